// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All is merged at once, then the new faces are searched. Where one meets another wrongly, it is
// done once more from the beginning: with the vertices that went near these faces kept; then with
// their regions left as they are. What is kept only grows, so it ends; nearly always nothing is.
#include "vcg_ext/arrange/merge_near_coplanar.h"

#include "vcg_ext/arrange/wrong_pairs.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"
#include "vcg_ext/exact/box_tree.h"
#include "vcg_ext/mesh/merge_regions.h"
#include "vcg_ext/mesh/vertex_table.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

constexpr double kReach = 0.4, kAside = 0.4;  // of the tolerance
constexpr int kMostRounds = 16;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double distanceToSegment(const Point& p, const Point& a, const Point& b) {
	const Point along = minus(b, a), to = minus(p, a);
	const double length = dot(along, along);
	const double t = length > 0 ? std::clamp(dot(to, along) / length, 0.0, 1.0) : 0;
	const Point off{to[0] - t * along[0], to[1] - t * along[1], to[2] - t * along[2]};
	return std::sqrt(dot(off, off));
}

// How far a point is from a triangle.
double distanceToFace(const Point& p, const std::array<Point, 3>& t) {
	const Point u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(p, t[0]);
	const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
	const double size = uu * vv - uv * uv;
	const double s = uw * vv - vw * uv, r = vw * uu - uw * uv;
	double least = std::min({distanceToSegment(p, t[0], t[1]), distanceToSegment(p, t[1], t[2]),
	                         distanceToSegment(p, t[2], t[0])});
	if (size > 0 && s >= 0 && r >= 0 && s + r <= size) {
		const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
		              u[0] * v[1] - u[1] * v[0]};
		least = std::min(least, std::fabs(dot(n, w)) / std::sqrt(dot(n, n)));
	}
	return least;
}

class NearCoplanarMerger {
public:
	NearCoplanarMerger(const NearCoplanarInput& input, Monitor& monitor, NearCoplanarMerge& out)
	    : input_(input), monitor_(monitor), out_(out),
	      surface_{input.points, input.triangles, input.faceClass, place_} {}

	Status run();

private:
	void findPlaces();
	void keepFace(std::uint32_t face);
	void keepWrongFaces();
	Status search(const MergedFaces& merged, std::vector<std::uint32_t>& wrong) const;
	bool keepNear(const MergedFaces& merged, const std::vector<std::uint32_t>& wrong);
	bool keepRegions(const MergedFaces& merged, const std::vector<std::uint32_t>& wrong);
	double largestMove(const MergedFaces& merged) const;
	BoundingBox boxOf(const IndexTriangle& t) const;

	const NearCoplanarInput& input_;
	Monitor& monitor_;
	NearCoplanarMerge& out_;
	std::vector<std::uint32_t> place_;
	ClassedSurface surface_;
	PlaneRegions regions_;
	KeptParts kept_;
};

void NearCoplanarMerger::findPlaces() {
	const std::size_t n = input_.points.size();
	VertexTable table(input_.points, n);
	place_.reserve(n);
	for (std::uint32_t v = 0; v < n; ++v) {
		place_.push_back(table.findOrAdd(v));
	}
}

void NearCoplanarMerger::keepFace(std::uint32_t face) {
	kept_.faces[face] = 1;
	for (const std::uint32_t v : input_.triangles[face]) {
		kept_.vertices[v] = 1;
	}
}

// The whole regions of faces that meet others wrongly already.
void NearCoplanarMerger::keepWrongFaces() {
	kept_.vertices.assign(input_.points.size(), 0);
	kept_.faces.assign(input_.triangles.size(), 0);
	std::vector<std::uint32_t> regions;
	for (const std::uint32_t face : input_.wrongFaces) {
		regions.push_back(regions_.ofFace[face]);
	}
	sortUnique(regions);
	for (std::uint32_t f = 0; f < input_.triangles.size() && !regions.empty(); ++f) {
		if (std::binary_search(regions.begin(), regions.end(), regions_.ofFace[f])) {
			keepFace(f);
		}
	}
}

BoundingBox NearCoplanarMerger::boxOf(const IndexTriangle& t) const {
	BoundingBox box = emptyBox();
	for (const std::uint32_t v : t) {
		box.add(input_.points[v]);
	}
	for (std::size_t i = 0; i < 3; ++i) {
		box.lo[i] -= input_.tolerance;
		box.hi[i] += input_.tolerance;
	}
	return box;
}

// The new faces that meet others wrongly, and those others.
Status NearCoplanarMerger::search(const MergedFaces& merged,
                                  std::vector<std::uint32_t>& wrong) const {
	std::vector<std::uint8_t> isNew(merged.triangles.size(), 0);
	std::fill(isNew.begin() + static_cast<std::ptrdiff_t>(merged.firstNew), isNew.end(), 1);
	WrongPairOptions options;
	options.threads = input_.threads;
	options.isSuspect = &isNew;
	WrongPairs found;
	const FacesView faces(input_.points, merged.triangles.data(), merged.triangles.size());
	const Status status = findWrongPairsNearSuspects(faces, options, monitor_, found);
	wrong = facesConcerned(found);
	return status;
}

// Keeps the vertices that went near wrong faces. \return whether there is any
bool NearCoplanarMerger::keepNear(const MergedFaces& merged,
                                  const std::vector<std::uint32_t>& wrong) {
	std::vector<BoundingBox> boxes;
	for (const std::uint32_t v : merged.gone) {
		boxes.push_back({input_.points[v], input_.points[v]});
	}
	const BoxTree tree(boxes);
	bool isAny = false;
	for (const std::uint32_t face : wrong) {
		const BoundingBox box = boxOf(merged.triangles[face]);
		tree.visit(
		    0, [&](const BoundingBox& other) { return !commonBox(box, other).empty(); },
		    [&](std::uint32_t i) {
			    kept_.vertices[merged.gone[i]] = 1;
			    isAny = true;
		    });
	}
	return isAny;
}

// Leaves the regions of wrong faces as they are. \return whether that is new for any
bool NearCoplanarMerger::keepRegions(const MergedFaces& merged,
                                     const std::vector<std::uint32_t>& wrong) {
	std::vector<std::uint32_t> regions;
	for (const std::uint32_t face : wrong) {
		regions.push_back(merged.region[face]);
	}
	sortUnique(regions);
	bool isAny = false;
	for (std::uint32_t f = 0; f < input_.triangles.size(); ++f) {
		if (std::binary_search(regions.begin(), regions.end(), regions_.ofFace[f])) {
			isAny = isAny || kept_.faces[f] == 0;
			keepFace(f);
		}
	}
	return isAny;
}

double NearCoplanarMerger::largestMove(const MergedFaces& merged) const {
	std::vector<BoundingBox> boxes;
	for (std::size_t f = merged.firstNew; f < merged.triangles.size(); ++f) {
		boxes.push_back(boxOf(merged.triangles[f]));
	}
	const BoxTree tree(boxes);
	double most = 0;
	for (const std::uint32_t v : merged.gone) {
		const Point& p = input_.points[v];
		double least = input_.tolerance;
		tree.visit(
		    0,
		    [&](const BoundingBox& box) {
			    return !commonBox(box, BoundingBox{p, p}).empty() && least > most;
		    },
		    [&](std::uint32_t i) {
			    const IndexTriangle& t = merged.triangles[merged.firstNew + i];
			    least = std::min(least, distanceToFace(p, {input_.points[t[0]], input_.points[t[1]],
			                                               input_.points[t[2]]}));
		    });
		most = std::max(most, least);
	}
	return most;
}

Status NearCoplanarMerger::run() {
	findPlaces();
	Status status = findPlaneRegions(surface_, kReach * input_.tolerance, input_.threads, monitor_,
	                                 regions_);
	if (!status.ok()) {
		return status;
	}
	keepWrongFaces();
	const MergeLimits limits{kReach * input_.tolerance, kAside * input_.tolerance};
	MergedFaces merged;
	std::vector<std::uint32_t> wrong;
	for (int round = 0;; ++round) {
		status = inOrder(
		    [&] { return mergeRegions(surface_, regions_, limits, kept_, monitor_, merged); },
		    [&] { return merged.gone.empty() ? Status{} : search(merged, wrong); });
		const bool isDone = !status.ok() || merged.gone.empty() || wrong.empty();
		const bool goesOn = !isDone && round < kMostRounds &&
		                    ((round < kMostRounds / 4 && keepNear(merged, wrong)) ||
		                     keepRegions(merged, wrong));
		if (!goesOn) {
			break;
		}
	}
	if (!status.ok() || merged.gone.empty() || !wrong.empty()) {
		return status;
	}
	out_.largestMove = largestMove(merged);
	out_.firstNew = merged.firstNew;
	out_.triangles = std::move(merged.triangles);
	out_.origin = std::move(merged.origin);
	out_.gone = std::move(merged.gone);
	std::sort(out_.gone.begin(), out_.gone.end());
	return status;
}

}  // namespace

Status mergeNearCoplanar(const NearCoplanarInput& input, Monitor& monitor, NearCoplanarMerge& out) {
	out = {};
	return NearCoplanarMerger(input, monitor, out).run();
}

}  // namespace index_boolean
