// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The set of faces only grows, and there are few rounds.
#include "vcg_ext/solids/kept_cuts.h"

#include "vcg_ext/base/sorted_list.h"

namespace index_boolean {

namespace {

constexpr int kMostRounds = 3;  // before all cuts are kept

// The input faces that have wrong faces of a block. \return whether any is new
bool addSources(const Block& block, std::vector<FaceId>& faces) {
	const std::size_t before = faces.size();
	for (const std::uint32_t wrong : block.certificate.faces) {
		faces.push_back(block.faceSource[wrong].face);
	}
	sortUnique(faces);
	return faces.size() > before;
}

std::vector<FaceId> allCutFaces(const Refinement& refinement) {
	std::vector<FaceId> faces;
	for (const CutFace& cut : refinement.cutFaces) {
		faces.push_back(cut.face);
	}
	sortUnique(faces);
	return faces;
}

void takeIfBetter(const Block& again, Block& block) {
	if (again.certificate.faces.size() < block.certificate.faces.size()) {
		std::vector<StageTime> times = std::move(block.stageTimes);
		block = again;
		block.stageTimes = std::move(times);
	}
}

}  // namespace

Status keepCutsThatHold(const Arrangement& arrangement, const RemakeBlock& remake, Block& block) {
	const Options& options = arrangement.options;
	const bool isMergingToBlame = (options.mergeFragments || options.mergeCoplanar) &&
	                              arrangement.placeRepair.faultsAfter == 0;
	if (block.certificate.faces.empty() || !isMergingToBlame) {
		return {};
	}
	std::vector<FaceId> kept;
	Block last = block;
	bool areAllKept = false;
	for (int round = 0; !areAllKept && !last.certificate.faces.empty(); ++round) {
		areAllKept = round == kMostRounds || !addSources(last, kept);
		if (areAllKept) {
			kept = allCutFaces(arrangement.refinement);
		}
		Block again;
		const Status status = remake({kept, false}, again);
		if (!status.ok()) {
			return status;
		}
		takeIfBetter(again, block);
		last = std::move(again);
	}
	return {};
}

Status pullApartLast(const Arrangement& arrangement, const RemakeBlock& remake, Block& block) {
	if (block.certificate.faces.empty() || arrangement.options.weldNonManifold) {
		return {};
	}
	Block again;
	const Status status = remake({block.keptCuts, true}, again);
	if (status.ok()) {
		takeIfBetter(again, block);
	}
	return status;
}

}  // namespace index_boolean
