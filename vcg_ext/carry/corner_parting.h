// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a finished mesh and the seams of its operands; out: the same surface, with a vertex for each
// thing that corners in one place stand for: the sides of a seam or, if wanted, both operands.
// Guarantee: no triangle changes its place; what stands apart is told by operands and seams alone.
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/carry/face_locator.h"
#include "vcg_ext/carry/seams.h"

namespace index_boolean {

// Gives corners at one vertex that stand for different ones a vertex each.
// \param locator   of the same mesh
// \param partCurve whether corners of different operands stand apart; else a vertex of both is the
//                  first's
// \param mesh      gets copies of vertices at its end
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(n) for n faces, O(k log k) for k corners that get another vertex; O(1) if there are
// no seams and partCurve is false.
Status partCorners(const Arrangement& arrangement, const FaceLocator& locator, const Seams& seams,
                   bool partCurve, Monitor& monitor, SourcedMesh& mesh);

}  // namespace index_boolean
