// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything here is sorting. First the edges, to collect the points on each and to order them
// along it; then the lines that contacts ask for, of which those with the same ends are one
// segment.
#include "vcg_ext/arrange/cut_lines.h"

#include "vcg_ext/arrange/contact_lines.h"
#include "vcg_ext/arrange/numbered_sort.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/groups.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

namespace index_boolean {

namespace {

// ---- points on edges

// A point on an edge of an operand; none() stands for an edge that is there for its ends alone.
using EdgePoint = EdgeItem<VertexId>;

// A point on the edges that one of its names tells.
void appendPoint(const PointName& name, VertexId point, std::vector<EdgePoint>& out) {
	const auto& ids = name.ids;
	switch (name.kind) {
	case PointKind::OnEdge:
		out.push_back({ids[1], ids[2], point});
		break;
	case PointKind::EdgeEdge:
		out.push_back({ids[2], ids[3], point});
		[[fallthrough]];
	case PointKind::EdgeFace:
		out.push_back({ids[0], ids[1], point});
		break;
	case PointKind::Vertex:
	case PointKind::FaceFaceFace:
		break;
	}
}

// The points of contact on the edges of operands, each once for each edge; in a soup, where points
// have several names, once for each name.
void appendPoints(const Arrangement& arrangement, const Contacts& contacts,
                  const std::vector<VertexId>& vertexOfName, std::vector<EdgePoint>& out) {
	const std::vector<PointName>& newPoints = arrangement.curve.names;
	for (std::uint32_t p = 0; p < newPoints.size() && !arrangement.isSoup; ++p) {
		appendPoint(newPoints[p], arrangement.vertexOf({p}), out);
	}
	for (std::size_t i = 0; i < contacts.names.size(); ++i) {
		if (arrangement.isSoup || contacts.names[i].kind == PointKind::OnEdge) {
			appendPoint(contacts.names[i], vertexOfName[i], out);
		}
	}
}

// The edges of touched faces with both ends on the other operand, once for each face.
void appendEdgesOnOther(const Arrangement& arrangement, std::vector<EdgePoint>& out) {
	for (const FaceId face : arrangement.curve.touchedFaces) {
		const Triangle& t = at(arrangement.mesh.triangles, face);
		for (std::size_t i = 0; i < 3; ++i) {
			const VertexId from = t[i], to = t[(i + 1) % 3];
			if (arrangement.isOnOther(from) && arrangement.isOnOther(to) &&
			    !isQuietEdge(arrangement.mesh, from, to)) {
				out.push_back(makeEdgeItem(from.value, to.value, VertexId::none()));
			}
		}
	}
}

Status collectEdgePoints(const Arrangement& arrangement, const Contacts& contacts,
                         const std::vector<VertexId>& vertexOfName, Monitor& monitor,
                         std::vector<EdgePoint>& out) {
	appendPoints(arrangement, contacts, vertexOfName, out);
	appendEdgesOnOther(arrangement, out);
	const auto isSame = [](const EdgePoint& a, const EdgePoint& b) {
		return a.sameEdge(b) && a.item == b.item;
	};
	const Status status =
	    inOrder([&] { return checkCounts(out.size(), 0, arrangement.options.mostElements); },
	            [&] {
		            return sortByEdge(out, arrangement.mesh.points.size(),
		                              arrangement.options.threads, monitor);
	            });
	out.erase(std::unique(out.begin(), out.end(), isSame), out.end());
	return status;
}

// Lists the edges and, in any order, the points on each.
// \return TooLarge if their intervals cannot be numbered behind the input vertices
Status collectCutEdges(const std::vector<EdgePoint>& edgePoints, Arrangement& arrangement) {
	Curve& curve = arrangement.curve;
	for (const EdgePoint& e : edgePoints) {
		const CutEdge* const last = curve.cutEdges.empty() ? nullptr : &curve.cutEdges.back();
		if (last == nullptr || last->low.value != e.low || last->high.value != e.high) {
			const auto first = static_cast<std::uint32_t>(curve.pointsOnEdges.size());
			const auto firstInterval = static_cast<std::uint32_t>(curve.intervalCount());
			curve.cutEdges.push_back({{e.low}, {e.high}, first, 0, firstInterval});
		}
		if (e.item != VertexId::none()) {
			curve.pointsOnEdges.push_back(e.item);
			++curve.cutEdges.back().count;
		}
	}
	return checkNumbering(arrangement.mesh.points.size() + curve.intervalCount(),
	                      arrangement.options.mostElements);
}

// The axis along which an edge is longest: coordinates grow or fall strictly along it.
int longestAxis(const Point& a, const Point& b) {
	int best = 0;
	double most = -1;
	for (int axis = 0; axis < 3; ++axis) {
		const auto k = static_cast<std::size_t>(axis);
		// Halves, so that the difference of two finite numbers is finite.
		const double length = std::fabs(a[k] / 2 - b[k] / 2);
		if (length > most && a[k] != b[k]) {
			most = length;
			best = axis;
		}
	}
	return best;
}

// Sorts the points of one edge from its low end on. False if two of them coincide.
bool sortAlongEdge(const Arrangement& arrangement, const CutEdge& edge, VertexId* points) {
	const Point& low = at(arrangement.mesh.points, edge.low);
	const Point& high = at(arrangement.mesh.points, edge.high);
	const int axis = longestAxis(low, high);
	const bool rising = low[static_cast<std::size_t>(axis)] < high[static_cast<std::size_t>(axis)];
	bool distinct = true;
	std::sort(points, points + edge.count, [&](VertexId a, VertexId b) {
		if (a == b) {
			return false;
		}
		const int order =
		    compareCoordinate(exactPoint(arrangement, a), exactPoint(arrangement, b), axis);
		distinct = distinct && order != 0;
		return rising ? order < 0 : order > 0;
	});
	return distinct;
}

// Two points of contact in one place: faces of the other operand meet there without a common edge.
// In a soup, where points in one place are one point, there are none.
Status refuseCoincidentPoints(const Arrangement& arrangement, const Contacts& contacts,
                              const CutEdge& edge) {
	if (arrangement.isSoup) {
		return statusOf(StatusCode::InternalError);
	}
	const MeshArrays& mesh = arrangement.mesh;
	OperandId operand = OperandId::none();
	std::vector<FaceId> faces;
	for (const NamedContact& contact : contacts.pairs) {
		for (const FaceId face : {contact.a, contact.b}) {
			const Triangle& t = at(mesh.triangles, face);
			const bool hasEdge = std::count(t.begin(), t.end(), edge.low) != 0 &&
			                     std::count(t.begin(), t.end(), edge.high) != 0;
			if (hasEdge) {
				const FaceId other = face == contact.a ? contact.b : contact.a;
				operand = mesh.operandOf(other);
				faces.push_back(other);
			}
		}
	}
	return selfIntersecting(arrangement, operand, faces, at(mesh.points, edge.low));
}

Status sortPointsOnEdges(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor) {
	Curve& curve = arrangement.curve;
	std::atomic<std::uint32_t> firstTied{kNone};
	const auto sortSome = [&](std::size_t begin, std::size_t end) {
		for (std::size_t e = begin; e < end; ++e) {
			const CutEdge& edge = curve.cutEdges[e];
			if (!sortAlongEdge(arrangement, edge, curve.pointsOnEdges.data() + edge.first)) {
				const auto tied = static_cast<std::uint32_t>(e);
				std::uint32_t known = firstTied.load();
				while (tied < known && !firstTied.compare_exchange_weak(known, tied)) {
				}
			}
		}
	};
	const Status status =
	    parallelFor(curve.cutEdges.size(), 512, arrangement.options.threads, monitor, sortSome);
	return status.ok() && firstTied.load() != kNone
	           ? refuseCoincidentPoints(arrangement, contacts, curve.cutEdges[firstTied.load()])
	           : status;
}

// ---- segments

// Each vertex once in each face.
Status takeFaceVertices(std::vector<FaceVertex>& collected, Monitor& monitor,
                        Arrangement& arrangement) {
	const auto keyOf = [](const FaceVertex& v) { return v.face.value; };
	const auto before = [](const FaceVertex& a, const FaceVertex& b) {
		return a.face != b.face ? a.face < b.face : a.vertex < b.vertex;
	};
	const Status status = sortNumbered(collected, arrangement.mesh.triangles.size(), keyOf, before,
	                                   arrangement.options, monitor);
	const auto end = std::unique(collected.begin(), collected.end(),
	                             [](const FaceVertex& a, const FaceVertex& b) {
		                             return a.face == b.face && a.vertex == b.vertex;
	                             });
	arrangement.curve.faceVertices.assign(collected.begin(), end);
	return status;
}

// \param lines replaced; sorted
Status collectLines(Arrangement& arrangement, const Contacts& contacts,
                    const std::vector<VertexId>& vertexOfName, Monitor& monitor,
                    std::vector<ContactLine>& lines) {
	std::vector<FaceVertex> faceVertices;
	const std::size_t vertexCount = arrangement.mesh.points.size() + arrangement.curve.pointCount();
	const auto keyOf = [](const ContactLine& line) { return line.key().first.value; };
	return inOrder(
	    [&] {
		    return collectContactLines(arrangement, contacts, vertexOfName, monitor, lines,
		                               faceVertices);
	    },
	    [&] { return takeFaceVertices(faceVertices, monitor, arrangement); },
	    [&] {
		    return sortNumbered(lines, vertexCount, keyOf, std::less<ContactLine>(),
		                        arrangement.options, monitor);
	    });
}

// Lines between the same two points are one segment, which all their faces have. It is a crossing
// if one pair of faces asks for it, and generically; in a soup, never. It is named by the first
// pair; in a soup, by the first one of two operands, if there is any.
void numberSegments(const std::vector<ContactLine>& lines, const Contacts& contacts,
                    const MeshArrays& mesh, bool isSoup, Curve& curve) {
	using Iterator = std::vector<ContactLine>::const_iterator;
	const auto hasSameEnds = [](const ContactLine& a, const ContactLine& b) {
		return a.key() == b.key();
	};
	forEachGroup(lines.begin(), lines.end(), hasSameEnds, [&](Iterator first, Iterator last) {
		const auto isOfTwo = [&](const ContactLine& line) {
			const NamedContact& contact = contacts.pairs[line.contact];
			return mesh.operandOf(contact.a) != mesh.operandOf(contact.b);
		};
		const Iterator naming = isSoup ? std::find_if(first, last, isOfTwo) : first;
		const NamedContact& c = contacts.pairs[(naming == last ? first : naming)->contact];
		const SegmentId segment = makeId<SegmentTag>(curve.segments.size());
		const bool isCrossing = last - first == 1 && c.generic && !isSoup;
		curve.segments.push_back({first->begin, first->end, c.a, c.b, isCrossing});
		for (Iterator line = first; line != last; ++line) {
			const NamedContact& contact = contacts.pairs[line->contact];
			curve.faceSegments.push_back({contact.a, segment});
			curve.faceSegments.push_back({contact.b, segment});
		}
	});
}

// Each segment once on each of its faces.
Status sortFaceSegments(Arrangement& arrangement, Monitor& monitor) {
	std::vector<FaceSegment>& all = arrangement.curve.faceSegments;
	const auto keyOf = [](const FaceSegment& s) { return s.face.value; };
	const auto before = [](const FaceSegment& a, const FaceSegment& b) {
		return a.face != b.face ? a.face < b.face : a.segment < b.segment;
	};
	const Status status = sortNumbered(all, arrangement.mesh.triangles.size(), keyOf, before,
	                                   arrangement.options, monitor);
	const auto isSame = [](const FaceSegment& a, const FaceSegment& b) {
		return a.face == b.face && a.segment == b.segment;
	};
	all.erase(std::unique(all.begin(), all.end(), isSame), all.end());
	return status;
}

// ---- irregular points

// Regular is a new point at which two segments meet, each the crossing of two faces.
void findIrregularPoints(Arrangement& arrangement) {
	constexpr std::uint8_t kIrregular = 1;
	constexpr std::uint8_t kMany = 3;  // segments, or one that is no crossing
	const MeshArrays& mesh = arrangement.mesh;
	Curve& curve = arrangement.curve;
	curve.irregular = curve.onOther;
	for (std::size_t v = 0; v < mesh.quietVertices.size(); ++v) {
		curve.irregular[v] = curve.irregular[v] & (1 - mesh.quietVertices[v]);
	}
	std::vector<std::uint8_t> crossings(curve.pointCount());
	for (const Segment& segment : curve.segments) {
		for (const VertexId v : {segment.begin, segment.end}) {
			if (arrangement.isCurvePoint(v)) {
				std::uint8_t& count = at(crossings, arrangement.pointOf(v));
				const bool isOneMore = segment.crossing && count < kMany;
				count = isOneMore ? static_cast<std::uint8_t>(count + 1) : kMany;
			}
		}
	}
	for (std::size_t p = 0; p < crossings.size(); ++p) {
		const bool regular = curve.names[p].kind == PointKind::EdgeFace && crossings[p] == 2;
		curve.irregular.push_back(regular ? 0 : kIrregular);
	}
}

}  // namespace

Status findCutLines(Arrangement& arrangement, const Contacts& contacts,
                    const std::vector<VertexId>& vertexOfName, Monitor& monitor) {
	std::vector<EdgePoint> edgePoints;
	std::vector<ContactLine> lines;
	const Status status = inOrder(
	    [&] { return collectEdgePoints(arrangement, contacts, vertexOfName, monitor, edgePoints); },
	    [&] { return collectCutEdges(edgePoints, arrangement); },
	    [&] { return sortPointsOnEdges(arrangement, contacts, monitor); },
	    [&] { return collectLines(arrangement, contacts, vertexOfName, monitor, lines); });
	if (!status.ok()) {
		return status;
	}
	numberSegments(lines, contacts, arrangement.mesh, arrangement.isSoup, arrangement.curve);
	findIrregularPoints(arrangement);
	return sortFaceSegments(arrangement, monitor);
}

}  // namespace index_boolean
