// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter of that name: the signed distance from a layer at the
// vertices of another one, written on that.
#pragma once

#include "filters/filter_output.h"
#include "runs/progress.h"
#include "texts/parameter_values.h"

#include <host_document.h>

namespace index_boolean {

// As runFilter.
FilterOutput computeIndexBooleanImplicit(const ParameterValues& values, MeshDocument& document,
                                         HostCallback* callback);

}  // namespace index_boolean
