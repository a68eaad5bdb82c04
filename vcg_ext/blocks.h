// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the labelled arrangement and an operation; out: the block's boundary as arrays, each element
// with where it came from. Guarantee: a face is kept iff the operation's truth differs between its
// two sides, turned so that the solid lies behind it (the paper's step 6, by labels).
#pragma once

#include "arrangement.h"
#include "monitor.h"
#include "status.h"

namespace index_boolean {

enum class Operation : std::uint8_t {
	Union,
	Intersection,
	FirstMinusSecond,
	SecondMinusFirst,
	SymmetricDifference,
};
constexpr int kOperationCount = 5;

// "union", "intersection", "first_minus_second", "second_minus_first", "symmetric_difference".
const char* operationName(Operation operation);

// Where a face of a block came from: the input face it is or is a piece of, and whether the block
// turned it over.
struct FaceSource {
	FaceId face;
	bool turned;
};

// The boundary of a solid. Arrays are parallel: points with vertexSource, triangles with
// faceSource. Triangles index `points`. A vertexSource is an input vertex or a curve point, or
// none() for the middle of an edge along which the block met itself.
struct Block {
	Operation operation = Operation::Union;
	std::vector<Point> points;
	std::vector<VertexId> vertexSource;
	std::vector<std::array<std::uint32_t, 3>> triangles;
	std::vector<FaceSource> faceSource;
	std::vector<std::uint8_t> faux;  // as in MeshArrays; empty if no face has a faux edge
	std::size_t zeroAreaFacesRemoved = 0;
	std::size_t verticesCopied = 0;     // to pull apart where the block meets itself
	std::vector<StageTime> stageTimes;  // of the stages that made this block

	// For the stages that finish the block; none of it is kept up to date afterwards.
	std::size_t firstPiece = 0;         // faces from here on lie on touched faces
	bool anySuspectOffCurve = false;    // else faces before firstPiece have no suspect corner
	std::vector<std::uint8_t> suspect;  // per point: the block may meet itself there, or a cut that
	                                    // parts nothing may end there
};

// Collects the faces and vertices of one block, before cleaning.
// Complexity: O(n), in parallel. \return Ok, Cancelled
Status collectBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out);

}  // namespace index_boolean
