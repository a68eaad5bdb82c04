// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Components are classes joined across segments and at common corners.
#include "vcg_ext/solids/components.h"

#include "vcg_ext/base/groups.h"

#include <algorithm>

namespace index_boolean {

Components::Components(const Arrangement& arrangement, const UnionFind& classes)
    : arrangement_(arrangement), nodes_(arrangement), sets_(classes) {
	if (!arrangement.refinement.cornerLinks.empty() || !arrangement.mesh.quietFaces.empty()) {
		sets_.grow(nodes_.countWithCorners());
	}
	joinAcrossSegments();
	joinAtCorners();
	sets_.flatten();
}

// All regions of one operand at a segment are of one component.
void Components::joinAcrossSegments() {
	const HugeVector<SegmentSide>& sides = arrangement_.refinement.sides;
	const auto sameSegment = [](const SegmentSide& a, const SegmentSide& b) {
		return a.segment == b.segment;
	};
	forEachGroup(sides.begin(), sides.end(), sameSegment, [this](auto first, auto last) {
		PerOperand<NodeId> reached{NodeId::none(), NodeId::none()};
		for (; first != last; ++first) {
			NodeId& previous = reached[arrangement_.mesh.operandOf(first->face)];
			for (const NodeId region : {first->left, first->right}) {
				if (region != NodeId::none() && previous != NodeId::none()) {
					sets_.unite(region.value, previous.value);
				}
				previous = region == NodeId::none() ? previous : region;
			}
		}
	});
}

void Components::joinAtCorners() {
	const MeshArrays& mesh = arrangement_.mesh;
	for (const auto& link : arrangement_.refinement.cornerLinks) {
		const OperandId operand = nodes_.operandOfRegion(link[0]);
		sets_.unite(link[0].value, nodes_.ofCorner(operand, {link[1].value}).value);
	}
	for (std::uint32_t f = 0; f < mesh.quietFaces.size(); ++f) {
		if (mesh.quietFaces[f] != Twin::None) {
			const OperandId operand = mesh.operandOf({f});
			const Triangle& t = mesh.triangles[f];
			sets_.unite({nodes_.ofCorner(operand, t[0]).value, nodes_.ofCorner(operand, t[1]).value,
			             nodes_.ofCorner(operand, t[2]).value});
		}
	}
}

// A component's root, its smallest node, is a vertex off the other operand if it has one at all.
std::uint32_t Components::count(OperandId operand) const {
	const MeshArrays& mesh = arrangement_.mesh;
	const Refinement& refinement = arrangement_.refinement;
	std::uint32_t count = 0;
	for (std::uint32_t v = mesh.vertexOffsets.begin(operand); v < mesh.vertexOffsets.end(operand);
	     ++v) {
		const bool isFree = arrangement_.labels.vertex[v] == Label::Unknown;
		count += isFree && sets_.root(v) == v ? 1 : 0;
	}
	std::vector<std::uint32_t> others;
	for (const CutFace& cut : refinement.cutFaces) {
		const std::uint32_t root = sets_.root(refinement.pieceRegion[cut.firstPiece].value);
		if (mesh.operandOf(cut.face) == operand && !nodes_.isVertex({root})) {
			others.push_back(root);
		}
	}
	std::sort(others.begin(), others.end());
	const auto end = std::unique(others.begin(), others.end());
	count += static_cast<std::uint32_t>(end - others.begin());
	for (std::uint32_t v = 0; v < mesh.quietVertices.size(); ++v) {
		const std::uint32_t node = nodes_.ofCorner(operand, {v}).value;
		count += mesh.quietVertices[v] != 0 && sets_.root(node) == node ? 1 : 0;
	}
	return count;
}

}  // namespace index_boolean
