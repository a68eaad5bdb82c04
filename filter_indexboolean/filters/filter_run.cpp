// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each filter is a file of its own; here is which one runs.
#include "filters/filter_run.h"

#include "filters/compute_index_boolean_distance.h"
#include "filters/compute_index_boolean_implicit.h"
#include "filters/generate_index_boolean.h"
#include "filters/generate_index_boolean_curves.h"
#include "filters/generate_index_boolean_expression.h"
#include "filters/generate_index_boolean_resolve.h"
#include "filters/generate_index_boolean_split.h"

#include <vcg_ext/index_boolean.h>

#include <stdexcept>

namespace index_boolean {

FilterOutput runFilter(FilterId filter, const ParameterValues& values, MeshDocument& document,
                       HostCallback* callback) {
	const PageReuse pages;
	switch (filter) {
	case FilterId::GenerateIndexBoolean:
		return generateIndexBoolean(values, document, callback);
	case FilterId::GenerateIndexBooleanSplit:
		return generateIndexBooleanSplit(values, document, callback);
	case FilterId::GenerateIndexBooleanCurves:
		return generateIndexBooleanCurves(values, document, callback);
	case FilterId::GenerateIndexBooleanExpression:
		return generateIndexBooleanExpression(values, document, callback);
	case FilterId::GenerateIndexBooleanResolve:
		return generateIndexBooleanResolve(values, document, callback);
	case FilterId::ComputeIndexBooleanDistance:
		return computeIndexBooleanDistance(values, document, callback);
	case FilterId::ComputeIndexBooleanImplicit:
		return computeIndexBooleanImplicit(values, document, callback);
	}
	throw std::logic_error("no such filter");
}

}  // namespace index_boolean
