// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each cut face becomes a planar problem of its own, known by index: its lines, the points on them,
// the edges between those. A sweep gives the pieces, which are certified before they are kept. Only
// the order and orientation of points are asked of geometry.
#include "vcg_ext/arrange/retriangulate.h"

#include "vcg_ext/arrange/chunk_pieces.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/element_counts.h"

namespace index_boolean {

namespace {

// Euler: a triangulated polygon with b border points and n points in all has 2n - b - 2 triangles
// and 3n - b - 3 edges.
struct EulerCounts {
	std::size_t triangles, edges;

	explicit EulerCounts(const FacePoints& points)
	    : triangles(2 * points.size() - points.borderCount() - 2),
	      edges(triangles + points.size() - 1) {}
};

// Why a chunk of faces was given up.
struct Failure {
	StatusCode code = StatusCode::Ok;
	FaceId face = FaceId::none();  // that touches itself
	std::size_t count = 0;         // of pieces, too many
};

// Cuts the faces of one chunk, with buffers that are used again.
class FaceCutter {
public:
	FaceCutter(const Arrangement& arrangement, const FaceLineFinder& finder, Monitor& monitor,
	           ChunkPieces& out)
	    : arrangement_(arrangement), finder_(finder), monitor_(monitor), out_(out),
	      points_(arrangement) {}

	Failure cut(FaceId face);

private:
	// For between the steps of a face that takes long.
	bool isStopped() const { return points_.size() > kMany && pollCancelled(monitor_); }

	bool findPoints(FaceId face);
	bool findPieces(const EulerCounts& counts);

	static constexpr std::size_t kMany = 4096;

	const Arrangement& arrangement_;
	const FaceLineFinder& finder_;
	Monitor& monitor_;
	ChunkPieces& out_;

	bool seenFromBehind_ = false;
	FaceLines lines_{};
	FacePoints points_;
	FaceEdges edges_;
	std::vector<PlanarEdge> required_;
	PlanarSweep sweep_;
	FacePieces pieces_;
};

// The points on the face's lines, ranked. False if two of the points are one place.
bool FaceCutter::findPoints(FaceId face) {
	int front = 1;
	const int axis =
	    projectionAxis(at(arrangement_.mesh.triangles, face), arrangement_.mesh.points, front);
	if (axis < 0) {
		return false;  // no area: nothing can cross it
	}
	seenFromBehind_ = front < 0;
	return points_.collect(lines_) && !isStopped() && points_.rank(axis) && !isStopped();
}

// The edges between the points, and pieces that contain them. False if the lines cannot all be part
// of one triangulation.
bool FaceCutter::findPieces(const EulerCounts& counts) {
	if (!edges_.fix(arrangement_, lines_, points_, counts.edges)) {
		return false;
	}
	required_.clear();
	for (const FaceEdge& edge : edges_.fixed()) {
		required_.push_back(edge.ranks);
	}
	const auto pointCount = static_cast<std::uint32_t>(points_.size());
	if (!sweep_.triangulate(pointCount, required_, points_, monitor_, pieces_.triangles)) {
		return false;
	}
	if (seenFromBehind_) {
		pieces_.turn();
	}
	return pieces_.triangles.size() == counts.triangles && !isStopped() && pieces_.certify(edges_);
}

Failure FaceCutter::cut(FaceId face) {
	const Failure refused{StatusCode::SelfIntersecting, face, 0};
	finder_.find(face, lines_);
	if (lines_.areEmpty()) {
		out_.appendWhole(arrangement_, lines_);
		return {};
	}
	if (!findPoints(face)) {
		return refused;
	}
	const EulerCounts counts(points_);
	const std::size_t pieceCount = out_.pieces.size() + counts.triangles;
	if (!checkCounts(0, pieceCount, arrangement_.options.mostElements).ok()) {
		return {StatusCode::TooLarge, face, pieceCount};
	}
	if (!findPieces(counts)) {
		return refused;
	}
	pieces_.flip(edges_, points_, seenFromBehind_ ? -1 : 1, monitor_);
	out_.append(arrangement_, face, points_, edges_, pieces_);
	return {};
}

// The other operand's faces with segments on a face that could not be cut. In a soup every face can
// be.
Status refuseFace(const Arrangement& arrangement, FaceId face) {
	const Curve& curve = arrangement.curve;
	const MeshArrays& mesh = arrangement.mesh;
	if (arrangement.isSoup) {
		Status defect = index_boolean::statusOf(StatusCode::InternalError);
		defect.hasPlace = true;
		defect.place = at(mesh.points, at(mesh.triangles, face)[0]);
		return defect;
	}
	const OperandId operand = otherOf(mesh.operandOf(face));
	std::vector<FaceId> faces;
	std::vector<std::uint8_t> onFace(curve.segments.size());
	for (const FaceSegment& s : segmentsOn(curve, face)) {
		at(onFace, s.segment) = 1;
	}
	for (const FaceSegment& s : curve.faceSegments) {
		if (at(onFace, s.segment) != 0 && mesh.operandOf(s.face) == operand) {
			faces.push_back(s.face);
		}
	}
	return selfIntersecting(arrangement, operand, faces,
	                        at(mesh.points, at(mesh.triangles, face)[0]));
}

Status statusOf(const Arrangement& arrangement, const Failure& failure) {
	if (failure.code == StatusCode::SelfIntersecting) {
		return refuseFace(arrangement, failure.face);
	}
	Status status;
	status.code = failure.code;
	status.count = failure.count;
	return status;
}

// Where chunks of the touched faces begin, and the end. A chunk is some faces, or fewer if they
// have many segments: a few large faces are not to keep one thread busy when the other has nothing
// left.
std::vector<std::size_t> chunkBounds(const Curve& curve) {
	constexpr std::size_t kMostFaces = 48;  // less than what waking a thread costs
	constexpr std::size_t kMostSegments = 1024;
	const std::vector<FaceId>& faces = curve.touchedFaces;
	std::vector<std::size_t> bounds{0};
	std::size_t next = 0, first = 0;  // of the segments on faces: of the face, of the chunk
	for (std::size_t i = 0; i < faces.size(); ++i) {
		while (next < curve.faceSegments.size() && !(faces[i] < curve.faceSegments[next].face)) {
			++next;
		}
		if (i + 1 - bounds.back() == kMostFaces || next - first >= kMostSegments ||
		    i + 1 == faces.size()) {
			bounds.push_back(i + 1);
			first = next;
		}
	}
	return bounds;
}

// Cuts the touched faces, chunk by chunk.
Status cutFaces(const Arrangement& arrangement, Monitor& monitor,
                std::vector<ChunkPieces>& chunks) {
	const std::vector<FaceId>& faces = arrangement.curve.touchedFaces;
	const FaceLineFinder finder(arrangement);
	const std::vector<std::size_t> bounds = chunkBounds(arrangement.curve);
	chunks.resize(bounds.size() - 1);
	std::vector<Failure> failures(chunks.size());
	const auto cutChunk = [&](std::size_t chunk, std::size_t, std::size_t) {
		FaceCutter cutter(arrangement, finder, monitor, chunks[chunk]);
		Failure& failure = failures[chunk];
		for (std::size_t i = bounds[chunk]; i < bounds[chunk + 1] && failure.code == StatusCode::Ok;
		     ++i) {
			failure = cutter.cut(faces[i]);
		}
	};
	const Status status =
	    parallelForChunks(chunks.size(), 1, arrangement.options.threads, monitor, cutChunk);
	if (!status.ok()) {
		return status;
	}
	for (const Failure& failure : failures) {
		if (failure.code != StatusCode::Ok) {
			return statusOf(arrangement, failure);
		}
	}
	return {};
}

}  // namespace

Status retriangulate(Arrangement& arrangement, Monitor& monitor) {
	std::vector<ChunkPieces> chunks;
	return inOrder([&] { return cutFaces(arrangement, monitor, chunks); },
	               [&] { return concatenate(chunks, arrangement, monitor); });
}

}  // namespace index_boolean
