// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a block, and marks on its faces or vertices; out: the block without the marked ones. What is
// left keeps its order.
#pragma once

#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// Takes faces out, and leaves their vertices. block.firstPiece follows.
// \param isGone per face, not 0: taken out. Complexity: O(n).
void removeFaces(const std::vector<std::uint8_t>& isGone, Block& block);

// Takes vertices out. \pre no face has one of them
// \param isGone per vertex, not 0: taken out. Throws std::bad_alloc. Complexity: O(n + v).
void removeVertices(const std::vector<std::uint8_t>& isGone, Block& block);

}  // namespace index_boolean
