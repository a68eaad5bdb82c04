// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Half-planes around a line, given by their places on a circle of whole numbers: what order they
// have is known, whatever a hint says about their angles.
#include "vcg_ext/arrange/radial_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace index_boolean;

namespace {

constexpr int kCircle = 1000;  // places; an even number, so that each has an opposite one

// The order of half-planes at these places, and how many turns were asked for.
struct Sorted {
	std::vector<RadialPlace> places;
	std::size_t turns = 0;
};

template <class Angle>
Sorted sortCircle(const std::vector<int>& circle, Angle&& angle) {
	Sorted out;
	const auto turn = [&](std::uint32_t i, std::uint32_t j) {
		++out.turns;
		const int ahead = (circle[j] - circle[i] + kCircle) % kCircle;
		return ahead % (kCircle / 2) == 0 ? 0 : (ahead < kCircle / 2 ? 1 : -1);
	};
	const auto sameSide = [&](std::uint32_t j) { return circle[0] == circle[j]; };
	sortRadially(circle.size(), turn, sameSide, angle, out.places);
	return out;
}

// Each place once round from the first on, equal ones in one slot.
void expectInOrder(const std::vector<int>& circle, const std::vector<RadialPlace>& places) {
	ASSERT_EQ(places.size(), circle.size());
	const auto ahead = [&](const RadialPlace& p) {
		return (circle[p.index] - circle[0] + kCircle) % kCircle;
	};
	EXPECT_EQ(ahead(places[0]), 0);
	for (std::size_t i = 1; i < places.size(); ++i) {
		ASSERT_LE(ahead(places[i - 1]), ahead(places[i]));
		ASSERT_EQ(places[i].slot - places[i - 1].slot,
		          ahead(places[i - 1]) == ahead(places[i]) ? 0U : 1U);
	}
}

std::vector<int> randomCircle(std::mt19937& random, std::size_t n) {
	std::vector<int> circle;
	for (std::size_t i = 0; i < n; ++i) {
		circle.push_back(static_cast<int>(random() % kCircle));
	}
	return circle;
}

}  // namespace

TEST(RadialOrder, anglesThatAreWrongDecideNothing) {
	const std::uint32_t seed = 18;
	SCOPED_TRACE(seed);
	std::mt19937 random(seed);
	for (const std::size_t n : {1U, 2U, 15U, 16U, 17U, 100U, 500U}) {
		const std::vector<int> circle = randomCircle(random, n);
		const auto right = [&](std::uint32_t i) { return circle[i] / double{kCircle}; };
		const auto offset = [&](std::uint32_t i) { return std::fmod(right(i) + 0.3, 1.0); };
		const auto wrong = [&](std::uint32_t i) { return std::fmod(i * 0.618, 1.0); };
		const auto nothing = [](std::uint32_t) { return 0.0; };
		expectInOrder(circle, sortCircle(circle, right).places);
		expectInOrder(circle, sortCircle(circle, offset).places);
		expectInOrder(circle, sortCircle(circle, wrong).places);
		expectInOrder(circle, sortCircle(circle, nothing).places);
	}
}

TEST(RadialOrder, anglesThatAreRightSpareTurns) {
	std::mt19937 random(18);
	const std::vector<int> circle = randomCircle(random, 500);
	const auto right = [&](std::uint32_t i) { return circle[i] / double{kCircle}; };
	EXPECT_LE(sortCircle(circle, right).turns, 3 * circle.size());
}

TEST(RadialOrder, anglesGoCounterClockwiseAgainstTheLine) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		Point end{0, 0, 0};
		end[axis] = 2;
		const AngleHint hint({0, 0, 0}, end);
		const auto angleOf = [&](double x, double y) {
			Point p{};
			p[(axis + 1) % 3] = x;
			p[(axis + 2) % 3] = y;
			return hint(p);
		};
		const double start = angleOf(1, 0);
		const auto fromStart = [&](double x, double y) {
			return std::fmod(angleOf(x, y) - start + 1, 1.0);
		};
		EXPECT_DOUBLE_EQ(fromStart(0, 1), 0.25);
		EXPECT_DOUBLE_EQ(fromStart(-1, 0), 0.5);
		EXPECT_DOUBLE_EQ(fromStart(0, -1), 0.75);
	}
}
