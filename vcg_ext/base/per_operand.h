// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operands by number. Two are the usual case: their values lie in the object itself, without an
// allocation; those of more operands lie in one allocated array.
#pragma once

#include "vcg_ext/base/ids.h"
#include "vcg_ext/base/status.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <vector>

namespace index_boolean {

// Operand 0 is the first one given (A), operand 1 the second (B).
using OperandId = Id<struct OperandTag>;

constexpr OperandId kFirst{0};
constexpr OperandId kSecond{1};

// What a Status says of an operand.
constexpr int numberOf(OperandId operand) { return static_cast<int>(operand.value); }

// The other one of two operands. \pre the operand is kFirst or kSecond
constexpr OperandId otherOf(OperandId operand) { return {1 - operand.value}; }

// All operands of a run, for range-based loops.
class Operands {
public:
	class Iterator {
	public:
		using iterator_category = std::input_iterator_tag;
		using value_type = OperandId;
		using difference_type = std::ptrdiff_t;
		using pointer = const OperandId*;
		using reference = OperandId;

		explicit constexpr Iterator(std::uint32_t value) : value_(value) {}
		constexpr OperandId operator*() const { return {value_}; }
		constexpr Iterator& operator++() {
			++value_;
			return *this;
		}
		friend constexpr bool operator==(Iterator a, Iterator b) { return a.value_ == b.value_; }
		friend constexpr bool operator!=(Iterator a, Iterator b) { return a.value_ != b.value_; }

	private:
		std::uint32_t value_;
	};

	explicit constexpr Operands(std::size_t count) : count_(static_cast<std::uint32_t>(count)) {}

	constexpr std::size_t count() const { return count_; }
	constexpr Iterator begin() const { return Iterator(0); }
	constexpr Iterator end() const { return Iterator(count_); }

private:
	std::uint32_t count_;
};

// Calls body(operand), which returns a Status, for one operand after another until one is not Ok.
// \return that status, or Ok
template <class Body>
Status forEachOperand(Operands operands, Body&& body) {
	Status status;
	for (const OperandId operand : operands) {
		status = body(operand);
		if (!status.ok()) {
			break;
		}
	}
	return status;
}

// One value for each operand. Complexity: as an array.
template <class T>
class PerOperand {
	struct Slot {  // so that bool is a T like any other
		T value{};
	};

	template <class AnySlot, class Value>
	class SlotIterator {
	public:
		using iterator_category = std::forward_iterator_tag;
		using value_type = T;
		using difference_type = std::ptrdiff_t;
		using pointer = Value*;
		using reference = Value&;

		explicit SlotIterator(AnySlot* slot) : slot_(slot) {}
		Value& operator*() const { return slot_->value; }
		Value* operator->() const { return &slot_->value; }
		SlotIterator& operator++() {
			++slot_;
			return *this;
		}
		friend bool operator==(SlotIterator a, SlotIterator b) { return a.slot_ == b.slot_; }
		friend bool operator!=(SlotIterator a, SlotIterator b) { return a.slot_ != b.slot_; }

	private:
		AnySlot* slot_;
	};

public:
	PerOperand() : PerOperand(std::size_t{2}) {}
	// \param count of operands, each with a value of its own, as T{} gives it
	explicit PerOperand(std::size_t count) : more_(count > 2 ? count : 0), count_(count) {}
	PerOperand(std::initializer_list<T> values) : PerOperand(values.size()) {
		std::copy(values.begin(), values.end(), begin());
	}

	T& operator[](OperandId operand) { return stored()[operand.value].value; }
	const T& operator[](OperandId operand) const { return stored()[operand.value].value; }

	std::size_t size() const { return count_; }
	Operands operands() const { return Operands(count_); }
	auto begin() { return SlotIterator<Slot, T>(stored()); }
	auto end() { return SlotIterator<Slot, T>(stored() + count_); }
	auto begin() const { return SlotIterator<const Slot, const T>(stored()); }
	auto end() const { return SlotIterator<const Slot, const T>(stored() + count_); }

	friend bool operator==(const PerOperand& a, const PerOperand& b) {
		return std::equal(a.begin(), a.end(), b.begin(), b.end());
	}

private:
	Slot* stored() { return count_ > 2 ? more_.data() : few_.data(); }
	const Slot* stored() const { return count_ > 2 ? more_.data() : few_.data(); }

	std::array<Slot, 2> few_{};
	std::vector<Slot> more_;  // instead, of more than two
	std::size_t count_;
};

// Where each operand's elements begin in a common numbering, and where the last one's end.
class OperandOffsets {
public:
	OperandOffsets() = default;
	// Of a number of operands without elements.
	explicit OperandOffsets(std::size_t operands) : ends_(operands) {}
	// \param ends of each operand
	OperandOffsets(std::initializer_list<std::uint32_t> ends) : ends_(ends) {}

	Operands operands() const { return ends_.operands(); }
	std::uint32_t begin(OperandId operand) const {
		return operand == kFirst ? 0 : ends_[{operand.value - 1}];
	}
	std::uint32_t end(OperandId operand) const { return ends_[operand]; }
	std::uint32_t size(OperandId operand) const { return end(operand) - begin(operand); }
	std::uint32_t total() const { return ends_[makeId<OperandTag>(ends_.size() - 1)]; }

	// The elements of an operand end there; those behind it have none, unless they are set.
	// \pre called for one operand after another
	void setEnd(OperandId operand, std::size_t end) {
		for (const OperandId behind : operands()) {
			if (!(behind < operand)) {
				ends_[behind] = static_cast<std::uint32_t>(end);
			}
		}
	}

	// The operand of an element. Complexity: one comparison for two operands, else O(log N).
	OperandId operandOf(std::uint32_t element) const {
		if (ends_.size() == 2) {
			return element < ends_[kFirst] ? kFirst : kSecond;
		}
		OperandId first{0}, last = makeId<OperandTag>(ends_.size());
		while (first != last) {
			const OperandId middle{first.value + (last.value - first.value) / 2};
			if (ends_[middle] <= element) {
				first = {middle.value + 1};
			} else {
				last = middle;
			}
		}
		return first;
	}

	friend bool operator==(const OperandOffsets& a, const OperandOffsets& b) {
		return a.ends_ == b.ends_;
	}

private:
	PerOperand<std::uint32_t> ends_;
};

}  // namespace index_boolean
