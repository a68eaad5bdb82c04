// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The octree and the exact contacts of two operands, put to one operand and itself. A contact is a
// convex set whose corners are named: it is the common corner or edge of two faces iff all its
// names are common corners. Contacts are judged where they are found and never stored, since a
// tangle of n faces may have n^2 of them.
#include "vcg_ext/arrange/self_intersections.h"

#include "vcg_ext/arrange/box_frame.h"
#include "vcg_ext/arrange/octree_pairs.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/triangle_contact.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <atomic>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 8192;

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

bool hasCorner(const Triangle& t, VertexId v) { return t[0] == v || t[1] == v || t[2] == v; }

// The number of corners that s has in common with t; `corner` is the last of them in s.
int countCommonCorners(const Triangle& s, const Triangle& t, int& corner) {
	int count = 0;
	for (int i = 0; i < 3; ++i) {
		if (hasCorner(t, s[static_cast<std::size_t>(i)])) {
			corner = i;
			++count;
		}
	}
	return count;
}

// One operand and what has been found of it.
class SelfSearch {
public:
	SelfSearch(const Arrangement& arrangement, OperandId operand, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), operand_(operand),
	      first_(mesh_.faceOffsets.begin(operand)), count_(mesh_.faceOffsets.size(operand)),
	      monitor_(monitor), isConcerned_(count_) {}

	Status run();

private:
	Status findBox(BoundingBox& out) const;
	Status collectBoxes(const BoundingBox& box);
	void visit(FacePair pair);
	bool sideIsApart(const Triangle& s, int corner, const Triangle& t) const;
	bool meetInOneCornerOnly(FacePair pair) const;
	bool isProper(FacePair pair, const PairContact& contact) const;
	bool isCommonCorner(FacePair pair, const PointName& name) const;
	Point placeOf(FacePair pair) const;
	Status result() const;

	std::atomic<bool>& isConcerned(FaceId face) { return isConcerned_[face.value - first_]; }

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	OperandId operand_;
	std::uint32_t first_, count_;
	Monitor& monitor_;
	HugeVector<FaceBox> boxes_;
	float halfSize_ = 1;
	std::vector<std::atomic<bool>> isConcerned_;  // per face
	AtomicMinimum firstPair_;                     // of those that meet wrongly: a, then b
	std::atomic<bool> contradiction_{false};
};

Status SelfSearch::findBox(BoundingBox& out) const {
	return findBoxOfFaces(
	    mesh_, count_, [this](std::size_t i) { return first_ + i; }, arrangement_.options.threads,
	    monitor_, out);
}

Status SelfSearch::collectBoxes(const BoundingBox& box) {
	const BoxFrame frame = makeBoxFrame(box);
	halfSize_ = frame.halfSize;
	boxes_.resizeForOverwrite(count_);
	return parallelFor(count_, kGrain, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t i = begin; i < end; ++i) {
			                   FaceBox& face = boxes_[i];
			                   face.face = first_ + static_cast<std::uint32_t>(i);
			                   face.lo.fill(halfSize_);
			                   face.hi.fill(-halfSize_);
			                   for (const VertexId v : mesh_.triangles[face.face]) {
				                   for (std::size_t axis = 0; axis < 3; ++axis) {
					                   const float x = frame.map(at(mesh_.points, v)[axis], axis);
					                   face.lo[axis] = std::min(face.lo[axis], x);
					                   face.hi[axis] = std::max(face.hi[axis], x);
				                   }
			                   }
		                   }
	                   });
}

// Whether the side of s opposite to a corner has a box apart from that of t.
bool SelfSearch::sideIsApart(const Triangle& s, int corner, const Triangle& t) const {
	const Point& p = at(mesh_.points, s[static_cast<std::size_t>(nextCorner(corner))]);
	const Point& q = at(mesh_.points, s[static_cast<std::size_t>(previousCorner(corner))]);
	bool apart = false;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const auto [low, high] =
		    std::minmax({at(mesh_.points, t[0])[axis], at(mesh_.points, t[1])[axis],
		                 at(mesh_.points, t[2])[axis]});
		apart |= std::max(p[axis], q[axis]) < low || std::min(p[axis], q[axis]) > high;
	}
	return apart;
}

// Tells quickly of most faces around one vertex. Two faces with one common corner meet elsewhere
// only if the side of one that is opposite to the corner meets the other face: seen from the
// corner, each face ends at that side, and one of them ends first.
bool SelfSearch::meetInOneCornerOnly(FacePair pair) const {
	const Triangle& a = at(mesh_.triangles, pair.a);
	const Triangle& b = at(mesh_.triangles, pair.b);
	int inA = 0, inB = 0;
	return countCommonCorners(a, b, inA) == 1 && countCommonCorners(b, a, inB) == 1 &&
	       sideIsApart(a, inA, b) && sideIsApart(b, inB, a);
}

void SelfSearch::visit(FacePair pair) {
	const std::uint64_t key = std::uint64_t{pair.a.value} << 32 | pair.b.value;
	if (isConcerned(pair.a) && isConcerned(pair.b) && key > firstPair_.get()) {
		return;
	}
	PairContact contact;
	if (meetInOneCornerOnly(pair)) {
		return;
	}
	if (!contactOf(mesh_, pair, contact)) {
		contradiction_ = true;
	} else if (!isProper(pair, contact)) {
		isConcerned(pair.a) = true;
		isConcerned(pair.b) = true;
		firstPair_.put(key);
	}
}

bool SelfSearch::isCommonCorner(FacePair pair, const PointName& name) const {
	const VertexId v{name.ids[0]};
	return name.kind == PointKind::Vertex && hasCorner(at(mesh_.triangles, pair.a), v) &&
	       hasCorner(at(mesh_.triangles, pair.b), v);
}

// Two faces with three common corners are one face twice.
bool SelfSearch::isProper(FacePair pair, const PairContact& contact) const {
	const PointName* end = contact.points.begin() + contact.count;
	return contact.count < 3 &&
	       std::all_of(contact.points.begin(), end,
	                   [&](const PointName& name) { return isCommonCorner(pair, name); });
}

// A point that two faces should not have in common; of two equal faces, a corner.
Point SelfSearch::placeOf(FacePair pair) const {
	PairContact contact;
	contactOf(mesh_, pair, contact);
	const PointName* begin = contact.points.begin();
	const PointName* end = begin + contact.count;
	const PointName* name =
	    std::find_if_not(begin, end, [&](const PointName& n) { return isCommonCorner(pair, n); });
	ExactPoint point = exactPointOf(mesh_, name == end ? *begin : *name);
	roundPoint(point);
	return point.rounded;
}

Status SelfSearch::result() const {
	Status status;
	const std::uint64_t key = firstPair_.get();
	if (contradiction_) {
		status.code = StatusCode::InternalError;
		return status;
	}
	for (std::uint32_t i = 0; i < count_; ++i) {
		if (isConcerned_[i]) {
			status.faces.push_back(arrangement_.givenFace({first_ + i}));
		}
	}
	if (status.faces.empty()) {
		return status;
	}
	// Faces that were split have one index as given.
	std::sort(status.faces.begin(), status.faces.end());
	status.faces.erase(std::unique(status.faces.begin(), status.faces.end()), status.faces.end());
	status.code = StatusCode::SelfIntersecting;
	status.operand = numberOf(operand_);
	status.count = status.faces.size();
	status.hasPlace = true;
	status.place = placeOf(
	    FacePair{{static_cast<std::uint32_t>(key >> 32)}, {static_cast<std::uint32_t>(key)}});
	return status;
}

Status SelfSearch::run() {
	BoundingBox box{};
	const auto visitPair = [this](FacePair pair) { visit(pair); };
	return inOrder([&] { return findBox(box); }, [&] { return collectBoxes(box); },
	               [&] {
		               return visitPairsWithin(boxes_, halfSize_, arrangement_.options, monitor_,
		                                       visitPair);
	               },
	               [&] { return result(); });
}

}  // namespace

Status checkSelfIntersections(const Arrangement& arrangement, Monitor& monitor) {
	if (!arrangement.options.checkSelfIntersections) {
		return {};
	}
	return forEachOperand(arrangement.mesh.operands(), [&](OperandId operand) {
		return SelfSearch(arrangement, operand, monitor).run();
	});
}

}  // namespace index_boolean
