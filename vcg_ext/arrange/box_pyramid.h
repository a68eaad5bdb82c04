// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces in an order; out: boxes of eight faces, of eight such boxes, and so on up to one.
// Guarantee: faces that meet have boxes that meet, at all levels.
#pragma once

#include "vcg_ext/arrange/face_order.h"

#include <array>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace index_boolean {

// Eight boxes side by side: [axis][lane]. Lanes without a box have one that meets nothing.
struct EightBoxes {
	std::array<std::array<float, 8>, 3> lo, hi;
};

// Sets of the eight lanes, as bits.
using Lanes = unsigned;

// The set of lanes of which all bits are set, not none. What makes such masks are loops that
// compilers turn into vectors. Complexity: O(1).
inline Lanes lanesOfMasks(const std::array<std::uint32_t, 8>& masks) {
	Lanes lanes = 0;
	for (unsigned i = 0; i < 8; ++i) {
		lanes |= masks[i] & 1U << i;
	}
	return lanes;
}

// The same, by the one instruction for it, where each processor has it, that no loop becomes.
// Complexity: O(1).
#if defined(__SSE2__)
inline Lanes lanesOf(const std::array<std::uint32_t, 8>& masks) {
	const auto lanesOfFour = [&masks](std::size_t first) {
		const void* const four = &masks[first];
		return static_cast<Lanes>(
		    _mm_movemask_ps(_mm_castsi128_ps(_mm_loadu_si128(static_cast<const __m128i*>(four)))));
	};
	return lanesOfFour(0) | lanesOfFour(4) << 4U;
}
#else
inline Lanes lanesOf(const std::array<std::uint32_t, 8>& masks) { return lanesOfMasks(masks); }
#endif

// All bits or none. Complexity: O(1).
inline std::uint32_t maskOf(bool isSet) { return isSet ? ~0U : 0U; }

// Which of eight boxes meet box `lane` of others. Complexity: O(1).
inline Lanes lanesThatMeet(const EightBoxes& boxes, const EightBoxes& others, std::size_t lane) {
	const float lo0 = others.lo[0][lane], lo1 = others.lo[1][lane], lo2 = others.lo[2][lane];
	const float hi0 = others.hi[0][lane], hi1 = others.hi[1][lane], hi2 = others.hi[2][lane];
	std::array<std::uint32_t, 8> masks;
	for (unsigned i = 0; i < 8; ++i) {
		masks[i] = maskOf(boxes.lo[0][i] <= hi0) & maskOf(lo0 <= boxes.hi[0][i]) &
		           maskOf(boxes.lo[1][i] <= hi1) & maskOf(lo1 <= boxes.hi[1][i]) &
		           maskOf(boxes.lo[2][i] <= hi2) & maskOf(lo2 <= boxes.hi[2][i]);
	}
	return lanesOf(masks);
}

// Eight faces. Corners have equal stars only if no two faces there meet but in the corner or in an
// edge at it; kNone is the star of a corner of which that is not known.
struct FaceLeaf {
	EightBoxes boxes;
	std::array<std::array<std::uint32_t, 8>, 3> stars;
	std::array<std::uint32_t, 8> faces;
};

// levels[0] has the boxes of eight leaves each, levels[k + 1] those of eight items of levels[k];
// the last one has one item. A lane's child is item 8 * item + lane of the level below.
struct BoxPyramid {
	HugeVector<FaceLeaf> leaves;
	std::vector<HugeVector<EightBoxes>> levels;
};

// Builds a pyramid.
// \param surface its stars are final; zero-area faces get a box that meets nothing
// \param out     replaced
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n), in parallel; some 50 bytes a face.
Status buildPyramid(const SearchedSurface& surface, const FaceOrder& order, Monitor& monitor,
                    BoxPyramid& out);

}  // namespace index_boolean
