// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Column by column; the columns know how.
#include "attributes/attribute_transfer.h"

#include <algorithm>
#include <unordered_map>

namespace index_boolean {

namespace {

constexpr const char *kSourceMesh = "source_mesh", *kSourceFace = "source_face",
                     *kSourceVertex = "source_vertex";

std::vector<const char*> withProvenance(std::vector<const char*> names) {
	names.insert(names.end(), {kSourceMesh, kSourceFace, kSourceVertex});
	return names;
}

}  // namespace

AttributeTransfer::AttributeTransfer(const PerOperand<MeshModel*>& layers,
                                     const OperandArrays& read, const AttributeOptions& options)
    : options_(options), access_(layers, read), textures_(layers),
      columns_(attributeColumns(access_, textures_, withProvenance(options.reserved))) {}

AttributeRequest AttributeTransfer::request() const {
	AttributeRequest request;
	request.given = [this](GivenFace face) { return access_.givenTriangle(face); };
	request.same = [this](VertexId a, VertexId b) {
		return areSame(access_.vertex(a.value), access_.vertex(b.value));
	};
	request.needs.corners =
	    std::any_of(columns_.begin(), columns_.end(),
	                [](const AttributeColumn& c) { return c.of == ElementKind::Corner; });
	request.needs.partCurve = options_.partCurve;
	return request;
}

bool AttributeTransfer::areSame(const OperandElementsAccess::Spot& a,
                                const OperandElementsAccess::Spot& b) const {
	return std::all_of(columns_.begin(), columns_.end(), [&](const AttributeColumn& column) {
		return !column.sameAt || column.sameAt(a, b);
	});
}

PerOperand<std::vector<std::uint32_t>> AttributeTransfer::faceClasses() const {
	PerOperand<std::vector<std::uint32_t>> classes(access_.operands().count());
	if (columns_.empty()) {
		return classes;
	}
	std::unordered_map<std::string, std::uint32_t> numbers;
	std::uint32_t next = 0;
	for (const OperandId operand : classes.operands()) {
		const std::size_t count = access_.elements(operand).faces.count;
		for (std::uint32_t f = 0; f < count; ++f) {
			const auto spot = access_.face({operand, f});
			std::string key;
			const bool hasOneValue =
			    std::all_of(columns_.begin(), columns_.end(),
			                [&](const AttributeColumn& c) { return c.appendKey(spot, key); });
			const auto [known, isNew] =
			    hasOneValue ? numbers.emplace(key, next) : std::pair(numbers.end(), true);
			classes[operand].push_back(isNew ? next++ : known->second);
		}
	}
	return classes;
}

void AttributeTransfer::prepareFaceProvenance(const AttributeSources& sources, MeshModel& layer,
                                              ElementWriters& writers) const {
	const std::size_t n = sources.face.size();
	auto mesh = addFaceAttribute<Scalarm>(kSourceMesh, n, layer.cm);
	auto face = addFaceAttribute<Scalarm>(kSourceFace, n, layer.cm);
	writers.faces.push_back([=, &sources](std::size_t begin, std::size_t end) mutable {
		for (std::size_t f = begin; f < end; ++f) {
			const auto spot = access_.face(sources.face[f]);
			mesh[f] = static_cast<Scalarm>(spot.operand.value);
			face[f] = static_cast<Scalarm>(spot.position);
		}
	});
}

void AttributeTransfer::prepareVertexProvenance(const SourcedMesh& mesh,
                                                const AttributeSources& sources, MeshModel& layer,
                                                ElementWriters& writers) const {
	const std::size_t n = sources.vertex.size();
	auto vertexMesh = addVertexAttribute<Scalarm>(kSourceMesh, n, layer.cm);
	auto vertex = addVertexAttribute<Scalarm>(kSourceVertex, n, layer.cm);
	writers.vertices.push_back([=, &mesh, &sources](std::size_t begin, std::size_t end) mutable {
		for (std::size_t v = begin; v < end; ++v) {
			const std::uint32_t given =
			    sources.isMix(v) ? mesh.vertexSource[v].value : sources.vertex[v];
			const bool isNew = given >= sources.vertexCount;
			const auto spot = isNew ? OperandElementsAccess::Spot{} : access_.vertex(given);
			vertexMesh[v] = isNew ? Scalarm(-1) : static_cast<Scalarm>(spot.operand.value);
			vertex[v] = isNew ? Scalarm(-1) : static_cast<Scalarm>(spot.position);
		}
	});
}

void AttributeTransfer::prepare(const SourcedMesh& mesh, const AttributeSources& sources,
                                const PerOperand<bool>& turned, MeshModel& layer,
                                ElementWriters& writers) const {
	writers.vertices.push_back(normalColumn(access_, turned).prepare(sources, layer));
	for (const AttributeColumn& column : columns_) {
		(column.of == ElementKind::Vertex ? writers.vertices : writers.faces)
		    .push_back(column.prepare(sources, layer));
	}
	prepareFaceProvenance(sources, layer, writers);
	prepareVertexProvenance(mesh, sources, layer, writers);
	if (options_.selectCurve) {
		writers.vertices.push_back([&mesh, &sources, &layer](std::size_t begin, std::size_t end) {
			for (std::size_t v = begin; v < end; ++v) {
				if (mesh.vertexSource[v].value >= sources.vertexCount) {
					layer.cm.vert[v].SetS();
				} else {
					layer.cm.vert[v].ClearS();
				}
			}
		});
	}
	textures_.addTo(layer);
}

void AttributeTransfer::addMessages(const LayerNames& names,
                                    std::vector<std::string>& messages) const {
	for (const OperandId operand : names.operands()) {
		std::vector<std::string> lacking;
		for (const AttributeColumn& column : columns_) {
			if (!column.has[operand] && !column.name.empty()) {
				lacking.push_back(column.name);
			}
		}
		if (!lacking.empty()) {
			messages.push_back(lackingAttributesMessage(names[operand], lacking));
		}
	}
}

}  // namespace index_boolean
