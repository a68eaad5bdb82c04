// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a filter and its parameters' values; out: new layers in the document, the result map and the
// log's lines. The same code in every host: it is compiled against the MeshLab of each.
// Guarantee: unless it returns, the document is as before, but for the selection that shows a
// defect.
#pragma once

#include "filters/filter_output.h"
#include "runs/progress.h"
#include "texts/filter_definitions.h"
#include "texts/parameter_values.h"
#include "texts/refusal.h"

#include <host_document.h>

namespace index_boolean {

// \param callback of the host; may be null
// Throws Refusal; and whatever the host or the standard library throws, for messageOfCaught.
FilterOutput runFilter(FilterId filter, const ParameterValues& values, MeshDocument& document,
                       HostCallback* callback);

}  // namespace index_boolean
