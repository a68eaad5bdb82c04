// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// By input face a group is a number that is known; by plane, neighbours are united.
#include "vcg_ext/solids/face_groups.h"

#include "vcg_ext/arrange/face_classes.h"
#include "vcg_ext/arrange/joined_polygons.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/union_find.h"

namespace index_boolean {

namespace {

using Faces = std::vector<std::uint32_t>;

Faces groupsByParent(const Arrangement& arrangement, const Block& block, const Faces& faces) {
	const std::vector<FaceId>& flat = arrangement.polygons.flat;
	Faces groups;
	for (const std::uint32_t face : faces) {
		const FaceSource& source = block.faceSource[face];
		const FaceId parent = flat.empty() ? source.face : at(flat, source.face);
		groups.push_back(2 * parent.value + (source.turned ? 1 : 0));
	}
	return groups;
}

// Whether two neighbouring faces lie in one plane, with fronts to the same side, and may be one.
bool areOne(const Arrangement& arrangement, const FaceSource& a, const FaceSource& b) {
	if (a.face == b.face) {
		return a.turned == b.turned;
	}
	if (givenClassOf(arrangement, a.face) != givenClassOf(arrangement, b.face)) {
		return false;
	}
	const int front = commonFront(arrangement.mesh, a.face, b.face);
	return front != 0 && (front > 0) == (a.turned == b.turned);
}

Faces groupsByPlane(const Arrangement& arrangement, const Block& block, const Faces& faces) {
	std::vector<HalfEdge> halfEdges;
	for (std::size_t f = 0; f < faces.size(); ++f) {
		const IndexTriangle& t = block.triangles[faces[f]];
		for (std::size_t i = 0; i < 3; ++i) {
			halfEdges.push_back(makeHalfEdge(t[i], t[i == 2 ? 0 : i + 1], f, i));
		}
	}
	UnionFind planes(faces.size());
	const auto sourceOf = [&](const HalfEdge& h) -> const FaceSource& {
		return block.faceSource[faces[h.face]];
	};
	forEachEdge(halfEdges, [&](auto first, auto last) {
		if (last - first == 2 && areOne(arrangement, sourceOf(first[0]), sourceOf(first[1]))) {
			planes.unite(first[0].face, first[1].face);
		}
	});
	Faces groups;
	for (std::uint32_t f = 0; f < faces.size(); ++f) {
		groups.push_back(planes.find(f));
	}
	return groups;
}

}  // namespace

std::vector<std::uint32_t> groupsOf(const Arrangement& arrangement, const Block& block,
                                    const std::vector<std::uint32_t>& faces) {
	return arrangement.options.mergeCoplanar ? groupsByPlane(arrangement, block, faces)
	                                         : groupsByParent(arrangement, block, faces);
}

}  // namespace index_boolean
