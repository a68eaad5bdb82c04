// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: counts; out: whether ids can hold them.
#pragma once

#include "vcg_ext/base/status.h"

#include <cstddef>

namespace index_boolean {

// The most points, and the most faces, that all operands may have together.
constexpr std::size_t kMostElements = 0x7fffffff;

// \param most how many there may be of each; no more than kMostElements count
// \return Ok, or TooLarge with the larger count, of no operand in particular. Complexity: O(1).
Status checkCounts(std::size_t points, std::size_t faces, std::size_t most = kMostElements);

// The same for what there is more of, such as corners: up to twice as many have numbers, none()
// left out, in 32 bits. \return Ok, or TooLarge with the count. Complexity: O(1).
Status checkNumbering(std::size_t count, std::size_t most = kMostElements);

}  // namespace index_boolean
