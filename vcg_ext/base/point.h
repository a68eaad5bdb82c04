// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A place in space.
#pragma once

#include <array>

namespace index_boolean {

using Point = std::array<double, 3>;

}  // namespace index_boolean
