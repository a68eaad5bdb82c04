// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/solids/merge_walls.h"

#include "vcg_ext/arrange/face_classes.h"
#include "vcg_ext/arrange/merge_near_coplanar.h"

namespace index_boolean {

namespace {

// Takes the merged faces, and only the vertices that they still have.
void take(const NearCoplanarMerge& merge, Block& block) {
	std::vector<std::uint32_t> newIndex(block.points.size(), 0);
	for (const std::uint32_t v : merge.gone) {
		newIndex[v] = kNone;
	}
	std::uint32_t count = 0;
	for (std::size_t v = 0; v < newIndex.size(); ++v) {
		if (newIndex[v] != kNone) {
			block.points[count] = block.points[v];
			block.vertexSource[count] = block.vertexSource[v];
			newIndex[v] = count++;
		}
	}
	block.points.resize(count);
	block.vertexSource.resize(count, VertexId::none());
	const HugeVector<FaceSource> sources = std::move(block.faceSource);
	block.triangles.clear();
	block.faceSource.clear();
	for (std::size_t f = 0; f < merge.triangles.size(); ++f) {
		const IndexTriangle& t = merge.triangles[f];
		block.triangles.push_back({newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]});
		block.faceSource.push_back(sources[merge.origin[f]]);
	}
}

// The faces that are wrong stay, under other numbers.
void renumber(const NearCoplanarMerge& merge, std::vector<std::uint32_t>& faces) {
	std::size_t next = 0;
	std::vector<std::uint32_t> renumbered;
	for (std::uint32_t f = 0; f < merge.firstNew && next < faces.size(); ++f) {
		if (merge.origin[f] == faces[next]) {
			renumbered.push_back(f);
			++next;
		}
	}
	faces = std::move(renumbered);
}

}  // namespace

Status mergeWalls(const Arrangement& arrangement, Monitor& monitor, Block& block) {
	const Options& options = arrangement.options;
	if (!(options.mergeTolerance > 0)) {
		return {};
	}
	std::vector<std::uint32_t> classes;
	listFaceClasses(arrangement, block.faceSource, classes);
	NearCoplanarMerge merge;
	const Status status =
	    mergeNearCoplanar({block.points, block.triangles, classes, block.certificate.faces,
	                       options.mergeTolerance, options.threads},
	                      monitor, merge);
	if (status.ok() && merge.any()) {
		renumber(merge, block.certificate.faces);
		take(merge, block);
		block.wallMerge = {merge.gone.size(), merge.largestMove};
	}
	return status;
}

}  // namespace index_boolean
