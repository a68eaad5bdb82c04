// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the root down: a set of faces is parted where the surfaces of the two boxes, times how many
// blocks are in them, are least. The upper nodes are made level by level, what hangs below them is
// grown by one thread each.
#include "vcg_ext/distance/face_tree_builder.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/distance/unit_normal.h"
#include "vcg_ext/exact/unit_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

// Items [begin .. end) of the builder's, and the box around them.
struct FaceSet {
	std::size_t begin, end, depth;
	FloatBox box;

	std::size_t count() const { return end - begin; }
};

// What a node's children are made of.
struct Parts {
	std::array<FaceSet, kLanes> part;
	std::size_t count = 1;
};

using FacesOfBlock = std::array<std::uint32_t, kLanes>;

// A part of the tree in numberings of its own.
struct Subtree {
	FaceSet faces{};
	std::vector<FaceTreeNode> nodes;
	std::vector<FacesOfBlock> blocks;  // the first face of each again in lanes that have none
	std::uint32_t root = kNone;
};

class Builder {
public:
	Builder(const Points& points, const IndexTriangles& triangles, int threads, Monitor& monitor)
	    : points_(points), triangles_(triangles), threads_(threads), monitor_(monitor) {}

	Status run(BuiltTree& out);

private:
	// A face, together with what it is sorted by, as sets are gone through from end to end.
	struct Item {
		FloatBox box;
		std::uint32_t face;
		std::uint32_t unused;
	};

	Status prepare();
	FloatBox boxOf(std::size_t begin, std::size_t end) const;
	void part(FaceSet& faces, FaceSet& second);
	bool partByCost(FaceSet& faces, FaceSet& second, std::size_t axis, const FloatBox& middles);
	void partInHalves(FaceSet& faces, FaceSet& second, std::size_t axis);
	Parts partInFour(const FaceSet& faces);
	std::uint32_t grow(const FaceSet& faces, Subtree& tree);
	std::uint32_t addBlock(const FaceSet& faces, Subtree& tree) const;
	Status growTop(std::size_t most);
	std::uint32_t addToTop(const FaceSet& faces, std::size_t most,
	                       std::vector<std::pair<FaceSet, std::uint32_t>>& waiting);
	void join(BuiltTree& out, std::vector<FacesOfBlock>& faces);
	Status fillBlocks(const std::vector<FacesOfBlock>& faces, BuiltTree& out) const;
	double fillLane(std::uint32_t face, std::size_t lane, FaceBlock& block) const;

	const Points& points_;
	const IndexTriangles& triangles_;
	int threads_;
	Monitor& monitor_;
	TreeFrame frame_;
	HugeVector<Item> items_;
	std::vector<FaceTreeNode> topNodes_;  // whose children below the bit of blocks are nodes; and
	                                      // with it, subtrees
	std::vector<Subtree> subtrees_;
};

// A float below and one above: at least a step away, which is more than what subtracting the centre
// rounds off.
float below(float f) { return f - (std::fabs(f) * 0x1p-23F + std::numeric_limits<float>::min()); }
float above(float f) { return f + (std::fabs(f) * 0x1p-23F + std::numeric_limits<float>::min()); }

Status Builder::prepare() {
	BoundingBox box{};
	Status status = findBoundingBox(points_.data(), points_.size(), threads_, monitor_, box);
	if (!status.ok()) {
		return status;
	}
	frame_.scale = unitScale(box);
	frame_.centre = frame_.scaled(box.centre());
	frame_.halfSize = box.halfSize() * frame_.scale;
	items_.resizeForOverwrite(triangles_.size());
	const auto setItems = [this](std::size_t begin, std::size_t end) {
		for (std::size_t face = begin; face < end; ++face) {
			FloatBox around;
			for (const std::uint32_t corner : triangles_[face]) {
				const Point place = minus(frame_.scaled(points_[corner]), frame_.centre);
				FloatBox at;
				for (std::size_t k = 0; k < 3; ++k) {
					at.lo[k] = at.hi[k] = static_cast<float>(place[k]);
				}
				around.add(at);
			}
			for (std::size_t k = 0; k < 3; ++k) {
				around.lo[k] = below(around.lo[k]);
				around.hi[k] = above(around.hi[k]);
			}
			items_[face] = {around, static_cast<std::uint32_t>(face), 0};
		}
	};
	return parallelFor(triangles_.size(), kGrain, threads_, monitor_, setItems);
}

FloatBox Builder::boxOf(std::size_t begin, std::size_t end) const {
	FloatBox box;
	for (std::size_t i = begin; i < end; ++i) {
		box.add(items_[i].box);
	}
	return box;
}

// Parts a set in two, neither of which is empty. What is left of it is the first one.
void Builder::part(FaceSet& faces, FaceSet& second) {
	FloatBox middles;  // twice
	for (std::size_t i = faces.begin; i < faces.end; ++i) {
		FloatBox middle;
		for (std::size_t k = 0; k < 3; ++k) {
			middle.lo[k] = middle.hi[k] = items_[i].box.twiceTheMiddle(k);
		}
		middles.add(middle);
	}
	const auto widthAlong = [&](std::size_t k) { return middles.hi[k] - middles.lo[k]; };
	std::size_t axis = 0;
	for (std::size_t k = 1; k < 3; ++k) {
		axis = widthAlong(k) > widthAlong(axis) ? k : axis;
	}
	second.end = faces.end;
	second.depth = faces.depth;
	if (faces.count() <= kFewFaces || faces.depth >= kDepthOfHalves || !(widthAlong(axis) > 0) ||
	    !partByCost(faces, second, axis, middles)) {
		partInHalves(faces, second, axis);
	}
}

// Halves by the middles of boxes; the first one fills whole blocks.
void Builder::partInHalves(FaceSet& faces, FaceSet& second, std::size_t axis) {
	const std::size_t half = (faces.count() / 2 + kLanes - 1) / kLanes * kLanes;
	const std::size_t middle = faces.begin + std::min(half, faces.count() - 1);
	Item* const items = items_.data();
	std::nth_element(items + faces.begin, items + middle, items + faces.end,
	                 [axis](const Item& a, const Item& b) {
		                 return a.box.twiceTheMiddle(axis) < b.box.twiceTheMiddle(axis);
	                 });
	second.begin = faces.end = middle;
	faces.box = boxOf(faces.begin, middle);
	second.box = boxOf(middle, second.end);
}

// \return false, and nothing is done, if no division leaves something on both sides
bool Builder::partByCost(FaceSet& faces, FaceSet& second, std::size_t axis,
                         const FloatBox& middles) {
	std::array<FloatBox, kBins> boxes;
	std::array<std::size_t, kBins> counts{};
	const float low = middles.lo[axis];
	const float toBin = static_cast<float>(kBins) / (middles.hi[axis] - low);
	const auto binOf = [&](const Item& item) {
		const float bin = (item.box.twiceTheMiddle(axis) - low) * toBin;
		return bin < static_cast<float>(kBins - 1) ? static_cast<std::size_t>(bin) : kBins - 1;
	};
	for (std::size_t i = faces.begin; i < faces.end; ++i) {
		const std::size_t bin = binOf(items_[i]);
		boxes[bin].add(items_[i].box);
		++counts[bin];
	}
	const auto costOf = [](const FloatBox& box, std::size_t count) {
		return count == 0 ? 0 : box.halfSurface() * static_cast<double>((count + 3) / kLanes);
	};
	std::array<FloatBox, kBins> behind;  // of the bins from this one on
	FloatBox box;
	for (std::size_t bin = kBins - 1; bin > 0; --bin) {
		box.add(boxes[bin]);
		behind[bin] = box;
	}
	box = {};
	std::size_t count = 0, best = 0;
	double least = std::numeric_limits<double>::infinity();
	for (std::size_t bin = 1; bin < kBins; ++bin) {
		box.add(boxes[bin - 1]);
		count += counts[bin - 1];
		const double cost = costOf(box, count) + costOf(behind[bin], faces.count() - count);
		if (count > 0 && count < faces.count() && cost < least) {
			least = cost;
			best = bin;
			faces.box = box;
		}
	}
	if (best == 0) {
		return false;
	}
	second.box = behind[best];
	Item* const items = items_.data();
	Item* const middle = std::partition(items + faces.begin, items + faces.end,
	                                    [&](const Item& item) { return binOf(item) < best; });
	second.begin = faces.end = static_cast<std::size_t>(middle - items);
	return true;
}

// Up to four parts, of which those with more than a block's faces are parted first.
Parts Builder::partInFour(const FaceSet& faces) {
	Parts parts;
	parts.part[0] = faces;
	++parts.part[0].depth;
	while (parts.count < kLanes) {
		const auto largest = std::max_element(
		    parts.part.begin(), parts.part.begin() + parts.count,
		    [](const FaceSet& a, const FaceSet& b) { return a.count() < b.count(); });
		if (largest->count() <= kLanes) {
			break;
		}
		part(*largest, parts.part[parts.count++]);
	}
	return parts;
}

// A node without children yet.
FaceTreeNode nodeOf(const Parts& parts) {
	const FloatBox none;
	FaceTreeNode node{};
	for (std::size_t k = 0; k < kLanes; ++k) {
		const FloatBox& box = k < parts.count ? parts.part[k].box : none;
		node.child[k] = kNone;
		for (std::size_t axis = 0; axis < 3; ++axis) {
			node.lo[axis][k] = box.lo[axis];
			node.hi[axis][k] = box.hi[axis];
		}
	}
	return node;
}

// What hangs below one node, on one thread.
std::uint32_t Builder::grow(const FaceSet& faces, Subtree& tree) {
	if (faces.count() <= kLanes || pollCancelled(monitor_)) {
		return addBlock(faces, tree);
	}
	const Parts parts = partInFour(faces);
	const auto index = static_cast<std::uint32_t>(tree.nodes.size());
	tree.nodes.push_back(nodeOf(parts));
	for (std::size_t k = 0; k < parts.count; ++k) {
		const std::uint32_t child = grow(parts.part[k], tree);
		tree.nodes[index].child[k] = child;
	}
	return index;
}

std::uint32_t Builder::addBlock(const FaceSet& faces, Subtree& tree) const {
	FacesOfBlock block;
	for (std::size_t lane = 0; lane < kLanes; ++lane) {
		block[lane] = items_[faces.begin + (lane < faces.count() ? lane : 0)].face;
	}
	tree.blocks.push_back(block);
	return static_cast<std::uint32_t>(tree.blocks.size() - 1) | FaceTreeNode::kBlockBit;
}

// A set becomes a node that waits for its children, or a subtree.
std::uint32_t Builder::addToTop(const FaceSet& faces, std::size_t most,
                                std::vector<std::pair<FaceSet, std::uint32_t>>& waiting) {
	if (faces.count() <= most) {
		subtrees_.emplace_back();
		subtrees_.back().faces = faces;
		return static_cast<std::uint32_t>(subtrees_.size() - 1) | FaceTreeNode::kBlockBit;
	}
	const auto index = static_cast<std::uint32_t>(topNodes_.size());
	topNodes_.emplace_back();
	waiting.emplace_back(faces, index);
	return index;
}

// The nodes above sets of at most `most` faces, level by level; the sets of a level are parted on
// all threads.
Status Builder::growTop(std::size_t most) {
	std::vector<std::pair<FaceSet, std::uint32_t>> level, next;  // with the nodes
	const std::size_t n = items_.size();
	topNodes_.emplace_back();
	level.emplace_back(FaceSet{0, n, 0, boxOf(0, n)}, 0);  // the root is a node, always
	Status status;
	while (!level.empty() && status.ok()) {
		std::vector<Parts> parts(level.size());
		status = parallelFor(level.size(), 1, threads_, monitor_,
		                     [&](std::size_t begin, std::size_t end) {
			                     for (std::size_t i = begin; i < end; ++i) {
				                     parts[i] = partInFour(level[i].first);
			                     }
		                     });
		next.clear();
		for (std::size_t i = 0; i < level.size() && status.ok(); ++i) {
			FaceTreeNode node = nodeOf(parts[i]);
			for (std::size_t k = 0; k < parts[i].count; ++k) {
				node.child[k] = addToTop(parts[i].part[k], most, next);
			}
			topNodes_[level[i].second] = node;
		}
		std::swap(level, next);
	}
	return status;
}

// \return the square of the longest edge
double Builder::fillLane(std::uint32_t face, std::size_t lane, FaceBlock& block) const {
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
	return squared[2];
}

// All parts in one numbering, the root first.
void Builder::join(BuiltTree& out, std::vector<FacesOfBlock>& faces) {
	std::size_t nodeCount = topNodes_.size(), blockCount = 0;
	for (const Subtree& tree : subtrees_) {
		nodeCount += tree.nodes.size();
		blockCount += tree.blocks.size();
	}
	out.nodes = std::move(topNodes_);
	out.nodes.reserve(nodeCount);
	faces.reserve(blockCount);
	const std::size_t topCount = out.nodes.size();
	std::vector<std::uint32_t> roots;
	for (Subtree& tree : subtrees_) {
		const auto firstNode = static_cast<std::uint32_t>(out.nodes.size());
		const auto firstBlock = static_cast<std::uint32_t>(faces.size());
		const auto moved = [=](std::uint32_t child) {
			const bool isBlock = (child & FaceTreeNode::kBlockBit) != 0;
			return child == kNone ? kNone : child + (isBlock ? firstBlock : firstNode);
		};
		for (FaceTreeNode& node : tree.nodes) {
			std::transform(node.child.begin(), node.child.end(), node.child.begin(), moved);
		}
		out.nodes.insert(out.nodes.end(), tree.nodes.begin(), tree.nodes.end());
		faces.insert(faces.end(), tree.blocks.begin(), tree.blocks.end());
		roots.push_back(moved(tree.root));
		tree = {};
	}
	for (std::size_t i = 0; i < topCount; ++i) {
		for (std::uint32_t& child : out.nodes[i].child) {
			const bool isSubtree = child != kNone && (child & FaceTreeNode::kBlockBit) != 0;
			child = isSubtree ? roots[child & ~FaceTreeNode::kBlockBit] : child;
		}
	}
}

// Blocks are large: each is written once, where it stays.
Status Builder::fillBlocks(const std::vector<FacesOfBlock>& faces, BuiltTree& out) const {
	constexpr std::size_t kBlocks = 1 << 9;
	out.blocks.resizeForOverwrite(faces.size());
	std::vector<double> longestSquared(chunkCount(faces.size(), kBlocks), 0);
	const auto fill = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			for (std::size_t lane = 0; lane < kLanes; ++lane) {
				const std::uint32_t face = faces[i][lane];
				const double squared = fillLane(face, lane, out.blocks[i]);
				longestSquared[chunk] = std::max(longestSquared[chunk], squared);
				const bool isAgain = lane > 0 && face == faces[i][0];
				out.blocks[i].face[lane] = isAgain ? kNone : face;
			}
		}
	};
	const Status status = parallelForChunks(faces.size(), kBlocks, threads_, monitor_, fill);
	out.frame = frame_;
	out.frame.longestEdge =
	    std::sqrt(*std::max_element(longestSquared.begin(), longestSquared.end()));
	return status;
}

Status Builder::run(BuiltTree& out) {
	constexpr std::size_t kSubtrees = 64, kLeast = 1 << 11;
	const std::size_t most = std::max(triangles_.size() / kSubtrees, kLeast);
	std::vector<FacesOfBlock> faces;
	const auto growSubtrees = [this](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			subtrees_[i].root = grow(subtrees_[i].faces, subtrees_[i]);
		}
	};
	return inOrder(
	    [&] { return prepare(); }, [&] { return growTop(most); },
	    [&] { return parallelFor(subtrees_.size(), 1, threads_, monitor_, growSubtrees); },
	    [&] {
		    Status status;
		    if (monitor_.cancelled()) {  // and the subtrees are not whole
			    status.code = StatusCode::Cancelled;
		    }
		    return status;
	    },
	    [&] {
		    join(out, faces);
		    return fillBlocks(faces, out);
	    });
}

}  // namespace

std::array<std::uint32_t, 3> verticesByShape(const Points& points, const IndexTriangle& triangle,
                                             const TreeFrame& frame) {
	std::array<std::uint32_t, 3> v = triangle;
	const auto isBefore = [&points](std::uint32_t a, std::uint32_t b) {
		return points[a] < points[b];
	};
	const auto squaredEdge = [&](std::size_t from, std::size_t to) {
		const Point edge = minus(frame.scaled(points[v[to]]), frame.scaled(points[v[from]]));
		return dot(edge, edge);
	};
	const std::array<double, 3> opposite{squaredEdge(1, 2), squaredEdge(0, 2), squaredEdge(0, 1)};
	std::size_t first = 0;
	for (std::size_t k = 1; k < 3; ++k) {
		const bool isFirst = opposite[k] > opposite[first] ||
		                     (opposite[k] == opposite[first] && isBefore(v[k], v[first]));
		first = isFirst ? k : first;
	}
	std::swap(v[0], v[first]);
	if (isBefore(v[2], v[1])) {
		std::swap(v[1], v[2]);
	}
	return v;
}

Status buildFaceTree(const Points& points, const IndexTriangles& triangles, int threads,
                     Monitor& monitor, BuiltTree& out) {
	return Builder(points, triangles, threads, monitor).run(out);
}

}  // namespace index_boolean
