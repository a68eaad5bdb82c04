// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Few cut edges to search among begin with about the same lower end; the lists of segments and
// vertices are sorted by face.
#include "vcg_ext/arrange/face_lines.h"

#include <algorithm>
#include <numeric>

namespace index_boolean {

namespace {

// Those of a list sorted by face that lie on one.
template <class Line>
ConstRange<Line> linesOn(const std::vector<Line>& lines, FaceId face) {
	const Line* const end = lines.data() + lines.size();
	const Line* const first =
	    std::lower_bound(lines.data(), end, face,
	                     [](const Line& line, FaceId wanted) { return line.face < wanted; });
	const Line* last = first;
	while (last != end && last->face == face) {
		++last;
	}
	return {first, last};
}

}  // namespace

ConstRange<FaceSegment> segmentsOn(const Curve& curve, FaceId face) {
	return linesOn(curve.faceSegments, face);
}

FaceLineFinder::FaceLineFinder(const Arrangement& arrangement) : arrangement_(arrangement) {
	const std::vector<CutEdge>& edges = arrangement.curve.cutEdges;
	const std::size_t vertexCount = arrangement.mesh.points.size();
	while (vertexCount >> shift_ > edges.size()) {
		++shift_;
	}
	firsts_.resize((vertexCount >> shift_) + 2);
	for (const CutEdge& e : edges) {
		++firsts_[bucketOf(e.low) + 1];
	}
	std::partial_sum(firsts_.begin(), firsts_.end(), firsts_.begin());
}

// The cut edge between two vertices, or null.
const CutEdge* FaceLineFinder::cutEdge(VertexId a, VertexId b) const {
	const std::pair<VertexId, VertexId> key = std::minmax(a, b);
	const std::vector<CutEdge>& edges = arrangement_.curve.cutEdges;
	const auto begin = edges.begin() + firsts_[bucketOf(key.first)];
	const auto end = edges.begin() + firsts_[bucketOf(key.first) + 1];
	const auto it = std::lower_bound(
	    begin, end, key, [](const CutEdge& e, const std::pair<VertexId, VertexId>& k) {
		    return e.low != k.first ? e.low < k.first : e.high < k.second;
	    });
	const bool found = it != end && it->low == key.first && it->high == key.second;
	return found ? &*it : nullptr;
}

void FaceLineFinder::findSide(VertexId from, VertexId to, FaceSide& side) const {
	side.points.assign(1, from);
	side.cut = cutEdge(from, to);
	if (side.cut != nullptr) {
		const VertexId* const onEdge = arrangement_.curve.pointsOnEdges.data() + side.cut->first;
		side.points.insert(side.points.end(), onEdge, onEdge + side.cut->count);
		if (to < from) {
			std::reverse(side.points.begin() + 1, side.points.end());
		}
	}
	side.points.push_back(to);
}

void FaceLineFinder::find(FaceId face, FaceLines& lines) const {
	const Triangle& corners = at(arrangement_.mesh.triangles, face);
	lines.face = face;
	for (std::size_t i = 0; i < 3; ++i) {
		findSide(corners[i], corners[(i + 1) % 3], lines.sides[i]);
	}
	lines.segments = segmentsOn(arrangement_.curve, face);
	lines.vertices = linesOn(arrangement_.curve.faceVertices, face);
}

bool FaceLines::areEmpty() const {
	const bool anyInside = segments.begin() != segments.end() || vertices.begin() != vertices.end();
	return !anyInside && std::all_of(sides.begin(), sides.end(),
	                                 [](const FaceSide& side) { return side.points.size() == 2; });
}

NodeId intervalNode(const Arrangement& arrangement, const FaceSide& side, std::size_t i) {
	const MeshArrays& mesh = arrangement.mesh;
	const VertexId begin = side.points[i], end = side.points[i + 1];
	const bool isQuiet = mesh.isQuiet(begin) && mesh.isQuiet(end);
	const bool isShared = arrangement.isOnOther(begin) && arrangement.isOnOther(end) && !isQuiet;
	return isShared ? makeId<NodeTag>(mesh.points.size() + side.interval(i)) : NodeId::none();
}

}  // namespace index_boolean
