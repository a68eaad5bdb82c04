// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the curve as polylines; out: the content of its layer, with the attributes loop, loop_kind,
// source_face_first and source_face_second of each vertex.
#pragma once

#include "layers/layers.h"
#include "texts/messages.h"

#include <vcg_ext/index_boolean.h>

namespace index_boolean {

// \param curves borrowed by the content
// \param read   which faces of the layers the core's faces are
LayerContent curveContent(const CurveLines& curves, const OperandArrays& read,
                          const LayerNames& names);

}  // namespace index_boolean
