// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The document of MeshLab and meshlabserver 2020.09, and what its versions do in different words.
#pragma once

#include <common/meshmodel.h>

#include <QVariant>

#include <vector>

namespace index_boolean {

// In the order of the document.
inline std::vector<int> layerIds(const MeshDocument& document) {
	std::vector<int> ids;
	for (const MeshModel* layer : document.meshList)
		ids.push_back(layer->id());
	return ids;
}

// nullptr if there is none of that id.
inline MeshModel* findLayer(MeshDocument& document, int id) { return document.getMesh(id); }

inline void deleteLayer(MeshDocument& document, const MeshModel& layer) {
	document.delMesh(document.getMesh(layer.id()));
}

// A list of numbers in a filter's result; this host shows no results.
inline QVariant listValue(const std::vector<double>&) { return {}; }

}  // namespace index_boolean
