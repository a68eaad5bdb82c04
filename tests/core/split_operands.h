// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For tests that split any number of operands: the run with all its meshes, and what of it must not
// depend on how the input is numbered.
#pragma once

#include "core/any_operands.h"

namespace index_boolean::shapes {

using Triangles3 = std::vector<Corners>;  // sorted

struct OperandsSplit {
	Status status;
	Arrangement arrangement;
	Split split;
	std::vector<SplitMesh> surfaces;  // per operand
	std::vector<SplitMesh> blocks;
	std::vector<SplitMesh> clips;  // as asked for
	SplitAudit audit;

	std::size_t surfaceCount(std::uint32_t operand) const {
		return split.surfaces.ofOperand[OperandId{operand}].size();
	}
	// Ascending.
	std::vector<double> volumes() const {
		std::vector<double> all;
		for (const SubBlock& block : split.blocks.all) {
			all.push_back(block.volume);
		}
		std::sort(all.begin(), all.end());
		return all;
	}
};

// \param clips the solids of these have to be some
inline OperandsSplit splitAll(const std::vector<Mesh>& operands,
                              const Options& options = onOneThread(),
                              const std::vector<Clip>& clips = {}) {
	OperandsSplit r;
	Monitor monitor;
	std::vector<SurfaceView> views;
	for (const Mesh& m : operands) {
		views.push_back(viewOf(m.points, m.triangles));
	}
	const auto again = [&](MeshArrays& out) { return joinSurfaces(views, 1, monitor, out); };
	MeshArrays arrays;
	r.status = inOrder([&] { return again(arrays); },
	                   [&] {
		                   return splitOperands(std::move(arrays), again, options, monitor,
		                                        r.arrangement, r.split);
	                   },
	                   [&] {
		                   std::vector<OperandId> solids;
		                   for (const Clip& clip : clips) {
			                   solids.push_back(clip.solid);
		                   }
		                   return requireSolids(solids, again, monitor, r.arrangement, r.split);
	                   });
	r.surfaces.resize(operands.size());
	for (std::size_t k = 0; k < operands.size() && r.status.ok(); ++k) {
		r.status = extractSubSurfaces(r.arrangement, r.split, makeId<OperandTag>(k), monitor,
		                              r.surfaces[k]);
	}
	for (std::uint32_t i = 0; i < r.split.blocks.all.size() && r.status.ok(); ++i) {
		r.blocks.emplace_back();
		r.status = extractSubBlock(r.arrangement, r.split, {i}, monitor, r.blocks.back());
	}
	for (const Clip& clip : clips) {
		r.clips.emplace_back();
		if (r.status.ok()) {
			r.status = extractClip(r.arrangement, r.split, clip, monitor, r.clips.back());
		}
	}
	if (r.status.ok()) {
		r.status = audit(r.arrangement, r.split, r.blocks, monitor, r.audit);
	}
	return r;
}

// The triangles of a mesh for which isChosen(face) is true, each from its smallest corner on.
template <class IsChosen>
Triangles3 placesOf(const SourcedMesh& mesh, IsChosen&& isChosen) {
	Triangles3 all;
	for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
		if (isChosen(f)) {
			const IndexTriangle& t = mesh.triangles[f];
			Corners c{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
			std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
			all.push_back(c);
		}
	}
	std::sort(all.begin(), all.end());
	return all;
}

inline Triangles3 placesOf(const SourcedMesh& mesh) {
	return placesOf(mesh, [](std::size_t) { return true; });
}

// Of a sub-surface, by its number among those of an operand.
inline Triangles3 placesOfSurface(const OperandsSplit& r, std::uint32_t operand,
                                  std::size_t number) {
	const SplitMesh& mesh = r.surfaces[operand];
	const SubSurfaceId id = r.split.surfaces.ofOperand[OperandId{operand}][number];
	return placesOf(mesh, [&](std::size_t f) { return mesh.subSurface[f] == id; });
}

inline double areaOf(const Triangles3& triangles) {
	double sum = 0;
	for (const Corners& c : triangles) {
		std::array<Point, 2> e{};
		for (std::size_t k = 0; k < 3; ++k) {
			e[0][k] = c[1][k] - c[0][k];
			e[1][k] = c[2][k] - c[0][k];
		}
		sum +=
		    std::hypot(e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2],
		               e[0][0] * e[1][1] - e[0][1] * e[1][0]) /
		    2;
	}
	return sum;
}

// A rectangle, its corners in order; its front is where they run counter-clockwise.
inline Mesh rectangle(const Point& a, const Point& b, const Point& c, const Point& d) {
	Mesh m;
	m.points = {a, b, c, d};
	m.triangles = {{0, 1, 2}, {0, 2, 3}};
	return m;
}

// The part of the plane z = height over [low, high] x [low, high].
inline Mesh level(double low, double high, double height) {
	return rectangle({low, low, height}, {high, low, height}, {high, high, height},
	                 {low, high, height});
}

}  // namespace index_boolean::shapes
