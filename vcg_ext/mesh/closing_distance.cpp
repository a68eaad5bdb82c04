// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Moving vertices changes nothing at edges with an even number of faces: what is odd there comes
// from the border alone. So distances are tried on the border's vertices, which are few, and only
// one that closes these is tried on all.
#include "vcg_ext/mesh/closing_distance.h"

#include "vcg_ext/base/groups.h"
#include "vcg_ext/exact/bounding_box.h"
#include "vcg_ext/exact/point_groups.h"
#include "vcg_ext/mesh/vertex_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

namespace index_boolean {

namespace {

using Edge = std::array<std::uint32_t, 2>;  // ascending

Edge makeEdge(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// Keeps those that are there an odd number of times, once.
void keepOddEdges(std::vector<Edge>& edges) {
	std::sort(edges.begin(), edges.end());
	std::vector<Edge> odd;
	forEachGroup(edges.begin(), edges.end(), std::equal_to<>(), [&odd](auto first, auto last) {
		if ((last - first) % 2 == 1) {
			odd.push_back(*first);
		}
	});
	edges = std::move(odd);
}

// Places, each once, and the border edges between them.
struct BorderPlaces {
	Points points;
	std::vector<Edge> edges;
};

// All places of an operand that faces use.
BorderPlaces placesOf(const MeshArrays& mesh, OperandId operand) {
	const std::uint32_t first = mesh.vertexOffsets.begin(operand);
	VertexTable table(mesh.points, mesh.vertexOffsets.size(operand));
	std::vector<std::uint32_t> number(mesh.vertexOffsets.size(operand), kNone);
	BorderPlaces out;
	const auto numberOf = [&](VertexId v) {
		const std::uint32_t place = table.findOrAdd(v.value);
		std::uint32_t& known = number[place - first];
		if (known == kNone) {
			known = static_cast<std::uint32_t>(out.points.size());
			out.points.push_back(mesh.points[place]);
		}
		return known;
	};
	for (std::uint32_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand);
	     ++f) {
		const Triangle& t = mesh.triangles[f];
		const IndexTriangle n{numberOf(t[0]), numberOf(t[1]), numberOf(t[2])};
		for (std::size_t i = 0; i < 3; ++i) {
			if (n[i] != n[(i + 1) % 3]) {
				out.edges.push_back(makeEdge(n[i], n[(i + 1) % 3]));
			}
		}
	}
	keepOddEdges(out.edges);
	return out;
}

// Those at border edges alone.
BorderPlaces borderOf(const BorderPlaces& all) {
	std::vector<std::uint32_t> number(all.points.size(), kNone);
	BorderPlaces out;
	for (const Edge& edge : all.edges) {
		for (const std::uint32_t end : edge) {
			if (number[end] == kNone) {
				number[end] = static_cast<std::uint32_t>(out.points.size());
				out.points.push_back(all.points[end]);
			}
		}
		out.edges.push_back(makeEdge(number[edge[0]], number[edge[1]]));
	}
	return out;
}

// Whether the border vanishes by pairs of its edges; not where an edge of it falls into one place,
// as those of a small hole do.
Status vanishes(const BorderPlaces& border, double distance, Monitor& monitor, bool& out) {
	std::vector<std::uint32_t> smallest, wide;
	const Status status =
	    inOrder([&] { return groupPoints(border.points, distance, monitor, smallest); },
	            [&] { return findWideGroups(border.points, smallest, distance, monitor, wide); });
	out = status.ok() && wide.empty();
	if (!out) {
		return status;
	}
	std::vector<Edge> edges;
	for (const Edge& edge : border.edges) {
		edges.push_back(makeEdge(smallest[edge[0]], smallest[edge[1]]));
	}
	const bool anyFalls = std::any_of(edges.begin(), edges.end(),
	                                  [](const Edge& edge) { return edge[0] == edge[1]; });
	keepOddEdges(edges);
	out = edges.empty() && !anyFalls;
	return status;
}

// A digit times a power of ten, as a user types it: 2e-07.
double roundNumber(int digit, int exponent) {
	return std::strtod((std::to_string(digit) + "e" + std::to_string(exponent)).c_str(), nullptr);
}

// What may be tried: powers of ten from the step of the coordinates on, and how large it may be.
struct Ladder {
	int lowest, highest;  // exponents of ten
	double most;
};

Ladder ladderOf(const Points& points) {
	BoundingBox box = emptyBox();
	double size = 0;
	for (const Point& p : points) {
		box.add(p);
		size = std::max({size, std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
	}
	constexpr double kStep = 0x1p-53, kMostOfDiagonal = 0.01;
	const double diagonal =
	    std::hypot(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]);
	const double most = std::min(diagonal * kMostOfDiagonal, 1e300);
	const double least = std::max(size * kStep, 1e-300);
	const auto exponentOf = [](double x) { return static_cast<int>(std::floor(std::log10(x))); };
	return {exponentOf(least), most > 0 ? exponentOf(most) : exponentOf(least) - 1, most};
}

}  // namespace

Status findClosingDistance(const MeshArrays& mesh, OperandId operand, Monitor& monitor,
                           double& distance) {
	distance = 0;
	const BorderPlaces all = placesOf(mesh, operand);
	const BorderPlaces border = borderOf(all);
	if (border.edges.empty()) {
		return {};
	}
	const Ladder ladder = ladderOf(all.points);
	const auto closes = [&](double d, bool& does) {
		does = false;
		Status status;
		if (d <= ladder.most) {
			status = vanishes(border, d, monitor, does);
		}
		return status.ok() && does ? vanishes(all, d, monitor, does) : status;
	};
	for (int exponent = ladder.lowest; exponent <= ladder.highest + 1; ++exponent) {
		bool does = false;
		for (const double d :
		     {roundNumber(1, exponent), roundNumber(2, exponent), roundNumber(5, exponent)}) {
			const Status status = closes(d, does);
			if (!status.ok() || does) {
				distance = does ? d : 0;
				return status;
			}
		}
	}
	return {};
}

}  // namespace index_boolean
