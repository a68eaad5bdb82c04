// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: pairs of faces that may meet; out: where they do, as named points and directed segments.
// Guarantee: decided by signs of input coordinates alone; a point's name is the pair of lowest
// simplices that meet there, so every pair that sees it gives it the same name.
// Source: Mei & Tipper 2013, step 2, with exact signs in place of Moeller's interval test.
#pragma once

#include "arrangement.h"
#include "monitor.h"
#include "octree_pairs.h"
#include "status.h"

namespace index_boolean {

// A segment of the curve before its points are numbered; directed as Segment is.
struct NamedSegment {
	PointName begin, end;
	FaceId a, b;
};

// How one pair of faces meets: all named points, each once. `generic` means no point, or the two
// ends of one segment, each inside an edge of one face and inside the other face.
struct PairContact {
	static constexpr int kMostPoints = 12;

	bool generic = true;
	bool meets = false;
	NamedSegment segment{};  // if generic and meets
	int pointCount = 0;      // if not generic
	std::array<PointName, kMostPoints> points{};
};

// Finds how two faces meet. Complexity: O(1); a dozen orient3d for a pair that does.
// \return false if the signs contradict each other, which exact signs never do
bool contactOf(const MeshArrays& mesh, FacePair pair, PairContact& out);

// Finds all contacts.
// \param pairs sorted by a
// \param out   the segments, in the order of the pairs
// \return Ok, Cancelled, OutOfMemory, InternalError; DegenerateContact, with the faces and their
//         number, if any pair meets in a vertex, in crossing edges or in coplanar faces
// Complexity: O(p) for p pairs, in parallel.
Status findContacts(const Arrangement& arrangement, const std::vector<FacePair>& pairs,
                    Monitor& monitor, std::vector<NamedSegment>& out);

}  // namespace index_boolean
