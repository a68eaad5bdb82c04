// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The entry: two closed surfaces are intersected once (an Arrangement), and every block is read
// from it. Source: Mei & Tipper, "Simple and Robust Boolean Operations for Triangulated Surfaces"
// (2013; Zhou, Qin, Mei, Tipper, Mathematics 2023, 11, 2713), on exact decisions.
// Guarantee: coordinates decide signs, signs make indices, after that only indices. No epsilon;
// the result is the same, byte for byte, for any number of threads.
#pragma once

#include "arrangement.h"
#include "blocks.h"
#include "measure.h"
#include "mesh_arrays.h"
#include "monitor.h"
#include "status.h"

namespace index_boolean {

// Intersects the two operands of `input`.
// \param input   both operands' arrays; moved in, the arrangement owns them from here on
// \param options octree limits, threads, output scalar
// \param monitor progress and cancel
// \param out     the arrangement; only meaningful if the status is Ok
// \return any StatusCode
// Complexity: O(n + k log k) for n faces and k points of the curve, beyond the octree's descent.
Status arrange(MeshArrays input, const Options& options, Monitor& monitor, Arrangement& out);

// Reads one block from the arrangement. Empty blocks are a valid result.
// \param operation which set the block bounds
// \param out       a closed, consistently oriented surface without zero-area faces
// \return Ok, Cancelled, OutOfMemory or InternalError
// Complexity: O(n).
Status extractBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out);

// Measures delivered blocks (volume, area, components, closedness) and the volume laws.
// \param blocks any of the arrangement's blocks
// \param out    one measure per block, in the same order, and the largest law residual
// \return Ok, Cancelled, OutOfMemory, or InternalError if a block is not closed
Status audit(const Arrangement& arrangement, const std::vector<Block>& blocks, Monitor& monitor,
             Audit& out);

}  // namespace index_boolean
