// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All is merged at once, then the new faces are searched, and what has gone is measured. Where a
// face meets another wrongly, or something is too far, all is done once more from the beginning:
// with the vertices kept that went near these faces, or too far; at last with the regions of these
// faces left as they are. What is kept only grows; nearly always nothing is.
#include "vcg_ext/arrange/merge_near_coplanar.h"

#include "vcg_ext/arrange/wrong_pairs.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"
#include "vcg_ext/exact/box_tree.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/mesh/face_probe.h"
#include "vcg_ext/mesh/merge_regions.h"
#include "vcg_ext/mesh/vertex_table.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

constexpr double kReach = 0.4, kAside = 0.4;  // of the tolerance
constexpr double kMost = 0.9;                 // what a vertex may be away
constexpr double kSliver = 0.5;               // what the longest side of a sliver may be away
constexpr int kMostRounds = 16;

class NearCoplanarMerger {
public:
	NearCoplanarMerger(const NearCoplanarInput& input, Monitor& monitor, NearCoplanarMerge& out)
	    : input_(input), monitor_(monitor),
	      out_(out), surface_{input.points, input.triangles, input.faceClass, place_} {}

	Status run();

private:
	void findPlaces();
	void keepFace(std::uint32_t face);
	void keepWrongFaces();
	Status search(const MergedFaces& merged, std::vector<std::uint32_t>& wrong) const;
	bool keepNear(const MergedFaces& merged, const std::vector<std::uint32_t>& wrong);
	void keepRegions(const MergedFaces& merged, const std::vector<std::uint32_t>& wrong);
	FaceProbe probeOf(const MergedFaces& merged) const;
	bool isSliver(std::uint32_t face) const;
	bool keepFar(const MergedFaces& merged);
	BoundingBox boxOf(const IndexTriangle& t) const;

	const NearCoplanarInput& input_;
	Monitor& monitor_;
	NearCoplanarMerge& out_;
	std::vector<std::uint32_t> place_;
	ClassedSurface surface_;
	PlaneRegions regions_;
	KeptParts kept_;
};

// Of vertices that faces use.
void NearCoplanarMerger::findPlaces() {
	const std::size_t n = input_.points.size();
	std::vector<std::uint8_t> isUsed(n, 0);
	for (const IndexTriangle& t : input_.triangles) {
		isUsed[t[0]] = isUsed[t[1]] = isUsed[t[2]] = 1;
	}
	VertexTable table(input_.points, n);
	place_.reserve(n);
	for (std::uint32_t v = 0; v < n; ++v) {
		place_.push_back(isUsed[v] != 0 ? table.findOrAdd(v) : v);
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

// Leaves the regions of wrong faces as they are.
void NearCoplanarMerger::keepRegions(const MergedFaces& merged,
                                     const std::vector<std::uint32_t>& wrong) {
	std::vector<std::uint32_t> regions;
	for (const std::uint32_t face : wrong) {
		regions.push_back(merged.region[face]);
	}
	sortUnique(regions);
	for (std::uint32_t f = 0; f < input_.triangles.size(); ++f) {
		if (std::binary_search(regions.begin(), regions.end(), regions_.ofFace[f])) {
			keepFace(f);
		}
	}
}

// The faces that may be near what has gone: all with a corner of a face that has.
FaceProbe NearCoplanarMerger::probeOf(const MergedFaces& merged) const {
	std::vector<std::uint8_t> isNear(input_.points.size(), 0);
	std::vector<std::uint8_t> isGone(input_.triangles.size(), 1);
	for (std::size_t f = 0; f < merged.firstNew; ++f) {
		isGone[merged.origin[f]] = 0;
	}
	for (std::size_t f = 0; f < isGone.size(); ++f) {
		for (std::size_t i = 0; isGone[f] != 0 && i < 3; ++i) {
			isNear[place_[input_.triangles[f][i]]] = 1;
		}
	}
	std::vector<IndexTriangle> faces;
	for (const IndexTriangle& t : merged.triangles) {
		if (isNear[place_[t[0]]] != 0 || isNear[place_[t[1]]] != 0 || isNear[place_[t[2]]] != 0) {
			faces.push_back(t);
		}
	}
	return FaceProbe(input_.points, std::move(faces), input_.tolerance);
}

// Whether a face of a region may be turned anyhow as seen along its plane's axis.
bool NearCoplanarMerger::isSliver(std::uint32_t face) const {
	const std::uint32_t region = regions_.ofFace[face];
	return !regions_.isSingle(region) &&
	       sizeOfFace(input_.points, input_.triangles[face]).leastHeight <=
	           kReach * input_.tolerance;
}

// Keeps what has come to be too far from the surface that is left: vertices, and slivers, which may
// have stood out from their region. \return whether there is any such; else out_ says how far
bool NearCoplanarMerger::keepFar(const MergedFaces& merged) {
	const FaceProbe probe = probeOf(merged);
	bool isAny = false;
	double most = 0;
	std::vector<std::uint8_t> isGone(input_.points.size(), 0);
	for (const std::uint32_t v : merged.gone) {
		const double distance = probe.distanceTo(input_.points[v]);
		isGone[v] = 1;
		most = std::max(most, distance);
		if (!(distance <= kMost * input_.tolerance)) {
			kept_.vertices[v] = 1;
			isAny = true;
		}
	}
	for (std::uint32_t f = 0; f < input_.triangles.size(); ++f) {
		const IndexTriangle& t = input_.triangles[f];
		if ((isGone[t[0]] | isGone[t[1]] | isGone[t[2]]) == 0 || !isSliver(f)) {
			continue;
		}
		const auto lengthFrom = [&](std::size_t i) {
			const Point &a = input_.points[t[i]], &b = input_.points[t[(i + 1) % 3]];
			return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
		};
		const std::size_t i = lengthFrom(0) >= lengthFrom(1)
		                          ? (lengthFrom(0) >= lengthFrom(2) ? 0 : 2)
		                      : lengthFrom(1) >= lengthFrom(2) ? 1
		                                                       : 2;
		if (!probe.isSegmentWithin(input_.points[t[i]], input_.points[t[(i + 1) % 3]],
		                           kSliver * input_.tolerance)) {
			for (const std::uint32_t v : t) {
				isAny = isAny || kept_.vertices[v] == 0;
				kept_.vertices[v] = 1;
			}
		}
	}
	out_.largestMove = most;
	return isAny;
}

Status NearCoplanarMerger::run() {
	findPlaces();
	Status status =
	    findPlaneRegions(surface_, kReach * input_.tolerance, input_.threads, monitor_, regions_);
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
		if (!status.ok() || merged.gone.empty() || round == kMostRounds) {
			return status;
		}
		const bool isFar = keepFar(merged);
		if (wrong.empty() && !isFar) {
			break;
		}
		if (!wrong.empty() && (round >= kMostRounds / 4 || !keepNear(merged, wrong))) {
			keepRegions(merged, wrong);
		}
	}
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
