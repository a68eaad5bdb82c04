// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the operands of a split, and how the user has named them; out: what its pieces are called:
// the names of their parameters and result keys, and the labels of their layers.
#pragma once

#include "texts/layer_names.h"

#include <array>
#include <string>

namespace index_boolean {

// What a layer of a split holds, in the order of the new layers.
enum class PieceKind : std::uint8_t { SubSurfaces, SubBlocks, Clip };

struct Pieces {
	PieceKind kind;
	OperandId operand;  // SubSurfaces: of this one; Clip: it is clipped
	Clip clip;          // Clip

	static Pieces subSurfacesOf(OperandId operand) { return {PieceKind::SubSurfaces, operand, {}}; }
	static Pieces subBlocks() { return {PieceKind::SubBlocks, {}, {}}; }
	static Pieces of(const Clip& clip) { return {PieceKind::Clip, clip.surface, clip}; }
};

// A clip that a user can ask for, by the parameter of its name.
struct ClipDefinition {
	const char* name;
	bool isFirstClipped;
	bool isInside;
};

// In the order of the new layers.
constexpr std::array<ClipDefinition, 4> kClipDefinitions{{
    {"first_inside_second", true, true},
    {"first_outside_second", true, false},
    {"second_inside_first", false, true},
    {"second_outside_first", false, false},
}};

struct SplitNames {
	LayerNames layers;
	bool isList = false;  // the operands are those of a list of layers, by number
	// Which operands the parameters first_mesh and second_mesh name.
	OperandId first = kFirst, second = kSecond;

	// "first" or "second"; of a list the operand's number. O(1).
	std::string keyOf(OperandId operand) const;
	// "sub_surfaces_<operand>", "sub_blocks", "first_inside_second". O(1).
	std::string keyOf(const Pieces& pieces) const;
	// "A cut by B", "A blocks B", "A inside B"; of more than two layers "A cut by 3 others",
	// "blocks of A and 3 others". O(1).
	std::string labelOf(const Pieces& pieces) const;
};

}  // namespace index_boolean
