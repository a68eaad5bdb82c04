// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything here is sorting: edges to collect the points on them, pairs of points to find segments
// that several pairs of faces share.
#include "vcg_ext/arrange/cut_lines.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

namespace index_boolean {

namespace {

// A point on an edge of an operand; none() stands for an edge that is there for its ends alone.
struct EdgePoint {
	VertexId low, high;
	VertexId point;

	friend bool operator<(const EdgePoint& a, const EdgePoint& b) {
		return a.low != b.low     ? a.low < b.low
		       : a.high != b.high ? a.high < b.high
		                          : a.point < b.point;
	}
	friend bool operator==(const EdgePoint& a, const EdgePoint& b) {
		return a.low == b.low && a.high == b.high && a.point == b.point;
	}
};

// A straight line between two points that a contact asks for.
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

class LineCutter {
public:
	LineCutter(Arrangement& arrangement, const Contacts& contacts,
	           const std::vector<VertexId>& vertexOfName, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), curve_(arrangement.curve),
	      contacts_(contacts), vertexOfName_(vertexOfName), monitor_(monitor) {}

	Status run();

private:
	Status collectPointsOnEdges();
	Status collectCutEdges();
	bool sortAlongEdge(const CutEdge& edge, VertexId* points) const;
	Status sortPointsOnEdges();
	Status refuseCoincidentPoints(const CutEdge& edge) const;
	Status collectLines();
	void addLine(VertexId begin, VertexId end, std::uint32_t contact);
	void addOverlap(std::uint32_t contact);
	Status numberSegments();
	Status findIrregularPoints();

	// As std::sort, for items with few equal keys in [0, keyCount).
	template <class Item, class KeyOf, class Before>
	Status sort(std::vector<Item>& items, std::size_t keyCount, KeyOf&& keyOf,
	            Before&& before) const {
		return bucketSort(items, keyCount, keyOf, before, arrangement_.options.threads, monitor_);
	}
	// Whether all faces at an edge have twins: the curve does not go along it.
	bool isQuiet(VertexId a, VertexId b) const { return mesh_.isQuiet(a) && mesh_.isQuiet(b); }
	bool isOn(VertexId v) const { return arrangement_.isOnOther(v); }
	ExactPoint exact(VertexId v) const { return exactPoint(arrangement_, v); }

	Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Curve& curve_;
	const Contacts& contacts_;
	const std::vector<VertexId>& vertexOfName_;
	Monitor& monitor_;
	std::vector<EdgePoint> edgePoints_;
	std::vector<ContactLine> lines_;
};

Status LineCutter::collectPointsOnEdges() {
	for (std::uint32_t p = 0; p < curve_.names.size(); ++p) {
		const auto& ids = curve_.names[p].ids;
		const VertexId point = arrangement_.vertexOf({p});
		edgePoints_.push_back({VertexId{ids[0]}, VertexId{ids[1]}, point});
		if (curve_.names[p].kind == PointKind::EdgeEdge) {
			edgePoints_.push_back({VertexId{ids[2]}, VertexId{ids[3]}, point});
		}
	}
	for (const PointName& name : contacts_.names) {
		if (name.kind == PointKind::OnEdge) {
			edgePoints_.push_back(
			    {VertexId{name.ids[1]}, VertexId{name.ids[2]}, VertexId{name.ids[0]}});
		}
	}
	for (const FaceId face : curve_.touchedFaces) {
		const Triangle& t = at(mesh_.triangles, face);
		for (std::size_t i = 0; i < 3; ++i) {
			const auto edge = std::minmax(t[i], t[(i + 1) % 3]);
			if (isOn(edge.first) && isOn(edge.second) && !isQuiet(edge.first, edge.second)) {
				edgePoints_.push_back({edge.first, edge.second, VertexId::none()});
			}
		}
	}
	const Status status = sort(
	    edgePoints_, mesh_.points.size(), [](const EdgePoint& e) { return e.low.value; },
	    std::less<EdgePoint>());
	edgePoints_.erase(std::unique(edgePoints_.begin(), edgePoints_.end()), edgePoints_.end());
	return status;
}

Status LineCutter::collectCutEdges() {
	std::uint32_t interval = 0;
	for (const EdgePoint& e : edgePoints_) {
		const bool isNewEdge = curve_.cutEdges.empty() || curve_.cutEdges.back().low != e.low ||
		                       curve_.cutEdges.back().high != e.high;
		if (isNewEdge) {
			const auto first = static_cast<std::uint32_t>(curve_.pointsOnEdges.size());
			curve_.cutEdges.push_back({e.low, e.high, first, 0, interval++});
		}
		if (e.point != VertexId::none()) {
			curve_.pointsOnEdges.push_back(e.point);
			++curve_.cutEdges.back().count;
			++interval;
		}
	}
	return {};
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
bool LineCutter::sortAlongEdge(const CutEdge& edge, VertexId* points) const {
	const Point& low = at(mesh_.points, edge.low);
	const Point& high = at(mesh_.points, edge.high);
	const int axis = longestAxis(low, high);
	const bool rising = low[static_cast<std::size_t>(axis)] < high[static_cast<std::size_t>(axis)];
	bool distinct = true;
	std::sort(points, points + edge.count, [&](VertexId a, VertexId b) {
		if (a == b) {
			return false;
		}
		const int order = compareCoordinate(exact(a), exact(b), axis);
		distinct = distinct && order != 0;
		return rising ? order < 0 : order > 0;
	});
	return distinct;
}

// Two points of contact in one place: faces of the other operand meet there without a common edge.
Status LineCutter::refuseCoincidentPoints(const CutEdge& edge) const {
	OperandId operand = OperandId::none();
	std::vector<FaceId> faces;
	for (const NamedContact& contact : contacts_.pairs) {
		for (const FaceId face : {contact.a, contact.b}) {
			const Triangle& t = at(mesh_.triangles, face);
			const bool hasEdge = std::count(t.begin(), t.end(), edge.low) != 0 &&
			                     std::count(t.begin(), t.end(), edge.high) != 0;
			if (hasEdge) {
				const FaceId other = face == contact.a ? contact.b : contact.a;
				operand = mesh_.operandOf(other);
				faces.push_back(other);
			}
		}
	}
	return selfIntersecting(arrangement_, operand, faces, at(mesh_.points, edge.low));
}

Status LineCutter::sortPointsOnEdges() {
	std::atomic<std::uint32_t> firstTied{0xffffffffu};
	Status status = parallelFor(
	    curve_.cutEdges.size(), 512, arrangement_.options.threads, monitor_,
	    [&](std::size_t begin, std::size_t end) {
		    for (std::size_t e = begin; e < end; ++e) {
			    const CutEdge& edge = curve_.cutEdges[e];
			    if (!sortAlongEdge(edge, curve_.pointsOnEdges.data() + edge.first)) {
				    const auto tied = static_cast<std::uint32_t>(e);
				    std::uint32_t known = firstTied.load();
				    while (tied < known && !firstTied.compare_exchange_weak(known, tied)) {
				    }
			    }
		    }
	    });
	if (status.ok() && firstTied.load() != 0xffffffffu) {
		return refuseCoincidentPoints(curve_.cutEdges[firstTied.load()]);
	}
	return status;
}

bool lexicographicallyBefore(const ExactPoint& a, const ExactPoint& b) {
	for (int axis = 0; axis < 3; ++axis) {
		if (const int order = compareCoordinate(a, b, axis); order != 0) {
			return order < 0;
		}
	}
	return false;
}

// No curve goes along an edge all of whose faces have twins. Faces at it that are not quiet are
// seen here, but not all of them, so nothing could be told from their order around it.
void LineCutter::addLine(VertexId begin, VertexId end, std::uint32_t contact) {
	if (!isQuiet(begin, end)) {
		lines_.push_back({begin, end, contact});
	}
}

// The sides of a coplanar overlap, and a fan of diagonals from its lexicographically smallest
// corner.
void LineCutter::addOverlap(std::uint32_t contact) {
	const NamedContact& c = contacts_.pairs[contact];
	std::vector<std::pair<VertexId, ExactPoint>> corners;
	for (std::uint32_t i = 0; i < c.count; ++i) {
		const VertexId v = vertexOfName_[c.first + i];
		corners.emplace_back(v, exact(v));
	}
	int sign = 0;
	const int axis = projectionAxis(at(mesh_.triangles, c.a), mesh_.points, sign);
	std::iter_swap(
	    corners.begin(),
	    std::min_element(corners.begin(), corners.end(), [](const auto& a, const auto& b) {
		    return lexicographicallyBefore(a.second, b.second);
	    }));
	const ExactPoint& apex = corners.front().second;
	std::sort(corners.begin() + 1, corners.end(), [&](const auto& a, const auto& b) {
		return orient2d(apex, a.second, b.second, axis) > 0;
	});
	for (std::size_t i = 0; i < corners.size(); ++i) {
		const VertexId next = corners[(i + 1) % corners.size()].first;
		addLine(corners[i].first, next, contact);
	}
	for (std::size_t i = 2; i + 1 < corners.size(); ++i) {
		curve_.faceDiagonals.push_back({c.a, corners.front().first, corners[i].first});
		curve_.faceDiagonals.push_back({c.b, corners.front().first, corners[i].first});
	}
}

Status LineCutter::collectLines() {
	for (std::uint32_t i = 0; i < contacts_.pairs.size(); ++i) {
		const NamedContact& c = contacts_.pairs[i];
		if (c.count == 2) {
			addLine(vertexOfName_[c.first], vertexOfName_[c.first + 1], i);
		} else if (c.count > 2) {
			addOverlap(i);
		}
	}
	std::sort(curve_.faceDiagonals.begin(), curve_.faceDiagonals.end(),
	          [](const FaceDiagonal& a, const FaceDiagonal& b) {
		          return a.face != b.face     ? a.face < b.face
		                 : a.begin != b.begin ? a.begin < b.begin
		                                      : a.end < b.end;
	          });
	return sort(
	    lines_, mesh_.points.size() + curve_.pointCount(),
	    [](const ContactLine& line) { return line.key().first.value; }, std::less<ContactLine>());
}

Status LineCutter::numberSegments() {
	for (std::size_t i = 0; i < lines_.size();) {
		std::size_t next = i + 1;
		while (next < lines_.size() && lines_[next].key() == lines_[i].key()) {
			++next;
		}
		const NamedContact& c = contacts_.pairs[lines_[i].contact];
		const SegmentId segment = makeId<SegmentTag>(curve_.segments.size());
		curve_.segments.push_back(
		    {lines_[i].begin, lines_[i].end, c.a, c.b, next - i == 1 && c.generic});
		for (std::size_t line = i; line < next; ++line) {
			const NamedContact& contact = contacts_.pairs[lines_[line].contact];
			curve_.faceSegments.push_back({contact.a, segment});
			curve_.faceSegments.push_back({contact.b, segment});
		}
		i = next;
	}
	std::vector<FaceSegment>& all = curve_.faceSegments;
	const Status status = sort(
	    all, mesh_.triangles.size(), [](const FaceSegment& s) { return s.face.value; },
	    [](const FaceSegment& a, const FaceSegment& b) {
		    return a.face != b.face ? a.face < b.face : a.segment < b.segment;
	    });
	all.erase(std::unique(all.begin(), all.end(),
	                      [](const FaceSegment& a, const FaceSegment& b) {
		                      return a.face == b.face && a.segment == b.segment;
	                      }),
	          all.end());
	return status;
}

// Regular is a new point at which two segments meet, each the crossing of two faces.
Status LineCutter::findIrregularPoints() {
	constexpr std::uint8_t kIrregular = 1;
	curve_.irregular = curve_.onOther;
	for (std::size_t v = 0; v < mesh_.quietVertices.size(); ++v) {
		curve_.irregular[v] = curve_.irregular[v] & (1 - mesh_.quietVertices[v]);
	}
	std::vector<std::uint8_t> crossings(curve_.pointCount());
	for (const Segment& segment : curve_.segments) {
		for (const VertexId v : {segment.begin, segment.end}) {
			if (arrangement_.isCurvePoint(v)) {
				std::uint8_t& count = at(crossings, arrangement_.pointOf(v));
				count = segment.crossing && count < 3 ? static_cast<std::uint8_t>(count + 1) : 3;
			}
		}
	}
	for (std::size_t p = 0; p < crossings.size(); ++p) {
		const bool regular = curve_.names[p].kind == PointKind::EdgeFace && crossings[p] == 2;
		curve_.irregular.push_back(regular ? 0 : kIrregular);
	}
	return {};
}

Status LineCutter::run() {
	using Step = Status (LineCutter::*)();
	constexpr std::array<Step, 6> kSteps{
	    {&LineCutter::collectPointsOnEdges, &LineCutter::collectCutEdges,
	     &LineCutter::sortPointsOnEdges, &LineCutter::collectLines, &LineCutter::numberSegments,
	     &LineCutter::findIrregularPoints}};
	Status status;
	for (std::size_t i = 0; i < kSteps.size() && status.ok(); ++i) {
		status = (this->*kSteps[i])();
	}
	return status;
}

}  // namespace

Status findCutLines(Arrangement& arrangement, const Contacts& contacts,
                    const std::vector<VertexId>& vertexOfName, Monitor& monitor) {
	return LineCutter(arrangement, contacts, vertexOfName, monitor).run();
}

}  // namespace index_boolean
