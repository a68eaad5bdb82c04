// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an expression says of a place, as a network of gates: in: the winding number of each operand
// there; out: the truth of each literal.
// Guarantee: a gate counts its true inputs, so one that a place has in common with the place before
// is not asked again: an evaluation costs what has changed (and one comparison an operand), however
// long the expression is.
#pragma once

#include "vcg_ext/base/per_operand.h"

#include <map>
#include <queue>
#include <tuple>

namespace index_boolean {

using GateId = Id<struct GateTag>;

// A gate, or its contrary.
struct Literal {
	GateId gate;
	bool negated;

	Literal operator~() const { return {gate, !negated}; }
	friend bool operator==(Literal a, Literal b) {
		return a.gate == b.gate && a.negated == b.negated;
	}
};

// What is asked of one operand's winding number.
enum class WindingTest : std::uint8_t { Nonzero, Positive, Odd, AtLeast };

struct Leaf {
	OperandId operand;
	WindingTest test;
	std::int32_t least = 0;  // AtLeast
};

// Gates without end: each is made of those before it. A leaf is one gate, however often it is asked
// for.
class GateNetwork {
public:
	// Complexity: O(log n).
	Literal leaf(const Leaf& leaf);

	// True where at least so many of the inputs are. Complexity: O(k) for k inputs.
	Literal atLeast(std::size_t count, const std::vector<Literal>& inputs);

	// True where an odd number of the inputs is.
	Literal odd(const std::vector<Literal>& inputs);

	// Whether it is true where all winding numbers are 0.
	bool isTrueOutside(Literal literal) const {
		return (at(gates_, literal.gate).isTrueOutside != 0) != literal.negated;
	}

	// Whether no more is asked of an operand than if its winding number is odd.
	bool asksParityOnly(OperandId operand) const;

private:
	friend class GateEvaluator;

	struct Gate {
		std::uint32_t firstInput, inputCount;  // among inputs_; a leaf has none
		std::uint32_t threshold;               // kParity: an odd number
		std::uint8_t isTrueOutside;
	};
	static constexpr std::uint32_t kParity = kNone;

	Literal add(std::uint32_t threshold, const std::vector<Literal>& inputs);

	std::vector<Gate> gates_;
	std::vector<Literal> inputs_;
	std::map<std::tuple<OperandId, WindingTest, std::int32_t>, GateId> leaves_;  // by operand
};

// Goes from place to place.
class GateEvaluator {
public:
	// \param gates borrowed. O(n) for all gates and inputs. Throws std::bad_alloc.
	explicit GateEvaluator(const GateNetwork& gates, std::size_t operands);

	// \param windings of all operands. Complexity: above.
	void goTo(const PerOperand<std::int32_t>& windings);

	bool isTrue(Literal literal) const {
		return (at(isTrue_, literal.gate) != 0) != literal.negated;
	}

private:
	struct LeafGate {
		WindingTest test;
		std::int32_t least;
		GateId gate;
	};

	void set(GateId gate, bool isTrue);
	void settle();

	const GateNetwork& gates_;
	std::vector<std::uint32_t> counts_;  // per gate: its true inputs
	std::vector<std::uint8_t> isTrue_, isQueued_;
	// Per gate, the gates that it is an input of, as often as it is: readers_[firstReader_[gate] ..
	// next one's).
	std::vector<std::uint32_t> firstReader_;
	std::vector<Literal> readers_;  // negated, if the reader reads its contrary
	// Per operand: leafGates_[firstLeaf_[operand] .. next one's).
	std::vector<std::uint32_t> firstLeaf_;
	std::vector<LeafGate> leafGates_;
	std::vector<std::int32_t> windings_;  // at the place
	// Gates whose counts have changed; the first made comes first, so its inputs are settled.
	std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> changed_;
};

}  // namespace index_boolean
