// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces of each group are a planar problem, as a cut face is. A group without a suspect vertex
// has nothing but regions of one face, each triangulated as a whole already.
#include "vcg_ext/solids/delaunay_pieces.h"

#include "vcg_ext/arrange/planar_patch.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"
#include "vcg_ext/solids/face_groups.h"

#include <algorithm>
#include <numeric>

namespace index_boolean {

namespace {

// An edge that may be flipped, between two faces of a group.
struct GroupEdge {
	std::uint32_t group;
	std::array<std::uint32_t, 2> faces;  // of the block
};

// Flips within one group after another, with buffers that are used again. One for each thread.
class GroupFlipper {
public:
	GroupFlipper(const Arrangement& arrangement, Monitor& monitor, Block& block)
	    : monitor_(monitor), block_(block), patch_(arrangement) {}

	// \param first, last the free edges of the group. Its faces without one are left out
	void run(const GroupEdge* first, const GroupEdge* last);

private:
	Monitor& monitor_;
	Block& block_;
	PlanarPatch patch_;
	std::vector<std::uint32_t> faces_;  // of the block, ascending
	std::vector<IndexTriangle> triangles_;
	std::vector<PlanarPatch::FreePair> edges_;
};

void GroupFlipper::run(const GroupEdge* first, const GroupEdge* last) {
	faces_.clear();
	triangles_.clear();
	edges_.clear();
	for (const GroupEdge* e = first; e != last; ++e) {
		faces_.insert(faces_.end(), e->faces.begin(), e->faces.end());
	}
	sortUnique(faces_);
	for (const std::uint32_t f : faces_) {
		triangles_.push_back(block_.triangles[f]);
	}
	for (const GroupEdge* e = first; e != last; ++e) {
		edges_.push_back({placeIn(faces_, e->faces[0]), placeIn(faces_, e->faces[1])});
	}
	const FaceSource& source = block_.faceSource[faces_.front()];
	patch_.flip(source.face, source.turned, block_.vertexSource.data(), edges_, monitor_,
	            triangles_);
	for (std::size_t i = 0; i < faces_.size(); ++i) {
		block_.triangles[faces_[i]] = triangles_[i];
	}
}

// The faces that may have to be flipped: pieces, or all, of groups that have a suspect vertex.
std::vector<std::uint32_t> facesOfSuspectGroups(const Arrangement& arrangement,
                                                const Block& block) {
	std::vector<std::uint32_t> faces(block.triangles.size() - block.firstPiece);
	std::iota(faces.begin(), faces.end(), static_cast<std::uint32_t>(block.firstPiece));
	const auto keepsCuts = [&block](std::uint32_t face) { return block.keepsCutsOf(face); };
	faces.erase(std::remove_if(faces.begin(), faces.end(), keepsCuts), faces.end());
	if (arrangement.options.mergeCoplanar) {
		return faces;
	}
	const std::vector<std::uint32_t> groups = groupsOf(arrangement, block, faces);
	std::vector<std::uint8_t> isSuspect(2 * arrangement.mesh.triangles.size());
	for (std::size_t i = 0; i < faces.size(); ++i) {
		for (const std::uint32_t v : block.triangles[faces[i]]) {
			isSuspect[groups[i]] |= block.suspect[v];
		}
	}
	std::size_t kept = 0;
	for (std::size_t i = 0; i < faces.size(); ++i) {
		if (isSuspect[groups[i]] != 0) {
			faces[kept++] = faces[i];
		}
	}
	faces.resize(kept);
	return faces;
}

// The half-edges of faces by the places of their ends; `face` counts in the list. A vertex in the
// middle of an edge along which the block met itself has no name: its edges are left out.
Status halfEdgesByPlace(const Arrangement& arrangement, const Block& block,
                        const std::vector<std::uint32_t>& faces, Monitor& monitor,
                        std::vector<HalfEdge>& halfEdges) {
	halfEdges.reserve(3 * faces.size());
	for (std::size_t f = 0; f < faces.size(); ++f) {
		for (std::size_t i = 0; i < 3; ++i) {
			const IndexTriangle& t = block.triangles[faces[f]];
			const VertexId from = block.vertexSource[t[i]];
			const VertexId to = block.vertexSource[t[(i + 1) % 3]];
			if (from != VertexId::none() && to != VertexId::none()) {
				halfEdges.push_back(makeHalfEdge(from.value, to.value, f, i));
			}
		}
	}
	const std::size_t vertexCount = arrangement.mesh.points.size() + arrangement.curve.pointCount();
	return sortByEdge(halfEdges, vertexCount, arrangement.options.threads, monitor);
}

// Whether two half-edges at one place are one edge by index too.
bool areJoined(const Block& block, const std::vector<std::uint32_t>& faces, const HalfEdge& h,
               const HalfEdge& g) {
	const IndexTriangle &s = block.triangles[faces[h.face]], &t = block.triangles[faces[g.face]];
	return s[h.corner] == t[(g.corner + 1) % 3] && t[g.corner] == s[(h.corner + 1) % 3];
}

// By group.
std::vector<GroupEdge> freeEdges(const Arrangement& arrangement, const Block& block,
                                 const std::vector<std::uint32_t>& faces,
                                 const std::vector<HalfEdge>& halfEdges) {
	const std::vector<std::uint32_t> groups = groupsOf(arrangement, block, faces);
	std::vector<GroupEdge> edges;
	forEachSortedManifoldEdge(halfEdges, [&](const HalfEdge& h, const HalfEdge& g) {
		if (groups[h.face] == groups[g.face] && areJoined(block, faces, h, g)) {
			edges.push_back({groups[h.face], {faces[h.face], faces[g.face]}});
		}
	});
	std::sort(edges.begin(), edges.end(), [](const GroupEdge& a, const GroupEdge& b) {
		return a.group != b.group ? a.group < b.group : a.faces < b.faces;
	});
	return edges;
}

Status flipGroups(const Arrangement& arrangement, const std::vector<GroupEdge>& edges,
                  Monitor& monitor, Block& block) {
	constexpr std::size_t kGrain = 64;
	using Range = std::pair<const GroupEdge*, const GroupEdge*>;
	std::vector<Range> ranges;
	forEachGroup(
	    edges.data(), edges.data() + edges.size(),
	    [](const GroupEdge& a, const GroupEdge& b) { return a.group == b.group; },
	    [&ranges](const GroupEdge* first, const GroupEdge* last) {
		    ranges.emplace_back(first, last);
	    });
	return parallelFor(ranges.size(), kGrain, arrangement.options.threads, monitor,
	                   [&](std::size_t begin, std::size_t end) {
		                   GroupFlipper flipper(arrangement, monitor, block);
		                   for (std::size_t i = begin; i < end; ++i) {
			                   flipper.run(ranges[i].first, ranges[i].second);
		                   }
	                   });
}

}  // namespace

Status makePiecesDelaunay(const Arrangement& arrangement, Monitor& monitor, Block& block) {
	const Options& options = arrangement.options;
	if (!options.mergeCoplanar && (!options.mergeFragments || !block.anySuspect())) {
		return {};
	}
	const std::vector<std::uint32_t> faces = facesOfSuspectGroups(arrangement, block);
	std::vector<HalfEdge> halfEdges;
	return inOrder([&] { return halfEdgesByPlace(arrangement, block, faces, monitor, halfEdges); },
	               [&] {
		               const auto edges = freeEdges(arrangement, block, faces, halfEdges);
		               return flipGroups(arrangement, edges, monitor, block);
	               });
}

}  // namespace index_boolean
