// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains are walked from the junctions and open ends first; what is then left are cycles.
#include "loops.h"

#include "parallel.h"

namespace index_boolean {

namespace {

// The segments at each point, in one array.
class Incidence {
public:
	explicit Incidence(const Curve& curve)
	    : curve_(curve), first_(curve.pointCount() + 1, 0), segments_(2 * curve.segments.size()) {
		for (const Segment& s : curve.segments) {
			++first_[s.begin.value + 1];
			++first_[s.end.value + 1];
		}
		for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
			first_[p + 1] += first_[p];
		}
		std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
		for (std::uint32_t s = 0; s < curve.segments.size(); ++s) {
			segments_[at(next, curve.segments[s].begin)++] = s;
			segments_[at(next, curve.segments[s].end)++] = s;
		}
	}

	std::uint32_t degree(PointId p) const { return first_[p.value + 1] - first_[p.value]; }
	SegmentId segment(PointId p, std::uint32_t i) const { return {segments_[first_[p.value] + i]}; }
	PointId otherEnd(SegmentId s, PointId p) const {
		const Segment& segment = at(curve_.segments, s);
		return segment.begin == p ? segment.end : segment.begin;
	}

private:
	const Curve& curve_;
	std::vector<std::uint32_t> first_;
	std::vector<std::uint32_t> segments_;
};

// Follows the chain that leaves `start` along `segment` to its next junction or end, or round.
Loop walk(const Incidence& incidence, PointId start, SegmentId segment,
          std::vector<std::uint8_t>& visited) {
	Loop loop{LoopKind::HardClosed, {start}};
	PointId point = start;
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
	case LoopKind::Open: ++counts.open; break;
	case LoopKind::HardClosed: ++counts.hardClosed; break;
	case LoopKind::SoftClosed: ++counts.softClosed; break;
	}
}

}  // namespace

Status traceLoops(Arrangement& arrangement, Monitor& monitor) {
	const Curve& curve = arrangement.curve;
	const Incidence incidence(curve);
	std::vector<std::uint8_t> visited(curve.segments.size(), 0);
	const auto walkFrom = [&](PointId p) {
		for (std::uint32_t i = 0; i < incidence.degree(p); ++i) {
			const SegmentId segment = incidence.segment(p, i);
			if (at(visited, segment) == 0) {
				arrangement.loops.push_back(walk(incidence, p, segment, visited));
				count(arrangement.loops.back().kind, arrangement.loopCounts);
			}
		}
	};
	for (const bool fromJunctions : {true, false}) {
		for (std::uint32_t p = 0; p < curve.pointCount(); ++p) {
			if ((incidence.degree({p}) != 2) == fromJunctions) {
				walkFrom({p});
			}
		}
	}
	Status status;
	status.code = pollCancelled(monitor) ? StatusCode::Cancelled : StatusCode::Ok;
	return status;
}

}  // namespace index_boolean
