// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces near the other operand; out: those around common vertices that are too many.
// Near a vertex of it, a triangle is the cone over an arc of directions, so that two triangles have
// more than this vertex in common near it, and thus at all, iff their arcs meet.
#include "vcg_ext/arrange/common_fans.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

// A fan is wide if it has more pairs than this for each of its faces: what is left costs no more
// than a fixed number of pairs a face.
constexpr std::uint64_t kPairsPerFace = 32;

bool isWide(std::uint64_t a, std::uint64_t b) { return a * b > kPairsPerFace * (a + b); }

// The direction from a vertex to another point as a unit vector, each coordinate off by less than
// kDirectionError: of u = 2^-53, a difference is off by u of its size, its quotient by the largest
// one by 2u, and the length and the last quotient add less than 4u. False next to the limits of
// double, where these bounds do not hold.
constexpr double kDirectionError = 1e-15;

bool directionTo(const Point& from, const Point& to, Point& out) {
	double largest = 0;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		out[axis] = to[axis] - from[axis];
		largest = std::max(largest, std::fabs(out[axis]));
	}
	if (!(largest > 1e-290 && largest < 1e290)) {
		return false;
	}
	double squares = 0;
	for (double& x : out) {
		x /= largest;
		squares += x * x;
	}
	const double length = std::sqrt(squares);
	for (double& x : out) {
		x /= length;
	}
	return true;
}

// The box of the arc between two directions. A chord of length c is nowhere farther from its arc,
// of at most half a circle, than 1 - sqrt(1 - c^2 / 4) <= c^2 / 4.
FaceBox boxOfArc(const Point& p, const Point& q) {
	double squares = 0;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		squares += (p[axis] - q[axis]) * (p[axis] - q[axis]);
	}
	const double margin = squares / 4 + 16 * kDirectionError;  // of which c^2 / 4 takes up to 6
	FaceBox box{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		box.lo[axis] = static_cast<float>(std::min(p[axis], q[axis]) - margin);
		box.hi[axis] = static_cast<float>(std::max(p[axis], q[axis]) + margin);
	}
	return box;
}

// How many of an operand's listed faces have each of the common vertices.
// \param counts per vertex of the first operand
void countFaces(const MeshArrays& mesh, const HugeVector<FaceBox>& boxes,
                std::vector<std::uint32_t>& counts) {
	for (const FaceBox& box : boxes) {
		for (const VertexId v : mesh.triangles[box.face]) {
			if (v.value < counts.size()) {
				++at(counts, v);
			}
		}
	}
}

bool anyCommonVertex(const MeshArrays& mesh, const HugeVector<FaceBox>& boxesOfSecond) {
	const std::uint32_t second = mesh.vertexOffsets.begin(kSecond);
	return std::any_of(boxesOfSecond.begin(), boxesOfSecond.end(), [&](const FaceBox& box) {
		const Triangle& t = mesh.triangles[box.face];
		return std::min({t[0].value, t[1].value, t[2].value}) < second;
	});
}

}  // namespace

CommonFans::CommonFans(const MeshArrays& mesh, const FaceBoxes& boxes) : mesh_(mesh) {
	if (!anyCommonVertex(mesh, boxes.operand[kSecond])) {
		return;
	}
	PerOperand<std::vector<std::uint32_t>> counts;
	for (const OperandId k : counts.operands()) {
		counts[k].resize(mesh.vertexOffsets.begin(kSecond), 0);
		countFaces(mesh, boxes.operand[k], counts[k]);
	}
	for (std::uint32_t v = 0; v < mesh.vertexOffsets.begin(kSecond); ++v) {
		if (isWide(counts[kFirst][v], counts[kSecond][v])) {
			fanOfVertex_.resize(mesh.vertexOffsets.begin(kSecond), kNone);
			fanOfVertex_[v] = static_cast<std::uint32_t>(fans_.size());
			fans_.push_back({{v}, {}});
		}
	}
	for (const OperandId k : boxes.operand.operands()) {
		for (const FaceBox& box : boxes.operand[k]) {
			forEachFan({box.face},
			           [&](std::uint32_t fan) { fans_[fan].faces[k].push_back({box.face}); });
		}
	}
}

HugeVector<FaceBox> boxesOfDirections(const MeshArrays& mesh, const CommonFan& fan,
                                      OperandId operand) {
	const Point& from = at(mesh.points, fan.vertex);
	HugeVector<FaceBox> boxes;
	boxes.reserve(fan.faces[operand].size());
	for (const FaceId face : fan.faces[operand]) {
		const Triangle& t = at(mesh.triangles, face);
		const std::size_t corner = t[0] == fan.vertex ? 0 : t[1] == fan.vertex ? 1 : 2;
		Point p, q;
		FaceBox box{};
		if (directionTo(from, at(mesh.points, t[(corner + 1) % 3]), p) &&
		    directionTo(from, at(mesh.points, t[(corner + 2) % 3]), q)) {
			box = boxOfArc(p, q);
		} else {
			box.lo.fill(-kDirectionsHalfSize);
			box.hi.fill(kDirectionsHalfSize);
		}
		box.face = face.value;
		boxes.push_back(box);
	}
	return boxes;
}

}  // namespace index_boolean
