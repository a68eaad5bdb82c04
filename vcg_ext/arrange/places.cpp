// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A name's simplices define its point; rounded coordinates answer what they can.
#include "vcg_ext/arrange/places.h"

#include "vcg_ext/exact/nearest_float.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

// The exact point rounded to float, once: the double next to it decides, unless it lies half-way
// between two floats; then the exact point's side of it does.
double roundedToFloat(const ExactPoint& point, std::size_t axis) {
	const double value = point.rounded[axis];
	const double nearest = nearestFloat(value);
	if (point.form == ExactPoint::Form::Explicit || !std::isfinite(nearest)) {
		return nearest;
	}
	const float towards = value > nearest ? HUGE_VALF : -HUGE_VALF;
	const auto next = static_cast<double>(std::nextafter(static_cast<float>(nearest), towards));
	if (value - nearest != next - value) {
		return nearest;
	}
	const Point middle = point.rounded;
	const int side =
	    compareCoordinate(point, ExactPoint::explicitPoint(middle), static_cast<int>(axis));
	return side == 0 ? nearest : (side < 0 ? std::min(nearest, next) : std::max(nearest, next));
}

template <class Scalar>
double gapAbove(double size) {
	const auto value = static_cast<Scalar>(size);
	const Scalar next = std::nextafter(value, static_cast<Scalar>(HUGE_VAL));
	return std::isfinite(next) ? static_cast<double>(next - value)
	                           : static_cast<double>(value - std::nextafter(value, Scalar{0}));
}

}  // namespace

ExactPoint exactPointOf(const MeshArrays& mesh, const PointName& name) {
	const auto& ids = name.ids;
	const Points& points = mesh.points;
	switch (name.kind) {
	case PointKind::EdgeEdge:
		return ExactPoint::lineLine(
		    {&points[ids[0]], &points[ids[1]], &points[ids[2]], &points[ids[3]]}, name.axis);
	case PointKind::EdgeFace: {
		const Triangle& face = mesh.triangles[ids[2]];
		return ExactPoint::linePlane({&points[ids[0]], &points[ids[1]], &at(points, face[0]),
		                              &at(points, face[1]), &at(points, face[2])});
	}
	case PointKind::FaceFaceFace: {
		std::array<const Point*, 9> corners{};
		for (std::size_t i = 0; i < corners.size(); ++i) {
			corners[i] = &at(points, mesh.triangles[ids[i / 3]][i % 3]);
		}
		return ExactPoint::threePlanes(corners);
	}
	case PointKind::Vertex:
	case PointKind::OnEdge:
		break;
	}
	return ExactPoint::explicitPoint(points[ids[0]]);
}

ExactPoint exactPoint(const Arrangement& arrangement, VertexId vertex) {
	if (!arrangement.isCurvePoint(vertex)) {
		return ExactPoint::explicitPoint(at(arrangement.mesh.points, vertex));
	}
	const PointId id = arrangement.pointOf(vertex);
	ExactPoint point = exactPointOf(arrangement.mesh, at(arrangement.curve.names, id));
	point.rounded = at(arrangement.curve.rounded, id);
	return point;
}

int comparePlaces(const Arrangement& arrangement, VertexId a, VertexId b) {
	const Point& p = arrangement.coordinates(a);
	const Point& q = arrangement.coordinates(b);
	if (p != q) {
		return p < q ? -1 : 1;
	}
	const bool areInput = !arrangement.isCurvePoint(a) && !arrangement.isCurvePoint(b);
	for (int axis = 0; axis < 3 && a != b && !areInput; ++axis) {
		const int order =
		    compareCoordinate(exactPoint(arrangement, a), exactPoint(arrangement, b), axis);
		if (order != 0) {
			return order;
		}
	}
	return 0;
}

AxisDirection directionBetween(const Arrangement& arrangement, VertexId from, VertexId to) {
	const Point& p = arrangement.coordinates(from);
	const Point& q = arrangement.coordinates(to);
	AxisDirection found{0, 0};
	double most = -1;
	for (int axis = 0; axis < 3; ++axis) {
		const auto k = static_cast<std::size_t>(axis);
		const double length = q[k] / 2 - p[k] / 2;  // halves, so that it is finite
		if (std::fabs(length) > most && p[k] != q[k]) {
			most = std::fabs(length);
			found = {axis, p[k] < q[k] ? 1 : -1};
		}
	}
	for (int axis = 0; axis < 3 && found.sign == 0; ++axis) {
		found = {axis, compareCoordinate(exactPoint(arrangement, to), exactPoint(arrangement, from),
		                                 axis)};
	}
	return found;
}

namespace {

bool isInScalar(const Point& p, OutputScalar scalar) {
	return std::all_of(p.begin(), p.end(), [scalar](double x) { return inScalar(x, scalar) == x; });
}

}  // namespace

bool isStoredExactly(const Arrangement& arrangement, VertexId vertex) {
	const auto& moved = arrangement.movedPlaces;
	if (arrangement.isCurvePoint(vertex) || (!moved.empty() && moved.count(vertex) != 0)) {
		return false;
	}
	return isInScalar(at(arrangement.mesh.points, vertex), arrangement.options.outputScalar);
}

bool isStoredExactly(const Points& points, OutputScalar scalar) {
	return scalar == OutputScalar::Double ||
	       std::all_of(points.begin(), points.end(),
	                   [scalar](const Point& p) { return isInScalar(p, scalar); });
}

void roundPlaces(OutputScalar scalar, Points& points) {
	for (Point& p : points) {
		for (double& x : p) {
			x = inScalar(x, scalar);
		}
	}
}

double inScalar(double x, OutputScalar scalar) {
	return scalar == OutputScalar::Double ? x : nearestFloat(x);
}

double gapAt(double x, OutputScalar scalar) {
	return scalar == OutputScalar::Double ? gapAbove<double>(std::fabs(x))
	                                      : gapAbove<float>(std::fabs(x));
}

Point roundedPlace(const Arrangement& arrangement, VertexId vertex) {
	if (arrangement.options.outputScalar == OutputScalar::Double) {
		return arrangement.coordinates(vertex);
	}
	const ExactPoint exact = exactPoint(arrangement, vertex);
	return {roundedToFloat(exact, 0), roundedToFloat(exact, 1), roundedToFloat(exact, 2)};
}

Point outputCoordinates(const Arrangement& arrangement, VertexId vertex) {
	if (!arrangement.movedPlaces.empty()) {
		const auto moved = arrangement.movedPlaces.find(vertex);
		if (moved != arrangement.movedPlaces.end()) {
			return moved->second;
		}
	}
	return roundedPlace(arrangement, vertex);
}

}  // namespace index_boolean
