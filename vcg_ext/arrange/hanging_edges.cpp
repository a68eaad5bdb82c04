// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two edges in one line overlap in an interval between ends of theirs: once each is parted at all
// ends on it, what is left of both there is the same.
#include "vcg_ext/arrange/hanging_edges.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"
#include "vcg_ext/exact/box_tree.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>

namespace index_boolean {

namespace {

bool overlap(const BoundingBox& a, const BoundingBox& b) {
	bool meet = true;
	for (std::size_t k = 0; k < 3; ++k) {
		meet = meet && a.lo[k] <= b.hi[k] && b.lo[k] <= a.hi[k];
	}
	return meet;
}

class EdgeParter {
public:
	EdgeParter(const Points& points, const std::vector<UnevenEdge>& edges) : points_(points) {
		for (const UnevenEdge& e : edges) {
			ends_.push_back(e.low);
			ends_.push_back(e.high);
		}
		sortUnique(ends_);
		std::vector<BoundingBox> places;
		for (const std::uint32_t v : ends_) {
			places.push_back({points[v], points[v]});
		}
		tree_ = BoxTree(std::move(places));
	}

	// Adds the parts of an edge.
	void part(const UnevenEdge& edge, std::vector<UnevenEdge>& out) const {
		const Point &a = points_[edge.low], &b = points_[edge.high];
		BoundingBox box{a, a};
		box.add(b);
		std::vector<std::uint32_t> along{edge.low, edge.high};
		tree_.visit(
		    0, [&box](const BoundingBox& other) { return overlap(box, other); },
		    [&](std::uint32_t i) {
			    const std::uint32_t v = ends_[i];
			    if (v != edge.low && v != edge.high && areCollinear(a, b, points_[v])) {
				    along.push_back(v);
			    }
		    });
		// In the box of the edge and on its line: lexicographic order is the order along it.
		std::sort(along.begin(), along.end(),
		          [this](std::uint32_t v, std::uint32_t w) { return points_[v] < points_[w]; });
		const bool runsUp = a < b;
		for (std::size_t i = 0; i + 1 < along.size(); ++i) {
			const std::uint32_t from = along[runsUp ? i : i + 1], to = along[runsUp ? i + 1 : i];
			out.push_back(makeEdgeItem(from, to, from < to ? edge.item : -edge.item));
		}
	}

private:
	static bool areCollinear(const Point& a, const Point& b, const Point& c) {
		return orient2d(a, b, c, 0) == 0 && orient2d(a, b, c, 1) == 0 && orient2d(a, b, c, 2) == 0;
	}

	const Points& points_;
	std::vector<std::uint32_t> ends_;
	BoxTree tree_;  // of the ends
};

}  // namespace

Status findWhetherEdgesCancel(const Points& points, const std::vector<UnevenEdge>& edges,
                              Monitor& monitor, bool& cancel) {
	constexpr std::size_t kGrain = 256;
	const EdgeParter parter(points, edges);
	std::vector<UnevenEdge> parts;
	const Status status =
	    inOrderFor(edges.size(), kGrain, monitor, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t i = begin; i < end; ++i) {
			    parter.part(edges[i], parts);
		    }
	    });
	std::sort(parts.begin(), parts.end());
	cancel = true;
	forEachSortedEdge(parts.begin(), parts.end(), [&cancel](auto first, auto last) {
		std::int64_t sum = 0;
		for (; first != last; ++first) {
			sum += first->item;
		}
		cancel = cancel && sum == 0;
	});
	return status;
}

}  // namespace index_boolean
