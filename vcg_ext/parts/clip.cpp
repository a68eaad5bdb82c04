// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sub-surface has the same blocks along it, and so is inside a solid or not as a whole: it is if
// any of its two sides faces a block in the solid. Of one on the solid's boundary one side does.
#include "vcg_ext/parts/clip.h"

#include "vcg_ext/arrange/refined_closed.h"

#include <algorithm>

namespace index_boolean {

bool isInClip(const SubBlocks& blocks, WindingRule rule, const Clip& clip, SubSurfaceId surface) {
	const std::array<std::int32_t, 2>& beside = at(blocks.beside, surface);
	const bool isInSolid = std::any_of(beside.begin(), beside.end(), [&](std::int32_t block) {
		return block != kNoBlock &&
		       isInside(rule, blocks.all[static_cast<std::size_t>(block)].windings[clip.solid]);
	});
	return isInSolid == clip.isInside;
}

Status collectClip(const Arrangement& arrangement, const SubSurfaces& surfaces,
                   const SubBlocks& blocks, const Clip& clip, Monitor& monitor, SplitMesh& out) {
	SurfaceChoice choice{clip.surface, {}, true};
	for (std::uint32_t s = 0; s < surfaces.all.size(); ++s) {
		const bool isIn = isInClip(blocks, arrangement.options.windingRule, clip, {s});
		choice.isChosen.push_back(isIn ? 1 : 0);
	}
	return collectSubSurfaces(arrangement, surfaces, blocks, choice, monitor, out);
}

Status refuseSolid(const Arrangement& arrangement, const SubBlocks& blocks, OperandId operand) {
	if (!arrangement.closed[operand]) {
		return refuseOpen(arrangement, operand);
	}
	const bool isEmpty =
	    std::none_of(blocks.all.begin(), blocks.all.end(), [&](const SubBlock& block) {
		    return isInside(arrangement.options.windingRule, block.windings[operand]);
	    });
	return isEmpty ? refuseWithoutInside(arrangement, operand) : Status{};
}

}  // namespace index_boolean
