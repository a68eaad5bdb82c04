// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a failing pair of solids small, as long as it fails.
#pragma once

#include "grid_polyhedra.h"

#include <functional>

namespace index_boolean::grid {

// Vertex u moved into v: faces with both go, opposite faces cancel.
inline GridMesh collapsed(const GridMesh& m, std::uint32_t u, std::uint32_t v) {
	std::map<Corners, int> balance;  // of faces, by their corners from the smallest on
	for (Corners t : m.triangles) {
		std::replace(t.begin(), t.end(), u, v);
		if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
			continue;
		}
		std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
		const Corners opposite{t[0], t[2], t[1]};
		if (balance[opposite] > 0) {
			--balance[opposite];
		} else {
			++balance[t];
		}
	}
	GridMesh smaller{m.points, {}};
	for (const auto& [t, count] : balance) {
		smaller.triangles.insert(smaller.triangles.end(), static_cast<std::size_t>(count), t);
	}
	return withoutLooseVertices(smaller);
}

// Replaces the mesh by a smaller one that is a solid and that `fails` accepts; false if none is.
inline bool shrinkOnce(GridMesh& m, const std::function<bool(const GridMesh&)>& fails) {
	const auto count = static_cast<std::uint32_t>(m.points.size());
	for (std::uint32_t u = 0; u < count; ++u) {
		for (std::uint32_t v = 0; v < count; ++v) {
			const GridMesh smaller = u == v ? m : collapsed(m, u, v);
			if (smaller.triangles.size() < m.triangles.size() && isSolid(smaller) &&
			    fails(smaller)) {
				m = smaller;
				return true;
			}
		}
	}
	return false;
}

// All coordinates above a number along one axis less by one, in both.
inline bool squeezeOnce(SolidPair& pair, const std::function<bool(const SolidPair&)>& fails) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		for (std::int64_t above = -1; above < kMostCoordinate; ++above) {
			SolidPair smaller = pair;
			bool any = false;
			for (GridMesh* m : {&smaller.a, &smaller.b}) {
				for (IntPoint& p : m->points) {
					any = any || p[axis] > above;
					p[axis] -= p[axis] > above ? 1 : 0;
				}
			}
			if (any && isWithin(smaller.a, kMostCoordinate) &&
			    isWithin(smaller.b, kMostCoordinate) && isSolid(smaller.a) && isSolid(smaller.b) &&
			    fails(smaller)) {
				pair = smaller;
				return true;
			}
		}
	}
	return false;
}

// \pre fails(pair)
inline SolidPair shrunk(SolidPair pair, const std::function<bool(const SolidPair&)>& fails) {
	const auto failsWithA = [&](const GridMesh& m) { return fails({m, pair.b}); };
	const auto failsWithB = [&](const GridMesh& m) { return fails({pair.a, m}); };
	while (shrinkOnce(pair.a, failsWithA) || shrinkOnce(pair.b, failsWithB) ||
	       squeezeOnce(pair, fails)) {
	}
	return pair;
}

}  // namespace index_boolean::grid
