// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A seam is found by its edges: two faces meet there, and name an end of it by two vertices.
#include "vcg_ext/carry/seams.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

// An edge of a face, between welded vertices, and what the face as given calls them.
using GivenEnds = std::array<VertexId, 2>;
using GivenEdge = EdgeItem<GivenEnds>;

class SeamFinder {
public:
	SeamFinder(const Arrangement& arrangement, const GivenTriangles& given,
	           const SameAttributes& same, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), given_(given), same_(same),
	      monitor_(monitor), apart_(mesh_.points.size()), sides_(mesh_.points.size()) {}

	Status run(Seams& out);

private:
	Triangle cornersAsGiven(std::size_t face) const;
	Status findPlaces(OperandId operand);
	Status listEdges(OperandId operand);
	void compareEnds(VertexId a, VertexId b);
	Status compareEdges();
	void listEnds();
	void joinOthers();
	void markApart();

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	const GivenTriangles& given_;
	const SameAttributes& same_;
	Monitor& monitor_;
	std::vector<VertexId> places_;        // per welded vertex: one that was given there
	std::vector<std::uint8_t> isShared_;  // per welded vertex: there are several in its place
	std::vector<GivenEdge> edges_;
	std::vector<std::array<VertexId, 2>> ends_;  // of these: where, and what is there as given
	UnionFind apart_;                            // vertices that seams connect
	UnionFind sides_;                            // vertices that need not be apart
	std::vector<VertexId> onSeams_;  // of each side that is not all of its place, at least one
};

// What the corners of a face are called as given; none() for a corner that is none there.
Triangle SeamFinder::cornersAsGiven(std::size_t face) const {
	const Triangle& t = mesh_.triangles[face];
	const Triangle given = given_(givenFaceOf(arrangement_, makeId<FaceTag>(face)));
	Triangle corners{VertexId::none(), VertexId::none(), VertexId::none()};
	for (std::size_t i = 0; i < 3; ++i) {
		for (const VertexId g : given) {
			if (at(mesh_.points, g) == at(mesh_.points, t[i])) {
				corners[i] = g;
			}
		}
	}
	return corners;
}

Status SeamFinder::findPlaces(OperandId operand) {
	places_.assign(mesh_.points.size(), VertexId::none());
	isShared_.assign(mesh_.points.size(), 0);
	const std::size_t first = mesh_.faceOffsets.begin(operand);
	const auto look = [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = first + begin; f < first + end; ++f) {
			const Triangle given = cornersAsGiven(f);
			for (std::size_t i = 0; i < 3; ++i) {
				const VertexId welded = mesh_.triangles[f][i];
				if (given[i] == VertexId::none()) {
					continue;
				}
				VertexId& known = at(places_, welded);
				if (known != VertexId::none() && known != given[i]) {
					at(isShared_, welded) = 1;
				}
				known = given[i];
			}
		}
	};
	return inOrderFor(mesh_.faceOffsets.size(operand), kGrain, monitor_, look);
}

Status SeamFinder::listEdges(OperandId operand) {
	edges_.clear();
	const std::size_t first = mesh_.faceOffsets.begin(operand);
	const auto list = [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = first + begin; f < first + end; ++f) {
			const Triangle& t = mesh_.triangles[f];
			if (std::none_of(t.begin(), t.end(),
			                 [&](VertexId v) { return at(isShared_, v) != 0; })) {
				continue;
			}
			const Triangle given = cornersAsGiven(f);
			for (std::size_t i = 0; i < 3; ++i) {
				const std::size_t j = (i + 1) % 3;
				const std::size_t low = t[i] < t[j] ? i : j, high = low == i ? j : i;
				edges_.push_back({t[low].value, t[high].value, {given[low], given[high]}});
			}
		}
	};
	return inOrderFor(mesh_.faceOffsets.size(operand), kGrain, monitor_, list);
}

void SeamFinder::compareEnds(VertexId a, VertexId b) {
	if (a == b || a == VertexId::none() || b == VertexId::none()) {
		return;
	}
	apart_.unite(a.value, b.value);
	if (same_(a, b)) {
		sides_.unite(a.value, b.value);
	}
}

Status SeamFinder::compareEdges() {
	const Status status =
	    sortByEdge(edges_, mesh_.points.size(), arrangement_.options.threads, monitor_);
	if (!status.ok()) {
		return status;
	}
	forEachSortedEdge(edges_.begin(), edges_.end(), [this](auto first, auto last) {
		if (last - first == 2) {
			compareEnds(first[0].item[0], first[1].item[0]);
			compareEnds(first[0].item[1], first[1].item[1]);
		}
	});
	return status;
}

// Without those of which a face as given has no corner.
void SeamFinder::listEnds() {
	ends_.clear();
	for (const GivenEdge& edge : edges_) {
		for (const auto& [place, given] :
		     {std::pair(edge.low, edge.item[0]), std::pair(edge.high, edge.item[1])}) {
			if (given != VertexId::none()) {
				ends_.push_back({VertexId{place}, given});
			}
		}
	}
	std::sort(ends_.begin(), ends_.end());
}

// Vertices in one place that no chain of seams connects need not be apart.
void SeamFinder::joinOthers() {
	for (std::size_t i = 1; i < ends_.size(); ++i) {
		const auto& [place, given] = ends_[i];
		const auto& [placeBefore, before] = ends_[i - 1];
		if (place == placeBefore && apart_.find(given.value) != apart_.find(before.value)) {
			sides_.unite(given.value, before.value);
			apart_.unite(given.value, before.value);
		}
	}
}

// What is left apart: where a place has several sides, each is somewhere beside another in the
// list.
void SeamFinder::markApart() {
	for (std::size_t i = 1; i < ends_.size(); ++i) {
		const auto& [place, given] = ends_[i];
		const auto& [placeBefore, before] = ends_[i - 1];
		if (place == placeBefore && sides_.find(given.value) != sides_.find(before.value)) {
			onSeams_.push_back(given);
			onSeams_.push_back(before);
		}
	}
}

Status SeamFinder::run(Seams& out) {
	const Status status = forEachOperand(mesh_.operands(), [&](OperandId operand) {
		if (!arrangement_.seams[operand]) {
			return Status{};
		}
		const Status compared =
		    inOrder([&] { return findPlaces(operand); }, [&] { return listEdges(operand); },
		            [&] { return compareEdges(); });
		listEnds();
		joinOthers();
		markApart();
		return compared;
	});
	if (onSeams_.empty()) {
		return status;
	}
	sides_.flatten();
	std::vector<std::uint8_t> isApart(sides_.size(), 0);  // per root
	for (const VertexId v : onSeams_) {
		isApart[sides_.root(v.value)] = 1;
	}
	out.side.resize(sides_.size());
	for (std::uint32_t v = 0; v < out.side.size(); ++v) {
		const std::uint32_t root = sides_.root(v);
		out.side[v] = isApart[root] != 0 ? VertexId{root} : VertexId::none();
	}
	return status;
}

}  // namespace

Status findSeams(const Arrangement& arrangement, const GivenTriangles& given,
                 const SameAttributes& same, Monitor& monitor, Seams& out) {
	out = Seams{};
	const auto& seams = arrangement.seams;
	if (std::find(seams.begin(), seams.end(), true) == seams.end()) {
		return {};
	}
	return SeamFinder(arrangement, given, same, monitor).run(out);
}

}  // namespace index_boolean
