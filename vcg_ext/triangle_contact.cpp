// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signs of the corners of each face against the plane of the other, then signs of edge against
// edge: that is all. An edge pierces a face if its ends lie on different sides of the plane and it
// passes all three edges of the face on the same side.
#include "triangle_contact.h"

#include "exact_sign.h"
#include "parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

using Signs = std::array<int, 3>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Both faces of a pair with the signs between them. Face 0 is operand 0's.
class PairSigns {
public:
	PairSigns(const MeshArrays& mesh, FacePair pair) : mesh_(mesh), face_{pair.a, pair.b} {
		corners_[0] = &at(mesh.triangles, pair.a);
		corners_[1] = &at(mesh.triangles, pair.b);
	}

	// False if one face lies strictly on one side of the other's plane: no contact.
	bool straddle() {
		return cornersAgainstPlane(0) && cornersAgainstPlane(1);
	}

	int side(int face, int corner) const { return side_[index(face)][index(corner)]; }
	FaceId face(int k) const { return face_[index(k)]; }
	VertexId corner(int face, int i) const { return (*corners_[index(face)])[index(i)]; }
	const Point& point(int face, int i) const { return at(mesh_.points, corner(face, i)); }
	const Triangle& triangle(int face) const { return *corners_[index(face)]; }
	const MeshArrays& mesh() const { return mesh_; }

	// The side on which edge i of face 0 passes edge j of face 1; computed once.
	int edgeAgainstEdge(int i, int j) {
		int& sign = edges_[index(3 * i + j)];
		if (sign == kUnknownSign) {
			sign = orient3d(point(0, i), point(0, nextCorner(i)), point(1, j),
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

	bool edgeStraddles(int face, int i) const {
		return side(face, i) * side(face, nextCorner(i)) < 0;
	}

private:
	bool cornersAgainstPlane(int face) {
		const int other = 1 - face;
		for (int i = 0; i < 3; ++i) {
			side_[index(face)][index(i)] =
			    orient3d(point(other, 0), point(other, 1), point(other, 2), point(face, i));
		}
		const Signs& s = side_[index(face)];
		return !(s[0] == s[1] && s[1] == s[2] && s[0] != 0);
	}

	const MeshArrays& mesh_;
	std::array<FaceId, 2> face_;
	std::array<const Triangle*, 2> corners_{};
	std::array<Signs, 2> side_{};
	std::array<int, 9> edges_{kUnknownSign, kUnknownSign, kUnknownSign,
	                          kUnknownSign, kUnknownSign, kUnknownSign,
	                          kUnknownSign, kUnknownSign, kUnknownSign};
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
	return {PointKind::EdgeFace, {edge[0], edge[1], signs.face(1 - face).value, 0}};
}

// The ends of the segment in which two faces cross, as edges that pierce faces.
struct Ends {
	std::array<int, 2> found{};  // begins, ends
	NamedSegment segment{};

	// Takes in edge i of a face, which pierces the other face. Along normal(a) x normal(b) a
	// segment begins on a where its border goes up through b's plane, on b where its border goes
	// down through a's plane.
	void add(const PairSigns& signs, int face, int i) {
		const bool upwards = signs.side(face, i) < 0;
		const bool begins = upwards == (face == 0);
		(begins ? segment.begin : segment.end) = edgeFaceName(signs, face, i);
		++found[begins ? 0 : 1];
	}

	// Writes the contact if the ends are those of none or one segment.
	bool finish(const PairSigns& signs, PairContact& out) {
		segment.a = signs.face(0);
		segment.b = signs.face(1);
		out.generic = true;
		out.meets = found[0] == 1;
		out.segment = segment;
		return found[0] == found[1] && found[0] <= 1;
	}
};

// The contact of a pair none of whose signs that matter is zero. False where one is: the pair then
// needs NamedPoints.
bool genericContact(PairSigns& signs, Ends& ends) {
	for (int face = 0; face < 2; ++face) {
		for (int i = 0; i < 3; ++i) {
			if (signs.side(face, i) == 0) {
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
		out_.pointCount = 0;
		for (int face = 0; face < 2; ++face) {
			int sign = 0;
			axis_[index(face)] =
			    projectionAxis(signs.triangle(face), signs.mesh().points, sign);
		}
	}

	// The ends of the segment, if the points turn out to be those of a generic contact.
	Ends& ends() { return ends_; }

	void collect() {
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
	}

private:
	void add(const PointName& name) {
		PointName* end = out_.points.begin() + out_.pointCount;
		if (std::find(out_.points.begin(), end, name) == end &&
		    out_.pointCount < PairContact::kMostPoints) {
			*end = name;
			++out_.pointCount;
		}
	}

	// A corner in the plane of the other face: inside it, on an edge, on a corner, or away.
	void addCorner(int face, int i) {
		const int other = 1 - face;
		Signs s;
		for (int j = 0; j < 3; ++j) {
			s[index(j)] = orient2d(signs_.point(other, j), signs_.point(other, nextCorner(j)),
			                       signs_.point(face, i), axis_[index(other)]);
		}
		if (mixed(s)) {
			return;
		}
		const std::uint32_t v = signs_.corner(face, i).value;
		const auto zeros = std::count(s.begin(), s.end(), 0);
		const int j = static_cast<int>(std::find(s.begin(), s.end(), 0) - s.begin());
		if (zeros == 0) {
			add({PointKind::VertexFace, {v, signs_.face(other).value, 0, 0}});
		} else if (zeros == 1) {
			const auto edge =
			    sortedEdge(signs_.corner(other, j), signs_.corner(other, nextCorner(j)));
			add({PointKind::VertexEdge, {v, edge[0], edge[1], 0}});
		} else {
			// On the lines of two edges: the corner they share.
			const int k = s[index(nextCorner(j))] == 0 ? nextCorner(j) : j;
			const std::uint32_t w = signs_.corner(other, k).value;
			add({PointKind::VertexVertex, {std::min(v, w), std::max(v, w), 0, 0}});
		}
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
		if (signs_.edgeAgainstEdge(i, j) != 0) {
			return;
		}
		const Point& a = signs_.point(0, i);
		const Point& b = signs_.point(0, nextCorner(i));
		const Point& c = signs_.point(1, j);
		const Point& d = signs_.point(1, nextCorner(j));
		for (int axis = 0; axis < 3; ++axis) {
			const int sideC = orient2d(a, b, c, axis), sideD = orient2d(a, b, d, axis);
			const int sideA = orient2d(c, d, a, axis), sideB = orient2d(c, d, b, axis);
			if (sideC * sideD < 0 && sideA * sideB < 0) {
				const auto first = sortedEdge(signs_.corner(0, i), signs_.corner(0, nextCorner(i)));
				const auto second =
				    sortedEdge(signs_.corner(1, j), signs_.corner(1, nextCorner(j)));
				add({PointKind::EdgeEdge, {first[0], first[1], second[0], second[1]}});
				return;
			}
		}
	}

	PairSigns& signs_;
	PairContact& out_;
	std::array<int, 2> axis_{};
	Ends ends_;
};

}  // namespace

bool contactOf(const MeshArrays& mesh, FacePair pair, PairContact& out) {
	out.generic = true;
	out.meets = false;
	PairSigns signs(mesh, pair);
	if (!signs.straddle()) {
		return true;
	}
	Ends ends;
	if (genericContact(signs, ends)) {
		return ends.finish(signs, out);
	}
	NamedPoints named(signs, out);
	named.collect();
	const auto isGeneric = [](const PointName& n) { return n.kind == PointKind::EdgeFace; };
	if (std::all_of(out.points.begin(), out.points.begin() + out.pointCount, isGeneric)) {
		return named.ends().finish(signs, out);
	}
	out.generic = false;
	out.meets = true;
	return true;
}

namespace {

// What one chunk of pairs gave.
struct ChunkContacts {
	std::vector<NamedSegment> segments;
	std::vector<FacePair> degenerate;
	bool consistent = true;
};

Status refuseDegenerate(const Arrangement& arrangement, const std::vector<ChunkContacts>& chunks) {
	Status status;
	for (const ChunkContacts& chunk : chunks) {
		if (!chunk.consistent) {
			status.code = StatusCode::InternalError;
			return status;
		}
		for (const FacePair pair : chunk.degenerate) {
			status.code = StatusCode::DegenerateContact;
			if (status.count++ == 0) {
				status.hasPlace = true;
				status.place = at(arrangement.mesh.points, at(arrangement.mesh.triangles, pair.a)[0]);
			}
			status.faces.push_back(arrangement.givenFace(pair.a));
			status.otherFaces.push_back(arrangement.givenFace(pair.b));
		}
	}
	for (auto* faces : {&status.faces, &status.otherFaces}) {
		std::sort(faces->begin(), faces->end());
		faces->erase(std::unique(faces->begin(), faces->end()), faces->end());
	}
	return status;
}

}  // namespace

Status findContacts(const Arrangement& arrangement, const std::vector<FacePair>& pairs,
                    Monitor& monitor, std::vector<NamedSegment>& out) {
	constexpr std::size_t kGrain = 2048;
	std::vector<ChunkContacts> chunks(chunkCount(pairs.size(), kGrain));
	Status status = parallelForChunks(
	    pairs.size(), kGrain, arrangement.options.threads, monitor,
	    [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    PairContact contact;
		    ChunkContacts& found = chunks[chunk];
		    for (std::size_t i = begin; i < end; ++i) {
			    if (!contactOf(arrangement.mesh, pairs[i], contact)) {
				    found.consistent = false;
			    } else if (contact.meets && contact.generic) {
				    found.segments.push_back(contact.segment);
			    } else if (contact.meets) {
				    found.degenerate.push_back(pairs[i]);
			    }
		    }
	    });
	if (status.ok()) {
		status = refuseDegenerate(arrangement, chunks);
	}
	for (const ChunkContacts& chunk : chunks) {
		out.insert(out.end(), chunk.segments.begin(), chunk.segments.end());
	}
	return status;
}

}  // namespace index_boolean
