// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Most vertices are alone in their place. Two passes over the points, by a table of bits that the
// processor's caches hold, rule out nearly all of these; the others are compared exactly.
#include "vcg_ext/mesh/corner_weld.h"

#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/vertex_table.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;
constexpr double kMax = std::numeric_limits<double>::max();

// Where a vertex sets its bits.
struct PlaceBits {
	std::size_t cell;
	std::uint64_t mask;
};

// The places of both operands' vertices: each sets two bits of a word of its operand. Threads add
// at the same time.
class PlaceSieve {
public:
	// A word for four to eight vertices of the larger operand.
	explicit PlaceSieve(std::size_t vertexCount) {
		while (vertexCount >> shift_ > 8) {
			++shift_;
		}
		cells_ = std::vector<Cell>(std::size_t{1} << shift_);
	}

	// From the upper half of a sum of products, since coordinates may end in many zeros; the same
	// for 0 and -0. Lets the processor fetch what add() and mayShare() need.
	PlaceBits bitsOf(const Point& p) const {
		constexpr std::array<std::uint64_t, 3> kFactors{0x9e3779b97f4a7c15U, 0xd6e8feb86659fd93U,
		                                                0xa0761d6478bd642fU};
		std::uint64_t hash = 0;
		for (std::size_t axis = 0; axis < 3; ++axis) {
			const double unsignedZero = p[axis] + 0.0;
			std::uint64_t bits;
			std::memcpy(&bits, &unsignedZero, sizeof bits);
			hash += (bits ^ bits >> 32) * kFactors[axis];
		}
		constexpr std::uint64_t kOne = 1;
		const auto cell = static_cast<std::size_t>(hash >> 12 >> (52 - shift_));
#ifdef __GNUC__
		__builtin_prefetch(&cells_[cell], 1);
#endif
		return {cell, kOne << (hash >> 26 & 63) | kOne << (hash >> 20 & 63)};
	}

	// Of two vertices that are added with the same bits, at the same time or not, one finds them.
	void add(OperandId operand, PlaceBits bits) {
		Cell& cell = cells_[bits.cell];
		if (set(cell.once[operand.value], bits.mask)) {
			set(cell.twice[operand.value], bits.mask);
		}
	}

	// Once all are added: whether this one may have another in its place.
	bool mayShare(OperandId operand, PlaceBits bits) const {
		const Cell& cell = cells_[bits.cell];
		return has(cell.twice[operand.value], bits.mask) ||
		       has(cell.once[otherOf(operand).value], bits.mask);
	}

private:
	using Word = std::atomic<std::uint64_t>;
	struct Cell {  // per operand: the bits that any vertex has set, and that two have
		std::array<Word, 2> once, twice;
	};

	static bool has(const Word& word, std::uint64_t mask) {
		return (word.load(std::memory_order_relaxed) & mask) == mask;
	}

	// \return whether the bits had been set before
	static bool set(Word& word, std::uint64_t mask) {
		std::uint64_t before = word.load(std::memory_order_relaxed);
		if ((before & mask) != mask) {
			before = word.fetch_or(mask, std::memory_order_relaxed);
		}
		return (before & mask) == mask;
	}

	unsigned shift_ = 4;
	std::vector<Cell> cells_;
};

// Calls body(operand, begin, end) for chunks of both operands' vertices.
template <class Body>
Status forEachVertexRange(const MeshArrays& mesh, int threads, Monitor& monitor, Body&& body) {
	const std::size_t second = mesh.vertexOffsets.begin(kSecond);
	return parallelFor(mesh.points.size(), kGrain, threads, monitor,
	                   [&](std::size_t begin, std::size_t end) {
		                   body(kFirst, begin, std::min(end, second));
		                   body(kSecond, std::max(begin, second), end);
	                   });
}

// Calls use(vertex, bits) for the vertices [begin, end): the memory of some of them is asked for
// before the first is waited for.
template <class Use>
void askAhead(const Points& points, std::size_t begin, std::size_t end, const PlaceSieve& sieve,
              Use&& use) {
	constexpr std::size_t kAhead = 16;
	std::array<PlaceBits, kAhead> bits{};
	for (std::size_t first = begin; first < end; first += kAhead) {
		const std::size_t count = std::min(kAhead, end - first);
		for (std::size_t i = 0; i < count; ++i) {
			bits[i] = sieve.bitsOf(points[first + i]);
		}
		for (std::size_t i = 0; i < count; ++i) {
			use(first + i, bits[i]);
		}
	}
}

}  // namespace

Status CornerWelder::findSuspects(double most, bool& inRange) {
	const Points& points = mesh_.points;
	const std::size_t second = mesh_.vertexOffsets.begin(kSecond);
	PlaceSieve sieve(std::max(second, points.size() - second));
	std::atomic<bool> allInRange{true};
	const auto add = [&](OperandId operand, std::size_t begin, std::size_t end) {
		bool within = true;
		askAhead(points, begin, end, sieve, [&](std::size_t v, PlaceBits bits) {
			within &= isWithin(points[v], most);
			sieve.add(operand, bits);
		});
		if (!within) {
			allInRange = false;
		}
	};
	std::vector<std::vector<std::uint32_t>> found(2 * chunkCount(points.size(), kGrain));
	const auto find = [&](OperandId operand, std::size_t begin, std::size_t end) {
		askAhead(points, begin, end, sieve, [&](std::size_t v, PlaceBits bits) {
			if (sieve.mayShare(operand, bits) && isWithin(points[v], kMax)) {
				found[2 * (v / kGrain) + operand.value].push_back(static_cast<std::uint32_t>(v));
			}
		});
	};
	Status status = forEachVertexRange(mesh_, threads_, monitor_, add);
	if (status.ok()) {
		status = forEachVertexRange(mesh_, threads_, monitor_, find);
	}
	inRange = allInRange;
	for (std::size_t i = 0; i < found.size(); ++i) {
		std::vector<std::uint32_t>& suspects = suspects_[makeId<OperandTag>(i % 2)];
		suspects.insert(suspects.end(), found[i].begin(), found[i].end());
	}
	return status;
}

// Replaces each corner of the faces from firstFace on.
Status CornerWelder::replaceCorners(const std::vector<Move>& moves, std::size_t firstFace) {
	if (moves.empty()) {
		return {};
	}
	auto canonical = HugeVector<VertexId>::forOverwrite(mesh_.points.size());
	Status status = parallelFor(mesh_.points.size(), kGrain, threads_, monitor_,
	                            [&canonical](std::size_t begin, std::size_t end) {
		                            for (std::size_t v = begin; v < end; ++v) {
			                            canonical[v] = makeId<VertexTag>(v);
		                            }
	                            });
	for (const Move& move : moves) {
		canonical[move.vertex] = {move.to};
	}
	if (!status.ok()) {
		return status;
	}
	return parallelFor(mesh_.triangles.size() - firstFace, kGrain, threads_, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t f = firstFace + begin; f < firstFace + end; ++f) {
			                   for (VertexId& v : mesh_.triangles[f]) {
				                   v = at(canonical, v);
			                   }
		                   }
	                   });
}

Status CornerWelder::weldWithinOperands(PerOperand<bool>& welded) {
	PerOperand<std::vector<Move>> moves;
	const int halves =
	    threadsForHalves(suspects_[kFirst].size() + suspects_[kSecond].size(), threads_);
	const Status status =
	    parallelFor(2, 1, halves, monitor_, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t k = begin; k < end; ++k) {
			    const auto operand = makeId<OperandTag>(k);
			    VertexTable table(mesh_.points, suspects_[operand].size());
			    for (const std::uint32_t v : suspects_[operand]) {
				    const std::uint32_t first = table.findOrAdd(v);
				    if (first != v) {
					    moves[operand].push_back({v, first});
				    }
			    }
		    }
	    });
	std::vector<Move>& all = moves[kFirst];
	welded = {!all.empty(), !moves[kSecond].empty()};
	all.insert(all.end(), moves[kSecond].begin(), moves[kSecond].end());
	return status.ok() ? replaceCorners(all, 0) : status;
}

// Per vertex of the first operand: a face of it has a corner there.
std::vector<bool> CornerWelder::usedByFirst() const {
	std::vector<bool> used(mesh_.vertexOffsets.begin(kSecond), false);
	for (std::size_t face = 0; face < mesh_.faceOffsets.begin(kSecond); ++face) {
		for (const VertexId v : mesh_.triangles[face]) {
			used[v.value] = true;
		}
	}
	return used;
}

Status CornerWelder::weldSecondToFirst() {
	VertexTable first(mesh_.points, suspects_[kFirst].size());
	for (const std::uint32_t v : suspects_[kFirst]) {
		first.findOrAdd(v);
	}
	std::vector<Move> moves;
	for (const std::uint32_t v : suspects_[kSecond]) {
		const std::uint32_t twin = first.vertexAt(mesh_.points[v]);
		if (twin != IndexTable::kNone) {
			moves.push_back({v, twin});
		}
	}
	if (moves.empty()) {
		return {};
	}
	const std::vector<bool> used = usedByFirst();
	const auto isUnused = [&used](const Move& move) { return !used[move.to]; };
	moves.erase(std::remove_if(moves.begin(), moves.end(), isUnused), moves.end());
	return replaceCorners(moves, mesh_.faceOffsets.begin(kSecond));
}

}  // namespace index_boolean
