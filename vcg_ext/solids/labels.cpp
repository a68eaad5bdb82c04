// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A class is a set of vertices, edge intervals and regions of touched faces that no segment parts.
// Every segment labels the classes beside it; every class with a vertex off the other operand gets
// a winding number from a ray as well, and so does each that no segment bounds.
#include "vcg_ext/solids/labels.h"

#include "vcg_ext/arrange/radial_order.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/solids/winding_rays.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

class Labeller {
public:
	Labeller(Arrangement& arrangement, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), refinement_(arrangement.refinement),
	      monitor_(monitor), nodes_(arrangement.refinement.nodeCount) {}

	Status run();

private:
	Status uniteNodes();
	void uniteFaces(OperandId operand);
	void findComponents();
	std::uint32_t countComponents(OperandId operand) const;
	Status checkComponents();
	Status checkNesting(OperandId operand);
	Status labelBySegments();
	Status labelBesides(std::size_t first, std::size_t last);
	Status labelByRays();
	Status labelClasses(OperandId operand, std::vector<WindingQuery>& queries);
	Status setLabel(NodeId node, Label label, FaceId face);
	Status fill();

	bool isFreeVertex(std::uint32_t v) const {
		return arrangement_.labels.vertex[v] == Label::Unknown;
	}
	OperandId operandOfRegion(NodeId region) const {
		return region < firstRegionOfSecond_ ? kFirst : kSecond;
	}
	std::uint32_t nodeOf(FaceId face) const;
	std::uint32_t cornerNode(OperandId operand, VertexId v) const {
		return static_cast<std::uint32_t>(nodes_.size() + operand.value * mesh_.points.size()) +
		       v.value;
	}
	std::uint32_t componentOf(FaceId face) const { return components_.root(nodeOf(face)); }

	Arrangement& arrangement_;
	const MeshArrays& mesh_;
	const Refinement& refinement_;
	Monitor& monitor_;
	UnionFind nodes_;          // sets: the classes
	UnionFind components_{0};  // over nodes; sets: the operands' components
	NodeId firstRegionOfSecond_ = NodeId::none();
	std::vector<Label> label_;  // per class root
};

// A node of the face: one of its vertices, or its first region. For a quiet face it is one of
// components_ only.
std::uint32_t Labeller::nodeOf(FaceId face) const {
	if (mesh_.quietTwin(face) != Twin::None) {
		return cornerNode(mesh_.operandOf(face), at(mesh_.triangles, face)[0]);
	}
	if (at(refinement_.isCut, face) == 0) {
		return at(mesh_.triangles, face)[0].value;
	}
	const auto cut = std::lower_bound(refinement_.cutFaces.begin(), refinement_.cutFaces.end(),
	                                  face, [](const CutFace& c, FaceId f) { return c.face < f; });
	return refinement_.pieceRegion[cut->firstPiece].value;
}

void Labeller::uniteFaces(OperandId operand) {
	std::vector<Label>& label = arrangement_.labels.vertex;
	const std::vector<std::uint8_t>& isCut = refinement_.isCut;
	for (std::size_t f = mesh_.faceOffsets.begin(operand); f < mesh_.faceOffsets.end(operand);
	     ++f) {
		const Triangle& t = mesh_.triangles[f];
		if (mesh_.quietTwin(makeId<FaceTag>(f)) != Twin::None) {
			continue;
		}
		if (isCut[f] == 0) {
			label[t[0].value] = label[t[1].value] = label[t[2].value] = Label::Unknown;
			nodes_.unite({t[0].value, t[1].value, t[2].value});
		}
	}
}

// A vertex on the other operand joins nothing: what meets there may lie on different sides.
Status Labeller::uniteNodes() {
	std::vector<Label>& label = arrangement_.labels.vertex;
	label.assign(mesh_.points.size(), Label::Unused);
	// Faces that are not touched have vertices of their own operand only, so each operand may be
	// united on a thread of its own.
	const int halves = threadsForHalves(mesh_.points.size(), arrangement_.options.threads);
	const Status status =
	    parallelFor(2, 1, halves, monitor_, [this](std::size_t begin, std::size_t end) {
		    for (std::size_t operand = begin; operand < end; ++operand) {
			    uniteFaces(makeId<OperandTag>(operand));
		    }
	    });
	for (const auto& link : refinement_.links) {
		if (link[1].value < label.size()) {
			label[link[1].value] = Label::Unknown;
		}
		nodes_.unite(link[0].value, link[1].value);
	}
	for (const auto& link : refinement_.cornerLinks) {
		label[link[1].value] = Label::OnVertex;
	}
	for (std::size_t v = 0; v < mesh_.quietVertices.size(); ++v) {
		if (mesh_.quietVertices[v] != 0) {
			label[v] = Label::OnVertex;
		}
	}
	nodes_.flatten();
	label_.assign(nodes_.size(), Label::Unknown);
	return status;
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

// Components are classes joined across segments and at common corners. A vertex on the other
// operand may be a corner of both: it has a node for each, numbered after all others.
void Labeller::findComponents() {
	components_ = nodes_;
	if (!refinement_.cornerLinks.empty() || !mesh_.quietFaces.empty()) {
		components_.grow(nodes_.size() + 2 * mesh_.points.size());
	}
	for (const CutFace& cut : refinement_.cutFaces) {
		if (mesh_.operandOf(cut.face) == kSecond) {
			firstRegionOfSecond_ = refinement_.pieceRegion[cut.firstPiece];
			break;
		}
	}
	PerOperand<NodeId> last;  // region of each operand at the segment that is looked at
	for (std::size_t i = 0; i < refinement_.sides.size(); ++i) {
		const SegmentSide& side = refinement_.sides[i];
		if (i == 0 || side.segment != refinement_.sides[i - 1].segment) {
			last = {NodeId::none(), NodeId::none()};
		}
		for (const NodeId region : {side.left, side.right}) {
			NodeId& previous = last[mesh_.operandOf(side.face)];
			if (region != NodeId::none() && previous != NodeId::none()) {
				components_.unite(region.value, previous.value);
			}
			previous = region == NodeId::none() ? previous : region;
		}
	}
	for (const auto& link : refinement_.cornerLinks) {
		const OperandId operand = operandOfRegion(link[0]);
		components_.unite(link[0].value, cornerNode(operand, {link[1].value}));
	}
	for (std::uint32_t f = 0; f < mesh_.quietFaces.size(); ++f) {
		if (mesh_.quietFaces[f] != Twin::None) {
			const OperandId operand = mesh_.operandOf({f});
			const Triangle& t = mesh_.triangles[f];
			components_.unite(
			    {cornerNode(operand, t[0]), cornerNode(operand, t[1]), cornerNode(operand, t[2])});
		}
	}
	components_.flatten();
}

// Numbers the components of one operand in the order of their first faces.
struct ComponentList {
	std::vector<std::uint32_t> ofFace;  // per face of the operand
	std::vector<FaceId> firstFace;      // per component
};

template <class ComponentOf>
ComponentList listComponents(const MeshArrays& mesh, OperandId operand, std::size_t nodeCount,
                             ComponentOf&& componentOf) {
	ComponentList list;
	std::vector<std::uint32_t> number(nodeCount, 0xffffffffu);
	for (std::uint32_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand);
	     ++f) {
		std::uint32_t& component = number[componentOf(FaceId{f})];
		if (component == 0xffffffffu) {
			component = static_cast<std::uint32_t>(list.firstFace.size());
			list.firstFace.push_back({f});
		}
		list.ofFace.push_back(component);
	}
	return list;
}

// A component's root, its smallest node, is a vertex off the other operand if it has one at all.
std::uint32_t Labeller::countComponents(OperandId operand) const {
	std::uint32_t count = 0;
	for (std::uint32_t v = mesh_.vertexOffsets.begin(operand); v < mesh_.vertexOffsets.end(operand);
	     ++v) {
		count += isFreeVertex(v) && components_.root(v) == v ? 1 : 0;
	}
	std::vector<std::uint32_t> others;
	for (const CutFace& cut : refinement_.cutFaces) {
		const std::uint32_t root = components_.root(refinement_.pieceRegion[cut.firstPiece].value);
		if (mesh_.operandOf(cut.face) == operand && root >= mesh_.points.size()) {
			others.push_back(root);
		}
	}
	std::sort(others.begin(), others.end());
	const auto end = std::unique(others.begin(), others.end());
	count += static_cast<std::uint32_t>(end - others.begin());
	for (std::uint32_t v = 0; v < mesh_.quietVertices.size(); ++v) {
		const std::uint32_t node = cornerNode(operand, {v});
		count += mesh_.quietVertices[v] != 0 && components_.root(node) == node ? 1 : 0;
	}
	return count;
}

Status Labeller::checkComponents() {
	findComponents();
	for (const OperandId operand : mesh_.operands()) {
		const Status status = checkNesting(operand);
		if (!status.ok()) {
			return status;
		}
	}
	return {};
}

// The signs of the components' volumes, by their root.
std::vector<int> volumeSigns(const MeshArrays& mesh, OperandId operand,
                             const std::vector<std::uint32_t>& componentOfFace,
                             std::size_t componentCount) {
	std::vector<Bounded> sums(componentCount, Bounded(0));
	const std::uint32_t first = mesh.faceOffsets.begin(operand);
	const Point& reference = at(mesh.points, mesh.triangles[first][0]);
	for (std::uint32_t i = 0; i < componentOfFace.size(); ++i) {
		const Triangle& t = mesh.triangles[first + i];
		Bounded& sum = sums[componentOfFace[i]];
		sum = sum - orient3dBounded(at(mesh.points, t[0]), at(mesh.points, t[1]),
		                            at(mesh.points, t[2]), reference);
	}
	std::vector<int> signs(componentCount);
	std::vector<Triangles> unsure(componentCount);
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
			signs[c] =
			    exactVolumeSign(mesh.points, unsure[c].data(), unsure[c].data() + unsure[c].size());
		}
	}
	return signs;
}

// Whether the operand's winding number is 0 or 1 on both sides of a place on a component. The other
// components' number is known; the component's own is that of an embedded one.
bool isPlacedRight(const WindingQuery& others, int volumeSign) {
	const int ownBehind = volumeSign > 0 ? 1 : 0;
	const int behind = others.behind + ownBehind, inFront = others.inFront + ownBehind - 1;
	return volumeSign != 0 && behind >= 0 && behind <= 1 && inFront >= 0 && inFront <= 1;
}

// A solid component must lie outside the operand's other components, a cavity inside them, once.
Status Labeller::checkNesting(OperandId operand) {
	const std::uint32_t first = mesh_.faceOffsets.begin(operand);
	arrangement_.labels.components[operand] = countComponents(operand);
	if (arrangement_.labels.components[operand] < 2) {
		return {};
	}
	const ComponentList list = listComponents(mesh_, operand, components_.size(),
	                                          [this](FaceId f) { return componentOf(f); });
	std::vector<WindingQuery> queries(list.firstFace.size());
	for (std::size_t c = 0; c < queries.size(); ++c) {
		queries[c].inside = list.firstFace[c];
	}
	const std::vector<int> signs = volumeSigns(mesh_, operand, list.ofFace, queries.size());
	const auto isOwn = [&](std::size_t query, FaceId face) {
		return list.ofFace[face.value - first] == query;
	};
	Status status =
	    findWindings(mesh_, operand, isOwn, arrangement_.options.threads, monitor_, queries);
	if (!status.ok()) {
		return status;
	}
	std::vector<std::uint8_t> wrong(queries.size());
	std::size_t wrongCount = 0;
	for (std::size_t c = 0; c < queries.size(); ++c) {
		wrong[c] = isPlacedRight(queries[c], signs[c]) ? 0 : 1;
		wrongCount += wrong[c];
	}
	if (wrongCount == 0) {
		return {};
	}
	std::vector<FaceId> faces;
	for (std::size_t i = 0; i < list.ofFace.size(); ++i) {
		if (wrong[list.ofFace[i]] != 0) {
			faces.push_back({first + static_cast<std::uint32_t>(i)});
		}
	}
	status.code = StatusCode::NestedComponents;
	status.operand = numberOf(operand);
	finish(arrangement_, status, faces);
	status.count = wrongCount;
	return status;
}

// Gives a class its label. A class that has another one already shows that the other operand's
// inside is not told from its outside: `face` is one of its faces there, or none().
Status Labeller::setLabel(NodeId node, Label label, FaceId face) {
	Label& known = label_[nodes_.root(node.value)];
	if (known == Label::Unknown || known == label) {
		known = label;
		return {};
	}
	Status status;
	status.code = StatusCode::SelfIntersecting;
	std::vector<FaceId> faces;
	if (face != FaceId::none()) {
		status.operand = numberOf(mesh_.operandOf(face));
		faces.push_back(face);
	}
	finish(arrangement_, status, faces);
	return status;
}

// Labels what lies beside one segment, whose sides are sides[first .. last).
Status Labeller::labelBesides(std::size_t first, std::size_t last) {
	const Segment& segment = at(arrangement_.curve.segments, refinement_.sides[first].segment);
	std::vector<LabelledHalfPlane> halfPlanes;
	for (std::size_t i = first; i < last; ++i) {
		const SegmentSide& side = refinement_.sides[i];
		const bool onFirst = mesh_.operandOf(side.face) == kFirst;
		if (side.left != NodeId::none()) {
			halfPlanes.push_back(
			    {{side.face, true}, side.left, onFirst ? Label::Inside : Label::Outside});
		}
		if (side.right != NodeId::none()) {
			halfPlanes.push_back(
			    {{side.face, false}, side.right, onFirst ? Label::Outside : Label::Inside});
		}
	}
	const int wrong = segment.crossing ? -1 : labelAround(arrangement_, segment, halfPlanes);
	Status status;
	if (wrong >= 0) {
		status.code = StatusCode::SelfIntersecting;
		status.operand = wrong;
		std::vector<FaceId> faces;
		for (const LabelledHalfPlane& half : halfPlanes) {
			if (numberOf(mesh_.operandOf(half.face)) == wrong) {
				faces.push_back(half.face);
			}
		}
		finish(arrangement_, status, faces);
	}
	for (std::size_t i = 0; i < halfPlanes.size() && status.ok(); ++i) {
		const bool onFirst = mesh_.operandOf(halfPlanes[i].face) == kFirst;
		status =
		    setLabel(halfPlanes[i].region, halfPlanes[i].label, onFirst ? segment.b : segment.a);
	}
	return status;
}

Status Labeller::labelBySegments() {
	const HugeVector<SegmentSide>& sides = refinement_.sides;
	for (std::size_t first = 0; first < sides.size();) {
		std::size_t last = first + 1;
		while (last < sides.size() && sides[last].segment == sides[first].segment) {
			++last;
		}
		const Status status = labelBesides(first, last);
		if (!status.ok()) {
			return status;
		}
		first = last;
	}
	return {};
}

// Labels the queries' classes by their winding numbers in the other operand.
Status Labeller::labelClasses(OperandId operand, std::vector<WindingQuery>& queries) {
	Status status =
	    findWindings(mesh_, otherOf(operand), {}, arrangement_.options.threads, monitor_, queries);
	for (std::size_t i = 0; i < queries.size() && status.ok(); ++i) {
		const WindingQuery& query = queries[i];
		const bool fromVertex = query.from != VertexId::none();
		const NodeId node{fromVertex ? query.from.value : nodeOf(query.inside)};
		if (query.onSurface || query.behind < 0 || query.behind > 1) {
			status.code = StatusCode::SelfIntersecting;
		} else {
			status =
			    setLabel(node, query.behind == 1 ? Label::Inside : Label::Outside, FaceId::none());
		}
		if (status.code == StatusCode::SelfIntersecting) {
			// Which of the other operand's faces are to blame is not known: all are shown.
			status.operand = numberOf(otherOf(operand));
			std::vector<FaceId> faces;
			for (std::uint32_t f = mesh_.faceOffsets.begin(otherOf(operand));
			     f < mesh_.faceOffsets.end(otherOf(operand)); ++f) {
				faces.push_back({f});
			}
			finish(arrangement_, status, faces);
			status.place = fromVertex ? at(mesh_.points, query.from)
			                          : at(mesh_.points, at(mesh_.triangles, query.inside)[0]);
		}
	}
	return status;
}

// A ray for every class that has a vertex off the other operand: its root, the smallest node, is
// then one. And for every class without a label, which has a whole face since no segment bounds it.
Status Labeller::labelByRays() {
	for (const OperandId operand : mesh_.operands()) {
		std::vector<WindingQuery> queries;
		for (std::uint32_t v = mesh_.vertexOffsets.begin(operand);
		     v < mesh_.vertexOffsets.end(operand); ++v) {
			if (isFreeVertex(v) && nodes_.root(v) == v) {
				queries.emplace_back();
				queries.back().from = {v};
			}
		}
		std::vector<std::uint32_t> asked;
		for (const CutFace& cut : refinement_.cutFaces) {
			const std::uint32_t root = nodes_.root(refinement_.pieceRegion[cut.firstPiece].value);
			const bool isOwn = mesh_.operandOf(cut.face) == operand;
			if (isOwn && root >= mesh_.points.size() && label_[root] == Label::Unknown) {
				label_[root] = Label::Unused;  // asked for: once is enough
				asked.push_back(root);
				queries.emplace_back();
				queries.back().inside = cut.face;
			}
		}
		for (const std::uint32_t root : asked) {
			label_[root] = Label::Unknown;
		}
		const Status status = labelClasses(operand, queries);
		if (!status.ok()) {
			return status;
		}
	}
	return {};
}

Status Labeller::fill() {
	Labels& labels = arrangement_.labels;
	const HugeVector<NodeId>& regions = refinement_.pieceRegion;
	Status status;
	labels.piece.resize(regions.size());
	for (std::size_t piece = 0; piece < regions.size(); ++piece) {
		labels.piece[piece] = label_[nodes_.root(regions[piece].value)];
		if (labels.piece[piece] == Label::Unknown) {
			status.code = StatusCode::InternalError;
		}
	}
	if (!status.ok()) {
		return status;
	}
	return parallelFor(mesh_.points.size(), kGrain, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t v = begin; v < end; ++v) {
			                   if (labels.vertex[v] == Label::Unknown) {
				                   labels.vertex[v] =
				                       label_[nodes_.root(static_cast<std::uint32_t>(v))];
			                   }
		                   }
	                   });
}

Status Labeller::run() {
	Status status = uniteNodes();
	if (status.ok()) {
		status = checkComponents();
	}
	if (status.ok()) {
		status = labelBySegments();
	}
	if (status.ok()) {
		status = labelByRays();
	}
	return status.ok() ? fill() : status;
}

}  // namespace

Status labelArrangement(Arrangement& arrangement, Monitor& monitor) {
	return Labeller(arrangement, monitor).run();
}

}  // namespace index_boolean
