// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How two triangles meet, in rational arithmetic: what they have in common, as a convex polygon,
// against their common corners. Shares no code with the core.
#pragma once

// GCC 12 takes the inline storage of Boost's integers for uninitialized where it inlines them.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <vcg_ext/base/mesh_types.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <vector>

namespace index_boolean::oracle {

using Rational = boost::multiprecision::cpp_rational;
using ExactVector = std::array<Rational, 3>;
using ExactPolygon = std::vector<ExactVector>;

inline ExactVector minus(const ExactVector& a, const ExactVector& b) {
	return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline ExactVector cross(const ExactVector& a, const ExactVector& b) {
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Rational dot(const ExactVector& a, const ExactVector& b) {
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// What a convex polygon (with two corners a segment, with one a point) has in common with the
// half-space normal . (x - origin) >= 0.
inline ExactPolygon clipped(const ExactPolygon& polygon, const ExactVector& normal,
                            const ExactVector& origin) {
	ExactPolygon result;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		const ExactVector& p = polygon[i];
		const ExactVector& q = polygon[(i + 1) % polygon.size()];
		const Rational atP = dot(normal, minus(p, origin)), atQ = dot(normal, minus(q, origin));
		if (atP >= 0) {
			result.push_back(p);
		}
		if ((atP > 0 && atQ < 0) || (atP < 0 && atQ > 0)) {
			const Rational t = atP / (atP - atQ);
			const ExactVector d = minus(q, p);
			result.push_back({p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]});
		}
	}
	return result;
}

inline ExactPolygon exactTriangle(const Points& points, const IndexTriangle& corners) {
	ExactPolygon polygon;
	for (const std::uint32_t v : corners) {
		const Point& p = points[v];
		polygon.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2])});
	}
	return polygon;
}

// Whether the corners lie on one line.
inline bool isFlat(const ExactPolygon& t) {
	return cross(minus(t[1], t[0]), minus(t[2], t[0])) == ExactVector{0, 0, 0};
}

// What two triangles have in common. \pre t is not flat
inline ExactPolygon commonPart(const ExactPolygon& s, const ExactPolygon& t) {
	const ExactVector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
	const ExactVector opposite{-normal[0], -normal[1], -normal[2]};
	ExactPolygon part = clipped(clipped(s, normal, t[0]), opposite, t[0]);
	for (std::size_t i = 0; i < 3; ++i) {
		part = clipped(part, cross(normal, minus(t[(i + 1) % 3], t[i])), t[i]);
	}
	return part;
}

// Whether p lies in the hull of at most two points.
inline bool isWithin(const ExactVector& p, const ExactPolygon& hull) {
	if (hull.size() < 2) {
		return !hull.empty() && p == hull[0];
	}
	const ExactVector toA = minus(hull[0], p), toB = minus(hull[1], p);
	const ExactVector zero{0, 0, 0};
	return cross(toA, toB) == zero && dot(toA, toB) <= 0;
}

// Whether all corners of s but those in `common` lie strictly on one side of the plane of t. Then s
// has nothing in common with that plane but what lies between these corners.
inline bool isBeside(const ExactPolygon& s, const ExactPolygon& t, const ExactPolygon& common) {
	const ExactVector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
	int side = 0;
	for (const ExactVector& p : s) {
		if (std::find(common.begin(), common.end(), p) != common.end()) {
			continue;
		}
		const int sign = dot(normal, minus(p, t[0])).sign();
		if (sign == 0 || sign == -side) {
			return false;
		}
		side = sign;
	}
	return true;
}

// Whether two triangles that are not flat have more in common than corners or an edge of both.
inline bool meetWrongly(const ExactPolygon& s, const ExactPolygon& t) {
	ExactPolygon common;
	std::copy_if(s.begin(), s.end(), std::back_inserter(common), [&t](const ExactVector& corner) {
		return std::find(t.begin(), t.end(), corner) != t.end();
	});
	if (common.size() == 3) {
		return true;
	}
	if (isBeside(s, t, common) || isBeside(t, s, common)) {
		return false;
	}
	const ExactPolygon part = commonPart(s, t);
	return !std::all_of(part.begin(), part.end(),
	                    [&](const ExactVector& p) { return isWithin(p, common); });
}

}  // namespace index_boolean::oracle
