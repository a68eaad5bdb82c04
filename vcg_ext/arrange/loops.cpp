// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains are walked from the junctions and open ends first; what is then left are cycles. Where
// every segment is the crossing of two faces, and at regular points everywhere, the degree of a
// point tells all; elsewhere the faces around it are asked.
#include "vcg_ext/arrange/loops.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/surface_complex.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

// The segments at each point of the curve, in one array. Points are vertices, numbered densely
// here.
class Incidence {
public:
	// Of the segments for which `counts` is true.
	template <class Counts>
	Incidence(const Arrangement& arrangement, Counts&& counts)
	    : curve_(arrangement.curve), vertexCount_(arrangement.vertexOf({0}).value) {
		const Curve& curve = curve_;
		std::vector<std::uint32_t> used;
		std::vector<VertexId> given;
		pointIndex_.assign(curve.pointCount(), kNone);
		for (std::uint32_t s = 0; s < curve.segments.size(); ++s) {
			if (counts(curve.segments[s])) {
				used.push_back(s);
				for (const VertexId v : {curve.segments[s].begin, curve.segments[s].end}) {
					if (v.value < vertexCount_) {
						given.push_back(v);
					} else {
						pointIndex_[v.value - vertexCount_] = 0;
					}
				}
			}
		}
		std::sort(given.begin(), given.end());
		given.erase(std::unique(given.begin(), given.end()), given.end());
		points_ = std::move(given);
		givenCount_ = points_.size();
		for (std::uint32_t p = 0; p < pointIndex_.size(); ++p) {
			if (pointIndex_[p] != kNone) {
				pointIndex_[p] = static_cast<std::uint32_t>(points_.size());
				points_.push_back({vertexCount_ + p});
			}
		}
		first_.assign(points_.size() + 1, 0);
		for (const std::uint32_t s : used) {
			++first_[index(curve.segments[s].begin) + 1];
			++first_[index(curve.segments[s].end) + 1];
		}
		for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
			first_[p + 1] += first_[p];
		}
		std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
		segments_.resize(2 * used.size());
		for (const std::uint32_t s : used) {
			segments_[next[index(curve.segments[s].begin)]++] = s;
			segments_[next[index(curve.segments[s].end)]++] = s;
		}
	}

	const std::vector<VertexId>& points() const { return points_; }
	std::uint32_t degree(VertexId v) const {
		const std::size_t p = index(v);
		return first_[p + 1] - first_[p];
	}
	SegmentId segment(VertexId v, std::uint32_t i) const {
		return {segments_[first_[index(v)] + i]};
	}
	VertexId otherEnd(SegmentId s, VertexId v) const {
		const Segment& segment = at(curve_.segments, s);
		return segment.begin == v ? segment.end : segment.begin;
	}
	// Of a point with two segments: the other one.
	SegmentId nextSegment(VertexId v, SegmentId s) const {
		return segment(v, 0) == s ? segment(v, 1) : segment(v, 0);
	}

private:
	std::size_t index(VertexId v) const {
		if (v.value >= vertexCount_) {
			return pointIndex_[v.value - vertexCount_];
		}
		const auto end = points_.begin() + static_cast<std::ptrdiff_t>(givenCount_);
		return static_cast<std::size_t>(std::lower_bound(points_.begin(), end, v) -
		                                points_.begin());
	}

	const Curve& curve_;
	std::uint32_t vertexCount_;              // of both operands
	std::vector<VertexId> points_;           // ascending: input vertices, then points of the curve
	std::size_t givenCount_ = 0;             // of the former
	std::vector<std::uint32_t> pointIndex_;  // in points_, per point of the curve
	std::vector<std::uint32_t> first_;
	std::vector<std::uint32_t> segments_;
};

class Tracer {
public:
	Tracer(Arrangement& arrangement, Monitor& monitor)
	    : arrangement_(arrangement), curve_(arrangement.curve), monitor_(monitor) {}

	Status run();

private:
	// Whether faces of two operands meet in a segment; lines in which an operand meets itself are
	// no loops.
	bool isOfTwo(const Segment& s) const {
		return arrangement_.mesh.operandOf(s.a) != arrangement_.mesh.operandOf(s.b);
	}
	bool isPassed(const Incidence& incidence, VertexId point) const;
	Loop walk(const Incidence& incidence, VertexId start, SegmentId segment);
	void trace(const Incidence& incidence);
	void orient(Loop& loop) const;
	bool isBefore(const Loop& a, const Loop& b) const;

	Arrangement& arrangement_;
	const Curve& curve_;
	Monitor& monitor_;
	bool allCross_ = true;
	SurfaceComplex complex_;  // of what lies at irregular points, unless allCross_
	std::vector<std::uint8_t> visited_;
};

// Whether the curve passes a point: it has two segments there, and the faces at the one are, going
// round the point, those at the other.
bool Tracer::isPassed(const Incidence& incidence, VertexId point) const {
	if (incidence.degree(point) != 2 || allCross_ || at(curve_.irregular, point) == 0) {
		return incidence.degree(point) == 2;
	}
	const VertexId before = incidence.otherEnd(incidence.segment(point, 0), point);
	const VertexId after = incidence.otherEnd(incidence.segment(point, 1), point);
	const PartingEdge* first = complex_.partingEdge(before, point);
	const PartingEdge* second = complex_.partingEdge(point, after);
	bool passed = first->count == second->count;
	for (std::uint32_t i = first->first; i < first->first + first->count && passed; ++i) {
		const HalfEdgeId last = complex_.turnAround(complex_.halfEdges[i], point);
		passed = complex_.beginOf(last) == after || complex_.endOf(last) == after;
	}
	return passed;
}

// Follows the chain that leaves `start` along `segment` to its next junction or end, or round.
Loop Tracer::walk(const Incidence& incidence, VertexId start, SegmentId segment) {
	Loop loop{LoopKind::HardClosed, {start}, {}};
	VertexId point = start;
	while (true) {
		at(visited_, segment) = 1;
		point = incidence.otherEnd(segment, point);
		loop.points.push_back(point);
		loop.faces.push_back({at(curve_.segments, segment).a, at(curve_.segments, segment).b});
		if (point == start || !isPassed(incidence, point)) {
			break;
		}
		segment = incidence.nextSegment(point, segment);
	}
	if (incidence.degree(start) == 1 || incidence.degree(point) == 1) {
		loop.kind = LoopKind::Open;
	} else if (!isPassed(incidence, start)) {
		loop.kind = LoopKind::SoftClosed;
	}
	return loop;
}

// Gives a loop the direction, and a cycle the start, that its coordinates tell.
void Tracer::orient(Loop& loop) const {
	const auto before = [this](VertexId a, VertexId b) {
		return comparePlaces(arrangement_, a, b) < 0;
	};
	std::vector<VertexId>& points = loop.points;
	if (loop.kind == LoopKind::HardClosed) {
		points.pop_back();
		const auto smallest = std::min_element(points.begin(), points.end(), before);
		std::rotate(loop.faces.begin(), loop.faces.begin() + (smallest - points.begin()),
		            loop.faces.end());
		std::rotate(points.begin(), smallest, points.end());
		points.push_back(points.front());
	}
	const bool isCycle = points.front() == points.back();
	const VertexId first = isCycle ? points[1] : points.front();
	const VertexId last = isCycle ? points[points.size() - 2] : points.back();
	if (before(last, first)) {
		std::reverse(points.begin(), points.end());
		std::reverse(loop.faces.begin(), loop.faces.end());
	}
}

bool Tracer::isBefore(const Loop& a, const Loop& b) const {
	return std::lexicographical_compare(
	    a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
	    [this](VertexId p, VertexId q) { return comparePlaces(arrangement_, p, q) < 0; });
}

void Tracer::trace(const Incidence& incidence) {
	visited_.assign(curve_.segments.size(), 0);
	std::vector<Loop>& loops = arrangement_.loops;
	for (const bool fromJunctions : {true, false}) {
		for (const VertexId point : incidence.points()) {
			if (fromJunctions && isPassed(incidence, point)) {
				continue;
			}
			for (std::uint32_t i = 0; i < incidence.degree(point); ++i) {
				const SegmentId segment = incidence.segment(point, i);
				if (at(visited_, segment) == 0) {
					loops.push_back(walk(incidence, point, segment));
					orient(loops.back());
				}
			}
		}
	}
	std::sort(loops.begin(), loops.end(),
	          [this](const Loop& a, const Loop& b) { return isBefore(a, b); });
}

void count(const std::vector<Loop>& loops, LoopCounts& counts) {
	for (const Loop& loop : loops) {
		switch (loop.kind) {
		case LoopKind::Open:
			++counts.open;
			break;
		case LoopKind::HardClosed:
			++counts.hardClosed;
			break;
		case LoopKind::SoftClosed:
			++counts.softClosed;
			break;
		}
	}
}

Status Tracer::run() {
	allCross_ = std::all_of(curve_.segments.begin(), curve_.segments.end(),
	                        [](const Segment& s) { return s.crossing; });
	Status status;
	if (!allCross_) {
		status = buildComplex(arrangement_, ComplexOf::IrregularPoints, monitor_, complex_);
	}
	if (status.ok()) {
		trace(Incidence(arrangement_, [this](const Segment& s) {
			return s.crossing || (isOfTwo(s) && complex_.partingEdge(s.begin, s.end) != nullptr);
		}));
		count(arrangement_.loops, arrangement_.loopCounts);
		status.code = pollCancelled(monitor_) ? StatusCode::Cancelled : StatusCode::Ok;
	}
	return status;
}

}  // namespace

Status traceLoops(Arrangement& arrangement, Monitor& monitor) {
	return Tracer(arrangement, monitor).run();
}

}  // namespace index_boolean
