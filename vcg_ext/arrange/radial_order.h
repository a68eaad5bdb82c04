// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the half-planes of faces around one line; out: their cyclic order.
// Guarantee: decided by signs of input corners against input planes; half-planes in one place are
// told from opposite ones exactly. Any contact: crossing, tangential, along edges, coplanar.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

#include <algorithm>

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

// Sorts n half-planes counter-clockwise, seen against the line's direction, from the first on.
// \param turn     turn(i, j): +1 if j lies less than half a turn counter-clockwise of i, -1 if
//                 clockwise, 0 if both lie in one plane
// \param sameSide sameSide(j), asked where turn(0, j) is 0: j lies where the first one does, not
//                 opposite to it
// Complexity: O(n log n) turns.
template <class Turn, class SameSide>
void sortRadially(std::size_t n, Turn&& turn, SameSide&& sameSide, std::vector<RadialPlace>& out) {
	enum Sector : std::uint8_t { Same, BeforeOpposite, Opposite, AfterOpposite };
	const auto sectorOf = [&](std::uint32_t i) {
		const int side = i == 0 ? 0 : turn(0u, i);
		if (side != 0) {
			return side > 0 ? BeforeOpposite : AfterOpposite;
		}
		return i == 0 || sameSide(i) ? Same : Opposite;
	};
	std::vector<Sector> sector;
	out.clear();
	for (std::uint32_t i = 0; i < n; ++i) {
		sector.push_back(sectorOf(i));
		out.push_back({i, 0});
	}
	std::sort(out.begin(), out.end(), [&](RadialPlace a, RadialPlace b) {
		if (sector[a.index] != sector[b.index]) {
			return sector[a.index] < sector[b.index];
		}
		return sector[a.index] % 2 == 1 && turn(a.index, b.index) > 0;
	});
	for (std::size_t i = 1; i < out.size(); ++i) {
		const std::uint32_t a = out[i - 1].index, b = out[i].index;
		const bool same = sector[a] == sector[b] && (sector[a] % 2 == 0 || turn(a, b) == 0);
		out[i].slot = out[i - 1].slot + (same ? 0 : 1);
	}
}

// Sorts half-planes around the line through two vertices, as sortRadially does.
// \return false if one of the faces does not reach its side of the line; places then mean nothing
// Complexity: O(k log k) for k half-planes.
bool sortAround(const Arrangement& arrangement, VertexId begin, VertexId end,
                const std::vector<HalfPlane>& halfPlanes, std::vector<RadialPlace>& places);

}  // namespace index_boolean
