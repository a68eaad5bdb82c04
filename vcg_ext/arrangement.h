// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arrangement: everything one intersection run knows, as plain arrays. Computed once by
// arrange(); every output (blocks now, sub-surfaces and curves later) is read from it.
#pragma once

#include "mesh_arrays.h"

#include <string>

namespace index_boolean {

// The scalar that output coordinates are rounded to, once.
enum class OutputScalar : std::uint8_t { Double, Float };

struct Options {
	int octreeMaxDepth = 12;  // 1 to 20
	int octreeLeafSize = 0;   // 0: the cost rule; else a node with Na*Nb <= leafSize^2 is a leaf
	int threads = 0;          // 0: as many as OpenMP gives
	OutputScalar outputScalar = OutputScalar::Double;
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

// A point of the curve is named by the pair of lowest simplices that meet there, one of each
// operand; equal names are one point (unique, as long as no operand touches itself).
enum class PointKind : std::uint8_t {
	VertexVertex,  // ids: vertex, vertex
	VertexEdge,    // ids: vertex, edge's lower vertex, edge's higher vertex
	VertexFace,    // ids: vertex, face
	EdgeEdge,      // ids: lower, higher vertex of the first operand's edge, then the second's
	EdgeFace,      // ids: edge's lower vertex, edge's higher vertex, face
};

struct PointName {
	PointKind kind;
	std::array<std::uint32_t, 4> ids;

	friend bool operator==(const PointName& a, const PointName& b) {
		return a.kind == b.kind && a.ids == b.ids;
	}
	friend bool operator<(const PointName& a, const PointName& b) {
		return a.kind != b.kind ? a.kind < b.kind : a.ids < b.ids;
	}
};

// One edge of the intersection curve: where the faces a (of operand 0) and b (of operand 1) cross.
// Directed along normal(a) x normal(b): on a, the inside of operand 1 is to its left; on b, the
// inside of operand 0 to its right.
struct Segment {
	PointId begin, end;
	FaceId a, b;
};

// An input edge with points on it: pointsOnEdges[first .. first + count) in order from `low` on.
struct CutEdge {
	VertexId low, high;  // low < high
	std::uint32_t first, count;
};

// The points of the curve, the edges they lie on, and the segments between them. Points are sorted
// by name, cut edges by their vertices, segments by their faces.
struct Curve {
	std::vector<PointName> names;
	std::vector<Point> rounded;  // each point's coordinates, correctly rounded to double
	std::vector<CutEdge> cutEdges;
	std::vector<PointId> pointsOnEdges;
	std::vector<Segment> segments;

	std::size_t pointCount() const { return names.size(); }
};

// A label node: an input vertex, an interval between neighbouring points of a cut edge (numbered
// after the vertices, as the left one of its points in pointsOnEdges), or a region of a cut face
// (numbered after the intervals).
using NodeId = Id<struct NodeTag>;

// A face that the curve cuts: pieces[firstPiece .. next cut face's), turned as the face is.
struct CutFace {
	FaceId face;
	std::uint32_t firstPiece;
};

// The regions to both sides of a segment, on each of its two faces.
struct SegmentSides {
	std::array<NodeId, 2> left, right;  // by operand
};

// Both surfaces refined by the curve.
struct Refinement {
	std::vector<CutFace> cutFaces;  // sorted by face
	std::vector<Triangle> pieces;
	std::vector<NodeId> pieceRegion;             // per piece
	std::vector<SegmentSides> sides;             // per segment
	std::vector<std::array<NodeId, 2>> links;    // nodes that have one label: (region, other)
	std::uint32_t nodeCount = 0;
	std::vector<std::uint8_t> isCut;             // per face
};

// What lies inside the other operand. Values: 0 outside, 1 inside; vertices no face uses: kUnused.
constexpr std::uint8_t kUnused = 2;
struct Labels {
	std::vector<std::uint8_t> vertexInside;  // per input vertex
	std::vector<std::uint8_t> pieceInside;   // per piece
	std::array<std::uint32_t, 2> components{};  // vertex-connected components of each operand
};

// One maximal chain of the curve, as consecutive points; the first is repeated at the end of a
// closed one.
enum class LoopKind : std::uint8_t { Open, HardClosed, SoftClosed };
struct Loop {
	LoopKind kind;
	std::vector<PointId> points;
};

struct Arrangement {
	Options options;
	MeshArrays mesh;                       // welded, without degenerate faces, right side out
	std::vector<std::uint32_t> faceGiven;  // per face: its index in the operand as given; see below
	std::array<bool, 2> turned{};          // the operand was inside out and has been turned
	std::array<double, 2> volume{};        // of each operand
	Curve curve;
	Refinement refinement;
	std::vector<Loop> loops;
	LoopCounts loopCounts;
	Labels labels;
	std::vector<StageTime> stageTimes;     // in the order of the stages

	// The index of a face in its operand's triangles as given. faceGiven is empty while no face has
	// been dropped or split.
	std::uint32_t givenFace(FaceId f) const {
		return faceGiven.empty() ? f.value - (mesh.operandOf(f) == 0 ? 0 : mesh.faceBegin[1])
		                         : at(faceGiven, f);
	}
	VertexId vertexOf(PointId p) const {
		return {static_cast<std::uint32_t>(mesh.points.size()) + p.value};
	}
	bool isCurvePoint(VertexId v) const { return v.value >= mesh.points.size(); }
	PointId pointOf(VertexId v) const {
		return {v.value - static_cast<std::uint32_t>(mesh.points.size())};
	}
	// Coordinates of an input vertex or of a curve point (rounded to double).
	const Point& coordinates(VertexId v) const {
		return isCurvePoint(v) ? at(curve.rounded, pointOf(v)) : at(mesh.points, v);
	}
};

}  // namespace index_boolean
