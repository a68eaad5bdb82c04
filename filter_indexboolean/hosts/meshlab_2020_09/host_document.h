// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document of MeshLab and meshlabserver 2020.09, and what its versions do in different words.
#pragma once

#include <common/meshmodel.h>

#include <QDir>
#include <QFileInfo>
#include <QVariant>

#include <string>
#include <vector>

namespace index_boolean {

// In the order of the document.
inline std::vector<int> layerIds(const MeshDocument& document) {
	std::vector<int> ids;
	for (const MeshModel* layer : document.meshList) {
		ids.push_back(layer->id());
	}
	return ids;
}

inline std::vector<const MeshModel*> layersOf(const MeshDocument& document) {
	return {document.meshList.begin(), document.meshList.end()};
}

// nullptr if there is none of that id.
inline MeshModel* findLayer(MeshDocument& document, int id) { return document.getMesh(id); }

inline void deleteLayer(MeshDocument& document, const MeshModel& layer) {
	document.delMesh(document.getMesh(layer.id()));
}

inline void hideLayer(MeshModel& layer) { layer.visible = false; }

// This host keeps no pictures: the name is that of the file.
struct LayerTexture {
	std::string name;

	friend bool operator==(const LayerTexture& a, const LayerTexture& b) {
		return a.name == b.name;
	}
};

// In the order of the layer's list. A name that is relative to the layer's file is made absolute,
// since a new layer has no file.
inline std::vector<LayerTexture> texturesOf(const MeshModel& layer) {
	std::vector<LayerTexture> textures;
	for (const std::string& name : layer.cm.textures) {
		const QFileInfo beside(QFileInfo(layer.fullName()).absoluteDir(),
		                       QString::fromStdString(name));
		textures.push_back({beside.exists() ? beside.absoluteFilePath().toStdString() : name});
	}
	return textures;
}

inline void addTexture(const LayerTexture& texture, MeshModel& layer) {
	layer.cm.textures.push_back(texture.name);
}

// A list of numbers in a filter's result; this host shows no results.
inline QVariant listValue(const std::vector<double>&) { return {}; }

}  // namespace index_boolean
