// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the classes; out: the vertex-connected components of each operand.
// Guarantee: by index only.
#pragma once

#include "vcg_ext/solids/label_nodes.h"

namespace index_boolean {

// Borrows the arrangement. \pre findClasses has marked the vertices
class Components {
public:
	// Complexity: O(n + k) for n nodes and k touched faces.
	Components(const Arrangement& arrangement, const UnionFind& classes);

	// What tells the component of a face from others: a number below idLimit().
	std::uint32_t of(FaceId face) const { return sets_.root(nodes_.ofFace(face).value); }
	std::size_t idLimit() const { return sets_.size(); }
	// How many components an operand has. Complexity: O(v + k log k) for v vertices.
	std::uint32_t count(OperandId operand) const;

private:
	void joinAcrossSegments();
	void joinAtCorners();

	const Arrangement& arrangement_;
	LabelNodes nodes_;
	UnionFind sets_;
};

}  // namespace index_boolean
