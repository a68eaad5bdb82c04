// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the refined surfaces; out: one numbering of all that gets a label or belongs to a component,
// and the classes: sets of nodes that no segment parts.
// A node is, in this order of numbers: an input vertex, an interval of a cut edge, a region of a
// touched face. Components know one more kind: a vertex on the other operand, once for each
// operand, since it may be a corner of both.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/base/union_find.h"

namespace index_boolean {

// The numbering. Borrows the arrangement.
class LabelNodes {
public:
	explicit LabelNodes(const Arrangement& arrangement);

	// Of nodes that get a label; and with the corners.
	std::size_t count() const { return arrangement_.refinement.nodeCount; }
	std::size_t countWithCorners() const { return count() + 2 * arrangement_.mesh.points.size(); }
	static NodeId ofVertex(VertexId v) { return {v.value}; }
	// The vertex as a corner of an operand's faces.
	NodeId ofCorner(OperandId operand, VertexId v) const {
		const std::size_t before = operand.value * arrangement_.mesh.points.size();
		return {static_cast<std::uint32_t>(count() + before) + v.value};
	}
	// A node of a face: one of its vertices, or its first region. Of a quiet face: a corner.
	// Complexity: O(1), but O(log k) for one of k touched faces.
	NodeId ofFace(FaceId face) const;
	bool isVertex(NodeId node) const { return node.value < arrangement_.mesh.points.size(); }
	OperandId operandOfRegion(NodeId region) const {
		return region < firstRegionOfSecond_ ? kFirst : kSecond;
	}

private:
	const Arrangement& arrangement_;
	NodeId firstRegionOfSecond_ = NodeId::none();
};

// Unites nodes unless a segment parts them, and marks in arrangement.labels.vertex which vertices
// have a label to get (Unknown), lie on the other operand (OnVertex), or are no face's (Unused).
// \param classes replaced; flat
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: O(n).
Status findClasses(Arrangement& arrangement, Monitor& monitor, UnionFind& classes);

}  // namespace index_boolean
