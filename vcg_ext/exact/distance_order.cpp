// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Squares are compared, so that no root is taken.
#include "vcg_ext/exact/distance_order.h"

#include "vcg_ext/exact/exact_number.h"

namespace index_boolean {

int compareDistance(const Point& a, const Point& b, double distance, double times) {
	return decideSign(Predicate::Distance, [&](auto tag) {
		using Number = typename decltype(tag)::Type;
		const auto square = [](const Number& x) { return x * x; };
		const auto along = [&](std::size_t k) { return square(Number(a[k]) - Number(b[k])); };
		const Number limit = Number(distance) * Number(times);
		return (along(0) + along(1) + along(2) - square(limit)).sign();
	});
}

}  // namespace index_boolean
