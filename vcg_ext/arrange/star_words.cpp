// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: certified stars. One pass over the faces, eight at a time, gathers a word a
// vertex: for each direction along an axis whether a face is not certainly turned that way, for
// each coordinate whether links come up through the vertex once, and again. Slices of the faces
// have words of their own, so that no word is written by two threads.
#include "vcg_ext/arrange/star_words.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/zero_area.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

// The bits of a word, from the low one on, each for x, y, z: a face that does not certainly turn
// counter-clockwise seen against the axis; one that does not certainly turn clockwise; the link
// comes up once; again. Then: there is a suspect face.
using Word = std::uint16_t;
constexpr unsigned kOnce = 6, kAgain = 9;
constexpr unsigned kAxes = 7, kNoTurn = 63, kSuspect = 1U << 12U;

constexpr std::size_t kMostSlices = 8;
constexpr std::size_t kLeastSlice = 1 << 14;
constexpr std::size_t kPoll = 1 << 15;  // faces between two looks at the monitor
constexpr std::size_t kGrain = 1 << 15;

// Both of two words about one vertex.
unsigned joined(unsigned a, unsigned b) {
	const unsigned both = a & b & (kAxes << kOnce);
	return a | b | both << (kAgain - kOnce);
}

// What eight faces add to the words of their corners, but for suspects.
struct EightWords {
	std::array<std::uint32_t, 8> turns{};                  // of all three corners
	std::array<std::array<std::uint32_t, 8>, 3> comeUp{};  // by corner
};

void findTurns(const EightFaces& eight, EightWords& out) {
	std::array<std::array<float, 8>, 3> u, w;
	std::array<float, 8> bound{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		for (std::size_t i = 0; i < 8; ++i) {
			u[axis][i] = eight.place[1][axis][i] - eight.place[0][axis][i];
			w[axis][i] = eight.place[2][axis][i] - eight.place[0][axis][i];
			bound[i] += std::fabs(u[axis][i]) + std::fabs(w[axis][i]);
		}
	}
	for (std::size_t i = 0; i < 8; ++i) {
		bound[i] = bound[i] * (0x1p-22F + bound[i] * 0x1p-23F) + 0x1p-40F;
	}
	for (unsigned axis = 0; axis < 3; ++axis) {
		const unsigned x = (axis + 1) % 3, y = (axis + 2) % 3;
		for (std::size_t i = 0; i < 8; ++i) {
			const float n = u[x][i] * w[y][i] - u[y][i] * w[x][i];
			out.turns[i] |= (n > bound[i] ? 0U : 1U << axis) | (n < -bound[i] ? 0U : 8U << axis);
		}
	}
}

// Where the link, from the next corner to the one before, comes from below a corner to not below.
void findLinks(const EightFaces& eight, EightWords& out) {
	for (std::size_t corner = 0; corner < 3; ++corner) {
		const auto& at = eight.place[corner];
		const auto& from = eight.place[(corner + 1) % 3];
		const auto& to = eight.place[(corner + 2) % 3];
		for (unsigned axis = 0; axis < 3; ++axis) {
			for (std::size_t i = 0; i < 8; ++i) {
				const std::uint32_t isFromBelow = from[axis][i] < at[axis][i] ? 1U : 0U;
				const std::uint32_t isToAbove = to[axis][i] >= at[axis][i] ? 1U : 0U;
				out.comeUp[corner][i] |= (isFromBelow & isToAbove) << (kOnce + axis);
			}
		}
	}
}

// The words that one slice of the faces gives.
class Slice {
public:
	explicit Slice(const SearchedSurface& surface) : surface_(surface) {}

	// Takes in the faces [begin, end); stops where the run is cancelled.
	void take(std::size_t begin, std::size_t end, Monitor& monitor) {
		words_.assign(surface_.points.points.size(), 0);
		std::size_t poll = begin;
		for (std::size_t first = begin; first < end; first += 8) {
			takeEight(first, std::min<std::size_t>(8, end - first));
			if (first - poll >= kPoll) {
				poll = first;
				if (pollCancelled(monitor)) {
					return;
				}
			}
		}
	}

	unsigned word(std::size_t i) const { return words_[i]; }
	const std::vector<std::uint32_t>& zeroAreaFaces() const { return zeroAreaFaces_; }

private:
	void takeEight(std::size_t first, std::size_t count) {
		EightFaces eight;
		gatherEight(
		    surface_.faces, surface_.points, count, [first](std::size_t i) { return first + i; },
		    eight);
		EightWords found;
		findTurns(eight, found);
		findLinks(eight, found);
		for (std::size_t i = 0; i < count; ++i) {
			const auto face = static_cast<std::uint32_t>(first + i);
			const unsigned suspect = surface_.suspects(face) ? kSuspect : 0U;
			for (std::size_t corner = 0; corner < 3; ++corner) {
				Word& word = words_[eight.vertex[corner][i] - surface_.points.first];
				word = static_cast<Word>(
				    joined(word, found.turns[i] | found.comeUp[corner][i] | suspect));
			}
			if (found.turns[i] == kNoTurn) {
				lookAtArea(face);
			}
		}
	}

	void lookAtArea(std::uint32_t face) {
		const FacesView& faces = surface_.faces;
		const IndexTriangle t = faces[face];
		if (hasZeroArea(faces.point(t[0]), faces.point(t[1]), faces.point(t[2]))) {
			zeroAreaFaces_.push_back(face);
		}
	}

	const SearchedSurface& surface_;
	HugeVector<Word> words_;
	std::vector<std::uint32_t> zeroAreaFaces_;
};

// Whether along an axis all faces turn one way and the link comes up once, by the next coordinate.
bool isCertified(unsigned word) {
	const unsigned oneWay = ~(word & word >> 3U);
	const unsigned once = word >> kOnce & ~(word >> kAgain) & kAxes;
	const unsigned onceByNext = once >> 1U | once << 2U;
	return (oneWay & onceByNext & kAxes) != 0;
}

// Sets the stars of the points [begin, end). \param open vertices that are left are added
void setStars(const std::vector<Slice>& slices, std::size_t begin, std::size_t end,
              SearchedSurface& surface, std::vector<std::uint32_t>& open) {
	for (std::size_t i = begin; i < end; ++i) {
		unsigned word = 0;
		for (const Slice& slice : slices) {
			word = joined(word, slice.word(i));
		}
		const auto vertex = surface.points.first + static_cast<std::uint32_t>(i);
		const bool isBalanced = surface.isUnbalanced.empty() || surface.isUnbalanced[i] == 0;
		const bool isOpen = (word & kSuspect) != 0 && !(isBalanced && isCertified(word));
		surface.points.points[i].star = isOpen ? kNone : vertex;
		if (isOpen) {
			open.push_back(vertex);
		}
	}
}

void append(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& some) {
	all.insert(all.end(), some.begin(), some.end());
}

}  // namespace

Status certifyStars(SearchedSurface& surface, Monitor& monitor, WordsLeave& out) {
	out = {};
	const std::size_t faceCount = surface.faces.count(), pointCount = surface.points.points.size();
	const std::size_t most =
	    std::min(static_cast<std::size_t>(mostWorkers(surface.threads)), kMostSlices);
	const std::size_t sliceSize = std::max(kLeastSlice, chunkCount(faceCount, most));
	std::vector<Slice> slices(chunkCount(faceCount, sliceSize), Slice(surface));
	std::vector<std::vector<std::uint32_t>> open(chunkCount(pointCount, kGrain));
	const auto takeSlice = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		slices[chunk].take(begin, end, monitor);
	};
	const auto setSome = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		setStars(slices, begin, end, surface, open[chunk]);
	};
	const Status status = inOrder(
	    [&] {
		    return parallelForChunks(faceCount, sliceSize, surface.threads, monitor, takeSlice);
	    },
	    [&] { return parallelForChunks(pointCount, kGrain, surface.threads, monitor, setSome); });
	for (const Slice& slice : slices) {
		append(out.zeroAreaFaces, slice.zeroAreaFaces());
	}
	for (const std::vector<std::uint32_t>& part : open) {
		append(out.openStars, part);
	}
	surface.isZeroArea.assign(out.zeroAreaFaces.empty() ? 0 : faceCount, 0);
	for (const std::uint32_t face : out.zeroAreaFaces) {
		surface.isZeroArea[face] = 1;
	}
	return status;
}

}  // namespace index_boolean
