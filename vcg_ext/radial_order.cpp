// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A half-plane has a witness: a corner of its face strictly on its side of the segment's line.
// Angles are compared by the side of one half-plane's plane on which another's witness lies.
#include "radial_order.h"

#include "exact_sign.h"
#include "weld.h"

#include <algorithm>

namespace index_boolean {

namespace {

// A half-plane with what its comparisons need.
struct Ray {
	HalfPlane half;
	int operand;
	const Triangle* corners;
	const Point* witness;
	int axis;         // of the face's projection
	int sideInPlane;  // of the witness, in that projection
	int sector = 0;  // from the first half-plane on: 0 same, 1 before opposite, 2 opposite, 3 after
	std::size_t slot = 0;
};

class RadialOrder {
public:
	RadialOrder(const Arrangement& arrangement, const Segment& segment)
	    : arrangement_(arrangement), begin_(exactPoint(arrangement, segment.begin)),
	      end_(exactPoint(arrangement, segment.end)) {}

	bool sort(const std::vector<HalfPlane>& halfPlanes);
	int label();
	const std::vector<Ray>& rays() const { return rays_; }

private:
	bool add(const HalfPlane& half);
	int sideInPlane(const Point& p, int axis) const {
		return orient2d(begin_, end_, ExactPoint::explicitPoint(p), axis);
	}
	// Whether the witness of b lies counter-clockwise (+1) or clockwise (-1) of a, by less than
	// half a turn; 0 in a's plane.
	int turnTo(const Ray& a, const Ray& b) const {
		const std::vector<Point>& points = arrangement_.mesh.points;
		const int side = orient3d(at(points, (*a.corners)[0]), at(points, (*a.corners)[1]),
		                          at(points, (*a.corners)[2]), *b.witness);
		return a.half.left ? side : -side;
	}
	int sectorOf(const Ray& ray) const {
		const int turn = turnTo(rays_[0], ray);
		if (turn != 0) {
			return turn > 0 ? 1 : 3;
		}
		return sideInPlane(*ray.witness, rays_[0].axis) == rays_[0].sideInPlane ? 0 : 2;
	}
	int labelOperand(int operand);

	const Arrangement& arrangement_;
	ExactPoint begin_, end_;
	std::vector<Ray> rays_;
};

// Finds a witness. False if there is none: the segment is not in the face.
bool RadialOrder::add(const HalfPlane& half) {
	Ray ray{};
	ray.half = half;
	ray.operand = arrangement_.mesh.operandOf(half.face);
	ray.corners = &at(arrangement_.mesh.triangles, half.face);
	int sign = 0;
	ray.axis = projectionAxis(*ray.corners, arrangement_.mesh.points, sign);
	const int wanted = half.left ? sign : -sign;
	for (const VertexId v : *ray.corners) {
		const Point& corner = at(arrangement_.mesh.points, v);
		if (sideInPlane(corner, ray.axis) == wanted) {
			ray.witness = &corner;
			ray.sideInPlane = wanted;
			rays_.push_back(ray);
			return true;
		}
	}
	return false;
}

bool RadialOrder::sort(const std::vector<HalfPlane>& halfPlanes) {
	for (const HalfPlane& half : halfPlanes) {
		if (!add(half)) {
			return false;
		}
	}
	for (Ray& ray : rays_) {
		ray.sector = sectorOf(ray);
	}
	std::sort(rays_.begin(), rays_.end(), [this](const Ray& a, const Ray& b) {
		if (a.sector != b.sector) {
			return a.sector < b.sector;
		}
		return a.sector % 2 == 1 && turnTo(a, b) > 0;
	});
	for (std::size_t i = 1; i < rays_.size(); ++i) {
		const Ray& before = rays_[i - 1];
		const bool same = before.sector == rays_[i].sector &&
		                  (before.sector % 2 == 0 || turnTo(before, rays_[i]) == 0);
		rays_[i].slot = before.slot + (same ? 0 : 1);
	}
	return true;
}

// Labels the half-planes of one operand by those of the other: going round, a left half-plane of
// the other is entered from behind, inside, and left in front, outside; a right one the other way.
int RadialOrder::labelOperand(int operand) {
	std::vector<const Ray*> others;
	for (const Ray& ray : rays_) {
		if (ray.operand != operand) {
			others.push_back(&ray);
		}
	}
	for (std::size_t i = 0; i < others.size(); ++i) {
		const Ray& next = *others[(i + 1) % others.size()];
		const bool insideAfter = !others[i]->half.left;
		const bool insideBeforeNext = next.half.left;
		const bool samePlace = others.size() > 1 && others[i]->slot == next.slot;
		if (others.size() == 1 || samePlace || insideAfter != insideBeforeNext) {
			return 1 - operand;
		}
	}
	for (Ray& ray : rays_) {
		if (ray.operand != operand || others.empty()) {
			continue;
		}
		const Ray* last = others.back();  // the last one before this ray, going round
		for (const Ray* other : others) {
			last = other->slot <= ray.slot ? other : last;
		}
		if (last->slot == ray.slot) {
			ray.half.label = last->half.left == ray.half.left ? Label::OnSame : Label::OnOpposite;
		} else {
			ray.half.label = last->half.left ? Label::Outside : Label::Inside;
		}
	}
	return -1;
}

int RadialOrder::label() {
	for (int operand = 0; operand < 2; ++operand) {
		if (const int wrong = labelOperand(operand); wrong >= 0) {
			return wrong;
		}
	}
	return -1;
}

}  // namespace

int labelAround(const Arrangement& arrangement, const Segment& segment,
                std::vector<HalfPlane>& halfPlanes) {
	RadialOrder order(arrangement, segment);
	if (!order.sort(halfPlanes)) {
		return 0;
	}
	const int wrong = order.label();
	for (std::size_t i = 0; i < halfPlanes.size(); ++i) {
		halfPlanes[i] = order.rays()[i].half;
	}
	return wrong;
}

}  // namespace index_boolean
