// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads numbers, options and meshes from any bytes; when there are none left, zeros.
#pragma once

#include "core/shapes.h"

#include <cstring>
#include <limits>

namespace index_boolean::fuzz {

class ByteReader {
public:
	ByteReader(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), end_(bytes + size) {}

	std::uint8_t byte() { return bytes_ == end_ ? std::uint8_t{0} : *bytes_++; }
	std::uint32_t below(std::uint32_t n) { return byte() % n; }
	bool flag() { return (byte() & 1U) != 0; }

	template <class Number>
	Number raw() {
		std::array<std::uint8_t, sizeof(Number)> all{};
		for (std::uint8_t& one : all) {
			one = byte();
		}
		Number number;
		std::memcpy(&number, all.data(), sizeof number);
		return number;
	}

	const std::uint8_t* rest() const { return bytes_; }
	std::size_t restSize() const { return static_cast<std::size_t>(end_ - bytes_); }

private:
	const std::uint8_t* bytes_;
	const std::uint8_t* end_;
};

// Any bits at all, or numbers that make trouble, or, so that they coincide, small integers, some of
// them a few units in the last place off.
inline double coordinate(ByteReader& in) {
	using Limits = std::numeric_limits<double>;
	constexpr std::array<double, 16> kSpecial{-0.0,
	                                          Limits::quiet_NaN(),
	                                          Limits::infinity(),
	                                          -Limits::infinity(),
	                                          Limits::max(),
	                                          -Limits::max(),
	                                          Limits::denorm_min(),
	                                          -Limits::denorm_min(),
	                                          Limits::min(),
	                                          1e30,
	                                          -1e30,
	                                          1e-30,
	                                          1e300,
	                                          1e-300,
	                                          0.1,
	                                          1e6};
	const std::uint32_t kind = in.byte();
	double value = kind % 9;
	if (kind >= 0xf8) {
		return in.raw<double>();
	}
	if (kind >= 0xf0) {
		return kSpecial[in.below(kSpecial.size())];
	}
	if (kind >= 0xd0) {
		const std::uint32_t steps = in.below(8);
		for (std::uint32_t i = 0; i < steps / 2 + 1; ++i) {
			value = std::nextafter(value, steps % 2 == 0 ? 100 : -100);
		}
	}
	return value;
}

// A vertex among `count`, or seldom one that does not exist.
inline std::uint32_t vertexIndex(ByteReader& in, std::size_t count) {
	const std::uint32_t kind = in.byte();
	return kind == 0xff || count == 0 ? in.raw<std::uint32_t>()
	                                  : kind % static_cast<std::uint32_t>(count);
}

// Any options, sensible or not.
inline Options options(ByteReader& in) {
	constexpr std::array<int, 8> kDepths{12, 1, 2, 20, 0, -1, 21, std::numeric_limits<int>::max()};
	constexpr std::array<int, 8> kLeafSizes{0,
	                                        1,
	                                        2,
	                                        1000,
	                                        -1,
	                                        100000,
	                                        std::numeric_limits<int>::min(),
	                                        std::numeric_limits<int>::max()};
	constexpr std::array<int, 8> kThreads{1, 1, 1, 1, 0, 2, 8, -1};
	constexpr std::array<double, 8> kWeldDistances{0, 0, 0, 0, 1e-15, 1e-9, 0.25, 1.5};
	Options o;
	o.octreeMaxDepth = kDepths[in.below(kDepths.size())];
	o.octreeLeafSize = kLeafSizes[in.below(kLeafSizes.size())];
	o.threads = kThreads[in.below(kThreads.size())];
	const std::uint32_t switches = in.byte();
	o.outputScalar = (switches & 1U) != 0 ? OutputScalar::Float : OutputScalar::Double;
	o.mergeFragments = (switches & 2U) == 0;
	o.mergeCoplanar = (switches & 4U) != 0;
	o.weldNonManifold = (switches & 8U) != 0;
	o.selfIntersections =
	    (switches & 16U) != 0 ? SelfIntersections::Refuse : SelfIntersections::Trust;
	o.weldDistance = kWeldDistances[switches >> 5U];
	return o;
}

// A cone over all unmatched sides: with it, any faces are a closed surface.
inline void closeByCone(shapes::Mesh& m, std::uint32_t apex) {
	std::map<std::array<std::uint32_t, 2>, int> balance;
	for (const auto& t : m.triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			++balance[{t[i], t[(i + 1) % 3]}];
			--balance[{t[(i + 1) % 3], t[i]}];
		}
	}
	for (const auto& [side, count] : balance) {
		for (int i = 0; i < count; ++i) {
			m.triangles.push_back({side[1], side[0], apex});
		}
	}
}

inline bool cornersExist(const shapes::Mesh& m) {
	return std::all_of(m.triangles.begin(), m.triangles.end(), [&m](const auto& t) {
		return std::all_of(t.begin(), t.end(),
		                   [&m](std::uint32_t v) { return v < m.points.size(); });
	});
}

enum class Base : std::uint8_t { None, Box, Tetrahedron, Soup };

// Points and faces from the bytes, beside or instead of a box or a tetrahedron. Most meshes are
// closed by a cone: few others get past the first checks.
inline shapes::Mesh mesh(ByteReader& in) {
	shapes::Mesh m;
	const auto base = static_cast<Base>(in.below(4));
	const bool close = in.below(8) != 7;
	if (base == Base::Box) {
		const Point low{coordinate(in), coordinate(in), coordinate(in)};
		m = shapes::box(low, {coordinate(in), coordinate(in), coordinate(in)});
	}
	const std::uint32_t points = (base == Base::Tetrahedron ? 4 : 0) + in.below(16);
	for (std::uint32_t i = 0; i < points; ++i) {
		m.points.push_back({coordinate(in), coordinate(in), coordinate(in)});
	}
	if (base == Base::Tetrahedron) {
		m.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
	}
	const std::uint32_t faces = in.below(24);
	for (std::uint32_t i = 0; i < faces; ++i) {
		std::array<std::uint32_t, 3> t{};
		for (std::uint32_t& v : t) {
			v = vertexIndex(in, m.points.size());
		}
		m.triangles.push_back(t);
	}
	if (close) {
		closeByCone(m, vertexIndex(in, m.points.size()));
	}
	return base == Base::Soup && cornersExist(m) ? shapes::soup(m) : m;
}

}  // namespace index_boolean::fuzz
