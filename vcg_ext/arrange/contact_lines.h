// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the contacts and the points on edges in order; out: the straight lines between points that
// contacts ask for, and the vertices inside faces. Guarantee: in a soup, no point of the curve lies
// inside one of the lines; else, none of the two faces' own contacts.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/arrange/triangle_contact.h"

#include <algorithm>
#include <utility>

namespace index_boolean {

// A straight line between two points that a contact, by its place among the pairs, asks for.
struct ContactLine {
	VertexId begin, end;
	std::uint32_t contact;

	std::pair<VertexId, VertexId> key() const { return std::minmax(begin, end); }
	friend bool operator<(const ContactLine& a, const ContactLine& b) {
		const auto x = a.key(), y = b.key();
		return x.first != y.first     ? x.first < y.first
		       : x.second != y.second ? x.second < y.second
		                              : a.contact < b.contact;
	}
};

// Whether all faces at an edge have twins: the curve does not go along it. Complexity: O(1).
inline bool isQuietEdge(const MeshArrays& mesh, VertexId a, VertexId b) {
	return mesh.isQuiet(a) && mesh.isQuiet(b);
}

// Collects the lines, and of each face the vertices inside it, repeated or not, in any order.
// \param vertexOfName  per name in the contacts
// \param lines         replaced; the same line once for each contact that asks for it
// \param faceVertices  replaced
// \pre arrangement.curve has its cut edges, with their points in order
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(c log c) for c contacts and points.
Status collectContactLines(const Arrangement& arrangement, const Contacts& contacts,
                           const std::vector<VertexId>& vertexOfName, Monitor& monitor,
                           std::vector<ContactLine>& lines, std::vector<FaceVertex>& faceVertices);

}  // namespace index_boolean
