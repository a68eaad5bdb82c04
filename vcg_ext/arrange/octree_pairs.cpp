// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' triangles; out: all pairs of faces with boxes that meet, each once.
// Both operands descend through one octree that is never stored: a node is two lists of boxes.
// All tests are closed, so a pair reaches every leaf that its boxes' overlap reaches; the leaf that
// holds the overlap's low corner reports it. Leaves are half open, the root has no bounds.
// No octree parts the faces around a common vertex, but a second one does, which they descend by
// the directions in which they leave it. In the first one, their pairs are left aside.
// Nor does it part long faces that lie askew, with boxes that are mostly empty. Where a node stops
// for that, its pairs, and no others, are looked for in an octree of their own, about all that its
// boxes have in common: there, faces go to those children only that they reach themselves. A pair
// is reported by each leaf that both faces reach, and what is there twice goes in the end.
#include "vcg_ext/arrange/octree_pairs.h"

#include "vcg_ext/arrange/cell_clip.h"
#include "vcg_ext/arrange/common_fans.h"
#include "vcg_ext/arrange/face_boxes.h"
#include "vcg_ext/base/groups.h"
#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"

#include <functional>
#include <limits>
#include <new>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::uint64_t kCost = 12;          // all pairs of a leaf cost no more than one more split
constexpr std::uint64_t kClipCost = 8;       // clipping a face to its children costs so many pairs
constexpr std::size_t kSmallNode = 2048;     // faces of a node not worth to be shared by threads
constexpr std::size_t kLargeNode = 1 << 17;  // faces of a node that threads share
constexpr std::size_t kManyNodes = 64;       // nodes enough for all threads
constexpr std::size_t kPollPairs = 65536;    // pairs tested between two looks at the monitor

// For loops by all threads; not to be had inside such a loop.
struct Workers {
	int threads;
	Monitor& monitor;
};

struct BoxSpan {
	const FaceBox* first = nullptr;
	std::size_t size = 0;

	const FaceBox* begin() const { return first; }
	const FaceBox* end() const { return first + size; }
};

// A node of the octree with the faces of each operand that reach it.
struct Node {
	std::array<float, 3> low;  // of the corners that the node owns; -inf along the root's side
	std::array<float, 3> mid;
	float half;
	int depth;
	bool isClipped;  // its faces reach it themselves, and `low` is that of a node that owns the
	                 // pairs
	std::array<BoxSpan, 2> faces;

	std::size_t size() const { return faces[0].size + faces[1].size; }
	std::uint64_t pairs() const { return std::uint64_t{faces[0].size} * faces[1].size; }
};

// Memory for boxes, reused and never initialized.
class BoxBuffer {
public:
	FaceBox* reserve(std::size_t size) {
		if (size > boxes_.size()) {
			boxes_ = HugeVector<FaceBox>();  // before the larger one is there
			boxes_.resizeForOverwrite(size);
		}
		return boxes_.data();
	}

private:
	HugeVector<FaceBox> boxes_;
};

constexpr std::array<std::array<ChildSet, 4>, 3> kHalves = {{
    {0x00, 0x55, 0xaa, 0xff},  // none, lower, upper, both halves along x
    {0x00, 0x33, 0xcc, 0xff},
    {0x00, 0x0f, 0xf0, 0xff},
}};

// The children that a box reaches.
ChildSet childrenOf(const FaceBox& box, const std::array<float, 3>& mid) {
	unsigned children = 0xff;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const unsigned lower = box.lo[axis] < mid[axis] ? 1U : 0U;
		const unsigned upper = box.hi[axis] >= mid[axis] ? 2U : 0U;
		children &= kHalves[axis][lower | upper];
	}
	return static_cast<ChildSet>(children);
}

// For each set the lowest child in it.
constexpr std::array<std::uint8_t, 256> makeLowestChild() {
	std::array<std::uint8_t, 256> lowest{};
	for (unsigned set = 1; set < 256; ++set) {
		while ((set >> lowest[set] & 1U) == 0) {
			++lowest[set];
		}
	}
	return lowest;
}
constexpr std::array<std::uint8_t, 256> kLowestChild = makeLowestChild();

template <class Visit>
void forEachChild(ChildSet set, Visit visit) {
	for (unsigned rest = set; rest != 0; rest &= rest - 1) {
		visit(static_cast<std::size_t>(kLowestChild[rest]));
	}
}

using ChildCounts = std::array<std::size_t, 8>;

// Whether a box reaches four children or more: if anything does, then its inside leaves some out.
constexpr bool reachesMany(ChildSet set) {
	const unsigned withoutOne = set & (set - 1U);
	const unsigned withoutTwo = withoutOne & (withoutOne - 1U);
	return (withoutTwo & (withoutTwo - 1U)) != 0;
}

// Which children each box of a range reaches, by childrenOf(box), and how many boxes reach each.
template <class ChildrenOf>
ChildCounts countChildren(const BoxSpan& boxes, ChildrenOf&& childrenOfBox, ChildSet* sets) {
	// By set first: no loop over the children of a box, whose number no processor can guess.
	std::array<std::size_t, 256> ofSet{};
	for (std::size_t i = 0; i < boxes.size; ++i) {
		sets[i] = childrenOfBox(boxes.first[i]);
		++ofSet[sets[i]];
	}
	ChildCounts counts{};
	for (unsigned set = 1; set < ofSet.size(); ++set) {
		if (ofSet[set] != 0) {
			forEachChild(static_cast<ChildSet>(set),
			             [&](std::size_t child) { counts[child] += ofSet[set]; });
		}
	}
	return counts;
}

// The split of one node: which boxes go to which children.
class NodeSplit {
public:
	// Counts the boxes of all children. \return false if splitting does not help
	bool count(const Node& node) { return countIn(node, node.size(), nullptr, nullptr); }

	// The same with children that faces reach themselves.
	bool countClipped(const Node& node, const CellClip& clip) {
		return countIn(node, node.size(), nullptr, &clip);
	}

	// The same by all threads. Where that fails, nothing that follows is of use; see status().
	bool countTogether(const Node& node, const Workers& workers) {
		return countIn(node, kChunk, &workers, nullptr) && status_.ok();
	}

	// Writes the boxes of the living children to `buffer` and appends the children to `out`, by
	// all threads if they have been counted so.
	void distribute(const Node& node, BoxBuffer& buffer, std::vector<Node>& out);

	// Ok, or how the work of all threads ended: Cancelled, OutOfMemory, InternalError.
	const Status& status() const { return status_; }

private:
	static constexpr std::size_t kChunk = 1 << 15;

	bool countIn(const Node& node, std::size_t grain, const Workers* workers, const CellClip* clip);
	ChildCounts countPart(const Node& node, const BoxSpan& boxes, ChildSet* sets) const;
	bool helps(const Node& node) const;

	// Calls body(chunk, begin, end) for all chunks of n boxes.
	template <class Body>
	void forEachChunk(std::size_t n, Body&& body) {
		if (workers_ == nullptr) {
			body(std::size_t{0}, std::size_t{0}, n);
		} else if (status_.ok()) {
			status_ = parallelForChunks(n, grain_, workers_->threads, workers_->monitor, body);
		}
	}

	const Workers* workers_ = nullptr;
	const CellClip* clip_ = nullptr;
	Status status_;
	std::size_t grain_ = 0;
	std::array<std::vector<ChildSet>, 2> sets_;      // for each box
	std::array<std::vector<ChildCounts>, 2> parts_;  // for each chunk of boxes
	std::array<ChildCounts, 2> counts_{};
	ChildSet living_ = 0;  // children with boxes of both operands
};

ChildCounts NodeSplit::countPart(const Node& node, const BoxSpan& boxes, ChildSet* sets) const {
	if (clip_ == nullptr) {
		return countChildren(
		    boxes, [&](const FaceBox& box) { return childrenOf(box, node.mid); }, sets);
	}
	const OctreeCell cell{node.mid, node.half};
	return countChildren(
	    boxes,
	    [&](const FaceBox& box) {
		    const ChildSet set = childrenOf(box, node.mid);
		    return reachesMany(set) ? clip_->reached({box.face}, set, cell) : set;
	    },
	    sets);
}

bool NodeSplit::countIn(const Node& node, std::size_t grain, const Workers* workers,
                        const CellClip* clip) {
	workers_ = workers;
	clip_ = clip;
	grain_ = grain;
	counts_ = {};
	for (std::size_t k = 0; k < 2; ++k) {
		const BoxSpan& faces = node.faces[k];
		sets_[k].resize(std::max(sets_[k].size(), faces.size));
		parts_[k].resize(workers == nullptr ? 1 : chunkCount(faces.size, grain));
		forEachChunk(faces.size, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			parts_[k][chunk] =
			    countPart(node, {faces.first + begin, end - begin}, &sets_[k][begin]);
		});
		for (const ChildCounts& part : parts_[k]) {
			for (std::size_t child = 0; child < 8; ++child) {
				counts_[k][child] += part[child];
			}
		}
	}
	living_ = 0;
	for (unsigned child = 0; child < 8; ++child) {
		if (counts_[0][child] != 0 && counts_[1][child] != 0) {
			living_ = static_cast<ChildSet>(living_ | 1U << child);
		}
	}
	return helps(node);
}

// A split helps if it halves the pairs to be tested or hardly repeats a face: faces around one
// common vertex stay together however often they are split. Clipping must save what it costs.
bool NodeSplit::helps(const Node& node) const {
	std::uint64_t pairs = 0;
	std::uint64_t boxes = 0;
	forEachChild(living_, [&](std::size_t child) {
		pairs += std::uint64_t{counts_[0][child]} * counts_[1][child];
		boxes += counts_[0][child] + counts_[1][child];
	});
	if (clip_ != nullptr) {
		return pairs + kClipCost * boxes <= node.pairs();
	}
	return pairs <= node.pairs() / 2 || 4 * boxes <= 5 * std::uint64_t{node.size()};
}

Node childNode(const Node& node, std::size_t child) {
	Node result = node;
	result.half = node.half / 2;
	++result.depth;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const bool upper = (child >> axis & 1U) != 0;
		if (upper && !node.isClipped) {
			result.low[axis] = node.mid[axis];
		}
		result.mid[axis] = node.mid[axis] + (upper ? result.half : -result.half);
	}
	return result;
}

void NodeSplit::distribute(const Node& node, BoxBuffer& buffer, std::vector<Node>& out) {
	std::size_t total = 0;
	forEachChild(living_, [&](std::size_t c) { total += counts_[0][c] + counts_[1][c]; });
	FaceBox* next = buffer.reserve(total);
	std::array<std::array<FaceBox*, 8>, 2> ends{};
	forEachChild(living_, [&](std::size_t child) {
		Node result = childNode(node, child);
		for (std::size_t k = 0; k < 2; ++k) {
			ends[k][child] = next;
			result.faces[k] = {next, counts_[k][child]};
			next += counts_[k][child];
		}
		out.push_back(result);
	});
	for (std::size_t k = 0; k < 2; ++k) {
		std::vector<std::array<FaceBox*, 8>> begins;
		for (const ChildCounts& part : parts_[k]) {
			begins.push_back(ends[k]);
			forEachChild(living_, [&](std::size_t child) { ends[k][child] += part[child]; });
		}
		const BoxSpan& faces = node.faces[k];
		forEachChunk(faces.size, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			std::array<FaceBox*, 8> to = begins[chunk];
			for (std::size_t i = begin; i < end; ++i) {
				forEachChild(static_cast<ChildSet>(sets_[k][i] & living_),
				             [&](std::size_t child) { *to[child]++ = faces.first[i]; });
			}
		});
	}
}

// A node with the pairs of another one, about all that the boxes of both operands have in common
// there, in which faces are clipped.
Node clippedNode(const Node& node) {
	Node result = node;
	result.isClipped = true;
	std::array<std::array<float, 3>, 2> lowest{}, highest{};
	for (std::size_t k = 0; k < 2; ++k) {
		lowest[k] = node.faces[k].first->lo;
		highest[k] = node.faces[k].first->hi;
		for (const FaceBox& box : node.faces[k]) {
			for (std::size_t axis = 0; axis < 3; ++axis) {
				lowest[k][axis] = std::min(lowest[k][axis], box.lo[axis]);
				highest[k][axis] = std::max(highest[k][axis], box.hi[axis]);
			}
		}
	}
	result.half = 0;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const float low = std::max(lowest[0][axis], lowest[1][axis]);
		const float high = std::min(highest[0][axis], highest[1][axis]);
		result.mid[axis] = (low + high) / 2;
		result.half = std::max(result.half, (high - low) / 2);
	}
	return result;
}

// How nodes are to be searched.
struct Search {
	const Options& options;
	Monitor& monitor;
	const CommonFans* fans;  // of which no pair need be visited; null if there is none
	const CellClip* clip;    // null if the boxes are not those of the faces
};

// The fan with the most pairs in a node, if these are more than one more split costs; else kNone.
std::uint32_t widestFan(const CommonFans& fans, const Node& node) {
	std::array<std::vector<std::uint32_t>, 2> found;  // of each face
	for (std::size_t k = 0; k < 2; ++k) {
		for (const FaceBox& box : node.faces[k]) {
			fans.forEachFan({box.face}, [&](std::uint32_t fan) { found[k].push_back(fan); });
		}
		std::sort(found[k].begin(), found[k].end());
	}
	std::uint64_t most = kCost * node.size();
	std::uint32_t widest = kNone;
	forEachGroup(found[0].begin(), found[0].end(), std::equal_to<std::uint32_t>(),
	             [&](auto first, auto last) {
		             const auto others = std::equal_range(found[1].begin(), found[1].end(), *first);
		             const auto pairs = static_cast<std::uint64_t>(last - first) *
		                                static_cast<std::uint64_t>(others.second - others.first);
		             if (pairs > most) {
			             most = pairs;
			             widest = *first;
		             }
	             });
	return widest;
}

// A node from which one fan after another is taken.
class FanParting {
public:
	FanParting(const CommonFans& fans, const Node& node) : fans_(fans), rest_(node) {
		boxes_.reserve(node.size());
		for (BoxSpan& faces : rest_.faces) {
			const FaceBox* const first = boxes_.data() + boxes_.size();
			boxes_.insert(boxes_.end(), faces.begin(), faces.end());
			faces.first = first;
		}
	}

	// Takes the first operand's faces of a fan out of the node. \return them, with the second
	// operand's faces that are not of the fan: valid until the next call
	Node take(std::uint32_t fan) {
		const auto isOfFan = [&](const FaceBox& box) { return fans_.has(fan, {box.face}); };
		Node taken = rest_;
		taken.faces[0].size = moveFirst(rest_.faces[0], isOfFan);
		taken.faces[1].size =
		    moveFirst(rest_.faces[1], [&](const FaceBox& box) { return !isOfFan(box); });
		rest_.faces[0].first += taken.faces[0].size;
		rest_.faces[0].size -= taken.faces[0].size;
		return taken;
	}

	// The node without what has been taken.
	const Node& rest() const { return rest_; }

private:
	// \return how many there are of those that are moved to the front
	template <class IsFirst>
	std::size_t moveFirst(const BoxSpan& faces, IsFirst&& isFirst) {
		FaceBox* const first = boxes_.data() + (faces.first - boxes_.data());
		return static_cast<std::size_t>(std::partition(first, first + faces.size, isFirst) - first);
	}

	const CommonFans& fans_;
	HugeVector<FaceBox> boxes_;
	Node rest_;
};

// Descends below one node and visits the pairs of all leaves. One object per thread's chunk.
template <class Visit>
class Descent {
public:
	Descent(const Search& search, Visit visitPair)
	    : options_(search.options), monitor_(search.monitor), fans_(search.fans),
	      clip_(search.clip), visitPair_(visitPair) {}

	void visit(const Node& node);

private:
	void visitChildren(const Node& node);
	bool visitWithoutFans(const Node& node);
	bool visitClipped(const Node& node);
	void scan(const Node& node);
	void scanAll(const Node& node);
	void sweep(const Node& node);
	void test(const Node& node, const FaceBox& a, const FaceBox& b);
	bool stopped();

	const Options& options_;
	Monitor& monitor_;
	const CommonFans* fans_;
	const CellClip* clip_;
	Visit visitPair_;
	NodeSplit split_;
	std::array<BoxBuffer, 21> buffers_;           // one per depth
	std::array<std::vector<Node>, 21> children_;  // one per depth
	std::array<HugeVector<FaceBox>, 2> sorted_;
	std::size_t tested_ = 0;
};

bool isLeaf(const Node& node, const Options& options) {
	if (node.depth >= std::min(options.octreeMaxDepth, 20)) {
		return true;
	}
	if (options.octreeLeafSize == 0) {
		return node.pairs() <= kCost * node.size();
	}
	const auto leafSize = static_cast<std::uint64_t>(options.octreeLeafSize);
	return node.pairs() <= leafSize * leafSize;
}

template <class Visit>
void Descent<Visit>::visit(const Node& node) {
	const bool isLast = isLeaf(node, options_);
	if (!isLast && split_.count(node)) {
		visitChildren(node);
	} else if (!visitWithoutFans(node) && (isLast || !visitClipped(node))) {
		scan(node);
	}
}

// \pre the split of the node has been counted
template <class Visit>
void Descent<Visit>::visitChildren(const Node& node) {
	const auto depth = static_cast<std::size_t>(node.depth);
	std::vector<Node>& children = children_[depth];
	children.clear();
	split_.distribute(node, buffers_[depth], children);
	for (const Node& child : children) {
		if (stopped()) {
			return;
		}
		visit(child);
	}
}

// Visits a node in parts without the pairs of its widest fans. The parts may be worth more splits.
// \return false if it has no such fan; then nothing has been visited
template <class Visit>
bool Descent<Visit>::visitWithoutFans(const Node& node) {
	if (fans_ == nullptr || node.pairs() <= kCost * node.size()) {
		return false;
	}
	std::uint32_t fan = widestFan(*fans_, node);
	if (fan == kNone) {
		return false;
	}
	FanParting parting(*fans_, node);
	for (; fan != kNone && !stopped(); fan = widestFan(*fans_, parting.rest())) {
		tested_ += node.size();
		visit(parting.take(fan));
	}
	if (!stopped()) {
		visit(parting.rest());
	}
	return true;
}

// Visits the children of a node with those faces only that reach them.
// \return false if that does not help; then nothing has been visited
template <class Visit>
bool Descent<Visit>::visitClipped(const Node& node) {
	constexpr std::uint64_t kWorthBeginning = 4;  // mostly, few pairs are just not worth a split
	const std::uint64_t most = (node.isClipped ? kCost : kWorthBeginning * kCost) * node.size();
	if (clip_ == nullptr || node.pairs() <= most) {
		return false;
	}
	const Node clipped = node.isClipped ? node : clippedNode(node);
	if (!split_.countClipped(clipped, *clip_)) {
		return false;
	}
	tested_ += node.size();
	visitChildren(clipped);
	return true;
}

template <class Visit>
bool Descent<Visit>::stopped() {
	if (tested_ < kPollPairs) {
		return monitor_.cancelled();
	}
	tested_ = 0;
	return pollCancelled(monitor_);
}

template <class Visit>
void Descent<Visit>::scan(const Node& node) {
	tested_ += node.size();
	if (node.pairs() <= kCost * node.size()) {
		scanAll(node);
	} else {
		sweep(node);
	}
}

template <class Visit>
void Descent<Visit>::scanAll(const Node& node) {
	for (const FaceBox& a : node.faces[0]) {
		for (const FaceBox& b : node.faces[1]) {
			test(node, a, b);
		}
	}
}

// Visits the pair if the boxes meet and the low corner of their overlap is this node's. That corner
// lies below the node's upper sides, as both boxes do.
template <class Visit>
void Descent<Visit>::test(const Node& node, const FaceBox& a, const FaceBox& b) {
	bool meet = true;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const float corner = std::max(a.lo[axis], b.lo[axis]);
		meet &= corner <= a.hi[axis];
		meet &= corner <= b.hi[axis];
		meet &= corner >= node.low[axis];
	}
	if (meet) {
		visitPair_(FacePair{{a.face}, {b.face}});
	}
}

// The axis along which the boxes are the shortest, compared with the room that they take.
std::size_t sweepAxis(const Node& node) {
	std::array<double, 3> lowest, highest, length{};
	lowest.fill(std::numeric_limits<double>::infinity());
	highest.fill(-std::numeric_limits<double>::infinity());
	for (const BoxSpan& faces : node.faces) {
		for (const FaceBox& box : faces) {
			for (std::size_t axis = 0; axis < 3; ++axis) {
				lowest[axis] = std::min<double>(lowest[axis], box.lo[axis]);
				highest[axis] = std::max<double>(highest[axis], box.hi[axis]);
				length[axis] += static_cast<double>(box.hi[axis]) - box.lo[axis];
			}
		}
	}
	std::size_t best = 0;
	for (std::size_t axis = 1; axis < 3; ++axis) {
		const double room = highest[axis] - lowest[axis];
		if (room * length[best] > (highest[best] - lowest[best]) * length[axis]) {
			best = axis;
		}
	}
	return best;
}

// Tests the boxes that meet along one axis only: each box, from low to high, against those of the
// other operand that begin after it and before its end.
template <class Visit>
void Descent<Visit>::sweep(const Node& node) {
	const std::size_t axis = sweepAxis(node);
	for (std::size_t k = 0; k < 2; ++k) {
		sorted_[k].assign(node.faces[k].begin(), node.faces[k].end());
		std::sort(sorted_[k].begin(), sorted_[k].end(),
		          [axis](const FaceBox& p, const FaceBox& q) { return p.lo[axis] < q.lo[axis]; });
	}
	auto a = sorted_[0].cbegin();
	auto b = sorted_[1].cbegin();
	while (a != sorted_[0].cend() && b != sorted_[1].cend() && !stopped()) {
		if (a->lo[axis] <= b->lo[axis]) {
			auto other = b;
			for (; other != sorted_[1].cend() && other->lo[axis] <= a->hi[axis]; ++other) {
				test(node, *a, *other);
			}
			tested_ += static_cast<std::size_t>(other - b);
			++a;
		} else {
			auto other = a;
			for (; other != sorted_[0].cend() && other->lo[axis] <= b->hi[axis]; ++other) {
				test(node, *other, *b);
			}
			tested_ += static_cast<std::size_t>(other - a);
			++b;
		}
	}
}

Node makeRoot(const HugeVector<FaceBox>& a, const HugeVector<FaceBox>& b, float halfSize) {
	Node root{};
	root.low.fill(-std::numeric_limits<float>::infinity());
	root.half = halfSize;
	root.faces = {BoxSpan{a.data(), a.size()}, BoxSpan{b.data(), b.size()}};
	return root;
}

// A frontier of the tree: nodes that own all pairs between them, and the memory of their boxes.
struct Frontier {
	std::vector<Node> nodes;
	std::vector<std::unique_ptr<BoxBuffer>> buffers;
};

// What replaces one node of a frontier: its children, or itself.
struct Expansion {
	std::vector<Node> nodes;
	std::unique_ptr<BoxBuffer> buffer;

	void split(const Node& node, NodeSplit& counted) {
		buffer = std::make_unique<BoxBuffer>();
		counted.distribute(node, *buffer, nodes);
	}
};

// Replaces the large nodes by their children: the largest ones by all threads together, the others
// side by side.
Status expand(const Options& options, Monitor& monitor, Frontier& frontier) {
	const std::size_t count = frontier.nodes.size();
	const Workers workers{options.threads, monitor};
	std::vector<Expansion> expansions(count);
	for (std::size_t i = 0; i < count && !monitor.cancelled(); ++i) {
		const Node& node = frontier.nodes[i];
		NodeSplit split;
		if (node.size() >= kLargeNode && !isLeaf(node, options) &&
		    split.countTogether(node, workers)) {
			expansions[i].split(node, split);
		}
		if (!split.status().ok()) {
			return split.status();
		}
	}
	const Status status = parallelForChunks(
	    count, 1, options.threads, monitor, [&](std::size_t i, std::size_t, std::size_t) {
		    const Node& node = frontier.nodes[i];
		    NodeSplit split;
		    if (!expansions[i].nodes.empty()) {
			    return;
		    }
		    if (node.size() < kSmallNode || node.size() >= kLargeNode || isLeaf(node, options) ||
		        !split.count(node)) {
			    expansions[i].nodes.push_back(node);
		    } else {
			    expansions[i].split(node, split);
		    }
	    });
	frontier.nodes.clear();
	for (Expansion& expansion : expansions) {
		frontier.nodes.insert(frontier.nodes.end(), expansion.nodes.begin(), expansion.nodes.end());
		frontier.buffers.push_back(std::move(expansion.buffer));
	}
	return status;
}

using PairLists = std::vector<std::vector<FacePair>>;

// Sorts by a (counting), then by b.
void sortPairs(const PairLists& parts, std::size_t facesOfA, std::vector<FacePair>& out) {
	std::vector<std::size_t> ends(facesOfA + 1, 0);
	for (const auto& part : parts) {
		for (const FacePair& pair : part) {
			++ends[pair.a.value + 1];
		}
	}
	std::partial_sum(ends.begin(), ends.end(), ends.begin());
	out.resize(ends.back());
	for (const auto& part : parts) {
		for (const FacePair& pair : part) {
			out[ends[pair.a.value]++] = pair;
		}
	}
	const auto byB = [](const FacePair& p, const FacePair& q) { return p.b < q.b; };
	std::size_t begin = 0;
	for (const std::size_t end : ends) {
		using Difference = std::vector<FacePair>::difference_type;
		if (end > begin + 1) {
			std::sort(out.begin() + static_cast<Difference>(begin),
			          out.begin() + static_cast<Difference>(end), byB);
		}
		begin = std::max(begin, end);
	}
}

// Divides the tree below the root into nodes enough for all threads.
Status makeFrontier(const Node& root, const Options& options, Monitor& monitor, Frontier& out) {
	Status status;
	out.nodes.push_back(root);
	for (int level = 0; level < 3 && out.nodes.size() < kManyNodes && status.ok(); ++level) {
		status = expand(options, monitor, out);
	}
	return status;
}

// Visits the pairs below each node i of the frontier with makeVisit(i).
template <class MakeVisit>
Status descend(const Frontier& frontier, const Search& search, MakeVisit makeVisit) {
	return parallelForChunks(frontier.nodes.size(), 1, search.options.threads, search.monitor,
	                         [&](std::size_t i, std::size_t, std::size_t) {
		                         Descent(search, makeVisit(i)).visit(frontier.nodes[i]);
	                         });
}

// Keeps the pairs of which neither face's plane parts the faces. Most faces near the other operand
// lie beside its faces, not across: what goes here is never stored, sorted or looked at again.
// Pairs of a fan go too.
class PlaneSieve {
public:
	PlaneSieve(const MeshArrays& mesh, const CommonFans* fans, std::vector<FacePair>& kept)
	    : mesh_(mesh), fans_(fans), kept_(kept) {}

	void operator()(FacePair pair) {
		if (fans_ != nullptr && fans_->share(pair)) {
			return;
		}
		// Pairs come in runs with one face of the first operand.
		if (pair.a != faceOfFilter_) {
			faceOfFilter_ = pair.a;
			filter_ = filterOf(pair.a);
		}
		const bool parted = parts(filter_, pair.b) || parts(filterOf(pair.b), pair.a);
		countSign(Predicate::PairSieve, parted ? DecidedBy::Double : DecidedBy::Undecided);
		if (!parted) {
			kept_.push_back(pair);
		}
	}

private:
	const Point& corner(FaceId face, std::size_t i) const {
		return at(mesh_.points, at(mesh_.triangles, face)[i]);
	}
	PlaneFilter filterOf(FaceId face) const {
		return {corner(face, 0), corner(face, 1), corner(face, 2)};
	}
	bool parts(const PlaneFilter& plane, FaceId face) const {
		return plane.parts(corner(face, 0), corner(face, 1), corner(face, 2));
	}

	const MeshArrays& mesh_;
	const CommonFans* fans_;
	std::vector<FacePair>& kept_;
	FaceId faceOfFilter_ = FaceId::none();
	PlaneFilter filter_{{}, {}, {}};
};

// Adds the pairs of a fan's faces that may meet elsewhere than in its vertex; and as many others as
// it takes for each face to have a pair, since the vertex is a contact of all of them.
Status addPairsOfFan(const MeshArrays& mesh, const CommonFan& fan, const Search& search,
                     PairLists& lists) {
	std::vector<FacePair>& star = lists.emplace_back();
	for (const FaceId a : fan.faces[kFirst]) {
		star.push_back({a, fan.faces[kSecond].front()});
	}
	for (const FaceId b : fan.faces[kSecond]) {
		star.push_back({fan.faces[kFirst].front(), b});
	}
	const HugeVector<FaceBox> boxesOfA = boxesOfDirections(mesh, fan, kFirst);
	const HugeVector<FaceBox> boxesOfB = boxesOfDirections(mesh, fan, kSecond);
	Frontier frontier;
	const Status status = makeFrontier(makeRoot(boxesOfA, boxesOfB, kDirectionsHalfSize),
	                                   search.options, search.monitor, frontier);
	const std::size_t first = lists.size();
	lists.resize(first + frontier.nodes.size());
	const auto makeVisit = [&](std::size_t i) {
		return [&kept = lists[first + i]](FacePair pair) { kept.push_back(pair); };
	};
	return status.ok() ? descend(frontier, search, makeVisit) : status;
}

// The same for all fans. A pair is added more than once if the faces have two fans in common.
Status addPairsOfFans(const MeshArrays& mesh, const CommonFans& fans, const Search& search,
                      PairLists& lists) {
	Status status;
	for (std::size_t i = 0; i < fans.fans().size() && status.ok(); ++i) {
		status = addPairsOfFan(mesh, fans.fans()[i], search, lists);
	}
	return status;
}

// The steps of findPairs, which adds the guard against running out of memory between regions.
Status findPairsUnguarded(const MeshArrays& mesh, const Options& options, Monitor& monitor,
                          std::vector<FacePair>& out) {
	FaceBoxes boxes;
	Status status = collectFaceBoxes(mesh, options.threads, monitor, boxes);
	if (!status.ok() || boxes.operand[kFirst].empty() || boxes.operand[kSecond].empty()) {
		return status;
	}
	const CommonFans commonFans(mesh, boxes);
	const CommonFans* const fans = commonFans.empty() ? nullptr : &commonFans;
	const CellClip clip(mesh, boxes.frame);
	Frontier frontier;
	PairLists lists;
	const auto makeVisit = [&](std::size_t i) { return PlaneSieve(mesh, fans, lists[i]); };
	status = inOrder(
	    [&] {
		    return makeFrontier(
		        makeRoot(boxes.operand[kFirst], boxes.operand[kSecond], boxes.frame.halfSize),
		        options, monitor, frontier);
	    },
	    [&] {
		    lists.resize(frontier.nodes.size());
		    return descend(frontier, {options, monitor, fans, &clip}, makeVisit);
	    },
	    [&] {
		    return addPairsOfFans(mesh, commonFans, {options, monitor, nullptr, nullptr}, lists);
	    });
	if (status.ok()) {
		sortPairs(lists, mesh.faceOffsets.begin(kSecond), out);
	}
	out.erase(std::unique(out.begin(), out.end()), out.end());
	return status;
}

}  // namespace

Status findPairs(const MeshArrays& mesh, const Options& options, Monitor& monitor,
                 std::vector<FacePair>& out) {
	const FpEnvironmentGuard environment;
	out.clear();
	try {
		return findPairsUnguarded(mesh, options, monitor, out);
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

}  // namespace index_boolean
