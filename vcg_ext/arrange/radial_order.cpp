// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A half-plane has a witness: a corner of its face strictly on its side of the segment's line.
// Angles are compared by the side of one half-plane's plane on which another's witness lies.
#include "vcg_ext/arrange/radial_order.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/exact/exact_sign.h"

#include <cmath>
#include <utility>

namespace index_boolean {

namespace {

// A half-plane with what its comparisons need.
struct Ray {
	HalfPlane half;
	const Triangle* corners;
	const Point* witness;
	int axis;         // of the face's projection
	int sideInPlane;  // of the witness, in that projection
};

class RadialOrder {
public:
	// \param count how many half-planes there will be
	RadialOrder(const Arrangement& arrangement, VertexId begin, VertexId end, std::size_t count)
	    : arrangement_(arrangement), begin_(exactPoint(arrangement, begin)),
	      end_(exactPoint(arrangement, end)) {
		rays_.reserve(count);
	}

	// False if there is no witness: the line does not part the face.
	bool add(const HalfPlane& half);
	void sort();
	std::vector<RadialPlace> takePlaces() { return std::move(places_); }

private:
	int sideInPlane(const Point& p, int axis) const {
		return orient2d(begin_, end_, ExactPoint::explicitPoint(p), axis);
	}
	// Whether the witness of b lies counter-clockwise (+1) or clockwise (-1) of a, by less than
	// half a turn; 0 in a's plane.
	int turnTo(const Ray& a, const Ray& b) const {
		const Points& points = arrangement_.mesh.points;
		const int side = orient3d(at(points, (*a.corners)[0]), at(points, (*a.corners)[1]),
		                          at(points, (*a.corners)[2]), *b.witness);
		return a.half.left ? side : -side;
	}

	const Arrangement& arrangement_;
	ExactPoint begin_, end_;
	std::vector<Ray> rays_;
	std::vector<RadialPlace> places_;
};

bool RadialOrder::add(const HalfPlane& half) {
	Ray ray{};
	ray.half = half;
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

void RadialOrder::sort() {
	const auto turn = [this](std::uint32_t i, std::uint32_t j) {
		return turnTo(rays_[i], rays_[j]);
	};
	const auto sameSide = [this](std::uint32_t i) {
		return sideInPlane(*rays_[i].witness, rays_[0].axis) == rays_[0].sideInPlane;
	};
	const AngleHint hint(begin_.rounded, end_.rounded);
	const auto angle = [this, &hint](std::uint32_t i) { return hint(*rays_[i].witness); };
	sortRadially(rays_.size(), turn, sameSide, angle, places_);
}

}  // namespace

// u is at right angles to the line and to one axis, v to both.
AngleHint::AngleHint(const Point& begin, const Point& end) : begin_(begin) {
	Point along{};
	for (std::size_t k = 0; k < 3; ++k) {
		along[k] = end[k] - begin[k];
	}
	std::size_t most = 0;
	for (std::size_t k = 1; k < 3; ++k) {
		most = std::abs(along[k]) > std::abs(along[most]) ? k : most;
	}
	const std::size_t next = (most + 1) % 3;
	const double length = std::hypot(along[0], along[1], along[2]);
	u_[most] = -along[next] / length;
	u_[next] = along[most] / length;
	v_[0] = (along[1] * u_[2] - along[2] * u_[1]) / length;
	v_[1] = (along[2] * u_[0] - along[0] * u_[2]) / length;
	v_[2] = (along[0] * u_[1] - along[1] * u_[0]) / length;
}

double AngleHint::operator()(const Point& p) const {
	double x = 0, y = 0;
	for (std::size_t k = 0; k < 3; ++k) {
		x += (p[k] - begin_[k]) * u_[k];
		y += (p[k] - begin_[k]) * v_[k];
	}
	const double size = std::abs(x) + std::abs(y);
	const double quarter = y / size / 4;  // of the diamond |x| + |y| = 1, as good as an angle
	const double turn = x < 0 ? 0.5 - quarter : (y < 0 ? 1 + quarter : quarter);
	return std::isfinite(turn) ? turn : 0;
}

bool sortAround(const Arrangement& arrangement, VertexId begin, VertexId end,
                const std::vector<HalfPlane>& halfPlanes, std::vector<RadialPlace>& places) {
	RadialOrder order(arrangement, begin, end, halfPlanes.size());
	for (const HalfPlane& half : halfPlanes) {
		if (!order.add(half)) {
			return false;
		}
	}
	order.sort();
	places = order.takePlaces();
	return true;
}

}  // namespace index_boolean
