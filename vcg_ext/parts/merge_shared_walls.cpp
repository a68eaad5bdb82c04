// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All sub-surfaces are one surface here, with edges that any number of triangles have: around a
// vertex of a line in which sheets meet each sheet is a run of its own, and a vertex goes from all
// of them or from none.
#include "vcg_ext/parts/merge_shared_walls.h"

#include "vcg_ext/arrange/face_classes.h"
#include "vcg_ext/arrange/merge_near_coplanar.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/stored_operands.h"
#include "vcg_ext/base/union_find.h"

#include <map>

namespace index_boolean {

namespace {

// The triangles of all sub-surfaces as they are stored.
struct StoredSheets {
	HugeVector<VertexId> vertices;  // of the arrangement as stored, ascending
	Points points;
	IndexTriangles triangles;
	std::vector<std::uint32_t> face;  // of the complex, per triangle; ascending
};

// Vertices that an edge joins and rounding has put in one place become one, and triangles with two
// such corners go: what they parted is joined.
void weldShortEdges(StoredSheets& sheets) {
	UnionFind sets(sheets.points.size());
	for (const IndexTriangle& t : sheets.triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			if (sheets.points[t[i]] == sheets.points[t[(i + 1) % 3]]) {
				sets.unite(t[i], t[(i + 1) % 3]);
			}
		}
	}
	std::size_t kept = 0;
	for (std::size_t f = 0; f < sheets.triangles.size(); ++f) {
		IndexTriangle t = sheets.triangles[f];
		t = {sets.find(t[0]), sets.find(t[1]), sets.find(t[2])};
		if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
			sheets.triangles[kept] = t;
			sheets.face[kept++] = sheets.face[f];
		}
	}
	sheets.triangles.resize(kept);
	sheets.face.resize(kept);
}

StoredSheets sheetsOf(const Arrangement& stored, const SubSurfaces& surfaces) {
	StoredSheets sheets;
	Triangles corners;
	const bool isOther = surfaces.stored.areThere();
	for (std::uint32_t f = 0; f < surfaces.complex.faces.size(); ++f) {
		if (!isOther) {
			corners.push_back(surfaces.complex.faces[f].corners);
			sheets.face.push_back(f);
			continue;
		}
		for (std::uint32_t i = surfaces.stored.first[f]; i < surfaces.stored.first[f + 1]; ++i) {
			corners.push_back(surfaces.stored.triangles[i]);
			sheets.face.push_back(f);
		}
	}
	std::vector<std::uint32_t> numbers(stored.mesh.points.size() + stored.curve.pointCount(),
	                                   kNone);
	for (const Triangle& t : corners) {
		for (const VertexId v : t) {
			numbers[v.value] = 0;
		}
	}
	for (std::uint32_t v = 0; v < numbers.size(); ++v) {
		if (numbers[v] != kNone) {
			numbers[v] = static_cast<std::uint32_t>(sheets.vertices.size());
			sheets.vertices.push_back({v});
			sheets.points.push_back(outputCoordinates(stored, {v}));
		}
	}
	for (const Triangle& t : corners) {
		sheets.triangles.push_back({numbers[t[0].value], numbers[t[1].value], numbers[t[2].value]});
	}
	weldShortEdges(sheets);
	return sheets;
}

// Triangles may become one if they are of one sub-surface, and if all faces that they are of are
// turned alike and may become one.
std::vector<std::uint32_t> classesOf(const Arrangement& arrangement, const SubSurfaces& surfaces,
                                     const StoredSheets& sheets) {
	HugeVector<FaceSource> sources;
	std::vector<std::size_t> first;  // of the sources of each face of the complex
	for (const RefinedFace& face : surfaces.complex.faces) {
		first.push_back(sources.size());
		surfaces.complex.visitSources(face, [&](FaceId source, bool opposed) {
			sources.push_back({source, opposed});
		});
	}
	first.push_back(sources.size());
	std::vector<std::uint32_t> classOfSource;
	listFaceClasses(arrangement, sources, classOfSource);
	std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;
	std::vector<std::uint32_t> ofFace, key;
	for (std::size_t f = 0; f + 1 < first.size(); ++f) {
		key = {surfaces.ofFace[f].value};
		for (std::size_t i = first[f]; i < first[f + 1]; ++i) {
			key.push_back(2 * classOfSource[i] + (sources[i].turned ? 1 : 0));
		}
		const auto number = static_cast<std::uint32_t>(numbers.size());
		ofFace.push_back(numbers.emplace(key, number).first->second);
	}
	std::vector<std::uint32_t> classes;
	for (const std::uint32_t face : sheets.face) {
		classes.push_back(ofFace[face]);
	}
	return classes;
}

// The merged triangles by the faces of the complex that they stand for.
void takeTriangles(const NearCoplanarMerge& merge, const StoredSheets& sheets,
                   std::size_t faceCount, StoredTriangles& out) {
	out.first.assign(faceCount + 1, 0);
	for (const std::uint32_t origin : merge.origin) {
		++out.first[sheets.face[origin] + 1];
	}
	for (std::size_t f = 0; f < faceCount; ++f) {
		out.first[f + 1] += out.first[f];
	}
	out.triangles.resize(merge.triangles.size());
	std::vector<std::uint32_t> next(out.first.begin(), out.first.end() - 1);
	for (std::size_t i = 0; i < merge.triangles.size(); ++i) {
		const IndexTriangle& t = merge.triangles[i];
		out.triangles[next[sheets.face[merge.origin[i]]]++] = {
		    sheets.vertices[t[0]], sheets.vertices[t[1]], sheets.vertices[t[2]]};
	}
}

}  // namespace

Status mergeSharedWalls(const Arrangement& arrangement, Monitor& monitor, SubSurfaces& surfaces) {
	const Options& options = arrangement.options;
	if (!(options.mergeTolerance > 0)) {
		return {};
	}
	const StoredSheets sheets = sheetsOf(asStored(arrangement), surfaces);
	const std::vector<std::uint32_t> classes = classesOf(arrangement, surfaces, sheets);
	NearCoplanarMerge merge;
	const Status status = mergeNearCoplanar(
	    {sheets.points, sheets.triangles, classes, {}, options.mergeTolerance, options.threads},
	    monitor, merge);
	if (status.ok() && merge.any()) {
		takeTriangles(merge, sheets, surfaces.complex.faces.size(), surfaces.stored);
		surfaces.wallMerge = {merge.gone.size(), merge.largestMove};
	}
	return status;
}

}  // namespace index_boolean
