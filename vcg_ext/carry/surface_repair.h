// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a surface before and after it is cleaned; out: what the repair of places (repair_places.h)
// has done to it. Nearly always no place has been moved, and nothing is measured.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/mesh/measure.h"
#include "vcg_ext/mesh/sourced_mesh.h"

namespace index_boolean {

// What the repair of places has done to one surface.
struct SurfaceRepair {
	std::size_t movedVertices = 0;       // of the surface, not stored in their rounded places
	double volumeChange = 0;             // against the same with all places as rounded; 0 if open
	std::size_t vanishedComponents = 0;  // too thin for the scalar
};

// Counts the surface's moved vertices, and measures it as it would be with all places as rounded.
// \param mesh before it is cleaned \param repair gets movedVertices
// Throws std::bad_alloc. Complexity: O(1) if no place has been moved, else O(n log m).
BlockMeasure measureUnrepaired(const Arrangement& arrangement, const SourcedMesh& mesh,
                               SurfaceRepair& repair);

// Fills the rest of the repair. \param before as measured \param mesh after it is cleaned
// Throws std::bad_alloc. Complexity: O(1) if no place has been moved, else O(n).
void compareWithUnrepaired(const Arrangement& arrangement, const BlockMeasure& before,
                           const SourcedMesh& mesh, SurfaceRepair& repair);

// How many vertices of a mesh that is named as the arrangement are not stored in their rounded
// places. Complexity: O(n).
std::size_t countMoved(const Arrangement& arrangement, const SourcedMesh& mesh);

// Fills `repair` of a mesh that was read from operands arranged again (rounding_loop.h).
// \param exact the same surface as the exact arrangement has it, before it is cleaned
// \param mesh  named as the arrangement
// Throws std::bad_alloc. Complexity: O(n).
void compareWithExact(const Arrangement& arrangement, const SourcedMesh& exact,
                      const SourcedMesh& mesh, SurfaceRepair& repair);

}  // namespace index_boolean
