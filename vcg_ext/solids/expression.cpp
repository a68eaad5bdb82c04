// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operator precedence with a stack of its own: what is inside parentheses or a call is a frame.
// Chains of one operator become one gate: the contrary of an "and" of contraries is an "or", so all
// of | & + - * ~ are gates that are true where at least one input is.
#include "vcg_ext/solids/expression.h"

#include "vcg_ext/solids/expression_tokens.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <unordered_map>

namespace index_boolean {

namespace {

enum class Callee : std::uint8_t {
	Union,
	Intersection,
	Difference,
	Xor,
	AtLeast,
	Winding,
	Odd,
	Positive,
	Nonzero
};

struct CalleeName {
	const char* name;
	Callee callee;
	bool takesItems;  // else one operand
};

constexpr std::array<CalleeName, 9> kCallees{{
    {"union", Callee::Union, true},
    {"intersection", Callee::Intersection, true},
    {"difference", Callee::Difference, true},
    {"xor", Callee::Xor, true},
    {"at_least", Callee::AtLeast, true},
    {"winding", Callee::Winding, false},
    {"odd", Callee::Odd, false},
    {"positive", Callee::Positive, false},
    {"nonzero", Callee::Nonzero, false},
}};

const CalleeName* calleeOf(const std::string& name) {
	const auto found = std::find_if(kCallees.begin(), kCallees.end(),
	                                [&](const CalleeName& c) { return name == c.name; });
	return found == kCallees.end() ? nullptr : &*found;
}

bool isList(const std::string& name) { return name == "visible" || name == "all"; }

struct Precedence {
	char symbol;
	int rank;  // the higher, the closer it binds
};

constexpr std::array<Precedence, 7> kPrecedences{
    {{'|', 1}, {'^', 2}, {'&', 3}, {'+', 4}, {'-', 4}, {'*', 5}, {'~', 6}}};

// 0: no operator.
int rankOf(char symbol) {
	const auto found = std::find_if(kPrecedences.begin(), kPrecedences.end(),
	                                [symbol](const Precedence& p) { return p.symbol == symbol; });
	return found == kPrecedences.end() ? 0 : found->rank;
}

// What a part of the text says: a literal, or a gate that is not made yet, since more inputs may
// come.
struct Value {
	enum class Kind : std::uint8_t { Literal, Any, Odd } kind = Kind::Literal;
	bool negated = false;
	std::vector<Literal> inputs;           // a literal has one
	OperandId single = OperandId::none();  // it is this operand and nothing else

	static Value of(Literal literal, OperandId single = OperandId::none()) {
		return {Kind::Literal, literal.negated, {{literal.gate, false}}, single};
	}
	Value operator~() && {
		negated = !negated;
		single = OperandId::none();
		return std::move(*this);
	}
};

enum class FrameKind : std::uint8_t { Statement, Parenthesis, Call };

// What has been read of a statement, a parenthesis or a call.
struct Frame {
	FrameKind kind;
	Callee callee = Callee::Union;
	std::size_t threshold = 1;  // AtLeast
	std::vector<char> operators{};
	std::vector<Value> values{};
	std::vector<Value> items{};
};

// Digits that may be too many.
std::int64_t numberOf(const std::string& digits) {
	std::int64_t number = 0;
	const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
	return read.ec == std::errc() ? number : std::numeric_limits<std::int64_t>::max();
}

class Reader {
public:
	Reader(const std::string& text, const OperandNames& names, WindingRule rule, Expression& out)
	    : text_(text), tokens_(tokensOf(text)), names_(names), rule_(rule), out_(out) {}

	void read();

private:
	[[noreturn]] void fail(const Token& token, const std::string& what) const;
	[[noreturn]] void failAt(const Token& token, const std::string& expected) const;
	const Token& token() const { return tokens_[next_]; }
	const Token& take() { return tokens_[next_++]; }
	void expect(char symbol);

	void readStatement();
	std::string readStatementName();
	void readOr();
	bool readFactor();
	bool readBehindFactor();
	void readWord();
	void openCall(const CalleeName& callee);
	void readOperandCall(Callee callee);
	void readListItem(const std::string& word);
	OperandId readOperand();
	OperandId operandOf(std::uint32_t number);
	WindingTest testOfRule() const;

	Frame& frame() { return frames_.back(); }
	void push(Value value);
	void pushOperator(char symbol);
	void reduce(int rank);
	void endItem();
	void closeFrame();

	Literal literalOf(Value value);
	std::vector<Literal> literalsOf(std::vector<Value>& values);
	Value any(Value a, Value b);
	Value odd(Value a, Value b);
	Value combined(char symbol, Value a, Value b);
	Value called(Frame& call);

	const std::string& text_;
	std::vector<Token> tokens_;
	const OperandNames& names_;
	WindingRule rule_;
	Expression& out_;
	std::size_t next_ = 0;
	std::vector<Frame> frames_;
	std::unordered_map<std::uint32_t, OperandId> operands_;  // by their numbers
	struct Definition {
		Literal truth;
		OperandId single;
	};
	std::unordered_map<std::string, Definition> definitions_;
};

void Reader::fail(const Token& token, const std::string& what) const {
	throw ExpressionProblem{token.begin, what};
}

// Something else is expected where a word is.
void Reader::failAt(const Token& token, const std::string& expected) const {
	if (token.kind == TokenKind::End) {
		fail(token, "the text ends where " + expected + " is expected");
	}
	if (token.kind != TokenKind::Unreadable) {
		fail(token, expected + " is expected here");
	}
	fail(token, token.text == "\"" ? "the double quote at the end of this label is missing"
	            : token.text == "\\"
	                ? "a backslash stands before a double quote or a backslash in a label only"
	                : "this character means nothing in an expression");
}

void Reader::expect(char symbol) {
	if (!token().is(symbol)) {
		failAt(token(), std::string("a \"") + symbol + "\"");
	}
	++next_;
}

void Reader::read() {
	readStatement();
	while (token().is(';')) {
		++next_;
		if (token().kind == TokenKind::End) {
			break;
		}
		readStatement();
	}
	if (token().kind != TokenKind::End) {
		failAt(token(), "an operator");
	}
}

// The name that the statement defines, which is none of another kind; empty if there is none.
std::string Reader::readStatementName() {
	const bool hasName = token().kind == TokenKind::Name && tokens_[next_ + 1].is('=');
	if (!hasName) {
		return {};
	}
	const Token& name = take();
	++next_;
	if (isList(name.text) || calleeOf(name.text) != nullptr) {
		fail(name, "\"" + name.text + "\" is a word of the grammar and cannot be a name");
	}
	if (definitions_.count(name.text) != 0) {
		fail(name, "the name \"" + name.text + "\" is defined twice");
	}
	return name.text;
}

void Reader::readStatement() {
	const Token& first = token();
	const std::string name = readStatementName();
	const std::size_t begin = token().begin;
	readOr();
	const OperandId single = frame().values.front().single;
	const Literal truth = literalOf(std::move(frame().values.front()));
	frames_.pop_back();
	if (out_.gates.isTrueOutside(truth)) {
		fail(first, "this is true of the outside, which has no boundary");
	}
	std::string text = text_.substr(begin, token().begin - begin);
	text.erase(text.find_last_not_of(" \t\r\n") + 1);
	out_.statements.push_back({name, text, truth});
	if (!name.empty()) {
		definitions_.emplace(name, Definition{truth, single});
	}
}

// Leaves one value in the frame of the statement.
void Reader::readOr() {
	frames_.push_back({FrameKind::Statement});
	bool isFactorNext = true;
	while (isFactorNext || frames_.size() > 1 || rankOf(token().text[0]) != 0) {
		isFactorNext = isFactorNext ? readFactor() : readBehindFactor();
	}
	reduce(0);
}

// Reads what begins a factor. \return whether a factor comes next, too
bool Reader::readFactor() {
	if (token().is('~')) {
		frame().operators.push_back('~');
		++next_;
		return true;
	}
	if (token().is('(')) {
		frames_.push_back({FrameKind::Parenthesis});
		++next_;
		return true;
	}
	if (token().is('-') || token().is('+')) {
		fail(token(), std::string("there is no \"") + token().text +
		                  "\" before an operand; \"~\" is what is outside it");
	}
	const std::size_t frames = frames_.size();
	if (token().kind == TokenKind::Name) {
		readWord();
	} else if (token().kind == TokenKind::Digits || token().kind == TokenKind::Label) {
		const OperandId operand = readOperand();
		push(Value::of(out_.gates.leaf({operand, testOfRule()}), operand));
	} else {
		failAt(token(), "a layer, a name, a call or a parenthesis");
	}
	return frames_.size() > frames;  // a call was opened
}

// Reads an operator, or what ends a parenthesis, an item or a call. \return whether a factor comes
// next
bool Reader::readBehindFactor() {
	const Token& here = token();
	if (here.kind == TokenKind::Symbol && rankOf(here.text[0]) != 0 && here.text[0] != '~') {
		pushOperator(here.text[0]);
		++next_;
		return true;
	}
	if (here.is(')') && frame().kind != FrameKind::Statement) {
		++next_;
		closeFrame();
		return false;
	}
	if (here.is(',') && frame().kind == FrameKind::Call) {
		++next_;
		endItem();
		return true;
	}
	failAt(here, frame().kind == FrameKind::Statement ? "an operator"
	             : frame().kind == FrameKind::Call    ? "an operator, a \",\" or a \")\""
	                                                  : "an operator or a \")\"");
}

void Reader::readWord() {
	const Token& word = token();
	const bool isCall = tokens_[next_ + 1].is('(');
	const CalleeName* const callee = calleeOf(word.text);
	if (callee != nullptr) {
		++next_;
		expect('(');
		callee->takesItems ? openCall(*callee) : readOperandCall(callee->callee);
	} else if (isList(word.text)) {
		readListItem(word.text);
	} else if (isCall) {
		fail(word, "there is no function \"" + word.text + "\"");
	} else {
		const auto known = definitions_.find(word.text);
		if (known == definitions_.end()) {
			fail(word, "no statement before this one defines the name \"" + word.text + "\"");
		}
		++next_;
		push(Value::of(known->second.truth, known->second.single));
	}
}

void Reader::openCall(const CalleeName& callee) {
	Frame call{FrameKind::Call};
	call.callee = callee.callee;
	if (callee.callee == Callee::AtLeast) {
		if (token().kind != TokenKind::Digits) {
			failAt(token(), "a number");
		}
		call.threshold = static_cast<std::size_t>(numberOf(take().text));
		expect(',');
	}
	frames_.push_back(std::move(call));
}

// winding, odd, positive, nonzero: of one operand, from behind the opening parenthesis on.
void Reader::readOperandCall(Callee callee) {
	if (token().kind != TokenKind::Digits && token().kind != TokenKind::Label) {
		failAt(token(), "a layer by its id, or by its label in double quotes,");
	}
	Leaf leaf{readOperand(), WindingTest::Nonzero};
	leaf.test = callee == Callee::Odd        ? WindingTest::Odd
	            : callee == Callee::Positive ? WindingTest::Positive
	            : callee == Callee::Winding  ? WindingTest::AtLeast
	                                         : WindingTest::Nonzero;
	if (callee == Callee::Winding) {
		expect(',');
		const bool isNegative = token().is('-');
		next_ += isNegative ? 1 : 0;
		if (token().kind != TokenKind::Digits) {
			failAt(token(), "a number");
		}
		constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
		const std::int64_t least = std::min(numberOf(take().text), kMost);
		leaf.least = static_cast<std::int32_t>(isNegative ? -least : least);
	}
	expect(')');
	push(Value::of(out_.gates.leaf(leaf)));
}

// "visible" or "all", as an item of a call.
void Reader::readListItem(const std::string& word) {
	const Token& here = take();
	const bool isItem = frame().kind == FrameKind::Call && frame().values.empty() &&
	                    frame().operators.empty() && (token().is(',') || token().is(')'));
	if (!isItem) {
		fail(here, "\"" + word +
		               "\" is a list, which stands alone as an argument of union, "
		               "intersection, difference, xor or at_least");
	}
	std::vector<Value>& items = frame().items;
	const OperandId first = items.empty() ? OperandId::none() : items.front().single;
	bool isEmpty = true;
	for (const std::uint32_t number : names_.list(word)) {
		const OperandId operand = operandOf(number);
		if (operand != first) {
			items.push_back(Value::of(out_.gates.leaf({operand, testOfRule()}), operand));
			isEmpty = false;
		}
	}
	if (isEmpty) {
		fail(here, "\"" + word + "\" stands for no layer here");
	}
	if (items.front().single != first) {  // the list itself begins the items: no single layer does
		items.front().single = OperandId::none();
	}
}

OperandId Reader::readOperand() {
	const Token& here = take();
	const NamedOperand named =
	    here.kind == TokenKind::Digits ? names_.byDigits(here.text) : names_.byLabel(here.text);
	if (!named.isFound) {
		fail(here, named.problem);
	}
	return operandOf(named.number);
}

OperandId Reader::operandOf(std::uint32_t number) {
	const auto [known, isNew] = operands_.emplace(number, makeId<OperandTag>(out_.operands.size()));
	if (isNew) {
		out_.operands.push_back(number);
	}
	return known->second;
}

WindingTest Reader::testOfRule() const {
	switch (rule_) {
	case WindingRule::Positive:
		return WindingTest::Positive;
	case WindingRule::Odd:
		return WindingTest::Odd;
	case WindingRule::Nonzero:
		break;
	}
	return WindingTest::Nonzero;
}

// A factor has been read, but for the contraries that are asked of it.
void Reader::push(Value value) {
	frame().values.push_back(std::move(value));
	reduce(rankOf('~'));
}

// Operators that bind as closely, or closer, come first: they group to the left.
void Reader::pushOperator(char symbol) {
	reduce(rankOf(symbol));
	frame().operators.push_back(symbol);
}

// Applies the frame's last operators, down to those of a rank.
void Reader::reduce(int rank) {
	std::vector<char>& operators = frame().operators;
	std::vector<Value>& values = frame().values;
	while (!operators.empty() && rankOf(operators.back()) >= rank) {
		Value right = std::move(values.back());
		values.pop_back();
		const char symbol = operators.back();
		operators.pop_back();
		if (symbol == '~') {
			values.push_back(~std::move(right));
		} else {
			Value left = std::move(values.back());
			values.back() = combined(symbol, std::move(left), std::move(right));
		}
	}
}

// Of a list there is no value: its items are there.
void Reader::endItem() {
	reduce(0);
	if (!frame().values.empty()) {
		frame().items.push_back(std::move(frame().values.back()));
		frame().values.pop_back();
	}
}

void Reader::closeFrame() {
	endItem();
	Frame closed = std::move(frame());
	frames_.pop_back();
	push(closed.kind == FrameKind::Call ? called(closed) : std::move(closed.items.front()));
}

Literal Reader::literalOf(Value value) {
	if (value.kind == Value::Kind::Literal) {
		return {value.inputs.front().gate, value.negated != value.inputs.front().negated};
	}
	const Literal gate = value.kind == Value::Kind::Any ? out_.gates.atLeast(1, value.inputs)
	                                                    : out_.gates.odd(value.inputs);
	return value.negated ? ~gate : gate;
}

std::vector<Literal> Reader::literalsOf(std::vector<Value>& values) {
	std::vector<Literal> literals;
	for (Value& value : values) {
		literals.push_back(literalOf(std::move(value)));
	}
	return literals;
}

// True where a or b is.
Value Reader::any(Value a, Value b) {
	const auto isOpen = [](const Value& v) { return v.kind == Value::Kind::Any && !v.negated; };
	if (!isOpen(a) || (isOpen(b) && a.inputs.size() < b.inputs.size())) {
		std::swap(a, b);
	}
	if (!isOpen(a)) {
		a = {Value::Kind::Any, false, {literalOf(std::move(a))}};
	}
	if (isOpen(b)) {
		a.inputs.insert(a.inputs.end(), b.inputs.begin(), b.inputs.end());
	} else {
		a.inputs.push_back(literalOf(std::move(b)));
	}
	return a;
}

// True where one of a and b is.
Value Reader::odd(Value a, Value b) {
	const auto isOpen = [](const Value& v) { return v.kind == Value::Kind::Odd; };
	if (!isOpen(a) || (isOpen(b) && a.inputs.size() < b.inputs.size())) {
		std::swap(a, b);
	}
	if (!isOpen(a)) {
		a = {Value::Kind::Odd, false, {literalOf(std::move(a))}};
	}
	if (isOpen(b)) {
		a.inputs.insert(a.inputs.end(), b.inputs.begin(), b.inputs.end());
		a.negated = a.negated != b.negated;
	} else {
		a.inputs.push_back(literalOf(std::move(b)));
	}
	return a;
}

Value Reader::combined(char symbol, Value a, Value b) {
	a.single = b.single = OperandId::none();
	switch (symbol) {
	case '|':
	case '+':
		return any(std::move(a), std::move(b));
	case '^':
		return odd(std::move(a), std::move(b));
	case '-':
		return ~any(~std::move(a), std::move(b));
	default:  // & and *
		return ~any(~std::move(a), ~std::move(b));
	}
}

Value Reader::called(Frame& call) {
	std::vector<Literal> items = literalsOf(call.items);
	switch (call.callee) {
	case Callee::Xor:
		return {Value::Kind::Odd, false, std::move(items)};
	case Callee::AtLeast:
		return Value::of(out_.gates.atLeast(call.threshold, items));
	case Callee::Intersection:
		std::transform(items.begin(), items.end(), items.begin(), [](Literal l) { return ~l; });
		return {Value::Kind::Any, true, std::move(items)};
	case Callee::Difference:
		items.front() = ~items.front();
		return {Value::Kind::Any, true, std::move(items)};
	default:
		return {Value::Kind::Any, false, std::move(items)};
	}
}

}  // namespace

std::optional<ExpressionProblem> readExpression(const std::string& text, const OperandNames& names,
                                                WindingRule rule, Expression& out) {
	out = Expression{};
	try {
		Reader(text, names, rule, out).read();
	} catch (const ExpressionProblem& problem) {
		return problem;
	}
	return {};
}

std::vector<CellSet> cellsOf(const Expression& expression, const Arrangement& arrangement) {
	const auto& windings = arrangement.cells.windings;
	std::vector<CellSet> sets(expression.statements.size(), CellSet(windings.size(), 0));
	GateEvaluator evaluator(expression.gates, expression.operands.size());
	for (std::size_t cell = 0; cell < windings.size(); ++cell) {
		evaluator.goTo(windings[cell]);
		for (std::size_t s = 0; s < sets.size(); ++s) {
			sets[s][cell] = evaluator.isTrue(expression.statements[s].truth) ? 1 : 0;
		}
	}
	return sets;
}

}  // namespace index_boolean
