// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One attribute of vertices, faces or corners (MeshLab's wedges): where its values are read in the
// operands' layers, and how they get into a new layer, by the sources that the core has found.
// Guarantee: an uncut element has its source's value, bit by bit; an operand that lacks the
// attribute gives its elements the default.
#pragma once

#include "attributes/attribute_mix.h"
#include "layers/layers.h"

#include <vcg_ext/index_boolean.h>

#include <cstring>
#include <functional>
#include <string>
#include <utility>

namespace index_boolean {

// The elements of the operands' layers by the core's numbers for them. Borrows the layers and what
// was noticed when they were read.
class OperandElementsAccess {
public:
	OperandElementsAccess(const PerOperand<MeshModel*>& layers, const OperandArrays& read);

	Operands operands() const { return layers_.operands(); }
	const CMeshO& mesh(OperandId operand) const { return layers_[operand]->cm; }
	const MeshModel& layer(OperandId operand) const { return *layers_[operand]; }
	const OperandElements& elements(OperandId operand) const { return elements_[operand]; }

	struct Spot {
		OperandId operand;
		std::size_t position;  // in the layer's vector
	};
	Spot vertex(std::uint32_t given) const {
		const OperandId operand = vertices_.operandOf(given);
		return {operand, elements_[operand].vertices[given - vertices_.begin(operand)]};
	}
	Spot face(GivenFace given) const {
		return {given.operand, elements_[given.operand].faces[given.index]};
	}
	// The position of a face's corner among the vertices of its layer.
	std::size_t cornerVertex(const Spot& face, std::size_t corner) const {
		const CMeshO& m = mesh(face.operand);
		return static_cast<std::size_t>(m.face[face.position].cV(static_cast<int>(corner)) -
		                                m.vert.data());
	}
	// See attributes.h of the core.
	Triangle givenTriangle(GivenFace given) const {
		const Spot spot = face(given);
		const auto& f = mesh(spot.operand).face[spot.position];
		const VertexNumbering<CMeshO>& numbering = numberings_[spot.operand];
		return {numbering.of(f.cV(0)), numbering.of(f.cV(1)), numbering.of(f.cV(2))};
	}

private:
	VertexNumbering<CMeshO> numberingOf(OperandId operand) const;

	PerOperand<const MeshModel*> layers_;
	PerOperand<OperandElements> elements_;
	OperandOffsets vertices_;  // as given
	PerOperand<VertexNumbering<CMeshO>> numberings_;
};

enum class ElementKind : std::uint8_t { Vertex, Face, Corner };

struct AttributeColumn {
	std::string name;      // in sentences: "vertex colours"; empty: nobody misses it
	PerOperand<bool> has;  // which operands carry it
	ElementKind of;        // what has a value each
	// Makes room in a layer that is still empty; what writes the values borrows the sources.
	std::function<RangeWriter(const AttributeSources&, MeshModel&)> prepare;
	// Appends the bytes of the value that all of a face has; false if it has not one value.
	std::function<bool(const OperandElementsAccess::Spot& face, std::string& key)> appendKey;
	// Whether two vertices of one operand have the same value; empty but for vertex columns.
	std::function<bool(const OperandElementsAccess::Spot&, const OperandElementsAccess::Spot&)>
	    sameAt;
};

// The bytes of a value without padding: what two equal values have in common.
template <class Value>
void appendBytes(const Value& value, std::string& key) {
	key.append(reinterpret_cast<const char*>(&value), sizeof value);
}

inline void appendBytes(const CurvatureValue& value, std::string& key) {
	for (int axis = 0; axis < 3; ++axis) {
		appendBytes(value.direction1[axis], key);
		appendBytes(value.direction2[axis], key);
	}
	appendBytes(value.k1, key);
	appendBytes(value.k2, key);
}

template <class Scalar>
void appendBytes(const vcg::TexCoord2<Scalar, 1>& value, std::string& key) {
	appendBytes(value.U(), key);
	appendBytes(value.V(), key);
	appendBytes(value.N(), key);
}

// Appends the first value. \return whether all three are the same
template <class Value>
bool appendConstant(const std::array<Value, 3>& values, std::string& key) {
	appendBytes(values[0], key);
	return values[1] == values[0] && values[2] == values[0];
}

// \param get     get(operand, position): a vertex's value; called only where the operand has it
// \param prepare prepare(layer, sources): makes room, and returns what writes one value:
//                put(vertex, value)
template <class Value, class Get, class Prepare>
AttributeColumn vertexColumn(const OperandElementsAccess& access, std::string name,
                             PerOperand<bool> has, Value missing, Get get, Prepare prepare) {
	AttributeColumn column{std::move(name), has, ElementKind::Vertex, {}, {}, {}};
	const auto cornerValues = [&access, get](const OperandElementsAccess::Spot& face) {
		std::array<Value, 3> values;
		for (std::size_t j = 0; j < 3; ++j) {
			values[j] = get(face.operand, access.cornerVertex(face, j));
		}
		return values;
	};
	const auto valueOf = [=, &access](const AttributeSources& sources, std::size_t v) {
		if (sources.isMix(v)) {
			const AttributeMix& mix = sources.mixOfVertex(v);
			const auto face = access.face(mix.face);
			return has[face.operand] ? mixed(cornerValues(face), mix.weights) : missing;
		}
		const auto vertex = access.vertex(sources.vertex[v]);
		return has[vertex.operand] ? get(vertex.operand, vertex.position) : missing;
	};
	column.sameAt = [=](const OperandElementsAccess::Spot& a,
	                    const OperandElementsAccess::Spot& b) {
		return !has[a.operand] || get(a.operand, a.position) == get(b.operand, b.position);
	};
	column.prepare = [=](const AttributeSources& sources, MeshModel& layer) -> RangeWriter {
		return [=, &sources, put = prepare(layer, sources)](std::size_t begin,
		                                                    std::size_t end) mutable {
			for (std::size_t v = begin; v < end; ++v) {
				put(v, valueOf(sources, v));
			}
		};
	};
	column.appendKey = [=](const OperandElementsAccess::Spot& face, std::string& key) {
		return appendConstant(has[face.operand] ? cornerValues(face)
		                                        : std::array<Value, 3>{missing, missing, missing},
		                      key);
	};
	return column;
}

// As vertexColumn, for faces.
template <class Value, class Get, class Prepare>
AttributeColumn faceColumn(const OperandElementsAccess& access, std::string name,
                           PerOperand<bool> has, Value missing, Get get, Prepare prepare) {
	AttributeColumn column{std::move(name), has, ElementKind::Face, {}, {}, {}};
	const auto valueOf = [=](const OperandElementsAccess::Spot& face) {
		return has[face.operand] ? get(face.operand, face.position) : missing;
	};
	column.prepare = [=, &access](const AttributeSources& sources,
	                              MeshModel& layer) -> RangeWriter {
		return [=, &access, &sources, put = prepare(layer, sources)](std::size_t begin,
		                                                             std::size_t end) mutable {
			for (std::size_t f = begin; f < end; ++f) {
				put(f, valueOf(access.face(sources.face[f])));
			}
		};
	};
	column.appendKey = [=](const OperandElementsAccess::Spot& face, std::string& key) {
		appendBytes(valueOf(face), key);
		return true;
	};
	return column;
}

// As vertexColumn, for corners: get(operand, face, corner), put(face, corner, value).
template <class Value, class Get, class Prepare>
AttributeColumn cornerColumn(const OperandElementsAccess& access, std::string name,
                             PerOperand<bool> has, Value missing, Get get, Prepare prepare) {
	AttributeColumn column{std::move(name), has, ElementKind::Corner, {}, {}, {}};
	const auto cornerValues = [get](const OperandElementsAccess::Spot& face) {
		return std::array<Value, 3>{get(face.operand, face.position, std::size_t{0}),
		                            get(face.operand, face.position, std::size_t{1}),
		                            get(face.operand, face.position, std::size_t{2})};
	};
	const auto valueOf = [=, &access](const AttributeSources& sources, std::size_t f,
	                                  std::size_t corner) {
		const std::uint32_t source = sources.corner[f][corner];
		const bool isMix = source >= 3;
		const auto face = access.face(isMix ? sources.mixes[source - 3].face : sources.face[f]);
		if (!has[face.operand]) {
			return missing;
		}
		return isMix ? mixed(cornerValues(face), sources.mixes[source - 3].weights)
		             : get(face.operand, face.position, std::size_t{source});
	};
	column.prepare = [=](const AttributeSources& sources, MeshModel& layer) -> RangeWriter {
		return [=, &sources, put = prepare(layer, sources)](std::size_t begin,
		                                                    std::size_t end) mutable {
			for (std::size_t f = begin; f < end; ++f) {
				for (std::size_t i = 0; i < 3; ++i) {
					put(f, i, valueOf(sources, f, i));
				}
			}
		};
	};
	column.appendKey = [=](const OperandElementsAccess::Spot& face, std::string& key) {
		return appendConstant(has[face.operand] ? cornerValues(face)
		                                        : std::array<Value, 3>{missing, missing, missing},
		                      key);
	};
	return column;
}

}  // namespace index_boolean
