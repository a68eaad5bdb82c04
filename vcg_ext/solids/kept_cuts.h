// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a block that does not hold as it is stored; out: one that holds with more of its cuts, if
// there is one. The pieces of cut faces have been repaired together (repair_places.h), but not what
// a block makes of them where cuts that part nothing in it are merged: such a face may fold even
// though none of its pieces does.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/solids/blocks.h"

#include <functional>

namespace index_boolean {

// Makes a block again with its cuts kept in these input faces, ascending, and certifies it.
using RemakeBlock = std::function<Status(const std::vector<FaceId>& keptCuts, Block& out)>;

// Keeps the cuts in the input faces of which faces of the block meet others wrongly, as long as
// there are such faces, a few times; then all cuts. What holds best stays.
// \param block certified; replaced by a better one, if there is one, but for its stages' times
// \return Ok, or what `remake` returns. Throws std::bad_alloc.
// Complexity: O(1) if the block holds or merges nothing, or if not all pieces hold; else that of
// making it a few times.
Status keepCutsThatHold(const Arrangement& arrangement, const RemakeBlock& remake, Block& block);

}  // namespace index_boolean
