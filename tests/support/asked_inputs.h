// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many random inputs a test makes.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace index_boolean {

// As many as INDEXBOOLEAN_FUZZ_PAIRS says, or else the usual number. Input n is made from the seed
// n.
inline std::uint32_t askedInputs(std::uint32_t usual) {
	const char* const asked = std::getenv("INDEXBOOLEAN_FUZZ_PAIRS");
	return asked == nullptr ? usual : static_cast<std::uint32_t>(std::strtoul(asked, nullptr, 10));
}

}  // namespace index_boolean
