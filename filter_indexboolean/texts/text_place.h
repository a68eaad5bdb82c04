// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a text that a user has written, and where something is wrong with it; out: the refusal that
// shows the place.
#pragma once

#include <cstddef>
#include <string>

namespace index_boolean {

// "<what>, line 1, column 5: <problem>", then the line, or of a long one what is around the place,
// and a caret under the place, on lines of their own. Columns count characters, from 1 on.
// \param text in UTF-8 \param begin the place: a byte of the text, or its end
std::string messageAtPlace(const std::string& what, const std::string& text, std::size_t begin,
                           const std::string& problem);

// A text of at most so many characters: a longer one is cut, with "…" in the last one's place.
std::string shortened(const std::string& text, std::size_t most);

}  // namespace index_boolean
