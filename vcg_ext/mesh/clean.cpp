// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why it stays closed: (1) vertices at the ends of one edge that coincide are united; uniting maps
// a closed chain of faces to a closed one, and a face with two equal corners has no boundary.
// (2) What is left of the zero-area faces forms clusters, joined by shared edges, each on one line.
// With one vertex per position, and every edge of the cluster split at every vertex on it, the
// cluster's boundary is a 1-cycle on a line, hence zero: dropping the cluster opens nothing.
// (3) Two opposite faces on the same corners have no boundary together and bound nothing.
#include "vcg_ext/mesh/clean.h"

#include "vcg_ext/base/groups.h"
#include "vcg_ext/base/index_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/face_key.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 16384;     // faces that a thread takes at a time
constexpr std::size_t kPollFaces = 4096;  // faces treated between two looks at the monitor
constexpr std::size_t kMaxFaces = std::numeric_limits<std::int32_t>::max();
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::uint32_t index32(std::size_t i) { return static_cast<std::uint32_t>(i); }

// A class of the numbers below n, named by one of its members: its label.
class Partition {
public:
	explicit Partition(std::size_t n) : label_(n), next_(n), size_(n, 1) {
		std::iota(label_.begin(), label_.end(), 0U);
		std::iota(next_.begin(), next_.end(), 0U);
	}

	std::uint32_t label(std::uint32_t x) const { return label_[x]; }

	// Unites two classes and calls moved(x) for every member whose label changes. It is the smaller
	// class that changes, so no member does more than log2(n) times in all.
	template <class Moved>
	void unite(std::uint32_t x, std::uint32_t y, const Moved& moved) {
		std::uint32_t large = label_[x], small = label_[y];
		if (large == small) {
			return;
		}
		if (size_[large] < size_[small]) {
			std::swap(large, small);
		}
		std::uint32_t member = small;
		do {
			label_[member] = large;
			moved(member);
			member = next_[member];
		} while (member != small);
		size_[large] += size_[small];
		std::swap(next_[large], next_[small]);  // splices the two rings
	}

private:
	std::vector<std::uint32_t> label_, next_, size_;
};

// A face at a corner of a zero-area face, by local vertex numbers; later also the pieces of those
// that are split.
struct NearFace {
	IndexTriangle corners;
	std::uint32_t origin;  // the face that it is or is a piece of
	bool zeroArea;
	bool alive;
};

// All that cleaning can touch, numbered on its own. Vertices are compared by the label of their
// class: vertices of one class are one vertex.
struct Neighbourhood {
	explicit Neighbourhood(std::vector<std::uint32_t> vertices)
	    : vertex(std::move(vertices)), rank(vertex.size(), kNone), classes(vertex.size()) {}

	std::vector<NearFace> faces;        // by origin, ascending; then the pieces
	std::size_t originalFaces = 0;      // of the faces, those that are no pieces
	std::vector<std::uint32_t> vertex;  // a local vertex's index in the surface, ascending
	std::vector<std::uint32_t> rank;    // order of the corners of zero-area faces by coordinates,
	                                    // equal ranks for equal places; kNone for all others
	Partition classes;

	IndexTriangle labels(const NearFace& face) const {
		const IndexTriangle& c = face.corners;
		return {classes.label(c[0]), classes.label(c[1]), classes.label(c[2])};
	}
};

// The surface to be cleaned, and how to go through it.
struct Surface {
	const Points& points;
	IndexTriangles& triangles;
	int threads;
	Monitor& monitor;
};

// The faces that have a corner for which wanted(corner) is true, ascending.
template <class Wanted>
Status facesAt(const Surface& surface, const Wanted& wanted, std::vector<std::uint32_t>& out) {
	const IndexTriangles& triangles = surface.triangles;
	std::vector<std::vector<std::uint32_t>> found(chunkCount(triangles.size(), kGrain));
	const Status status =
	    parallelForChunks(triangles.size(), kGrain, surface.threads, surface.monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t i = begin; i < end; ++i) {
			                      const IndexTriangle& t = triangles[i];
			                      if (wanted(t[0]) || wanted(t[1]) || wanted(t[2])) {
				                      found[chunk].push_back(index32(i));
			                      }
		                      }
	                      });
	for (const std::vector<std::uint32_t>& faces : found) {
		out.insert(out.end(), faces.begin(), faces.end());
	}
	return status;
}

void sortUnique(std::vector<std::uint32_t>& values) {
	std::sort(values.begin(), values.end());
	values.erase(std::unique(values.begin(), values.end()), values.end());
}

Neighbourhood numberLocally(const IndexTriangles& triangles, const std::vector<std::uint32_t>& near,
                            const std::vector<std::uint32_t>& zeroAreaFaces) {
	std::vector<std::uint32_t> vertices;
	vertices.reserve(3 * near.size());
	for (const std::uint32_t face : near) {
		vertices.insert(vertices.end(), triangles[face].begin(), triangles[face].end());
	}
	sortUnique(vertices);
	Neighbourhood local(std::move(vertices));
	local.originalFaces = near.size();
	local.faces.reserve(near.size());
	for (const std::uint32_t face : near) {
		IndexTriangle corners = triangles[face];
		for (std::uint32_t& corner : corners) {
			const auto place = std::lower_bound(local.vertex.begin(), local.vertex.end(), corner);
			corner = index32(static_cast<std::size_t>(place - local.vertex.begin()));
		}
		const bool zeroArea = std::binary_search(zeroAreaFaces.begin(), zeroAreaFaces.end(), face);
		local.faces.push_back({corners, face, zeroArea, true});
	}
	return local;
}

// Ranks the corners of zero-area faces lexicographically. Along a line this is the order of its
// points, and points of equal rank coincide (0 and -0 are equal): from here on only indices.
void rankCorners(const Points& points, Neighbourhood& local) {
	std::vector<std::uint32_t> corners;
	for (const NearFace& face : local.faces) {
		if (face.zeroArea) {
			corners.insert(corners.end(), face.corners.begin(), face.corners.end());
		}
	}
	sortUnique(corners);
	const auto pointOf = [&](std::uint32_t v) -> const Point& { return points[local.vertex[v]]; };
	std::sort(corners.begin(), corners.end(),
	          [&](std::uint32_t a, std::uint32_t b) { return pointOf(a) < pointOf(b); });
	std::uint32_t rank = 0;
	for (std::size_t i = 0; i < corners.size(); ++i) {
		if (i > 0 && pointOf(corners[i - 1]) < pointOf(corners[i])) {
			++rank;
		}
		local.rank[corners[i]] = rank;
	}
}

// Unites vertices at one place that an edge joins (its faces have zero area, so they are all here).
// Faces that lose a corner vanish.
void uniteJoined(Neighbourhood& local) {
	for (const NearFace& face : local.faces) {
		for (int i = 0; face.zeroArea && i < 3; ++i) {
			const std::uint32_t from = face.corners[static_cast<std::size_t>(i)];
			const std::uint32_t to = face.corners[static_cast<std::size_t>(nextCorner(i))];
			if (local.rank[from] == local.rank[to]) {
				local.classes.unite(from, to, [](std::uint32_t) {});
			}
		}
	}
	for (NearFace& face : local.faces) {
		const IndexTriangle c = local.labels(face);
		if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) {
			face.alive = false;
		}
	}
}

using LabelledFace = KeyedFace<std::uint32_t>;  // by the labels of its corners

// Cancels opposite faces one against one; equal ones that are left over stay. Those of lower
// number stay, which matters to their origin only.
// \return how many faces with area went
std::size_t cancelOpposite(Neighbourhood& local) {
	std::vector<LabelledFace> faces;
	faces.reserve(local.faces.size());
	for (std::size_t i = 0; i < local.faces.size(); ++i) {
		if (local.faces[i].alive) {
			faces.push_back({faceKeyOf(local.labels(local.faces[i])), index32(i)});
		}
	}
	std::sort(faces.begin(), faces.end(), [](const LabelledFace& a, const LabelledFace& b) {
		return a.key != b.key ? a.key < b.key : a.face > b.face;
	});
	std::size_t removed = 0;
	const auto isSame = [](const LabelledFace& a, const LabelledFace& b) { return a.key == b.key; };
	forEachGroup(faces.begin(), faces.end(), isSame, [&](auto first, auto last) {
		const auto ascending =
		    std::count_if(first, last, [](const LabelledFace& f) { return f.key.ascending; });
		std::array<std::ptrdiff_t, 2> left{};
		left.fill(std::min(ascending, last - first - ascending));
		for (; first != last; ++first) {
			NearFace& face = local.faces[first->face];
			if (left[first->key.ascending] > 0) {
				--left[first->key.ascending];
				face.alive = false;
				removed += face.zeroArea ? 0 : 1;
			}
		}
	});
	return removed;
}

// The zero-area faces with three different corners, in clusters: the finest partition in which
// faces that share an edge are in one cluster, and vertices of one cluster at one place are united.
// Uniting two vertices can make two edges one, which can unite two clusters, which can bring two
// vertices of one place together: a face whose cluster or corners get another label is looked at
// again, until nothing changes. The partition is the same whatever the order.
class Clusters {
public:
	explicit Clusters(Neighbourhood& local);

	// Unites clusters and vertices. Cancel is polled; the result is then of no use.
	void grow(Monitor& monitor);

	// The vertices strictly inside the edge from u to v, in this order, if a cluster has that edge.
	void inside(std::uint32_t u, std::uint32_t v, std::vector<std::uint32_t>& out) const;

private:
	// A vertex of a cluster, and its place in the order along the line.
	struct Site {
		std::uint32_t cluster, rank, vertex;

		friend bool operator<(const Site& a, const Site& b) {
			return a.cluster != b.cluster ? a.cluster < b.cluster : a.rank < b.rank;
		}
	};

	void look(std::uint32_t face);
	void uniteVertices(std::uint32_t u, std::uint32_t v);
	void listSites();

	Neighbourhood& local_;
	IndexTriangles faces_;                        // alive zero-area faces, by local vertices
	Partition clusters_;                          // of faces_
	std::vector<std::uint32_t> begin_, facesAt_;  // the faces at a local vertex
	std::vector<std::uint32_t> again_;            // faces to be looked at
	PairTable faceOfEdge_;    // by vertex labels, the lower first; keys with labels gone out of use
	                          // do no harm
	PairTable vertexOfSite_;  // by cluster label and rank
	std::vector<Site> sites_;
};

IndexTriangles aliveZeroAreaFaces(const Neighbourhood& local) {
	IndexTriangles faces;
	for (const NearFace& face : local.faces) {
		if (face.alive && face.zeroArea) {
			faces.push_back(face.corners);
		}
	}
	return faces;
}

Clusters::Clusters(Neighbourhood& local)
    : local_(local), faces_(aliveZeroAreaFaces(local)), clusters_(faces_.size()),
      begin_(local.vertex.size() + 1, 0), facesAt_(3 * faces_.size()), again_(faces_.size()) {
	for (const IndexTriangle& face : faces_) {
		for (const std::uint32_t corner : face) {
			++begin_[corner];
		}
	}
	std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
	for (std::size_t i = 0; i < faces_.size(); ++i) {
		for (const std::uint32_t corner : faces_[i]) {
			facesAt_[--begin_[corner]] = index32(i);
		}
	}
	std::iota(again_.begin(), again_.end(), 0U);
}

void Clusters::uniteVertices(std::uint32_t u, std::uint32_t v) {
	local_.classes.unite(u, v, [this](std::uint32_t moved) {
		again_.insert(again_.end(), facesAt_.begin() + begin_[moved],
		              facesAt_.begin() + begin_[moved + 1]);
	});
}

void Clusters::look(std::uint32_t face) {
	const IndexTriangle& corners = faces_[face];
	for (int i = 0; i < 3; ++i) {
		const std::uint32_t from = corners[static_cast<std::size_t>(i)];
		const std::uint32_t to = corners[static_cast<std::size_t>(nextCorner(i))];
		const auto edge = std::minmax({local_.classes.label(from), local_.classes.label(to)});
		clusters_.unite(face, faceOfEdge_.findOrAdd(edge.first, edge.second, face),
		                [this](std::uint32_t moved) { again_.push_back(moved); });
	}
	for (const std::uint32_t corner : corners) {
		uniteVertices(corner,
		              vertexOfSite_.findOrAdd(clusters_.label(face), local_.rank[corner], corner));
	}
}

void Clusters::grow(Monitor& monitor) {
	for (std::size_t looks = 1; !again_.empty(); ++looks) {
		if (looks % kPollFaces == 0 && pollCancelled(monitor)) {
			return;
		}
		const std::uint32_t face = again_.back();
		again_.pop_back();
		look(face);
	}
	listSites();
}

void Clusters::listSites() {
	for (std::size_t i = 0; i < faces_.size(); ++i) {
		for (const std::uint32_t corner : faces_[i]) {
			sites_.push_back({clusters_.label(index32(i)), local_.rank[corner], corner});
		}
	}
	// All vertices at a site are united, so any of them may stand for it.
	const auto same = [](const Site& a, const Site& b) { return !(a < b) && !(b < a); };
	std::sort(sites_.begin(), sites_.end());
	sites_.erase(std::unique(sites_.begin(), sites_.end(), same), sites_.end());
}

void Clusters::inside(std::uint32_t u, std::uint32_t v, std::vector<std::uint32_t>& out) const {
	out.clear();
	const std::uint32_t from = local_.rank[u], to = local_.rank[v];
	if (from == kNone || to == kNone) {
		return;
	}
	const auto edge = std::minmax({local_.classes.label(u), local_.classes.label(v)});
	const std::uint32_t face = faceOfEdge_.find(edge.first, edge.second);
	if (face == IndexTable::kNone) {
		return;
	}
	const std::uint32_t cluster = clusters_.label(face);
	const Site low{cluster, std::min(from, to), 0}, high{cluster, std::max(from, to), 0};
	const auto begin = std::upper_bound(sites_.begin(), sites_.end(), low);
	const auto end = std::lower_bound(begin, sites_.end(), high);
	std::transform(begin, end, std::back_inserter(out), [](const Site& s) { return s.vertex; });
	if (to < from) {
		std::reverse(out.begin(), out.end());
	}
}

// Splits the faces with area beside clusters. The points lie inside the face's edges, exactly. From
// a corner x, the first and the last point of the opposite edge cut the face into at most three
// triangles with area, of which each has points on one edge only: a fan from the corner opposite
// that edge gives triangles with area. So no piece has zero area, nor two corners at one place.
class Splitter {
public:
	Splitter(const Points& points, const Clusters& clusters, Neighbourhood& local)
	    : points_(points), clusters_(clusters), local_(local) {}

	// \return whether the face is beside a cluster that has vertices inside the face's edges; then
	// its pieces have been added
	bool split(std::size_t face);

private:
	std::size_t apex(const IndexTriangle& corners) const;
	void fan(std::uint32_t from, std::uint32_t first, const std::vector<std::uint32_t>& middle,
	         std::uint32_t last);

	const Points& points_;
	const Clusters& clusters_;
	Neighbourhood& local_;
	std::uint32_t origin_ = 0;
	std::array<std::vector<std::uint32_t>, 3> inside_;  // of the edge opposite each corner
};

// Of the corners that face a split edge, the lexicographically smallest: no matter of numbering.
std::size_t Splitter::apex(const IndexTriangle& corners) const {
	std::size_t best = 3;
	for (std::size_t i = 0; i < 3; ++i) {
		const auto pointOf = [&](std::size_t k) { return points_[local_.vertex[corners[k]]]; };
		if (!inside_[i].empty() && (best == 3 || pointOf(i) < pointOf(best))) {
			best = i;
		}
	}
	return best;
}

void Splitter::fan(std::uint32_t from, std::uint32_t first,
                   const std::vector<std::uint32_t>& middle, std::uint32_t last) {
	for (const std::uint32_t next : middle) {
		local_.faces.push_back({{from, first, next}, origin_, false, true});
		first = next;
	}
	local_.faces.push_back({{from, first, last}, origin_, false, true});
}

bool Splitter::split(std::size_t face) {
	const IndexTriangle corners = local_.faces[face].corners;
	for (std::size_t i = 0; i < 3; ++i) {
		clusters_.inside(corners[(i + 1) % 3], corners[(i + 2) % 3], inside_[i]);
	}
	const std::size_t top = apex(corners);
	if (top == 3) {
		return false;
	}
	const std::size_t left = (top + 1) % 3, right = (top + 2) % 3;
	const std::uint32_t x = corners[top], y = corners[left], z = corners[right];
	origin_ = local_.faces[face].origin;
	const std::vector<std::uint32_t>& base = inside_[top];
	const std::uint32_t first = base.front(), last = base.back();
	fan(first, x, inside_[right], y);
	fan(last, z, inside_[left], x);
	if (base.size() > 1) {
		const std::vector<std::uint32_t> between(base.begin() + 1, base.end() - 1);
		fan(x, first, between, last);
	}
	local_.faces[face].alive = false;
	return true;
}

// Splits every face beside a cluster and drops the clusters.
Status replaceClusters(const Surface& surface, Neighbourhood& local, CleanResult& result) {
	Clusters clusters(local);
	clusters.grow(surface.monitor);
	Splitter splitter(surface.points, clusters, local);
	for (std::size_t i = 0; i < local.originalFaces; ++i) {
		if (i % kPollFaces == 0 && pollCancelled(surface.monitor)) {
			return statusOf(StatusCode::Cancelled);
		}
		if (!local.faces[i].alive) {
			continue;
		}
		if (local.faces[i].zeroArea) {
			local.faces[i].alive = false;
		} else {
			result.facesSplit += splitter.split(i) ? 1 : 0;
		}
		if (surface.triangles.size() + local.faces.size() > kMaxFaces + local.originalFaces) {
			return statusOf(StatusCode::TooLarge);
		}
	}
	return Status();
}

// The vertex that stands for each local vertex: the smallest of its class.
std::vector<std::uint32_t> representatives(const Neighbourhood& local) {
	std::vector<std::uint32_t> smallest(local.vertex.size(), kNone);
	for (std::size_t v = 0; v < local.vertex.size(); ++v) {
		std::uint32_t& best = smallest[local.classes.label(index32(v))];
		best = std::min(best, local.vertex[v]);
	}
	std::vector<std::uint32_t> result(local.vertex.size());
	for (std::size_t v = 0; v < local.vertex.size(); ++v) {
		result[v] = smallest[local.classes.label(index32(v))];
	}
	return result;
}

// The vertices of the neighbourhood that none of its faces refers to any more, as flags of all.
std::vector<std::uint8_t> lostHere(const Surface& surface, const Neighbourhood& local,
                                   const std::vector<std::uint32_t>& representative) {
	std::vector<std::uint8_t> lost(surface.points.size(), 0);
	for (const std::uint32_t vertex : local.vertex) {
		lost[vertex] = 1;
	}
	for (const NearFace& face : local.faces) {
		for (std::size_t i = 0; face.alive && i < 3; ++i) {
			lost[representative[face.corners[i]]] = 0;
		}
	}
	return lost;
}

// Lists the vertices that no face refers to any more. All faces of a ranked vertex are in the
// neighbourhood; faces of another are looked for in the rest of the surface, if one is lost here.
Status listUnreferenced(const Surface& surface, const Neighbourhood& local,
                        const std::vector<std::uint32_t>& representative,
                        std::vector<std::uint32_t>& out) {
	std::vector<std::uint8_t> lost = lostHere(surface, local, representative);
	bool inDoubt = false;
	for (std::size_t v = 0; v < local.vertex.size(); ++v) {
		inDoubt = inDoubt || (local.rank[v] == kNone && lost[local.vertex[v]] != 0);
	}
	std::vector<std::uint32_t> faces;
	Status status;
	if (inDoubt) {
		status = facesAt(
		    surface, [&lost](std::uint32_t v) { return lost[v] != 0; }, faces);
	}
	std::size_t next = 0;  // of the original faces here, which ascend as `faces` do
	for (const std::uint32_t face : faces) {
		while (next < local.originalFaces && local.faces[next].origin < face) {
			++next;
		}
		if (next < local.originalFaces && local.faces[next].origin == face) {
			continue;
		}
		for (const std::uint32_t corner : surface.triangles[face]) {
			lost[corner] = 0;
		}
	}
	std::copy_if(local.vertex.begin(), local.vertex.end(), std::back_inserter(out),
	             [&lost](std::uint32_t vertex) { return lost[vertex] != 0; });
	return status;
}

// Removes the elements at the holes [begin, end), ascending, of an array of `count` elements: the
// last elements fill the gaps. Appends the moves. \return the new count
std::size_t closeHoles(const std::uint32_t* begin, const std::uint32_t* end, std::size_t count,
                       std::vector<Relocation::Move>& moves) {
	while (begin != end) {
		--count;
		if (*(end - 1) == count) {
			--end;
		} else {
			moves.push_back({index32(count), *begin++});
		}
	}
	return count;
}

// Writes the faces back: those that stay keep their places; pieces take the places of faces that
// went, then new ones at the end; or else the last faces fill the places left.
void writeBack(const Neighbourhood& local, const std::vector<std::uint32_t>& representative,
               IndexTriangles& triangles, Relocation& relocation) {
	std::vector<std::uint32_t> holes;
	std::vector<std::size_t> pieces;
	for (std::size_t i = 0; i < local.faces.size(); ++i) {
		if (i >= local.originalFaces && local.faces[i].alive) {
			pieces.push_back(i);
		}
		if (i < local.originalFaces && !local.faces[i].alive) {
			holes.push_back(local.faces[i].origin);
		}
	}
	const std::size_t filled = std::min(holes.size(), pieces.size());
	const std::size_t added = pieces.size() - filled;
	std::vector<Relocation::Move>& moves = relocation.moves;
	moves.reserve(std::max(holes.size(), pieces.size()));
	for (std::size_t i = 0; i < pieces.size(); ++i) {
		const std::size_t to = i < filled ? holes[i] : triangles.size() + (i - filled);
		moves.push_back({local.faces[pieces[i]].origin, index32(to)});
	}
	relocation.count = closeHoles(holes.data() + filled, holes.data() + holes.size(),
	                              triangles.size() + added, moves);
	// The last allocation: nothing can fail from here.
	triangles.resizeForOverwrite(triangles.size() + added);
	const auto write = [&](std::size_t to, const NearFace& face) {
		const IndexTriangle& c = face.corners;
		triangles[to] = {representative[c[0]], representative[c[1]], representative[c[2]]};
	};
	for (std::size_t i = 0; i < local.originalFaces; ++i) {
		write(local.faces[i].origin, local.faces[i]);
	}
	for (std::size_t i = 0; i < pieces.size(); ++i) {
		write(moves[i].to, local.faces[pieces[i]]);
	}
	for (std::size_t i = pieces.size(); i < moves.size(); ++i) {
		triangles[moves[i].to] = triangles[moves[i].from];
	}
	triangles.resize(relocation.count);
}

// Gathers every face at the corners of the zero-area faces.
Status gather(const Surface& surface, const std::vector<std::uint32_t>& zeroAreaFaces,
              std::vector<std::uint32_t>& near) {
	std::vector<std::uint8_t> flags(surface.points.size(), 0);
	for (const std::uint32_t face : zeroAreaFaces) {
		for (const std::uint32_t corner : surface.triangles[face]) {
			flags[corner] = 1;
		}
	}
	return facesAt(
	    surface, [&flags](std::uint32_t v) { return flags[v] != 0; }, near);
}

Status clean(const Surface& surface, const std::vector<std::uint32_t>& zeroAreaFaces,
             CleanResult& result) {
	std::vector<std::uint32_t> near;
	if (Status status = gather(surface, zeroAreaFaces, near); !status.ok()) {
		return status;
	}
	Neighbourhood local = numberLocally(surface.triangles, near, zeroAreaFaces);
	rankCorners(surface.points, local);
	uniteJoined(local);
	result.oppositeFacesRemoved = cancelOpposite(local);
	if (Status status = replaceClusters(surface, local, result); !status.ok()) {
		return status;
	}
	result.oppositeFacesRemoved += cancelOpposite(local);
	result.zeroAreaFacesRemoved = zeroAreaFaces.size();
	const std::vector<std::uint32_t> representative = representatives(local);
	for (std::size_t v = 0; v < local.vertex.size(); ++v) {
		result.verticesMerged += representative[v] != local.vertex[v] ? 1 : 0;
	}
	Status status = listUnreferenced(surface, local, representative, result.unreferenced);
	if (status.ok()) {
		writeBack(local, representative, surface.triangles, result.faces);
		result.looked = std::move(local.vertex);
	}
	return status;
}

Status remove(const std::vector<std::uint32_t>& vertices, const Surface& surface, Points& points,
              Relocation& relocated) {
	std::vector<Relocation::Move>& moves = relocated.moves;
	moves.reserve(vertices.size());
	const std::size_t count =
	    closeHoles(vertices.data(), vertices.data() + vertices.size(), points.size(), moves);
	relocated.count = count;
	std::vector<std::uint32_t> target(points.size() - count, kNone);
	for (const Relocation::Move& move : moves) {
		target[move.from - count] = move.to;
	}
	std::vector<std::uint32_t> faces;
	Status status;
	if (!moves.empty()) {
		status = facesAt(
		    surface, [count](std::uint32_t v) { return v >= count; }, faces);
	}
	if (!status.ok()) {
		return status;
	}
	for (const std::uint32_t face : faces) {
		for (std::uint32_t& corner : surface.triangles[face]) {
			corner = corner >= count ? target[corner - count] : corner;
		}
	}
	for (const Relocation::Move& move : moves) {
		points[move.to] = points[move.from];
	}
	points.resize(count);
	return status;
}

}  // namespace

Status cleanSurface(const Points& points, const std::vector<std::uint32_t>& zeroAreaFaces,
                    int threads, Monitor& monitor, IndexTriangles& triangles,
                    CleanResult& result) try {
	result = CleanResult();
	result.faces.count = triangles.size();
	return zeroAreaFaces.empty()
	           ? Status()
	           : clean({points, triangles, threads, monitor}, zeroAreaFaces, result);
} catch (const std::bad_alloc&) {
	return statusOf(StatusCode::OutOfMemory);
}

Status removeVertices(const std::vector<std::uint32_t>& vertices, int threads, Monitor& monitor,
                      Points& points, IndexTriangles& triangles, Relocation& relocated) try {
	relocated = Relocation();
	return remove(vertices, {points, triangles, threads, monitor}, points, relocated);
} catch (const std::bad_alloc&) {
	return statusOf(StatusCode::OutOfMemory);
}

Status cleanMesh(FaceRange range, int threads, Monitor& monitor, Points& points,
                 IndexTriangles& triangles, CleanResult& result) {
	std::vector<std::uint32_t> zeroAreaFaces;
	Status status = findZeroAreaFaces(points, triangles, range, threads, monitor, zeroAreaFaces);
	if (status.ok()) {
		status = cleanSurface(points, zeroAreaFaces, threads, monitor, triangles, result);
	}
	if (status.ok()) {
		status = removeVertices(result.unreferenced, threads, monitor, points, triangles,
		                        result.vertices);
	}
	return status;
}

}  // namespace index_boolean
