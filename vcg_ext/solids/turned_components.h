// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a block with its places as stored, pulled apart where it touches itself; out: the same
// without components that rounding has turned inside out. A bubble of material, or a cavity, that
// is thinner than the scalar's steps may be stored with its sides exchanged: no two of its faces
// meet wrongly then, and yet there is no solid of which it is the boundary.
// Guarantee: exact. No component is dropped that lies where it may, or that is not that thin.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// Drops such components, and counts them as vanished. Does nothing unless options.certify is set
// and all pieces hold.
// \param firstRounded the faces before it have no rounded corner
// \param block        changed in place; its vertices are copied where it touches itself, or else
//                     such components may stay
// \return Ok, Cancelled, OutOfMemory, InternalError. Throws std::bad_alloc.
// Complexity: O(v + k) for v vertices and k faces from firstRounded on; where a component is thin,
// that of findWindings.
Status dropTurnedComponents(const Arrangement& arrangement, std::size_t firstRounded,
                            Monitor& monitor, Block& block);

}  // namespace index_boolean
