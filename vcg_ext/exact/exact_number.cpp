// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/exact_number.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace index_boolean {

BoundedPair operator/(BoundedPair a, BoundedPair b) {
	const double divisor = std::fabs(b.high) - std::fabs(b.low) - b.bound;
	if (!(divisor > 0)) {
		return {0, 0, std::numeric_limits<double>::infinity()};
	}
	// Two steps of long division, then the remainder bounds the error of what was found.
	const double first = a.high / b.high;
	const BoundedPair rest = a - b * BoundedPair(first);
	const double second = rest.high / b.high;
	const BoundedPair left = rest - b * BoundedPair(second);
	double low;
	const double high = twoSum(first, second, low);
	const double error = (std::fabs(left.high) + std::fabs(left.low) + left.bound) / divisor;
	return {high, low, error * (1 + 4 * kRoundoff) * Bounded::kGrow + kUnderflow};
}

// By the bits of the double: as an integer of at most 53 bits, without trailing zeros.
Dyadic::Dyadic(double exact) : exponent_(0) {
	constexpr unsigned kFraction = 52;
	std::uint64_t bits = 0;
	static_assert(sizeof bits == sizeof exact);
	std::memcpy(&bits, &exact, sizeof bits);
	const auto biased = static_cast<std::int64_t>(bits >> kFraction & 0x7ff);
	const std::uint64_t fraction = bits & ((std::uint64_t{1} << kFraction) - 1);
	const std::uint64_t size = biased == 0 ? fraction : fraction | std::uint64_t{1} << kFraction;
	if (size != 0) {
		const int zeros = __builtin_ctzll(size);
		const auto mantissa = static_cast<std::int64_t>(size >> zeros);
		mantissa_ = std::signbit(exact) ? -mantissa : mantissa;
		exponent_ = (biased == 0 ? 1 : biased) - 1075 + zeros;
	}
}

Dyadic Dyadic::difference(double a, double b) {
	double lost;
	const double rounded = twoSum(a, -b, lost);
	return lost == 0 ? Dyadic(rounded) : Dyadic(a) - Dyadic(b);
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
	if (a.sign() == 0 || b.sign() == 0) {
		return a.sign() == 0 ? b : a;
	}
	const bool aIsFiner = a.exponent() <= b.exponent();
	const Dyadic& fine = aIsFiner ? a : b;
	const Dyadic& coarse = aIsFiner ? b : a;
	Dyadic::Integer sum = coarse.mantissa();
	sum <<= static_cast<unsigned>(coarse.exponent() - fine.exponent());
	sum += fine.mantissa();
	return {std::move(sum), fine.exponent()};
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) {
	return a + Dyadic(-b.mantissa(), b.exponent());
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
	return {Dyadic::Integer(a.mantissa() * b.mantissa()), a.exponent() + b.exponent()};
}

double roundedQuotient(const Dyadic& numerator, const Dyadic& denominator) {
	using Integer = Dyadic::Integer;
	if (numerator.sign() == 0) {
		return 0;
	}
	const bool negative = numerator.sign() * denominator.sign() < 0;
	Integer dividend = abs(numerator.mantissa());
	Integer divisor = abs(denominator.mantissa());
	// Shift so that the integer quotient has 64 or 65 bits.
	const auto bitsDividend = static_cast<std::int64_t>(msb(dividend));
	const auto bitsDivisor = static_cast<std::int64_t>(msb(divisor));
	const std::int64_t shift = 64 - (bitsDividend - bitsDivisor);
	if (shift > 0) {
		dividend <<= static_cast<unsigned>(shift);
	} else {
		divisor <<= static_cast<unsigned>(-shift);
	}
	Integer quotient;
	Integer remainder;
	divide_qr(dividend, divisor, quotient, remainder);
	bool sticky = remainder.sign() != 0;
	std::int64_t exponent = numerator.exponent() - denominator.exponent() - shift;
	// Keep 53 bits, or as many as a subnormal result has, and round to nearest, ties to even.
	const auto top = static_cast<std::int64_t>(msb(quotient));
	const std::int64_t lowestKept = std::max<std::int64_t>(top - 52, -1074 - exponent);
	if (lowestKept > top + 1) {
		return 0;  // below half of the smallest double
	}
	const auto drop = static_cast<unsigned>(lowestKept);  // at least 12: the quotient has 64 bits
	const bool half = bit_test(quotient, drop - 1);
	sticky = sticky || lsb(quotient) + 1 < drop;
	auto kept = static_cast<std::uint64_t>(Integer(quotient >> drop));
	kept += half && (sticky || (kept & 1) != 0) ? 1 : 0;
	exponent += lowestKept;
	const double size = exponent > 2000
	                        ? std::numeric_limits<double>::infinity()
	                        : std::ldexp(static_cast<double>(kept), static_cast<int>(exponent));
	return negative ? -size : size;
}

bool certainSum(double base, BoundedPair offset, double& rounded) {
	double error, lost, low;
	const double sum = twoSum(base, offset.high, error);
	const double rest = twoSum(error, offset.low, lost);
	const double high = twoSum(sum, rest, low);
	// true = high + low + lost +- bound; certain if both ends round to the same double.
	const double slack = (offset.bound + std::fabs(lost)) * (1 + 8 * kRoundoff) +
	                     std::fabs(low) * 4 * kRoundoff + kUnderflow;
	const double upper = high + (low + slack);
	const double lower = high + (low - slack);
	if (!(upper == lower)) {
		return false;
	}
	rounded = upper;
	return true;
}

}  // namespace index_boolean
