// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names sort by their edge first, so that the points of one edge are neighbours: one sort numbers
// the points and finds the cut edges.
#include "weld.h"

#include "parallel.h"

#include <algorithm>
#include <atomic>

namespace index_boolean {

namespace {

// One end of one segment: 2 * segment + (0 begin | 1 end).
struct NamedEnd {
	PointName name;
	std::uint32_t end;
};

void numberPoints(const std::vector<NamedSegment>& segments, Curve& curve) {
	std::vector<NamedEnd> ends;
	ends.reserve(2 * segments.size());
	for (const NamedSegment& s : segments) {
		ends.push_back({s.begin, static_cast<std::uint32_t>(ends.size())});
		ends.push_back({s.end, static_cast<std::uint32_t>(ends.size())});
	}
	std::sort(ends.begin(), ends.end(), [](const NamedEnd& a, const NamedEnd& b) {
		return a.name == b.name ? a.end < b.end : a.name < b.name;
	});
	curve.segments.resize(segments.size());
	for (const NamedEnd& e : ends) {
		if (curve.names.empty() || !(curve.names.back() == e.name)) {
			curve.names.push_back(e.name);
		}
		const PointId point = makeId<PointTag>(curve.names.size() - 1);
		Segment& segment = curve.segments[e.end / 2];
		(e.end % 2 == 0 ? segment.begin : segment.end) = point;
	}
	for (std::size_t i = 0; i < segments.size(); ++i) {
		curve.segments[i].a = segments[i].a;
		curve.segments[i].b = segments[i].b;
	}
}

void collectCutEdges(Curve& curve) {
	for (std::uint32_t p = 0; p < curve.names.size(); ++p) {
		const VertexId low{curve.names[p].ids[0]};
		const VertexId high{curve.names[p].ids[1]};
		if (curve.cutEdges.empty() || curve.cutEdges.back().low != low ||
		    curve.cutEdges.back().high != high) {
			curve.cutEdges.push_back({low, high, p, 0});
		}
		++curve.cutEdges.back().count;
		curve.pointsOnEdges.push_back({p});
	}
}

Status roundPoints(Arrangement& arrangement, Monitor& monitor) {
	Curve& curve = arrangement.curve;
	curve.rounded.resize(curve.pointCount());
	return parallelFor(curve.pointCount(), 256, arrangement.options.threads, monitor,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t p = begin; p < end; ++p) {
			                   const PointId id = makeId<PointTag>(p);
			                   ExactPoint point = exactPoint(arrangement, arrangement.vertexOf(id));
			                   roundPoint(point);
			                   curve.rounded[p] = point.rounded;
		                   }
	                   });
}

// The axis along which an edge is longest: coordinates grow or fall strictly along it.
int longestAxis(const Point& a, const Point& b) {
	int best = 0;
	double most = -1;
	for (int axis = 0; axis < 3; ++axis) {
		const auto k = static_cast<std::size_t>(axis);
		// Halves, so that the difference of two finite numbers is finite.
		const double length = std::fabs(a[k] / 2 - b[k] / 2);
		if (length > most && a[k] != b[k]) {
			most = length;
			best = axis;
		}
	}
	return best;
}

// Sorts the points of one edge from its low end on. False if two of them coincide.
bool sortAlongEdge(const Arrangement& arrangement, const CutEdge& edge, PointId* points) {
	const Point& low = at(arrangement.mesh.points, edge.low);
	const Point& high = at(arrangement.mesh.points, edge.high);
	const int axis = longestAxis(low, high);
	const bool rising = low[static_cast<std::size_t>(axis)] < high[static_cast<std::size_t>(axis)];
	bool distinct = true;
	std::sort(points, points + edge.count, [&](PointId a, PointId b) {
		if (a == b) {
			return false;
		}
		const int order = compareCoordinate(exactPoint(arrangement, arrangement.vertexOf(a)),
		                                    exactPoint(arrangement, arrangement.vertexOf(b)), axis);
		distinct = distinct && order != 0;
		return rising ? order < 0 : order > 0;
	});
	return distinct;
}

Status refuseCoincidentPoints(const Arrangement& arrangement, const CutEdge& edge) {
	Status status;
	status.code = StatusCode::SelfIntersecting;
	status.operand = 1 - arrangement.mesh.operandOf(edge.low);
	for (std::uint32_t i = 0; i < edge.count; ++i) {
		const PointId p = arrangement.curve.pointsOnEdges[edge.first + i];
		status.faces.push_back(arrangement.givenFace({at(arrangement.curve.names, p).ids[2]}));
	}
	std::sort(status.faces.begin(), status.faces.end());
	status.count = status.faces.size();
	status.hasPlace = true;
	status.place = at(arrangement.curve.rounded, arrangement.curve.pointsOnEdges[edge.first]);
	return status;
}

Status sortPointsOnEdges(Arrangement& arrangement, Monitor& monitor) {
	Curve& curve = arrangement.curve;
	std::atomic<std::uint32_t> firstTied{0xffffffffu};
	Status status = parallelFor(
	    curve.cutEdges.size(), 64, arrangement.options.threads, monitor,
	    [&](std::size_t begin, std::size_t end) {
		    for (std::size_t e = begin; e < end; ++e) {
			    const CutEdge& edge = curve.cutEdges[e];
			    if (!sortAlongEdge(arrangement, edge, curve.pointsOnEdges.data() + edge.first)) {
				    const auto tied = static_cast<std::uint32_t>(e);
				    std::uint32_t known = firstTied.load();
				    while (tied < known && !firstTied.compare_exchange_weak(known, tied)) {
				    }
			    }
		    }
	    });
	if (status.ok() && firstTied.load() != 0xffffffffu) {
		return refuseCoincidentPoints(arrangement, curve.cutEdges[firstTied.load()]);
	}
	return status;
}

}  // namespace

ExactPoint exactPoint(const Arrangement& arrangement, VertexId vertex) {
	const std::vector<Point>& points = arrangement.mesh.points;
	if (!arrangement.isCurvePoint(vertex)) {
		return ExactPoint::explicitPoint(at(points, vertex));
	}
	const PointId id = arrangement.pointOf(vertex);
	const auto& ids = at(arrangement.curve.names, id).ids;
	const Triangle& face = arrangement.mesh.triangles[ids[2]];
	ExactPoint point =
	    ExactPoint::linePlane({&points[ids[0]], &points[ids[1]], &at(points, face[0]),
	                           &at(points, face[1]), &at(points, face[2])});
	point.rounded = at(arrangement.curve.rounded, id);
	return point;
}

Status weldPoints(Arrangement& arrangement, const std::vector<NamedSegment>& segments,
                  Monitor& monitor) {
	numberPoints(segments, arrangement.curve);
	collectCutEdges(arrangement.curve);
	const Status status = roundPoints(arrangement, monitor);
	return status.ok() ? sortPointsOnEdges(arrangement, monitor) : status;
}

}  // namespace index_boolean
