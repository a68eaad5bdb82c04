// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every segment labels the classes beside it; every class with a vertex off the other operand gets
// a winding number from a ray as well, and so does each that no segment bounds.
#include "vcg_ext/solids/labels.h"

#include "vcg_ext/base/groups.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/parts/winding_rays.h"
#include "vcg_ext/solids/components.h"
#include "vcg_ext/solids/faces_to_blame.h"
#include "vcg_ext/solids/nesting.h"
#include "vcg_ext/solids/segment_labels.h"

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

class Labeller {
public:
	Labeller(Arrangement& arrangement, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), refinement_(arrangement.refinement),
	      monitor_(monitor), nodes_(arrangement) {}

	Status run();

private:
	Status checkComponents();
	Status labelBySegments();
	Status labelBesides(const SegmentSide* first, const SegmentSide* last);
	Status labelByRays();
	std::vector<VertexId> freeRoots(OperandId operand) const;
	std::vector<FaceId> unboundedFaces(OperandId operand);
	Status labelByRays(OperandId operand);
	Status setLabel(NodeId node, Label label, FaceId face);
	Status refuseOther(OperandId operand, VertexId vertex) const;
	Status fill();

	Label& labelOf(NodeId node) { return label_[classes_.root(node.value)]; }

	Arrangement& arrangement_;
	const MeshArrays& mesh_;
	const Refinement& refinement_;
	Monitor& monitor_;
	LabelNodes nodes_;
	UnionFind classes_{0};
	std::vector<Label> label_;                   // per root of a class
	std::vector<LabelledHalfPlane> halfPlanes_;  // of one segment
};

// Each operand's components must not lie in each other, but for cavities.
Status Labeller::checkComponents() {
	const Components components(arrangement_, classes_);
	Status status;
	for (const OperandId operand : mesh_.operands()) {
		std::uint32_t& count = arrangement_.labels.components[operand];
		if (status.ok()) {
			count = components.count(operand);
			status =
			    count < 2 ? Status{} : checkNesting(arrangement_, operand, components, monitor_);
		}
	}
	return status;
}

// Gives a class its label. A class that has another one already shows that the other operand's
// inside is not told from its outside: `face` is one of its faces there, or none().
Status Labeller::setLabel(NodeId node, Label label, FaceId face) {
	Label& known = labelOf(node);
	if (known == Label::Unknown || known == label) {
		known = label;
		return {};
	}
	return face == FaceId::none() ? statusOf(StatusCode::SelfIntersecting)
	                              : refusalOf(arrangement_, StatusCode::SelfIntersecting,
	                                          mesh_.operandOf(face), {face});
}

// Labels what lies beside one segment, whose sides these are.
Status Labeller::labelBesides(const SegmentSide* first, const SegmentSide* last) {
	const Segment& segment = at(arrangement_.curve.segments, first->segment);
	std::vector<LabelledHalfPlane>& halfPlanes = halfPlanes_;
	halfPlanes.clear();
	for (const SegmentSide* side = first; side != last; ++side) {
		const bool onFirst = mesh_.operandOf(side->face) == kFirst;
		if (side->left != NodeId::none()) {
			halfPlanes.push_back(
			    {{side->face, true}, side->left, onFirst ? Label::Inside : Label::Outside});
		}
		if (side->right != NodeId::none()) {
			halfPlanes.push_back(
			    {{side->face, false}, side->right, onFirst ? Label::Outside : Label::Inside});
		}
	}
	const auto wrong = segment.crossing ? std::optional<OperandId>{}
	                                    : labelAround(arrangement_, segment, halfPlanes);
	if (wrong) {
		std::vector<FaceId> faces;
		for (const LabelledHalfPlane& half : halfPlanes) {
			if (mesh_.operandOf(half.face) == *wrong) {
				faces.push_back(half.face);
			}
		}
		return refusalOf(arrangement_, StatusCode::SelfIntersecting, *wrong, std::move(faces));
	}
	Status status;
	for (std::size_t i = 0; i < halfPlanes.size() && status.ok(); ++i) {
		const bool onFirst = mesh_.operandOf(halfPlanes[i].face) == kFirst;
		status =
		    setLabel(halfPlanes[i].region, halfPlanes[i].label, onFirst ? segment.b : segment.a);
	}
	return status;
}

Status Labeller::labelBySegments() {
	const HugeVector<SegmentSide>& sides = refinement_.sides;
	Status status;
	label_.assign(classes_.size(), Label::Unknown);
	forEachGroup(
	    sides.data(), sides.data() + sides.size(),
	    [](const SegmentSide& a, const SegmentSide& b) { return a.segment == b.segment; },
	    [&](const SegmentSide* first, const SegmentSide* last) {
		    if (status.ok()) {
			    status = labelBesides(first, last);
		    }
	    });
	return status;
}

// One vertex of every class that has one off the other operand: its root, the smallest node.
std::vector<VertexId> Labeller::freeRoots(OperandId operand) const {
	std::vector<VertexId> roots;
	for (std::uint32_t v = mesh_.vertexOffsets.begin(operand); v < mesh_.vertexOffsets.end(operand);
	     ++v) {
		if (arrangement_.labels.vertex[v] == Label::Unknown && classes_.root(v) == v) {
			roots.push_back({v});
		}
	}
	return roots;
}

// One face of every other class without a label. It is of the class as a whole, since no segment
// bounds that.
std::vector<FaceId> Labeller::unboundedFaces(OperandId operand) {
	std::vector<FaceId> faces;
	for (const CutFace& cut : refinement_.cutFaces) {
		const std::uint32_t root = classes_.root(refinement_.pieceRegion[cut.firstPiece].value);
		const bool isOwn = mesh_.operandOf(cut.face) == operand;
		if (isOwn && !nodes_.isVertex({root}) && label_[root] == Label::Unknown) {
			label_[root] = Label::Unused;  // listed: once is enough
			faces.push_back(cut.face);
		}
	}
	for (const FaceId face : faces) {
		labelOf(nodes_.ofFace(face)) = Label::Unknown;
	}
	return faces;
}

// The other operand intersects itself. Which of its faces are to blame is not known: all are shown.
Status Labeller::refuseOther(OperandId operand, VertexId vertex) const {
	const OperandId other = otherOf(operand);
	std::vector<FaceId> faces;
	for (std::uint32_t f = mesh_.faceOffsets.begin(other); f < mesh_.faceOffsets.end(other); ++f) {
		faces.push_back({f});
	}
	Status status = refusalOf(arrangement_, StatusCode::SelfIntersecting, other, std::move(faces));
	status.place = at(mesh_.points, vertex);
	return status;
}

// Labels classes of one operand by their winding numbers in the other.
Status Labeller::labelByRays(OperandId operand) {
	std::vector<WindingQuery> queries;
	std::vector<NodeId> nodes;       // per query, one of its class
	std::vector<VertexId> vertices;  // per query, one near it
	for (const VertexId v : freeRoots(operand)) {
		queries.emplace_back();
		queries.back().from = v;
		nodes.push_back(LabelNodes::ofVertex(v));
		vertices.push_back(v);
	}
	for (const FaceId face : unboundedFaces(operand)) {
		queries.push_back(queryInside(mesh_, face));
		nodes.push_back(nodes_.ofFace(face));
		vertices.push_back(at(mesh_.triangles, face)[0]);
	}
	Status status =
	    findWindings(mesh_, otherOf(operand), {}, arrangement_.options.threads, monitor_, queries);
	for (std::size_t i = 0; i < queries.size() && status.ok(); ++i) {
		const WindingQuery& query = queries[i];
		const bool isSolid = !query.onSurface && query.behind >= 0 && query.behind <= 1;
		const Label label = query.behind == 1 ? Label::Inside : Label::Outside;
		if (!isSolid || !setLabel(nodes[i], label, FaceId::none()).ok()) {
			status = refuseOther(operand, vertices[i]);
		}
	}
	return status;
}

Status Labeller::labelByRays() {
	Status status;
	for (const OperandId operand : mesh_.operands()) {
		if (status.ok()) {
			status = labelByRays(operand);
		}
	}
	return status;
}

Status Labeller::fill() {
	Labels& labels = arrangement_.labels;
	const HugeVector<NodeId>& regions = refinement_.pieceRegion;
	Status status;
	labels.piece.resize(regions.size());
	for (std::size_t piece = 0; piece < regions.size(); ++piece) {
		labels.piece[piece] = labelOf(regions[piece]);
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
				                   labels.vertex[v] = labelOf({static_cast<std::uint32_t>(v)});
			                   }
		                   }
	                   });
}

Status Labeller::run() {
	return inOrder([this] { return findClasses(arrangement_, monitor_, classes_); },
	               [this] { return checkComponents(); }, [this] { return labelBySegments(); },
	               [this] { return labelByRays(); }, [this] { return fill(); });
}

}  // namespace

Status labelArrangement(Arrangement& arrangement, Monitor& monitor) {
	return Labeller(arrangement, monitor).run();
}

}  // namespace index_boolean
