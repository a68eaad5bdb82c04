// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signs of the corners of each face against the plane of the other, then signs of edge against
// edge: that is all. An edge pierces a face if its ends lie on different sides of the plane and it
// passes all three edges of the face on the same side.
#include "vcg_ext/arrange/triangle_contact.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>

namespace index_boolean {

namespace {

using Signs = std::array<int, 3>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Both faces of a pair with the signs between them. Face 0 is operand 0's.
class PairSigns {
public:
	PairSigns(const Points& points, FacePair pair, const std::array<Triangle, 2>& corners)
	    : points_(points), face_{pair.a, pair.b}, corners_(corners) {}

	// Takes the signs of a face's corners. False if it lies strictly on one side of the other's
	// plane: no contact.
	bool reachesPlane(int face) {
		const int other = 1 - face;
		for (int i = 0; i < 3; ++i) {
			const bool common = cornerAt(other, corner(face, i)) >= 0;
			common_[index(face)][index(i)] = common;
			side_[index(face)][index(i)] = common ? 0
			                                      : orient3d(point(other, 0), point(other, 1),
			                                                 point(other, 2), point(face, i));
		}
		const Signs& s = side_[index(face)];
		return !(s[0] == s[1] && s[1] == s[2] && s[0] != 0);
	}

	// Whether a face, but for corners common to both, lies strictly on one side of the other's
	// plane: then these corners, and the edge between them, are all that the faces have in common.
	bool touchesInCommonCorners(int face) const {
		int strictSide = 0;
		for (int i = 0; i < 3; ++i) {
			if (common_[index(face)][index(i)]) {
				continue;
			}
			if (side(face, i) == 0 || side(face, i) == -strictSide) {
				return false;
			}
			strictSide = side(face, i);
		}
		return strictSide != 0;
	}

	int side(int face, int corner) const { return side_[index(face)][index(corner)]; }
	FaceId face(int k) const { return face_[index(k)]; }
	VertexId corner(int face, int i) const { return corners_[index(face)][index(i)]; }
	const Point& point(int face, int i) const { return at(points_, corner(face, i)); }
	const Triangle& triangle(int face) const { return corners_[index(face)]; }
	const Points& points() const { return points_; }

	// Whether edge i of face 0 and edge j of face 1 have an end in common.
	bool haveCommonEnd(int i, int j) const {
		return isCorner(1, corner(0, i), j) || isCorner(1, corner(0, nextCorner(i)), j);
	}

	// The side on which edge i of face 0 passes edge j of face 1; computed once.
	int edgeAgainstEdge(int i, int j) {
		int& sign = edges_[index(3 * i + j)];
		if (sign == kUnknownSign) {
			sign = haveCommonEnd(i, j) ? 0
			                           : orient3d(point(0, i), point(0, nextCorner(i)), point(1, j),
			                                      point(1, nextCorner(j)));
		}
		return sign;
	}

	// How edge i of a face passes the edges of the other face.
	Signs edgeAgainstFace(int face, int i) {
		Signs signs;
		for (int j = 0; j < 3; ++j) {
			signs[index(j)] = face == 0 ? edgeAgainstEdge(i, j) : edgeAgainstEdge(j, i);
		}
		return signs;
	}

	bool coplanar() const { return side_[0] == Signs{} && side_[1] == Signs{}; }

	// The corner of a face that is the given vertex, or -1.
	int cornerAt(int face, VertexId v) const {
		for (int i = 0; i < 3; ++i) {
			if (corner(face, i) == v) {
				return i;
			}
		}
		return -1;
	}

	bool edgeStraddles(int face, int i) const {
		return side(face, i) * side(face, nextCorner(i)) < 0;
	}

private:
	// Whether a vertex is an end of edge j of a face.
	bool isCorner(int face, VertexId v, int j) const {
		return corner(face, j) == v || corner(face, nextCorner(j)) == v;
	}

	const Points& points_;
	std::array<FaceId, 2> face_;
	const std::array<Triangle, 2>& corners_;
	std::array<Signs, 2> side_{};
	std::array<std::array<bool, 3>, 2> common_{};  // per corner: it is one of the other face too
	std::array<int, 9> edges_{kUnknownSign, kUnknownSign, kUnknownSign, kUnknownSign, kUnknownSign,
	                          kUnknownSign, kUnknownSign, kUnknownSign, kUnknownSign};
};

bool allEqual(const Signs& s) { return s[0] == s[1] && s[1] == s[2]; }

// Both signs occur: the line misses the face.
bool mixed(const Signs& s) {
	const auto [low, high] = std::minmax({s[0], s[1], s[2]});
	return low < 0 && high > 0;
}

std::array<std::uint32_t, 2> sortedEdge(VertexId a, VertexId b) {
	return {std::min(a.value, b.value), std::max(a.value, b.value)};
}

PointName edgeFaceName(const PairSigns& signs, int face, int i) {
	const auto edge = sortedEdge(signs.corner(face, i), signs.corner(face, nextCorner(i)));
	return {PointKind::EdgeFace, 0, {edge[0], edge[1], signs.face(1 - face).value, 0}};
}

// The ends of the segment in which two faces cross, as edges that pierce faces.
struct Ends {
	std::array<std::size_t, 2> found{};  // begins, ends
	std::array<PointName, 2> names{};

	// Takes in edge i of a face, which pierces the other face. Along normal(a) x normal(b) a
	// segment begins on a where its border goes up through b's plane, on b where its border goes
	// down through a's plane.
	void add(const PairSigns& signs, int face, int i) {
		const bool upwards = signs.side(face, i) < 0;
		const std::size_t end = upwards == (face == 0) ? 0 : 1;
		names[end] = edgeFaceName(signs, face, i);
		++found[end];
	}

	// Writes the contact if the ends are those of none or one segment.
	bool finish(PairContact& out) const {
		out.generic = true;
		out.count = 2 * found[0];
		std::copy(names.begin(), names.end(), out.points.begin());
		return found[0] == found[1] && found[0] <= 1;
	}
};

// Whether the edges in which face 0 crosses the plane of face 1 both pass one edge of face 1 on the
// outside: then what face 0 has in that plane lies beyond that edge, and the faces have no point in
// common. Most pairs that both reach each other's plane are told apart so, by a few of their signs.
// \pre no corner of face 0 lies in the plane
bool passesOutside(PairSigns& signs) {
	std::array<int, 2> crossing{};
	int count = 0;
	for (int i = 0; i < 3; ++i) {
		if (signs.edgeStraddles(0, i)) {
			crossing[index(count++)] = i;
		}
	}
	// An edge that goes up through the face passes all of the face's edges on the positive side.
	const auto isOutside = [&](int i, int j) {
		const int inside = signs.side(0, i) < 0 ? 1 : -1;
		return signs.edgeAgainstEdge(i, j) == -inside;
	};
	for (int j = 0; j < 3; ++j) {
		if (isOutside(crossing[0], j) && isOutside(crossing[1], j)) {
			return true;
		}
	}
	return false;
}

// The contact of a pair none of whose signs that matter is zero. False where one is: the pair then
// needs NamedPoints.
bool genericContact(PairSigns& signs, Ends& ends) {
	const auto isZero = [&](int face, int i) { return signs.side(face, i) == 0; };
	if (isZero(0, 0) || isZero(0, 1) || isZero(0, 2)) {
		return false;
	}
	if (passesOutside(signs)) {
		return true;
	}
	for (int face = 0; face < 2; ++face) {
		for (int i = 0; i < 3; ++i) {
			if (isZero(face, i)) {
				return false;
			}
			if (!signs.edgeStraddles(face, i)) {
				continue;
			}
			const Signs passes = signs.edgeAgainstFace(face, i);
			if (mixed(passes)) {
				continue;
			}
			if (!allEqual(passes)) {
				return false;
			}
			ends.add(signs, face, i);
		}
	}
	return true;
}

// Collects the names of the points of one pair, each once.
class NamedPoints {
public:
	NamedPoints(PairSigns& signs, PairContact& out) : signs_(signs), out_(out) {
		sides_.fill(kUnknownSign);
	}

	// False if there are more points than a pair of triangles can have.
	bool collect() {
		for (int face = 0; face < 2; ++face) {
			for (int i = 0; i < 3; ++i) {
				if (signs_.side(face, i) == 0) {
					addCorner(face, i);
				}
			}
		}
		for (int i = 0; i < 3; ++i) {
			addPiercing(0, i);
			addPiercing(1, i);
			for (int j = 0; j < 3; ++j) {
				addCrossing(i, j);
			}
		}
		return !overflow_ && (signs_.coplanar() || out_.count <= 2);
	}

	// The ends of the segment, if the points turn out to be those of a generic contact.
	const Ends& ends() const { return ends_; }

private:
	void add(const PointName& name) {
		PointName* end = out_.points.begin() + out_.count;
		if (std::find(out_.points.begin(), end, name) != end) {
			return;
		}
		if (out_.count == PairContact::kMostPoints) {
			overflow_ = true;
			return;
		}
		*end = name;
		++out_.count;
	}

	int axisOf(int face) {
		int& axis = axis_[index(face)];
		if (axis < 0) {
			int sign = 0;
			axis = projectionAxis(signs_.triangle(face), signs_.points(), sign);
		}
		return axis;
	}

	// The side of edge j of the other face on which corner i of a face lies, in its plane; computed
	// once. Faces in one plane have one projection.
	int sideOfEdge(int face, int i, int j) {
		const int other = 1 - face;
		int& sign = sides_[index(9 * face + 3 * i + j)];
		if (sign == kUnknownSign) {
			const VertexId v = signs_.corner(face, i);
			const bool isEnd =
			    v == signs_.corner(other, j) || v == signs_.corner(other, nextCorner(j));
			sign = isEnd ? 0
			             : orient2d(signs_.point(other, j), signs_.point(other, nextCorner(j)),
			                        signs_.point(face, i), axisOf(signs_.coplanar() ? 0 : other));
		}
		return sign;
	}

	// A corner in the plane of the other face: a common corner, inside it, on an edge, or away.
	void addCorner(int face, int i) {
		const int other = 1 - face;
		const VertexId v = signs_.corner(face, i);
		if (signs_.cornerAt(other, v) >= 0) {
			add({PointKind::Vertex, 0, {v.value, 0, 0, 0}});
			return;
		}
		const Signs s{sideOfEdge(face, i, 0), sideOfEdge(face, i, 1), sideOfEdge(face, i, 2)};
		const auto zero = std::find(s.begin(), s.end(), 0);
		if (mixed(s)) {
			return;
		}
		if (zero == s.end()) {
			add({PointKind::Vertex, 0, {v.value, 0, 0, 0}});
			return;
		}
		const int j = static_cast<int>(zero - s.begin());
		const auto edge = sortedEdge(signs_.corner(other, j), signs_.corner(other, nextCorner(j)));
		add({PointKind::OnEdge, 0, {v.value, edge[0], edge[1], 0}});
	}

	// An edge that goes through the plane of the other face, strictly, and through the face's
	// inside. (Through its border: a crossing, or a corner on the edge.)
	void addPiercing(int face, int i) {
		if (!signs_.edgeStraddles(face, i)) {
			return;
		}
		const Signs passes = signs_.edgeAgainstFace(face, i);
		if (allEqual(passes) && passes[0] != 0) {
			add(edgeFaceName(signs_, face, i));
			ends_.add(signs_, face, i);
		}
	}

	// Two edges in one plane that cross inside both.
	void addCrossing(int i, int j) {
		if (signs_.haveCommonEnd(i, j)) {
			return;
		}
		int axis = axisOf(0);
		if (signs_.coplanar()) {
			const int sideC = sideOfEdge(1, j, i), sideD = sideOfEdge(1, nextCorner(j), i);
			if (sideC * sideD >= 0 || sideOfEdge(0, i, j) * sideOfEdge(0, nextCorner(i), j) >= 0) {
				return;
			}
		} else if (signs_.edgeAgainstEdge(i, j) != 0 || !crossInSomeProjection(i, j, axis)) {
			return;
		}
		const auto first = sortedEdge(signs_.corner(0, i), signs_.corner(0, nextCorner(i)));
		const auto second = sortedEdge(signs_.corner(1, j), signs_.corner(1, nextCorner(j)));
		add({PointKind::EdgeEdge,
		     static_cast<std::uint8_t>(axis),
		     {first[0], first[1], second[0], second[1]}});
	}

	// For edges known to lie in one plane; writes the projection in which they are not parallel.
	bool crossInSomeProjection(int i, int j, int& axis) const {
		const Point& a = signs_.point(0, i);
		const Point& b = signs_.point(0, nextCorner(i));
		const Point& c = signs_.point(1, j);
		const Point& d = signs_.point(1, nextCorner(j));
		for (axis = 0; axis < 3; ++axis) {
			if (orient2d(a, b, c, axis) * orient2d(a, b, d, axis) < 0 &&
			    orient2d(c, d, a, axis) * orient2d(c, d, b, axis) < 0) {
				return true;
			}
		}
		return false;
	}

	PairSigns& signs_;
	PairContact& out_;
	std::array<int, 2> axis_{-1, -1};  // found when first asked for
	std::array<int, 18> sides_{};
	Ends ends_;
	bool overflow_ = false;
};

void addCommonCorners(const PairSigns& signs, PairContact& out) {
	for (int i = 0; i < 3; ++i) {
		if (signs.cornerAt(1, signs.corner(0, i)) >= 0) {
			out.points[out.count++] = {PointKind::Vertex, 0, {signs.corner(0, i).value, 0, 0, 0}};
		}
	}
}

}  // namespace

bool contactOf(const MeshArrays& mesh, FacePair pair, PairContact& out) {
	return contactOf(mesh.points, pair, {at(mesh.triangles, pair.a), at(mesh.triangles, pair.b)},
	                 out);
}

bool contactOf(const Points& points, FacePair pair, const std::array<Triangle, 2>& corners,
               PairContact& out) {
	out.generic = false;
	out.count = 0;
	PairSigns signs(points, pair, corners);
	for (int face = 0; face < 2; ++face) {
		if (!signs.reachesPlane(face)) {
			return true;
		}
		if (signs.touchesInCommonCorners(face)) {
			addCommonCorners(signs, out);
			return true;
		}
	}
	Ends ends;
	if (genericContact(signs, ends)) {
		return ends.finish(out);
	}
	NamedPoints named(signs, out);
	if (!named.collect()) {
		return false;
	}
	const auto isGeneric = [](const PointName& n) { return n.kind == PointKind::EdgeFace; };
	return std::all_of(out.points.begin(), out.points.begin() + out.count, isGeneric)
	           ? named.ends().finish(out)
	           : true;
}

namespace {

// What one chunk of pairs gave.
struct ChunkContacts {
	Contacts contacts;
	bool consistent = true;
};

void append(Contacts& all, const Contacts& some) {
	const auto offset = static_cast<std::uint32_t>(all.names.size());
	all.names.insert(all.names.end(), some.names.begin(), some.names.end());
	for (NamedContact contact : some.pairs) {
		contact.first += offset;
		all.pairs.push_back(contact);
	}
}

void append(Contacts& all, FacePair pair, const PairContact& contact) {
	all.pairs.push_back({pair.a, pair.b, static_cast<std::uint32_t>(all.names.size()),
	                     static_cast<std::uint8_t>(contact.count), contact.generic});
	all.names.insert(all.names.end(), contact.points.begin(),
	                 contact.points.begin() + contact.count);
}

}  // namespace

Status findContacts(const Arrangement& arrangement, const std::vector<FacePair>& pairs,
                    Monitor& monitor, Contacts& out) {
	constexpr std::size_t kGrain = 2048;
	std::vector<ChunkContacts> chunks(chunkCount(pairs.size(), kGrain));
	Status status = parallelForChunks(pairs.size(), kGrain, arrangement.options.threads, monitor,
	                                  [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                                  PairContact contact;
		                                  ChunkContacts& found = chunks[chunk];
		                                  for (std::size_t i = begin; i < end; ++i) {
			                                  if (!contactOf(arrangement.mesh, pairs[i], contact)) {
				                                  found.consistent = false;
			                                  } else if (contact.count > 0) {
				                                  append(found.contacts, pairs[i], contact);
			                                  }
		                                  }
	                                  });
	for (const ChunkContacts& chunk : chunks) {
		if (!chunk.consistent) {
			status.code = StatusCode::InternalError;
		}
		append(out, chunk.contacts);
	}
	return status;
}

}  // namespace index_boolean
