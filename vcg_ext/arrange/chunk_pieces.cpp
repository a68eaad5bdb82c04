// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers within a chunk become numbers of the whole by adding where the chunk begins.
#include "vcg_ext/arrange/chunk_pieces.h"

#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/element_counts.h"

#include <array>

namespace index_boolean {

namespace {

// Where the parts of a chunk begin in the whole.
struct ChunkBegin {
	std::size_t cutFaces = 0, pieces = 0, sides = 0, links = 0, cornerLinks = 0;
	std::size_t node = 0;  // of its first region

	ChunkBegin next(const ChunkPieces& chunk) const {
		return {cutFaces + chunk.cutFaces.size(),
		        pieces + chunk.pieces.size(),
		        sides + chunk.sides.size(),
		        links + chunk.links.size(),
		        cornerLinks + chunk.cornerLinks.size(),
		        node + chunk.regionCount};
	}
};

// Where each chunk begins; last, where all end.
std::vector<ChunkBegin> beginsOf(const std::vector<ChunkPieces>& chunks,
                                 const Arrangement& arrangement) {
	std::vector<ChunkBegin> begins(1);
	begins.front().node = arrangement.mesh.points.size() + arrangement.curve.intervalCount();
	for (const ChunkPieces& chunk : chunks) {
		begins.push_back(begins.back().next(chunk));
	}
	return begins;
}

// Labelling gives each operand's corners nodes of their own behind all others, which a soup does
// without; a block has faces of all operands and pieces.
Status checkSizes(const ChunkBegin& all, const Arrangement& arrangement) {
	const MeshArrays& mesh = arrangement.mesh;
	const std::size_t labelled = arrangement.isSoup ? 0 : mesh.operands().count();
	const std::size_t nodes = all.node + labelled * mesh.points.size();
	const std::size_t corners = 3 * (mesh.triangles.size() + all.pieces);
	const std::size_t most = arrangement.options.mostElements;
	return inOrder([&] { return checkNumbering(nodes, most); },
	               [&] { return checkNumbering(corners, most); });
}

void makeRoom(const ChunkBegin& all, std::size_t faceCount, Refinement& out) {
	out.nodeCount = static_cast<std::uint32_t>(all.node);
	out.isCut.assign(faceCount, 0);
	out.cutFaces.resizeForOverwrite(all.cutFaces);
	out.pieces.resizeForOverwrite(all.pieces);
	out.pieceRegion.resizeForOverwrite(all.pieces);
	out.sides.resizeForOverwrite(all.sides);
	out.links.resizeForOverwrite(all.links);
	out.cornerLinks.resizeForOverwrite(all.cornerLinks);
}

// Writes one chunk to its place.
void place(const ChunkPieces& chunk, const ChunkBegin& begin, Refinement& out) {
	const auto node = [&begin](std::uint32_t region) {
		return region == kNone ? NodeId::none() : makeId<NodeTag>(begin.node + region);
	};
	const auto transform = [](const auto& from, auto& to, std::size_t first, auto&& change) {
		for (std::size_t i = 0; i < from.size(); ++i) {
			to[first + i] = change(from[i]);
		}
	};
	transform(chunk.cutFaces, out.cutFaces, begin.cutFaces, [&](const CutFace& f) {
		at(out.isCut, f.face) = 1;
		return CutFace{f.face, f.firstPiece + static_cast<std::uint32_t>(begin.pieces)};
	});
	transform(chunk.pieces, out.pieces, begin.pieces, [](const Triangle& t) { return t; });
	transform(chunk.pieceRegion, out.pieceRegion, begin.pieces, node);
	transform(chunk.sides, out.sides, begin.sides, [&](const ChunkPieces::Sides& s) {
		return SegmentSide{s.segment, s.face, node(s.left), node(s.right)};
	});
	const auto link = [&](const ChunkPieces::Link& l) {
		return std::array<NodeId, 2>{node(l.region), l.other};
	};
	transform(chunk.links, out.links, begin.links, link);
	transform(chunk.cornerLinks, out.cornerLinks, begin.cornerLinks, link);
}

}  // namespace

// What lies to both sides of the segments and behind the border's intervals.
void ChunkPieces::appendSides(FaceId face, const FaceEdges& edges, const FacePieces& facePieces) {
	const auto beside = [&](const FaceEdge& edge, bool left) {
		const std::uint32_t region = facePieces.regionBeside(edge, left);
		return region != kNone ? regionCount + region : kNone;
	};
	for (const FaceEdge& edge : edges.fixed()) {
		if (edge.segment != SegmentId::none()) {
			sides.push_back(
			    {edge.segment, face, beside(edge, edge.isRising), beside(edge, !edge.isRising)});
		} else if (edge.interval != NodeId::none()) {
			links.push_back({beside(edge, edge.pieces[1] != kNone), edge.interval});
		}
	}
}

// Links a region to a corner of its face.
void ChunkPieces::linkCorner(const Arrangement& arrangement, std::uint32_t region,
                             VertexId corner) {
	auto& list = arrangement.isOnOther(corner) ? cornerLinks : links;
	list.push_back({region, {corner.value}});
}

void ChunkPieces::appendWhole(const Arrangement& arrangement, const FaceLines& lines) {
	const Triangle& t = at(arrangement.mesh.triangles, lines.face);
	const std::uint32_t region = regionCount++;
	cutFaces.push_back({lines.face, static_cast<std::uint32_t>(pieces.size())});
	pieces.push_back(t);
	pieceRegion.push_back(region);
	for (const FaceSide& side : lines.sides) {
		if (const NodeId node = intervalNode(arrangement, side, 0); node != NodeId::none()) {
			links.push_back({region, node});
		}
		linkCorner(arrangement, region, side.points[0]);
	}
}

void ChunkPieces::append(const Arrangement& arrangement, FaceId face, const FacePoints& points,
                         const FaceEdges& edges, const FacePieces& facePieces) {
	appendSides(face, edges, facePieces);
	cutFaces.push_back({face, static_cast<std::uint32_t>(pieces.size())});
	for (std::size_t piece = 0; piece < facePieces.triangles.size(); ++piece) {
		const std::uint32_t region = regionCount + facePieces.regionOf(piece);
		Triangle t{};
		for (std::size_t i = 0; i < 3; ++i) {
			const FacePoint& p = points.at(facePieces.triangles[piece][i]);
			t[i] = p.id;
			if (p.isCorner()) {
				linkCorner(arrangement, region, p.id);
			}
		}
		pieces.push_back(t);
		pieceRegion.push_back(region);
	}
	regionCount += facePieces.regionCount();
}

Status concatenate(const std::vector<ChunkPieces>& chunks, Arrangement& arrangement,
                   Monitor& monitor) {
	const std::vector<ChunkBegin> begins = beginsOf(chunks, arrangement);
	const int threads = arrangement.options.threads;
	Refinement& out = arrangement.refinement;
	const auto placeAll = [&] {
		makeRoom(begins.back(), arrangement.mesh.triangles.size(), out);
		return parallelFor(chunks.size(), 8, threads, monitor,
		                   [&](std::size_t begin, std::size_t end) {
			                   for (std::size_t i = begin; i < end; ++i) {
				                   place(chunks[i], begins[i], out);
			                   }
		                   });
	};
	const auto sortSides = [&] {
		return bucketSort(
		    out.sides, arrangement.curve.segments.size(),
		    [](const SegmentSide& s) { return s.segment.value; },
		    [](const SegmentSide& a, const SegmentSide& b) {
			    return a.segment != b.segment ? a.segment < b.segment : a.face < b.face;
		    },
		    threads, monitor);
	};
	return inOrder([&] { return checkSizes(begins.back(), arrangement); }, placeAll, sortSides);
}

}  // namespace index_boolean
