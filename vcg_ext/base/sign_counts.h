// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many signs each number type decided, for those who tune the filters. Counted only where the
// core is built with the CMake option INDEXBOOLEAN_COUNT_SIGNS; elsewhere counting is nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace index_boolean {

enum class Predicate : std::uint8_t {
	PairSieve,      // whether a plane parts two faces whose boxes meet
	Orient3d,       // an input point against the plane of three
	Orient2d,       // three input points, projected
	CurveOrient2d,  // three points, some of the curve, projected
	CurveOrder,     // two points, some of the curve, along an axis
	Slopes,         // of two planes
	Rounding,       // the coordinates of a point of the curve
	AxisOrder,      // two components of a normal
	InCircle,       // four places, projected
	Distance,       // of two points, and a given one
};
constexpr std::size_t kPredicateCount = 10;

// Undecided: a filter that may pass its question on, and did.
enum class DecidedBy : std::uint8_t { Double, DoubleDouble, Integers, Undecided };
constexpr std::size_t kDeciderCount = 4;

// [predicate][decider]
using SignCounts = std::array<std::array<std::uint64_t, kDeciderCount>, kPredicateCount>;

// Counts one answer, in a build that counts. Complexity: O(1).
#ifdef INDEXBOOLEAN_COUNT_SIGNS
void countSign(Predicate predicate, DecidedBy decider);
#else
inline void countSign(Predicate, DecidedBy) {}
#endif

// What has been counted since the last call, by all threads; zeros in a build that does not count.
// Complexity: O(threads).
SignCounts takeSignCounts();

}  // namespace index_boolean
