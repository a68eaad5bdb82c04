// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the operands' layers are called, in sentences and in new layers' labels.
#pragma once

#include <vcg_ext/index_boolean.h>

#include <string>

namespace index_boolean {

struct LayerName {
	std::string label;
	int id;
};
using LayerNames = PerOperand<LayerName>;

}  // namespace index_boolean
