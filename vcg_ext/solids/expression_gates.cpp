// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/solids/expression_gates.h"

#include <algorithm>

namespace index_boolean {

namespace {

bool passes(WindingTest test, std::int32_t least, std::int32_t winding) {
	switch (test) {
	case WindingTest::Positive:
		return winding > 0;
	case WindingTest::Odd:
		return winding % 2 != 0;
	case WindingTest::AtLeast:
		return winding >= least;
	case WindingTest::Nonzero:
		break;
	}
	return winding != 0;
}

}  // namespace

Literal GateNetwork::leaf(const Leaf& leaf) {
	const std::int32_t least = leaf.test == WindingTest::AtLeast ? leaf.least : 0;
	const auto [known, isNew] =
	    leaves_.emplace(std::tuple(leaf.operand, leaf.test, least), GateId::none());
	if (isNew) {
		known->second = makeId<GateTag>(gates_.size());
		gates_.push_back({0, 0, 0, static_cast<std::uint8_t>(passes(leaf.test, least, 0))});
	}
	return {known->second, false};
}

Literal GateNetwork::add(std::uint32_t threshold, const std::vector<Literal>& inputs) {
	const auto isTrue = [this](Literal input) { return isTrueOutside(input); };
	const auto count = std::count_if(inputs.begin(), inputs.end(), isTrue);
	const bool isTrueOutside = threshold == kParity ? count % 2 != 0 : count >= threshold;
	gates_.push_back({static_cast<std::uint32_t>(inputs_.size()),
	                  static_cast<std::uint32_t>(inputs.size()), threshold,
	                  static_cast<std::uint8_t>(isTrueOutside)});
	inputs_.insert(inputs_.end(), inputs.begin(), inputs.end());
	return {makeId<GateTag>(gates_.size() - 1), false};
}

Literal GateNetwork::atLeast(std::size_t count, const std::vector<Literal>& inputs) {
	// More than all are never true.
	return add(static_cast<std::uint32_t>(std::min(count, inputs.size() + 1)), inputs);
}

Literal GateNetwork::odd(const std::vector<Literal>& inputs) { return add(kParity, inputs); }

bool GateNetwork::asksParityOnly(OperandId operand) const {
	const auto first = leaves_.lower_bound({operand, WindingTest::Nonzero, 0});
	bool isAsked = false;
	for (auto leaf = first; leaf != leaves_.end() && std::get<0>(leaf->first) == operand; ++leaf) {
		if (std::get<1>(leaf->first) != WindingTest::Odd) {
			return false;
		}
		isAsked = true;
	}
	return isAsked;
}

GateEvaluator::GateEvaluator(const GateNetwork& gates, std::size_t operands)
    : gates_(gates), counts_(gates.gates_.size(), 0), isTrue_(gates.gates_.size(), 0),
      isQueued_(gates.gates_.size(), 0), firstReader_(gates.gates_.size() + 1, 0),
      readers_(gates.inputs_.size()), firstLeaf_(operands + 1, 0), windings_(operands, 0) {
	for (const Literal input : gates.inputs_) {
		++firstReader_[input.gate.value + 1];
	}
	for (std::size_t i = 1; i < firstReader_.size(); ++i) {
		firstReader_[i] += firstReader_[i - 1];
	}
	std::vector<std::uint32_t> next(firstReader_.begin(), firstReader_.end());
	for (std::size_t g = 0; g < gates.gates_.size(); ++g) {
		const GateNetwork::Gate& gate = gates.gates_[g];
		isTrue_[g] = gate.isTrueOutside;
		for (std::uint32_t i = gate.firstInput; i < gate.firstInput + gate.inputCount; ++i) {
			const Literal input = gates.inputs_[i];
			readers_[at(next, input.gate)++] = {makeId<GateTag>(g), input.negated};
			counts_[g] += gates.isTrueOutside(input) ? 1 : 0;
		}
	}
	for (const auto& [leaf, gate] : gates.leaves_) {  // in the order of the operands
		const auto& [operand, test, least] = leaf;
		leafGates_.push_back({test, least, gate});
		firstLeaf_[operand.value + 1] = static_cast<std::uint32_t>(leafGates_.size());
	}
	for (std::size_t i = 1; i < firstLeaf_.size(); ++i) {
		firstLeaf_[i] = std::max(firstLeaf_[i], firstLeaf_[i - 1]);
	}
}

void GateEvaluator::goTo(const PerOperand<std::int32_t>& windings) {
	std::size_t operand = 0;
	for (const std::int32_t winding : windings) {
		if (winding != windings_[operand]) {
			windings_[operand] = winding;
			for (std::uint32_t i = firstLeaf_[operand]; i < firstLeaf_[operand + 1]; ++i) {
				const LeafGate& leaf = leafGates_[i];
				set(leaf.gate, passes(leaf.test, leaf.least, winding));
			}
		}
		++operand;
	}
	settle();
}

// Tells the readers of a gate if its truth has changed.
void GateEvaluator::set(GateId gate, bool isTrue) {
	if ((at(isTrue_, gate) != 0) == isTrue) {
		return;
	}
	at(isTrue_, gate) = isTrue ? 1 : 0;
	for (std::uint32_t i = at(firstReader_, gate); i < firstReader_[gate.value + 1]; ++i) {
		const Literal reader = readers_[i];
		std::uint32_t& count = at(counts_, reader.gate);
		count = isTrue != reader.negated ? count + 1 : count - 1;
		if (at(isQueued_, reader.gate) == 0) {
			at(isQueued_, reader.gate) = 1;
			changed_.push(reader.gate.value);
		}
	}
}

void GateEvaluator::settle() {
	while (!changed_.empty()) {
		const GateId gate{changed_.top()};
		changed_.pop();
		at(isQueued_, gate) = 0;
		const std::uint32_t threshold = at(gates_.gates_, gate).threshold;
		const std::uint32_t count = at(counts_, gate);
		set(gate, threshold == GateNetwork::kParity ? count % 2 != 0 : count >= threshold);
	}
}

}  // namespace index_boolean
