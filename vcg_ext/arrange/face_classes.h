// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces of an output, by their sources; out: which of them may become one.
// Guarantee: faces have one class only if the caller's classes of their sources are one
// (MeshArrays::faceClass), and neither, or both, are of one polygon of several faces.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

namespace index_boolean {

// Lists the class of each face.
// \param classes replaced. Throws std::bad_alloc. Complexity: O(n), and O(n log n) with polygons.
void listFaceClasses(const Arrangement& arrangement, const HugeVector<FaceSource>& sources,
                     std::vector<std::uint32_t>& classes);

}  // namespace index_boolean
