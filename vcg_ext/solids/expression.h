// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the text of an expression over operands, and what these are called; out: the operands that it
// names, in the order of their first appearance, and what each of its statements says of a place.
//
//   text      = statement { ";" statement } [ ";" ]
//   statement = [ name "=" ] or
//   or  = xor { "|" xor }        xor = and { "^" and }        and = sum { "&" sum }
//   sum = product { ("+" | "-") product }                     product = factor { "*" factor }
//   factor  = "~" factor | "(" or ")" | operand | name | call
//   call    = ("union" | "intersection" | "difference" | "xor") "(" item { "," item } ")"
//           | "at_least" "(" digits "," item { "," item } ")"
//           | "winding" "(" operand "," [ "-" ] digits ")"
//           | ("odd" | "positive" | "nonzero") "(" operand ")"
//   item    = "visible" | "all" | or
//   operand = digits | '"' { any but " and \ | \" | \\ } '"'
//   name    = letter or _ { letter, digit or _ }
//
// Guarantee: precedence is Python's, operators group to the left. No depth and no length is too
// much: nothing recurs. What does not read is a problem with its place, never a guess.
#pragma once

#include "vcg_ext/solids/cell_blocks.h"
#include "vcg_ext/solids/expression_gates.h"

#include <functional>
#include <optional>
#include <string>

namespace index_boolean {

// An operand by the caller's number for it, or why there is none.
struct NamedOperand {
	bool isFound;
	std::uint32_t number;  // if it is found
	std::string problem;   // if it is not: half a sentence
};

// What a caller's operands are called.
struct OperandNames {
	std::function<NamedOperand(const std::string& digits)> byDigits;
	std::function<NamedOperand(const std::string& label)> byLabel;
	// The operands that "visible" or "all" stands for, by their numbers, in order.
	std::function<std::vector<std::uint32_t>(const std::string& word)> list;
};

struct Statement {
	std::string name;  // empty: it has none
	std::string text;  // without the name, and without blanks around it
	Literal truth;     // false of the outside
};

struct Expression {
	std::vector<std::uint32_t> operands;  // the caller's number of each
	std::vector<Statement> statements;    // at least one
	GateNetwork gates;
};

// What is wrong with a text, and where: a byte of it, or its end.
struct ExpressionProblem {
	std::size_t begin;
	std::string what;  // half a sentence
};

// Reads a text.
// \param rule what a plain operand is true of; others are said by the text itself
// \param out  only meaningful if there is no problem
// \return the first problem, if there is any: a word that should not be there, or is missing; an
//         operand that is not found; a list of none; a name that is not defined before, defined
//         twice or reserved; a statement that is true of the outside, which has no boundary
// Throws std::bad_alloc. Complexity: O(n log n) for the text with its lists written out.
std::optional<ExpressionProblem> readExpression(const std::string& text, const OperandNames& names,
                                                WindingRule rule, Expression& out);

// The cells of which each statement is true. \pre the arrangement has cells, and the expression's
// operands in its order. Throws std::bad_alloc.
// Complexity: O(c (N + s)) for c cells, N operands and s statements, and what changes from cell to
// cell.
std::vector<CellSet> cellsOf(const Expression& expression, const Arrangement& arrangement);

}  // namespace index_boolean
