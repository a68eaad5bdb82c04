// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers only; the polylines are the core's.
#include "layers/curve_layer.h"

#include "texts/filter_definitions.h"

namespace index_boolean {

namespace {

template <class Number>
ScalarAttribute perVertex(const char* name, const CurveLines& curves, Number&& number) {
	ScalarAttribute attribute{name, {}};
	attribute.values.reserve(curves.points.size());
	for (std::size_t vertex = 0; vertex < curves.points.size(); ++vertex) {
		attribute.values.push_back(static_cast<std::int32_t>(number(vertex)));
	}
	return attribute;
}

}  // namespace

LayerContent curveContent(const CurveLines& curves, const OperandArrays& read,
                          const LayerNames& names) {
	const auto source = [&](const char* name, std::size_t side) {
		return perVertex(name, curves, [&, side](std::size_t vertex) {
			const OperandId operand = curves.operands[vertex][side];
			return read.elements[operand].faces[curves.sources[vertex][side]];
		});
	};
	const auto operand = [&](const char* name, std::size_t side) {
		return perVertex(name, curves, [&, side](std::size_t vertex) {
			return curves.operands[vertex][side].value;
		});
	};
	LayerContent content;
	content.label = QString::fromStdString(curvesLabel(names));
	content.curves = &curves;
	content.vertexAttributes = {
	    perVertex("loop", curves, [&](std::size_t vertex) { return curves.line[vertex]; }),
	    perVertex("loop_kind", curves,
	              [&](std::size_t vertex) { return curves.lines[curves.line[vertex]].kind; }),
	    source("source_face_first", 0),
	    source("source_face_second", 1),
	};
	if (names.size() != 2) {
		content.vertexAttributes.push_back(operand("source_mesh_first", 0));
		content.vertexAttributes.push_back(operand("source_mesh_second", 1));
	}
	return content;
}

}  // namespace index_boolean
