// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the operands' layers, and the sources of a new layer's elements; out: the layer's
// attributes.
// Guarantee: the operands' layers are not changed. What they do not carry costs nothing.
#pragma once

#include "attributes/layer_attributes.h"
#include "runs/attribute_request.h"
#include "texts/messages.h"

namespace index_boolean {

struct AttributeOptions {
	bool partCurve = false;             // a vertex that two operands have becomes two
	bool selectCurve = false;           // new layers have their new vertices selected, no others
	std::vector<const char*> reserved;  // names of attributes that the filter itself writes
};

class AttributeTransfer {
public:
	// Borrows the layers.
	AttributeTransfer(const PerOperand<MeshModel*>& layers, const OperandArrays& read,
	                  const AttributeOptions& options);
	AttributeTransfer(const AttributeTransfer&) = delete;
	AttributeTransfer& operator=(const AttributeTransfer&) = delete;

	// What the core is to be asked for. Borrows this.
	AttributeRequest request() const;

	// Numbers for the faces of each operand: two have the same if each attribute has one value on
	// both of them. Empty if there are no attributes.
	PerOperand<std::vector<std::uint32_t>> faceClasses() const;

	// Makes room for all attributes in an empty layer, and adds what writes them, the normals, and
	// where each element comes from. Throws std::bad_alloc.
	// \param mesh    what the layer will hold, with its sources; both borrowed
	// \param turned  which operands' faces the core has turned
	void prepare(const SourcedMesh& mesh, const AttributeSources& sources,
	             const PerOperand<bool>& turned, MeshModel& layer, ElementWriters& writers) const;

	// Adds a sentence for each operand that lacks what another carries.
	void addMessages(const LayerNames& names, std::vector<std::string>& messages) const;

private:
	bool areSame(const OperandElementsAccess::Spot& a, const OperandElementsAccess::Spot& b) const;
	void prepareFaceProvenance(const AttributeSources& sources, MeshModel& layer,
	                           ElementWriters& writers) const;
	void prepareVertexProvenance(const SourcedMesh& mesh, const AttributeSources& sources,
	                             MeshModel& layer, ElementWriters& writers) const;

	AttributeOptions options_;
	OperandElementsAccess access_;
	TextureList textures_;
	std::vector<AttributeColumn> columns_;
};

}  // namespace index_boolean
