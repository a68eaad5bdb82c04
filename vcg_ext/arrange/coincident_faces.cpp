// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/arrange/coincident_faces.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <atomic>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;
constexpr std::uint32_t kEmpty = 0xffffffffu;

// A face's corners in ascending order, and whether it goes round them in that order.
struct FaceKey {
	Triangle sorted;
	bool ascending;
};

FaceKey keyOf(const Triangle& t) {
	FaceKey key{t, true};
	const auto order = [&key](std::size_t i, std::size_t j) {
		if (key.sorted[j] < key.sorted[i]) {
			std::swap(key.sorted[i], key.sorted[j]);
			key.ascending = !key.ascending;
		}
	};
	order(0, 1);
	order(1, 2);
	order(0, 1);
	return key;
}

// The faces of the second operand all of whose corners are the first one's, by their corners.
class FaceTable {
public:
	FaceTable(const Triangles& triangles, const std::vector<std::uint32_t>& faces)
	    : triangles_(triangles) {
		std::size_t size = 16;
		while (size < 2 * faces.size()) {
			size *= 2;
		}
		slots_.assign(size, kEmpty);
		for (const std::uint32_t face : faces) {
			slots_[find(keyOf(triangles[face]))] = face;
		}
	}

	// The face on these corners, or kEmpty.
	std::uint32_t faceOn(const FaceKey& key) const { return slots_[find(key)]; }

private:
	std::size_t find(const FaceKey& key) const {
		std::uint64_t hash = 0x9e3779b97f4a7c15u;
		for (const VertexId v : key.sorted) {
			hash = (hash ^ v.value) * 0xff51afd7ed558ccdu;
			hash ^= hash >> 32;
		}
		std::size_t slot = hash & (slots_.size() - 1);
		while (slots_[slot] != kEmpty && keyOf(triangles_[slots_[slot]]).sorted != key.sorted) {
			slot = (slot + 1) & (slots_.size() - 1);
		}
		return slot;
	}

	const Triangles& triangles_;
	std::vector<std::uint32_t> slots_;
};

class Finder {
public:
	Finder(MeshArrays& mesh, int threads, Monitor& monitor)
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
				    const FaceKey key = keyOf(mesh_.triangles[f]);
				    const std::uint32_t other = table.faceOn(key);
				    if (other != kEmpty &&
				        taken[other - mesh_.faceOffsets.begin(kSecond)].exchange(1) == 0) {
					    const bool same = keyOf(mesh_.triangles[other]).ascending == key.ascending;
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
	return Finder(arrangement.mesh, arrangement.options.threads, monitor).run();
}

}  // namespace index_boolean
