// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums of many fractions with small denominators, exactly.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace index_boolean::grid {

using Integer = boost::multiprecision::cpp_int;

// An exact fraction, in any terms.
class Rational {
public:
	Rational(std::int64_t integer = 0) : numerator_(integer), denominator_(1) {}
	// \pre denominator > 0
	Rational(Integer numerator, Integer denominator)
	    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {}

	friend Rational operator+(const Rational& a, const Rational& b) {
		return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
		        a.denominator_ * b.denominator_};
	}
	friend Rational operator-(const Rational& a, const Rational& b) { return a + b * -1; }
	friend Rational operator*(const Rational& a, std::int64_t factor) {
		return {a.numerator_ * factor, a.denominator_};
	}
	friend bool operator==(const Rational& a, const Rational& b) {
		return a.numerator_ * b.denominator_ == b.numerator_ * a.denominator_;
	}
	friend bool operator!=(const Rational& a, const Rational& b) { return !(a == b); }

	double toDouble() const {
		return Integer((numerator_ << 64) / denominator_).convert_to<double>() * 0x1p-64;
	}
	std::string text() const {
		const Integer divisor = gcd(numerator_, denominator_);
		return Integer(numerator_ / divisor).str() + '/' + Integer(denominator_ / divisor).str();
	}

private:
	Integer numerator_, denominator_;
};

// Collects fractions and adds them over their least common denominator, so that no reduction of
// large numbers is needed but the last.
class ExactSum {
public:
	// \pre denominator != 0
	void add(std::int64_t numerator, std::int64_t denominator) {
		if (numerator == 0) {
			return;
		}
		std::int64_t divisor = std::gcd(numerator, denominator);
		divisor = denominator < 0 ? -divisor : divisor;
		terms_.push_back({denominator / divisor, numerator / divisor});
	}

	Rational value() {
		std::sort(terms_.begin(), terms_.end(),
		          [](const Term& a, const Term& b) { return a.denominator < b.denominator; });
		Integer common = 1;
		for (std::size_t i = 0; i < terms_.size(); i = endOfEqual(i)) {
			const std::int64_t denominator = terms_[i].denominator;
			const auto rest = static_cast<std::int64_t>(common % denominator);
			common *= denominator / std::gcd(rest, denominator);
		}
		Integer numerator = 0;
		for (std::size_t i = 0; i < terms_.size();) {
			const std::size_t end = endOfEqual(i);
			Integer sum = 0;
			const Integer factor = common / terms_[i].denominator;
			for (; i < end; ++i) {
				sum += terms_[i].numerator;
			}
			numerator += sum * factor;
		}
		return {numerator, common};
	}

private:
	struct Term {
		std::int64_t denominator;  // positive
		std::int64_t numerator;
	};

	std::size_t endOfEqual(std::size_t i) const {
		const std::int64_t denominator = terms_[i].denominator;
		while (i < terms_.size() && terms_[i].denominator == denominator) {
			++i;
		}
		return i;
	}

	std::vector<Term> terms_;
};

}  // namespace index_boolean::grid
