// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A class is a set of vertices, edge intervals and regions of cut faces that no segment parts. Its
// winding number in the other operand comes from a ray, or, if it has no vertex, from a neighbour
// across a segment; then every segment must see a difference of one.
#include "labels.h"

#include "exact_sign.h"
#include "parallel.h"
#include "union_find.h"
#include "winding_rays.h"

#include <algorithm>
#include <limits>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;
constexpr int kUnknownWinding = std::numeric_limits<int>::min();

// Which sides of a segment hold the inside of the other operand: on operand 0's face the left one,
// on operand 1's the right one.
struct SidePair {
	NodeId inside, outside;
};

SidePair sidesOn(const SegmentSides& sides, std::size_t operand) {
	return operand == 0 ? SidePair{sides.left[0], sides.right[0]}
	                    : SidePair{sides.right[1], sides.left[1]};
}

// Across a segment: what a class's winding number tells of its neighbour's.
struct ClassStep {
	std::uint32_t from, to;  // class roots
	int difference;
};

class Labeller {
public:
	Labeller(Arrangement& arrangement, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), monitor_(monitor),
	      nodes_(arrangement.refinement.nodeCount) {}

	Status run();

private:
	Status uniteNodes();
	void uniteFaces(std::size_t operand);
	Status castClassRays();
	void propagate();
	Status checkSegments();
	Status checkWindings();
	Status checkComponents();
	void findComponents();
	Status checkNesting(std::size_t operand);
	Status fill();

	bool isVertex(std::uint32_t node) const { return node < mesh_.points.size(); }
	bool isUsedVertex(std::uint32_t v) const {
		return arrangement_.labels.vertexInside[v] != kUnused;
	}
	std::uint32_t componentOf(FaceId face) const {
		return components_.root(nodes_.root(at(mesh_.triangles, face)[0].value));
	}

	Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
	UnionFind nodes_;           // sets: the classes
	UnionFind components_{0};   // over class roots; sets: the operands' components
	std::vector<int> winding_;  // per class root, of the other operand
};

void Labeller::uniteFaces(std::size_t operand) {
	std::vector<std::uint8_t>& used = arrangement_.labels.vertexInside;
	const std::vector<std::uint8_t>& isCut = arrangement_.refinement.isCut;
	for (std::size_t f = mesh_.faceBegin[operand]; f < mesh_.faceBegin[operand + 1]; ++f) {
		const Triangle& t = mesh_.triangles[f];
		used[t[0].value] = used[t[1].value] = used[t[2].value] = 0;
		if (isCut[f] == 0) {
			nodes_.unite(t[0].value, t[1].value);
			nodes_.unite(t[1].value, t[2].value);
		}
	}
}

Status Labeller::uniteNodes() {
	arrangement_.labels.vertexInside.assign(mesh_.points.size(), kUnused);
	// The operands share no vertex, so each may be united on a thread of its own.
	const Status status =
	    parallelFor(2, 1, arrangement_.options.threads, monitor_,
	                [this](std::size_t begin, std::size_t end) {
		                for (std::size_t operand = begin; operand < end; ++operand) {
			                uniteFaces(operand);
		                }
	                });
	for (const auto& link : arrangement_.refinement.links) {
		nodes_.unite(link[0].value, link[1].value);
	}
	nodes_.flatten();
	return status;
}

// Every class with a vertex gets its winding number from a ray. The root, the smallest node, is
// then a vertex.
Status Labeller::castClassRays() {
	winding_.assign(nodes_.size(), kUnknownWinding);
	for (std::size_t operand = 0; operand < 2; ++operand) {
		std::vector<RayQuery> queries;
		for (std::uint32_t v = mesh_.vertexBegin[operand]; v < mesh_.vertexBegin[operand + 1]; ++v) {
			if (isUsedVertex(v) && nodes_.root(v) == v) {
				queries.push_back({VertexId{v}});
			}
		}
		const Status status = castRays(arrangement_, 1 - operand, {}, monitor_, queries);
		if (!status.ok()) {
			return status;
		}
		for (const RayQuery& query : queries) {
			winding_[query.from.value] = query.winding;
		}
	}
	return {};
}

// Classes without a vertex are regions inside one face, or several along one edge: they learn their
// winding number across the segments around them, each class once it has its own.
void Labeller::propagate() {
	std::vector<ClassStep> steps;  // from every class over every segment to one without a ray
	for (const SegmentSides& sides : arrangement_.refinement.sides) {
		for (std::size_t operand = 0; operand < 2; ++operand) {
			const SidePair pair = sidesOn(sides, operand);
			const std::uint32_t inside = nodes_.root(pair.inside.value);
			const std::uint32_t outside = nodes_.root(pair.outside.value);
			if (winding_[inside] == kUnknownWinding) {
				steps.push_back({outside, inside, 1});
			}
			if (winding_[outside] == kUnknownWinding) {
				steps.push_back({inside, outside, -1});
			}
		}
	}
	const auto byFrom = [](const ClassStep& a, const ClassStep& b) { return a.from < b.from; };
	std::sort(steps.begin(), steps.end(), byFrom);
	std::vector<std::uint32_t> known;
	for (const ClassStep& step : steps) {
		if (winding_[step.from] != kUnknownWinding &&
		    (known.empty() || known.back() != step.from)) {
			known.push_back(step.from);
		}
	}
	while (!known.empty()) {
		const ClassStep key{known.back(), 0, 0};
		known.pop_back();
		const auto range = std::equal_range(steps.begin(), steps.end(), key, byFrom);
		for (auto step = range.first; step != range.second; ++step) {
			if (winding_[step->to] == kUnknownWinding) {
				winding_[step->to] = winding_[step->from] + step->difference;
				known.push_back(step->to);
			}
		}
	}
}

// Collects the offending faces of one operand, given by global ids, into a status.
void finish(const Arrangement& arrangement, Status& status, std::vector<FaceId>& faces) {
	std::sort(faces.begin(), faces.end());
	faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
	for (const FaceId face : faces) {
		status.faces.push_back(arrangement.givenFace(face));
	}
	status.count = status.faces.size();
	if (!faces.empty()) {
		status.hasPlace = true;
		status.place = at(arrangement.mesh.points, at(arrangement.mesh.triangles, faces[0])[0]);
	}
}

// Loop orientation and winding numbers must agree at every segment.
Status Labeller::checkSegments() {
	for (std::size_t operand = 0; operand < 2; ++operand) {
		std::vector<FaceId> faces;
		for (std::size_t s = 0; s < arrangement_.refinement.sides.size(); ++s) {
			const SidePair pair = sidesOn(arrangement_.refinement.sides[s], operand);
			const int inside = winding_[nodes_.root(pair.inside.value)];
			const int outside = winding_[nodes_.root(pair.outside.value)];
			if (inside != outside + 1 || outside != 0) {
				const Segment& segment = arrangement_.curve.segments[s];
				faces.push_back(operand == 0 ? segment.b : segment.a);
			}
		}
		if (!faces.empty()) {
			Status status;
			status.code = StatusCode::SelfIntersecting;
			status.operand = static_cast<int>(1 - operand);
			finish(arrangement_, status, faces);
			return status;
		}
	}
	return {};
}

// Classes that no segment touches must lie outside the other operand, or inside it once.
Status Labeller::checkWindings() {
	for (std::uint32_t v = 0; v < mesh_.points.size(); ++v) {
		if (!isUsedVertex(v) || nodes_.root(v) != v || winding_[v] == 0 || winding_[v] == 1) {
			continue;
		}
		Status status;
		status.code = StatusCode::SelfIntersecting;
		const auto other = static_cast<std::size_t>(1 - mesh_.operandOf(VertexId{v}));
		status.operand = static_cast<int>(other);
		std::vector<FaceId> faces;
		for (std::uint32_t f = mesh_.faceBegin[other]; f < mesh_.faceBegin[other + 1]; ++f) {
			faces.push_back({f});
		}
		finish(arrangement_, status, faces);
		status.place = mesh_.points[v];
		return status;
	}
	return {};
}

// Components are classes joined across the segments that part them.
void Labeller::findComponents() {
	components_ = UnionFind(nodes_.size());
	for (const SegmentSides& sides : arrangement_.refinement.sides) {
		for (std::size_t operand = 0; operand < 2; ++operand) {
			const SidePair pair = sidesOn(sides, operand);
			components_.unite(nodes_.root(pair.inside.value), nodes_.root(pair.outside.value));
		}
	}
	components_.flatten();
	for (std::uint32_t v = 0; v < mesh_.points.size(); ++v) {
		if (isUsedVertex(v) && nodes_.root(v) == v && components_.root(v) == v) {
			const int operand = mesh_.operandOf(VertexId{v});
			++arrangement_.labels.components[static_cast<std::size_t>(operand)];
		}
	}
}

Status Labeller::checkComponents() {
	findComponents();
	for (std::size_t operand = 0; operand < 2; ++operand) {
		if (arrangement_.labels.components[operand] > 1) {
			const Status status = checkNesting(operand);
			if (!status.ok()) {
				return status;
			}
		}
	}
	return {};
}

// The signs of the components' volumes, by their root.
std::vector<int> volumeSigns(const MeshArrays& mesh, std::size_t operand,
                             const std::vector<std::uint32_t>& componentOfFace,
                             std::size_t componentCount) {
	std::vector<Bounded> sums(componentCount, Bounded(0));
	const std::uint32_t first = mesh.faceBegin[operand];
	const Point& reference = at(mesh.points, mesh.triangles[first][0]);
	for (std::uint32_t i = 0; i < componentOfFace.size(); ++i) {
		const Triangle& t = mesh.triangles[first + i];
		Bounded& sum = sums[componentOfFace[i]];
		sum = sum - orient3dBounded(at(mesh.points, t[0]), at(mesh.points, t[1]),
		                            at(mesh.points, t[2]), reference);
	}
	std::vector<int> signs(componentCount);
	std::vector<std::vector<Triangle>> unsure(componentCount);
	for (std::size_t c = 0; c < componentCount; ++c) {
		signs[c] = sums[c].sign();
	}
	for (std::uint32_t i = 0; i < componentOfFace.size(); ++i) {
		if (signs[componentOfFace[i]] == kUnknownSign) {
			unsure[componentOfFace[i]].push_back(mesh.triangles[first + i]);
		}
	}
	for (std::size_t c = 0; c < componentCount; ++c) {
		if (signs[c] == kUnknownSign) {
			signs[c] = exactVolumeSign(mesh.points, unsure[c].data(),
			                           unsure[c].data() + unsure[c].size());
		}
	}
	return signs;
}

// A solid component must lie outside the operand's other components, a cavity inside them, once.
Status Labeller::checkNesting(std::size_t operand) {
	const std::uint32_t first = mesh_.faceBegin[operand];
	const std::uint32_t last = mesh_.faceBegin[operand + 1];
	// Components by number, in the order of their roots.
	std::vector<std::uint32_t> number(mesh_.points.size());
	std::vector<RayQuery> queries;
	for (std::uint32_t v = mesh_.vertexBegin[operand]; v < mesh_.vertexBegin[operand + 1]; ++v) {
		if (isUsedVertex(v) && nodes_.root(v) == v && components_.root(v) == v) {
			number[v] = static_cast<std::uint32_t>(queries.size());
			queries.push_back({VertexId{v}});
		}
	}
	std::vector<std::uint32_t> componentOfFace;
	for (std::uint32_t f = first; f < last; ++f) {
		componentOfFace.push_back(number[componentOf({f})]);
	}
	const std::vector<int> signs =
	    volumeSigns(mesh_, operand, componentOfFace, queries.size());
	const auto isOwn = [&](std::size_t query, FaceId face) {
		return componentOfFace[face.value - first] == query;
	};
	Status status = castRays(arrangement_, operand, isOwn, monitor_, queries);
	if (!status.ok()) {
		return status;
	}
	std::vector<std::uint8_t> wrong(queries.size());
	for (std::size_t c = 0; c < queries.size(); ++c) {
		const int expected = signs[c] > 0 ? 0 : 1;
		wrong[c] = signs[c] == 0 || queries[c].onSurface || queries[c].winding != expected;
		status.count += wrong[c];
	}
	if (status.count == 0) {
		return {};
	}
	const std::size_t components = status.count;
	std::vector<FaceId> faces;
	for (std::uint32_t f = first; f < last; ++f) {
		if (wrong[componentOfFace[f - first]] != 0) {
			faces.push_back({f});
		}
	}
	status.code = StatusCode::NestedComponents;
	status.operand = static_cast<int>(operand);
	finish(arrangement_, status, faces);
	status.count = components;
	return status;
}

Status Labeller::fill() {
	Labels& labels = arrangement_.labels;
	const auto insideOf = [this](std::uint32_t node) {
		return static_cast<std::uint8_t>(winding_[nodes_.root(node)]);
	};
	const std::vector<NodeId>& regions = arrangement_.refinement.pieceRegion;
	labels.pieceInside.resize(regions.size());
	for (std::size_t piece = 0; piece < regions.size(); ++piece) {
		labels.pieceInside[piece] = insideOf(regions[piece].value);
	}
	return parallelFor(mesh_.points.size(), kGrain, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t v = begin; v < end; ++v) {
			                   if (labels.vertexInside[v] != kUnused) {
				                   labels.vertexInside[v] =
				                       insideOf(static_cast<std::uint32_t>(v));
			                   }
		                   }
	                   });
}

Status Labeller::run() {
	Status status = uniteNodes();
	if (status.ok()) {
		status = castClassRays();
	}
	if (status.ok()) {
		propagate();
		status = checkComponents();
	}
	if (status.ok()) {
		status = checkSegments();
	}
	if (status.ok()) {
		status = checkWindings();
	}
	return status.ok() ? fill() : status;
}

}  // namespace

Status labelArrangement(Arrangement& arrangement, Monitor& monitor) {
	return Labeller(arrangement, monitor).run();
}

}  // namespace index_boolean
