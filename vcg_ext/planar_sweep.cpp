// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line sweeps from left to right. Between two neighbouring edges that it crosses (an interval,
// owned by the lower edge) lies a chain: the right border of what is triangulated there, from the
// left end of the lower edge to the left end of the upper one. No triangle fits into a chain, so it
// bulges to the right, and a new point sees a connected part of it that starts at an end or, for a
// point that no edge reaches from the left, at the point of the chain that was added last.
#include "planar_sweep.h"

#include <boost/intrusive/set.hpp>

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

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

class Sweep {
public:
	Sweep(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges,
	      const PlanarOrientation& orientation, std::vector<std::array<std::uint32_t, 3>>& out);
	~Sweep() { status_.clear(); }

	bool run();

private:
	void sortOutgoing(std::uint32_t point);
	bool visit(std::uint32_t point);
	bool findInterval(std::uint32_t point, ActiveEdges::iterator& upper) const;
	bool closeIncoming(std::uint32_t point, ActiveEdges::iterator& it, Chain& upperChain,
	                   bool& hasUpper);
	Chain splitAtLast(Chain& chain);
	void attachTop(Chain& chain, std::uint32_t point);
	void attachBottom(Chain& chain, std::uint32_t point);
	Chain join(const Chain& lower, const Chain& upper);
	std::uint32_t newLink(std::uint32_t point, std::uint32_t below, std::uint32_t above);
	bool emitFan(std::uint32_t point, const Chain& chain);
	std::uint32_t pointOf(std::uint32_t link) const { return links_[link].point; }

	const PlanarOrientation& orientation_;
	std::vector<std::array<std::uint32_t, 3>>& triangles_;
	std::vector<ActiveEdge> edges_;             // sorted by left end, then upwards
	std::vector<std::uint32_t> firstOutgoing_;  // per point, into edges_; one past the end last
	std::vector<std::uint32_t> anyIncoming_;    // per point, an edge that ends there, or kNone
	std::vector<Link> links_;
	ActiveEdges status_;  // upwards
};

Sweep::Sweep(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges,
             const PlanarOrientation& orientation, std::vector<std::array<std::uint32_t, 3>>& out)
    : orientation_(orientation), triangles_(out), edges_(edges.size()),
      firstOutgoing_(pointCount + 1, 0), anyIncoming_(pointCount, kNone) {
	for (const PlanarEdge& e : edges) {
		++firstOutgoing_[e.left + 1];
	}
	for (std::uint32_t p = 0; p < pointCount; ++p) {
		firstOutgoing_[p + 1] += firstOutgoing_[p];
	}
	std::vector<std::uint32_t> next(firstOutgoing_.begin(), firstOutgoing_.end() - 1);
	for (const PlanarEdge& e : edges) {
		edges_[next[e.left]++].edge = e;
	}
	for (std::uint32_t p = 0; p < pointCount; ++p) {
		sortOutgoing(p);
	}
	for (std::uint32_t e = 0; e < edges_.size(); ++e) {
		anyIncoming_[edges_[e].edge.right] = e;
	}
	links_.reserve(2 * static_cast<std::size_t>(pointCount));
}

// Upwards: b comes after a if its right end lies left of point -> a's right end.
void Sweep::sortOutgoing(std::uint32_t point) {
	const auto below = [this, point](const ActiveEdge& a, const ActiveEdge& b) {
		return orientation_(point, a.edge.right, b.edge.right) > 0;
	};
	const auto begin = edges_.begin() + firstOutgoing_[point];
	const auto end = edges_.begin() + firstOutgoing_[point + 1];
	if (end - begin == 2) {  // by far the most frequent case of more than one
		if (below(begin[1], begin[0])) {
			std::swap(begin[0].edge, begin[1].edge);
		}
		return;
	}
	std::vector<PlanarEdge> sorted;
	std::transform(begin, end, std::back_inserter(sorted),
	               [](const ActiveEdge& e) { return e.edge; });
	std::sort(sorted.begin(), sorted.end(), [this, point](PlanarEdge a, PlanarEdge b) {
		return orientation_(point, a.right, b.right) > 0;
	});
	std::transform(begin, end, sorted.begin(), begin,
	               [](ActiveEdge& e, PlanarEdge edge) -> ActiveEdge& {
		               e.edge = edge;
		               return e;
	               });
}

bool Sweep::run() {
	for (std::uint32_t point = 0; point < anyIncoming_.size(); ++point) {
		if (!visit(point)) {
			return false;
		}
	}
	return status_.empty();
}

// The lowest edge above a point that no edge ends at. False if the point lies on an edge or
// outside.
bool Sweep::findInterval(std::uint32_t point, ActiveEdges::iterator& upper) const {
	bool onEdge = false;
	const auto isBelow = [this, &onEdge](std::uint32_t p, const ActiveEdge& e) {
		const int side = orientation_(e.edge.left, e.edge.right, p);
		onEdge = onEdge || side == 0;
		return side < 0;
	};
	auto& status = const_cast<ActiveEdges&>(status_);
	upper = status.upper_bound(point, isBelow);
	return !onEdge && upper != status.begin() && upper != status.end();
}

// Takes out the edges that end at the point, from the lowest, `it`, upwards, and fills the
// intervals between them. Leaves `it` above them; the chain above the highest goes to upperChain if
// there is an interval above it. False if the point does not see what it should.
bool Sweep::closeIncoming(std::uint32_t point, ActiveEdges::iterator& it, Chain& upperChain,
                          bool& hasUpper) {
	while (it != status_.end() && it->edge.right == point) {
		upperChain = it->chain;
		it = status_.erase(it);
		hasUpper = it != status_.end();
		if (hasUpper && it->edge.right == point && !emitFan(point, upperChain)) {
			return false;
		}
	}
	return true;
}

bool Sweep::visit(std::uint32_t point) {
	Chain lower, upper;
	bool hasLower = false, hasUpper = false;
	ActiveEdges::iterator above = status_.end();
	if (anyIncoming_[point] != kNone) {
		above = status_.iterator_to(edges_[anyIncoming_[point]]);
		while (above != status_.begin() && std::prev(above)->edge.right == point) {
			--above;
		}
		hasLower = above != status_.begin();
		if (hasLower) {
			lower = std::prev(above)->chain;
		}
		if (!closeIncoming(point, above, upper, hasUpper)) {
			return false;
		}
	} else if (!status_.empty()) {
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
		status_.insert_before(above, edges_[e]);
	}
	return true;
}

std::uint32_t Sweep::newLink(std::uint32_t point, std::uint32_t below, std::uint32_t above) {
	links_.push_back({point, below, above});
	return static_cast<std::uint32_t>(links_.size() - 1);
}

// Cuts the chain at the link added last, which both parts keep; returns the upper part.
Chain Sweep::splitAtLast(Chain& chain) {
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
void Sweep::attachTop(Chain& chain, std::uint32_t point) {
	std::uint32_t top = chain.top;
	for (std::uint32_t next = links_[top].below; next != kNone; next = links_[top].below) {
		if (orientation_(pointOf(next), point, pointOf(top)) <= 0) {
			break;
		}
		triangles_.push_back({pointOf(next), point, pointOf(top)});
		top = next;
	}
	const std::uint32_t link = newLink(point, top, kNone);
	links_[top].above = link;
	chain.top = chain.last = link;
}

// The same below the chain's bottom.
void Sweep::attachBottom(Chain& chain, std::uint32_t point) {
	std::uint32_t bottom = chain.bottom;
	for (std::uint32_t next = links_[bottom].above; next != kNone; next = links_[bottom].above) {
		if (orientation_(pointOf(bottom), point, pointOf(next)) <= 0) {
			break;
		}
		triangles_.push_back({pointOf(bottom), point, pointOf(next)});
		bottom = next;
	}
	const std::uint32_t link = newLink(point, kNone, bottom);
	links_[bottom].below = link;
	chain.bottom = chain.last = link;
}

// Joins two chains, the lower of which ends with the point that the upper begins with.
Chain Sweep::join(const Chain& lower, const Chain& upper) {
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
bool Sweep::emitFan(std::uint32_t point, const Chain& chain) {
	for (std::uint32_t link = chain.bottom; links_[link].above != kNone;
	     link = links_[link].above) {
		const std::uint32_t next = pointOf(links_[link].above);
		if (orientation_(pointOf(link), point, next) <= 0) {
			return false;
		}
		triangles_.push_back({pointOf(link), point, next});
	}
	return true;
}

}  // namespace

bool triangulatePlanar(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges,
                       const PlanarOrientation& orientation,
                       std::vector<std::array<std::uint32_t, 3>>& triangles) {
	triangles.clear();
	return Sweep(pointCount, edges, orientation, triangles).run();
}

}  // namespace index_boolean
