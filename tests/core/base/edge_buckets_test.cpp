// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sides of edges by buckets are those of a sorted list.
#include <vcg_ext/base/edge_buckets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <tuple>

using namespace index_boolean;

namespace {

// Vertices, face, corner and direction of a side.
using Side = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, int, bool>;
using Faces = std::vector<std::array<std::uint32_t, 3>>;

Faces randomFaces(std::size_t count, std::uint32_t vertices, std::mt19937& random) {
	std::uniform_int_distribution<std::uint32_t> vertex(0, vertices - 1);
	Faces faces;
	while (faces.size() < count) {
		const std::array<std::uint32_t, 3> t{vertex(random), vertex(random), vertex(random)};
		if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
			faces.push_back(t);
		}
	}
	return faces;
}

// Visits all sides but the first of every third face.
template <class Visit>
void visitSides(const Faces& faces, std::size_t f, Visit&& visit) {
	for (std::size_t i = f % 3 == 0 ? 1 : 0; i < 3; ++i) {
		visit(makeHalfEdge(faces[f][i], faces[f][(i + 1) % 3], f, i));
	}
}

// The end of a face's side that is not the given one.
std::uint32_t lowOf(const std::array<std::uint32_t, 3>& face, std::size_t corner,
                    std::uint32_t high) {
	const std::uint32_t from = face[corner], to = face[(corner + 1) % 3];
	return from == high ? to : from;
}

// The sides of each edge, edge by edge, by a sort.
std::vector<std::vector<Side>> sortedEdges(const Faces& faces) {
	std::vector<HalfEdge> sides;
	for (std::size_t f = 0; f < faces.size(); ++f) {
		visitSides(faces, f, [&](const HalfEdge& side) { sides.push_back(side); });
	}
	std::vector<std::vector<Side>> edges;
	forEachEdge(sides, [&](auto first, auto last) {
		edges.emplace_back();
		for (auto s = first; s != last; ++s) {
			edges.back().emplace_back(s->low, s->high, s->face, s->corner, s->forward);
		}
	});
	return edges;
}

}  // namespace

// Few vertices give edges of many faces, many give edges of one.
TEST(EdgeBuckets, visitsTheEdgesOfASortedListOnAnyThreads) {
	std::mt19937 random(20260131);
	for (const std::uint32_t vertices : {4U, 90U, 9000U, 200000U}) {
		const Faces faces = randomFaces(30000, vertices, random);
		const std::vector<std::vector<Side>> expected = sortedEdges(faces);
		for (const int threads : {1, 3}) {
			Monitor unheard;
			EdgeBuckets edges;
			const auto visitThose = [&](std::size_t f, auto&& visit) {
				visitSides(faces, f, visit);
			};
			ASSERT_TRUE(edges.list(faces.size(), vertices, visitThose, unheard).ok());
			std::vector<std::vector<std::vector<Side>>> chunks(edges.chunks());
			const auto keep = [&](std::size_t chunk, EdgeSide* first, EdgeSide* last) {
				std::vector<Side> found;
				for (const EdgeSide* s = first; s != last; ++s) {
					const std::uint32_t high = s->high;
					const std::uint32_t low = lowOf(faces[s->face], s->corner, high);
					found.emplace_back(low, high, s->face, s->corner, s->forward);
				}
				chunks[chunk].push_back(found);
				first->mark = true;
			};
			ASSERT_TRUE(edges.forEachEdge(threads, unheard, keep).ok());
			std::vector<std::vector<Side>> found;
			for (const auto& chunk : chunks) {
				found.insert(found.end(), chunk.begin(), chunk.end());
			}
			EXPECT_TRUE(found == expected) << vertices << " vertices, " << threads << " threads";
			const auto marked = std::count_if(edges.sides().begin(), edges.sides().end(),
			                                  [](const EdgeSide& side) { return side.mark; });
			EXPECT_EQ(static_cast<std::size_t>(marked), expected.size());
		}
	}
}

TEST(EdgeBuckets, aMeshWithoutSidesHasNoEdges) {
	Monitor unheard;
	EdgeBuckets edges;
	ASSERT_TRUE(edges
	                .list(
	                    5, 7, [](std::size_t, auto&&) {}, unheard)
	                .ok());
	EXPECT_TRUE(edges.sides().empty());
	EXPECT_TRUE(
	    edges.forEachEdge(1, unheard, [](std::size_t, EdgeSide*, EdgeSide*) { ADD_FAILURE(); })
	        .ok());
}
