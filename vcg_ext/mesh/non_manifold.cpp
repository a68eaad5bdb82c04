// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/non_manifold.h"

#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/index_table.h"

#include <algorithm>
#include <optional>

namespace index_boolean {

namespace {

// A face as one of its corners sees it: the directed edge opposite.
struct OppositeEdge {
	std::uint32_t from, to;
};

// The opposite edges at each vertex of a range, in one array.
struct Links {
	HugeVector<std::uint32_t> first;  // per vertex, and the end
	HugeVector<OppositeEdge> edges;
};

Links collectLinks(const Triangle* begin, const Triangle* end, VertexRange range) {
	const std::uint32_t count = range.end - range.begin;
	Links links;
	links.first.assign(count + std::size_t{1}, 0u);
	for (const Triangle* t = begin; t != end; ++t) {
		for (const VertexId v : *t) {
			if (v.value - range.begin < count) {  // false below the range: it wraps
				++links.first[v.value - range.begin];
			}
		}
	}
	std::uint32_t sum = 0;
	for (std::uint32_t& first : links.first) {
		sum += first;
		first = sum;  // the end; filling moves it to the beginning
	}
	links.edges.resizeForOverwrite(sum);
	for (const Triangle* t = begin; t != end; ++t) {
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t v = (*t)[i].value - range.begin;
			if (v < count) {
				links.edges[--links.first[v]] = {(*t)[i == 2 ? 0 : i + 1].value,
				                                 (*t)[i == 0 ? 2 : i - 1].value};
			}
		}
	}
	return links;
}

// Tells whether edges are one cycle without a vertex twice: whether following each by one that
// leaves its end comes back to the first after n steps and no sooner. An edge is followed by one
// only, so no other then leaves there.
class CycleCheck {
public:
	bool isOneCycle(const OppositeEdge* edges, std::size_t n) {
		return (n <= kFew && isShortCycle(edges, n)) || isAnyCycle(edges, n);
	}

private:
	static constexpr std::size_t kFew = 32;

	// Finds few edges by their first vertex in a table, which is not cleared between calls: what is
	// found there is looked at. \return false, too, if two vertices share a place in the table
	bool isShortCycle(const OppositeEdge* edges, std::size_t n) {
		for (std::size_t i = 0; i < n; ++i) {
			edgeFrom_[placeOf(edges[i].from)] = static_cast<std::uint8_t>(i);
		}
		std::size_t edge = 0, steps = 0;
		do {
			const std::uint32_t vertex = edges[edge].to;
			edge = edgeFrom_[placeOf(vertex)];
			if (edge >= n || edges[edge].from != vertex) {
				return false;
			}
			++steps;
		} while (edge != 0 && steps < n);
		return edge == 0 && steps == n;
	}

	bool isAnyCycle(const OppositeEdge* edges, std::size_t n) {
		const auto hashOf = [](std::uint32_t vertex) {
			const std::uint64_t hash = vertex * 0x9e3779b97f4a7c15U;
			return hash ^ hash >> 32;
		};
		const auto begins = [edges](std::uint32_t vertex) {
			return [edges, vertex](std::uint32_t i) { return edges[i].from == vertex; };
		};
		if (!table_) {
			table_.emplace();
		}
		table_->reset(n);
		for (std::uint32_t i = 0; i < n; ++i) {
			std::uint32_t& slot = table_->slotOf(hashOf(edges[i].from), begins(edges[i].from));
			if (slot != IndexTable::kNone) {
				return false;  // a vertex twice
			}
			slot = i;
		}
		std::uint32_t edge = 0;
		std::size_t steps = 0;
		do {
			const std::uint32_t vertex = edges[edge].to;
			edge = table_->find(hashOf(vertex), begins(vertex));
			++steps;
		} while (edge != 0 && edge != IndexTable::kNone && steps < n);
		return edge == 0 && steps == n;
	}

	static std::size_t placeOf(std::uint32_t vertex) { return vertex % kPlaces; }

	static constexpr std::size_t kPlaces = 1024;
	std::array<std::uint8_t, kPlaces> edgeFrom_{};
	std::optional<IndexTable> table_;  // of many edges, by their first vertices; if ever needed
};

}  // namespace

void findNonManifoldVertices(const Triangle* begin, const Triangle* end, VertexRange range,
                             std::vector<VertexId>& out) {
	const Links links = collectLinks(begin, end, range);
	CycleCheck check;
	for (std::uint32_t v = 0; v < range.end - range.begin; ++v) {
		const std::uint32_t first = links.first[v];
		const std::uint32_t count = links.first[v + 1] - first;
		if (count > 0 && !check.isOneCycle(&links.edges[first], count)) {
			out.push_back({range.begin + v});
		}
	}
}

bool isClosedManifold(const Triangle* begin, const Triangle* end, VertexRange range) {
	const Links links = collectLinks(begin, end, range);
	CycleCheck check;
	for (std::uint32_t v = 0; v < range.end - range.begin; ++v) {
		const std::uint32_t first = links.first[v];
		const std::uint32_t count = links.first[v + 1] - first;
		if (count > 0 && (count < 3 || !check.isOneCycle(&links.edges[first], count))) {
			return false;
		}
	}
	return true;
}

}  // namespace index_boolean
