// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: operands some of whose vertices were welded; out: which of those are the two sides of a seam
// and stay apart in every output: a border of a texture, or of colours.
// Guarantee: by indices, and by what the caller says of two vertices' attributes. Copies of a
// vertex where an operand touches itself are no seam.
#pragma once

#include "vcg_ext/arrange/given_faces.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Whether two vertices of one operand have the same attributes.
using SameAttributes = std::function<bool(VertexId a, VertexId b)>;

struct Seams {
	// Per vertex as given: the first vertex in its place that it need not be apart from, or none()
	// if that is all of them. Empty: no two vertices of an operand stay apart.
	std::vector<VertexId> side;

	bool any() const { return !side.empty(); }
	VertexId sideOf(VertexId v) const { return side.empty() ? VertexId::none() : at(side, v); }
};

// Finds the seams of the operands that have any.
// \return Ok, Cancelled, OutOfMemory
// Complexity: O(1) if no operand has two vertices in one place; else O(n + k log k) for n faces, k
// of them at such places.
Status findSeams(const Arrangement& arrangement, const GivenTriangles& given,
                 const SameAttributes& same, Monitor& monitor, Seams& out);

}  // namespace index_boolean
