// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operands by number. Two are the usual case, so values of two operands lie in the object itself,
// without an allocation; more lie in one allocated array.
#pragma once

#include "vcg_ext/base/ids.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace index_boolean {

// Operand 0 is the first one given (A), operand 1 the second (B).
using OperandId = Id<struct OperandTag>;

constexpr OperandId kFirst{0};
constexpr OperandId kSecond{1};

// The other one of two operands. \pre the operand is kFirst or kSecond
constexpr OperandId otherOf(OperandId operand) { return {1 - operand.value}; }

// All operands of a run, for range-based loops.
class Operands {
public:
	class Iterator {
	public:
		explicit constexpr Iterator(std::uint32_t value) : value_(value) {}
		constexpr OperandId operator*() const { return {value_}; }
		constexpr Iterator& operator++() {
			++value_;
			return *this;
		}
		friend constexpr bool operator!=(Iterator a, Iterator b) { return a.value_ != b.value_; }

	private:
		std::uint32_t value_;
	};

	explicit constexpr Operands(std::size_t count) : count_(static_cast<std::uint32_t>(count)) {}

	constexpr Iterator begin() const { return Iterator(0); }
	constexpr Iterator end() const { return Iterator(count_); }

private:
	std::uint32_t count_;
};

// One value for each operand. Complexity: as an array.
template <class T>
class PerOperand {
public:
	// \param count of operands, each with a value of its own, as T{} gives it
	explicit PerOperand(std::size_t count = 2) : values_(count) {}
	PerOperand(std::initializer_list<T> values) : values_(values) {}

	T& operator[](OperandId operand) { return values_[operand.value]; }
	const T& operator[](OperandId operand) const { return values_[operand.value]; }

	std::size_t size() const { return values_.size(); }
	Operands operands() const { return Operands(values_.size()); }
	auto begin() { return values_.begin(); }
	auto end() { return values_.end(); }
	auto begin() const { return values_.begin(); }
	auto end() const { return values_.end(); }

	friend bool operator==(const PerOperand& a, const PerOperand& b) {
		return std::equal(a.begin(), a.end(), b.begin(), b.end());
	}

private:
	boost::container::small_vector<T, 2> values_;
};

// Where each operand's elements begin in a common numbering, and where the last one's end.
class OperandOffsets {
public:
	// Of a number of operands without elements.
	explicit OperandOffsets(std::size_t operands = 2) : begins_(operands + 1, 0) {}

	std::size_t count() const { return begins_.size() - 1; }
	Operands operands() const { return Operands(count()); }
	std::uint32_t begin(OperandId operand) const { return begins_[operand.value]; }
	std::uint32_t end(OperandId operand) const { return begins_[operand.value + 1]; }
	std::uint32_t size(OperandId operand) const { return end(operand) - begin(operand); }
	std::uint32_t total() const { return begins_.back(); }

	// The elements of an operand end there; those behind it begin there, unless they are set.
	// \pre called for one operand after another
	void setEnd(OperandId operand, std::size_t end) {
		std::fill(begins_.begin() + operand.value + 1, begins_.end(),
		          static_cast<std::uint32_t>(end));
	}

	// The operand of an element. Complexity: one comparison for two operands, else O(log N).
	OperandId operandOf(std::uint32_t element) const {
		if (begins_.size() == 3) {
			return element < begins_[1] ? kFirst : kSecond;
		}
		const auto behind = std::upper_bound(begins_.begin() + 1, begins_.end() - 1, element);
		return makeId<OperandTag>(static_cast<std::size_t>(behind - begins_.begin()) - 1);
	}

private:
	boost::container::small_vector<std::uint32_t, 3> begins_;
};

}  // namespace index_boolean
