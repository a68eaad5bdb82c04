// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A fuzz target's way to say that something is wrong: the text, then a trap, so that the fuzzer
// keeps the bytes.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace index_boolean::fuzz {

// Nothing, if nothing is wrong.
inline void expectNone(const std::string& defect) {
	if (!defect.empty()) {
		std::fprintf(stderr, "broken property: %s\n", defect.c_str());
		std::abort();
	}
}

}  // namespace index_boolean::fuzz
