// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every delivered block promises of its faces as stored, for any coordinates: checked exactly,
// without code of the core.
#pragma once

#include <vcg_ext/solids/blocks.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace index_boolean {

// A finite double times 2^1100 is an integer.
inline boost::multiprecision::cpp_int scaledToInteger(double x) {
	int exponent = 0;
	const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
	const boost::multiprecision::cpp_int integer(static_cast<std::int64_t>(mantissa));
	const int shift = exponent - 53 + 1100;
	// Below 2^-1074 a double has no bits: what is shifted out is zero.
	return shift >= 0 ? boost::multiprecision::cpp_int(integer << shift)
	                  : boost::multiprecision::cpp_int(integer / (std::int64_t{1} << -shift));
}

// Whether three points lie on one line.
inline bool areCollinear(const Point& a, const Point& b, const Point& c) {
	for (std::size_t k = 0; k < 3; ++k) {
		const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
		const double left = (b[x] - a[x]) * (c[y] - a[y]), right = (b[y] - a[y]) * (c[x] - a[x]);
		// Four roundings of at most 2^-53 each; an overflow or underflow proves nothing.
		if (std::fabs(left - right) > 0x1p-49 * (std::fabs(left) + std::fabs(right)) + 1e-280) {
			return false;
		}
	}
	std::array<std::array<boost::multiprecision::cpp_int, 3>, 2> sides;
	for (std::size_t k = 0; k < 3; ++k) {
		sides[0][k] = scaledToInteger(b[k]) - scaledToInteger(a[k]);
		sides[1][k] = scaledToInteger(c[k]) - scaledToInteger(a[k]);
	}
	for (std::size_t k = 0; k < 3; ++k) {
		const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
		if (sides[0][x] * sides[1][y] != sides[0][y] * sides[1][x]) {
			return false;
		}
	}
	return true;
}

// The first broken promise: finite coordinates, closed by index, no face without area, no edge
// between coincident vertices, no vertex without face. Empty if all are kept.
inline std::string brokenPromise(const Block& block) {
	std::map<std::array<std::uint32_t, 2>, int> balance;
	std::vector<bool> used(block.points.size(), false);
	for (const auto& t : block.triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t u = t[i], v = t[(i + 1) % 3];
			if (u >= block.points.size()) {
				return "a corner that does not exist";
			}
			used[u] = true;
			balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
		}
	}
	for (const Point& p : block.points) {
		if (!std::all_of(p.begin(), p.end(), [](double c) { return std::isfinite(c); })) {
			return "a coordinate that is not finite";
		}
	}
	for (const auto& t : block.triangles) {
		const Point &a = block.points[t[0]], &b = block.points[t[1]], &c = block.points[t[2]];
		if (a == b || b == c || c == a) {
			return "an edge between coincident vertices";
		}
		if (areCollinear(a, b, c)) {
			return "a face of zero area";
		}
	}
	if (std::any_of(balance.begin(), balance.end(), [](const auto& e) { return e.second != 0; })) {
		return "not closed";
	}
	if (std::count(used.begin(), used.end(), false) != 0) {
		return "a vertex without face";
	}
	if (block.vertexSource.size() != block.points.size() ||
	    block.faceSource.size() != block.triangles.size()) {
		return "sources that are not parallel";
	}
	return {};
}

}  // namespace index_boolean
