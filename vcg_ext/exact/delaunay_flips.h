// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a triangulation of points in a plane, some of its edges free; out: the same points and fixed
// edges with triangles as round as they can be: the constrained Delaunay triangulation.
// Guarantee: only signs are asked for. The exact orientations say which flips are *legal*, so what
// was a triangulation of the exact points stays one. Which flips are *wanted*, the in-circle sign
// of the places as stored says, since what is delivered are these. It ends, and depends on the
// geometry alone; in each region that the fixed edges part, on that region's alone.
// Source: Lawson 1977.
#pragma once

#include "vcg_ext/base/ids.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/exact/in_circle.h"
#include "vcg_ext/exact/planar_sweep.h"

#include <array>
#include <cstdint>
#include <vector>

namespace index_boolean {

using RankTriangles = std::vector<std::array<std::uint32_t, 3>>;

// An edge that two triangles have and that may be flipped.
struct FreeEdge {
	PlanarEdge ends;
	std::array<std::uint32_t, 2> triangles;
};

// Flips the edges of one triangulation after another, with reused buffers. One object for each
// thread.
class DelaunayFlips {
public:
	// Flips free edges until none wants to.
	// \param edges       the free ones, each once, in any order; those that remain, afterwards
	// \param places      of each point, by rank, as stored
	// \param front       +1 if the triangles are counter-clockwise by their exact orientations, -1
	//                    if clockwise
	// \param orientation the exact one of three points by rank
	// \param triangles   triples of ranks. Of two triangles that a flip replaces, the one whose
	//                    corner opposite the edge has the lower rank becomes the one at the edge's
	//                    lower end
	// \return how many flips there were; if the run is cancelled, it may not be done
	// Throws std::bad_alloc. Complexity: O(n) for n edges in most triangulations, O(n^2) at most.
	std::size_t run(std::vector<FreeEdge>& edges, const std::vector<PlanarPlace>& places, int front,
	                const PlanarOrientation& orientation, Monitor& monitor,
	                RankTriangles& triangles);

	// Whether the side from a triangle's corner on is a free edge of the last run. O(1).
	bool isFree(std::size_t triangle, std::size_t corner) const {
		return edgeOf_[triangle][corner] != kNone;
	}

private:
	// The four points around an edge from a to b, which its first triangle has that way, and that
	// triangle has the opposite corner of lower rank.
	struct Quad {
		std::uint32_t a, b, c, d;           // c: opposite, in the first triangle; d: in the second
		std::uint32_t first, second;        // triangles
		std::size_t firstSide, secondSide;  // the edge, by the corner where it begins
	};
	// Its sides, as edges; kNone if fixed.
	struct Sides {
		std::uint32_t bc, ca, ad, db;
	};

	void sort(std::vector<FreeEdge>& edges, std::size_t pointCount);
	void link(const std::vector<FreeEdge>& edges, std::size_t triangleCount);
	Quad quadOf(const FreeEdge& edge, std::uint32_t index) const;
	Sides sidesOf(const Quad& quad) const;
	bool isWanted(const Quad& quad) const;
	bool isLegal(const Quad& quad) const;
	void flip(const Quad& quad, const Sides& sides, std::uint32_t index);
	void moveSide(std::uint32_t side, std::uint32_t from, std::uint32_t to);
	void enqueue(const Sides& sides);

	// Of the run.
	std::vector<FreeEdge>* edges_ = nullptr;
	RankTriangles* triangles_ = nullptr;
	const std::vector<PlanarPlace>* places_ = nullptr;
	const PlanarOrientation* orientation_ = nullptr;
	int front_ = 1;

	std::vector<std::uint32_t> ends_;  // per point: where the edges with it as their left end end
	std::vector<FreeEdge> sorted_;
	std::vector<std::array<std::uint32_t, 3>> edgeOf_;  // per triangle: from its corner i on
	std::vector<std::uint32_t> queue_;                  // of edges; those before head_ are done
	std::vector<std::uint8_t> isQueued_;                // per edge
};

}  // namespace index_boolean
