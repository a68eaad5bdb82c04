// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells are sub-blocks, but that walls across which no winding number changes are none.
#include "vcg_ext/solids/cell_labels.h"

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
void listSides(const Arrangement& arrangement, const SubSurfaces& surfaces, const SubBlocks& blocks,
               CellLabels& out) {
	out.ofFace.assign(arrangement.mesh.triangles.size(), kNoWall);
	out.ofPiece.assign(arrangement.refinement.pieces.size(), kNoWall);
	for (std::size_t f = 0; f < surfaces.complex.faces.size(); ++f) {
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
	}
}

}  // namespace

Status labelCells(Arrangement& arrangement, Monitor& monitor) {
	static_assert(kNoBlock == -1, "the outside is cell 0");
	SubSurfaces surfaces;
	SubBlocks blocks;
	arrangement.cells = CellLabels{};
	const Status status = inOrder(
	    [&] { return findSubSurfaces(arrangement, monitor, surfaces); },
	    [&] { return findSubBlocks(arrangement, surfaces, Walls::Jumps, monitor, blocks); });
	if (status.ok()) {
		listSides(arrangement, surfaces, blocks, arrangement.cells);
		measureOperands(blocks, arrangement);
		listCells(arrangement, blocks, arrangement.cells);
	}
	return status;
}

}  // namespace index_boolean
