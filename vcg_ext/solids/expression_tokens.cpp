// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Characters are told by their codes, whatever the program's locale.
#include "vcg_ext/solids/expression_tokens.h"

namespace index_boolean {

namespace {

constexpr char kQuote = '"', kEscape = '\\';

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isSymbol(char c) { return std::string("|^&+-*~(),;=").find(c) != std::string::npos; }

class Tokenizer {
public:
	explicit Tokenizer(const std::string& text) : text_(text) {}

	Token next() {
		while (at_ < text_.size() && isBlank(text_[at_])) {
			++at_;
		}
		if (at_ == text_.size()) {
			return {TokenKind::End, {}, at_};
		}
		const char c = text_[at_];
		if (isDigit(c)) {
			return run(TokenKind::Digits, isDigit);
		}
		if (isLetter(c)) {
			return run(TokenKind::Name, [](char d) { return isLetter(d) || isDigit(d); });
		}
		if (c == kQuote) {
			return label();
		}
		return {isSymbol(c) ? TokenKind::Symbol : TokenKind::Unreadable, {c}, at_++};
	}

private:
	template <class Belongs>
	Token run(TokenKind kind, Belongs belongs) {
		const std::size_t begin = at_;
		while (at_ < text_.size() && belongs(text_[at_])) {
			++at_;
		}
		return {kind, text_.substr(begin, at_ - begin), begin};
	}

	// A backslash stands before a quote or a backslash only.
	Token label() {
		Token token{TokenKind::Label, {}, at_++};
		for (; at_ < text_.size() && text_[at_] != kQuote; ++at_) {
			if (text_[at_] == kEscape) {
				++at_;
				if (at_ == text_.size() || (text_[at_] != kQuote && text_[at_] != kEscape)) {
					return {TokenKind::Unreadable, {kEscape}, at_ - 1};
				}
			}
			token.text += text_[at_];
		}
		if (at_ == text_.size()) {
			return {TokenKind::Unreadable, {kQuote}, token.begin};
		}
		++at_;
		return token;
	}

	const std::string& text_;
	std::size_t at_ = 0;
};

}  // namespace

std::vector<Token> tokensOf(const std::string& text) {
	Tokenizer tokenizer(text);
	std::vector<Token> tokens;
	do {
		tokens.push_back(tokenizer.next());
	} while (tokens.back().kind != TokenKind::End);
	return tokens;
}

}  // namespace index_boolean
