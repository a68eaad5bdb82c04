// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the labelled arrangement and an operation; out: the block's boundary as arrays, each element
// with where it came from. Guarantee: a face is kept iff the operation's truth differs between its
// two sides, turned so that the solid lies behind it (the paper's step 6, by labels).
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/carry/surface_repair.h"
#include "vcg_ext/mesh/sourced_mesh.h"

#include <algorithm>

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
// Never null, never freed. Complexity: O(1).
const char* operationName(Operation operation);

// The boundary of a solid. A vertexSource is none() for the middle of an edge along which the block
// met itself.
struct Block : SourcedMesh {
	Operation operation = Operation::Union;
	SurfaceRepair repair;
	std::size_t verticesCopied = 0;     // to pull apart where the block meets itself
	std::vector<StageTime> stageTimes;  // of the stages that made this block

	// Input faces of which no cut is merged or flipped away (kept_cuts.h), ascending; nearly always
	// none.
	std::vector<FaceId> keptCuts;

	// For the stages that finish the block; none of it is kept up to date afterwards.
	std::size_t firstPiece = 0;         // faces from here on lie on touched faces
	bool anySuspectOffCurve = false;    // else faces before firstPiece have no suspect corner
	bool isApart = false;               // the block has been pulled apart at all suspect vertices
	std::vector<std::uint8_t> suspect;  // per point: the block may meet itself there, or a cut that
	                                    // parts nothing may end there

	// Whether all cuts of the input face of one of the faces are kept. O(log k).
	bool keepsCutsOf(std::size_t face) const {
		return !keptCuts.empty() &&
		       std::binary_search(keptCuts.begin(), keptCuts.end(), faceSource[face].face);
	}

	// Whether there is one. O(n).
	bool anySuspect() const {
		return std::find(suspect.begin(), suspect.end(), 1) != suspect.end();
	}
};

// Collects the faces and vertices of one block, before cleaning.
// Complexity: O(n), in parallel. \return Ok, Cancelled
Status collectBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out);

}  // namespace index_boolean
