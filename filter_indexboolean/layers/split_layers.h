// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a split; out: what its layers hold: vertices, faces, and for each face its numbers and the
// colour of the piece that it belongs to. By index alone; free of MeshLab.
#pragma once

#include "runs/split_run.h"
#include "texts/split_names.h"

#include <string>
#include <vector>

namespace index_boolean {

using Colour = std::array<std::uint8_t, 3>;

// The numbers of a face, which users see as scalar attributes of these names; -1: outside, or none.
enum class FaceNumber : std::uint8_t {
	SubSurface,
	BlockFront,
	BlockBack,
	SubBlock,
};
constexpr int kFaceNumberCount = 4;
constexpr std::array<const char*, kFaceNumberCount> kFaceNumberNames{
    {"sub_surface", "block_front", "block_back", "sub_block"}};

struct SplitLayer : SourcedMesh {
	Pieces pieces;
	std::string label;
	// Per FaceNumber and face; SubBlock is empty but for layers of sub-blocks.
	std::array<std::vector<std::int32_t>, kFaceNumberCount> numbers;
	std::vector<Colour> colours;  // per face
};

// How many pieces have been asked for, without clips.
std::size_t pieceCount(const SplitResult& result, const SplitRequest& request);

// Whether the pieces asked for get a layer each.
bool hasLayerForEachPiece(const SplitResult& result, const SplitRequest& request);

// The layers, in the order of PieceKind, then of the operands, clips, and the pieces' ids; at least
// one of each that is asked for, if an empty one. A clip has one in any case.
// Complexity: O(n) for all faces. Throws std::bad_alloc.
std::vector<SplitLayer> splitLayers(const SplitResult& result, const SplitRequest& request,
                                    const SplitNames& names);

// A colour for each id; colours of neighbouring ids are far from each other.
Colour colourOf(std::size_t id);

}  // namespace index_boolean
