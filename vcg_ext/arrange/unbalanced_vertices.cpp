// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: unbalanced vertices. Each face tells each of its corners which vertex comes next
// and which before. All edges at a vertex are balanced iff it has been told the same vertices, as
// often, in both ways.
#include "vcg_ext/arrange/unbalanced_vertices.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 11;

// For each vertex what its faces tell it, from ends[vertex - 1] to ends[vertex].
class Neighbours {
public:
	explicit Neighbours(const FramePoints& points)
	    : first_(points.first), ends_(points.points.size()) {}

	void count(const IndexTriangle& corners) {
		for (const std::uint32_t v : corners) {
			ends_[v - first_].fetch_add(1, std::memory_order_relaxed);
		}
	}

	// To be called when all are counted.
	void makeRoom() {
		std::uint32_t begin = 0;
		for (auto& end : ends_) {
			begin += end.exchange(begin, std::memory_order_relaxed);
		}
		nexts_.resizeForOverwrite(begin);
		befores_.resizeForOverwrite(begin);
	}

	// In any order, so that what follows must not depend on it.
	void add(const IndexTriangle& corners) {
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t place =
			    ends_[corners[i] - first_].fetch_add(1, std::memory_order_relaxed);
			nexts_[place] = corners[(i + 1) % 3];
			befores_[place] = corners[(i + 2) % 3];
		}
	}

	// Whether all edges at the i-th vertex are balanced; sorts what it has been told.
	bool areBalanced(std::size_t i) {
		const std::size_t begin = i == 0 ? 0 : ends_[i - 1].load(std::memory_order_relaxed);
		const std::size_t size = ends_[i].load(std::memory_order_relaxed) - begin;
		std::uint32_t* const nexts = nexts_.data() + begin;
		std::uint32_t* const befores = befores_.data() + begin;
		std::sort(nexts, nexts + size);
		std::sort(befores, befores + size);
		return std::equal(nexts, nexts + size, befores);
	}

private:
	std::uint32_t first_;
	std::vector<std::atomic<std::uint32_t>> ends_;
	HugeVector<std::uint32_t> nexts_, befores_;
};

}  // namespace

Status findUnbalancedVertices(SearchedSurface& surface, Monitor& monitor) {
	const FacesView& faces = surface.faces;
	std::vector<std::uint8_t>& out = surface.isUnbalanced;
	Neighbours neighbours(surface.points);
	std::atomic<bool> isAnyUnbalanced{false};
	out.assign(surface.points.points.size(), 0);
	const auto forEachFace = [&](auto&& visit) {
		return parallelFor(faces.count(), kGrain, surface.threads, monitor,
		                   [&](std::size_t begin, std::size_t end) {
			                   for (std::size_t face = begin; face < end; ++face) {
				                   visit(faces[face]);
			                   }
		                   });
	};
	const Status status =
	    inOrder([&] { return forEachFace([&](const IndexTriangle& t) { neighbours.count(t); }); },
	            [&] {
		            neighbours.makeRoom();
		            return forEachFace([&](const IndexTriangle& t) { neighbours.add(t); });
	            },
	            [&] {
		            return parallelFor(out.size(), kGrain, surface.threads, monitor,
		                               [&](std::size_t begin, std::size_t end) {
			                               for (std::size_t i = begin; i < end; ++i) {
				                               if (!neighbours.areBalanced(i)) {
					                               out[i] = 1;
					                               isAnyUnbalanced = true;
				                               }
			                               }
		                               });
	            });
	if (!isAnyUnbalanced) {
		out.clear();
	}
	return status;
}

}  // namespace index_boolean
