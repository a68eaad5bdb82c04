// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: the nodes and blocks of their tree (face_tree.h). Guarantee: the same for any
// number of threads.
#pragma once

#include "vcg_ext/distance/face_tree.h"

namespace index_boolean {

// The vertices of a face in the order of its shape: that opposite the longest edge first, then the
// others in lexicographic order of their places. Of equally long edges, the one opposite the first
// vertex in that order. Complexity: O(1).
std::array<std::uint32_t, 3> verticesByShape(const Points& points, const IndexTriangle& triangle,
                                             const TreeFrame& frame);

// What a builder makes.
struct BuiltTree {
	TreeFrame frame;
	std::vector<FaceTreeNode> nodes;  // the first one is the root
	HugeVector<FaceBlock> blocks;
};

// No path from the root is longer: below a depth of about the half, halves have equal counts.
constexpr std::size_t kDeepestTree = 64;

// Builds the tree; see FaceTree::build.
// \return Ok, Cancelled, OutOfMemory. Throws std::bad_alloc. Complexity: O(n log n).
Status buildFaceTree(const Points& points, const IndexTriangles& triangles, int threads,
                     Monitor& monitor, BuiltTree& out);

}  // namespace index_boolean
