// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/solids/block_elements.h"

namespace index_boolean {

void removeFaces(const std::vector<std::uint8_t>& isGone, Block& block) {
	std::size_t kept = 0, keptBeforePieces = 0;
	for (std::size_t f = 0; f < isGone.size(); ++f) {
		if (isGone[f] == 0) {
			keptBeforePieces += f < block.firstPiece ? 1 : 0;
			block.triangles[kept] = block.triangles[f];
			block.faceSource[kept++] = block.faceSource[f];
		}
	}
	block.triangles.resize(kept);
	block.faceSource.resize(kept);
	block.firstPiece = keptBeforePieces;
}

void removeVertices(const std::vector<std::uint8_t>& isGone, Block& block) {
	std::vector<std::uint32_t> newIndex(block.points.size());
	std::uint32_t count = 0;
	for (std::size_t v = 0; v < newIndex.size(); ++v) {
		newIndex[v] = count;
		if (isGone[v] == 0) {
			block.points[count] = block.points[v];
			block.vertexSource[count] = block.vertexSource[v];
			block.suspect[count++] = block.suspect[v];
		}
	}
	block.points.resize(count);
	block.vertexSource.resize(count, VertexId::none());
	block.suspect.resize(count);
	for (IndexTriangle& t : block.triangles) {
		t = {newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]};
	}
}

}  // namespace index_boolean
