// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the root down: a set of faces is parted where the surfaces of the two boxes, times how many
// blocks are in them, are least. The upper nodes are made on one thread, what hangs below them on
// all.
#include "vcg_ext/distance/face_tree_builder.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/distance/unit_normal.h"
#include "vcg_ext/exact/unit_scale.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::size_t kBins = 16, kFewFaces = 16, kGrain = 1 << 12;
constexpr std::size_t kDepthOfHalves = 24;  // from here on halves have equal counts
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct FloatBox {
	std::array<float, 3> lo{kInfinity, kInfinity, kInfinity};
	std::array<float, 3> hi{-kInfinity, -kInfinity, -kInfinity};

	void add(const FloatBox& other) {
		for (std::size_t k = 0; k < 3; ++k) {
			lo[k] = std::min(lo[k], other.lo[k]);
			hi[k] = std::max(hi[k], other.hi[k]);
		}
	}
	double halfSurface() const {
		const double x = double{hi[0]} - lo[0], y = double{hi[1]} - lo[1],
		             z = double{hi[2]} - lo[2];
		return x * y + y * z + z * x;
	}
	float twiceTheMiddle(std::size_t axis) const { return lo[axis] + hi[axis]; }
};

// Of the faces order[begin .. end).
struct FaceSet {
	std::size_t begin, end, depth;

	std::size_t count() const { return end - begin; }
};

// A part of the tree in numberings of its own, and what it holds of the whole.
struct Subtree {
	FaceSet faces{};
	std::vector<FaceTreeNode> nodes;
	std::vector<FaceBlock> blocks;
	std::uint32_t root = kNone;
	double longestSquared = 0;
};

class Builder {
public:
	Builder(const Points& points, const IndexTriangles& triangles, int threads, Monitor& monitor)
	    : points_(points), triangles_(triangles), threads_(threads), monitor_(monitor) {}

	Status run(BuiltTree& out);

private:
	Status prepare();
	FloatBox boxOf(const FaceSet& faces) const;
	std::size_t part(const FaceSet& faces);
	std::size_t partByCost(const FaceSet& faces, std::size_t axis, float low, float high);
	std::size_t partInHalves(const FaceSet& faces, std::size_t axis);
	std::vector<FaceSet> partInFour(const FaceSet& faces);
	template <class Descend>
	std::uint32_t addNode(const FaceSet& faces, std::vector<FaceTreeNode>& nodes,
	                      Descend&& descend);
	std::uint32_t grow(const FaceSet& faces, Subtree& tree);
	std::uint32_t growTop(const FaceSet& faces, std::size_t most);
	std::uint32_t addBlock(const FaceSet& faces, Subtree& tree) const;
	void fillLane(std::uint32_t face, std::size_t lane, FaceBlock& block, Subtree& tree) const;
	void join(BuiltTree& out);

	const Points& points_;
	const IndexTriangles& triangles_;
	int threads_;
	Monitor& monitor_;
	TreeFrame frame_;
	HugeVector<FloatBox> boxes_;          // per face
	HugeVector<std::uint32_t> order_;     // faces
	std::vector<FaceTreeNode> topNodes_;  // whose children below the bit of blocks are nodes; and
	                                      // with it, subtrees
	std::vector<Subtree> subtrees_;
};

// The float box around a face, rounded outwards: a step of a float is more than what subtracting
// the centre rounds off.
Status Builder::prepare() {
	BoundingBox box{};
	Status status = findBoundingBox(points_.data(), points_.size(), threads_, monitor_, box);
	if (!status.ok()) {
		return status;
	}
	frame_.scale = unitScale(box);
	frame_.centre = frame_.scaled(box.centre());
	frame_.halfSize = box.halfSize() * frame_.scale;
	boxes_.resizeForOverwrite(triangles_.size());
	order_.resizeForOverwrite(triangles_.size());
	const auto setBoxes = [this](std::size_t begin, std::size_t end) {
		for (std::size_t face = begin; face < end; ++face) {
			FloatBox around;
			for (const std::uint32_t corner : triangles_[face]) {
				const Point place = minus(frame_.scaled(points_[corner]), frame_.centre);
				FloatBox at;
				for (std::size_t k = 0; k < 3; ++k) {
					at.lo[k] = std::nextafter(static_cast<float>(place[k]), -kInfinity);
					at.hi[k] = std::nextafter(static_cast<float>(place[k]), kInfinity);
				}
				around.add(at);
			}
			boxes_[face] = around;
			order_[face] = static_cast<std::uint32_t>(face);
		}
	};
	return parallelFor(triangles_.size(), kGrain, threads_, monitor_, setBoxes);
}

FloatBox Builder::boxOf(const FaceSet& faces) const {
	FloatBox box;
	for (std::size_t i = faces.begin; i < faces.end; ++i) {
		box.add(boxes_[order_[i]]);
	}
	return box;
}

// Parts a set in two. \return where the second one begins, neither is empty
std::size_t Builder::part(const FaceSet& faces) {
	std::array<float, 3> low{kInfinity, kInfinity, kInfinity};
	std::array<float, 3> high{-kInfinity, -kInfinity, -kInfinity};
	for (std::size_t i = faces.begin; i < faces.end; ++i) {
		for (std::size_t k = 0; k < 3; ++k) {
			const float middle = boxes_[order_[i]].twiceTheMiddle(k);
			low[k] = std::min(low[k], middle);
			high[k] = std::max(high[k], middle);
		}
	}
	std::size_t axis = 0;
	for (std::size_t k = 1; k < 3; ++k) {
		axis = high[k] - low[k] > high[axis] - low[axis] ? k : axis;
	}
	if (faces.count() <= kFewFaces || faces.depth >= kDepthOfHalves || !(high[axis] > low[axis])) {
		return partInHalves(faces, axis);
	}
	return partByCost(faces, axis, low[axis], high[axis]);
}

// Halves by the middles of boxes; the first one fills whole blocks.
std::size_t Builder::partInHalves(const FaceSet& faces, std::size_t axis) {
	const std::size_t half = (faces.count() / 2 + kLanes - 1) / kLanes * kLanes;
	const std::size_t middle = faces.begin + std::min(half, faces.count() - 1);
	const auto at = [this](std::size_t i) {
		return order_.begin() + static_cast<std::ptrdiff_t>(i);
	};
	std::nth_element(at(faces.begin), at(middle), at(faces.end),
	                 [this, axis](std::uint32_t a, std::uint32_t b) {
		                 return boxes_[a].twiceTheMiddle(axis) < boxes_[b].twiceTheMiddle(axis);
	                 });
	return middle;
}

std::size_t Builder::partByCost(const FaceSet& faces, std::size_t axis, float low, float high) {
	std::array<FloatBox, kBins> boxes;
	std::array<std::size_t, kBins> counts{};
	const float toBin = static_cast<float>(kBins) / (high - low);
	const auto binOf = [&](std::uint32_t face) {
		const float bin = (boxes_[face].twiceTheMiddle(axis) - low) * toBin;
		return bin < static_cast<float>(kBins - 1) ? static_cast<std::size_t>(bin) : kBins - 1;
	};
	for (std::size_t i = faces.begin; i < faces.end; ++i) {
		const std::size_t bin = binOf(order_[i]);
		boxes[bin].add(boxes_[order_[i]]);
		++counts[bin];
	}
	const auto costOf = [](const FloatBox& box, std::size_t count) {
		return count == 0 ? 0 : box.halfSurface() * static_cast<double>((count + 3) / kLanes);
	};
	std::array<double, kBins> costBehind{};  // of the bins from this one on
	FloatBox box;
	std::size_t count = 0;
	for (std::size_t bin = kBins - 1; bin > 0; --bin) {
		box.add(boxes[bin]);
		count += counts[bin];
		costBehind[bin] = costOf(box, count);
	}
	box = {};
	count = 0;
	std::size_t best = 0;
	double least = std::numeric_limits<double>::infinity();
	for (std::size_t bin = 1; bin < kBins; ++bin) {
		box.add(boxes[bin - 1]);
		count += counts[bin - 1];
		const double cost = costOf(box, count) + costBehind[bin];
		if (count > 0 && count < faces.count() && cost < least) {
			least = cost;
			best = bin;
		}
	}
	if (best == 0) {  // all are in one bin
		return partInHalves(faces, axis);
	}
	const auto at = [this](std::size_t i) {
		return order_.begin() + static_cast<std::ptrdiff_t>(i);
	};
	const auto second = std::partition(at(faces.begin), at(faces.end),
	                                   [&](std::uint32_t face) { return binOf(face) < best; });
	return static_cast<std::size_t>(second - order_.begin());
}

// Up to four parts, of which those with more than a block's faces are parted first.
std::vector<FaceSet> Builder::partInFour(const FaceSet& faces) {
	std::vector<FaceSet> parts{{faces.begin, faces.end, faces.depth + 1}};
	while (parts.size() < kLanes) {
		const auto largest =
		    std::max_element(parts.begin(), parts.end(), [](const FaceSet& a, const FaceSet& b) {
			    return a.count() < b.count();
		    });
		if (largest->count() <= kLanes) {
			break;
		}
		const std::size_t middle = part(*largest);
		const FaceSet second{middle, largest->end, largest->depth};
		largest->end = middle;
		parts.push_back(second);
	}
	return parts;
}

// \param descend descend(part) gives the child that a part becomes
template <class Descend>
std::uint32_t Builder::addNode(const FaceSet& faces, std::vector<FaceTreeNode>& nodes,
                               Descend&& descend) {
	const auto index = static_cast<std::uint32_t>(nodes.size());
	FaceTreeNode node{};
	for (std::size_t k = 0; k < kLanes; ++k) {
		node.child[k] = kNone;
		for (std::size_t axis = 0; axis < 3; ++axis) {
			node.lo[axis][k] = kInfinity;
			node.hi[axis][k] = -kInfinity;
		}
	}
	nodes.push_back(node);
	const std::vector<FaceSet> parts = partInFour(faces);
	for (std::size_t k = 0; k < parts.size(); ++k) {
		const FloatBox box = boxOf(parts[k]);
		for (std::size_t axis = 0; axis < 3; ++axis) {
			nodes[index].lo[axis][k] = box.lo[axis];
			nodes[index].hi[axis][k] = box.hi[axis];
		}
		const std::uint32_t child = descend(parts[k]);
		nodes[index].child[k] = child;
	}
	return index;
}

// What hangs below one node, on one thread.
std::uint32_t Builder::grow(const FaceSet& faces, Subtree& tree) {
	if (faces.count() <= kLanes || pollCancelled(monitor_)) {
		return addBlock({faces.begin, std::min(faces.end, faces.begin + kLanes), 0}, tree);
	}
	return addNode(faces, tree.nodes, [&](const FaceSet& part) { return grow(part, tree); });
}

// The nodes above sets of at most `most` faces, which become subtrees later.
std::uint32_t Builder::growTop(const FaceSet& faces, std::size_t most) {
	if (faces.count() <= most || pollCancelled(monitor_)) {
		subtrees_.emplace_back();
		subtrees_.back().faces = faces;
		return static_cast<std::uint32_t>(subtrees_.size() - 1) | FaceTreeNode::kBlockBit;
	}
	return addNode(faces, topNodes_, [&](const FaceSet& part) { return growTop(part, most); });
}

void Builder::fillLane(std::uint32_t face, std::size_t lane, FaceBlock& block,
                       Subtree& tree) const {
	constexpr double kTooShort = 0x1p-960;  // its square's roundings would be of no use
	const std::array<std::uint32_t, 3> vertices =
	    verticesByShape(points_, triangles_[face], frame_);
	const std::array<Point, 3> corners{frame_.scaled(points_[vertices[0]]),
	                                   frame_.scaled(points_[vertices[1]]),
	                                   frame_.scaled(points_[vertices[2]])};
	const Point first = minus(corners[1], corners[0]), second = minus(corners[2], corners[0]);
	const Point third = minus(second, first);
	const std::array<double, 3> squared{dot(first, first), dot(second, second), dot(third, third)};
	const bool isTooShort = *std::min_element(squared.begin(), squared.end()) < kTooShort;
	constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
	const Point normal =
	    isTooShort ? Point{kNaN, kNaN, kNaN} : unitNormal(corners[0], corners[1], corners[2]);
	for (std::size_t k = 0; k < 3; ++k) {
		block.origin[k][lane] = corners[0][k];
		block.first[k][lane] = first[k];
		block.second[k][lane] = second[k];
		block.normal[k][lane] = normal[k];
		block.inverse[k][lane] = squared[k] < kTooShort ? 0 : 1 / squared[k];
	}
	tree.longestSquared = std::max(tree.longestSquared, squared[2]);
}

std::uint32_t Builder::addBlock(const FaceSet& faces, Subtree& tree) const {
	FaceBlock block;
	for (std::size_t lane = 0; lane < kLanes; ++lane) {
		const bool isFace = lane < faces.count();
		const std::uint32_t face = order_[faces.begin + (isFace ? lane : 0)];
		block.face[lane] = isFace ? face : kNone;
		fillLane(face, lane, block, tree);
	}
	tree.blocks.push_back(block);
	return static_cast<std::uint32_t>(tree.blocks.size() - 1) | FaceTreeNode::kBlockBit;
}

// All parts in one numbering, the root first.
void Builder::join(BuiltTree& out) {
	std::size_t nodeCount = topNodes_.size(), blockCount = 0;
	for (const Subtree& tree : subtrees_) {
		nodeCount += tree.nodes.size();
		blockCount += tree.blocks.size();
	}
	out.nodes.reserve(nodeCount);
	out.blocks.reserve(blockCount);
	out.nodes = std::move(topNodes_);
	const std::size_t topCount = out.nodes.size();
	std::vector<std::uint32_t> roots;
	double longestSquared = 0;
	for (Subtree& tree : subtrees_) {
		const auto firstNode = static_cast<std::uint32_t>(out.nodes.size());
		const auto firstBlock = static_cast<std::uint32_t>(out.blocks.size());
		const auto moved = [=](std::uint32_t child) {
			const bool isBlock = (child & FaceTreeNode::kBlockBit) != 0;
			return child == kNone ? kNone : child + (isBlock ? firstBlock : firstNode);
		};
		for (FaceTreeNode& node : tree.nodes) {
			std::transform(node.child.begin(), node.child.end(), node.child.begin(), moved);
		}
		out.nodes.insert(out.nodes.end(), tree.nodes.begin(), tree.nodes.end());
		out.blocks.insert(out.blocks.end(), tree.blocks.begin(), tree.blocks.end());
		roots.push_back(moved(tree.root));
		longestSquared = std::max(longestSquared, tree.longestSquared);
		tree = {};
	}
	for (std::size_t i = 0; i < topCount; ++i) {
		for (std::uint32_t& child : out.nodes[i].child) {
			const bool isSubtree = child != kNone && (child & FaceTreeNode::kBlockBit) != 0;
			child = isSubtree ? roots[child & ~FaceTreeNode::kBlockBit] : child;
		}
	}
	out.frame = frame_;
	out.frame.longestEdge = std::sqrt(longestSquared);
}

Status Builder::run(BuiltTree& out) {
	constexpr std::size_t kSubtrees = 64, kLeast = 1 << 11;
	Status status = prepare();
	if (!status.ok()) {
		return status;
	}
	const std::size_t n = triangles_.size();
	const std::size_t most = std::max(std::min(std::max(n / kSubtrees, kLeast), n - 1), kLanes);
	growTop({0, n, 0}, most);
	if (topNodes_.empty()) {  // one block: the root is a node all the same
		const auto leave = [this](const FaceSet& part) { return growTop(part, kLanes); };
		subtrees_.clear();
		addNode({0, n, 0}, topNodes_, leave);
	}
	status = parallelFor(subtrees_.size(), 1, threads_, monitor_,
	                     [this](std::size_t begin, std::size_t end) {
		                     for (std::size_t i = begin; i < end; ++i) {
			                     subtrees_[i].root = grow(subtrees_[i].faces, subtrees_[i]);
		                     }
	                     });
	if (status.ok() && monitor_.cancelled()) {
		status.code = StatusCode::Cancelled;
	}
	if (status.ok()) {
		join(out);
	}
	return status;
}

}  // namespace

std::array<std::uint32_t, 3> verticesByShape(const Points& points, const IndexTriangle& triangle,
                                             const TreeFrame& frame) {
	std::array<std::uint32_t, 3> v = triangle;
	std::sort(v.begin(), v.end(),
	          [&points](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
	const auto squaredEdge = [&](std::size_t from, std::size_t to) {
		const Point edge = minus(frame.scaled(points[v[to]]), frame.scaled(points[v[from]]));
		return dot(edge, edge);
	};
	const std::array<double, 3> opposite{squaredEdge(1, 2), squaredEdge(0, 2), squaredEdge(0, 1)};
	const auto longest = std::max_element(opposite.begin(), opposite.end()) - opposite.begin();
	std::rotate(v.begin(), v.begin() + longest, v.begin() + longest + 1);
	return v;
}

Status buildFaceTree(const Points& points, const IndexTriangles& triangles, int threads,
                     Monitor& monitor, BuiltTree& out) {
	return Builder(points, triangles, threads, monitor).run(out);
}

}  // namespace index_boolean
