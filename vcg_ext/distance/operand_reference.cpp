// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/distance/operand_reference.h"

#include <cmath>
#include <utility>

namespace index_boolean {

namespace {

// The vertices that faces use, in their order, in place of all.
template <class AnyPoints>
void takePoints(const AnyPoints& points, Reference& out) {
	std::vector<std::uint32_t> number(points.size(), kNone);
	for (const IndexTriangle& triangle : out.triangles) {
		for (const std::uint32_t corner : triangle) {
			number[corner] = 0;
		}
	}
	for (std::size_t vertex = 0; vertex < number.size(); ++vertex) {
		if (number[vertex] != kNone) {
			number[vertex] = static_cast<std::uint32_t>(out.points.size());
			out.points.push_back(points[vertex]);
		}
	}
	for (IndexTriangle& triangle : out.triangles) {
		for (std::uint32_t& corner : triangle) {
			corner = number[corner];
		}
	}
}

}  // namespace

void takeOperand(const Arrangement& arrangement, Reference& out) {
	out.isClosed = arrangement.closed[kFirst];
	out.wasInsideOut = out.isClosed && arrangement.volume[kFirst] < 0;
	out.volume = out.isClosed ? std::fabs(arrangement.volume[kFirst]) : 0;
	const Triangles& triangles = arrangement.mesh.triangles;
	for (std::size_t face = 0; face < triangles.size(); ++face) {
		const Triangle& t = triangles[face];
		out.triangles.push_back({t[0].value, t[1].value, t[2].value});
		if (out.wasInsideOut) {
			std::swap(out.triangles.back()[1], out.triangles.back()[2]);
		}
		out.faceGiven.push_back(arrangement.givenFace(makeId<FaceTag>(face)));
	}
	takePoints(arrangement.mesh.points, out);
}

Status takeBoundary(const Arrangement& arrangement, Block& block, Reference& out) {
	if (block.triangles.empty()) {
		Status status = statusOf(StatusCode::NoVolume);
		status.operand = numberOf(kFirst);
		return status;
	}
	out.isClosed = true;
	out.wasInsideOut = arrangement.insideOut[kFirst];
	out.volume = arrangement.volume[kFirst];
	out.isResolved = block.triangles.size() != arrangement.mesh.triangles.size() ||
	                 !arrangement.refinement.cutFaces.empty();
	out.rule = WindingRule::Nonzero;  // the boundary winds once around what is inside
	out.triangles = std::move(block.triangles);
	for (const FaceSource& source : block.faceSource) {
		out.faceGiven.push_back(arrangement.givenFace(source.face));
	}
	takePoints(block.points, out);
	return {};
}

}  // namespace index_boolean
