// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "non_manifold.h"

#include <algorithm>

namespace index_boolean {

namespace {

// A face as one of its corners sees it: the directed edge opposite.
struct OppositeEdge {
	std::uint32_t from, to;
};

// The opposite edges at each vertex, in one array.
struct Links {
	std::vector<std::uint32_t> first;  // per vertex, and the end
	std::vector<OppositeEdge> edges;
};

Links collectLinks(const Triangle* begin, const Triangle* end, std::size_t vertexCount) {
	Links links;
	links.first.assign(vertexCount + 1, 0);
	for (const Triangle* t = begin; t != end; ++t) {
		for (const VertexId v : *t) {
			++links.first[v.value];
		}
	}
	std::uint32_t sum = 0;
	for (std::uint32_t& first : links.first) {
		sum += first;
		first = sum;  // the end; filling moves it to the beginning
	}
	links.edges.resize(sum);
	for (const Triangle* t = begin; t != end; ++t) {
		const auto [a, b, c] = *t;
		links.edges[--links.first[a.value]] = {b.value, c.value};
		links.edges[--links.first[b.value]] = {c.value, a.value};
		links.edges[--links.first[c.value]] = {a.value, b.value};
	}
	return links;
}

// Whether n edges, each vertex entered as often as left, are one cycle without a vertex twice.
bool isOneCycle(OppositeEdge* edges, std::size_t n) {
	// Ordinary vertices have few faces: no sorting for them.
	constexpr std::size_t kFew = 24;
	if (n > kFew) {
		std::sort(edges, edges + n,
		          [](const OppositeEdge& a, const OppositeEdge& b) { return a.from < b.from; });
	}
	const auto next = [=](std::uint32_t from) {
		if (n > kFew) {
			return std::lower_bound(
			    edges, edges + n, from,
			    [](const OppositeEdge& e, std::uint32_t vertex) { return e.from < vertex; });
		}
		return std::find_if(edges, edges + n,
		                    [from](const OppositeEdge& e) { return e.from == from; });
	};
	// The first edge that leaves each vertex is a function; it comes back to its start after n
	// steps iff all edges are on one cycle and no vertex has a second one.
	const OppositeEdge* edge = edges;
	const std::uint32_t start = next(edge->from)->from;
	std::size_t steps = 0;
	std::uint32_t at = start;
	do {
		at = next(at)->to;
		++steps;
	} while (at != start && steps <= n);
	return at == start && steps == n;
}

}  // namespace

void findNonManifoldVertices(const Triangle* begin, const Triangle* end, std::size_t vertexCount,
                             std::vector<VertexId>& out) {
	Links links = collectLinks(begin, end, vertexCount);
	for (std::uint32_t v = 0; v < vertexCount; ++v) {
		const std::uint32_t first = links.first[v];
		const std::uint32_t count = links.first[v + 1] - first;
		if (count > 0 && !isOneCycle(&links.edges[first], count)) {
			out.push_back({v});
		}
	}
}

}  // namespace index_boolean
