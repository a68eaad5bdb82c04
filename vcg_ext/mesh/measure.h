// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: delivered blocks; out: volume, area, components, closedness, and how well the volume laws
// hold. Guarantee: sums are taken over fixed chunks, so the figures do not depend on the threads.
#pragma once

#include "vcg_ext/base/mesh_types.h"

namespace index_boolean {

struct BlockMeasure {
	double volume = 0;
	double area = 0;
	std::size_t components = 0;  // vertex-connected
	bool closed = true;          // every directed edge matched by its opposite
};

// The volume, area, components and closedness of an indexed triangle surface.
// \param points, triangles a surface whose triangles index points
// \param threads 0 = all
// \return in the cube and square of the coordinates' unit; never fails, but may throw
// std::bad_alloc Complexity: O(n), in parallel.
BlockMeasure measureSurface(const Points& points, const IndexTriangles& triangles, int threads);

}  // namespace index_boolean
