// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For tests of what is stored: pairs of meshes that rounding folds, and how much of a surface is
// wrong.
#pragma once

#include "core/shapes.h"

#include <vcg_ext/arrange/wrong_pairs.h>

#include <gtest/gtest.h>

#include <map>

namespace index_boolean::shapes {

inline Mesh turnedAboutX(Mesh m, double angle) {
	const double c = std::cos(angle), s = std::sin(angle);
	for (Point& p : m.points) {
		p = {p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]};
	}
	return m;
}

// Faults of a surface as delivered: pairs that meet wrongly and zero-area faces, once vertices in
// one place are one.
inline std::size_t faultsOf(const Points& points, const IndexTriangles& triangles) {
	std::map<Point, std::uint32_t> numbers;
	Points places;
	IndexTriangles stored;
	for (const IndexTriangle& t : triangles) {
		IndexTriangle welded;
		for (std::size_t i = 0; i < 3; ++i) {
			const auto next = static_cast<std::uint32_t>(places.size());
			const auto [it, isNew] = numbers.emplace(points[t[i]], next);
			if (isNew) {
				places.push_back(points[t[i]]);
			}
			welded[i] = it->second;
		}
		stored.push_back(welded);
	}
	Monitor monitor;
	WrongPairs wrong;
	const FacesView faces(places, stored.data(), stored.size());
	const Status status = findWrongPairs(faces, {}, monitor, wrong);
	EXPECT_TRUE(status.ok()) << describe(status);
	return wrong.pairs.size() + wrong.zeroAreaFaces.size();
}

}  // namespace index_boolean::shapes
