// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: which of them may become one.
// Guarantee: faces have one class only if the caller's classes of their sources are one
// (MeshArrays::faceClass), and neither, or both, are of one polygon of several faces.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

namespace index_boolean {

// What an input face must have in common with others to become one with them, as the caller says:
// whether there are classes, and which. Complexity: O(1).
std::array<std::uint32_t, 2> givenClassOf(const Arrangement& arrangement, FaceId face);

// Lists the class of each face of an output, by its source.
// \param classes replaced. Throws std::bad_alloc. Complexity: O(n), and O(n log n) with polygons.
void listFaceClasses(const Arrangement& arrangement, const HugeVector<FaceSource>& sources,
                     std::vector<std::uint32_t>& classes);

}  // namespace index_boolean
