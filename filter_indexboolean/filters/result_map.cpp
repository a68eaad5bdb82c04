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

// Of a surface that is certified as one.
void addCertificate(const std::string& name, const SourcedMesh& mesh, const SurfaceRepair& ofMesh,
                    const PlaceRepair& repair, ResultMap& map) {
	map[name + "_self_intersections"] = static_cast<int>(mesh.certificate.count());
	if (mesh.certificate.isKnown) {
		map[name + "_repair_rounds"] = toInt(repair.rounds);
		map[name + "_moved_vertices"] = toInt(ofMesh.movedVertices);
		map[name + "_largest_move"] = std::max(repair.largestMove, mesh.wallMerge.largestMove);
		map[name + "_volume_change"] = ofMesh.volumeChange;
		map[name + "_vanished_components"] = toInt(ofMesh.vanishedComponents);
	}
}

// \param i which of the blocks \param name what its keys begin with
void addBlock(const BlocksResult& result, std::size_t i, const std::string& name, int layerId,
              ResultMap& map) {
	const Block& block = result.blocks[i];
	const BlockMeasure& measure = result.audit.blocks[i];
	const PlaceRepair& repair = result.report.placeRepair;
	map[name + "_layer"] = layerId;
	map[name + "_volume"] = measure.volume;
	map[name + "_area"] = measure.area;
	map[name + "_faces"] = toInt(block.triangles.size());
	map[name + "_components"] = toInt(measure.components);
	map[name + "_closed"] = measure.closed;
	map[name + "_open_edges"] = toInt(result.openEdges[i]);
	map[name + "_merged_vertices"] = toInt(block.wallMerge.vertices);
	addCertificate(name, block, block.repair, repair, map);
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

void addSubSurfaces(const SplitResult& result, OperandId operand, const std::string& name,
                    ResultMap& map) {
	const std::vector<SubSurfaceId>& ids = result.split.surfaces.ofOperand[operand];
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
void addCertificates(const SplitResult& result, const SplitNames& names,
                     const PieceLayers& layerIds, ResultMap& map) {
	for (const OperandId operand : result.surfaceMeshes.operands()) {
		if (!layerIds.subSurfaces[operand].empty()) {
			map[names.keyOf(Pieces::subSurfacesOf(operand)) + "_self_intersections"] =
			    listOf(concernedPerSubSurface(result, operand), [](std::int64_t n) { return n; });
		}
	}
	if (!layerIds.subBlocks.empty()) {
		map["sub_blocks_self_intersections"] =
		    listOf(result.blockMeshes, [](const SplitMesh& m) { return m.certificate.count(); });
	}
}

void addSubBlocks(const SplitResult& result, const SplitNames& names, ResultMap& map) {
	const std::vector<SubBlock>& blocks = result.split.blocks.all;
	const WindingRule rule = result.arrangement.options.windingRule;
	map["sub_blocks"] = toInt(blocks.size());
	map["sub_blocks_volumes"] = listOf(blocks, [](const SubBlock& b) { return b.volume; });
	map["sub_blocks_areas"] = listOf(blocks, [](const SubBlock& b) { return b.area; });
	for (const OperandId operand : result.surfaceMeshes.operands()) {
		map["sub_blocks_in_" + names.keyOf(operand)] =
		    listOf(blocks, [&](const SubBlock& b) { return isInside(rule, b.windings[operand]); });
	}
}

void addClips(const SplitResult& result, const std::vector<Clip>& clips, const SplitNames& names,
              const PieceLayers& layerIds, ResultMap& map) {
	for (std::size_t i = 0; i < clips.size(); ++i) {
		const std::string name = names.keyOf(Pieces::of(clips[i]));
		const SplitMesh& mesh = result.clipMeshes[i];
		map[name + "_layer"] = layerIds.clips[i];
		map[name + "_area"] = result.clipMeasures[i].area;
		map[name + "_faces"] = toInt(mesh.triangles.size());
		addCertificate(name, mesh, mesh.repair, result.report.placeRepair, map);
	}
}

// The layers of one kind of pieces, if it was asked for.
void addLayers(const std::string& name, const std::vector<int>& layerIds, ResultMap& map) {
	if (!layerIds.empty()) {
		map[name + "_layer"] = layerIds.front();
		map[name + "_layers"] = listOf(layerIds, [](int id) { return id; });
	}
}

// Which layer each number of a list stands for.
void addOperands(const LayerNames& layers, ResultMap& map) {
	map["operands"] = toInt(layers.size());
	map["operand_layers"] = listOf(layers, [](const LayerName& layer) { return layer.id; });
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

// Of two operands.
void addSelfIntersecting(const RunReport& report, ResultMap& map) {
	map["self_intersecting_faces_first"] = toInt(report.selfIntersecting[kFirst]);
	map["self_intersecting_faces_second"] = toInt(report.selfIntersecting[kSecond]);
}

// What every filter reports that makes blocks.
void addBlocksReport(const BlocksResult& result, const AdapterSeconds& seconds, ResultMap& map) {
	map["volume_law_residual"] = result.audit.volumeLawResidual;
	map["zero_area_faces_removed"] = toInt(zeroAreaFacesRemoved(result.blocks));
	addReport(result.report, seconds, map);
}

}  // namespace

ResultMap resultMap(const BooleanResult& result, const std::vector<int>& layerIds,
                    const AdapterSeconds& seconds) {
	ResultMap map;
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		addBlock(result, i, operationName(result.blocks[i].operation), layerIds[i], map);
	}
	addBlocksReport(result, seconds, map);
	addSelfIntersecting(result.report, map);
	if (layerIds.size() > result.blocks.size()) {
		addLoops(result.curves, layerIds.back(), map);
	}
	return map;
}

ResultMap resultMap(const ExpressionResult& result, const LayerNames& operands,
                    const std::vector<int>& layerIds, const AdapterSeconds& seconds) {
	ResultMap map;
	map["results"] = toInt(result.blocks.size());
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		addBlock(result, i, "result_" + std::to_string(i), layerIds[i], map);
	}
	addOperands(operands, map);
	map["self_intersecting_faces"] =
	    listOf(result.report.selfIntersecting, [](std::size_t faces) { return faces; });
	map["cells"] = toInt(result.cells);
	addBlocksReport(result, seconds, map);
	if (layerIds.size() > result.blocks.size()) {
		addLoops(result.curves, layerIds.back(), map);
	}
	return map;
}

ResultMap resultMap(const ExpressionResult& result, int layerId, const AdapterSeconds& seconds) {
	ResultMap map;
	addBlock(result, 0, "resolved", layerId, map);
	map["self_intersecting_faces"] = toInt(result.report.selfIntersecting[kFirst]);
	addBlocksReport(result, seconds, map);
	return map;
}

ResultMap resultMap(const SplitResult& result, const std::vector<Clip>& clips,
                    const SplitNames& names, const PieceLayers& layerIds,
                    const AdapterSeconds& seconds) {
	ResultMap map;
	for (const OperandId operand : result.surfaceMeshes.operands()) {
		const std::string name = names.keyOf(Pieces::subSurfacesOf(operand));
		addSubSurfaces(result, operand, name, map);
		addLayers(name, layerIds.subSurfaces[operand], map);
		map["self_intersecting_faces_" + names.keyOf(operand)] =
		    toInt(result.report.selfIntersecting[operand]);
	}
	addSubBlocks(result, names, map);
	addLayers("sub_blocks", layerIds.subBlocks, map);
	addCertificates(result, names, layerIds, map);
	addClips(result, clips, names, layerIds, map);
	if (names.isList) {
		addOperands(names.layers, map);
	}
	const WallMerge& merge = result.split.surfaces.wallMerge;
	map["merged_vertices"] = toInt(merge.vertices);
	map["largest_merge"] = merge.largestMove;
	map["sub_blocks_closed"] = result.audit.closed;
	map["volume_law_residual"] = result.audit.volumeLawResidual;
	map["zero_area_faces_removed"] =
	    toInt(zeroAreaFacesRemoved(result.surfaceMeshes) +
	          zeroAreaFacesRemoved(result.blockMeshes) + zeroAreaFacesRemoved(result.clipMeshes));
	addReport(result.report, seconds, map);
	return map;
}

ResultMap resultMap(const CurvesResult& result, int layerId, const AdapterSeconds& seconds) {
	ResultMap map;
	addReport(result.report, seconds, map);
	addSelfIntersecting(result.report, map);
	addLoops(result.curves, layerId, map);
	addIncidence(result.curves, result.surfaces, map);
	return map;
}

void addDistances(const DistanceStatistics& statistics, const std::string& suffix, ResultMap& map) {
	map["min" + suffix] = statistics.min;
	map["max" + suffix] = statistics.max;
	map["mean" + suffix] = statistics.mean;
	map["rms" + suffix] = statistics.rms;
	map["mean_absolute" + suffix] = statistics.meanAbsolute;
	map["beyond" + suffix] = toInt(statistics.beyond);
}

}  // namespace index_boolean
