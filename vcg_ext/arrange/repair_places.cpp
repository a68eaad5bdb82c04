// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A look first. Only where it finds something is the surface collected once more, with all that
// moved vertices may come near, for a descent.
#include "vcg_ext/arrange/repair_places.h"

#include "vcg_ext/arrange/box_frame.h"
#include "vcg_ext/arrange/place_descent.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/sorted_list.h"
#include "vcg_ext/base/union_find.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

// The distance of the output scalar's values at the largest coordinate.
Status findUnit(const Arrangement& arrangement, Monitor& monitor, double& unit) {
	const MeshArrays& mesh = arrangement.mesh;
	BoundingBox box{};
	const Status status = findBoxOfFaces(
	    mesh, mesh.triangles.size(), [](std::size_t i) { return i; }, arrangement.options.threads,
	    monitor, box);
	double largest = 0;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		largest = std::max({largest, std::fabs(box.lo[axis]), std::fabs(box.hi[axis])});
	}
	unit = gapAt(largest, arrangement.options.outputScalar);
	return status;
}

// Per face of the surface: which of them lie in the same blocks, as far as that is known before
// they have labels: faces joined across edges that are no segments.
std::vector<std::uint32_t> findClasses(const Arrangement& arrangement,
                                       const StoredSurface& surface) {
	const MeshArrays& mesh = arrangement.mesh;
	const Refinement& refinement = arrangement.refinement;
	UnionFind classes(refinement.nodeCount);
	for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
		const Triangle& t = mesh.triangles[f];
		if (refinement.isCut[f] == 0 && mesh.quietTwin(makeId<FaceTag>(f)) == Twin::None) {
			classes.unite({t[0].value, t[1].value, t[2].value});
		}
	}
	for (const auto& [region, other] : refinement.links) {
		classes.unite(region.value, other.value);
	}
	std::vector<std::uint32_t> classOf;
	for (std::size_t f = 0; f < surface.corners.size(); ++f) {
		const std::uint32_t node = f < surface.firstPiece
		                               ? surface.vertices[surface.corners[f][0]].value
		                               : refinement.pieceRegion[f - surface.firstPiece].value;
		classOf.push_back(classes.find(node));
	}
	return classOf;
}

// The corners of faces.
std::vector<VertexId> cornersOf(const StoredSurface& surface,
                                const std::vector<std::uint32_t>& faces) {
	std::vector<VertexId> corners;
	for (const std::uint32_t face : faces) {
		for (const std::uint32_t v : surface.corners[face]) {
			corners.push_back(surface.vertices[v]);
		}
	}
	sortUnique(corners);
	return corners;
}

void takePieces(const StoredSurface& surface, Triangles& pieces) {
	for (std::size_t i = 0; i < pieces.size(); ++i) {
		for (std::size_t k = 0; k < 3; ++k) {
			pieces[i][k] = surface.vertices[surface.corners[surface.firstPiece + i][k]];
		}
	}
}

Status descend(Arrangement& arrangement, Monitor& monitor) {
	double unit = 0;
	StoredSurface surface;
	Status status =
	    inOrder([&] { return findUnit(arrangement, monitor, unit); },
	            [&] {
		            return collectStoredSurface(arrangement, 2 * PlaceDescent::kMostUnits * unit,
		                                        monitor, surface);
	            });
	if (!status.ok()) {
		return status;
	}
	arrangement.placeRepair.unit = unit;
	StoredFaults faults(arrangement, surface, findClasses(arrangement, surface), monitor);
	status = faults.find();
	if (status.ok()) {
		status = PlaceDescent(arrangement, faults, unit, monitor).run();
	}
	arrangement.placeRepair.concerned = cornersOf(surface, faults.facesConcerned());
	if (status.ok() && arrangement.placeRepair.faultsAfter < arrangement.placeRepair.faultsBefore) {
		takePieces(surface, arrangement.refinement.pieces);
	}
	return status;
}

// Whether anything is wrong. \param areAllDistinct no face is another one's twin, or collapsed
Status look(const Arrangement& arrangement, Monitor& monitor, WrongPairs& wrong,
            bool& areAllDistinct, std::vector<VertexId>& concerned) {
	StoredSurface surface;
	const Status status = collectStoredSurface(arrangement, 0, monitor, surface);
	areAllDistinct = true;
	if (!status.ok() || !surface.anySuspect) {
		return status;
	}
	std::vector<std::uint32_t> faces;
	return inOrder([&] { return findDistinctFaces(arrangement, surface, monitor, faces); },
	               [&] {
		               areAllDistinct = faces.size() == surface.corners.size();
		               return findFaults(surface, faces, arrangement.options.threads, monitor,
		                                 wrong);
	               },
	               [&] {
		               concerned = cornersOf(surface, facesConcerned(wrong));
		               return Status{};
	               });
}

}  // namespace

Status repairPlaces(Arrangement& arrangement, Monitor& monitor) {
	constexpr std::size_t kMostFaces = 5000;  // beyond which trials take longer than all else
	if (!arrangement.options.certify) {
		return {};
	}
	WrongPairs wrong;
	PlaceRepair& report = arrangement.placeRepair;
	bool areAllDistinct = false;
	const Status status = look(arrangement, monitor, wrong, areAllDistinct, report.concerned);
	if (!status.ok() || (wrong.pairs.empty() && wrong.zeroAreaFaces.empty())) {
		report.areFacesFine = status.ok() && areAllDistinct;
		return status;
	}
	report.concernedBefore = report.concernedAfter = facesConcerned(wrong).size();
	report.faultsBefore = report.faultsAfter = wrong.pairs.size() + wrong.zeroAreaFaces.size();
	if (report.concernedBefore > kMostFaces) {
		report.isGivenUp = true;
		return {};
	}
	return descend(arrangement, monitor);
}

}  // namespace index_boolean
