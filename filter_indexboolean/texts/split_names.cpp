// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "texts/split_names.h"

#include "texts/filter_definitions.h"

namespace index_boolean {

namespace {

std::string othersThan(const LayerName& layer, const LayerNames& layers) {
	switch (layers.size()) {
	case 1:
		return "itself";
	case 2:
		return nameInLabel(layers[layers[kFirst].id == layer.id ? kSecond : kFirst]);
	default:
		return std::to_string(layers.size() - 1) + " others";
	}
}

std::string blocksLabel(const LayerNames& layers) {
	const std::string first = nameInLabel(layers[kFirst]);
	switch (layers.size()) {
	case 1:
		return first + " blocks";
	case 2:
		return first + " blocks " + nameInLabel(layers[kSecond]);
	default:
		return "blocks of " + first + " and " + othersThan(layers[kFirst], layers);
	}
}

}  // namespace

std::string SplitNames::keyOf(OperandId operand) const {
	return isList ? std::to_string(operand.value) : operand == kFirst ? "first" : "second";
}

std::string SplitNames::keyOf(const Pieces& pieces) const {
	switch (pieces.kind) {
	case PieceKind::SubSurfaces:
		return "sub_surfaces_" + keyOf(pieces.operand);
	case PieceKind::SubBlocks:
		break;
	case PieceKind::Clip:
		for (const ClipDefinition& definition : kClipDefinitions) {
			if (definition.isFirstClipped == (pieces.operand == first) &&
			    definition.isInside == pieces.clip.isInside) {
				return definition.name;
			}
		}
	}
	return "sub_blocks";
}

std::string SplitNames::labelOf(const Pieces& pieces) const {
	switch (pieces.kind) {
	case PieceKind::SubSurfaces:
		return nameInLabel(layers[pieces.operand]) + " cut by " +
		       othersThan(layers[pieces.operand], layers);
	case PieceKind::SubBlocks:
		break;
	case PieceKind::Clip:
		return nameInLabel(layers[pieces.operand]) +
		       (pieces.clip.isInside ? " inside " : " outside ") +
		       nameInLabel(layers[pieces.clip.solid]);
	}
	return blocksLabel(layers);
}

}  // namespace index_boolean
