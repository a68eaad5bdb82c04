// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arrangement: everything one intersection run knows, as plain arrays. Computed once; every
// output (blocks, sub-surfaces, sub-blocks, curves) is read from it.
// Each field is filled by one stage, named in square brackets above it, and only read from then on;
// before that it is empty. The stages are those of docs/architecture.md, in their order.
#pragma once

#include "vcg_ext/mesh/element_counts.h"
#include "vcg_ext/mesh/mesh_arrays.h"
#include "vcg_ext/mesh/near_vertices.h"
#include "vcg_ext/mesh/sourced_mesh.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>

namespace index_boolean {

// The scalar that output coordinates are rounded to, once.
enum class OutputScalar : std::uint8_t { Double, Float };

// What is done about operands that meet themselves: their faces cross, touch or lie on one another.
enum class SelfIntersections : std::uint8_t {
	Resolve,  // each operand is searched; one that meets itself is what its winding rule says
	Trust,   // no search: the caller knows that there are none; what shows all the same is resolved
	Refuse,  // each operand is searched; one that meets itself is refused
};

// What is inside an operand that meets itself, by the winding number of its surface.
enum class WindingRule : std::uint8_t { Nonzero, Positive, Odd };

struct Options {
	int octreeMaxDepth = 12;  // 1 to 20
	int octreeLeafSize = 0;   // 0: the cost rule; else a node with Na*Nb <= leafSize^2 is a leaf
	int threads = 0;          // 0: as many as there are
	OutputScalar outputScalar = OutputScalar::Double;
	bool mergeFragments = true;    // cuts that part nothing in a block leave no trace in it
	bool mergeCoplanar = false;    // and coplanar neighbours become one face, as far as they can
	bool weldNonManifold = false;  // where a block meets itself, it keeps one vertex, not copies
	SelfIntersections selfIntersections = SelfIntersections::Trust;
	WindingRule windingRule = WindingRule::Nonzero;
	bool certify =
	    true;  // repair places so that what is delivered holds as stored, and say if it does
	bool thoroughRepair = true;  // where few faces do not hold, many places are tried for each
	double weldDistance = 0;     // vertices of one operand that are nearer than this become one
	double mergeTolerance = 0;   // walls that lie within this of one plane become one polygon
	// How many there may be of anything that a run numbers: vertices, faces, points of contact,
	// pieces; of corners and label nodes, twice as many. More is TooLarge. Raising it does nothing.
	std::size_t mostElements = kMostElements;
};

// Counts of the maximal chains of intersection edges (the paper's loops).
struct LoopCounts {
	std::size_t open = 0;        // an end of degree one
	std::size_t hardClosed = 0;  // a cycle without junction
	std::size_t softClosed = 0;  // both ends are junctions
};

struct StageTime {
	const char* stage;
	double seconds;
};

// A point of contact is named by the lowest simplices that meet there: two, or three faces. Equal
// names are one point; in a soup a point may have several names, of which the smallest stands for
// it. Vertices in one place have been welded: they are one vertex from the beginning.
enum class PointKind : std::uint8_t {
	Vertex,        // ids: a vertex common to two faces, or of one inside the other
	OnEdge,        // ids: vertex; lower, higher vertex of an edge
	EdgeEdge,      // ids: lower, higher vertex of an edge, then of another; of two operands, the
	               // first one's edge comes first, in a soup the smaller edge
	EdgeFace,      // ids: lower, higher vertex of an edge; a face
	FaceFaceFace,  // ids: three faces, ascending; in a soup only
};

struct PointName {
	PointKind kind;
	std::uint8_t axis;  // EdgeEdge: where the edges are not parallel; not a part of the name
	std::array<std::uint32_t, 4> ids;

	friend bool operator==(const PointName& a, const PointName& b) {
		return a.kind == b.kind && a.ids == b.ids;
	}
	friend bool operator<(const PointName& a, const PointName& b) {
		return a.kind != b.kind ? a.kind < b.kind : a.ids < b.ids;
	}
};

// One edge of the intersection curve. `crossing`: the faces a (of operand 0) and b (of operand 1)
// cross there, inside both; then it is directed along normal(a) x normal(b): on a, the inside of
// operand 1 is to its left; on b, the inside of operand 0 to its right. Else more faces meet there,
// or the direction means nothing; in a soup it never does, and a and b are any two faces.
struct Segment {
	VertexId begin, end;
	FaceId a, b;
	bool crossing;
};

// A segment as one face sees it.
struct FaceSegment {
	FaceId face;
	SegmentId segment;
};

// A vertex of one operand inside a face of the other.
struct FaceVertex {
	FaceId face;
	VertexId vertex;
};

// An input edge with points on it, or with both ends on the other operand:
// pointsOnEdges[first .. first + count) in order from `low` on. Its count + 1 intervals are
// numbered from firstInterval on.
struct CutEdge {
	VertexId low, high;  // low < high
	std::uint32_t first, count;
	std::uint32_t firstInterval;
};

// The points of contact, the edges they lie on, and the segments between them. New points are
// sorted by name, cut edges by their vertices, segments by their first pair of faces.
// All are empty where the operands do not meet, but for onOther and irregular.
struct Curve {
	// [curve_points]
	std::vector<PointName> names;  // of the new points
	Points rounded;                // their coordinates, correctly rounded to double
	std::vector<std::uint8_t>
	    onOther;  // per input vertex: it lies on the other operand; in a soup,
	              // on a face that has no corner there, or two operands have it
	std::vector<FaceId> touchedFaces;  // sorted
	// [cut_lines]
	std::vector<CutEdge> cutEdges;
	std::vector<VertexId> pointsOnEdges;
	std::vector<Segment> segments;
	std::vector<FaceSegment> faceSegments;  // sorted by face
	std::vector<FaceVertex> faceVertices;   // sorted by face, then by vertex; each once
	// Per input vertex and new point: on the curve, and more happens there than one edge passing
	// through one face. Only there can a block meet itself, or a cut part nothing.
	std::vector<std::uint8_t> irregular;

	std::size_t pointCount() const { return names.size(); }
	std::size_t intervalCount() const { return pointsOnEdges.size() + cutEdges.size(); }
};

// A label node: an input vertex, an interval of a cut edge (numbered after the vertices), or a
// region of a touched face (numbered after the intervals).
using NodeId = Id<struct NodeTag>;

// A face that the other operand touches: pieces[firstPiece .. next one's), turned as the face is.
struct CutFace {
	FaceId face;
	std::uint32_t firstPiece;
};

// The regions of one face to both sides of a segment on it; one of them is none() where the segment
// lies on the face's border.
struct SegmentSide {
	SegmentId segment;
	FaceId face;
	NodeId left, right;
};

// Both surfaces refined by the curve. All are empty where the operands do not meet, but for isCut
// and nodeCount, which is then the number of input vertices.
struct Refinement {
	// [retriangulate]
	HugeVector<CutFace> cutFaces;  // sorted by face
	Triangles pieces;
	HugeVector<NodeId> pieceRegion;                 // per piece
	HugeVector<SegmentSide> sides;                  // sorted by segment, then by face
	HugeVector<std::array<NodeId, 2>> links;        // nodes that have one label: (region, other)
	HugeVector<std::array<NodeId, 2>> cornerLinks;  // (region, corner on the other operand)
	std::uint32_t nodeCount = 0;
	std::vector<std::uint8_t> isCut;  // per face: it is one of cutFaces

	// The pieces of a cut face: pieces[begin .. end).
	struct PieceRange {
		std::size_t begin, end;
	};
	// \param i index into cutFaces
	PieceRange piecesOf(std::size_t i) const {
		return {cutFaces[i].firstPiece,
		        i + 1 < cutFaces.size() ? cutFaces[i + 1].firstPiece : pieces.size()};
	}
};

// Where an element of one operand lies with respect to the other. On*: a piece of a face that lies
// in the other's surface, whose normal there points the same way or the opposite way.
enum class Label : std::uint8_t { Outside, Inside, OnSame, OnOpposite, OnVertex, Unused, Unknown };
constexpr std::size_t kLabelCount = 7;

// Empty when splitting, which needs no labels.
struct Labels {
	// [labels]
	std::vector<Label> vertex;             // per input vertex: Outside, Inside, OnVertex or Unused
	std::vector<Label> piece;              // per piece: the first four
	PerOperand<std::uint32_t> components;  // vertex-connected components of each operand
	// [overlap_owners]
	// Per piece labelled OnSame, as bits: in these blocks it stands for the overlap, and its twin,
	// the other operand's piece on the same corners, does not. Empty if there is none.
	static constexpr std::uint8_t kOwnerInUnion = 1, kOwnerInIntersection = 2;
	std::vector<std::uint8_t> owner;
};

// The parts that all surfaces together cut space into, by number; cell 0 is the unbounded outside.
// Walls that no operand's winding number changes across are no walls. Empty unless the arrangement
// is a soup's, for blocks.
struct CellLabels {
	using Sides = std::array<std::uint32_t, 2>;

	// [cell_labels]
	std::vector<PerOperand<std::int32_t>> windings;  // per cell, of each operand; 0 if that is open
	std::vector<double> volume;                      // per cell; of the outside 0
	// Per face that is not cut, and per piece: the cells in front of it and behind it. They are the
	// same where it is no wall, or where another one on its corners stands for it.
	HugeVector<Sides> ofFace, ofPiece;
	// The other input faces that have a piece, too, and whether they are turned the other way; by
	// piece, ascending.
	struct Source {
		std::uint32_t piece;
		FaceId face;
		bool opposed;
	};
	std::vector<Source> otherSources;

	// Calls visit(source) for the other input faces that have a piece. O(log k + m) for m of k.
	template <class Visit>
	void visitOtherSources(std::uint32_t piece, Visit&& visit) const {
		const auto before = [](const Source& s, std::uint32_t p) { return s.piece < p; };
		for (auto s = std::lower_bound(otherSources.begin(), otherSources.end(), piece, before);
		     s != otherSources.end() && s->piece == piece; ++s) {
			visit(*s);
		}
	}

	bool areKnown() const { return !windings.empty(); }
};

// One maximal chain of the curve, as consecutive points; the first is repeated at the end of a
// closed one. Of each of its edges, from one point to the next: two faces that meet there, one of
// each operand.
enum class LoopKind : std::uint8_t { Open, HardClosed, SoftClosed };
struct Loop {
	LoopKind kind;
	std::vector<VertexId> points;
	std::vector<std::array<FaceId, 2>> faces;
};

// Faces of an operand on the same three vertices, which have been dropped.
struct DuplicateFaces {
	PerOperand<std::size_t> cancelledPairs;  // per operand: pairs of a face and its opposite
	PerOperand<std::size_t> takenOnce;       // per operand: faces equal to another that is kept
};

// Which faces of the operands are one polygon. All arrays are empty if no face has a faux edge.
struct Polygons {
	std::vector<FaceId> polygon;  // per face: the first face of its polygon
	std::vector<FaceId> flat;  // per face: the first of those faces of its polygon that lie in one
	                           // plane and are joined to it within that plane
};

// What became of the faces of both refined surfaces that, as stored, meet others wrongly or have no
// area: the faces concerned. All are 0 if there was none.
struct PlaceRepair {
	std::size_t concernedBefore = 0, concernedAfter = 0;  // faces
	std::size_t faultsBefore = 0, faultsAfter = 0;        // pairs and zero-area faces
	std::size_t rounds = 0;                               // over all clusters of such faces
	std::size_t trials = 0;
	double unit = 0;         // the scalar's step at the largest coordinate, if any trial was made
	double largestMove = 0;  // how far a vertex is stored from its correctly rounded place
	bool areFacesFine =
	    false;               // searched: no two of all faces meet wrongly as stored, none is flat
	bool isGivenUp = false;  // there were too many faces, or trials: some have not been tried
	std::vector<VertexId> concerned;  // corners of the faces that are still concerned; ascending
};

struct StoredAgain;

struct Arrangement {
	// [operands], as the caller gave them
	Options options;
	MeshArrays mesh;    // welded, without degenerate faces; for blocks, right side out. Its quiet
	                    // faces and vertices are filled by [coincident_faces], if there are any
	Polygons polygons;  // empty if no face has a faux edge
	std::vector<std::uint32_t> faceGiven;  // per face: its index in the operand as given; empty if
	                                       // no face has been dropped or split
	std::vector<VertexId> nonManifold;     // at which an operand is no manifold; ascending
	PerOperand<bool> seams;                // vertices of the operand in one place have become one
	bool isSoup = false;                   // of any operands, which may meet themselves (soup.h)
	PerOperand<bool> closed;     // each edge of the operand has as many faces each way; in
	                             // a soup, each edge of its pieces, or, for the rule Odd,
	                             // it has an even number of faces
	PerOperand<bool> insideOut;  // the operand is closed and was given inside out; for
	                             // blocks it has been turned
	DuplicateFaces duplicates;
	PerOperand<std::size_t> turnedAlike;       // faces that were turned against their neighbours
	PerOperand<std::size_t> selfIntersecting;  // faces that meet others of the same operand
	                                           // wrongly; [soup_contacts], else 0
	PerOperand<double> volume;  // of each operand that is closed, else 0; in a soup, with what is
	                            // inside out counted as negative
	// [curve_points] and [cut_lines]
	Curve curve;
	// [retriangulate]
	Refinement refinement;
	// [repair_places]: where a vertex is stored, if not in its correctly rounded place; almost
	// always empty. Exact signs do not know of it.
	std::map<VertexId, Point> movedPlaces;
	PlaceRepair placeRepair;
	// [loops]; empty where the operands do not meet
	std::vector<Loop> loops;
	LoopCounts loopCounts;
	// [rounding_loop]: the refined operands as stored, arranged once more, from which blocks are
	// read; null unless faults were left that only this cures.
	std::shared_ptr<const StoredAgain> again;
	// [labels] and [overlap_owners]; empty when splitting, and of a soup
	Labels labels;
	CellLabels cells;
	// [near_vertices]
	VertexWeld vertexWeld;
	// the driver
	std::vector<StageTime> stageTimes;  // in the order of the stages

	// Whether it is known where the operands meet themselves: they have been searched.
	bool areOperandsKnown() const {
		return isSoup || options.selfIntersections != SelfIntersections::Trust;
	}
	// The index of a face in its operand's triangles as given.
	std::uint32_t givenFace(FaceId f) const {
		return faceGiven.empty() ? f.value - mesh.faceOffsets.begin(mesh.operandOf(f))
		                         : at(faceGiven, f);
	}
	VertexId vertexOf(PointId p) const {
		return {static_cast<std::uint32_t>(mesh.points.size()) + p.value};
	}
	bool isCurvePoint(VertexId v) const { return v.value >= mesh.points.size(); }
	PointId pointOf(VertexId v) const {
		return {v.value - static_cast<std::uint32_t>(mesh.points.size())};
	}
	// Whether a vertex lies on the other operand: a new point, or an input vertex in contact.
	bool isOnOther(VertexId v) const { return isCurvePoint(v) || at(curve.onOther, v) != 0; }
	// Coordinates of an input vertex or of a curve point (rounded to double).
	const Point& coordinates(VertexId v) const {
		return isCurvePoint(v) ? at(curve.rounded, pointOf(v)) : at(mesh.points, v);
	}
};

// An arrangement of another one's operands as they are stored, and what its elements are in that
// one.
struct StoredAgain {
	Arrangement arrangement;
	// Per input face: the other's input face that it is a piece of, and whether it has been turned.
	std::vector<FaceSource> faceOf;
	std::vector<std::uint32_t> pieceOf;  // per input face: which piece of that face, or kNone: all
	std::vector<VertexId> vertexOf;      // per input vertex: the other's, or none()
};

// The arrangement that blocks and parts are read from. Complexity: O(1).
inline const Arrangement& asStored(const Arrangement& arrangement) {
	return arrangement.again != nullptr ? arrangement.again->arrangement : arrangement;
}

}  // namespace index_boolean
