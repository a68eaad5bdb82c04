// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces of a block; out: which of them count as one, so that edges between them part nothing.
// Guarantee: the faces of a group lie in one plane, decided exactly, with fronts to one side.
#pragma once

#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// The group of each face: a number below twice the arrangement's faces or the list's length.
// Faces of one input face are a group if they are turned alike; those input faces of a polygon that
// lie in one plane count as one. With options.mergeCoplanar: neighbours in one plane that may be
// one face, see MeshArrays::faceClass.
// \param faces of the block, each once
// Throws std::bad_alloc. Complexity: O(k) for k faces; with mergeCoplanar O(k log k).
std::vector<std::uint32_t> groupsOf(const Arrangement& arrangement, const Block& block,
                                    const std::vector<std::uint32_t>& faces);

}  // namespace index_boolean
