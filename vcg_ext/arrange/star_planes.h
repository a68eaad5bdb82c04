// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces at one vertex; out: which two of them certainly meet properly. Nothing is supposed
// of the star: it may be open, of many sheets, folded.
//
// Each face lends three planes through the vertex: its own, and those that stand on it along its
// two sides there. Two faces meet properly if one of these planes has them on different sides, and
// what at least one of them has in the plane is the vertex, or an edge that both have: for all that
// they have in common lies in the plane.
// - The plane of face i: of j's two other corners those that are not i's lie strictly on one side.
// - The plane along i's side from the vertex to l: i's third corner lies strictly on one side, and
//   of j's two other corners those that are not l lie strictly on the other. (If j has i's third
//   corner, it does not.)
// Last, a plane across the way from the one face's middle to the other's, which has both strictly
// on its sides: of two faces with no other corner in common.
#pragma once

#include "vcg_ext/arrange/faces_view.h"

#include <array>
#include <vector>

namespace index_boolean {

// One star at a time. Reused, for its memory.
class StarPlanes {
public:
	static constexpr std::size_t kMostFaces = 64;

	// Takes a star. \param faces which have the vertex as a corner, and an area
	// \return false if there are too many of them, or they are too large or too small for doubles:
	// then no two can be asked for. Complexity: O(k^2) for k faces.
	bool take(const FacesView& surface, std::uint32_t vertex,
	          const std::vector<std::uint32_t>& faces);

	// Whether the i-th and the j-th face, which differ, certainly meet properly.
	// Complexity: O(1) if a face's own plane parts them, O(k) the first time that one does not.
	bool areParted(std::size_t i, std::size_t j) {
		return ownPlaneParts(i, j) || ownPlaneParts(j, i) || middlePlaneParts(i, j) ||
		       sidePlaneParts(i, j) || sidePlaneParts(j, i);
	}

private:
	using Corners = std::uint64_t;  // a set of the star's other corners, a bit each

	// One face: its corners but for the vertex, and sets of corners that are certainly where they
	// do not meet it.
	struct Planes {
		std::array<double, 3> normal, middle;
		Corners first, second;              // its corner at the one side, at the other
		Corners above, below;               // of its own plane
		Corners beyondFirst, beyondSecond;  // the plane along the one side, the other
		bool hasSides;                      // the last two are known
	};

	// Corners above and below a plane.
	struct Sides {
		Corners above, below;
	};

	static Corners both(const Planes& of) { return of.first | of.second; }

	bool ownPlaneParts(std::size_t face, std::size_t other) const {
		const Planes& of = planes_[face];
		const Corners own = both(planes_[other]) & ~both(of);
		return own != 0 && ((own & ~of.above) == 0 || (own & ~of.below) == 0);
	}

	bool sidePlaneParts(std::size_t face, std::size_t other) {
		if (!planes_[face].hasSides) {
			findSides(face);
		}
		const Planes& of = planes_[face];
		const Corners common = both(planes_[other]) & both(of),
		              own = both(planes_[other]) & ~common;
		return own != 0 && (((common & ~of.first) == 0 && (own & ~of.beyondFirst) == 0) ||
		                    ((common & ~of.second) == 0 && (own & ~of.beyondSecond) == 0));
	}

	bool middlePlaneParts(std::size_t i, std::size_t j) const;
	std::size_t indexOf(std::uint32_t corner);
	bool placeCorners(const FacesView& surface, std::uint32_t vertex);
	void findOwnPlane(std::size_t face);
	void findSides(std::size_t face);
	Sides sidesOf(const std::array<double, 3>& normal, const std::array<double, 3>& size) const;
	Corners beyond(const std::array<double, 3>& normal, std::size_t along, Corners third) const;

	std::vector<std::uint32_t> corners_;             // of the star but for the vertex, each once
	std::vector<std::array<std::uint8_t, 2>> ends_;  // per face, as indices of them
	std::array<std::array<double, 64>, 3> offset_;   // from the vertex, by axis and corner
	std::array<double, 64> perLength_;               // about one by its length
	std::vector<Planes> planes_;                     // per face
};

}  // namespace index_boolean
