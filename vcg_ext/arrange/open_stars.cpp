// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: open stars; out: closed ones. The proof of star_words.h holds along any direction d. Where d
// is no axis, the coordinate that tells below from not below is d_q x_p - d_p x_q, which is
// constant along d.
#include "vcg_ext/arrange/open_stars.h"

#include "vcg_ext/arrange/star_planes.h"
#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/groups.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/vectors.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;
constexpr std::size_t kStarsAtATime = 16;

struct StarFace {
	std::uint32_t vertex, face;

	friend bool operator<(const StarFace& a, const StarFace& b) {
		return a.vertex != b.vertex ? a.vertex < b.vertex : a.face < b.face;
	}
};

using StarFaces = std::vector<StarFace>;

// The faces at all open stars, in order.
Status collectStars(const SearchedSurface& surface, Monitor& monitor, StarFaces& out) {
	std::vector<StarFaces> parts(chunkCount(surface.faces.count(), kGrain));
	const Status status = parallelForChunks(
	    surface.faces.count(), kGrain, surface.threads, monitor,
	    [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    for (std::size_t face = begin; face < end; ++face) {
			    for (const std::uint32_t v : surface.faces[face]) {
				    if (surface.points[v].star == kNone) {
					    parts[chunk].push_back({v, static_cast<std::uint32_t>(face)});
				    }
			    }
		    }
	    });
	for (const StarFaces& part : parts) {
		out.insert(out.end(), part.begin(), part.end());
	}
	return status.ok() ? bucketSort(
	                         out, surface.points.first + surface.points.points.size(),
	                         [](const StarFace& item) { return item.vertex; },
	                         [](const StarFace& a, const StarFace& b) { return a < b; },
	                         surface.threads, monitor)
	                   : status;
}

// A face at a vertex: its other corners, in order, and its normal.
struct Wedge {
	const Point* next;
	const Point* before;
	RoundedNormal normal;
	double length;  // of the normal
};

// One open star. Reused, for its memory.
class Star {
public:
	// Takes the faces [first, last) of one vertex.
	void take(const FacesView& faces, const StarFace* first, const StarFace* last) {
		origin_ = &faces.point(first->vertex);
		wedges_.clear();
		for (const StarFace* item = first; item != last; ++item) {
			const IndexTriangle t = faces[item->face];
			const std::size_t i = t[0] == item->vertex ? 0 : t[1] == item->vertex ? 1 : 2;
			const Point &next = faces.point(t[(i + 1) % 3]), &before = faces.point(t[(i + 2) % 3]);
			const RoundedNormal normal(*origin_, next, before);
			wedges_.push_back({&next, &before, normal, std::sqrt(dot(normal.value, normal.value))});
		}
	}

	// Whether, along some direction, it certainly meets itself nowhere. \pre all edges at the
	// vertex are balanced
	bool isCertified() const {
		Point direction = guessDirection();
		constexpr std::array<Point, 3> kTurns{
		    {{0, 0, 0}, {0.037, 0.017, -0.026}, {-0.061, 0, 0.06}}};
		const double size =
		    std::max({std::fabs(direction[0]), std::fabs(direction[1]), std::fabs(direction[2])});
		for (const Point& turn : kTurns) {
			for (std::size_t k = 0; k < 3; ++k) {
				direction[k] += turn[k] * size;
			}
			if (isCertifiedAlong(direction)) {
				return true;
			}
		}
		return false;
	}

private:
	Point guessDirection() const;
	bool isCertifiedAlong(const Point& direction) const;
	bool windsOnce(const Point& direction, std::size_t p, std::size_t q) const;

	const Point* origin_ = nullptr;
	std::vector<Wedge> wedges_;
};

// A direction on the same side of all faces, if such a one is found soon: from the mean of the
// normals on, each face that is not turned towards it clearly pulls it to itself (the perceptron).
Point Star::guessDirection() const {
	constexpr int kMostRounds = 12;
	constexpr double kClearly = 0.05, kPull = 0.7;
	Point d{};
	for (const Wedge& w : wedges_) {
		for (std::size_t k = 0; k < 3 && w.length > 0; ++k) {
			d[k] += w.normal.value[k] / w.length;
		}
	}
	bool goOn = true;
	for (int round = 0; round < kMostRounds && goOn; ++round) {
		goOn = false;
		for (const Wedge& w : wedges_) {
			const double length = std::sqrt(dot(d, d));
			if (w.length > 0 && dot(w.normal.value, d) < kClearly * w.length * length) {
				goOn = true;
				for (std::size_t k = 0; k < 3; ++k) {
					d[k] = d[k] / length + kPull * w.normal.value[k] / w.length;
				}
			}
		}
	}
	return d;
}

// Each product of a normal's component with d errs by 4.2u of size |d_k| for the component, see
// RoundedNormal, and u for its own rounding, the two sums by u of their terms each: less than 8u in
// all. What underflows is less than kUnderflow times 1 + |d|_1.
bool Star::isCertifiedAlong(const Point& d) const {
	for (const Wedge& w : wedges_) {
		double size = 0, room = 1;
		for (std::size_t k = 0; k < 3; ++k) {
			size += w.normal.size[k] * std::fabs(d[k]);
			room += std::fabs(d[k]);
		}
		if (!(dot(w.normal.value, d) > 16 * kRoundoff * size + kUnderflow * room)) {
			return false;
		}
	}
	std::size_t p = 0;
	for (std::size_t k = 1; k < 3; ++k) {
		p = std::fabs(d[k]) > std::fabs(d[p]) ? k : p;
	}
	return windsOnce(d, p, (p + 1) % 3) || windsOnce(d, p, (p + 2) % 3);
}

int signOf(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Where a point lies, seen from the origin: -1 below, +1 not below, 0 in doubt. Where one of the
// two products is zero the sign is that of the factors of the other, exactly, so that what is level
// counts as not below: spokes along an axis are common.
int sideOf(const Point& point, const Point& origin, const Point& d, std::size_t p, std::size_t q) {
	const double x = point[p] - origin[p], y = point[q] - origin[q];
	if (x == 0 || y == 0 || d[q] == 0) {
		const int sign = y == 0 ? signOf(d[q]) * signOf(x) : -signOf(d[p]) * signOf(y);
		return sign < 0 ? -1 : 1;
	}
	const double left = d[q] * x, right = d[p] * y;
	const double value = left - right;
	const double bound = 8 * kRoundoff * (std::fabs(left) + std::fabs(right)) + kUnderflow;
	return value > bound ? 1 : value < -bound ? -1 : 0;
}

// Whether the links come up through the vertex once, without doubt. \param p along which d is
// largest
bool Star::windsOnce(const Point& d, std::size_t p, std::size_t q) const {
	int comeUp = 0;
	for (const Wedge& w : wedges_) {
		const int from = sideOf(*w.next, *origin_, d, p, q),
		          to = sideOf(*w.before, *origin_, d, p, q);
		if (from == 0 || to == 0) {
			return false;
		}
		comeUp += from < 0 && to > 0 ? 1 : 0;
	}
	return comeUp == 1;
}

// What one thread needs to close stars.
struct Closer {
	Star star;
	StarPlanes planes;
	std::vector<std::uint32_t> faces;
};

// Judges all pairs of a star that are of interest, but for those that are parted, or that a star
// certified before tells of.
void judgePairs(const SearchedSurface& surface, Closer& closer, bool havePlanes, PairJudge& judge) {
	const auto haveCertifiedCorner = [&](const IndexTriangle& s, const IndexTriangle& t) {
		return std::any_of(s.begin(), s.end(), [&](std::uint32_t v) {
			return surface.points[v].star != kNone && std::find(t.begin(), t.end(), v) != t.end();
		});
	};
	for (std::size_t i = 0; i < closer.faces.size(); ++i) {
		for (std::size_t j = i + 1; j < closer.faces.size(); ++j) {
			const std::uint32_t f = closer.faces[i], g = closer.faces[j];
			if ((surface.suspects(f) || surface.suspects(g)) &&
			    !(havePlanes && closer.planes.areParted(i, j)) &&
			    !haveCertifiedCorner(surface.faces[f], surface.faces[g])) {
				judge.judge(f, g);
			}
		}
	}
}

// Closes the star with the faces [first, last). \return false if it stays open
bool closeStar(const SearchedSurface& surface, const StarFace* first, const StarFace* last,
               Closer& closer, PairJudge& judge) {
	if (static_cast<std::size_t>(last - first) > StarPlanes::kMostFaces) {
		const bool isBalanced = surface.isUnbalanced.empty() ||
		                        surface.isUnbalanced[first->vertex - surface.points.first] == 0;
		closer.star.take(surface.faces, first, last);
		return isBalanced && closer.star.isCertified();
	}
	closer.faces.clear();
	for (const StarFace* item = first; item != last; ++item) {
		if (!surface.hasNoArea(item->face)) {
			closer.faces.push_back(item->face);
		}
	}
	const bool havePlanes = closer.planes.take(surface.faces, first->vertex, closer.faces);
	judgePairs(surface, closer, havePlanes, judge);
	return true;
}

}  // namespace

Status closeStars(const std::vector<std::uint32_t>& openStars, Monitor& monitor, PairJudge& judge,
                  SearchedSurface& surface) {
	if (openStars.empty()) {
		return {};
	}
	StarFaces faces;
	Status status = collectStars(surface, monitor, faces);
	if (!status.ok()) {
		return status;
	}
	std::vector<const StarFace*> begins;
	forEachGroup(
	    faces.begin(), faces.end(),
	    [](const StarFace& a, const StarFace& b) { return a.vertex == b.vertex; },
	    [&](auto first, auto) { begins.push_back(&*first); });
	begins.push_back(faces.data() + faces.size());
	// Stars are written at the end only: meanwhile all threads read them.
	std::vector<std::uint8_t> isClosed(openStars.size());
	status = parallelFor(openStars.size(), kStarsAtATime, surface.threads, monitor,
	                     [&](std::size_t begin, std::size_t end) {
		                     Closer closer;
		                     for (std::size_t i = begin; i < end && !pollCancelled(monitor); ++i) {
			                     isClosed[i] =
			                         closeStar(surface, begins[i], begins[i + 1], closer, judge);
		                     }
	                     });
	for (std::size_t i = 0; i < openStars.size(); ++i) {
		if (isClosed[i] != 0) {
			surface.points[openStars[i]].star = openStars[i];
		}
	}
	return status;
}

}  // namespace index_boolean
