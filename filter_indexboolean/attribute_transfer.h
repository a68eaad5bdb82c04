// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' layers, and the sources of a new layer's elements; out: the layer's
// attributes.
// Guarantee: the operands' layers are not changed. What they do not carry costs nothing.
#pragma once

#include "layer_attributes.h"
#include "messages.h"

namespace index_boolean {

struct AttributeOptions {
	bool partCurve = false;             // a vertex that both operands have becomes two
	bool selectCurve = false;           // new layers have their new vertices selected, no others
	std::vector<const char*> reserved;  // names of attributes that the filter itself writes
};

class AttributeTransfer {
public:
	// Borrows the layers.
	AttributeTransfer(const std::array<MeshModel*, 2>& layers, const OperandArrays& read,
	                  const AttributeOptions& options);
	AttributeTransfer(const AttributeTransfer&) = delete;
	AttributeTransfer& operator=(const AttributeTransfer&) = delete;

	// What the core is to be asked for.
	GivenTriangles givenTriangles() const {
		return [this](GivenFace face) { return access_.givenTriangle(face); };
	}
	SameAttributes sameAttributes() const {
		return [this](VertexId a, VertexId b, bool alsoNormals) {
			return areSame(access_.vertex(a.value), access_.vertex(b.value), alsoNormals);
		};
	}
	AttributeNeeds needs() const;

	// Numbers for the faces of each operand: two have the same if each attribute has one value on
	// both of them. Empty if there are no attributes.
	std::array<std::vector<std::uint32_t>, 2> faceClasses() const;

	// Writes the normals, all attributes and where each element comes from into a layer.
	// \param turned which operands' faces the core has turned
	// \return Ok or Cancelled. Throws std::bad_alloc.
	Status write(const SourcedMesh& mesh, const AttributeSources& sources,
	             const std::array<bool, 2>& turned, Monitor& monitor, MeshModel& layer) const;

	// A sentence for each operand that lacks what the other carries.
	std::vector<std::string> messages(const LayerNames& names) const;

private:
	bool areSame(const OperandElementsAccess::Spot& a, const OperandElementsAccess::Spot& b,
	             bool alsoNormals) const;
	Status writeProvenance(const SourcedMesh& mesh, const AttributeSources& sources,
	                       Monitor& monitor, MeshModel& layer) const;
	void selectCurve(const SourcedMesh& mesh, const AttributeSources& sources,
	                 MeshModel& layer) const;

	void countSelected(MeshModel& layer) const;

	AttributeOptions options_;
	OperandElementsAccess access_;
	TextureList textures_;
	std::vector<AttributeColumn> columns_;
};

}  // namespace index_boolean
