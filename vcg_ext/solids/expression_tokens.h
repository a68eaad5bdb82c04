// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the text of an expression, or of a list of operands; out: its words, with their places.
// Guarantee: any bytes are taken; what is no word is one of kind Unreadable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace index_boolean {

enum class TokenKind : std::uint8_t {
	Digits,      // an operand by its number, or a count
	Label,       // an operand by its label: text without the quotes and backslashes around it
	Name,        // a letter or _, then letters, digits or _
	Symbol,      // one of the signs of the grammar
	Unreadable,  // any other character, or a label without its end
	End,         // behind the last one; text is empty
};

struct Token {
	TokenKind kind;
	std::string text;
	std::size_t begin;  // of its first byte

	bool is(char symbol) const { return kind == TokenKind::Symbol && text[0] == symbol; }
};

// All words, then one of kind End. Blanks, tabs and line ends part words. Throws std::bad_alloc.
// Complexity: O(n) for n bytes.
std::vector<Token> tokensOf(const std::string& text);

}  // namespace index_boolean
