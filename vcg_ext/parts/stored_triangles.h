// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an arrangement whose operands have been arranged again as they are stored, and the triangles
// of its complex; out: which triangles of the new arrangement are stored in the place of each.
// Guarantee: all of them, so that what a set of triangles bounds stays closed, and what two sets
// share stays the same in both.
#pragma once

#include "vcg_ext/arrange/surface_complex.h"

namespace index_boolean {

// triangles[first[f] .. first[f + 1]) are stored in the place of face f of the complex, turned as
// it is. Empty if its triangles are stored as they are.
struct StoredTriangles {
	std::vector<std::uint32_t> first;
	Triangles triangles;  // by vertices of the arrangement as stored

	bool areThere() const { return !first.empty(); }
};

// Lists the triangles. \param out replaced; stays empty if nothing has been arranged again
// Throws std::bad_alloc. Complexity: O(n) for n triangles of both arrangements.
void listStoredTriangles(const Arrangement& arrangement, const SurfaceComplex& complex,
                         StoredTriangles& out);

}  // namespace index_boolean
