// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "texts/text_place.h"

#include <algorithm>
#include <vector>

namespace index_boolean {

namespace {

// How many characters of a long line are shown before the place and from it on.
constexpr std::size_t kBefore = 60, kBehind = 40;
const char* const kLeftOut = "...";

bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// The characters of a line; what does not show, such as a tab, as a blank.
std::vector<std::string> charactersOf(const std::string& line) {
	std::vector<std::string> characters;
	for (const char c : line) {
		if (continuesCharacter(c) && !characters.empty()) {
			characters.back() += c;
		} else {
			constexpr char kBlank = ' ';
			characters.emplace_back(1, static_cast<unsigned char>(c) < ' ' ? kBlank : c);
		}
	}
	return characters;
}

std::string joined(const std::vector<std::string>& characters, std::size_t begin, std::size_t end) {
	std::string text;
	for (std::size_t i = begin; i < end; ++i) {
		text += characters[i];
	}
	return text;
}

}  // namespace

std::string shortened(const std::string& text, std::size_t most) {
	const std::vector<std::string> characters = charactersOf(text);
	return characters.size() > most ? joined(characters, 0, most - 1) + "\u2026" : text;
}

std::string messageAtPlace(const std::string& what, const std::string& text, std::size_t begin,
                           const std::string& problem) {
	const std::size_t place = std::min(begin, text.size());
	const std::string before = text.substr(0, place);
	const std::size_t lineNumber =
	    1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
	const std::size_t lineBegin = before.rfind('\n') + 1;  // 0 in the first line
	const std::size_t lineEnd = std::min(text.find('\n', place), text.size());
	const std::vector<std::string> line = charactersOf(text.substr(lineBegin, lineEnd - lineBegin));
	const std::size_t column = charactersOf(text.substr(lineBegin, place - lineBegin)).size();

	const std::size_t first = column > kBefore ? column - kBefore : 0;
	const std::size_t last = std::min(line.size(), column + kBehind);
	const std::string start = first > 0 ? kLeftOut : "";
	return what + ", line " + std::to_string(lineNumber) + ", column " +
	       std::to_string(column + 1) + ": " + problem + "\n" + start + joined(line, first, last) +
	       (last < line.size() ? kLeftOut : "") + "\n" +
	       std::string(start.size() + column - first, ' ') + "^";
}

}  // namespace index_boolean
