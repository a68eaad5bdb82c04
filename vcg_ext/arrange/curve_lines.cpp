// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops are written one after another.
#include "vcg_ext/arrange/curve_lines.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

double distance(const Point& p, const Point& q) {
	return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

void drawLoop(const Arrangement& arrangement, const Loop& loop, CurveLines& out) {
	const bool ring = loop.points.front() == loop.points.back();
	const auto first = static_cast<std::uint32_t>(out.points.size());
	const auto edgeCount = static_cast<std::uint32_t>(loop.faces.size());
	CurveLine line{loop.kind, first, ring ? edgeCount : edgeCount + 1, ring, 0};
	for (std::uint32_t i = 0; i < line.pointCount; ++i) {
		const std::array<FaceId, 2>& faces = loop.faces[std::min(i, edgeCount - 1)];
		out.points.push_back(arrangement.coordinates(loop.points[i]));
		out.line.push_back(static_cast<std::uint32_t>(out.lines.size()));
		out.operands.push_back(
		    {arrangement.mesh.operandOf(faces[0]), arrangement.mesh.operandOf(faces[1])});
		out.sources.push_back({arrangement.givenFace(faces[0]), arrangement.givenFace(faces[1])});
	}
	for (std::uint32_t i = 0; i < edgeCount; ++i) {
		const std::uint32_t next = i + 1 < line.pointCount ? i + 1 : 0;
		out.edges.push_back({first + i, first + next});
		line.length += distance(out.points[first + i], out.points[first + next]);
	}
	out.lines.push_back(line);
}

}  // namespace

Status drawCurve(const Arrangement& arrangement, Monitor& monitor, CurveLines& out) {
	out = CurveLines{};
	for (const Loop& loop : arrangement.loops) {
		drawLoop(arrangement, loop, out);
	}
	Status status;
	status.code = pollCancelled(monitor) ? StatusCode::Cancelled : StatusCode::Ok;
	return status;
}

}  // namespace index_boolean
