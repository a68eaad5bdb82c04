// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces at a feature are found by its place. Their shares are summed up in an order of their
// own, so that the sum is the same whatever the numbering.
#include "vcg_ext/distance/pseudonormals.h"

#include "vcg_ext/distance/unit_normal.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

// A face's normal, as it faces. The corners are taken in lexicographic order, so that it is the
// same bits for each order of them.
Point normalOf(const SearchedFaces& faces, std::uint32_t face) {
	IndexTriangle t = faces.triangles[face];
	bool isOdd = false;
	const auto sortTwo = [&](std::size_t i, std::size_t j) {
		if (faces.points[t[j]] < faces.points[t[i]]) {
			std::swap(t[i], t[j]);
			isOdd = !isOdd;
		}
	};
	sortTwo(0, 1);
	sortTwo(1, 2);
	sortTwo(0, 1);
	const Point normal = unitNormal(faces.points[t[0]], faces.points[t[1]], faces.points[t[2]]);
	return isOdd ? times(normal, -1) : normal;
}

bool has(const IndexTriangle& t, std::uint32_t vertex) {
	return t[0] == vertex || t[1] == vertex || t[2] == vertex;
}

// The angle of a face at its corner k.
double angleAt(const SearchedFaces& faces, const IndexTriangle& t, std::size_t k) {
	const double scale = faces.tree.frame().scale;
	const auto direction = [&](std::size_t other) {
		return unitVector(
		    minus(times(faces.points[t[other]], scale), times(faces.points[t[k]], scale)));
	};
	const Point a = direction((k + 1) % 3), b = direction((k + 2) % 3);
	const Point across = cross(a, b);
	return std::atan2(std::sqrt(dot(across, across)), dot(a, b));
}

}  // namespace

Point pseudonormal(const SearchedFaces& faces, std::uint32_t face, const FeatureVertices& feature) {
	if (feature.count == 3) {
		return normalOf(faces, face);
	}
	const TreeFrame& frame = faces.tree.frame();
	const Point place = minus(frame.scaled(faces.points[feature.vertex[0]]), frame.centre);
	std::vector<Point> shares;
	const auto holds = [&](auto&& lo, auto&& hi) {
		return place[0] >= lo(0) && place[0] <= hi(0) && place[1] >= lo(1) && place[1] <= hi(1) &&
		       place[2] >= lo(2) && place[2] <= hi(2);
	};
	faces.tree.visit(holds, [&](std::uint32_t other) {
		const IndexTriangle& t = faces.triangles[other];
		if (!has(t, feature.vertex[0]) || (feature.count == 2 && !has(t, feature.vertex[1]))) {
			return;
		}
		const auto corner =
		    static_cast<std::size_t>(std::find(t.begin(), t.end(), feature.vertex[0]) - t.begin());
		const double weight = feature.count == 2 ? 1 : angleAt(faces, t, corner);
		shares.push_back(times(normalOf(faces, other), weight));
	});
	std::sort(shares.begin(), shares.end());
	Point sum{0, 0, 0};
	for (const Point& share : shares) {
		sum = {sum[0] + share[0], sum[1] + share[1], sum[2] + share[2]};
	}
	const Point normal = unitVector(sum);
	return dot(normal, normal) > 0 ? normal : normalOf(faces, face);
}

}  // namespace index_boolean
