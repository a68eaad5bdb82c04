// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the operands' layers; out: a column for each attribute that at least one of them carries.
#pragma once

#include "attributes/attribute_column.h"
#include "attributes/texture_list.h"

#include <vector>

namespace index_boolean {

// The layers' colours, qualities, radii, curvatures, texture coordinates and selection; and user's
// scalar and point attributes but those of the names in `reserved`. Not the normals, which every
// layer has.
std::vector<AttributeColumn> attributeColumns(const OperandElementsAccess& access,
                                              const TextureList& textures,
                                              const std::vector<const char*>& reserved);

// The vertices' normals, with the layers' matrices applied; turned with the faces that a vertex
// stands for.
// \param opposed per operand: the core has turned its faces
AttributeColumn normalColumn(const OperandElementsAccess& access, PerOperand<bool> opposed);

}  // namespace index_boolean
