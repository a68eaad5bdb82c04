// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A contact of two points is one line, an overlap has a line for each side. In a soup, a line may
// have points inside: along an edge these are the edge's, else those that triple_contact found.
#include "vcg_ext/arrange/contact_lines.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/soup_contacts.h"
#include "vcg_ext/base/parallel.h"

namespace index_boolean {

namespace {

bool lexicographicallyBefore(const ExactPoint& a, const ExactPoint& b) {
	for (int axis = 0; axis < 3; ++axis) {
		if (const int order = compareCoordinate(a, b, axis); order != 0) {
			return order < 0;
		}
	}
	return false;
}

// Where points lie along the cut edges. Borrows the curve.
class EdgePlaces {
public:
	// \param isNeeded else nothing is listed. O(k log m) for k points on edges, m on one.
	EdgePlaces(const Curve& curve, bool isNeeded) : curve_(curve) {
		places_.resize(isNeeded ? curve.pointsOnEdges.size() : 0);
		for (std::size_t e = 0; e < curve.cutEdges.size() && isNeeded; ++e) {
			const CutEdge& edge = curve.cutEdges[e];
			Place* const first = places_.data() + edge.first;
			for (std::uint32_t i = 0; i < edge.count; ++i) {
				first[i] = {curve.pointsOnEdges[edge.first + i], i + 1};
			}
			std::sort(first, first + edge.count);
		}
	}

	// Calls visit(begin, end) for each interval of an edge between two of its points, in order from
	// the first to the second. O(log k + m) for m of them.
	template <class Visit>
	void visitIntervals(const std::array<VertexId, 2>& ends, VertexId from, VertexId to,
	                    Visit&& visit) const {
		const auto edge =
		    std::lower_bound(curve_.cutEdges.begin(), curve_.cutEdges.end(), ends,
		                     [](const CutEdge& e, const std::array<VertexId, 2>& wanted) {
			                     return e.low != wanted[0] ? e.low < wanted[0] : e.high < wanted[1];
		                     });
		const std::uint32_t first = placeOf(*edge, from), last = placeOf(*edge, to);
		for (std::uint32_t i = first, next = first; i != last; i = next) {
			next = first < last ? i + 1 : i - 1;
			visit(pointAt(*edge, i), pointAt(*edge, next));
		}
	}

private:
	struct Place {
		VertexId point;
		std::uint32_t place;  // from 1 on; the edge's low end is at 0

		friend bool operator<(const Place& a, const Place& b) { return a.point < b.point; }
	};

	std::uint32_t placeOf(const CutEdge& edge, VertexId point) const {
		if (point == edge.low || point == edge.high) {
			return point == edge.low ? 0 : edge.count + 1;
		}
		const Place* const first = places_.data() + edge.first;
		return std::lower_bound(first, first + edge.count, Place{point, 0})->place;
	}
	VertexId pointAt(const CutEdge& edge, std::uint32_t place) const {
		return place == 0                ? edge.low
		       : place == edge.count + 1 ? edge.high
		                                 : curve_.pointsOnEdges[edge.first + place - 1];
	}

	const Curve& curve_;
	std::vector<Place> places_;  // of each edge's points, as the curve has them; by point
};

// Collects what contacts ask for.
class LineCollector {
public:
	// Borrows all.
	LineCollector(const Arrangement& arrangement, const Contacts& contacts,
	              const std::vector<VertexId>& vertexOfName, std::vector<ContactLine>& lines,
	              std::vector<FaceVertex>& faceVertices)
	    : arrangement_(arrangement), contacts_(contacts), vertexOfName_(vertexOfName),
	      edges_(arrangement.curve, arrangement.isSoup), lines_(lines),
	      faceVertices_(faceVertices) {}

	Status collect(Monitor& monitor);

private:
	// A corner of an overlap, by the slot of its name.
	struct Corner {
		std::uint32_t name;
		ExactPoint place;
	};

	void addLine(VertexId begin, VertexId end, std::uint32_t contact);
	void addSide(std::uint32_t contact, std::uint32_t first, std::uint32_t second);
	void addInside(std::uint32_t contact);
	void addOverlap(std::uint32_t contact);
	void addVertices(const NamedContact& contact);
	std::vector<Corner> cornersOf(const NamedContact& overlap) const;

	const Arrangement& arrangement_;
	const Contacts& contacts_;
	const std::vector<VertexId>& vertexOfName_;
	EdgePlaces edges_;
	std::vector<ContactLine>& lines_;
	std::vector<FaceVertex>& faceVertices_;
	std::vector<VertexId> inside_;  // of one line
};

// No curve goes along an edge all of whose faces have twins. Faces at it that are not quiet are
// seen here, but not all of them, so nothing could be told from their order around it.
void LineCollector::addLine(VertexId begin, VertexId end, std::uint32_t contact) {
	if (!isQuietEdge(arrangement_.mesh, begin, end)) {
		lines_.push_back({begin, end, contact});
	}
}

// The line between two points of a contact, by the slots of their names.
void LineCollector::addSide(std::uint32_t contact, std::uint32_t first, std::uint32_t second) {
	const VertexId begin = vertexOfName_[first], end = vertexOfName_[second];
	if (!arrangement_.isSoup) {
		addLine(begin, end, contact);
		return;
	}
	const NamedContact& c = contacts_.pairs[contact];
	const std::array<VertexId, 2> edge =
	    edgeAlong(arrangement_.mesh, {c.a, c.b}, contacts_.names[first], contacts_.names[second]);
	if (edge[0] == VertexId::none()) {
		addInside(contact);
		return;
	}
	edges_.visitIntervals(edge, begin, end,
	                      [&](VertexId from, VertexId to) { addLine(from, to, contact); });
}

// The line of a contact that runs through the inside of both faces.
void LineCollector::addInside(std::uint32_t contact) {
	const NamedContact& c = contacts_.pairs[contact];
	const VertexId begin = vertexOfName_[c.first], end = vertexOfName_[c.first + 1];
	const auto before = [](const InnerPoint& p, std::uint32_t wanted) {
		return p.contact < wanted;
	};
	inside_.assign(1, begin);
	for (auto p = std::lower_bound(contacts_.inner.begin(), contacts_.inner.end(), contact, before);
	     p != contacts_.inner.end() && p->contact == contact; ++p) {
		inside_.push_back(p->point);
	}
	inside_.push_back(end);
	const AxisDirection direction = directionBetween(arrangement_, begin, end);
	const auto isBefore = [&](VertexId a, VertexId b) {
		return a != b && compareCoordinate(exactPoint(arrangement_, b), exactPoint(arrangement_, a),
		                                   direction.axis) == direction.sign;
	};
	std::sort(inside_.begin() + 1, inside_.end() - 1, isBefore);
	for (std::size_t i = 0; i + 1 < inside_.size(); ++i) {
		addLine(inside_[i], inside_[i + 1], contact);
	}
}

// The corners of a coplanar overlap around it, from the lexicographically smallest on.
std::vector<LineCollector::Corner> LineCollector::cornersOf(const NamedContact& overlap) const {
	const MeshArrays& mesh = arrangement_.mesh;
	std::vector<Corner> corners;
	for (std::uint32_t i = overlap.first; i < overlap.first + overlap.count; ++i) {
		corners.push_back({i, exactPoint(arrangement_, vertexOfName_[i])});
	}
	int sign = 0;
	const int axis = projectionAxis(at(mesh.triangles, overlap.a), mesh.points, sign);
	const auto isBefore = [](const Corner& a, const Corner& b) {
		return lexicographicallyBefore(a.place, b.place);
	};
	std::iter_swap(corners.begin(), std::min_element(corners.begin(), corners.end(), isBefore));
	const ExactPoint& apex = corners.front().place;
	std::sort(corners.begin() + 1, corners.end(), [&](const Corner& a, const Corner& b) {
		return orient2d(apex, a.place, b.place, axis) > 0;
	});
	return corners;
}

// The sides of a coplanar overlap.
void LineCollector::addOverlap(std::uint32_t contact) {
	const std::vector<Corner> corners = cornersOf(contacts_.pairs[contact]);
	for (std::size_t i = 0; i < corners.size(); ++i) {
		addSide(contact, corners[i].name, corners[(i + 1) % corners.size()].name);
	}
}

// The vertices of either face that lie inside the other one.
void LineCollector::addVertices(const NamedContact& contact) {
	for (std::uint32_t i = 0; i < contact.count; ++i) {
		const PointName& name = contacts_.names[contact.first + i];
		if (name.kind != PointKind::Vertex) {
			continue;
		}
		const VertexId vertex{name.ids[0]};
		for (const FaceId face : {contact.a, contact.b}) {
			const Triangle& t = at(arrangement_.mesh.triangles, face);
			if (std::find(t.begin(), t.end(), vertex) == t.end()) {
				faceVertices_.push_back({face, vertex});
			}
		}
	}
}

Status LineCollector::collect(Monitor& monitor) {
	constexpr std::size_t kGrain = 1024;
	return inOrderFor(contacts_.pairs.size(), kGrain, monitor,
	                  [&](std::size_t begin, std::size_t end) {
		                  for (std::size_t k = begin; k < end; ++k) {
			                  const NamedContact& c = contacts_.pairs[k];
			                  const auto contact = static_cast<std::uint32_t>(k);
			                  addVertices(c);
			                  if (c.count == 2) {
				                  addSide(contact, c.first, c.first + 1);
			                  } else if (c.count > 2) {
				                  addOverlap(contact);
			                  }
		                  }
	                  });
}

}  // namespace

Status collectContactLines(const Arrangement& arrangement, const Contacts& contacts,
                           const std::vector<VertexId>& vertexOfName, Monitor& monitor,
                           std::vector<ContactLine>& lines, std::vector<FaceVertex>& faceVertices) {
	lines.clear();
	faceVertices.clear();
	return LineCollector(arrangement, contacts, vertexOfName, lines, faceVertices).collect(monitor);
}

}  // namespace index_boolean
