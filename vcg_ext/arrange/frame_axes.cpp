// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Of a sample of faces it is told how many pairs of all faces would have boxes that meet, if faces
// lay anywhere. If there are many, axes are tried that the largest boxes' own faces have: the
// longer of the sides that are no diagonal, and the normal.
#include "vcg_ext/arrange/frame_axes.h"

#include "vcg_ext/base/vectors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace index_boolean {

namespace {

constexpr std::size_t kSamples = 512;
constexpr std::size_t kTried = 6;        // faces whose axes are tried
constexpr double kFewPairs = 8;          // a face: neighbours' boxes meet anyway
constexpr double kWorthwhile = 1.0 / 4;  // turning takes longer, and widens boxes by a hair

using Corners = std::array<Point, 3>;

constexpr Axes kGivenAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// Corners of some faces, in a cube from -1 to 1.
std::vector<Corners> sampleFaces(const FacesView& faces, const BoundingBox& box, double scale) {
	constexpr std::uint64_t kStep =
	    0x9E3779B97F4A7C15U;  // spreads; a stride could see one kind only
	const Point centre = box.centre();
	std::vector<Corners> samples(kSamples);
	std::uint64_t state = 0;
	for (Corners& sample : samples) {
		state += kStep;
		const IndexTriangle face = faces[static_cast<std::size_t>((state >> 32U) % faces.count())];
		for (std::size_t corner = 0; corner < 3; ++corner) {
			sample[corner] = times(minus(faces.point(face[corner]), centre), scale);
		}
	}
	return samples;
}

// From the least to the greatest of three numbers.
double spread(double a, double b, double c) {
	return std::max(std::max(a, b), c) - std::min(std::min(a, b), c);
}

// The sides of a face's box.
Point sidesOf(const Corners& corners, const Axes& axes) {
	Point sides;
	for (std::size_t k = 0; k < 3; ++k) {
		sides[k] =
		    spread(dot(axes[k], corners[0]), dot(axes[k], corners[1]), dot(axes[k], corners[2]));
	}
	return sides;
}

// The sides of the box of all.
Point sidesOfAll(const std::vector<Corners>& samples, const Axes& axes) {
	Point lo{2, 2, 2}, hi{-2, -2, -2};
	for (const Corners& corners : samples) {
		for (const Point& corner : corners) {
			for (std::size_t k = 0; k < 3; ++k) {
				const double x = dot(axes[k], corner);
				lo[k] = std::min(lo[k], x);
				hi[k] = std::max(hi[k], x);
			}
		}
	}
	return minus(hi, lo);
}

// Of all pairs of faces, the share whose boxes meet if they lie anywhere in the box of all.
double shareThatMeets(const std::vector<Corners>& samples, const Axes& axes) {
	const Point all = sidesOfAll(samples, axes);
	double sum = 0;
	Point before = sidesOf(samples.back(), axes);
	for (const Corners& corners : samples) {
		const Point sides = sidesOf(corners, axes);
		double chance = 1;
		for (std::size_t k = 0; k < 3; ++k) {
			const double both = sides[k] + before[k];
			chance *= both < all[k] ? both / all[k] : 1;
		}
		sum += chance;
		before = sides;
	}
	return sum / static_cast<double>(samples.size());
}

double length(const Point& v) { return std::sqrt(dot(v, v)); }

// Along the middle one of a face's sides, and its normal. \return false if it has no such
bool axesOf(const Corners& corners, Axes& axes) {
	std::array<Point, 3> sides{minus(corners[1], corners[0]), minus(corners[2], corners[1]),
	                           minus(corners[0], corners[2])};
	std::sort(sides.begin(), sides.end(),
	          [](const Point& a, const Point& b) { return dot(a, a) < dot(b, b); });
	axes[0] = times(sides[1], 1 / length(sides[1]));
	const Point normal = cross(axes[0], times(sides[2], 1 / length(sides[2])));
	const Point upright = minus(normal, times(axes[0], dot(axes[0], normal)));
	axes[2] = times(upright, 1 / length(upright));
	axes[1] = cross(axes[2], axes[0]);
	// No number if a side or the area is none. (Were they askew a little, the search would only see
	// larger boxes: what it needs of them is that their map has an inverse.)
	constexpr double kClose = 1e-6;
	return std::fabs(dot(axes[0], cross(axes[1], axes[2])) - 1) < kClose &&
	       std::fabs(dot(axes[0], axes[2])) < kClose;
}

}  // namespace

std::optional<Axes> guessFrameAxes(const FacesView& faces, const BoundingBox& box, double scale) {
	if (faces.count() < kSamples) {
		return {};
	}
	std::vector<Corners> samples = sampleFaces(faces, box, scale);
	const double given = shareThatMeets(samples, kGivenAxes);
	if (given * static_cast<double>(faces.count()) < 2 * kFewPairs) {
		return {};
	}
	const auto boxSize = [](const Corners& corners) {
		const Point sides = sidesOf(corners, kGivenAxes);
		return sides[0] * sides[1] * sides[2];
	};
	std::vector<Corners> tried = samples;
	std::partial_sort(tried.begin(), tried.begin() + kTried, tried.end(),
	                  [&](const Corners& a, const Corners& b) { return boxSize(a) > boxSize(b); });
	std::optional<Axes> best;
	double least = given * kWorthwhile;
	for (std::size_t i = 0; i < kTried; ++i) {
		Axes axes;
		if (axesOf(tried[i], axes)) {
			if (const double share = shareThatMeets(samples, axes); share < least) {
				least = share;
				best = axes;
			}
		}
	}
	return best;
}

}  // namespace index_boolean
