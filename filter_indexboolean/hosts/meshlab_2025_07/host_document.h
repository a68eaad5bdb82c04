// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document of MeshLab and pymeshlab 2025.07, and what its versions do in different words.
#pragma once

#include <common/ml_document/mesh_document.h>
#include <common/plugins/interfaces/filter_plugin.h>

#include <QImage>
#include <QVariant>

#include <string>
#include <vector>

namespace index_boolean {

// In the order of the document.
inline std::vector<int> layerIds(const MeshDocument& document) {
	std::vector<int> ids;
	for (const MeshModel& layer : document.meshIterator()) {
		ids.push_back(layer.id());
	}
	return ids;
}

inline std::vector<const MeshModel*> layersOf(const MeshDocument& document) {
	std::vector<const MeshModel*> layers;
	for (const MeshModel& layer : document.meshIterator()) {
		layers.push_back(&layer);
	}
	return layers;
}

// nullptr if there is none of that id.
inline MeshModel* findLayer(MeshDocument& document, int id) {
	return document.getMesh(static_cast<unsigned int>(id));
}

inline void deleteLayer(MeshDocument& document, const MeshModel& layer) {
	document.delMesh(static_cast<unsigned int>(layer.id()));
}

inline void hideLayer(MeshModel& layer) { layer.setVisible(false); }

struct LayerTexture {
	std::string name;
	QImage picture;

	friend bool operator==(const LayerTexture& a, const LayerTexture& b) {
		return a.name == b.name && a.picture == b.picture;
	}
};

// In the order of the layer's list.
inline std::vector<LayerTexture> texturesOf(const MeshModel& layer) {
	std::vector<LayerTexture> textures;
	for (const std::string& name : layer.cm.textures) {
		textures.push_back({name, layer.getTexture(name)});
	}
	return textures;
}

inline void addTexture(const LayerTexture& texture, MeshModel& layer) {
	layer.addTexture(texture.name, texture.picture);
}

// A list of numbers in a filter's result: a numpy array in Python.
inline QVariant listValue(const std::vector<double>& numbers) {
	const auto size = static_cast<Eigen::Index>(numbers.size());
	return QVariant::fromValue(
	    Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(numbers.data(), size)));
}

}  // namespace index_boolean
