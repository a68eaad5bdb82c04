// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: them, sorted by the Morton code of where they lie. A radix sort, stable and by
// slices, of which each thread has one.
// Source: Morton 1966; Lauterbach et al. 2009 (boxes of boxes over sorted codes).
#include "vcg_ext/arrange/face_order.h"

#include "vcg_ext/base/morton.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

// The codes of the middles of eight faces' boxes, with 2^bits cells along each axis of the frame.
void findCodes(const EightFaces& eight, unsigned bits, std::array<std::uint32_t, 8>& out) {
	out.fill(0);
	const float cells = static_cast<float>(1U << bits) / 4;
	const auto last = static_cast<float>((1U << bits) - 1);
	for (unsigned axis = 0; axis < 3; ++axis) {
		for (std::size_t i = 0; i < 8; ++i) {
			const float a = eight.place[0][axis][i], b = eight.place[1][axis][i],
			            c = eight.place[2][axis][i];
			const float lo = a < b ? a : b, hi = a < b ? b : a;
			const float twiceTheMiddle = (c < lo ? c : lo) + (c > hi ? c : hi);
			const float cell = (twiceTheMiddle + 2) * cells;
			const auto whole = static_cast<std::int32_t>(cell < last ? cell : last);
			out[i] |= spreadBits(static_cast<std::uint32_t>(whole)) << axis;
		}
	}
}

// Cells small enough that few faces have one code, in as few passes as that takes.
unsigned bitsFor(std::size_t faceCount) { return faceCount > 2'000'000 ? 10 : 8; }

constexpr unsigned kDigitBits = 12, kDigits = 1U << kDigitBits;

// Sorts by the 12 bits from `shift` on. \param to of the same size
Status sortByDigit(const HugeVector<std::uint64_t>& from, unsigned shift, int threads,
                   Monitor& monitor, HugeVector<std::uint64_t>& to) {
	const auto workers = static_cast<std::size_t>(mostWorkers(threads));
	const std::size_t slice = std::max(kGrain, chunkCount(from.size(), workers));
	std::vector<std::array<std::uint32_t, kDigits>> ends(chunkCount(from.size(), slice));
	const auto digitOf = [shift](std::uint64_t item) {
		return static_cast<std::size_t>(item >> shift & (kDigits - 1));
	};
	const auto count = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		ends[chunk].fill(0);
		for (std::size_t i = begin; i < end; ++i) {
			++ends[chunk][digitOf(from[i])];
		}
	};
	const auto move = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			to[ends[chunk][digitOf(from[i])]++] = from[i];
		}
	};
	Status status = parallelForChunks(from.size(), slice, threads, monitor, count);
	if (!status.ok()) {
		return status;
	}
	std::uint32_t sum = 0;
	for (std::size_t digit = 0; digit < kDigits; ++digit) {
		for (auto& part : ends) {
			sum += part[digit];
			part[digit] = sum - part[digit];
		}
	}
	return parallelForChunks(from.size(), slice, threads, monitor, move);
}

}  // namespace

Status orderFaces(const SearchedSurface& surface, Monitor& monitor, FaceOrder& out) {
	const std::size_t count = surface.faces.count();
	const unsigned bits = bitsFor(count);
	const auto setItems = [&](std::size_t first, std::size_t end) {
		EightFaces eight;
		std::array<std::uint32_t, 8> codes;
		for (std::size_t face = first; face < end; face += 8) {
			const std::size_t few = std::min<std::size_t>(8, end - face);
			gatherEight(
			    surface.faces, surface.points, few, [face](std::size_t i) { return face + i; },
			    eight);
			findCodes(eight, bits, codes);
			for (std::size_t i = 0; i < few; ++i) {
				out.items[face + i] = std::uint64_t{codes[i]} << 32U | (face + i);
			}
		}
	};
	out.items.resizeForOverwrite(count);
	Status status = parallelFor(count, kGrain, surface.threads, monitor, setItems);
	auto other = HugeVector<std::uint64_t>::forOverwrite(count);
	for (unsigned shift = 32; shift < 32 + 3 * bits && status.ok(); shift += kDigitBits) {
		status = sortByDigit(out.items, shift, surface.threads, monitor, other);
		out.items.swap(other);
	}
	return status;
}

}  // namespace index_boolean
