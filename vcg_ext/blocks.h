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
// faceSource. Triangles index `points`. A vertexSource is an input vertex or a curve point.
struct Block {
	Operation operation = Operation::Union;
	std::vector<Point> points;
	std::vector<VertexId> vertexSource;
	std::vector<std::array<std::uint32_t, 3>> triangles;
	std::vector<FaceSource> faceSource;
	std::size_t firstPiece = 0;  // before cleaning: faces from here on are pieces of cut faces
	std::size_t zeroAreaFacesRemoved = 0;
	std::vector<StageTime> stageTimes;  // of the stages that made this block
};

// Collects the faces and vertices of one block, before cleaning.
// Complexity: O(n), in parallel. \return Ok, Cancelled
Status collectBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out);

}  // namespace index_boolean
