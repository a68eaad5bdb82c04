// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything here is sorting: names to number the points, edges to collect the points on them,
// pairs of points to find segments that several pairs of faces share.
#include "weld.h"

#include "bucket_sort.h"
#include "parallel.h"
#include "self_intersecting.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

namespace index_boolean {

namespace {

bool isNewPoint(const PointName& name) {
	return name.kind == PointKind::EdgeEdge || name.kind == PointKind::EdgeFace;
}

struct NamedSlot {
	PointName name;
	std::uint32_t slot;  // in the contacts
};

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

class Welder {
public:
	Welder(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), curve_(arrangement.curve),
	      contacts_(contacts), monitor_(monitor) {}

	Status run();

private:
	Status numberPoints();
	Status roundPoints();
	Status collectTouchedFaces();
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
	Monitor& monitor_;
	std::vector<VertexId> vertexOfName_;  // per name in the contacts
	std::vector<EdgePoint> edgePoints_;
	std::vector<ContactLine> lines_;
};

// New points are numbered in the order of their names; the others are input vertices.
Status Welder::numberPoints() {
	curve_.onOther = mesh_.quietVertices;
	curve_.onOther.resize(mesh_.points.size(), 0);
	vertexOfName_.resize(contacts_.names.size());
	std::vector<NamedSlot> slots;
	for (std::uint32_t i = 0; i < contacts_.names.size(); ++i) {
		const PointName& name = contacts_.names[i];
		if (isNewPoint(name)) {
			slots.push_back({name, i});
		} else {
			vertexOfName_[i] = {name.ids[0]};
			curve_.onOther[name.ids[0]] = 1;
		}
	}
	const std::size_t n = mesh_.points.size();
	const Status status = sort(
	    slots, 2 * n,
	    [n](const NamedSlot& slot) {
		    return (slot.name.kind == PointKind::EdgeFace ? n : 0) + slot.name.ids[0];
	    },
	    [](const NamedSlot& a, const NamedSlot& b) { return a.name < b.name; });
	for (const auto& [name, slot] : slots) {
		if (curve_.names.empty() || !(curve_.names.back() == name)) {
			curve_.names.push_back(name);
		}
		vertexOfName_[slot] = arrangement_.vertexOf(makeId<PointTag>(curve_.names.size() - 1));
	}
	return status;
}

Status Welder::roundPoints() {
	curve_.rounded.resize(curve_.pointCount());
	return parallelFor(curve_.pointCount(), 128, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t p = begin; p < end; ++p) {
			                   ExactPoint point = exact(arrangement_.vertexOf(makeId<PointTag>(p)));
			                   roundPoint(point);
			                   curve_.rounded[p] = point.rounded;
		                   }
	                   });
}

Status Welder::collectTouchedFaces() {
	std::vector<FaceId>& faces = curve_.touchedFaces;
	faces.reserve(2 * contacts_.pairs.size());
	for (const NamedContact& contact : contacts_.pairs) {
		faces.push_back(contact.a);
		faces.push_back(contact.b);
	}
	const Status status = sort(
	    faces, mesh_.triangles.size(), [](FaceId f) { return f.value; }, std::less<FaceId>());
	faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
	return status;
}

Status Welder::collectPointsOnEdges() {
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

Status Welder::collectCutEdges() {
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
bool Welder::sortAlongEdge(const CutEdge& edge, VertexId* points) const {
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
Status Welder::refuseCoincidentPoints(const CutEdge& edge) const {
	int operand = -1;
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

Status Welder::sortPointsOnEdges() {
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
void Welder::addLine(VertexId begin, VertexId end, std::uint32_t contact) {
	if (!isQuiet(begin, end)) {
		lines_.push_back({begin, end, contact});
	}
}

// The sides of a coplanar overlap, and a fan of diagonals from its lexicographically smallest
// corner.
void Welder::addOverlap(std::uint32_t contact) {
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

Status Welder::collectLines() {
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

Status Welder::numberSegments() {
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
Status Welder::findIrregularPoints() {
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

Status Welder::run() {
	using Step = Status (Welder::*)();
	constexpr std::array<Step, 9> kSteps{
	    {&Welder::numberPoints, &Welder::roundPoints, &Welder::collectTouchedFaces,
	     &Welder::collectPointsOnEdges, &Welder::collectCutEdges, &Welder::sortPointsOnEdges,
	     &Welder::collectLines, &Welder::numberSegments, &Welder::findIrregularPoints}};
	Status status;
	for (std::size_t i = 0; i < kSteps.size() && status.ok(); ++i) {
		status = (this->*kSteps[i])();
	}
	return status;
}

// The exact point rounded to float, once: the double next to it decides, unless it lies half-way
// between two floats; then the exact point's side of it does.
double roundedToFloat(const ExactPoint& point, std::size_t axis) {
	const double value = point.rounded[axis];
	const auto nearest = static_cast<float>(value);
	if (point.form == ExactPoint::Form::Explicit || !std::isfinite(nearest)) {
		return static_cast<double>(nearest);
	}
	const double towards = value > static_cast<double>(nearest) ? HUGE_VAL : -HUGE_VAL;
	const double next = static_cast<double>(std::nextafter(nearest, static_cast<float>(towards)));
	if (value - static_cast<double>(nearest) != next - value) {
		return static_cast<double>(nearest);
	}
	const Point middle = point.rounded;
	const int side =
	    compareCoordinate(point, ExactPoint::explicitPoint(middle), static_cast<int>(axis));
	const double low = std::min(static_cast<double>(nearest), next);
	const double high = std::max(static_cast<double>(nearest), next);
	return side == 0 ? static_cast<double>(nearest) : (side < 0 ? low : high);
}

}  // namespace

ExactPoint exactPoint(const Arrangement& arrangement, VertexId vertex) {
	const Points& points = arrangement.mesh.points;
	if (!arrangement.isCurvePoint(vertex)) {
		return ExactPoint::explicitPoint(at(points, vertex));
	}
	const PointId id = arrangement.pointOf(vertex);
	const PointName& name = at(arrangement.curve.names, id);
	const auto& ids = name.ids;
	ExactPoint point;
	if (name.kind == PointKind::EdgeEdge) {
		point = ExactPoint::lineLine(
		    {&points[ids[0]], &points[ids[1]], &points[ids[2]], &points[ids[3]]}, name.axis);
	} else {
		const Triangle& face = arrangement.mesh.triangles[ids[2]];
		point = ExactPoint::linePlane({&points[ids[0]], &points[ids[1]], &at(points, face[0]),
		                               &at(points, face[1]), &at(points, face[2])});
	}
	point.rounded = at(arrangement.curve.rounded, id);
	return point;
}

int comparePlaces(const Arrangement& arrangement, VertexId a, VertexId b) {
	const Point& p = arrangement.coordinates(a);
	const Point& q = arrangement.coordinates(b);
	if (p != q) {
		return p < q ? -1 : 1;
	}
	const bool areInput = !arrangement.isCurvePoint(a) && !arrangement.isCurvePoint(b);
	for (int axis = 0; axis < 3 && a != b && !areInput; ++axis) {
		const int order =
		    compareCoordinate(exactPoint(arrangement, a), exactPoint(arrangement, b), axis);
		if (order != 0) {
			return order;
		}
	}
	return 0;
}

Point outputCoordinates(const Arrangement& arrangement, VertexId vertex) {
	if (arrangement.options.outputScalar == OutputScalar::Double) {
		return arrangement.coordinates(vertex);
	}
	const ExactPoint exact = exactPoint(arrangement, vertex);
	return {roundedToFloat(exact, 0), roundedToFloat(exact, 1), roundedToFloat(exact, 2)};
}

Status weldPoints(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor) {
	return Welder(arrangement, contacts, monitor).run();
}

}  // namespace index_boolean
