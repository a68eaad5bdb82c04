// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line sweeps from left to right. Between two neighbouring edges that it crosses (an interval,
// owned by the lower edge) lies a chain: the right border of what is triangulated there, from the
// left end of the lower edge to the left end of the upper one.
//
// Why it triangulates: after each point, (1) a chain turns left at all its inner points, so that it
// bulges to the right and no triangle fits into it, and (2) `last` is its rightmost point. From (1)
// follows that what a new point sees of a chain is connected. What happens to its intervals:
// - Between two edges that end at the point the chain lies in the triangle of its ends and the
//   point. So its first and last links are seen, hence all; a fan fills the interval.
// - Below the lowest such edge the chain's top, being that edge's left end, is seen; what else is,
//   begins there. Cutting it off and adding the point as new top keeps (1) and (2). Above the
//   highest such edge, the same from the bottom.
// - If no edge ends at the point, it lies inside one interval, where nothing is further right than
//   `last`: so no edge is between the two. The chain is parted there and both parts treated as
//   above.
// - If no edge begins at the point, both parts are one chain again, and at the point, its
// rightmost,
//   it turns left. Else the edges part them, and a chain of the point alone is between every two.
// Each link is covered from the right once, and no edge is ever crossed. When no edge is left, all
// between the polygon's sides is covered, and every edge is a side of triangles. Finding an
// interval takes O(log n), and each link is cut off once.
//
// Why it is local: all that is done reads one chain, which belongs to one of the regions that the
// edges part the polygon into, and the edges around it. What triangles a region gets does not
// depend on what lies around it: coplanar faces of two operands are cut alike where they overlap.
#include "vcg_ext/exact/planar_sweep.h"

#include "vcg_ext/base/ids.h"
#include "vcg_ext/base/parallel.h"

#include <boost/intrusive/set.hpp>

#include <algorithm>

namespace index_boolean {

namespace {

// One entry of a chain; neighbours by index.
struct Link {
	std::uint32_t point;
	std::uint32_t below, above;
};

struct Chain {
	std::uint32_t bottom = kNone, top = kNone;  // links
	std::uint32_t last = kNone;                 // the link added last: the rightmost point
};

struct ActiveEdge : boost::intrusive::set_base_hook<> {
	PlanarEdge edge{};
	Chain chain;  // of the interval above this edge
};

using ActiveEdges = boost::intrusive::set<ActiveEdge>;

}  // namespace

// What the sweep line knows.
class PlanarSweep::Line {
public:
	~Line() { active_.clear(); }

	bool run(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges,
	         const PlanarOrientation& orientation, Monitor& monitor,
	         std::vector<std::array<std::uint32_t, 3>>& triangles);

private:
	void start(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges);
	void sortOutgoing(std::uint32_t point);
	bool visit(std::uint32_t point);
	bool findInterval(std::uint32_t point, ActiveEdges::iterator& upper);
	bool closeIncoming(std::uint32_t point, ActiveEdges::iterator& it, Chain& upperChain,
	                   bool& hasUpper);
	Chain splitAtLast(Chain& chain);
	void attachTop(Chain& chain, std::uint32_t point);
	void attachBottom(Chain& chain, std::uint32_t point);
	Chain join(const Chain& lower, const Chain& upper);
	std::uint32_t newLink(std::uint32_t point, std::uint32_t below, std::uint32_t above);
	bool emitFan(std::uint32_t point, const Chain& chain);
	std::uint32_t pointOf(std::uint32_t link) const { return links_[link].point; }
	int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
		return (*orientation_)(a, b, c);
	}
	void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
		triangles_->push_back({a, b, c});
	}

	const PlanarOrientation* orientation_ = nullptr;
	std::vector<std::array<std::uint32_t, 3>>* triangles_ = nullptr;
	std::vector<ActiveEdge> edges_;             // sorted by left end, then upwards
	std::vector<std::uint32_t> firstOutgoing_;  // per point, into edges_; one past the end last
	std::vector<std::uint32_t> anyIncoming_;    // per point, an edge that ends there, or kNone
	std::vector<PlanarEdge> outgoing_;          // of one point, while they are sorted
	std::vector<Link> links_;
	ActiveEdges active_;  // upwards
};

bool PlanarSweep::Line::run(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges,
                            const PlanarOrientation& orientation, Monitor& monitor,
                            std::vector<std::array<std::uint32_t, 3>>& triangles) {
	orientation_ = &orientation;
	triangles_ = &triangles;
	triangles.clear();
	start(pointCount, edges);
	constexpr std::uint32_t kPointsAPoll = 4096;
	for (std::uint32_t point = 0; point < pointCount; ++point) {
		const bool isStopped = point % kPointsAPoll == kPointsAPoll - 1 && pollCancelled(monitor);
		if (isStopped || !visit(point)) {
			return false;
		}
	}
	return active_.empty();
}

void PlanarSweep::Line::start(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges) {
	active_.clear();
	links_.clear();
	edges_.resize(edges.size());
	firstOutgoing_.assign(pointCount + 1, 0);
	anyIncoming_.assign(pointCount, kNone);
	for (const PlanarEdge& e : edges) {
		++firstOutgoing_[e.left];
	}
	std::uint32_t sum = 0;
	for (std::uint32_t& first : firstOutgoing_) {
		sum += first;
		first = sum;  // the end; filling moves it to the beginning
	}
	for (const PlanarEdge& e : edges) {
		edges_[--firstOutgoing_[e.left]].edge = e;
	}
	for (std::uint32_t p = 0; p < pointCount; ++p) {
		sortOutgoing(p);
	}
	for (std::uint32_t e = 0; e < edges_.size(); ++e) {
		anyIncoming_[edges_[e].edge.right] = e;
	}
}

// Upwards: b comes after a if its right end lies left of point -> a's right end.
void PlanarSweep::Line::sortOutgoing(std::uint32_t point) {
	const auto begin = edges_.begin() + firstOutgoing_[point];
	const auto end = edges_.begin() + firstOutgoing_[point + 1];
	const auto isBelow = [this, point](PlanarEdge a, PlanarEdge b) {
		return orientation(point, a.right, b.right) > 0;
	};
	if (end - begin < 2) {
		return;
	}
	if (end - begin == 2) {  // by far the most frequent case: one question, not two
		if (isBelow(begin[1].edge, begin[0].edge)) {
			std::swap(begin[0].edge, begin[1].edge);
		}
		return;
	}
	outgoing_.clear();
	std::transform(begin, end, std::back_inserter(outgoing_),
	               [](const ActiveEdge& e) { return e.edge; });
	std::sort(outgoing_.begin(), outgoing_.end(), isBelow);
	std::transform(begin, end, outgoing_.begin(), begin,
	               [](ActiveEdge& e, PlanarEdge edge) -> ActiveEdge& {
		               e.edge = edge;
		               return e;
	               });
}

// The lowest edge above a point that no edge ends at. False if the point lies on an edge or
// outside.
bool PlanarSweep::Line::findInterval(std::uint32_t point, ActiveEdges::iterator& upper) {
	bool onEdge = false;
	const auto isBelow = [this, &onEdge](std::uint32_t p, const ActiveEdge& e) {
		const int side = orientation(e.edge.left, e.edge.right, p);
		onEdge = onEdge || side == 0;
		return side < 0;
	};
	upper = active_.upper_bound(point, isBelow);
	return !onEdge && upper != active_.begin() && upper != active_.end();
}

// Takes out the edges that end at the point, from the lowest, `it`, upwards, and fills the
// intervals between them. Leaves `it` above them; the chain above the highest goes to upperChain if
// there is an interval above it. False if the point does not see what it should.
bool PlanarSweep::Line::closeIncoming(std::uint32_t point, ActiveEdges::iterator& it,
                                      Chain& upperChain, bool& hasUpper) {
	while (it != active_.end() && it->edge.right == point) {
		upperChain = it->chain;
		it = active_.erase(it);
		hasUpper = it != active_.end();
		if (hasUpper && it->edge.right == point && !emitFan(point, upperChain)) {
			return false;
		}
	}
	return true;
}

bool PlanarSweep::Line::visit(std::uint32_t point) {
	Chain lower, upper;
	bool hasLower = false, hasUpper = false;
	ActiveEdges::iterator above = active_.end();
	if (anyIncoming_[point] != kNone) {
		above = active_.iterator_to(edges_[anyIncoming_[point]]);
		while (above != active_.begin() && std::prev(above)->edge.right == point) {
			--above;
		}
		hasLower = above != active_.begin();
		if (hasLower) {
			lower = std::prev(above)->chain;
		}
		if (!closeIncoming(point, above, upper, hasUpper)) {
			return false;
		}
	} else if (!active_.empty()) {
		if (!findInterval(point, above)) {
			return false;
		}
		lower = std::prev(above)->chain;
		upper = splitAtLast(lower);
		hasLower = hasUpper = true;
	} else if (point != 0) {
		return false;
	}

	if (hasLower) {
		attachTop(lower, point);
	}
	if (hasUpper) {
		attachBottom(upper, point);
	} else {
		const std::uint32_t link = newLink(point, kNone, kNone);
		upper = {link, link, link};
	}
	const std::uint32_t begin = firstOutgoing_[point], end = firstOutgoing_[point + 1];
	if (begin == end && hasLower != hasUpper) {
		return false;  // the polygon would be open here
	}
	if (hasLower) {
		std::prev(above)->chain = begin == end ? join(lower, upper) : lower;
	}
	for (std::uint32_t e = begin; e < end; ++e) {
		const std::uint32_t link = e + 1 < end ? newLink(point, kNone, kNone) : kNone;
		edges_[e].chain = e + 1 < end ? Chain{link, link, link} : upper;
		active_.insert_before(above, edges_[e]);
	}
	return true;
}

std::uint32_t PlanarSweep::Line::newLink(std::uint32_t point, std::uint32_t below,
                                         std::uint32_t above) {
	links_.push_back({point, below, above});
	return static_cast<std::uint32_t>(links_.size() - 1);
}

// Cuts the chain at the link added last, which both parts keep; returns the upper part.
Chain PlanarSweep::Line::splitAtLast(Chain& chain) {
	const std::uint32_t above = links_[chain.last].above;
	const std::uint32_t copy = newLink(pointOf(chain.last), kNone, above);
	if (above != kNone) {
		links_[above].below = copy;
	}
	links_[chain.last].above = kNone;
	const Chain upper{copy, above == kNone ? copy : chain.top, copy};
	chain.top = chain.last;
	return upper;
}

// Adds a point above the chain's top, after cutting off what it sees from there.
void PlanarSweep::Line::attachTop(Chain& chain, std::uint32_t point) {
	std::uint32_t top = chain.top;
	for (std::uint32_t next = links_[top].below; next != kNone; next = links_[top].below) {
		if (orientation(pointOf(next), point, pointOf(top)) <= 0) {
			break;
		}
		emit(pointOf(next), point, pointOf(top));
		top = next;
	}
	const std::uint32_t link = newLink(point, top, kNone);
	links_[top].above = link;
	chain.top = chain.last = link;
}

// The same below the chain's bottom.
void PlanarSweep::Line::attachBottom(Chain& chain, std::uint32_t point) {
	std::uint32_t bottom = chain.bottom;
	for (std::uint32_t next = links_[bottom].above; next != kNone; next = links_[bottom].above) {
		if (orientation(pointOf(bottom), point, pointOf(next)) <= 0) {
			break;
		}
		emit(pointOf(bottom), point, pointOf(next));
		bottom = next;
	}
	const std::uint32_t link = newLink(point, kNone, bottom);
	links_[bottom].below = link;
	chain.bottom = chain.last = link;
}

// Joins two chains, the lower of which ends with the point that the upper begins with.
Chain PlanarSweep::Line::join(const Chain& lower, const Chain& upper) {
	const std::uint32_t above = links_[upper.bottom].above;
	links_[lower.top].above = above;
	if (above == kNone) {
		return lower;
	}
	links_[above].below = lower.top;
	return {lower.bottom, upper.top, lower.top};
}

// Fills the interval between two edges that end at the point. It sees the whole chain, unless edges
// cross: every triangle of a result is known to be counter-clockwise, so that a result whose edges
// match is one layer.
bool PlanarSweep::Line::emitFan(std::uint32_t point, const Chain& chain) {
	for (std::uint32_t link = chain.bottom; links_[link].above != kNone;
	     link = links_[link].above) {
		const std::uint32_t next = pointOf(links_[link].above);
		if (orientation(pointOf(link), point, next) <= 0) {
			return false;
		}
		emit(pointOf(link), point, next);
	}
	return true;
}

PlanarSweep::PlanarSweep() : line_(std::make_unique<Line>()) {}

PlanarSweep::~PlanarSweep() = default;

bool PlanarSweep::triangulate(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges,
                              const PlanarOrientation& orientation, Monitor& monitor,
                              std::vector<std::array<std::uint32_t, 3>>& triangles) {
	return line_->run(pointCount, edges, orientation, monitor, triangles);
}

}  // namespace index_boolean
