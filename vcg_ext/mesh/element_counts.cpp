// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: counts; out: the larger one against the limit.
#include "vcg_ext/mesh/element_counts.h"

#include <algorithm>

namespace index_boolean {

namespace {

Status tooLargeIf(bool isTooLarge, std::size_t count) {
	Status status;
	if (isTooLarge) {
		status.code = StatusCode::TooLarge;
		status.count = count;
	}
	return status;
}

}  // namespace

Status checkCounts(std::size_t points, std::size_t faces, std::size_t most) {
	const std::size_t count = std::max(points, faces);
	return tooLargeIf(count > std::min(most, kMostElements), count);
}

Status checkNumbering(std::size_t count, std::size_t most) {
	return tooLargeIf(count > 2 * std::min(most, kMostElements), count);
}

}  // namespace index_boolean
