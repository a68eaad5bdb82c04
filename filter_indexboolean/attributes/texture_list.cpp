// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A texture is known by its name and, where the host keeps pictures, by its picture.
#include "attributes/texture_list.h"

#include <algorithm>

namespace index_boolean {

namespace {

bool hasName(const std::vector<LayerTexture>& all, const std::string& name) {
	return std::any_of(all.begin(), all.end(),
	                   [&](const LayerTexture& t) { return t.name == name; });
}

// "brick.png" gives "brick_2.png", or the next number that is free.
std::string freeName(const std::vector<LayerTexture>& all, const std::string& name) {
	const std::size_t dot = name.rfind('.');
	const std::size_t end = dot == std::string::npos ? name.size() : dot;
	for (int number = 2;; ++number) {
		std::string other = name.substr(0, end) + "_" + std::to_string(number) + name.substr(end);
		if (!hasName(all, other)) {
			return other;
		}
	}
}

// Whether a face names one of the layer's textures.
bool namesTextures(const MeshModel& layer) {
	return std::any_of(layer.cm.face.begin(), layer.cm.face.end(), [](const CFaceO& face) {
		return !face.IsD() &&
		       (face.cWT(0).N() >= 0 || face.cWT(1).N() >= 0 || face.cWT(2).N() >= 0);
	});
}

}  // namespace

TextureList::TextureList(const PerOperand<MeshModel*>& layers)
    : numbers_(layers.size()), unnamed_(layers.size()) {
	std::fill(unnamed_.begin(), unnamed_.end(), kNoTexture);
	for (const OperandId operand : layers.operands()) {
		for (LayerTexture& texture : texturesOf(*layers[operand])) {
			const auto same = std::find(all_.begin(), all_.end(), texture);
			numbers_[operand].push_back(static_cast<short>(same - all_.begin()));
			if (same != all_.end()) {
				continue;
			}
			if (hasName(all_, texture.name)) {
				texture.name = freeName(all_, texture.name);
			}
			all_.push_back(std::move(texture));
		}
		if (numbers_[operand].size() == 1 &&
		    layers[operand]->hasDataMask(MeshModel::MM_WEDGTEXCOORD) &&
		    !namesTextures(*layers[operand])) {
			unnamed_[operand] = numbers_[operand].front();
		}
	}
}

short TextureList::number(OperandId operand, short texture) const {
	const std::vector<short>& numbers = numbers_[operand];
	const bool isOne = texture >= 0 && static_cast<std::size_t>(texture) < numbers.size();
	return isOne ? numbers[static_cast<std::size_t>(texture)] : unnamed_[operand];
}

void TextureList::addTo(MeshModel& layer) const {
	for (const LayerTexture& texture : all_) {
		addTexture(texture, layer);
	}
}

}  // namespace index_boolean
