// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: them, or groups of eight, sorted by the Morton code of where they lie. A radix
// sort, stable and by slices, of which each thread has one.
// Source: Morton 1966; Lauterbach et al. 2009 (boxes of boxes over sorted codes).
#include "vcg_ext/arrange/face_order.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

struct FloatBox {
	std::array<float, 3> lo{2, 2, 2}, hi{-2, -2, -2};

	void add(const std::array<float, 3>& p) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			lo[axis] = std::min(lo[axis], p[axis]);
			hi[axis] = std::max(hi[axis], p[axis]);
		}
	}
	float size() const { return (hi[0] - lo[0]) + (hi[1] - lo[1]) + (hi[2] - lo[2]); }
};

void addFace(const FacesView& faces, const FramePoints& points, std::size_t face, FloatBox& box) {
	for (const std::uint32_t v : faces[face]) {
		box.add(points[v].place);
	}
}

// Whether the boxes of eight faces that follow each other are, in a sample, less than so many times
// as large as those of the faces: eight faces side by side have about three times their size.
bool liesTogether(const FacesView& faces, const FramePoints& points) {
	constexpr double kTimes = 3.6;
	constexpr std::size_t kSample = 256;
	const std::size_t groups = faces.count() / 8;
	double single = 0, together = 0;
	for (std::size_t k = 0; k < std::min(groups, kSample); ++k) {
		const std::size_t first = groups <= kSample ? 8 * k : groups / kSample * k * 8;
		FloatBox all;
		for (std::size_t face = first; face < first + 8; ++face) {
			FloatBox box;
			addFace(faces, points, face, box);
			addFace(faces, points, face, all);
			single += box.size();
		}
		together += 8 * all.size();
	}
	return together <= kTimes * single;
}

// Moves each of the low 10 bits of a number to three times its place.
std::uint32_t spread(std::uint32_t x) {
	x = (x | x << 16U) & 0x030000ffU;
	x = (x | x << 8U) & 0x0300f00fU;
	x = (x | x << 4U) & 0x030c30c3U;
	return (x | x << 2U) & 0x09249249U;
}

// The code of the middle of a face's box, with 2^bits cells along each axis of the frame.
std::uint64_t codeOf(const FacesView& faces, const FramePoints& points, std::size_t face,
                     unsigned bits) {
	FloatBox box;
	addFace(faces, points, face, box);
	const float cells = static_cast<float>(1U << bits) / 4;
	std::uint32_t code = 0;
	for (unsigned axis = 0; axis < 3; ++axis) {
		const float middle = (box.lo[axis] + box.hi[axis] + 2) * cells;
		const auto cell = std::min(static_cast<std::uint32_t>(middle), (1U << bits) - 1);
		code |= spread(cell) << axis;
	}
	return code;
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
	const FacesView& faces = surface.faces;
	const FramePoints& points = surface.points;
	out.asGiven = liesTogether(faces, points);
	const std::size_t step = out.asGiven ? 8 : 1;
	const unsigned bits = bitsFor(faces.count());
	out.items.resizeForOverwrite(chunkCount(faces.count(), step));
	Status status = parallelFor(out.items.size(), kGrain, surface.threads, monitor,
	                            [&](std::size_t begin, std::size_t end) {
		                            for (std::size_t i = begin; i < end; ++i) {
			                            out.items[i] =
			                                codeOf(faces, points, step * i, bits) << 32U | i;
		                            }
	                            });
	auto other = HugeVector<std::uint64_t>::forOverwrite(out.items.size());
	for (unsigned shift = 32; shift < 32 + 3 * bits && status.ok(); shift += kDigitBits) {
		status = sortByDigit(out.items, shift, surface.threads, monitor, other);
		out.items.swap(other);
	}
	return status;
}

}  // namespace index_boolean
