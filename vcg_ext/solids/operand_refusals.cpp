// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/solids/operand_refusals.h"

#include "vcg_ext/arrange/refined_closed.h"
#include "vcg_ext/parts/sub_blocks.h"

namespace index_boolean {

bool isOnlyForEmbedded(StatusCode code, SelfIntersections selfIntersections) {
	switch (code) {
	case StatusCode::SelfIntersecting:
		return selfIntersections != SelfIntersections::Refuse;
	case StatusCode::NestedComponents:
	case StatusCode::NotClosed:
	case StatusCode::NotOriented:
	case StatusCode::NoVolume:
		return true;
	default:
		return false;
	}
}

Status refuseWithoutFaces(const MeshArrays& input) {
	return forEachOperand(input.operands(), [&](OperandId operand) {
		Status status = statusOf(input.faceOffsets.size(operand) == 0 ? StatusCode::EmptyOperand
		                                                              : StatusCode::Ok);
		status.operand = numberOf(operand);
		return status;
	});
}

Status refuseUnlessSolids(const Arrangement& arrangement) {
	const WindingRule rule = arrangement.options.windingRule;
	PerOperand<bool> hasInside(arrangement.mesh.operands().count());
	for (const PerOperand<std::int32_t>& windings : arrangement.cells.windings) {
		for (const OperandId operand : windings.operands()) {
			hasInside[operand] = hasInside[operand] || isInside(rule, windings[operand]);
		}
	}
	return forEachOperand(arrangement.mesh.operands(), [&](OperandId operand) {
		if (!arrangement.closed[operand]) {
			return refuseOpen(arrangement, operand);
		}
		return hasInside[operand] ? Status{} : refuseWithoutInside(arrangement, operand);
	});
}

}  // namespace index_boolean
