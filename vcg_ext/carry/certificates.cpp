// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only a face with a rounded corner can have come to meet another one wrongly, or one that has been
// given other corners since.
#include "vcg_ext/carry/certificates.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/wrong_pairs.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

// Whether a vertex may be stored elsewhere than where it exactly is.
bool isRounded(const Arrangement& arrangement, VertexId source) {
	return source == VertexId::none() || !isStoredExactly(arrangement, source);
}

// Per face: it has a rounded corner.
Status findSuspects(const Arrangement& arrangement, const SourcedMesh& mesh, Monitor& monitor,
                    std::vector<std::uint8_t>& isSuspect) {
	constexpr std::size_t kGrain = 1 << 14;
	// What was arranged again as stored, or merged, is looked at as a whole: parts of the first
	// arrangement may have come to lie on one another. So are faces from which others without area
	// were taken away: a corner may have gone to one that is not rounded.
	const bool areAll = arrangement.again != nullptr || mesh.wallMerge.vertices > 0 ||
	                    mesh.zeroAreaFacesRemoved > 0;
	isSuspect.assign(mesh.triangles.size(), areAll ? 1 : 0);
	if (areAll) {
		return {};
	}
	const auto isRoundedSource = [&arrangement](VertexId v) { return isRounded(arrangement, v); };
	const auto first = static_cast<std::uint32_t>(
	    std::find_if(mesh.vertexSource.begin(), mesh.vertexSource.end(), isRoundedSource) -
	    mesh.vertexSource.begin());  // in blocks, most vertices come before it
	return parallelFor(isSuspect.size(), kGrain, arrangement.options.threads, monitor,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t f = begin; f < end; ++f) {
			                   const IndexTriangle& t = mesh.triangles[f];
			                   isSuspect[f] = std::any_of(t.begin(), t.end(), [&](std::uint32_t v) {
				                   return v >= first && isRoundedSource(mesh.vertexSource[v]);
			                   });
		                   }
	                   });
}

// Takes away pairs of faces of different parts.
void leaveWithinParts(const std::vector<std::uint32_t>& part, std::vector<FacePair>& pairs) {
	const auto isAcross = [&part](const FacePair& pair) {
		return part[pair.a.value] != part[pair.b.value];
	};
	pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isAcross), pairs.end());
}

}  // namespace

Status certify(const Arrangement& arrangement, const SourcedMesh& mesh,
               const std::vector<std::uint32_t>& part, bool isAsCut, Monitor& monitor,
               Certificate& out) {
	out = {};
	out.isKnown = arrangement.options.certify && isAsCut && arrangement.placeRepair.areFacesFine;
	if (!arrangement.options.certify || out.isKnown) {
		return {};
	}
	WrongPairOptions options;
	options.threads = arrangement.options.threads;
	std::vector<std::uint8_t> isSuspect;
	options.isSuspect = &isSuspect;
	WrongPairs found;
	const FacesView faces(mesh.points, mesh.triangles.data(), mesh.triangles.size());
	const Status status =
	    inOrder([&] { return findSuspects(arrangement, mesh, monitor, isSuspect); },
	            [&] { return findWrongPairsNearSuspects(faces, options, monitor, found); });
	if (!part.empty()) {
		leaveWithinParts(part, found.pairs);
	}
	out.isKnown = status.ok();
	out.faces = facesConcerned(found);
	return status;
}

}  // namespace index_boolean
