// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Welding only takes pairs away: what meets wrongly with equal coordinates as one vertex does so
// with copies too. So copies are left alone at first, and welded where pairs have been found.
#include "vcg_ext/carry/certificates.h"

#include "vcg_ext/arrange/wrong_pairs.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

bool isFloat(const Point& p) {
	return std::all_of(p.begin(), p.end(),
	                   [](double c) { return static_cast<double>(static_cast<float>(c)) == c; });
}

// Whether a vertex may be stored elsewhere than where it exactly is.
bool isRounded(const Arrangement& arrangement, VertexId source) {
	return source == VertexId::none() || arrangement.isCurvePoint(source) ||
	       (arrangement.options.outputScalar == OutputScalar::Float &&
	        !isFloat(at(arrangement.mesh.points, source)));
}

// Per face: it has a rounded corner.
Status findSuspects(const Arrangement& arrangement, const SourcedMesh& mesh, Monitor& monitor,
                    std::vector<std::uint8_t>& isSuspect) {
	constexpr std::size_t kGrain = 1 << 14;
	isSuspect.resize(mesh.triangles.size());
	return parallelFor(isSuspect.size(), kGrain, arrangement.options.threads, monitor,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t f = begin; f < end; ++f) {
			                   const IndexTriangle& t = mesh.triangles[f];
			                   isSuspect[f] = std::any_of(t.begin(), t.end(), [&](std::uint32_t v) {
				                   return isRounded(arrangement, mesh.vertexSource[v]);
			                   });
		                   }
	                   });
}

// The same triangles, with one index for each place at which some faces have corners.
IndexTriangles welded(const SourcedMesh& mesh, const std::vector<FacePair>& pairs) {
	std::vector<std::uint32_t> vertices;
	for (const FacePair& pair : pairs) {
		for (const FaceId face : {pair.a, pair.b}) {
			const IndexTriangle& t = mesh.triangles[face.value];
			vertices.insert(vertices.end(), t.begin(), t.end());
		}
	}
	const Points& points = mesh.points;
	std::sort(vertices.begin(), vertices.end(), [&points](std::uint32_t v, std::uint32_t w) {
		return points[v] != points[w] ? points[v] < points[w] : v < w;
	});
	std::vector<std::uint32_t> keeper(points.size());
	for (std::uint32_t v = 0; v < keeper.size(); ++v) {
		keeper[v] = v;
	}
	for (std::size_t i = 1; i < vertices.size(); ++i) {
		if (points[vertices[i]] == points[vertices[i - 1]]) {
			keeper[vertices[i]] = keeper[vertices[i - 1]];
		}
	}
	IndexTriangles triangles;
	triangles.reserve(mesh.triangles.size());
	for (const IndexTriangle& t : mesh.triangles) {
		triangles.push_back({keeper[t[0]], keeper[t[1]], keeper[t[2]]});
	}
	return triangles;
}

// Takes away pairs of faces of different parts.
void leaveWithinParts(const std::vector<std::uint32_t>& part, std::vector<FacePair>& pairs) {
	const auto isAcross = [&part](const FacePair& pair) {
		return part[pair.a.value] != part[pair.b.value];
	};
	pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isAcross), pairs.end());
}

std::vector<std::uint32_t> facesOf(const WrongPairs& found) {
	std::vector<std::uint32_t> faces = found.zeroAreaFaces;
	for (const FacePair& pair : found.pairs) {
		faces.push_back(pair.a.value);
		faces.push_back(pair.b.value);
	}
	std::sort(faces.begin(), faces.end());
	faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
	return faces;
}

}  // namespace

Status certify(const Arrangement& arrangement, const SourcedMesh& mesh,
               const std::vector<std::uint32_t>& part, Monitor& monitor, Certificate& out) {
	out = {};
	if (!arrangement.options.certify) {
		return {};
	}
	WrongPairOptions options;
	options.threads = arrangement.options.threads;
	std::vector<std::uint8_t> isSuspect;
	WrongPairs found;
	const auto search = [&](const IndexTriangles& triangles) {
		const FacesView faces(mesh.points, triangles.data(), triangles.size());
		const Status searched = findWrongPairsAmong(faces, isSuspect, options, monitor, found);
		if (!part.empty()) {
			leaveWithinParts(part, found.pairs);
		}
		return searched;
	};
	const Status status =
	    inOrder([&] { return findSuspects(arrangement, mesh, monitor, isSuspect); },
	            [&] { return search(mesh.triangles); },
	            [&] { return found.pairs.empty() ? Status{} : search(welded(mesh, found.pairs)); });
	out.isKnown = status.ok();
	out.faces = facesOf(found);
	return status;
}

}  // namespace index_boolean
