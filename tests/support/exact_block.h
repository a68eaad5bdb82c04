// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a block's vertices say exactly: each is named by input simplices, whose meeting point is a
// fraction where the input's coordinates are small integers. Only names are taken from the core;
// the points are computed here.
#pragma once

#include "exact_sum.h"
#include "grid_mesh.h"

#include <vcg_ext/arrange/places.h>

#include <stdexcept>

namespace index_boolean::grid {

// (x / w, y / w, z / w), w > 0, without common divisor.
struct FractionPoint {
	IntPoint x{};
	std::int64_t w = 1;
};

inline FractionPoint reduced(const IntPoint& x, std::int64_t w) {
	const std::int64_t common = std::gcd(std::gcd(x[0], x[1]), std::gcd(x[2], w));
	const std::int64_t divisor = w < 0 ? -common : common;
	return {{x[0] / divisor, x[1] / divisor, x[2] / divisor}, w / divisor};
}

// p + (q - p) * numerator / denominator.
inline FractionPoint pointBetween(const IntPoint& p, const IntPoint& q, std::int64_t numerator,
                                  std::int64_t denominator) {
	IntPoint x{};
	for (std::size_t k = 0; k < 3; ++k) {
		x[k] = p[k] * denominator + (q[k] - p[k]) * numerator;
	}
	return reduced(x, denominator);
}

// A coordinate of an operand. \throw std::domain_error if it is not the integer it should be
inline IntPoint integers(const Point& p) {
	IntPoint x{};
	for (std::size_t k = 0; k < 3; ++k) {
		x[k] = static_cast<std::int64_t>(p[k]);
		if (static_cast<double>(x[k]) != p[k] || std::abs(x[k]) > 64) {
			throw std::domain_error("not a small integer");
		}
	}
	return x;
}

// The place of a vertex, from its name alone.
inline FractionPoint placeOf(const Arrangement& arrangement, VertexId vertex) {
	const ExactPoint name = exactPoint(arrangement, vertex);
	const auto by = [&name](std::size_t i) { return integers(*name.by[i]); };
	switch (name.form) {
	case ExactPoint::Form::Explicit:
		return {by(0), 1};
	case ExactPoint::Form::LinePlane: {
		const IntPoint n = normal(by(2), by(3), by(4));
		return pointBetween(by(0), by(1), dot(n, by(2) - by(0)), dot(n, by(1) - by(0)));
	}
	case ExactPoint::Form::LineLine: {
		const IntPoint along = by(1) - by(0), other = by(3) - by(2);
		return pointBetween(by(0), by(1), cross(by(2) - by(0), other)[name.axis],
		                    cross(along, other)[name.axis]);
	}
	case ExactPoint::Form::ThreePlanes:
		break;
	}
	throw std::domain_error("two operands alone have no point of three planes");
}

inline std::vector<FractionPoint> placesOf(const Arrangement& arrangement, const Block& block) {
	std::vector<FractionPoint> places;
	for (const VertexId v : block.vertexSource) {
		places.push_back(placeOf(arrangement, v));
	}
	return places;
}

// (b - a) x (c - a) times the three w.
inline IntPoint scaledNormal(const FractionPoint& a, const FractionPoint& b,
                             const FractionPoint& c) {
	const IntPoint bc = cross(b.x, c.x), ca = cross(c.x, a.x), ab = cross(a.x, b.x);
	IntPoint n{};
	for (std::size_t k = 0; k < 3; ++k) {
		n[k] = a.w * bc[k] + b.w * ca[k] + c.w * ab[k];
	}
	return n;
}

// Exact measures of a block as its vertices' names tell them.
struct ExactMeasure {
	Rational sixVolume;
	Rational doubleProjections;  // of all faces, each to the three coordinate planes
};

// \param block each of its points has a vertexSource that is not none(). Coordinates of the
//              operands are integers up to 8; larger ones overflow.
inline ExactMeasure exactMeasure(const Arrangement& arrangement, const Block& block) {
	const std::vector<FractionPoint> places = placesOf(arrangement, block);
	ExactSum volume, projections;
	for (const auto& t : block.triangles) {
		const FractionPoint &a = places[t[0]], &b = places[t[1]], &c = places[t[2]];
		const std::int64_t w = a.w * b.w * c.w;
		const IntPoint n = scaledNormal(a, b, c);
		volume.add(dot(a.x, cross(b.x, c.x)), w);
		for (const std::int64_t projection : n) {
			projections.add(std::abs(projection), w);
		}
	}
	return {volume.value(), projections.value()};
}

// Whether every face has area, exactly, and lies in the plane of the input face it is said to come
// from, turned as it is said to be.
inline bool facesLieInTheirSources(const Arrangement& arrangement, const Block& block) {
	const std::vector<FractionPoint> places = placesOf(arrangement, block);
	for (std::size_t f = 0; f < block.triangles.size(); ++f) {
		const FaceSource source = block.faceSource[f];
		std::array<IntPoint, 3> from;
		for (std::size_t i = 0; i < 3; ++i) {
			from[i] = integers(
			    at(arrangement.mesh.points, at(arrangement.mesh.triangles, source.face)[i]));
		}
		const IntPoint n = normal(from[0], from[1], from[2]);
		const auto& t = block.triangles[f];
		for (const std::uint32_t v : t) {
			if (dot(n, places[v].x) != dot(n, from[0]) * places[v].w) {
				return false;
			}
		}
		const std::int64_t along = dot(n, scaledNormal(places[t[0]], places[t[1]], places[t[2]]));
		if (source.turned ? along >= 0 : along <= 0) {
			return false;
		}
	}
	return true;
}

}  // namespace index_boolean::grid
