// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes are appended to layers; a layer of sub-surfaces is parted by their ids if each is to have
// its own.
#include "layers/split_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace index_boolean {

namespace {

constexpr std::int32_t kNoNumber = -1;

std::vector<std::int32_t>& numbersOf(FaceNumber number, SplitLayer& layer) {
	return layer.numbers[static_cast<std::size_t>(number)];
}

template <class Array>
void append(const Array& more, Array& all) {
	all.insert(all.end(), more.begin(), more.end());
}

SplitLayer emptyLayer(const Pieces& pieces, const SplitNames& names) {
	SplitLayer layer;
	layer.pieces = pieces;
	layer.label = names.labelOf(pieces);
	return layer;
}

// Appends a mesh with the numbers of its faces.
// \param block the sub-block that the mesh bounds, or kNoNumber
void appendMesh(const SplitMesh& mesh, std::int32_t block, const SplitResult& result,
                SplitLayer& layer) {
	const auto first = static_cast<std::uint32_t>(layer.points.size());
	const auto firstFace = static_cast<std::uint32_t>(layer.triangles.size());
	for (const std::uint32_t face : mesh.certificate.faces) {
		layer.certificate.faces.push_back(firstFace + face);
	}
	append(mesh.points, layer.points);
	append(mesh.vertexSource, layer.vertexSource);
	append(mesh.faceSource, layer.faceSource);
	if (!mesh.faux.empty() || !layer.faux.empty()) {
		layer.faux.resize(layer.triangles.size(), 0);
		append(mesh.faux, layer.faux);
		layer.faux.resize(layer.faceSource.size(), 0);
	}
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		const auto& [a, b, c] = mesh.triangles[i];
		layer.triangles.push_back({first + a, first + b, first + c});
		const FaceId source = mesh.faceSource[i].face;
		const OperandId operand = result.arrangement.mesh.operandOf(source);
		const SubSurface& surface = at(result.split.surfaces.all, mesh.subSurface[i]);
		numbersOf(FaceNumber::SubSurface, layer).push_back(surface.number[operand]);
		numbersOf(FaceNumber::BlockFront, layer).push_back(mesh.beside[i][0]);
		numbersOf(FaceNumber::BlockBack, layer).push_back(mesh.beside[i][1]);
		if (block != kNoNumber) {
			numbersOf(FaceNumber::SubBlock, layer).push_back(block);
		}
	}
}

// The ids that a layer's colours stand for.
FaceNumber idOf(PieceKind kind) {
	return kind == PieceKind::SubBlocks ? FaceNumber::SubBlock : FaceNumber::SubSurface;
}

void colourFaces(SplitLayer& layer) {
	// Sub-surfaces of two operands with the same id are not to look alike.
	const bool isOfBlocks = layer.pieces.kind == PieceKind::SubBlocks;
	const std::size_t shift = isOfBlocks ? 0 : 4 * std::size_t{layer.pieces.operand.value};
	for (const std::int32_t id : numbersOf(idOf(layer.pieces.kind), layer)) {
		layer.colours.push_back(colourOf(static_cast<std::size_t>(id) + shift));
	}
}

// Moves the faces of a layer to layers of their own, one for each id from 0 on.
class LayerDivider {
public:
	explicit LayerDivider(const SplitLayer& whole)
	    : whole_(whole), local_(whole.points.size(), kUnused) {}

	// \param faces all those of the id
	SplitLayer part(std::size_t id, const std::vector<std::uint32_t>& faces) {
		SplitLayer layer;
		layer.pieces = whole_.pieces;
		layer.label = whole_.label + " " + std::to_string(id);
		for (const std::uint32_t face : faces) {
			std::array<std::uint32_t, 3> triangle{};
			for (std::size_t corner = 0; corner < 3; ++corner) {
				triangle[corner] = number(whole_.triangles[face][corner], layer);
			}
			if (isConcerned(face)) {
				layer.certificate.faces.push_back(
				    static_cast<std::uint32_t>(layer.triangles.size()));
			}
			layer.triangles.push_back(triangle);
			layer.faceSource.push_back(whole_.faceSource[face]);
			if (!whole_.faux.empty()) {
				layer.faux.push_back(whole_.faux[face]);
			}
			layer.colours.push_back(whole_.colours[face]);
			for (std::size_t k = 0; k < layer.numbers.size(); ++k) {
				if (!whole_.numbers[k].empty()) {
					layer.numbers[k].push_back(whole_.numbers[k][face]);
				}
			}
		}
		for (const std::uint32_t vertex : used_) {
			local_[vertex] = kUnused;
		}
		used_.clear();
		return layer;
	}

private:
	bool isConcerned(std::uint32_t face) const {
		const std::vector<std::uint32_t>& faces = whole_.certificate.faces;
		return std::binary_search(faces.begin(), faces.end(), face);
	}

	static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

	// The vertex's number in the part, which gets it when it is first asked for.
	std::uint32_t number(std::uint32_t vertex, SplitLayer& layer) {
		if (local_[vertex] == kUnused) {
			local_[vertex] = static_cast<std::uint32_t>(layer.points.size());
			layer.points.push_back(whole_.points[vertex]);
			layer.vertexSource.push_back(whole_.vertexSource[vertex]);
			used_.push_back(vertex);
		}
		return local_[vertex];
	}

	const SplitLayer& whole_;
	std::vector<std::uint32_t> local_;  // per vertex of the whole
	std::vector<std::uint32_t> used_;   // by the part that is being made
};

void appendParts(const SplitLayer& whole, std::size_t count, std::vector<SplitLayer>& layers) {
	const auto& ids = whole.numbers[static_cast<std::size_t>(idOf(whole.pieces.kind))];
	std::vector<std::vector<std::uint32_t>> faces(count);
	for (std::uint32_t face = 0; face < ids.size(); ++face) {
		faces[static_cast<std::size_t>(ids[face])].push_back(face);
	}
	LayerDivider divider(whole);
	for (std::size_t id = 0; id < count; ++id) {
		layers.push_back(divider.part(id, faces[id]));
	}
}

void appendSurfaceLayers(const SplitResult& result, OperandId operand, bool separate,
                         const SplitNames& names, std::vector<SplitLayer>& layers) {
	SplitLayer whole = emptyLayer(Pieces::subSurfacesOf(operand), names);
	appendMesh(result.surfaceMeshes[operand], kNoNumber, result, whole);
	colourFaces(whole);
	if (separate) {
		appendParts(whole, result.surfaceCount(operand), layers);
	} else {
		layers.push_back(std::move(whole));
	}
}

void appendBlockLayers(const SplitResult& result, bool separate, const SplitNames& names,
                       std::vector<SplitLayer>& layers) {
	const std::size_t first = layers.size();
	if (!separate || result.blockMeshes.empty()) {
		layers.push_back(emptyLayer(Pieces::subBlocks(), names));
	}
	for (std::size_t id = 0; id < result.blockMeshes.size(); ++id) {
		if (separate) {
			layers.push_back(emptyLayer(Pieces::subBlocks(), names));
			layers.back().label += " " + std::to_string(id);
		}
		appendMesh(result.blockMeshes[id], static_cast<std::int32_t>(id), result, layers.back());
	}
	std::for_each(layers.begin() + static_cast<std::ptrdiff_t>(first), layers.end(), colourFaces);
}

void appendClipLayers(const SplitResult& result, const SplitRequest& request,
                      const SplitNames& names, std::vector<SplitLayer>& layers) {
	for (std::size_t i = 0; i < request.clips.size(); ++i) {
		layers.push_back(emptyLayer(Pieces::of(request.clips[i]), names));
		appendMesh(result.clipMeshes[i], kNoNumber, result, layers.back());
		colourFaces(layers.back());
	}
}

}  // namespace

std::size_t pieceCount(const SplitResult& result, const SplitRequest& request) {
	std::size_t count = request.subBlocks ? result.split.blocks.all.size() : 0;
	for (const OperandId operand : request.subSurfaces.operands()) {
		count += request.subSurfaces[operand] ? result.surfaceCount(operand) : 0;
	}
	return count;
}

bool hasLayerForEachPiece(const SplitResult& result, const SplitRequest& request) {
	return request.separateLayers && pieceCount(result, request) <= request.maxLayers;
}

std::vector<SplitLayer> splitLayers(const SplitResult& result, const SplitRequest& request,
                                    const SplitNames& names) {
	const bool separate = hasLayerForEachPiece(result, request);
	std::vector<SplitLayer> layers;
	for (const OperandId operand : request.subSurfaces.operands()) {
		if (request.subSurfaces[operand]) {
			appendSurfaceLayers(result, operand, separate, names, layers);
		}
	}
	if (request.subBlocks) {
		appendBlockLayers(result, separate, names, layers);
	}
	appendClipLayers(result, request, names, layers);
	return layers;
}

Colour colourOf(std::size_t id) {
	// Steps of the golden ratio spread over the circle of hues; every seventh id gets darker.
	constexpr double kGoldenRatio = 0.618033988749895;
	const double hue = std::fmod(0.58 + static_cast<double>(id) * kGoldenRatio, 1.0) * 6;
	const double value = 0.95 - 0.25 * static_cast<double>(id / 7 % 3) / 2;
	constexpr double kSaturation = 0.6;
	const auto channel = [&](double shift) {
		const double place = std::fmod(shift + hue, 6.0);
		const double fall = std::clamp(std::min(place, 4 - place), 0.0, 1.0);
		return static_cast<std::uint8_t>(std::lround(255 * value * (1 - kSaturation * fall)));
	};
	return {channel(5), channel(3), channel(1)};
}

}  // namespace index_boolean
