// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: what a new layer is to hold; out: its elements, written in place, each vector from front to
// back in one go. Guarantee: what is written does not depend on the number of threads.
#pragma once

#include <vcg_ext/index_boolean.h>
#include <vcg_ext/mesh/mesh_arrays_vcg.h>

#include <host_document.h>

#include <functional>
#include <vector>

namespace index_boolean {

// Writes a value of each of the elements [begin, end), which have just been appended to a layer.
using RangeWriter = std::function<void(std::size_t begin, std::size_t end)>;

// What writes the values of a layer's vertices and of its faces, in this order. Those of vertices
// are called on another thread than those of faces.
struct ElementWriters {
	std::vector<RangeWriter> vertices, faces;
};

// A number for each vertex or each face: the host's scalar attribute of that name.
struct ScalarAttribute {
	const char* name;
	std::vector<std::int32_t> values;
};

// What a new layer holds: a surface, or polylines. What is pointed to is borrowed.
struct LayerContent {
	QString label;  // the host appends a number to a label that is taken
	const SourcedMesh* surface = nullptr;
	const CurveLines* curves = nullptr;
	std::vector<ScalarAttribute> vertexAttributes, faceAttributes;
	const std::vector<std::uint32_t>* selectedFaces = nullptr;  // if any, these alone are selected
	std::vector<vcg::Color4b> faceColours;                      // empty: the faces have none
	// Makes room in a layer that is still empty for whatever the operands carry, and adds what
	// writes it, the vertices' normals as well. Empty: normals are those of the faces.
	std::function<void(MeshModel&, ElementWriters&)> prepareAttributes;
};

// Writes one layer: first begin(), then vertices and faces, on two threads if there are.
class LayerWriter {
public:
	// \param content, layer borrowed; the layer is empty
	LayerWriter(const LayerContent& content, MeshModel& layer);

	// Makes room for all elements. \return Ok or Cancelled. Throws std::bad_alloc.
	Status begin(Monitor& monitor);

	// Stop early once the monitor is cancelled. Throw std::bad_alloc. O(n).
	Status writeVertices(Monitor& monitor);
	Status writeFaces(Monitor& monitor);

	// What is written, about.
	std::size_t vertexBytes() const;
	std::size_t faceBytes() const;

private:
	void prepareScalars();

	const LayerContent& content_;
	MeshModel& layer_;
	SurfaceWriter<CMeshO> surface_;
	ElementWriters writers_;
};

}  // namespace index_boolean
