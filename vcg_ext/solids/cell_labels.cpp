// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells are sub-blocks, but that walls across which no winding number changes are none.
#include "vcg_ext/solids/cell_labels.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/parts/sub_blocks.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr CellLabels::Sides kNoWall{0, 0};

// Takes the windings.
void listCells(const Arrangement& arrangement, SubBlocks& blocks, CellLabels& out) {
	out.windings.assign(1, PerOperand<std::int32_t>(arrangement.mesh.operands().count()));
	out.volume.assign(1, 0);
	for (SubBlock& block : blocks.all) {
		out.windings.push_back(std::move(block.windings));
		out.volume.push_back(block.volume);
	}
}

// Notes what has been turned, and sums up the volumes of what is inside.
void measureOperands(const SubBlocks& blocks, Arrangement& arrangement) {
	arrangement.insideOut = blocks.turned;
	std::fill(arrangement.volume.begin(), arrangement.volume.end(), 0);
	for (const SubBlock& block : blocks.all) {
		for (const OperandId operand : arrangement.mesh.operands()) {
			const bool isIn = isInside(arrangement.options.windingRule, block.windings[operand]);
			arrangement.volume[operand] += isIn ? block.volume : 0;
		}
	}
}

// The cells in front of each triangle and behind it.
Status listSides(const Arrangement& arrangement, const SubSurfaces& surfaces,
                 const SubBlocks& blocks, Monitor& monitor, CellLabels& out) {
	constexpr std::size_t kGrain = 1 << 15;
	out.ofFace.assign(arrangement.mesh.triangles.size(), kNoWall);
	out.ofPiece.assign(arrangement.refinement.pieces.size(), kNoWall);
	const auto list = [&](std::size_t f) {
		const RefinedFace& face = surfaces.complex.faces[f];
		const std::array<std::int32_t, 2>& beside = at(blocks.beside, surfaces.ofFace[f]);
		const std::size_t front = surfaces.turned[f] != 0 ? 1 : 0;
		CellLabels::Sides& sides =
		    face.piece == kNone ? at(out.ofFace, face.source) : out.ofPiece[face.piece];
		sides = {static_cast<std::uint32_t>(beside[front] + 1),
		         static_cast<std::uint32_t>(beside[1 - front] + 1)};
		surfaces.complex.visitSources(face, [&](FaceId source, bool opposed) {
			if (source != face.source) {
				out.otherSources.push_back({face.piece, source, opposed});
			}
		});
	};
	return inOrderFor(surfaces.complex.faces.size(), kGrain, monitor,
	                  [&](std::size_t begin, std::size_t end) {
		                  for (std::size_t f = begin; f < end; ++f) {
			                  list(f);
		                  }
	                  });
}

}  // namespace

Status labelCells(Arrangement& arrangement, Monitor& monitor) {
	static_assert(kNoBlock == -1, "the outside is cell 0");
	SubSurfaces surfaces;
	SubBlocks blocks;
	arrangement.cells = CellLabels{};
	return inOrder(
	    [&] { return findSubSurfaces(arrangement, monitor, surfaces); },
	    [&] { return findSubBlocks(arrangement, surfaces, Walls::Jumps, monitor, blocks); },
	    [&] { return listSides(arrangement, surfaces, blocks, monitor, arrangement.cells); },
	    [&] {
		    measureOperands(blocks, arrangement);
		    listCells(arrangement, blocks, arrangement.cells);
		    return Status{};
	    });
}

}  // namespace index_boolean
