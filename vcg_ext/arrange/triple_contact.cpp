// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Neighbours of a face are listed in order, so that those common to two faces are found by looking
// the shorter list up in the longer one.
#include "vcg_ext/arrange/triple_contact.h"

#include "vcg_ext/arrange/curve_points.h"
#include "vcg_ext/arrange/numbered_sort.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/soup_contacts.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

// A face in contact with another.
struct Neighbour {
	FaceId face;
	std::uint32_t contact;
};

// Of each face, the faces in contact with it, ascending.
class ContactGraph {
public:
	ContactGraph(const std::vector<NamedContact>& pairs, std::size_t faceCount)
	    : first_(faceCount + 1), neighbours_(2 * pairs.size()) {
		for (const NamedContact& c : pairs) {
			++first_[c.a.value + 1];
			++first_[c.b.value + 1];
		}
		for (std::size_t f = 0; f < faceCount; ++f) {
			first_[f + 1] += first_[f];
		}
		// Pairs are sorted: a face gets its smaller neighbours before the larger ones.
		std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
		for (std::uint32_t i = 0; i < pairs.size(); ++i) {
			neighbours_[next[pairs[i].b.value]++] = {pairs[i].a, i};
		}
		for (std::uint32_t i = 0; i < pairs.size(); ++i) {
			neighbours_[next[pairs[i].a.value]++] = {pairs[i].b, i};
		}
	}

	// Calls visit(k, contact of f and k, contact of g and k) for each face k in contact with both.
	template <class Visit>
	void visitCommon(FaceId f, FaceId g, Visit&& visit) const {
		const bool isFirstShorter = degree(f) <= degree(g);
		const FaceId few = isFirstShorter ? f : g, many = isFirstShorter ? g : f;
		const Neighbour* const end = endOf(many);
		for (const Neighbour* n = beginOf(few); n != endOf(few); ++n) {
			const Neighbour* const found =
			    std::lower_bound(beginOf(many), end, n->face,
			                     [](const Neighbour& m, FaceId wanted) { return m.face < wanted; });
			if (found != end && found->face == n->face) {
				visit(n->face, isFirstShorter ? n->contact : found->contact,
				      isFirstShorter ? found->contact : n->contact);
			}
		}
	}

private:
	const Neighbour* beginOf(FaceId f) const { return neighbours_.data() + first_[f.value]; }
	const Neighbour* endOf(FaceId f) const { return neighbours_.data() + first_[f.value + 1]; }
	std::size_t degree(FaceId f) const { return first_[f.value + 1] - first_[f.value]; }

	std::vector<std::size_t> first_;
	std::vector<Neighbour> neighbours_;
};

// A point of three faces inside the segment of a contact.
struct NamedInner {
	std::uint32_t contact;
	PointName name;
};

// What one chunk of contacts gave.
struct ChunkPoints {
	std::vector<InnerPoint> known;
	std::vector<NamedInner> named;
};

class TripleFinder {
public:
	TripleFinder(const Arrangement& arrangement, const Contacts& contacts,
	             const std::vector<VertexId>& vertexOfName)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), contacts_(contacts),
	      vertexOfName_(vertexOfName), graph_(contacts.pairs, arrangement.mesh.triangles.size()) {}

	// The points inside the segment of one contact. Any thread may ask.
	void find(std::uint32_t contact, ChunkPoints& out) const;

private:
	// The segment of a contact.
	struct Line {
		std::uint32_t contact;
		VertexId begin, end;
		Point low, high;  // box of the rounded ends
		AxisDirection direction;
	};

	Line lineOf(std::uint32_t contact) const;
	void addPointsOf(const NamedContact& other, FaceId plane, const Line& line,
	                 ChunkPoints& out) const;
	bool isInside(VertexId v, FaceId plane, const Line& line) const;
	bool crosses(const NamedContact& segment, FaceId plane) const;
	bool hasEnd(const NamedContact& c, const Line& line) const;
	int side(FaceId plane, VertexId v) const;
	VertexId pointOf(const NamedContact& c, std::uint32_t i) const {
		return vertexOfName_[c.first + i];
	}

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	const Contacts& contacts_;
	const std::vector<VertexId>& vertexOfName_;
	ContactGraph graph_;
};

TripleFinder::Line TripleFinder::lineOf(std::uint32_t contact) const {
	const NamedContact& c = contacts_.pairs[contact];
	const VertexId begin = pointOf(c, 0), end = pointOf(c, 1);
	Line line{contact, begin, end, {}, {}, directionBetween(arrangement_, begin, end)};
	const Point& p = arrangement_.coordinates(begin);
	const Point& q = arrangement_.coordinates(end);
	for (std::size_t k = 0; k < 3; ++k) {
		line.low[k] = std::min(p[k], q[k]);
		line.high[k] = std::max(p[k], q[k]);
	}
	return line;
}

// The side of a face's plane on which a point lies; 0 without arithmetic where its name says so.
int TripleFinder::side(FaceId plane, VertexId v) const {
	const Triangle& t = at(mesh_.triangles, plane);
	const auto isCorner = [&t](std::uint32_t id) {
		return t[0].value == id || t[1].value == id || t[2].value == id;
	};
	if (arrangement_.isCurvePoint(v)) {
		const PointName& name = at(arrangement_.curve.names, arrangement_.pointOf(v));
		const auto& ids = name.ids;
		const bool isInPlane =
		    (isCorner(ids[0]) && isCorner(ids[1])) ||
		    (name.kind == PointKind::EdgeFace ? ids[2] == plane.value
		                                      : isCorner(ids[2]) && isCorner(ids[3]));
		if (isInPlane) {
			return 0;
		}
	} else if (isCorner(v.value)) {
		return 0;
	}
	const Points& points = mesh_.points;
	return orient3d({&at(points, t[0]), &at(points, t[1]), &at(points, t[2])},
	                exactPoint(arrangement_, v));
}

// Whether a point of one of the line's faces lies on the line, strictly between its ends. Rounding
// is monotone, so such a point is rounded into the box of the rounded ends.
bool TripleFinder::isInside(VertexId v, FaceId plane, const Line& line) const {
	const Point& p = arrangement_.coordinates(v);
	for (std::size_t k = 0; k < 3; ++k) {
		if (p[k] < line.low[k] || p[k] > line.high[k]) {
			return false;
		}
	}
	if (v == line.begin || v == line.end || side(plane, v) != 0) {
		return false;
	}
	const ExactPoint point = exactPoint(arrangement_, v);
	const auto [axis, sign] = line.direction;
	return compareCoordinate(point, exactPoint(arrangement_, line.begin), axis) == sign &&
	       compareCoordinate(exactPoint(arrangement_, line.end), point, axis) == sign;
}

void TripleFinder::addPointsOf(const NamedContact& other, FaceId plane, const Line& line,
                               ChunkPoints& out) const {
	for (std::uint32_t i = 0; i < other.count; ++i) {
		if (isInside(pointOf(other, i), plane, line)) {
			out.known.push_back({line.contact, pointOf(other, i)});
		}
	}
}

// Whether a contact is a segment with its ends strictly on different sides of a face's plane.
bool TripleFinder::crosses(const NamedContact& segment, FaceId plane) const {
	return segment.count == 2 &&
	       side(plane, pointOf(segment, 0)) * side(plane, pointOf(segment, 1)) < 0;
}

// Whether an end of the line is one of a contact's points: both its faces hold it then.
bool TripleFinder::hasEnd(const NamedContact& c, const Line& line) const {
	for (std::uint32_t i = 0; i < c.count; ++i) {
		if (pointOf(c, i) == line.begin || pointOf(c, i) == line.end) {
			return true;
		}
	}
	return false;
}

void TripleFinder::find(std::uint32_t contact, ChunkPoints& out) const {
	const NamedContact& c = contacts_.pairs[contact];
	if (c.count != 2) {
		return;
	}
	const PointName& begin = contacts_.names[c.first];
	const PointName& end = contacts_.names[c.first + 1];
	if (edgeAlong(mesh_, {c.a, c.b}, begin, end)[0] != VertexId::none()) {
		return;  // the points on the edge are known
	}
	const Line line = lineOf(contact);
	graph_.visitCommon(c.a, c.b, [&](FaceId k, std::uint32_t withF, std::uint32_t withG) {
		addPointsOf(contacts_.pairs[withF], c.b, line, out);
		addPointsOf(contacts_.pairs[withG], c.a, line, out);
		const bool endsInK =
		    hasEnd(contacts_.pairs[withF], line) || hasEnd(contacts_.pairs[withG], line);
		if (!endsInK && crosses(c, k) && crosses(contacts_.pairs[withF], c.b)) {
			std::array<std::uint32_t, 4> ids{c.a.value, c.b.value, k.value, 0};
			std::sort(ids.begin(), ids.begin() + 3);
			out.named.push_back({contact, {PointKind::FaceFaceFace, 0, ids}});
		}
	});
}

// Numbers the points of three faces behind all others.
Status numberNamed(Arrangement& arrangement, std::vector<NamedInner>& named, Monitor& monitor,
                   Contacts& contacts) {
	const auto isBefore = [](const NamedInner& a, const NamedInner& b) {
		return a.name == b.name ? a.contact < b.contact : a.name < b.name;
	};
	const auto firstFaceOf = [](const NamedInner& inner) { return inner.name.ids[0]; };
	const Status status = sortNumbered(named, arrangement.mesh.triangles.size(), firstFaceOf,
	                                   isBefore, arrangement.options, monitor);
	if (!status.ok()) {
		return status;
	}
	Curve& curve = arrangement.curve;
	const std::size_t before = curve.names.size();
	for (const NamedInner& inner : named) {
		if (curve.names.size() == before || !(curve.names.back() == inner.name)) {
			curve.names.push_back(inner.name);
		}
		contacts.inner.push_back(
		    {inner.contact, arrangement.vertexOf(makeId<PointTag>(curve.names.size() - 1))});
	}
	return inOrder(
	    [&] {
		    return checkCounts(arrangement.mesh.points.size() + curve.pointCount(), 0,
		                       arrangement.options.mostElements);
	    },
	    [&] { return roundCurvePoints(arrangement, before, monitor); });
}

}  // namespace

Status findTripleContacts(Arrangement& arrangement, const std::vector<VertexId>& vertexOfName,
                          Monitor& monitor, Contacts& contacts) {
	constexpr std::size_t kGrain = 256;
	const TripleFinder finder(arrangement, contacts, vertexOfName);
	std::vector<ChunkPoints> chunks(chunkCount(contacts.pairs.size(), kGrain));
	const Status status =
	    parallelForChunks(contacts.pairs.size(), kGrain, arrangement.options.threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t i = begin; i < end; ++i) {
			                      finder.find(static_cast<std::uint32_t>(i), chunks[chunk]);
		                      }
	                      });
	std::vector<NamedInner> named;
	for (const ChunkPoints& chunk : chunks) {
		contacts.inner.insert(contacts.inner.end(), chunk.known.begin(), chunk.known.end());
		named.insert(named.end(), chunk.named.begin(), chunk.named.end());
	}
	return status.ok() ? numberNamed(arrangement, named, monitor, contacts) : status;
}

}  // namespace index_boolean
