// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Expressions: what they say of a place, against trees that are evaluated node by node; what does
// not read, and where.
#include "core/any_operands.h"

#include <vcg_ext/index_boolean.h>

#include <gtest/gtest.h>

#include <random>

namespace index_boolean {
namespace {

constexpr std::size_t kLayers = 12;  // layers have the ids 0 .. 11 and the labels l0 .. l11

NamedOperand numbered(const std::string& text, std::size_t count) {
	const bool isNumber = !text.empty() && text.size() < 6 &&
	                      text.find_first_not_of("0123456789") == std::string::npos;
	const std::size_t number = isNumber ? std::stoul(text) : count;
	return number < count ? NamedOperand{true, static_cast<std::uint32_t>(number), {}}
	                      : NamedOperand{false, 0, "no such layer"};
}

OperandNames layersNamed(std::size_t count = kLayers) {
	return {[count](const std::string& digits) { return numbered(digits, count); },
	        [count](const std::string& label) {
		        return numbered(label.substr(label.empty() ? 0 : 1), count);
	        },
	        [count](const std::string& word) {
		        std::vector<std::uint32_t> all;
		        for (std::uint32_t i = 0; i < (word == "all" ? count : count / 2); ++i) {
			        all.push_back(i);
		        }
		        return all;
	        }};
}

Expression read(const std::string& text, WindingRule rule = WindingRule::Nonzero) {
	Expression expression;
	const auto problem = readExpression(text, layersNamed(), rule, expression);
	EXPECT_FALSE(problem) << text << ": " << problem->what << " at " << problem->begin;
	return expression;
}

std::string problemOf(const std::string& text, std::size_t& place) {
	Expression expression;
	const auto problem = readExpression(text, layersNamed(), WindingRule::Nonzero, expression);
	place = problem ? problem->begin : std::string::npos;
	return problem ? problem->what : "";
}

// The winding numbers of an expression's operands, of those of the layers.
PerOperand<std::int32_t> windingsOf(const Expression& expression,
                                    const std::vector<std::int32_t>& ofLayers) {
	PerOperand<std::int32_t> windings(expression.operands.size());
	for (const OperandId operand : windings.operands()) {
		windings[operand] = ofLayers[expression.operands[operand.value]];
	}
	return windings;
}

bool isTrue(const Expression& expression, const std::vector<std::int32_t>& ofLayers,
            std::size_t statement = 0) {
	GateEvaluator evaluator(expression.gates, expression.operands.size());
	evaluator.goTo(windingsOf(expression, ofLayers));
	return evaluator.isTrue(expression.statements[statement].truth);
}

// Whether two texts say the same of all places where layers 0 to 3 wind once or not at all.
void expectSame(const std::string& text, const std::string& other) {
	const Expression a = read(text), b = read(other);
	for (unsigned bits = 0; bits < 16; ++bits) {
		std::vector<std::int32_t> windings(kLayers, 0);
		for (std::size_t i = 0; i < 4; ++i) {
			windings[i] = static_cast<std::int32_t>(bits >> i & 1U);
		}
		EXPECT_EQ(isTrue(a, windings), isTrue(b, windings)) << text << " / " << other << bits;
	}
}

TEST(Expression, precedenceIsPythonsAndOperatorsGroupToTheLeft) {
	const char* const same[][2] = {
	    {"0 | 1 ^ 2", "0 | (1 ^ 2)"},
	    {"0 ^ 1 | 2", "(0 ^ 1) | 2"},
	    {"0 ^ 1 & 2", "0 ^ (1 & 2)"},
	    {"0 & 1 ^ 2", "(0 & 1) ^ 2"},
	    {"0 & 1 + 2", "0 & (1 + 2)"},
	    {"0 + 1 & 2", "(0 + 1) & 2"},
	    {"0 & 1 - 2", "0 & (1 - 2)"},
	    {"0 - 1 & 2", "(0 - 1) & 2"},
	    {"0 + 1 * 2", "0 + (1 * 2)"},
	    {"0 * 1 + 2", "(0 * 1) + 2"},
	    {"0 - 1 * 2", "0 - (1 * 2)"},
	    {"0 - 1 - 2", "(0 - 1) - 2"},
	    {"0 - 1 + 2", "(0 - 1) + 2"},
	    {"0 + 1 - 2", "(0 + 1) - 2"},
	    {"0 * ~1 * 2", "0 * (~1) * 2"},
	    {"0 - ~1 | 2", "(0 - (~1)) | 2"},
	    {"~~0", "0"},
	    {"0 * ~~~1", "0 - 1"},
	    {"0 | 1 ^ 2 & 3 - 0 * 1", "0 | (1 ^ (2 & (3 - (0 * 1))))"},
	};
	for (const auto& pair : same) {
		expectSame(pair[0], pair[1]);
	}
	const Expression left = read("0 - 1 - 2"), right = read("0 - (1 - 2)");
	const std::vector<std::int32_t> inAll(kLayers, 1);
	EXPECT_FALSE(isTrue(left, inAll));
	EXPECT_TRUE(isTrue(right, inAll));
}

TEST(Expression, functionsAreOperatorsOfAnyNumber) {
	const char* const same[][2] = {
	    {"union(0, 1, 2)", "0 | 1 | 2"},
	    {"intersection(0, 1, 2)", "0 & 1 & 2"},
	    {"difference(0, 1, 2)", "0 - 1 - 2"},
	    {"difference(0)", "0"},
	    {"xor(0, 1, 2)", "0 ^ 1 ^ 2"},
	    {"at_least(1, 0, 1)", "0 | 1"},
	    {"at_least(2, 0, 1, 2)", "0 & 1 | 1 & 2 | 0 & 2"},
	    {"at_least(2, 0, 0)", "0"},
	    {"at_least(3, 0, 1)", "0 - 0"},
	    {"at_least(99999999999999999999, 0, 1)", "0 - 0"},
	    {"union(0 - 1, 2) - 3", "(0 - 1 | 2) - 3"},
	    {"union(\"l0\", 1)", "0 | \"l1\""},
	    {"difference(0 | 1, 2)", "(0 | 1) - 2"},
	    {"0 & at_least(0, 1)", "0"},
	};
	for (const auto& pair : same) {
		expectSame(pair[0], pair[1]);
	}
}

TEST(Expression, aListLeavesOutTheSingleLayerBeforeIt) {
	EXPECT_EQ(read("difference(3, all)").operands,
	          (std::vector<std::uint32_t>{3, 0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 11}));
	std::vector<std::int32_t> only(kLayers, 0);
	only[3] = 1;
	EXPECT_TRUE(isTrue(read("difference(3, all)"), only));
	EXPECT_TRUE(isTrue(read("a = 3; difference(a, all)"), only, 1));
	EXPECT_FALSE(isTrue(read("at_least(2, 3, all)"), only));
	EXPECT_TRUE(isTrue(read("at_least(2, 3 | 3, all)"), only));  // no single layer
	EXPECT_FALSE(isTrue(read("difference(all)"), only));
	only[0] = 1;
	EXPECT_FALSE(isTrue(read("difference(all)"), only));
	only[3] = 0;
	EXPECT_TRUE(isTrue(read("difference(all)"), only));
	EXPECT_TRUE(isTrue(read("xor(all)"), only));
	EXPECT_FALSE(isTrue(read("xor(all, visible)"), only));  // twice: what comes first is a list
}

TEST(Expression, operandsAreNumberedByFirstAppearance) {
	const Expression expression = read("a = 7 - 2; b = \"l3\" & 7 - a; union(visible)");
	EXPECT_EQ(expression.operands, (std::vector<std::uint32_t>{7, 2, 3, 0, 1, 4, 5}));
	ASSERT_EQ(expression.statements.size(), 3U);
	EXPECT_EQ(expression.statements[0].name, "a");
	EXPECT_EQ(expression.statements[0].text, "7 - 2");
	EXPECT_EQ(expression.statements[1].text, "\"l3\" & 7 - a");
	EXPECT_EQ(expression.statements[2].name, "");
	EXPECT_EQ(read(" 0 ;\n 1 ; ").statements[1].text, "1");
}

TEST(Expression, windingTestsHoldWhateverTheRuleIs) {
	for (const WindingRule rule : {WindingRule::Nonzero, WindingRule::Positive, WindingRule::Odd}) {
		for (std::int32_t w = -3; w <= 3; ++w) {
			std::vector<std::int32_t> windings(kLayers, 0);
			windings[5] = w;
			EXPECT_EQ(isTrue(read("odd(5)", rule), windings), w % 2 != 0);
			EXPECT_EQ(isTrue(read("positive(5)", rule), windings), w > 0);
			EXPECT_EQ(isTrue(read("nonzero(5)", rule), windings), w != 0);
			EXPECT_EQ(isTrue(read("winding(5, 2)", rule), windings), w >= 2);
			EXPECT_EQ(isTrue(read("5 * winding(5, -2)", rule), windings),
			          w >= -2 && isInside(rule, w));
			EXPECT_EQ(isTrue(read("5", rule), windings), isInside(rule, w));
		}
	}
	const Expression mixed = read("odd(0) | 1 | odd(2) & 2 | winding(3, 1)");
	std::vector<bool> parityOnly;
	for (std::uint32_t i = 0; i < 4; ++i) {
		parityOnly.push_back(mixed.gates.asksParityOnly({i}));
	}
	EXPECT_EQ(parityOnly, (std::vector<bool>{true, false, false, false}));
	EXPECT_TRUE(read("0", WindingRule::Odd).gates.asksParityOnly(kFirst));
}

TEST(Expression, whatDoesNotReadIsShownByItsPlace) {
	const struct {
		const char* text;
		std::size_t place;
		const char* problem;
	} cases[] = {
	    {"", 0, "the text ends"},
	    {"  ", 2, "the text ends"},
	    {"0 |", 3, "the text ends"},
	    {"0 1", 2, "an operator is expected"},
	    {"| 0", 0, "is expected here"},
	    {"(0", 2, "the text ends where an operator or a \")\""},
	    {"0)", 1, "an operator is expected"},
	    {"union(0", 7, "the text ends"},
	    {"union()", 6, "is expected here"},
	    {"union 0", 6, "a \"(\" is expected"},
	    {"0 ? 1", 2, "this character means nothing"},
	    {"\"abc", 0, "the double quote at the end"},
	    {"\"a\\bc\"", 2, "a backslash stands before"},
	    {"-0", 0, "there is no \"-\" before an operand"},
	    {"0 + +1", 4, "there is no \"+\" before an operand"},
	    {"99", 0, "no such layer"},
	    {"0 | \"l99\"", 4, "no such layer"},
	    {"a", 0, "no statement before this one defines the name \"a\""},
	    {"b = 0 - b", 8, "no statement before this one"},
	    {"a = 0; a = 1", 7, "is defined twice"},
	    {"union = 0", 0, "is a word of the grammar"},
	    {"all = 0", 0, "is a word of the grammar"},
	    {"all", 0, "is a list"},
	    {"0 | all", 4, "is a list"},
	    {"union(0 | all)", 10, "is a list"},
	    {"union(~all)", 7, "is a list"},
	    {"union(all | 0)", 6, "is a list"},
	    {"foo(0)", 0, "there is no function \"foo\""},
	    {"at_least(0)", 10, "a \",\" is expected"},
	    {"at_least(a, 0)", 9, "a number is expected"},
	    {"winding(0)", 9, "a \",\" is expected"},
	    {"winding(0, x)", 11, "a number is expected"},
	    {"winding(0 | 1, 1)", 10, "a \",\" is expected"},
	    {"a = 0; odd(a)", 11, "a layer by its id"},
	    {"~0", 0, "is true of the outside"},
	    {"0; b = ~1", 3, "is true of the outside"},
	    {"winding(0, 0)", 0, "is true of the outside"},
	    {"at_least(0, 1)", 0, "is true of the outside"},
	    {"0;;1", 2, "is expected here"},
	    {";", 0, "is expected here"},
	    {"0 ~ 1", 2, "an operator is expected"},
	};
	for (const auto& c : cases) {
		std::size_t place = 0;
		const std::string problem = problemOf(c.text, place);
		EXPECT_NE(problem.find(c.problem), std::string::npos) << c.text << ": " << problem;
		EXPECT_EQ(place, c.place) << c.text << ": " << problem;
	}
}

TEST(Expression, anEmptyListIsRefusedInItsPlace) {
	Expression expression;
	for (const char* text : {"union(visible)", "difference(0, all)"}) {
		const auto problem = readExpression(text, layersNamed(text[0] == 'u' ? 0 : 1),
		                                    WindingRule::Nonzero, expression);
		ASSERT_TRUE(problem) << text;
		EXPECT_EQ(problem->begin, std::string(text).find_first_of("(") + (text[0] == 'u' ? 1 : 4));
	}
}

// A tree as text, and evaluated node by node.
struct Tree {
	std::string text;
	std::function<bool(const std::vector<std::int32_t>&)> truth;
	int rank;  // of its weakest operator outside parentheses
};

class TreeMaker {
public:
	explicit TreeMaker(unsigned seed) : random_(seed) {}

	Tree make(int depth) {
		if (depth == 0 || below(5) == 0) {
			return leaf();
		}
		return below(3) == 0 ? call(depth) : below(6) == 0 ? contrary(depth) : binary(depth);
	}
	unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }

private:
	static Tree enclosed(Tree t) { return {"(" + t.text + ")", t.truth, 7}; }
	static std::string atRank(const Tree& t, int rank) {
		return t.rank < rank ? "(" + t.text + ")" : t.text;
	}

	Tree leaf() {
		const std::size_t k = below(kLayers);
		const std::string id = below(2) == 0 ? std::to_string(k) : "\"l" + std::to_string(k) + "\"";
		switch (below(8)) {
		case 0: {
			const int least = static_cast<int>(below(4)) - 1;
			return {"winding(" + id + "," + std::to_string(least) + ")",
			        [=](const auto& w) { return w[k] >= least; }, 7};
		}
		case 1:
			return {"odd( " + id + ")", [=](const auto& w) { return w[k] % 2 != 0; }, 7};
		case 2:
			return {"positive(" + id + ")", [=](const auto& w) { return w[k] > 0; }, 7};
		default:
			return {id, [=](const auto& w) { return w[k] != 0; }, 7};
		}
	}

	Tree contrary(int depth) {
		const Tree a = make(depth - 1);
		return {"~" + atRank(a, 6), [=](const auto& w) { return !a.truth(w); }, 6};
	}

	Tree binary(int depth) {
		static const struct {
			const char* symbol;
			int rank;
			bool (*truth)(bool, bool);
		} kOperators[] = {
		    {"|", 1, [](bool a, bool b) { return a || b; }},
		    {"^", 2, [](bool a, bool b) { return a != b; }},
		    {"&", 3, [](bool a, bool b) { return a && b; }},
		    {"+", 4, [](bool a, bool b) { return a || b; }},
		    {"-", 4, [](bool a, bool b) { return a && !b; }},
		    {"*", 5, [](bool a, bool b) { return a && b; }},
		};
		const auto& op = kOperators[below(6)];
		const Tree a = make(depth - 1), b = make(depth - 1);
		const auto truth = op.truth;
		return {atRank(a, op.rank) + (below(2) == 0 ? " " : "") + op.symbol +
		            atRank(b, op.rank + 1),
		        [=](const auto& w) { return truth(a.truth(w), b.truth(w)); }, op.rank};
	}

	Tree call(int depth) {
		static const char* const kNames[] = {"union", "intersection", "difference", "xor",
		                                     "at_least"};
		const std::size_t which = below(5), count = 1 + below(4);
		const unsigned least = below(4);
		std::string text = std::string(kNames[which]) + "(";
		text += which == 4 ? std::to_string(least) + ", " : "";
		std::vector<Tree> items;
		for (std::size_t i = 0; i < count; ++i) {
			items.push_back(make(depth - 1));
			text += (i > 0 ? ", " : "") + items.back().text;
		}
		return {text + ")",
		        [=](const auto& w) {
			        std::size_t number = 0;
			        for (const Tree& item : items) {
				        number += item.truth(w) ? 1 : 0;
			        }
			        const bool first = items[0].truth(w);
			        return which == 0   ? number > 0
			               : which == 1 ? number == count
			               : which == 2 ? first && number == 1
			               : which == 3 ? number % 2 != 0
			                            : number >= least;
		        },
		        7};
	}

	std::mt19937 random_;
};

TEST(Expression, randomTreesSayTheSameAsTheirTexts) {
	constexpr unsigned kSeed = 20261129;
	TreeMaker maker(kSeed);
	std::size_t read = 0, outside = 0;
	for (int i = 0; i < 4000; ++i) {
		const Tree tree = maker.make(1 + static_cast<int>(maker.below(5)));
		Expression expression;
		const auto problem =
		    readExpression(tree.text, layersNamed(), WindingRule::Nonzero, expression);
		std::vector<std::int32_t> windings(kLayers, 0);
		if (tree.truth(windings)) {
			++outside;
			ASSERT_TRUE(problem) << tree.text;
			ASSERT_EQ(problem->what, "this is true of the outside, which has no boundary");
			continue;
		}
		++read;
		ASSERT_FALSE(problem) << tree.text << ": " << problem->what << " at " << problem->begin;
		GateEvaluator evaluator(expression.gates, expression.operands.size());
		for (int place = 0; place < 40; ++place) {
			for (std::int32_t& w : windings) {  // some stay, as from one place to the next
				w = maker.below(2) == 0 ? w : static_cast<std::int32_t>(maker.below(5)) - 2;
			}
			evaluator.goTo(windingsOf(expression, windings));
			ASSERT_EQ(evaluator.isTrue(expression.statements[0].truth), tree.truth(windings))
			    << tree.text << ", seed " << kSeed;
		}
	}
	EXPECT_GT(read, 2000U);
	EXPECT_GT(outside, 200U);
}

TEST(Expression, noDepthAndNoLengthIsTooMuch) {
	constexpr std::size_t kDepth = 100000;
	const std::vector<std::int32_t> inAll(kLayers, 1);
	const std::string parentheses = std::string(kDepth, '(') + "0" + std::string(kDepth, ')');
	EXPECT_TRUE(isTrue(read(parentheses), inAll));
	EXPECT_TRUE(isTrue(read("1 &" + std::string(2 * kDepth, '~') + "0"), inAll));
	std::string calls, nested, chain = "0";
	for (std::size_t i = 0; i < kDepth; ++i) {
		calls += "union(1,";
		nested += "0 - (";
		chain += i % 2 == 0 ? " | 1" : " ^ 2";
	}
	EXPECT_TRUE(isTrue(read(calls + "0" + std::string(kDepth, ')')), inAll));
	EXPECT_TRUE(isTrue(read(nested + "1" + std::string(kDepth, ')')), inAll));
	read(chain);
	std::size_t place = 0;
	EXPECT_NE(problemOf(std::string(kDepth, '('), place), "");
	EXPECT_EQ(place, kDepth);
}

TEST(Expression, anyBytesReadOrHaveAProblemInThem) {
	std::mt19937 random(7);
	const std::string pieces[] = {"0",
	                              "11",
	                              "\"l1\"",
	                              "\"",
	                              "\\",
	                              "a",
	                              "=",
	                              ";",
	                              "(",
	                              ")",
	                              ",",
	                              "|",
	                              "^",
	                              "&",
	                              "+",
	                              "-",
	                              "*",
	                              "~",
	                              "union(",
	                              "at_least(",
	                              "winding(",
	                              "odd(",
	                              "visible",
	                              "all",
	                              " ",
	                              "\n",
	                              "\xc3\xbc",
	                              "?",
	                              std::string(1, '\0'),
	                              "2,",
	                              "b",
	                              "99999999999999999999"};
	for (int i = 0; i < 20000; ++i) {
		std::string text;
		for (std::size_t n = random() % 12; n > 0; --n) {
			text += pieces[random() % std::size(pieces)];
		}
		Expression expression;
		const auto problem = readExpression(text, layersNamed(), WindingRule::Odd, expression);
		if (problem) {
			ASSERT_LE(problem->begin, text.size()) << text;
			ASSERT_FALSE(problem->what.empty());
		} else {
			ASSERT_FALSE(expression.statements.empty()) << text;
		}
	}
}

}  // namespace
}  // namespace index_boolean
