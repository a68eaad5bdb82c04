// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: axis-parallel boxes; out: those that a question may concern, without a look at most others.
// Guarantee: what is found depends on the boxes only. Boxes may overlap, coincide or be points, and
// may lie in clusters: halves have equal counts, whatever their size. A box may be without end in a
// direction.
#pragma once

#include "vcg_ext/exact/bounding_box.h"

#include <array>
#include <cstdint>
#include <vector>

namespace index_boolean {

class BoxTree {
public:
	BoxTree() = default;
	// \param boxes none of them empty; at most 2^31 - 1
	// Complexity: O(n log n). Memory: O(n).
	explicit BoxTree(std::vector<BoundingBox> boxes);

	// Calls visit(i) for each box i for which enters(box i) is true.
	// \param enters  asked of boxes that hold others, too: if it is true of a box then also of any
	//                box around it. It may become false of more and more boxes meanwhile.
	// \param axis    boxes that begin lower along it tend to come first
	// Complexity: one call of enters for each box entered and its children.
	template <class Enters, class Visit>
	void visit(int axis, Enters&& enters, Visit&& visit) const;

private:
	// Of order_[begin .. end): their common box. `right` is its second child, or 0 if it has none;
	// the first one follows it.
	struct Node {
		BoundingBox box;
		std::uint32_t begin, end;
		std::uint32_t right;
	};

	void build(std::uint32_t begin, std::uint32_t end);
	BoundingBox boxAround(std::uint32_t begin, std::uint32_t end) const;

	std::vector<BoundingBox> boxes_;
	std::vector<std::uint32_t> order_;
	std::vector<Node> nodes_;
};

template <class Enters, class Visit>
void BoxTree::visit(int axis, Enters&& enters, Visit&& visit) const {
	if (nodes_.empty() || !enters(nodes_[0].box)) {
		return;  // mostly; so it comes before all else
	}
	const auto along = static_cast<std::size_t>(axis);
	std::array<std::uint32_t, 64> waiting;  // one per level at most, and there are 32
	waiting[0] = 0;
	std::size_t count = 1;
	while (count > 0) {
		const std::uint32_t index = waiting[--count];
		const Node& node = nodes_[index];
		if (!enters(node.box)) {
			continue;
		}
		if (node.right != 0) {
			const bool leftFirst =
			    nodes_[index + 1].box.lo[along] <= nodes_[node.right].box.lo[along];
			waiting[count++] = leftFirst ? node.right : index + 1;
			waiting[count++] = leftFirst ? index + 1 : node.right;
			continue;
		}
		for (std::uint32_t i = node.begin; i < node.end; ++i) {
			if (enters(boxes_[order_[i]])) {
				visit(order_[i]);
			}
		}
	}
}

}  // namespace index_boolean
