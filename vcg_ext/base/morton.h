// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a cell of a grid; out: its place on a curve that fills space. Source: Morton 1966.
#pragma once

#include <cstdint>

namespace index_boolean {

// Moves each of the low 10 bits of a number to three times its place. O(1).
inline std::uint32_t spreadBits(std::uint32_t x) {
	x = (x | x << 16U) & 0x030000ffU;
	x = (x | x << 8U) & 0x0300f00fU;
	x = (x | x << 4U) & 0x030c30c3U;
	return (x | x << 2U) & 0x09249249U;
}

}  // namespace index_boolean
