// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Three number types with the same operators, so that one formula serves every stage of a filter:
// Bounded (a double and a bound on its error), BoundedPair (a double-double and a bound), Dyadic
// (mantissa * 2^exponent, exact and of any size).
// Guarantee: sign() never errs; the bounded types answer kUnknownSign where their bound does not
// tell. Overflow ends as an infinity or NaN in value or bound, which is "unknown" too.
// Error bounds: a rounded sum errs by at most u|s|, a rounded product by u|p| plus an underflow
// term. Of double-doubles what each operation rounds off is computed, by error-free transformations
// (Dekker, Knuth): it is nothing at all where the true value fits, as it does for coordinates with
// few bits. So points that lie in one plane of a construction are told so without big integers.
// Complexity: O(1) for the bounded types, a few flops; of Dyadic, as of its integers' length.
#pragma once

#include "vcg_ext/base/sign_counts.h"
#include "vcg_ext/exact/ieee_arithmetic.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <cstdint>

namespace index_boolean {

constexpr int kUnknownSign = 2;

// Unit roundoff of double; and a term far above every underflow error of the products below that
// is itself a normal number (arithmetic on denormals is slow).
constexpr double kRoundoff = 1.0 / 9007199254740992.0;
constexpr double kUnderflow = 0x1p-1000;

// A double `value` with |true - value| <= bound. The factor kGrow covers the rounding of the bound
// itself.
struct Bounded {
	double value;
	double bound;

	explicit Bounded(double exact) : value(exact), bound(0) {}
	Bounded(double v, double b) : value(v), bound(b) {}

	// The correctly rounded value of an exact number.
	static Bounded fromRounded(double v) {
		return {v, std::fabs(v) * kRoundoff * kGrow + kUnderflow};
	}

	bool isZero() const { return value == 0 && bound == 0; }
	int sign() const;

	static constexpr double kGrow = 1.0 + 16 * kRoundoff;
};

inline int Bounded::sign() const {
	if (value > bound) {
		return 1;
	}
	if (value < -bound) {
		return -1;
	}
	return isZero() ? 0 : kUnknownSign;
}

inline Bounded operator+(Bounded a, Bounded b) {
	const double sum = a.value + b.value;
	return {sum, (a.bound + b.bound + kRoundoff * std::fabs(sum)) * Bounded::kGrow};
}

inline Bounded operator-(Bounded a, Bounded b) { return a + Bounded(-b.value, b.bound); }

inline Bounded operator*(Bounded a, Bounded b) {
	if (a.isZero() || b.isZero()) {
		return Bounded(0);
	}
	const double product = a.value * b.value;
	const double bound = std::fabs(a.value) * b.bound + a.bound * (std::fabs(b.value) + b.bound) +
	                     kRoundoff * std::fabs(product);
	return {product, bound * Bounded::kGrow + kUnderflow};
}

// a + b = sum + error, exactly.
inline double twoSum(double a, double b, double& error) {
	const double sum = a + b;
	const double bPart = sum - a;
	error = (a - (sum - bPart)) + (b - bPart);
	return sum;
}

#if defined(__MINGW32__) && !defined(__FMA__)
// The high half of the bits of a double, by a product with 2^27 + 1 (Veltkamp); not a number if
// that overflows.
inline double highHalf(double a) {
	const double scaled = 134217729.0 * a;
	return scaled - (scaled - a);
}

// a * b - product, by products of halves, each of which is a double (Dekker): mingw-w64's C library
// rounds a fused product twice, which loses bits of the error.
inline double errorByHalves(double a, double b, double product) {
	const double aHigh = highHalf(a), bHigh = highHalf(b);
	const double aLow = a - aHigh, bLow = b - bHigh;
	return ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
}
#endif

// a * b = product + error, exactly unless the error may be too small for a double.
inline double twoProduct(double a, double b, double& error) {
	const double product = a * b;
#if defined(__MINGW32__) && !defined(__FMA__)
	error = errorByHalves(a, b, product);
#else
	error = std::fma(a, b, -product);
#endif
	return product;
}

// A bound on what of a * b is lost to underflow, the product's error included.
inline double underflowOf(double a, double b) {
	constexpr double kErrorIsNormal = 0x1p-900;
	return std::fabs(a * b) > kErrorIsNormal || a == 0 || b == 0 ? 0 : kUnderflow;
}

// An unevaluated sum high + low (double-double) with |true - (high + low)| <= bound.
struct BoundedPair {
	double high;
	double low;
	double bound;

	explicit BoundedPair(double exact) : high(exact), low(0), bound(0) {}
	BoundedPair(double h, double l, double b) : high(h), low(l), bound(b) {}

	bool isZero() const { return high == 0 && low == 0 && bound == 0; }
	// Whether the number is just `high`, exactly; most differences of neighbours' coordinates are.
	bool isDouble() const { return low == 0 && bound == 0; }
	int sign() const;

	// a - b, which is exact.
	static BoundedPair difference(double a, double b) {
		const double high = a - b;
		const double part = high - a;
		return {high, (a - (high - part)) - (b + part), 0};
	}
};

inline int BoundedPair::sign() const {
	if (high - bound > std::fabs(low)) {
		return 1;
	}
	if (high + bound < -std::fabs(low)) {
		return -1;
	}
	return isZero() ? 0 : kUnknownSign;
}

inline BoundedPair operator+(BoundedPair a, BoundedPair b) {
	double highError, lowError, middleError, lost, low;
	const double highSum = twoSum(a.high, b.high, highError);
	const double lowSum = twoSum(a.low, b.low, lowError);
	const double middle = twoSum(highError, lowSum, middleError);
	const double high = twoSum(highSum, middle, low);
	low = twoSum(low, lowError + middleError, lost);
	const double roundedOff = std::fabs(lost) + kRoundoff * std::fabs(lowError + middleError);
	return {high, low, (a.bound + b.bound + roundedOff) * Bounded::kGrow};
}

inline BoundedPair operator-(BoundedPair a, BoundedPair b) {
	return a + BoundedPair(-b.high, -b.low, b.bound);
}

inline BoundedPair operator*(BoundedPair a, BoundedPair b) {
	if (a.isDouble() && b.isDouble()) {
		double error;
		const double product = twoProduct(a.high, b.high, error);
		return {product, error, underflowOf(a.high, b.high)};
	}
	if (a.isZero() || b.isZero()) {
		return BoundedPair(0);
	}
	double productError, firstError, secondError, crossError, lowError, low;
	const double product = twoProduct(a.high, b.high, productError);
	const double first = twoProduct(a.high, b.low, firstError);
	const double second = twoProduct(a.low, b.high, secondError);
	const double cross = twoSum(first, second, crossError);
	const double rest = twoSum(cross, productError, lowError);
	const double high = twoSum(product, rest, low);
	const double roundedOff = std::fabs(firstError) + std::fabs(secondError) +
	                          std::fabs(crossError) + std::fabs(lowError) +
	                          std::fabs(a.low * b.low);
	const double underflow = underflowOf(a.high, b.high) + underflowOf(a.high, b.low) +
	                         underflowOf(a.low, b.high) + underflowOf(a.low, b.low);
	const double sizeA = std::fabs(a.high) + std::fabs(a.low);
	const double sizeB = std::fabs(b.high) + std::fabs(b.low);
	const double carried = sizeA * b.bound + a.bound * (sizeB + b.bound);
	const double carriedUnderflow = a.bound == 0 && b.bound == 0 ? 0 : kUnderflow;
	return {high, low, (carried + roundedOff) * Bounded::kGrow + underflow + carriedUnderflow};
}

// The quotient; its bound is infinite where the divisor may be zero.
BoundedPair operator/(BoundedPair a, BoundedPair b);

// mantissa * 2^exponent, exact. Every finite double is one; sums and products are again.
class Dyadic {
public:
	// Numbers of up to 1024 bits live inside the object; longer ones are allocated.
	using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
	    1024, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked>>;

	explicit Dyadic(double exact);
	Dyadic(Integer mantissa, std::int64_t exponent)
	    : mantissa_(std::move(mantissa)), exponent_(exponent) {}

	// a - b: mostly a double, so that no integers are added. O(1).
	static Dyadic difference(double a, double b);

	int sign() const { return mantissa_.sign(); }
	const Integer& mantissa() const { return mantissa_; }
	std::int64_t exponent() const { return exponent_; }

private:
	Integer mantissa_;
	std::int64_t exponent_;
};

Dyadic operator+(const Dyadic& a, const Dyadic& b);
Dyadic operator-(const Dyadic& a, const Dyadic& b);
Dyadic operator*(const Dyadic& a, const Dyadic& b);

// numerator / denominator rounded to the nearest double, ties to even; subnormals and overflow to
// infinity as IEEE has them. \pre denominator.sign() != 0
double roundedQuotient(const Dyadic& numerator, const Dyadic& denominator);

// The double that base + offset rounds to, if the offset's bound allows no other.
// \param rounded written only on success. \return whether the rounding is certain
bool certainSum(double base, BoundedPair offset, double& rounded);

template <class Number>
struct NumberTag {
	using Type = Number;
};

// The sign of a formula (see decideSign) that doubles leave in doubt. Apart, so that it takes no
// registers from what is asked millions of times.
template <class Formula>
[[gnu::noinline]] int decideInDoubt(Predicate predicate, const Formula& formula) {
	if (const int sign = formula(NumberTag<BoundedPair>{}); sign != kUnknownSign) {
		countSign(predicate, DecidedBy::DoubleDouble);
		return sign;
	}
	countSign(predicate, DecidedBy::Integers);
	return formula(NumberTag<Dyadic>{});
}

// The sign of a formula, by the cheapest number type that can tell. `formula(NumberTag<N>{})`
// returns the sign as N sees it, kUnknownSign included; `predicate` is what is counted.
template <class Formula>
int decideSign(Predicate predicate, const Formula& formula) {
	if (const int sign = formula(NumberTag<Bounded>{}); sign != kUnknownSign) {
		countSign(predicate, DecidedBy::Double);
		return sign;
	}
	return decideInDoubt(predicate, formula);
}

// The product of two signs, either of which may be unknown.
constexpr int signProduct(int a, int b) {
	if (a == 0 || b == 0) {
		return 0;
	}
	return a == kUnknownSign || b == kUnknownSign ? kUnknownSign : a * b;
}

}  // namespace index_boolean
