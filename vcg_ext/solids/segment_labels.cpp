// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Going round, a left half-plane of the other operand is entered from behind, inside, and left in
// front, outside; a right one the other way.
#include "vcg_ext/solids/segment_labels.h"

namespace index_boolean {

namespace {

// Labels the half-planes of one operand by those of the other.
// \return the other operand, if it contradicts itself
std::optional<OperandId> labelOperand(const MeshArrays& mesh, OperandId operand,
                                      const std::vector<RadialPlace>& places,
                                      std::vector<LabelledHalfPlane>& halfPlanes) {
	const auto isOwn = [&](const RadialPlace& place) {
		return mesh.operandOf(halfPlanes[place.index].face) == operand;
	};
	const auto isLeft = [&](const RadialPlace& place) { return halfPlanes[place.index].left; };
	std::vector<RadialPlace> others;
	for (const RadialPlace& place : places) {
		if (!isOwn(place)) {
			others.push_back(place);
		}
	}
	for (std::size_t i = 0; i < others.size(); ++i) {
		const RadialPlace& next = others[(i + 1) % others.size()];
		const bool samePlace = others[i].slot == next.slot;  // also if it is the only one
		if (samePlace || isLeft(others[i]) == isLeft(next)) {
			return otherOf(operand);
		}
	}
	for (const RadialPlace& place : places) {
		if (!isOwn(place) || others.empty()) {
			continue;
		}
		RadialPlace last = others.back();  // the last one before this one, going round
		for (const RadialPlace& other : others) {
			last = other.slot <= place.slot ? other : last;
		}
		Label& label = halfPlanes[place.index].label;
		if (last.slot == place.slot) {
			label = isLeft(last) == isLeft(place) ? Label::OnSame : Label::OnOpposite;
		} else {
			label = isLeft(last) ? Label::Outside : Label::Inside;
		}
	}
	return {};
}

}  // namespace

std::optional<OperandId> labelAround(const Arrangement& arrangement, const Segment& segment,
                                     std::vector<LabelledHalfPlane>& halfPlanes) {
	std::vector<RadialPlace> places;
	const std::vector<HalfPlane> toSort(halfPlanes.begin(), halfPlanes.end());
	if (!sortAround(arrangement, segment.begin, segment.end, toSort, places)) {
		return kFirst;
	}
	for (LabelledHalfPlane& half : halfPlanes) {
		half.label = Label::Unknown;
	}
	for (const OperandId operand : {kFirst, kSecond}) {
		if (const auto wrong = labelOperand(arrangement.mesh, operand, places, halfPlanes)) {
			return wrong;
		}
	}
	return {};
}

}  // namespace index_boolean
