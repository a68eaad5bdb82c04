// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the filters that measure distances have in common: their parameters, and their refusals.
#pragma once

#include "layers/distance_layer.h"
#include "layers/operand_layers.h"
#include "runs/distance_run.h"

namespace index_boolean {

// The parameters that both filters have. Throws Refusal.
inline DistanceRequest readDistanceRequest(FilterId filter, const ParameterValues& values) {
	DistanceRequest request;
	request.options.selfIntersections =
	    static_cast<SelfIntersections>(values.getInt("self_intersections"));
	request.options.windingRule = static_cast<WindingRule>(values.getInt("winding_rule"));
	request.options.weldDistance = lengthInRange(filter, "weld_distance", values);
	request.distance.negate = values.getBool("negate");
	const double maximum = lengthInRange(filter, "max_distance", values);
	if (maximum > 0) {
		request.distance.maximum = maximum;
	}
	return request;
}

// Throws Refusal unless Ok: of a status that speaks of the one surface of a run.
// \param operand which of the named layers that surface is; its faces are left selected
inline void refuseSurface(Status status, OperandId operand, const MeasuredLayer& surface,
                          const LayerNames& names) {
	status.operand = numberOf(operand);
	if (!status.faces.empty()) {
		selectFaces(status.faces, surface.elements.faces, *surface.layer);
	}
	refuseUnlessOk(status, names, TakenFor::Reference);
}

}  // namespace index_boolean
