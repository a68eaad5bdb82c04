// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the half-planes of faces around one line; out: their cyclic order.
// Guarantee: decided by signs of input corners against input planes; half-planes in one place are
// told from opposite ones exactly. Any contact: crossing, tangential, along edges, coplanar.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

#include <algorithm>
#include <tuple>

namespace index_boolean {

// One half-plane that ends in the line: the part of a face to the left or right of it.
struct HalfPlane {
	FaceId face;
	bool left;
};

// Where one of several half-planes comes in their order around a line. Those in one place have the
// same slot.
struct RadialPlace {
	std::uint32_t index;
	std::uint32_t slot;
};

// Sorts places by the sectors of their half-planes, and within them by angles from 0 to 1 turn.
template <class Sector, class Angle>
void sortByAngles(const std::vector<Sector>& sector, Angle&& angle, std::vector<RadialPlace>& out) {
	struct Key {
		Sector sector;
		double angle;
		std::uint32_t index;
	};
	std::vector<Key> keys;
	keys.reserve(out.size());
	const double start = angle(0u);
	for (const RadialPlace place : out) {
		const double fromStart = angle(place.index) - start;
		keys.push_back(
		    {sector[place.index], fromStart < 0 ? fromStart + 1 : fromStart, place.index});
	}
	std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
		return std::tie(a.sector, a.angle, a.index) < std::tie(b.sector, b.angle, b.index);
	});
	for (std::size_t i = 0; i < out.size(); ++i) {
		out[i].index = keys[i].index;
	}
}

// Sorts n half-planes counter-clockwise, seen against the line's direction, from the first on.
// \param turn     turn(i, j): +1 if j lies less than half a turn counter-clockwise of i, -1 if
//                 clockwise, 0 if both lie in one plane
// \param sameSide sameSide(j), asked where turn(0, j) is 0: j lies where the first one does, not
//                 opposite to it
// \param angle    angle(i): about the angle of i, in turns from any direction on. It decides
//                 nothing, but where it sorts rightly no more turns are asked for
// Complexity: O(n) turns where all angles are right, else O(n log n).
template <class Turn, class SameSide, class Angle>
void sortRadially(std::size_t n, Turn&& turn, SameSide&& sameSide, Angle&& angle,
                  std::vector<RadialPlace>& out) {
	enum Sector : std::uint8_t { Same, BeforeOpposite, Opposite, AfterOpposite };
	const auto sectorOf = [&](std::uint32_t i) {
		const int side = i == 0 ? 0 : turn(0u, i);
		if (side != 0) {
			return side > 0 ? BeforeOpposite : AfterOpposite;
		}
		return i == 0 || sameSide(i) ? Same : Opposite;
	};
	std::vector<Sector> sector;
	sector.reserve(n);
	out.clear();
	out.reserve(n);
	for (std::uint32_t i = 0; i < n; ++i) {
		sector.push_back(sectorOf(i));
		out.push_back({i, 0});
	}
	const auto before = [&](RadialPlace a, RadialPlace b) {
		if (sector[a.index] != sector[b.index]) {
			return sector[a.index] < sector[b.index];
		}
		return sector[a.index] % 2 == 1 && turn(a.index, b.index) > 0;
	};
	// False if the places are not sorted.
	const auto fillSlots = [&] {
		bool areSorted = true;
		for (std::size_t i = 1; i < out.size(); ++i) {
			const std::uint32_t a = out[i - 1].index, b = out[i].index;
			const bool together = sector[a] == sector[b];
			const int step = !together ? 1 : (sector[a] % 2 == 0 ? 0 : turn(a, b));
			areSorted = areSorted && step >= 0;
			out[i].slot = out[i - 1].slot + (step == 0 ? 0 : 1);
		}
		return areSorted;
	};
	constexpr std::size_t kMany = 16;
	if (n >= kMany) {
		sortByAngles(sector, angle, out);
	}
	if (n < kMany || !fillSlots()) {
		std::sort(out.begin(), out.end(), before);
		if (!out.empty()) {
			out[0].slot = 0;
			fillSlots();
		}
	}
}

// Angles about a line, in turns, for sortRadially.
class AngleHint {
public:
	AngleHint(const Point& begin, const Point& end);
	// Of a point off the line. O(1).
	double operator()(const Point& p) const;

private:
	Point begin_;
	Point u_{}, v_{};  // across the line, counter-clockwise as seen against it
};

// Sorts half-planes around the line through two vertices, as sortRadially does.
// \return false if one of the faces does not reach its side of the line; places then mean nothing
// Complexity: O(k log k) for k half-planes.
bool sortAround(const Arrangement& arrangement, VertexId begin, VertexId end,
                const std::vector<HalfPlane>& halfPlanes, std::vector<RadialPlace>& places);

}  // namespace index_boolean
