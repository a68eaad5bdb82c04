// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the textures of the operands' layers; out: one list without duplicates, and where each
// texture is in it.
#pragma once

#include <vcg_ext/index_boolean.h>

#include <host_document.h>

#include <vector>

namespace index_boolean {

class TextureList {
public:
	// Textures of one name but with other pictures get another name.
	explicit TextureList(const PerOperand<MeshModel*>& layers);

	// The number in this list of an operand's texture; -1, none, for what is none of its textures.
	// Where a layer with one texture names none anywhere, that one is meant: as MeshLab draws and
	// saves it.
	short number(OperandId operand, short texture) const;

	void addTo(MeshModel& layer) const;

private:
	static constexpr short kNoTexture = -1;

	std::vector<LayerTexture> all_;
	PerOperand<std::vector<short>> numbers_;  // per texture of the operand's layer
	PerOperand<short> unnamed_;               // what kNoTexture means
};

}  // namespace index_boolean
