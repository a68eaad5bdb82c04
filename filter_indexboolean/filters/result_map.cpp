// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of the result map.
#include "filters/result_map.h"

#include <host_document.h>

#include <algorithm>

namespace index_boolean {

namespace {

// Counts of elements are below 2^31 by the core's limit.
int toInt(std::size_t count) { return static_cast<int>(count); }

// A stage's name as a part of a key: "octree pairs" gives "octree_pairs".
std::string keyOf(std::string stage) {
	std::replace(stage.begin(), stage.end(), ' ', '_');
	return stage;
}

void addBlock(const BooleanResult& result, std::size_t i, int layerId, ResultMap& map) {
	const Block& block = result.blocks[i];
	const BlockMeasure& measure = result.audit.blocks[i];
	const PlaceRepair& repair = result.report.placeRepair;
	const std::string name = operationName(block.operation);
	map[name + "_layer"] = layerId;
	map[name + "_volume"] = measure.volume;
	map[name + "_area"] = measure.area;
	map[name + "_faces"] = toInt(block.triangles.size());
	map[name + "_components"] = toInt(measure.components);
	map[name + "_closed"] = measure.closed;
	map[name + "_open_edges"] = toInt(result.openEdges[i]);
	map[name + "_self_intersections"] = static_cast<int>(block.certificate.count());
	if (block.certificate.isKnown) {
		map[name + "_repair_rounds"] = toInt(repair.rounds);
		map[name + "_moved_vertices"] = toInt(block.repair.movedVertices);
		map[name + "_largest_move"] = repair.largestMove;
		map[name + "_volume_change"] = block.repair.volumeChange;
		map[name + "_vanished_components"] = toInt(block.repair.vanishedComponents);
	}
}

// Those of all meshes.
template <class Meshes>
std::size_t zeroAreaFacesRemoved(const Meshes& meshes) {
	std::size_t count = 0;
	for (const auto& mesh : meshes) {
		count += mesh.zeroAreaFacesRemoved;
	}
	return count;
}

// For each element, what `number` gives of it.
template <class Elements, class Number>
QVariant listOf(const Elements& elements, Number&& number) {
	std::vector<double> numbers;
	for (const auto& element : elements) {
		numbers.push_back(static_cast<double>(number(element)));
	}
	return listValue(numbers);
}

void addLoops(const CurveLines& curves, int layerId, ResultMap& map) {
	map["curves_layer"] = layerId;
	map["loop_lengths"] = listOf(curves.lines, [](const CurveLine& line) { return line.length; });
	map["loop_kinds"] = listOf(curves.lines, [](const CurveLine& line) { return line.kind; });
}

void addSubSurfaces(const SplitResult& result, OperandId operand, ResultMap& map) {
	const std::vector<SubSurfaceId>& ids = result.split.surfaces.ofOperand[operand];
	const std::string name = kPieceNames[static_cast<std::size_t>(subSurfacesOf(operand))];
	const auto listOfSurfaces = [&](auto&& number) {
		return listOf(ids,
		              [&](SubSurfaceId id) { return number(at(result.split.surfaces.all, id)); });
	};
	map[name] = toInt(ids.size());
	map[name + "_areas"] = listOfSurfaces([](const SubSurface& s) { return s.area; });
	map[name + "_public"] = listOfSurfaces([](const SubSurface& s) { return s.isPublic(); });
	map[name + "_one_sided"] = listOfSurfaces([](const SubSurface& s) { return s.oneSided; });
	map[name + "_boundary_cycles"] =
	    listOfSurfaces([](const SubSurface& s) { return s.closedCycles; });
	map[name + "_separating"] =
	    listOf(ids, [&](SubSurfaceId id) { return at(result.split.blocks.separates, id); });
}

// Per sub-surface, the faces concerned; -1 for each if that is not known.
std::vector<std::int64_t> concernedPerSubSurface(const SplitResult& result, OperandId operand) {
	const SplitMesh& mesh = result.surfaceMeshes[operand];
	const std::int64_t none = mesh.certificate.isKnown ? 0 : -1;
	std::vector<std::int64_t> counts(result.surfaceCount(operand), none);
	for (const std::uint32_t face : mesh.certificate.faces) {
		const SubSurface& surface = at(result.split.surfaces.all, mesh.subSurface[face]);
		++counts[static_cast<std::size_t>(surface.number[operand])];
	}
	return counts;
}

// Of the pieces of each kind that is asked for.
void addCertificates(const SplitResult& result, const PieceLayers& layerIds, ResultMap& map) {
	for (const OperandId operand : result.surfaceMeshes.operands()) {
		const auto kind = static_cast<std::size_t>(subSurfacesOf(operand));
		if (!layerIds[kind].empty()) {
			map[std::string(kPieceNames[kind]) + "_self_intersections"] =
			    listOf(concernedPerSubSurface(result, operand), [](std::int64_t n) { return n; });
		}
	}
	if (!layerIds[static_cast<std::size_t>(PieceKind::SubBlocks)].empty()) {
		map["sub_blocks_self_intersections"] =
		    listOf(result.blockMeshes, [](const SplitMesh& m) { return m.certificate.count(); });
	}
}

void addSubBlocks(const std::vector<SubBlock>& blocks, WindingRule rule, ResultMap& map) {
	const auto isIn = [&](OperandId operand) {
		return listOf(blocks,
		              [=](const SubBlock& b) { return isInside(rule, b.windings[operand]); });
	};
	map["sub_blocks"] = toInt(blocks.size());
	map["sub_blocks_volumes"] = listOf(blocks, [](const SubBlock& b) { return b.volume; });
	map["sub_blocks_areas"] = listOf(blocks, [](const SubBlock& b) { return b.area; });
	map["sub_blocks_in_first"] = isIn(kFirst);
	map["sub_blocks_in_second"] = isIn(kSecond);
}

// Pairs of a loop and a sub-surface of an operand that it bounds, as two lists.
void addIncidence(const CurveLines& curves, const SubSurfaces& surfaces, ResultMap& map) {
	const PerOperand<const char*> operandNames{"first", "second"};
	for (const OperandId operand : operandNames.operands()) {
		std::vector<double> loops, pieces;
		for (std::size_t line = 0; line < curves.lines.size(); ++line) {
			for (const SubSurfaceId id : surfaces.atLoop[line]) {
				const std::int32_t number = at(surfaces.all, id).number[operand];
				if (number < 0) {
					continue;
				}
				loops.push_back(static_cast<double>(line));
				pieces.push_back(number);
			}
		}
		const std::string name = std::string("loops_at_sub_surfaces_") + operandNames[operand];
		map[name + "_loop"] = listValue(loops);
		map[name + "_sub_surface"] = listValue(pieces);
	}
}

// What every filter reports.
void addReport(const RunReport& report, const AdapterSeconds& adapter, ResultMap& map) {
	map["self_intersecting_faces_first"] = toInt(report.selfIntersecting[kFirst]);
	map["self_intersecting_faces_second"] = toInt(report.selfIntersecting[kSecond]);
	map["labelled_by_cells"] = report.isLabelledByCells;
	map["welded_vertices"] = toInt(report.vertexWeld.moved);
	map["largest_weld"] = report.vertexWeld.largestMove;
	map["loops_open"] = toInt(report.loopCounts.open);
	map["loops_hard_closed"] = toInt(report.loopCounts.hardClosed);
	map["loops_soft_closed"] = toInt(report.loopCounts.softClosed);
	for (const StageTime& time : report.stageTimes) {
		map["seconds_" + keyOf(time.stage)] = time.seconds;
	}
	map["seconds_read_layers"] = adapter.readLayers;
	map["seconds_write_layers"] = adapter.writeLayers;
	map["seconds_core"] = report.seconds;
	map["seconds_total"] = adapter.total;
}

}  // namespace

ResultMap resultMap(const BooleanResult& result, const std::vector<int>& layerIds,
                    const AdapterSeconds& seconds) {
	ResultMap map;
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		addBlock(result, i, layerIds[i], map);
	}
	map["volume_law_residual"] = result.audit.volumeLawResidual;
	map["zero_area_faces_removed"] = toInt(zeroAreaFacesRemoved(result.blocks));
	addReport(result.report, seconds, map);
	if (layerIds.size() > result.blocks.size()) {
		addLoops(result.curves, layerIds.back(), map);
	}
	return map;
}

ResultMap resultMap(const SplitResult& result, const PieceLayers& layerIds,
                    const AdapterSeconds& seconds) {
	ResultMap map;
	for (const OperandId operand : result.surfaceMeshes.operands()) {
		addSubSurfaces(result, operand, map);
	}
	addSubBlocks(result.split.blocks.all, result.arrangement.options.windingRule, map);
	addCertificates(result, layerIds, map);
	for (std::size_t kind = 0; kind < layerIds.size(); ++kind) {
		if (layerIds[kind].empty()) {
			continue;
		}
		map[std::string(kPieceNames[kind]) + "_layer"] = layerIds[kind].front();
		map[std::string(kPieceNames[kind]) + "_layers"] =
		    listOf(layerIds[kind], [](int id) { return id; });
	}
	map["sub_blocks_closed"] = result.audit.closed;
	map["volume_law_residual"] = result.audit.volumeLawResidual;
	map["zero_area_faces_removed"] = toInt(zeroAreaFacesRemoved(result.surfaceMeshes) +
	                                       zeroAreaFacesRemoved(result.blockMeshes));
	addReport(result.report, seconds, map);
	return map;
}

ResultMap resultMap(const CurvesResult& result, int layerId, const AdapterSeconds& seconds) {
	ResultMap map;
	addReport(result.report, seconds, map);
	addLoops(result.curves, layerId, map);
	addIncidence(result.curves, result.surfaces, map);
	return map;
}

}  // namespace index_boolean
