// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: pairs of faces that may meet; out: where they do, as named points, segments and overlaps.
// Guarantee: decided by signs of input coordinates alone; a point's name is the pair of lowest
// simplices that meet there, so every pair that sees it gives it the same name.
// Source: Mei & Tipper 2013, step 2, with exact signs in place of Moeller's interval test.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/arrange/octree_pairs.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// How one pair of faces meets: in one point, in a segment between two, or in a coplanar overlap, a
// strictly convex polygon with up to six corners. `generic`: a segment between two points each of
// which lies inside an edge of one face and inside the other face, directed as Segment is.
struct PairContact {
	static constexpr std::size_t kMostPoints = 6;

	bool generic = false;
	std::size_t count = 0;
	std::array<PointName, kMostPoints> points{};
};

// One contact in the list of all; its names are names[first .. first + count).
struct NamedContact {
	FaceId a, b;
	std::uint32_t first;
	std::uint8_t count;
	bool generic;
};

// A point inside the segment of a contact, where a third face meets both.
struct InnerPoint {
	std::uint32_t contact;
	VertexId point;
};

struct Contacts {
	std::vector<NamedContact> pairs;
	std::vector<PointName> names;
	std::vector<InnerPoint> inner;  // of a soup, see triple_contact.h; sorted by contact
};

// Finds how two faces meet; count is 0 if they do not. Complexity: O(1); a dozen orient3d for a
// pair that does. \return false if the signs contradict each other, which exact signs never do
bool contactOf(const MeshArrays& mesh, FacePair pair, PairContact& out);

// The same for two faces by their corners. \param pair  how names call the faces
// \pre both have area. Complexity: as above.
bool contactOf(const Points& points, FacePair pair, const std::array<Triangle, 2>& corners,
               PairContact& out);

// Finds all contacts.
// \param pairs sorted by a
// \param out   in the order of the pairs
// \return Ok, Cancelled, OutOfMemory, InternalError
// Complexity: O(p) for p pairs, in parallel.
Status findContacts(const Arrangement& arrangement, const std::vector<FacePair>& pairs,
                    Monitor& monitor, Contacts& out);

}  // namespace index_boolean
