// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sorting by rounded coordinates brings together what may be equal.
#include "vcg_ext/arrange/equal_points.h"

#include "vcg_ext/arrange/numbered_sort.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/groups.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

struct PlacedPoint {
	Point place;
	VertexId point;
};

// All points that may have another in their place, in no order.
std::vector<PlacedPoint> placedPoints(const Arrangement& arrangement) {
	const Curve& curve = arrangement.curve;
	std::vector<PlacedPoint> all;
	for (std::uint32_t v = 0; v < curve.onOther.size(); ++v) {
		if (curve.onOther[v] != 0) {
			all.push_back({arrangement.mesh.points[v], {v}});
		}
	}
	for (std::uint32_t p = 0; p < curve.pointCount(); ++p) {
		all.push_back({curve.rounded[p], arrangement.vertexOf({p})});
	}
	return all;
}

// Sorts by rounded coordinates; points with equal ones by their numbers: input vertices first, then
// smaller names.
Status sortByPlace(std::vector<PlacedPoint>& all, const Options& options, Monitor& monitor) {
	double low = HUGE_VAL, high = -HUGE_VAL;
	for (const PlacedPoint& p : all) {
		low = std::min(low, p.place[0]);
		high = std::max(high, p.place[0]);
	}
	// Rounding is monotone, and so this is; halves, since a difference of numbers may be none.
	const double span = high / 2 - low / 2, count = static_cast<double>(all.size());
	const auto keyOf = [=](const PlacedPoint& p) {
		const double along = span > 0 ? (p.place[0] / 2 - low / 2) / span * count : 0;
		return static_cast<std::size_t>(std::min(along, count - 1));
	};
	const auto before = [](const PlacedPoint& a, const PlacedPoint& b) {
		return a.place != b.place ? a.place < b.place : a.point < b.point;
	};
	return sortNumbered(all, all.size(), keyOf, before, options, monitor);
}

// Enters for each of some points with equal rounded coordinates the first one in its place.
void findFirsts(const Arrangement& arrangement, const PlacedPoint* begin, const PlacedPoint* end,
                std::vector<VertexId>& firstOf) {
	std::vector<VertexId> firsts;
	for (const PlacedPoint* p = begin; p != end; ++p) {
		const auto same = std::find_if(firsts.begin(), firsts.end(), [&](VertexId first) {
			return comparePlaces(arrangement, first, p->point) == 0;
		});
		if (same == firsts.end()) {
			firsts.push_back(p->point);
		} else {
			firstOf[arrangement.pointOf(p->point).value] = *same;
		}
	}
}

// Keeps the points that stand for themselves. \return per old point, its new number
std::vector<VertexId> renumber(Arrangement& arrangement, const std::vector<VertexId>& firstOf) {
	Curve& curve = arrangement.curve;
	std::vector<VertexId> newNumber(firstOf.size());
	std::uint32_t kept = 0;
	for (std::uint32_t p = 0; p < firstOf.size(); ++p) {
		if (firstOf[p] == arrangement.vertexOf({p})) {
			curve.names[kept] = curve.names[p];
			curve.rounded[kept] = curve.rounded[p];
			newNumber[p] = arrangement.vertexOf({kept++});
		} else {  // of a smaller point, which has its number
			const VertexId first = firstOf[p];
			newNumber[p] = arrangement.isCurvePoint(first)
			                   ? newNumber[arrangement.pointOf(first).value]
			                   : first;
		}
	}
	curve.names.resize(kept);
	curve.rounded.resize(kept);
	return newNumber;
}

}  // namespace

Status mergeEqualPoints(Arrangement& arrangement, Monitor& monitor, Contacts& contacts,
                        std::vector<VertexId>& vertexOfName) {
	std::vector<PlacedPoint> all = placedPoints(arrangement);
	Status status = sortByPlace(all, arrangement.options, monitor);
	if (!status.ok()) {
		return status;
	}
	std::vector<VertexId> firstOf;
	for (std::uint32_t p = 0; p < arrangement.curve.pointCount(); ++p) {
		firstOf.push_back(arrangement.vertexOf({p}));
	}
	bool isCancelled = false;
	const auto areAlike = [](const PlacedPoint& a, const PlacedPoint& b) {
		return a.place == b.place;
	};
	forEachGroup(all.data(), all.data() + all.size(), areAlike,
	             [&](const PlacedPoint* begin, const PlacedPoint* end) {
		             if (end - begin > 1 && !isCancelled) {
			             findFirsts(arrangement, begin, end, firstOf);
			             isCancelled = pollCancelled(monitor);
		             }
	             });
	const std::vector<VertexId> newNumber = renumber(arrangement, firstOf);
	const auto update = [&](VertexId& v) {
		if (arrangement.isCurvePoint(v)) {
			v = newNumber[arrangement.pointOf(v).value];
		}
	};
	std::for_each(vertexOfName.begin(), vertexOfName.end(), update);
	for (InnerPoint& inner : contacts.inner) {
		update(inner.point);
	}
	const auto before = [](const InnerPoint& a, const InnerPoint& b) {
		return a.contact != b.contact ? a.contact < b.contact : a.point < b.point;
	};
	const auto contactOf = [](const InnerPoint& p) { return p.contact; };
	status = sortNumbered(contacts.inner, contacts.pairs.size(), contactOf, before,
	                      arrangement.options, monitor);
	const auto isSame = [](const InnerPoint& a, const InnerPoint& b) {
		return a.contact == b.contact && a.point == b.point;
	};
	contacts.inner.erase(std::unique(contacts.inner.begin(), contacts.inner.end(), isSame),
	                     contacts.inner.end());
	return isCancelled ? statusOf(StatusCode::Cancelled) : status;
}

}  // namespace index_boolean
