// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A half-plane has a witness: a corner of its face strictly on its side of the segment's line.
// Angles are compared by the side of one half-plane's plane on which another's witness lies.
#include "vcg_ext/arrange/radial_order.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/exact/exact_sign.h"

namespace index_boolean {

namespace {

// A half-plane with what its comparisons need.
struct Ray {
	HalfPlane half;
	OperandId operand;
	const Triangle* corners;
	const Point* witness;
	int axis;         // of the face's projection
	int sideInPlane;  // of the witness, in that projection
};

class RadialOrder {
public:
	RadialOrder(const Arrangement& arrangement, VertexId begin, VertexId end)
	    : arrangement_(arrangement), begin_(exactPoint(arrangement, begin)),
	      end_(exactPoint(arrangement, end)) {}

	// False if there is no witness: the line does not part the face.
	bool add(const HalfPlane& half);
	void sort();
	// Labels all half-planes; see labelAround. Labels are by index, as added.
	int label(std::vector<Label>& labels) const;
	const std::vector<RadialPlace>& places() const { return places_; }

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
	int labelOperand(OperandId operand, std::vector<Label>& labels) const;

	const Arrangement& arrangement_;
	ExactPoint begin_, end_;
	std::vector<Ray> rays_;
	std::vector<RadialPlace> places_;
};

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

void RadialOrder::sort() {
	const auto turn = [this](std::uint32_t i, std::uint32_t j) {
		return turnTo(rays_[i], rays_[j]);
	};
	const auto sameSide = [this](std::uint32_t i) {
		return sideInPlane(*rays_[i].witness, rays_[0].axis) == rays_[0].sideInPlane;
	};
	sortRadially(rays_.size(), turn, sameSide, places_);
}

// Labels the half-planes of one operand by those of the other: going round, a left half-plane of
// the other is entered from behind, inside, and left in front, outside; a right one the other way.
int RadialOrder::labelOperand(OperandId operand, std::vector<Label>& labels) const {
	std::vector<RadialPlace> others;
	for (const RadialPlace& place : places_) {
		if (rays_[place.index].operand != operand) {
			others.push_back(place);
		}
	}
	const auto isLeft = [this](const RadialPlace& place) { return rays_[place.index].half.left; };
	for (std::size_t i = 0; i < others.size(); ++i) {
		const RadialPlace& next = others[(i + 1) % others.size()];
		const bool samePlace = others[i].slot == next.slot;  // also if it is the only one
		if (samePlace || isLeft(others[i]) == isLeft(next)) {
			return numberOf(otherOf(operand));
		}
	}
	for (const RadialPlace& place : places_) {
		if (rays_[place.index].operand != operand || others.empty()) {
			continue;
		}
		RadialPlace last = others.back();  // the last one before this ray, going round
		for (const RadialPlace& other : others) {
			last = other.slot <= place.slot ? other : last;
		}
		Label& label = labels[place.index];
		if (last.slot == place.slot) {
			label = isLeft(last) == isLeft(place) ? Label::OnSame : Label::OnOpposite;
		} else {
			label = isLeft(last) ? Label::Outside : Label::Inside;
		}
	}
	return -1;
}

int RadialOrder::label(std::vector<Label>& labels) const {
	labels.assign(rays_.size(), Label::Unknown);
	for (const OperandId operand : {kFirst, kSecond}) {
		if (const int wrong = labelOperand(operand, labels); wrong >= 0) {
			return wrong;
		}
	}
	return -1;
}

}  // namespace

bool sortAround(const Arrangement& arrangement, VertexId begin, VertexId end,
                const std::vector<HalfPlane>& halfPlanes, std::vector<RadialPlace>& places) {
	RadialOrder order(arrangement, begin, end);
	for (const HalfPlane& half : halfPlanes) {
		if (!order.add(half)) {
			return false;
		}
	}
	order.sort();
	places = order.places();
	return true;
}

int labelAround(const Arrangement& arrangement, const Segment& segment,
                std::vector<LabelledHalfPlane>& halfPlanes) {
	RadialOrder order(arrangement, segment.begin, segment.end);
	for (const LabelledHalfPlane& half : halfPlanes) {
		if (!order.add(half)) {
			return 0;
		}
	}
	order.sort();
	std::vector<Label> labels;
	const int wrong = order.label(labels);
	for (std::size_t i = 0; i < halfPlanes.size(); ++i) {
		halfPlanes[i].label = labels[i];
	}
	return wrong;
}

}  // namespace index_boolean
