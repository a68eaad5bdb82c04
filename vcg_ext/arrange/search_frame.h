// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of one surface that is to be searched; out: their corners as floats from -1 to 1.
// Guarantee: boxes of faces that meet, widened by the margin, meet; and the map moves a corner,
// taken to the frame exactly, by less than 2^-24 along each axis. Where the frame has axes of its
// own the exact map is linear, so it keeps what meets, what is a plane and on which side of it
// something is. With p the corner and c the frame's centre, p - c is rounded to a double, scaled by
// a power of two, and rounded to a float: by at most 2^-53 and 2^-25, where no more than 1 is
// rounded. (Of a surface smaller than 2^-1000 the doubles scaled may be less than 1 by far: all the
// better.) This never swaps two numbers along an axis: there is no margin. With axes of its own
// three products of numbers below 1 are summed up between, to less than 1 again: by less than 2^-49
// more.
#pragma once

#include "vcg_ext/arrange/faces_view.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/exact/bounding_box.h"

#include <array>
#include <vector>

namespace index_boolean {

// A corner in the frame; `star` is for those who judge the faces around it.
struct FramePoint {
	std::array<float, 3> place;
	std::uint32_t star;
};

// The corners of all faces by their index in the surface's points. What lies between them without
// being a corner may be anything, even no number.
struct FramePoints {
	std::uint32_t first = 0;  // no corner has a smaller index
	HugeVector<FramePoint> points;

	const FramePoint& operator[](std::uint32_t vertex) const { return points[vertex - first]; }
	FramePoint& operator[](std::uint32_t vertex) { return points[vertex - first]; }
};

// A surface that is being searched, and what stages find of it.
struct SearchedSurface {
	FacesView faces;  // whose corners are finite
	int threads = 0;  // 0: as many as there are
	// Per face: only pairs with a suspect one are of interest; null: all are suspect.
	const std::vector<std::uint8_t>* isSuspect = nullptr;
	// [search_frame]; the stars by [star_words] and [open_stars]
	FramePoints points;
	float boxMargin = 0;  // [search_frame]
	// [unbalanced_vertices] Per vertex, from the first of the points on: not all edges there have
	// as many faces each way. Empty: all have.
	std::vector<std::uint8_t> isUnbalanced;
	// [star_words] Per face: it has no area, and takes no part in pairs. Empty: all have.
	std::vector<std::uint8_t> isZeroArea;

	bool suspects(std::uint32_t face) const {
		return isSuspect == nullptr || (*isSuspect)[face] != 0;
	}
	bool hasNoArea(std::uint32_t face) const {
		return !isZeroArea.empty() && isZeroArea[face] != 0;
	}
};

// Maps the corners of the faces.
// \param surface its points and the margin are replaced; the stars have no value
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n), in parallel.
Status placeInFrame(SearchedSurface& surface, Monitor& monitor);

// The corners of eight faces side by side: [corner][axis][face], or [corner][face].
struct EightFaces {
	static constexpr std::size_t kCount = 8;

	std::array<std::array<std::array<float, kCount>, 3>, 3> place;
	std::array<std::array<std::uint32_t, kCount>, 3> vertex, star;
};

// Gathers faces faceAt(0) ... faceAt(count - 1), 1 to 8 of them, and the last one again and again
// up to eight. Complexity: O(1).
template <class FaceAt>
inline void gatherEight(const FacesView& faces, const FramePoints& points, std::size_t count,
                        FaceAt&& faceAt, EightFaces& out) {
	std::array<std::array<FramePoint, EightFaces::kCount>, 3> gathered;
	for (std::size_t lane = 0; lane < EightFaces::kCount; ++lane) {
		const IndexTriangle corners = faces[faceAt(lane < count ? lane : count - 1)];
		for (std::size_t corner = 0; corner < 3; ++corner) {
			out.vertex[corner][lane] = corners[corner];
			gathered[corner][lane] = points[corners[corner]];
		}
	}
	for (std::size_t corner = 0; corner < 3; ++corner) {
		for (std::size_t lane = 0; lane < EightFaces::kCount; ++lane) {
			const FramePoint& p = gathered[corner][lane];
			out.place[corner][0][lane] = p.place[0];
			out.place[corner][1][lane] = p.place[1];
			out.place[corner][2][lane] = p.place[2];
			out.star[corner][lane] = p.star;
		}
	}
}

}  // namespace index_boolean
