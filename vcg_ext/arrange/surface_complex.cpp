// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coincident triangles and coincident edges are both found by sorting them by their vertices. Most
// faces of most surfaces have plain vertices only, and take no part in it.
#include "vcg_ext/arrange/surface_complex.h"

#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/element_counts.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

using EdgeEntry = EdgeItem<HalfEdgeId>;

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

// The edges that part the surface in one chunk.
struct PartingEdges {
	std::vector<PartingEdge> edges;  // `first` counts from the chunk's half-edges
	std::vector<HalfEdgeId> halfEdges;
};

class Builder {
public:
	Builder(const Arrangement& arrangement, Monitor& monitor, SurfaceComplex& out)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), monitor_(monitor), out_(out),
	      vertexCount_(arrangement.mesh.points.size() + arrangement.curve.pointCount()) {}

	Status run(ComplexOf part);

private:
	Status addUncutFaces();
	void addPieces(ComplexOf part);
	bool isIrregular(const Triangle& piece) const;
	bool isOnCurve(const Triangle& piece) const;
	Status mergeCoincident();
	Status merge(const FaceEntry* begin, const FaceEntry* end);
	void findPlainVertices();
	Status listNearFaces();
	Status joinFaces();
	std::vector<EdgeEntry> listEdges() const;
	bool haveSameOwners(HalfEdgeId a, HalfEdgeId b) const;
	void join(const EdgeEntry* begin, const EdgeEntry* end, PartingEdges& parting);
	void append(const PartingEdges& parting);

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
	SurfaceComplex& out_;
	std::size_t vertexCount_;
	std::vector<std::uint32_t> maybeCoincident_;  // faces of the complex
	std::vector<std::uint8_t> isMerged_;          // per face: into an earlier one
};

// Counts the uncut faces of each chunk, then writes them.
Status Builder::addUncutFaces() {
	const std::vector<std::uint8_t>& isCut = arrangement_.refinement.isCut;
	const std::size_t n = mesh_.triangles.size();
	const int threads = arrangement_.options.threads;
	std::vector<std::size_t> begins(chunkCount(n, kGrain) + 1, 0);
	Status status = parallelForChunks(
	    n, kGrain, threads, monitor_, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    const auto first = isCut.begin() + static_cast<std::ptrdiff_t>(begin);
		    const auto last = isCut.begin() + static_cast<std::ptrdiff_t>(end);
		    begins[chunk + 1] = static_cast<std::size_t>(std::count(first, last, 0));
	    });
	std::partial_sum(begins.begin(), begins.end(), begins.begin());
	out_.faces.resizeForOverwrite(begins.back());
	if (status.ok()) {
		status = parallelForChunks(
		    n, kGrain, threads, monitor_,
		    [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			    std::size_t slot = begins[chunk];
			    for (std::size_t f = begin; f < end; ++f) {
				    if (isCut[f] == 0) {
					    out_.faces[slot++] = {mesh_.triangles[f], makeId<FaceTag>(f), kNone, kNone};
				    }
			    }
		    });
	}
	for (std::uint32_t face = 0; face < begins.back() && !mesh_.quietFaces.empty(); ++face) {
		if (mesh_.quietTwin(out_.faces[face].source) != Twin::None) {
			maybeCoincident_.push_back(face);
		}
	}
	return status;
}

bool Builder::isIrregular(const Triangle& piece) const {
	const std::vector<std::uint8_t>& irregular = arrangement_.curve.irregular;
	return (at(irregular, piece[0]) | at(irregular, piece[1]) | at(irregular, piece[2])) != 0;
}

// Only such a piece can coincide with another face's.
bool Builder::isOnCurve(const Triangle& piece) const {
	return arrangement_.isOnOther(piece[0]) && arrangement_.isOnOther(piece[1]) &&
	       arrangement_.isOnOther(piece[2]);
}

void Builder::addPieces(ComplexOf part) {
	const Refinement& refinement = arrangement_.refinement;
	for (std::size_t i = 0; i < refinement.cutFaces.size(); ++i) {
		const Refinement::PieceRange pieces = refinement.piecesOf(i);
		for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) {
			const Triangle& corners = refinement.pieces[piece];
			if (part == ComplexOf::IrregularPoints && !isIrregular(corners)) {
				continue;
			}
			if (isOnCurve(corners)) {
				maybeCoincident_.push_back(static_cast<std::uint32_t>(out_.faces.size()));
			}
			out_.faces.push_back(
			    {corners, refinement.cutFaces[i].face, static_cast<std::uint32_t>(piece), kNone});
		}
	}
}

bool runAlike(const Triangle& a, const Triangle& b) {
	const auto first = std::find(b.begin(), b.end(), a[0]);
	return b[static_cast<std::size_t>(nextCorner(static_cast<int>(first - b.begin())))] == a[1];
}

// Makes faces on the same corners one face. Unless the operands may meet themselves, they are at
// most one of each.
Status Builder::merge(const FaceEntry* begin, const FaceEntry* end) {
	if (end - begin < 2) {
		return {};
	}
	RefinedFace& first = out_.faces[begin->face];
	const OperandId operand = mesh_.operandOf(first.source);
	std::vector<FaceId> ofOperand{first.source};
	first.others = static_cast<std::uint32_t>(out_.others.size());
	for (const FaceEntry* e = begin + 1; e != end; ++e) {
		const RefinedFace& other = out_.faces[e->face];
		if (mesh_.operandOf(other.source) == operand) {
			ofOperand.push_back(other.source);
		}
		out_.others.push_back(
		    {other.source, !runAlike(first.corners, other.corners), e + 1 == end});
		isMerged_[e->face] = 1;
	}
	const bool isFine = arrangement_.isSoup || (ofOperand.size() == 1 && end - begin == 2);
	return isFine ? Status{}
	              : selfIntersecting(arrangement_, operand, ofOperand,
	                                 arrangement_.coordinates(begin->low));
}

Status Builder::mergeCoincident() {
	std::vector<FaceEntry> entries;
	for (const std::uint32_t face : maybeCoincident_) {
		Triangle t = out_.faces[face].corners;
		std::sort(t.begin(), t.end());
		entries.push_back({t[0], t[1], t[2], face});
	}
	Status status = bucketSort(
	    entries, vertexCount_, [](const FaceEntry& e) { return e.low.value; },
	    std::less<FaceEntry>(), arrangement_.options.threads, monitor_);
	isMerged_.assign(out_.faces.size(), 0);
	bool anyMerged = false;
	const auto sameCorners = [](const FaceEntry& a, const FaceEntry& b) { return a.isOn(b); };
	const FaceEntry* const begin = entries.data();
	forEachGroup(begin, begin + entries.size(), sameCorners,
	             [&](const FaceEntry* first, const FaceEntry* last) {
		             status = status.ok() ? merge(first, last) : status;
		             anyMerged = anyMerged || last - first > 1;
	             });
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

// Whether the surface goes on across an edge that two triangles have: the same operands have both,
// and, of a closed operand in a soup, as often, the same way.
bool Builder::haveSameOwners(HalfEdgeId a, HalfEdgeId b) const {
	const RefinedFace &face = out_.faceOf(a), &next = out_.faceOf(b);
	if (face.others == kNone && next.others == kNone) {
		return mesh_.operandOf(face.source) == mesh_.operandOf(next.source);
	}
	if (!arrangement_.isSoup) {
		return face.others != kNone && next.others != kNone;
	}
	std::map<OperandId, int> difference;  // of the jumps; of open operands, of the numbers of faces
	const bool runAlike = out_.beginOf(a) == out_.beginOf(b);
	const auto count = [&](int sign) {
		return [&, sign](FaceId source, bool opposed) {
			const OperandId operand = mesh_.operandOf(source);
			const bool isSigned = arrangement_.closed[operand] &&
			                      arrangement_.options.windingRule != WindingRule::Odd;
			const bool isNegative = isSigned && (opposed != (sign < 0 && runAlike));
			difference[operand] += isNegative ? -sign : sign;
		};
	};
	out_.visitSources(face, count(1));
	out_.visitSources(next, count(-1));
	return std::all_of(difference.begin(), difference.end(),
	                   [](const auto& entry) { return entry.second == 0; });
}

// Takes the half-edges of one edge; one that parts goes to `parting`.
void Builder::join(const EdgeEntry* begin, const EdgeEntry* end, PartingEdges& parting) {
	const HalfEdgeId first = begin->item;
	if (end - begin == 2) {
		const HalfEdgeId second = (begin + 1)->item;
		if (haveSameOwners(first, second)) {
			at(out_.mates, first) = second;
			at(out_.mates, second) = first;
			return;
		}
	}
	const auto place = static_cast<std::uint32_t>(parting.halfEdges.size());
	parting.edges.push_back({VertexId{begin->low}, VertexId{begin->high}, place,
	                         static_cast<std::uint32_t>(end - begin)});
	for (; begin != end; ++begin) {
		parting.halfEdges.push_back(begin->item);
	}
}

void Builder::append(const PartingEdges& parting) {
	const auto before = static_cast<std::uint32_t>(out_.halfEdges.size());
	for (PartingEdge edge : parting.edges) {
		edge.first += before;
		out_.parting.push_back(edge);
	}
	out_.halfEdges.insert(out_.halfEdges.end(), parting.halfEdges.begin(), parting.halfEdges.end());
}

// Off the other operand, or where all its faces have twins there, a vertex is as the operand has
// it.
void Builder::findPlainVertices() {
	const std::vector<std::uint8_t>& onOther = arrangement_.curve.onOther;
	out_.plain.assign(mesh_.points.size(), std::uint8_t{0});
	for (std::uint32_t v = 0; v < out_.plain.size(); ++v) {
		out_.plain[v] = onOther[v] == 0 || mesh_.isQuiet({v}) ? 1 : 0;
	}
	for (const VertexId v : arrangement_.nonManifold) {
		at(out_.plain, v) = 0;
	}
}

Status Builder::listNearFaces() {
	const std::size_t n = out_.faces.size();
	std::vector<std::vector<std::uint32_t>> chunks(chunkCount(n, kGrain));
	const auto list = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			const Triangle& t = out_.faces[f].corners;
			if (!(out_.isPlain(t[0]) && out_.isPlain(t[1]) && out_.isPlain(t[2]))) {
				chunks[chunk].push_back(static_cast<std::uint32_t>(f));
			}
		}
	};
	const Status status =
	    parallelForChunks(n, kGrain, arrangement_.options.threads, monitor_, list);
	for (const std::vector<std::uint32_t>& chunk : chunks) {
		out_.nearFaces.insert(out_.nearFaces.end(), chunk.begin(), chunk.end());
	}
	return status;
}

// The edges of the near faces but for those between plain vertices.
std::vector<EdgeEntry> Builder::listEdges() const {
	std::vector<EdgeEntry> edges;
	edges.reserve(3 * out_.nearFaces.size());
	for (std::uint32_t n = 0; n < out_.nearFaces.size(); ++n) {
		const Triangle& t = out_.faces[out_.nearFaces[n]].corners;
		for (std::uint32_t i = 0; i < 3; ++i) {
			const VertexId from = t[i], to = t[i == 2 ? 0 : i + 1];
			if (!out_.isPlain(from) || !out_.isPlain(to)) {
				edges.push_back(makeEdgeItem(from.value, to.value, HalfEdgeId{3 * n + i}));
			}
		}
	}
	return edges;
}

Status Builder::joinFaces() {
	std::vector<EdgeEntry> entries = listEdges();
	pollCancelled(monitor_);
	const std::size_t count = entries.size();
	const int threads = arrangement_.options.threads;
	Status status = sortByEdge(entries, vertexCount_, threads, monitor_);
	if (!status.ok()) {
		return status;
	}
	out_.mates.assign(3 * out_.nearFaces.size(), HalfEdgeId::none());
	std::vector<PartingEdges> parts(chunkCount(count, kGrain));
	// A chunk takes the edges that begin in it.
	const auto firstEdgeFrom = [&](std::size_t i, std::size_t end) {
		while (i > 0 && i < end && entries[i].sameEdge(entries[i - 1])) {
			++i;
		}
		return i;
	};
	const auto joinChunk = [&](std::size_t chunk, std::size_t chunkBegin, std::size_t chunkEnd) {
		const std::size_t begin = firstEdgeFrom(chunkBegin, chunkEnd);
		const std::size_t end = begin < chunkEnd ? firstEdgeFrom(chunkEnd, count) : begin;
		forEachSortedEdge(entries.data() + begin, entries.data() + end,
		                  [&](const EdgeEntry* first, const EdgeEntry* last) {
			                  join(first, last, parts[chunk]);
		                  });
	};
	status = parallelForChunks(count, kGrain, threads, monitor_, joinChunk);
	for (const PartingEdges& part : parts) {
		append(part);
	}
	return status;
}

Status Builder::run(ComplexOf part) {
	const bool isWhole = part == ComplexOf::Everything;
	if (isWhole) {
		out_.faces.reserve(mesh_.triangles.size() + arrangement_.refinement.pieces.size());
	}
	return inOrder([&] { return isWhole ? addUncutFaces() : Status{}; },
	               [&] {
		               addPieces(part);
		               pollCancelled(monitor_);
		               return checkCounts(vertexCount_, 3 * out_.faces.size());
	               },
	               [&] { return mergeCoincident(); },
	               [&] {
		               if (isWhole) {
			               findPlainVertices();
		               }
		               pollCancelled(monitor_);
		               return listNearFaces();
	               },
	               [&] { return joinFaces(); });
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
