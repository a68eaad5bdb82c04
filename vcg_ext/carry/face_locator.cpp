// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A vertex that is no corner of its face, by index or by coordinates, has weights with exact signs.
// Where a whole polygon is asked, boxes leave out faces that the vertex cannot lie in: seen along
// the axis that the face is projected along, a point of it is in its box, and rounding keeps it
// there, since the box ends in coordinates that are not rounded.
#include "vcg_ext/carry/face_locator.h"

#include "vcg_ext/arrange/places.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::uint32_t kFew = 8;  // faces of a part that are asked one after another

bool isInside(const std::array<double, 3>& weights) {
	return std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0; });
}

// The nearest of the means that no weight is negative in: for a vertex that is no exact point of
// the face, or of a face whose corners all have the same attributes.
std::array<double, 3> clamped(std::array<double, 3> weights) {
	double sum = 0;
	for (double& w : weights) {
		w = w > 0 ? w : 0;
		sum += w;
	}
	for (double& w : weights) {
		w /= sum;
	}
	return weights;
}

}  // namespace

FaceLocator::FaceLocator(const Arrangement& arrangement, const GivenTriangles& given,
                         const SourcedMesh& mesh)
    : arrangement_(arrangement), given_(given), mesh_(mesh) {
	const std::vector<FaceId>& flat = arrangement.polygons.flat;
	if (flat.empty()) {
		return;
	}
	begin_.assign(flat.size() + 1, 0);
	for (const FaceId root : flat) {
		++begin_[root.value + 1];
	}
	std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
	members_.resize(flat.size());
	std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
	for (std::uint32_t f = 0; f < flat.size(); ++f) {
		members_[next[flat[f].value]++] = {f};
	}
	listLargeParts();
}

void FaceLocator::listLargeParts() {
	std::vector<std::uint32_t> large;
	for (std::uint32_t part = 0; part + 1 < begin_.size(); ++part) {
		if (begin_[part + 1] - begin_[part] > kFew) {
			large.push_back(part);
		}
	}
	largePartCount_ = large.size();
	largeParts_ = std::make_unique<LargePart[]>(large.size());
	for (std::size_t i = 0; i < large.size(); ++i) {
		largeParts_[i].part = large[i];
	}
}

// The corner of a given triangle at the place of an input vertex, or -1.
int FaceLocator::cornerOfName(const Triangle& given, std::uint32_t id) const {
	const Points& points = arrangement_.mesh.points;
	for (int j = 0; j < 3; ++j) {
		if (at(points, given[static_cast<std::size_t>(j)]) == points[id]) {
			return j;
		}
	}
	return -1;
}

// The corner opposite an input edge, or -1 if that is no edge of the triangle.
int FaceLocator::cornerOpposite(const Triangle& given, std::uint32_t low,
                                std::uint32_t high) const {
	const int lowCorner = cornerOfName(given, low);
	const int highCorner = lowCorner < 0 ? -1 : cornerOfName(given, high);
	return highCorner < 0 ? -1 : 3 - lowCorner - highCorner;
}

// The corner opposite the triangle's edge that a point of the curve is named by, or -1.
int FaceLocator::zeroCorner(const Triangle& given, VertexId v) const {
	if (v == VertexId::none() || !arrangement_.isCurvePoint(v)) {
		return -1;
	}
	const PointName& name = at(arrangement_.curve.names, arrangement_.pointOf(v));
	switch (name.kind) {
	case PointKind::EdgeFace:
		return cornerOpposite(given, name.ids[0], name.ids[1]);
	case PointKind::EdgeEdge: {
		const int corner = cornerOpposite(given, name.ids[0], name.ids[1]);
		return corner >= 0 ? corner : cornerOpposite(given, name.ids[2], name.ids[3]);
	}
	case PointKind::Vertex:
	case PointKind::OnEdge:
	case PointKind::FaceFaceFace:
		return -1;  // names of input vertices; of a point that lies on no edge by name
	}
	return -1;
}

std::array<double, 3> FaceLocator::weightsIn(const Triangle& given, std::uint32_t vertex) const {
	const Points& points = arrangement_.mesh.points;
	const VertexId v = mesh_.vertexSource[vertex];
	const ExactPoint point = v == VertexId::none() ? ExactPoint::explicitPoint(mesh_.points[vertex])
	                                               : exactPoint(arrangement_, v);
	int sign = 0;
	const int axis = projectionAxis(given, points, sign);
	return barycentricWeights({&at(points, given[0]), &at(points, given[1]), &at(points, given[2])},
	                          point, zeroCorner(given, v), axis);
}

// Fills the vertex's place in one face. \return whether it lies in that face
bool FaceLocator::placeIn(FaceId face, std::uint32_t vertex, PlaceInFace& place) const {
	const Triangle given = givenTriangle(face);
	place = {face, {}, true};
	if (const int corner = cornerOf(given, vertex); corner >= 0) {
		place.weights[static_cast<std::size_t>(corner)] = 1;
	} else {
		place.weights = weightsIn(given, vertex);
		place.isThere = isInside(place.weights);
	}
	return place.isThere;
}

// Of a given face, without end along the axis that it is projected along: a vertex that is no exact
// point of its plane is seen along that axis too.
BoundingBox FaceLocator::boxOf(FaceId face) const {
	const Points& points = arrangement_.mesh.points;
	const Triangle given = givenTriangle(face);
	int sign = 0;
	const auto along = static_cast<std::size_t>(projectionAxis(given, points, sign));
	const Point &a = at(points, given[0]), &b = at(points, given[1]), &c = at(points, given[2]);
	BoundingBox box{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		box.lo[axis] = axis == along ? -HUGE_VAL : std::min({a[axis], b[axis], c[axis]});
		box.hi[axis] = axis == along ? HUGE_VAL : std::max({a[axis], b[axis], c[axis]});
	}
	return box;
}

// \pre the part is large
const BoxTree& FaceLocator::treeOf(std::uint32_t part) const {
	LargePart* const end = largeParts_.get() + largePartCount_;
	LargePart& large =
	    *std::lower_bound(largeParts_.get(), end, part,
	                      [](const LargePart& l, std::uint32_t wanted) { return l.part < wanted; });
	std::call_once(large.isBuilt, [&] {
		std::vector<BoundingBox> boxes;
		boxes.reserve(begin_[part + 1] - begin_[part]);
		for (std::uint32_t i = begin_[part]; i < begin_[part + 1]; ++i) {
			boxes.push_back(boxOf(members_[i]));
		}
		large.tree = std::make_unique<BoxTree>(std::move(boxes));
	});
	return *large.tree;
}

// The faces of a flat part that a vertex may lie in, ascending.
std::vector<FaceId> FaceLocator::facesNear(std::uint32_t part, std::uint32_t vertex) const {
	const FaceId* const members = members_.data() + begin_[part];
	const std::uint32_t count = begin_[part + 1] - begin_[part];
	if (count <= kFew) {
		return {members, members + count};
	}
	const VertexId v = mesh_.vertexSource[vertex];
	const Point& p = v == VertexId::none() ? mesh_.points[vertex] : arrangement_.coordinates(v);
	const auto mayHold = [&p](const BoundingBox& box) {
		return box.lo[0] <= p[0] && p[0] <= box.hi[0] && box.lo[1] <= p[1] && p[1] <= box.hi[1] &&
		       box.lo[2] <= p[2] && p[2] <= box.hi[2];
	};
	std::vector<std::uint32_t> near;
	treeOf(part).visit(0, mayHold, [&near](std::uint32_t member) { near.push_back(member); });
	std::sort(near.begin(), near.end());
	std::vector<FaceId> faces;
	for (const std::uint32_t member : near) {
		faces.push_back(members[member]);
	}
	return faces;
}

// A face that was merged with others of its polygon may have corners outside of its own source:
// they lie in another triangle of the polygon.
PlaceInFace FaceLocator::locate(FaceId face, std::uint32_t vertex) const {
	PlaceInFace own{}, other{};
	if (placeIn(face, vertex, own)) {
		return own;
	}
	if (!members_.empty()) {
		for (const FaceId near : facesNear(at(arrangement_.polygons.flat, face).value, vertex)) {
			if (placeIn(near, vertex, other)) {
				return other;
			}
		}
	}
	own.weights = clamped(own.weights);
	return own;
}

}  // namespace index_boolean
