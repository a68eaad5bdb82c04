// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for wrong pairs, put to one operand after another. Pairs are never stored, since a
// tangle of n faces may have n^2 of them: of each face it is kept whether there is any, and of all
// pairs the first one.
#include "vcg_ext/arrange/self_intersections.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/arrange/triangle_contact.h"
#include "vcg_ext/arrange/wrong_pairs.h"

#include <algorithm>
#include <atomic>

namespace index_boolean {

namespace {

// Keeps the smallest of the values that threads put in.
class AtomicMinimum {
public:
	void put(std::uint64_t value) {
		std::uint64_t known = get();
		while (value < known &&
		       !smallest_.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
		}
	}
	std::uint64_t get() const { return smallest_.load(std::memory_order_relaxed); }

private:
	std::atomic<std::uint64_t> smallest_{~std::uint64_t{0}};
};

// The faces of one operand that meet others of it wrongly. Faces are numbered from its first on.
class ConcernedFaces : public WrongPairTaker {
public:
	explicit ConcernedFaces(std::size_t count) : isConcerned_(count) {}

	bool wants(FacePair pair) const override {
		return keyOf(pair) < firstPair_.get() || !at(isConcerned_, pair.a) ||
		       !at(isConcerned_, pair.b);
	}
	void take(FacePair pair) override {
		at(isConcerned_, pair.a) = true;
		at(isConcerned_, pair.b) = true;
		firstPair_.put(keyOf(pair));
	}

	std::vector<std::uint32_t> faces() const {
		std::vector<std::uint32_t> found;
		for (std::uint32_t face = 0; face < isConcerned_.size(); ++face) {
			if (isConcerned_[face]) {
				found.push_back(face);
			}
		}
		return found;
	}
	// By the first face, then by the second. \pre there is one
	FacePair firstPair() const {
		const std::uint64_t key = firstPair_.get();
		return {{static_cast<std::uint32_t>(key >> 32)}, {static_cast<std::uint32_t>(key)}};
	}

private:
	static std::uint64_t keyOf(FacePair pair) {
		return std::uint64_t{pair.a.value} << 32 | pair.b.value;
	}

	std::vector<std::atomic<bool>> isConcerned_;
	AtomicMinimum firstPair_;
};

bool isVertexOf(const PointName& name, const Triangle& t) {
	return name.kind == PointKind::Vertex &&
	       std::find(t.begin(), t.end(), VertexId{name.ids[0]}) != t.end();
}

// A point that two faces should not have in common; of two equal faces, a corner.
Point placeOf(const MeshArrays& mesh, FacePair pair) {
	PairContact contact;
	contactOf(mesh, pair, contact);
	const auto isCommonCorner = [&](const PointName& name) {
		return isVertexOf(name, at(mesh.triangles, pair.a)) &&
		       isVertexOf(name, at(mesh.triangles, pair.b));
	};
	const auto begin = contact.points.begin(), end = begin + contact.count;
	const auto name = std::find_if_not(begin, end, isCommonCorner);
	ExactPoint point = exactPointOf(mesh, name == end ? *begin : *name);
	roundPoint(point);
	return point.rounded;
}

Status searchOperand(const Arrangement& arrangement, OperandId operand, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	const std::uint32_t first = mesh.faceOffsets.begin(operand);
	ConcernedFaces concerned(mesh.faceOffsets.size(operand));
	std::vector<std::uint32_t> zeroAreaFaces;  // of which a prepared operand has none
	// Known by the operand's check, and so as surely as the run knows it (boundary_checksum.h).
	const WrongPairOptions options{arrangement.options.threads, arrangement.closed[operand]};
	const Status status =
	    visitWrongPairs(facesOf(mesh, operand), options, monitor, concerned, zeroAreaFaces);
	std::vector<FaceId> faces;
	for (const std::uint32_t face : concerned.faces()) {
		faces.push_back({first + face});
	}
	if (!status.ok() || faces.empty()) {
		return status;
	}
	const FacePair pair = concerned.firstPair();
	return selfIntersecting(arrangement, operand, faces,
	                        placeOf(mesh, {{first + pair.a.value}, {first + pair.b.value}}));
}

}  // namespace

Status checkSelfIntersections(const Arrangement& arrangement, Monitor& monitor) {
	if (arrangement.options.selfIntersections == SelfIntersections::Trust) {
		return {};
	}
	return forEachOperand(arrangement.mesh.operands(), [&](OperandId operand) {
		return searchOperand(arrangement, operand, monitor);
	});
}

}  // namespace index_boolean
