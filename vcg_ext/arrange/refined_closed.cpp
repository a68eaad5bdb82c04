// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/arrange/refined_closed.h"

#include "vcg_ext/arrange/duplicate_faces.h"
#include "vcg_ext/mesh/boundary_checksum.h"
#include "vcg_ext/mesh/unmatched_edges.h"

#include <algorithm>

namespace index_boolean {

namespace {

// An operand's triangles as cut, each with its input face.
struct RefinedOperand {
	Triangles triangles;
	std::vector<FaceId> faces;
};

RefinedOperand refinedOperand(const Arrangement& arrangement, OperandId operand) {
	const MeshArrays& mesh = arrangement.mesh;
	const Refinement& refinement = arrangement.refinement;
	RefinedOperand all;
	const auto add = [&all](const Triangle& t, FaceId face) {
		all.triangles.push_back(t);
		all.faces.push_back(face);
	};
	const auto isBefore = [](const CutFace& cut, std::uint32_t f) { return cut.face.value < f; };
	std::size_t next = static_cast<std::size_t>(
	    std::lower_bound(refinement.cutFaces.begin(), refinement.cutFaces.end(),
	                     mesh.faceOffsets.begin(operand), isBefore) -
	    refinement.cutFaces.begin());
	for (std::uint32_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand);
	     ++f) {
		if (refinement.isCut[f] == 0) {
			add(mesh.triangles[f], {f});
			continue;
		}
		const Refinement::PieceRange pieces = refinement.piecesOf(next++);
		for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) {
			add(refinement.pieces[piece], {f});
		}
	}
	return all;
}

// 0 if each edge has an even number of triangles; hardly ever else.
std::uint64_t parityChecksum(const Triangles& triangles) {
	std::uint64_t sum = 0;
	for (const Triangle& t : triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			const auto [low, high] = std::minmax(t[i].value, t[(i + 1) % 3].value);
			sum ^= signedEdgeHash(low, high);
		}
	}
	return sum;
}

}  // namespace

Status findRefinedClosed(Arrangement& arrangement, Monitor& monitor) {
	const bool isOdd = arrangement.options.windingRule == WindingRule::Odd;
	return forEachOperand(arrangement.mesh.operands(), [&](OperandId operand) {
		if (arrangement.closed[operand]) {
			return Status{};
		}
		const Triangles triangles = refinedOperand(arrangement, operand).triangles;
		std::uint64_t sum = isOdd ? parityChecksum(triangles) : 0;
		const Status status =
		    isOdd ? Status{}
		          : boundaryChecksum(triangles.data(), triangles.data() + triangles.size(),
		                             arrangement.options.threads, monitor, sum);
		arrangement.closed[operand] = sum == 0;
		arrangement.volume[operand] *= sum == 0 ? 1 : 0;
		return status;
	});
}

Status refuseOpen(const Arrangement& arrangement, OperandId operand) {
	const RefinedOperand all = refinedOperand(arrangement, operand);
	UnmatchedEdges found;
	findUnmatchedEdges(all.triangles.data(), all.triangles.data() + all.triangles.size(), found);
	const bool hasBorder = found.borderEdges > 0;
	Status status = statusOf(hasBorder ? StatusCode::NotClosed : StatusCode::NotOriented);
	status.operand = numberOf(operand);
	status.count = hasBorder ? found.borderEdges : found.conflictingEdges;
	status.hasPlace = true;
	status.place = arrangement.coordinates({found.firstEdge[0]});
	for (const std::uint32_t face : found.faces) {
		status.faces.push_back(arrangement.givenFace(all.faces[face]));
	}
	std::sort(status.faces.begin(), status.faces.end());
	status.faces.erase(std::unique(status.faces.begin(), status.faces.end()), status.faces.end());
	return status;
}

Status refuseWithoutInside(const Arrangement& arrangement, OperandId operand) {
	const bool isOdd = arrangement.options.windingRule == WindingRule::Odd;
	const std::size_t pairs = cancellingPairs(arrangement.mesh, operand, isOdd);
	Status status;
	if (pairs == 0 || !isOdd) {
		status.code = pairs == 0 ? StatusCode::NoVolume : StatusCode::EmptyOperand;
		status.operand = numberOf(operand);
		status.count = pairs;
	}
	return status;
}

}  // namespace index_boolean
