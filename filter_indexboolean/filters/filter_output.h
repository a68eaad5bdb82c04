// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every filter gives back beside its layers: the result map and the log's lines.
#pragma once

#include "filters/result_map.h"

#include <string>
#include <vector>

namespace index_boolean {

struct FilterOutput {
	ResultMap map;
	std::vector<std::string> messages;
};

}  // namespace index_boolean
