// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: values at the three corners of a face and a point's weights; out: the value at the point.
// Guarantee: corners of weight 0 have no say; where all others have one value, that is the result,
// so that labels and constants stay as they are.
#pragma once

#include <host_document.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace index_boolean {

using Weights = std::array<double, 3>;

// Principal directions and curvatures.
struct CurvatureValue {
	Point3m direction1{0, 0, 0}, direction2{0, 0, 0};
	Scalarm k1 = 0, k2 = 0;

	friend bool operator==(const CurvatureValue& a, const CurvatureValue& b) {
		return a.direction1 == b.direction1 && a.direction2 == b.direction2 && a.k1 == b.k1 &&
		       a.k2 == b.k2;
	}
};

// The weighted mean of what `part` gives of each value that has a weight.
template <class Value, class Part>
double meanOf(const std::array<Value, 3>& values, const Weights& weights, Part&& part) {
	double sum = 0;
	for (std::size_t i = 0; i < 3; ++i) {
		if (weights[i] > 0) {
			sum += weights[i] * static_cast<double>(part(values[i]));
		}
	}
	return sum;
}

inline double weightedMean(const std::array<double, 3>& values, const Weights& weights) {
	return meanOf(values, weights, [](double v) { return v; });
}

inline float weightedMean(const std::array<float, 3>& values, const Weights& weights) {
	return static_cast<float>(meanOf(values, weights, [](float v) { return v; }));
}

template <class Scalar>
vcg::Point3<Scalar> weightedMean(const std::array<vcg::Point3<Scalar>, 3>& values,
                                 const Weights& weights) {
	vcg::Point3<Scalar> mean;
	for (int axis = 0; axis < 3; ++axis) {
		mean[axis] = static_cast<Scalar>(
		    meanOf(values, weights, [axis](const vcg::Point3<Scalar>& p) { return p[axis]; }));
	}
	return mean;
}

inline vcg::Color4b weightedMean(const std::array<vcg::Color4b, 3>& values,
                                 const Weights& weights) {
	vcg::Color4b mean;
	for (int channel = 0; channel < 4; ++channel) {
		const double value =
		    meanOf(values, weights, [channel](const vcg::Color4b& c) { return c[channel]; });
		mean[channel] = static_cast<unsigned char>(std::clamp(std::lround(value), 0L, 255L));
	}
	return mean;
}

// Coordinates in different textures have no mean: the nearest corner's texture is taken.
template <class Scalar>
vcg::TexCoord2<Scalar, 1> weightedMean(const std::array<vcg::TexCoord2<Scalar, 1>, 3>& values,
                                       const Weights& weights) {
	using TexCoord = vcg::TexCoord2<Scalar, 1>;
	const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
	TexCoord mean = values[static_cast<std::size_t>(nearest)];
	mean.U() =
	    static_cast<Scalar>(meanOf(values, weights, [](const TexCoord& t) { return t.U(); }));
	mean.V() =
	    static_cast<Scalar>(meanOf(values, weights, [](const TexCoord& t) { return t.V(); }));
	return mean;
}

// A principal direction and its opposite are the same one: they are turned the same way first.
inline CurvatureValue weightedMean(std::array<CurvatureValue, 3> values, const Weights& weights) {
	const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
	const CurvatureValue reference = values[static_cast<std::size_t>(nearest)];
	std::array<Point3m, 3> first, second;
	for (std::size_t i = 0; i < 3; ++i) {
		const auto along = [](const Point3m& v, const Point3m& w) { return v * w < 0 ? -v : v; };
		first[i] = along(values[i].direction1, reference.direction1);
		second[i] = along(values[i].direction2, reference.direction2);
	}
	CurvatureValue mean;
	mean.direction1 = weightedMean(first, weights).Normalize();
	mean.direction2 = weightedMean(second, weights).Normalize();
	mean.k1 =
	    static_cast<Scalarm>(meanOf(values, weights, [](const CurvatureValue& v) { return v.k1; }));
	mean.k2 =
	    static_cast<Scalarm>(meanOf(values, weights, [](const CurvatureValue& v) { return v.k2; }));
	return mean;
}

// An element with a weight is selected at the point if all that have one are.
inline bool weightedMean(const std::array<bool, 3>&, const Weights&) { return false; }

// The value at the point.
template <class Value>
Value mixed(const std::array<Value, 3>& values, const Weights& weights) {
	std::size_t first = 0;
	while (first < 2 && !(weights[first] > 0)) {
		++first;
	}
	bool isConstant = true;
	for (std::size_t i = first + 1; i < 3; ++i) {
		isConstant = isConstant && (!(weights[i] > 0) || values[i] == values[first]);
	}
	return isConstant ? values[first] : weightedMean(values, weights);
}

}  // namespace index_boolean
