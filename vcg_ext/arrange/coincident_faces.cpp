// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands, with common vertices; out: their twins, from a table of one operand's faces.
#include "vcg_ext/arrange/coincident_faces.h"

#include "vcg_ext/base/index_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/face_key.h"

#include <algorithm>
#include <atomic>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

using VertexKey = FaceKey<VertexId>;

// The faces of the second operand all of whose corners are the first one's, by their corners.
class FaceTable {
	auto isOn(const VertexKey& key) const {
		return [this, &key](std::uint32_t face) { return faceKeyOf(triangles_[face]) == key; };
	}

public:
	FaceTable(const Triangles& triangles, const std::vector<std::uint32_t>& faces)
	    : triangles_(triangles), table_(faces.size()) {
		for (const std::uint32_t face : faces) {
			const VertexKey key = faceKeyOf(triangles[face]);
			table_.slotOf(hashOf(key), isOn(key)) = face;
		}
	}

	// The last of the faces on these corners, or IndexTable::kNone.
	std::uint32_t faceOn(const VertexKey& key) const { return table_.find(hashOf(key), isOn(key)); }

private:
	const Triangles& triangles_;
	IndexTable table_;
};

class TwinSearch {
public:
	TwinSearch(MeshArrays& mesh, int threads, Monitor& monitor)
	    : mesh_(mesh), threads_(threads), monitor_(monitor) {}

	Status run() {
		const std::vector<std::uint32_t> faces = facesOnCommonVertices();
		if (faces.empty()) {
			return {};
		}
		Status status = findTwins(FaceTable(mesh_.triangles, faces));
		if (status.ok()) {
			markQuietVertices();
			status = keepQuietFaces();
		}
		return status;
	}

private:
	std::vector<std::uint32_t> facesOnCommonVertices() const {
		std::vector<std::uint32_t> faces;
		for (std::uint32_t f = mesh_.faceOffsets.begin(kSecond); f < mesh_.faceOffsets.total();
		     ++f) {
			const Triangle& t = mesh_.triangles[f];
			if (std::max({t[0].value, t[1].value, t[2].value}) <
			    mesh_.vertexOffsets.begin(kSecond)) {
				faces.push_back(f);
			}
		}
		return faces;
	}

	// Of several faces on the same corners one has a twin, the others have none: around them
	// nothing is quiet.
	Status findTwins(const FaceTable& table) {
		mesh_.quietFaces.assign(mesh_.triangles.size(), Twin::None);
		std::vector<std::atomic<std::uint8_t>> taken(mesh_.faceOffsets.total() -
		                                             mesh_.faceOffsets.begin(kSecond));
		return parallelFor(
		    mesh_.faceOffsets.begin(kSecond), kGrain, threads_, monitor_,
		    [&](std::size_t begin, std::size_t end) {
			    for (std::size_t f = begin; f < end; ++f) {
				    const VertexKey key = faceKeyOf(mesh_.triangles[f]);
				    const std::uint32_t other = table.faceOn(key);
				    if (other != IndexTable::kNone &&
				        taken[other - mesh_.faceOffsets.begin(kSecond)].exchange(1) == 0) {
					    const bool same =
					        faceKeyOf(mesh_.triangles[other]).ascending == key.ascending;
					    mesh_.quietFaces[f] = same ? Twin::SameWay : Twin::Opposite;
					    mesh_.quietFaces[other] = mesh_.quietFaces[f];
				    }
			    }
		    });
	}

	// A vertex is quiet if all its faces have twins.
	void markQuietVertices() {
		mesh_.quietVertices.assign(mesh_.points.size(), 0);
		for (const Twin wanted : {Twin::SameWay, Twin::None}) {
			for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
				if ((mesh_.quietFaces[f] == Twin::None) == (wanted == Twin::None)) {
					for (const VertexId v : mesh_.triangles[f]) {
						at(mesh_.quietVertices, v) = wanted == Twin::None ? 0 : 1;
					}
				}
			}
		}
	}

	Status keepQuietFaces() {
		return parallelFor(mesh_.triangles.size(), kGrain, threads_, monitor_,
		                   [&](std::size_t begin, std::size_t end) {
			                   for (std::size_t f = begin; f < end; ++f) {
				                   const Triangle& t = mesh_.triangles[f];
				                   if (!mesh_.isQuiet(t[0]) || !mesh_.isQuiet(t[1]) ||
				                       !mesh_.isQuiet(t[2])) {
					                   mesh_.quietFaces[f] = Twin::None;
				                   }
			                   }
		                   });
	}

	MeshArrays& mesh_;
	int threads_;
	Monitor& monitor_;
};

}  // namespace

Status findCoincidentFaces(Arrangement& arrangement, Monitor& monitor) {
	return TwinSearch(arrangement.mesh, arrangement.options.threads, monitor).run();
}

}  // namespace index_boolean
