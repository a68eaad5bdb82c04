// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes are built in place inside their layers, since a copy costs more than the whole Boolean.
#include "layers/layer_writer.h"

#include <algorithm>

namespace index_boolean {

namespace {

// Elements that are appended and filled at a time: few enough to stay in a core's cache.
constexpr std::size_t kAppendGrain = 2048;

const IndexTriangles kNoTriangles;
const std::vector<std::uint8_t> kNoFaux;

const Points& pointsOf(const LayerContent& content) {
	return content.surface != nullptr ? content.surface->points : content.curves->points;
}

const IndexTriangles& trianglesOf(const LayerContent& content) {
	return content.surface != nullptr ? content.surface->triangles : kNoTriangles;
}

const std::vector<std::uint8_t>& fauxOf(const LayerContent& content) {
	return content.surface != nullptr ? content.surface->faux : kNoFaux;
}

template <class Attribute>
RangeWriter scalarWriter(const ScalarAttribute& scalar, Attribute out) {
	return [&scalar, out](std::size_t begin, std::size_t end) mutable {
		for (std::size_t i = begin; i < end; ++i) {
			out[i] = static_cast<Scalarm>(scalar.values[i]);
		}
	};
}

// Of the faces [begin, end), selects those listed, in ascending order, and no others.
void selectOnly(const std::vector<std::uint32_t>& faces, std::size_t begin, std::size_t end,
                CMeshO& mesh) {
	for (std::size_t f = begin; f < end; ++f) {
		mesh.face[f].ClearS();
	}
	for (auto face = std::lower_bound(faces.begin(), faces.end(), begin);
	     face != faces.end() && *face < end; ++face) {
		mesh.face[*face].SetS();
	}
}

template <class Elements>
int countSelected(const Elements& elements, std::size_t begin, std::size_t end) {
	int count = 0;
	for (std::size_t i = begin; i < end; ++i) {
		count += elements[i].IsS() ? 1 : 0;
	}
	return count;
}

}  // namespace

LayerWriter::LayerWriter(const LayerContent& content, MeshModel& layer)
    : content_(content), layer_(layer),
      surface_(pointsOf(content), trianglesOf(content), fauxOf(content), layer.cm) {}

void LayerWriter::prepareScalars() {
	for (const ScalarAttribute& scalar : content_.vertexAttributes) {
		writers_.vertices.push_back(scalarWriter(
		    scalar, addVertexAttribute<Scalarm>(scalar.name, scalar.values.size(), layer_.cm)));
	}
	for (const ScalarAttribute& scalar : content_.faceAttributes) {
		writers_.faces.push_back(scalarWriter(
		    scalar, addFaceAttribute<Scalarm>(scalar.name, scalar.values.size(), layer_.cm)));
	}
}

Status LayerWriter::begin(Monitor& monitor) {
	if (!fauxOf(content_).empty()) {
		layer_.updateDataMask(MeshModel::MM_POLYGONAL);
	}
	if (!content_.faceColours.empty()) {
		layer_.updateDataMask(MeshModel::MM_FACECOLOR);
		writers_.faces.push_back([this](std::size_t begin, std::size_t end) {
			for (std::size_t f = begin; f < end; ++f) {
				layer_.cm.face[f].C() = content_.faceColours[f];
			}
		});
	}
	if (content_.prepareAttributes) {
		content_.prepareAttributes(layer_, writers_);
	}
	prepareScalars();
	return surface_.begin(monitor);
}

Status LayerWriter::writeVertices(Monitor& monitor) {
	if (content_.surface != nullptr && !content_.prepareAttributes) {
		const Status normals = surface_.findVertexNormals(monitor);
		if (!normals.ok()) {
			return normals;
		}
	}
	CMeshO& mesh = layer_.cm;
	const auto append = [&](std::size_t begin, std::size_t end) {
		surface_.appendVertices(begin, end);
		for (const RangeWriter& write : writers_.vertices) {
			write(begin, end);
		}
		mesh.svn += countSelected(mesh.vert, begin, end);
	};
	const Status status = inOrderFor(pointsOf(content_).size(), kAppendGrain, monitor, append);
	if (status.ok() && content_.curves != nullptr) {
		addEdges(content_.curves->edges, mesh);
	}
	return status;
}

Status LayerWriter::writeFaces(Monitor& monitor) {
	CMeshO& mesh = layer_.cm;
	const bool selects = content_.selectedFaces != nullptr && !content_.selectedFaces->empty();
	return inOrderFor(trianglesOf(content_).size(), kAppendGrain, monitor,
	                  [&](std::size_t begin, std::size_t end) {
		                  surface_.appendFaces(begin, end);
		                  for (const RangeWriter& write : writers_.faces) {
			                  write(begin, end);
		                  }
		                  if (selects) {
			                  selectOnly(*content_.selectedFaces, begin, end, mesh);
		                  }
		                  mesh.sfn += countSelected(mesh.face, begin, end);
	                  });
}

std::size_t LayerWriter::vertexBytes() const {
	return pointsOf(content_).size() * (sizeof(CVertexO) + 2 * sizeof(Scalarm));
}

std::size_t LayerWriter::faceBytes() const {
	return trianglesOf(content_).size() * (sizeof(CFaceO) + 2 * sizeof(Scalarm));
}

}  // namespace index_boolean
