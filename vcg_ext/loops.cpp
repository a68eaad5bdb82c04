// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains are walked from the junctions and open ends first; what is then left are cycles.
#include "loops.h"

#include "parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

// The segments at each point of the curve, in one array. Points are vertices, numbered densely
// here.
class Incidence {
public:
	explicit Incidence(const Curve& curve) : curve_(curve), segments_(2 * curve.segments.size()) {
		for (const Segment& s : curve.segments) {
			points_.push_back(s.begin);
			points_.push_back(s.end);
		}
		std::sort(points_.begin(), points_.end());
		points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
		first_.assign(points_.size() + 1, 0);
		for (const Segment& s : curve.segments) {
			++first_[index(s.begin) + 1];
			++first_[index(s.end) + 1];
		}
		for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
			first_[p + 1] += first_[p];
		}
		std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
		for (std::uint32_t s = 0; s < curve.segments.size(); ++s) {
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

private:
	std::size_t index(VertexId v) const {
		return static_cast<std::size_t>(std::lower_bound(points_.begin(), points_.end(), v) -
		                                points_.begin());
	}

	const Curve& curve_;
	std::vector<VertexId> points_;
	std::vector<std::uint32_t> first_;
	std::vector<std::uint32_t> segments_;
};

// Follows the chain that leaves `start` along `segment` to its next junction or end, or round.
Loop walk(const Incidence& incidence, VertexId start, SegmentId segment,
          std::vector<std::uint8_t>& visited) {
	Loop loop{LoopKind::HardClosed, {start}};
	VertexId point = start;
	while (true) {
		at(visited, segment) = 1;
		point = incidence.otherEnd(segment, point);
		loop.points.push_back(point);
		if (point == start || incidence.degree(point) != 2) {
			break;
		}
		const SegmentId first = incidence.segment(point, 0);
		segment = first == segment ? incidence.segment(point, 1) : first;
	}
	const std::uint32_t startDegree = incidence.degree(start);
	const std::uint32_t endDegree = incidence.degree(point);
	if (startDegree == 1 || endDegree == 1) {
		loop.kind = LoopKind::Open;
	} else if (startDegree != 2) {
		loop.kind = LoopKind::SoftClosed;
	}
	return loop;
}

void count(LoopKind kind, LoopCounts& counts) {
	switch (kind) {
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

}  // namespace

Status traceLoops(Arrangement& arrangement, Monitor& monitor) {
	const Curve& curve = arrangement.curve;
	const Incidence incidence(curve);
	std::vector<std::uint8_t> visited(curve.segments.size(), 0);
	const auto walkFrom = [&](VertexId p) {
		for (std::uint32_t i = 0; i < incidence.degree(p); ++i) {
			const SegmentId segment = incidence.segment(p, i);
			if (at(visited, segment) == 0) {
				arrangement.loops.push_back(walk(incidence, p, segment, visited));
				count(arrangement.loops.back().kind, arrangement.loopCounts);
			}
		}
	};
	for (const bool fromJunctions : {true, false}) {
		for (const VertexId point : incidence.points()) {
			if ((incidence.degree(point) != 2) == fromJunctions) {
				walkFrom(point);
			}
		}
	}
	Status status;
	status.code = pollCancelled(monitor) ? StatusCode::Cancelled : StatusCode::Ok;
	return status;
}

}  // namespace index_boolean
