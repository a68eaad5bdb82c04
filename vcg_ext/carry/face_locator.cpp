// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A vertex that is no corner of its face, by index or by coordinates, has weights with exact signs.
// A vertex outside of its face is looked for in all faces of the polygon, by boxes: seen along the
// axis that a face is projected along, a point of it is in its box, and rounding keeps it there,
// since the box ends in coordinates that are not rounded. Such vertices are few, faces of a polygon
// may be many: so the vertices are put into a tree, and each face is looked at once.
#include "vcg_ext/carry/face_locator.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/box_tree.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace index_boolean {

namespace {

constexpr std::uint8_t kNoAxis = 3;

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

// Lowers a number that other threads lower too.
void lowerTo(std::uint32_t value, std::atomic<std::uint32_t>& number) {
	std::uint32_t known = number.load(std::memory_order_relaxed);
	while (value < known &&
	       !number.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
	}
}

bool overlap(const BoundingBox& a, const BoundingBox& b) {
	return a.lo[0] <= b.hi[0] && b.lo[0] <= a.hi[0] && a.lo[1] <= b.hi[1] && b.lo[1] <= a.hi[1] &&
	       a.lo[2] <= b.hi[2] && b.lo[2] <= a.hi[2];
}

}  // namespace

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

const Point& FaceLocator::placeOf(std::uint32_t vertex) const {
	const VertexId v = mesh_.vertexSource[vertex];
	return v == VertexId::none() ? mesh_.points[vertex] : arrangement_.coordinates(v);
}

// The box of a face of a part, without end along the axis that the part is projected along: a
// vertex that is no exact point of its plane is seen along that axis too.
BoundingBox FaceLocator::boxOf(FaceId face, std::size_t along) const {
	const MeshArrays& mesh = arrangement_.mesh;
	const Triangle& t = at(mesh.triangles, face);  // in the same places as the face as given
	const Point &a = at(mesh.points, t[0]), &b = at(mesh.points, t[1]), &c = at(mesh.points, t[2]);
	BoundingBox box{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		box.lo[axis] = axis == along ? -HUGE_VAL : std::min({a[axis], b[axis], c[axis]});
		box.hi[axis] = axis == along ? HUGE_VAL : std::max({a[axis], b[axis], c[axis]});
	}
	return box;
}

// The search for wanted vertices that lie outside of their own faces.
struct FaceLocator::PartSearch {
	PartSearch(const FaceLocator& l, const std::vector<WantedPlace>& w,
	           const std::vector<std::size_t>& m);

	void lookIn(FaceId face);
	bool mayHoldAny(std::size_t begin, std::size_t end) const;

	std::uint8_t axisFor(FaceId face) const { return at(axisOf, locator.partOf(face)); }

	const FaceLocator& locator;
	const std::vector<WantedPlace>& wanted;
	const std::vector<std::size_t>& missing;        // of them
	std::vector<std::uint8_t> axisOf;               // per part, if it is asked: one for one plane
	BoxTree tree;                                   // of the places of the missing
	std::vector<std::atomic<std::uint32_t>> first;  // per missing: the face it lies in
};

FaceLocator::PartSearch::PartSearch(const FaceLocator& l, const std::vector<WantedPlace>& w,
                                    const std::vector<std::size_t>& m)
    : locator(l), wanted(w), missing(m), axisOf(l.arrangement_.mesh.triangles.size(), kNoAxis),
      first(m.size()) {
	const MeshArrays& mesh = locator.arrangement_.mesh;
	std::vector<BoundingBox> places;
	for (const std::size_t i : missing) {
		const FaceId part = locator.partOf(wanted[i].face);
		int sign = 0;
		at(axisOf, part) =
		    static_cast<std::uint8_t>(projectionAxis(at(mesh.triangles, part), mesh.points, sign));
		const Point& place = locator.placeOf(wanted[i].vertex);
		places.push_back({place, place});
	}
	tree = BoxTree(std::move(places));
	for (std::atomic<std::uint32_t>& face : first) {
		face = kNone;
	}
}

void FaceLocator::PartSearch::lookIn(FaceId face) {
	const std::uint8_t axis = axisFor(face);
	if (axis == kNoAxis) {
		return;
	}
	const BoundingBox box = locator.boxOf(face, axis);
	const auto mayHold = [&box](const BoundingBox& vertices) { return overlap(box, vertices); };
	tree.visit(0, mayHold, [&](std::uint32_t i) {
		const WantedPlace& place = wanted[missing[i]];
		PlaceInFace found{};
		if (locator.partOf(place.face) == locator.partOf(face) && face.value < first[i] &&
		    locator.placeIn(face, place.vertex, found)) {
			lowerTo(face.value, first[i]);
		}
	});
}

// Whether any of some faces may hold a vertex: one look at the tree that mostly spares many.
bool FaceLocator::PartSearch::mayHoldAny(std::size_t begin, std::size_t end) const {
	BoundingBox all = emptyBox();
	for (std::size_t f = begin; f < end; ++f) {
		const auto face = makeId<FaceTag>(f);
		if (const std::uint8_t axis = axisFor(face); axis != kNoAxis) {
			const BoundingBox box = locator.boxOf(face, axis);
			all.add(box.lo);
			all.add(box.hi);
		}
	}
	bool found = false;
	tree.visit(
	    0, [&](const BoundingBox& vertices) { return !found && overlap(all, vertices); },
	    [&found](std::uint32_t) { found = true; });
	return found;
}

// Looks for those of the wanted vertices that lie outside of their own faces in all faces of their
// parts: of the faces that hold one, the first counts.
Status FaceLocator::locateInParts(const std::vector<WantedPlace>& wanted,
                                  const std::vector<std::size_t>& missing, Monitor& monitor,
                                  std::vector<PlaceInFace>& out) const {
	constexpr std::size_t kFaces = 1 << 13, kPlaces = 64;  // of a chunk
	constexpr std::size_t kNear = 32;  // faces one after another, which mostly lie near each other
	const int threads = arrangement_.options.threads;
	PartSearch search(*this, wanted, missing);
	const auto lookInChunk = [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; f += kNear) {
			const std::size_t last = std::min(f + kNear, end);
			const bool isNear = search.mayHoldAny(f, last);
			for (std::size_t g = f; isNear && g < last; ++g) {
				search.lookIn(makeId<FaceTag>(g));
			}
		}
	};
	const auto fill = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			if (search.first[i] != kNone) {
				placeIn({search.first[i]}, wanted[missing[i]].vertex, out[missing[i]]);
			}
		}
	};
	const std::size_t n = arrangement_.mesh.triangles.size();
	return inOrder([&] { return parallelFor(n, kFaces, threads, monitor, lookInChunk); },
	               [&] { return parallelFor(missing.size(), kPlaces, threads, monitor, fill); });
}

// A face that was merged with others of its polygon may have corners outside of its own source:
// they lie in another triangle of the polygon.
Status FaceLocator::locate(const std::vector<WantedPlace>& wanted, Monitor& monitor,
                           std::vector<PlaceInFace>& out) const {
	constexpr std::size_t kGrain = 256;
	out.resize(wanted.size());
	std::vector<std::size_t> missing;
	Status status = parallelFor(wanted.size(), kGrain, arrangement_.options.threads, monitor,
	                            [&](std::size_t begin, std::size_t end) {
		                            for (std::size_t i = begin; i < end; ++i) {
			                            placeIn(wanted[i].face, wanted[i].vertex, out[i]);
		                            }
	                            });
	for (std::size_t i = 0; i < wanted.size() && status.ok(); ++i) {
		if (!out[i].isThere) {
			missing.push_back(i);
		}
	}
	if (status.ok() && !missing.empty() && !arrangement_.polygons.flat.empty()) {
		status = locateInParts(wanted, missing, monitor, out);
	}
	for (const std::size_t i : missing) {
		if (!out[i].isThere) {
			out[i].weights = clamped(out[i].weights);
		}
	}
	return status;
}

}  // namespace index_boolean
