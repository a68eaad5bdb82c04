// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the arrangement's loops; out: the same as polylines, with what each vertex comes from.
// Guarantee: order, starts and directions are those of the loops, which depend on coordinates only.
// Source: Mei & Tipper 2013, step 4.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// One loop of the arrangement, as the vertices [firstPoint, firstPoint + pointCount) in order.
struct CurveLine {
	LoopKind kind;
	std::uint32_t firstPoint, pointCount;
	bool ring;  // the last vertex is joined to the first
	double length;
};

// Each loop has vertices of its own, so that junctions are repeated.
struct CurveLines {
	std::vector<CurveLine> lines;                     // one for each loop
	Points points;                                    // as the arrangement rounds them
	std::vector<std::array<std::uint32_t, 2>> edges;  // indices into points
	std::vector<std::uint32_t> line;                  // per point: its line
	// Per point: two operands, and a face of each, as given, in which the line leaves it; at the
	// end of a line, arrives.
	std::vector<std::array<OperandId, 2>> operands;
	std::vector<std::array<std::uint32_t, 2>> sources;
};

// Draws all loops. \return Ok, Cancelled. Complexity: O(s) for s segments.
Status drawCurve(const Arrangement& arrangement, Monitor& monitor, CurveLines& out);

}  // namespace index_boolean
