// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/block_layers.h"

#include "texts/messages.h"

#include <algorithm>

namespace index_boolean {

Options readBlockOptions(FilterId filter, const ParameterValues& values) {
	Options options = readSurfaceOptions(filter, values);
	options.mergeFragments = values.getBool("merge_fragments");
	options.mergeCoplanar = values.getBool("merge_coplanar");
	options.weldNonManifold = values.getBool("weld_non_manifold");
	return options;
}

std::unique_ptr<AttributeTransfer> attributeTransfer(const ParameterValues& values,
                                                     const OperandLayers& operands,
                                                     BlocksRequest& request, OperandArrays& read) {
	if (!values.getBool("transfer_attributes")) {
		return nullptr;
	}
	AttributeOptions options;
	options.partCurve = values.getBool("duplicate_curve_vertices");
	options.selectCurve = values.getBool("select_curve_vertices");
	auto transfer = std::make_unique<AttributeTransfer>(operands.layers, read, options);
	request.attributes = transfer->request();
	if (request.options.mergeCoplanar || request.options.mergeTolerance > 0) {
		read.arrays.faceClass = transfer->faceClasses();
	}
	return transfer;
}

std::vector<LayerContent> blockContents(const BlocksResult& result,
                                        const std::vector<std::string>& labels,
                                        const AttributeTransfer* transfer) {
	std::vector<LayerContent> contents;
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		const Block& block = result.blocks[i];
		LayerContent content;
		content.label = QString::fromStdString(labels[i]);
		content.surface = &block;
		content.selectedFaces = &block.certificate.faces;
		if (transfer != nullptr) {
			content.prepareAttributes = [&result, &block, transfer, i](MeshModel& layer,
			                                                           ElementWriters& writers) {
				transfer->prepare(block, result.sources[i], result.report.insideOut, layer,
				                  writers);
			};
		}
		contents.push_back(std::move(content));
	}
	return contents;
}

std::vector<int> idsOf(const std::vector<MeshModel*>& layers) {
	std::vector<int> ids;
	for (const MeshModel* layer : layers) {
		ids.push_back(layer->id());
	}
	return ids;
}

void addCertificateMessages(const BlocksResult& result, const std::vector<std::string>& labels,
                            OutputScalar scalar, std::vector<std::string>& messages) {
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		if (result.blocks[i].wallMerge.vertices > 0) {
			messages.push_back(mergedMessage("\"" + labels[i] + "\"", result.blocks[i].wallMerge));
		}
		const std::size_t faces = result.blocks[i].certificate.faces.size();
		if (faces > 0) {
			messages.push_back(uncertifiedMessage(labels[i], faces, scalar));
		}
	}
	if (std::all_of(result.blocks.begin(), result.blocks.end(),
	                [](const Block& block) { return block.certificate.count() == 0; })) {
		messages.push_back(certifiedMessage(result.blocks.size(), scalar));
	}
}

}  // namespace index_boolean
