// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a block that does not hold as it is stored; out: one that holds, made in another way, if
// there is one. The pieces of cut faces have been repaired together (repair_places.h), but not what
// a block makes of them: where cuts that part nothing in it are merged, a face may fold even though
// none of its pieces does; where it has been pulled apart, two faces that rounding puts on one
// triangle are not seen to cancel.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/solids/blocks.h"

#include <functional>

namespace index_boolean {

// How a block is made.
struct BlockVariant {
	std::vector<FaceId> keptCuts;    // input faces, ascending
	bool isPulledApartLast = false;  // after cleaning only, where it meets itself as stored
};

// Makes a block again so, and certifies it.
using RemakeBlock = std::function<Status(const BlockVariant& variant, Block& out)>;

// Keeps the cuts in the input faces of which faces of the block meet others wrongly, as long as
// there are such faces, a few times; then all cuts. What holds best stays.
// \param block certified; replaced by a better one, if there is one, but for its stages' times
// \return Ok, or what `remake` returns. Throws std::bad_alloc.
// Complexity: O(1) if the block holds or merges nothing, or if not all pieces hold; else that of
// making it a few times.
Status keepCutsThatHold(const Arrangement& arrangement, const RemakeBlock& remake, Block& block);

// Pulls the block apart last, with the cuts that it keeps, if it holds better then.
// \param block certified; replaced by a better one, if there is one, but for its stages' times
// \return Ok, or what `remake` returns. Throws std::bad_alloc.
// Complexity: O(1) if the block holds, or is not pulled apart at all; else that of making it.
Status pullApartLast(const Arrangement& arrangement, const RemakeBlock& remake, Block& block);

}  // namespace index_boolean
