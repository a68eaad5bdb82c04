// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coincident triangles and coincident edges are both found by grouping them by their smallest
// vertex: by counting where there are many of them, else by sorting.
#include "surface_complex.h"

#include "mesh_checks.h"
#include "parallel.h"
#include "self_intersecting.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

// A half-edge by the ends of its edge.
struct EdgeEntry {
	VertexId low, high;
	HalfEdgeId halfEdge;

	bool isOn(const EdgeEntry& other) const { return low == other.low && high == other.high; }
	friend bool operator<(const EdgeEntry& a, const EdgeEntry& b) {
		return a.low != b.low     ? a.low < b.low
		       : a.high != b.high ? a.high < b.high
		                          : a.halfEdge < b.halfEdge;
	}
};

// A face by its corners in ascending order.
struct FaceEntry {
	VertexId low, middle, high;
	std::uint32_t face;

	bool isOn(const FaceEntry& other) const {
		return low == other.low && middle == other.middle && high == other.high;
	}
	friend bool operator<(const FaceEntry& a, const FaceEntry& b) {
		return a.low != b.low         ? a.low < b.low
		       : a.middle != b.middle ? a.middle < b.middle
		       : a.high != b.high     ? a.high < b.high
		                              : a.face < b.face;
	}
};

// Sorts n entries, entry(i) each, whose `low` is below vertexCount.
template <class Entry, class EntryAt>
Status sortEntries(std::size_t n, EntryAt&& entry, std::size_t vertexCount, int threads,
                   Monitor& monitor, std::vector<Entry>& out) {
	constexpr std::size_t kFew = 8;  // entries per vertex, below which counting does not pay
	out.resize(n);
	if (n < vertexCount / kFew) {
		for (std::size_t i = 0; i < n; ++i) {
			out[i] = entry(i);
		}
		std::sort(out.begin(), out.end());
		return {};
	}
	std::vector<std::uint32_t> next(vertexCount + 2);  // first counts, then ends of groups
	Status status = inOrderFor(n, kGrain, monitor, [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			++next[entry(i).low.value + 2];
		}
	});
	for (std::size_t v = 0; v <= vertexCount; ++v) {
		next[v + 1] += next[v];
	}
	if (status.ok()) {
		status = inOrderFor(n, kGrain, monitor, [&](std::size_t begin, std::size_t end) {
			for (std::size_t i = begin; i < end; ++i) {
				const Entry e = entry(i);
				out[next[e.low.value + 1]++] = e;
			}
		});
	}
	if (status.ok()) {
		status = parallelFor(vertexCount, kGrain, threads, monitor,
		                     [&](std::size_t begin, std::size_t end) {
			                     for (std::size_t v = begin; v < end; ++v) {
				                     std::sort(out.begin() + next[v], out.begin() + next[v + 1]);
			                     }
		                     });
	}
	return status;
}

class Builder {
public:
	Builder(const Arrangement& arrangement, Monitor& monitor, SurfaceComplex& out)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), monitor_(monitor), out_(out),
	      vertexCount_(arrangement.mesh.points.size() + arrangement.curve.pointCount()) {}

	Status run(ComplexOf part);

private:
	void add(const Triangle& corners, FaceId source);
	Status addUncutFaces();
	void addPieces(ComplexOf part);
	bool isIrregular(const Triangle& piece) const;
	Status mergeCoincident();
	Status merge(const FaceEntry* begin, const FaceEntry* end);
	Status joinFaces();
	void join(const EdgeEntry* begin, const EdgeEntry* end);

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
	SurfaceComplex& out_;
	std::size_t vertexCount_;
	std::vector<std::uint32_t> maybeCoincident_;  // faces of the complex
	std::vector<std::uint8_t> isMerged_;          // per face: into an earlier one
};

void Builder::add(const Triangle& corners, FaceId source) {
	RefinedFace face{corners, {FaceId::none(), FaceId::none()}, false};
	face.sources[static_cast<std::size_t>(mesh_.operandOf(source))] = source;
	out_.faces.push_back(face);
}

Status Builder::addUncutFaces() {
	const auto addRange = [this](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			if (arrangement_.refinement.isCut[f] == 0) {
				const FaceId face = makeId<FaceTag>(f);
				if (mesh_.quietTwin(face) != Twin::None) {
					maybeCoincident_.push_back(static_cast<std::uint32_t>(out_.faces.size()));
				}
				add(mesh_.triangles[f], face);
			}
		}
	};
	return inOrderFor(mesh_.triangles.size(), kGrain, monitor_, addRange);
}

bool Builder::isIrregular(const Triangle& piece) const {
	const std::vector<std::uint8_t>& irregular = arrangement_.curve.irregular;
	return (at(irregular, piece[0]) | at(irregular, piece[1]) | at(irregular, piece[2])) != 0;
}

void Builder::addPieces(ComplexOf part) {
	const Refinement& refinement = arrangement_.refinement;
	for (std::size_t i = 0; i < refinement.cutFaces.size(); ++i) {
		const std::size_t end = i + 1 < refinement.cutFaces.size()
		                            ? refinement.cutFaces[i + 1].firstPiece
		                            : refinement.pieces.size();
		for (std::size_t piece = refinement.cutFaces[i].firstPiece; piece < end; ++piece) {
			if (part == ComplexOf::Everything || isIrregular(refinement.pieces[piece])) {
				maybeCoincident_.push_back(static_cast<std::uint32_t>(out_.faces.size()));
				add(refinement.pieces[piece], refinement.cutFaces[i].face);
			}
		}
	}
}

bool runAlike(const Triangle& a, const Triangle& b) {
	const auto first = std::find(b.begin(), b.end(), a[0]);
	return b[static_cast<std::size_t>(nextCorner(static_cast<int>(first - b.begin())))] == a[1];
}

// Makes faces on the same corners, at most one of each operand, one face.
Status Builder::merge(const FaceEntry* begin, const FaceEntry* end) {
	if (end - begin < 2) {
		return {};
	}
	RefinedFace& first = out_.faces[begin->face];
	const RefinedFace& second = out_.faces[(begin + 1)->face];
	if (end - begin == 2 && !first.hasOwnersOf(second)) {
		first.sources[1] = second.source();
		first.opposed = !runAlike(first.corners, second.corners);
		isMerged_[(begin + 1)->face] = 1;
		return {};
	}
	const int operand = mesh_.operandOf(first.source());
	std::vector<FaceId> faces;
	for (const FaceEntry* e = begin; e != end; ++e) {
		const FaceId source = out_.faces[e->face].source();
		if (mesh_.operandOf(source) == operand) {
			faces.push_back(source);
		}
	}
	return selfIntersecting(arrangement_, operand, faces, arrangement_.coordinates(begin->low));
}

Status Builder::mergeCoincident() {
	const auto entry = [this](std::size_t i) {
		Triangle t = out_.faces[maybeCoincident_[i]].corners;
		std::sort(t.begin(), t.end());
		return FaceEntry{t[0], t[1], t[2], maybeCoincident_[i]};
	};
	std::vector<FaceEntry> entries;
	Status status = sortEntries(maybeCoincident_.size(), entry, vertexCount_,
	                            arrangement_.options.threads, monitor_, entries);
	isMerged_.assign(out_.faces.size(), 0);
	bool anyMerged = false;
	for (std::size_t i = 0, end = 0; i < entries.size() && status.ok(); i = end) {
		while (end < entries.size() && entries[end].isOn(entries[i])) {
			++end;
		}
		status = merge(&entries[i], &entries[i] + (end - i));
		anyMerged = anyMerged || end - i > 1;
	}
	if (status.ok() && anyMerged) {
		std::size_t kept = 0;
		for (std::size_t f = 0; f < out_.faces.size(); ++f) {
			if (isMerged_[f] == 0) {
				out_.faces[kept++] = out_.faces[f];
			}
		}
		out_.faces.resize(kept);
	}
	return status;
}

// Takes the half-edges of one edge.
void Builder::join(const EdgeEntry* begin, const EdgeEntry* end) {
	const HalfEdgeId first = begin->halfEdge;
	if (end - begin == 2) {
		const HalfEdgeId second = (begin + 1)->halfEdge;
		if (out_.faceOf(first).hasOwnersOf(out_.faceOf(second))) {
			at(out_.mates, first) = second;
			at(out_.mates, second) = first;
			return;
		}
	}
	const auto place = static_cast<std::uint32_t>(out_.halfEdges.size());
	out_.parting.push_back(
	    {begin->low, begin->high, place, static_cast<std::uint32_t>(end - begin)});
	for (; begin != end; ++begin) {
		out_.halfEdges.push_back(begin->halfEdge);
	}
}

Status Builder::joinFaces() {
	const auto entry = [this](std::size_t i) {
		const HalfEdgeId h = makeId<HalfEdgeTag>(i);
		const std::pair<VertexId, VertexId> ends = std::minmax(out_.beginOf(h), out_.endOf(h));
		return EdgeEntry{ends.first, ends.second, h};
	};
	std::vector<EdgeEntry> entries;
	const std::size_t count = 3 * out_.faces.size();
	const Status status =
	    sortEntries(count, entry, vertexCount_, arrangement_.options.threads, monitor_, entries);
	if (!status.ok()) {
		return status;
	}
	out_.mates.assign(count, HalfEdgeId::none());
	std::size_t first = 0;  // entry of an edge, which may lie in several chunks
	return inOrderFor(count, kGrain, monitor_, [&](std::size_t, std::size_t chunkEnd) {
		while (first < chunkEnd) {
			std::size_t end = first + 1;
			while (end < count && entries[end].isOn(entries[first])) {
				++end;
			}
			join(&entries[first], &entries[first] + (end - first));
			first = end;
		}
	});
}

Status Builder::run(ComplexOf part) {
	Status status;
	if (part == ComplexOf::Everything) {
		out_.faces.reserve(mesh_.triangles.size() + arrangement_.refinement.pieces.size());
		status = addUncutFaces();
	}
	addPieces(part);
	if (status.ok()) {
		status = checkCounts(vertexCount_, 3 * out_.faces.size());
	}
	if (status.ok()) {
		status = mergeCoincident();
	}
	return status.ok() ? joinFaces() : status;
}

}  // namespace

const PartingEdge* SurfaceComplex::partingEdge(VertexId a, VertexId b) const {
	const std::pair<VertexId, VertexId> key = std::minmax(a, b);
	const auto it =
	    std::lower_bound(parting.begin(), parting.end(), key,
	                     [](const PartingEdge& e, const std::pair<VertexId, VertexId>& k) {
		                     return e.low != k.first ? e.low < k.first : e.high < k.second;
	                     });
	const bool found = it != parting.end() && it->low == key.first && it->high == key.second;
	return found ? &*it : nullptr;
}

HalfEdgeId SurfaceComplex::turnAround(HalfEdgeId from, VertexId around) const {
	while (true) {
		const std::uint32_t face = from.value / 3;
		const auto corner = static_cast<int>(from.value % 3);
		const int other = beginOf(from) == around ? previousCorner(corner) : nextCorner(corner);
		const HalfEdgeId last{3 * face + static_cast<std::uint32_t>(other)};
		from = at(mates, last);
		if (from == HalfEdgeId::none()) {
			return last;
		}
	}
}

Status buildComplex(const Arrangement& arrangement, ComplexOf part, Monitor& monitor,
                    SurfaceComplex& out) {
	out = SurfaceComplex{};
	return Builder(arrangement, monitor, out).run(part);
}

}  // namespace index_boolean
