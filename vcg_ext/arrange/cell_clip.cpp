// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A direction is any vector of doubles: which one, rounding may choose. What counts is the error of
// the products with it. Let u be the unit roundoff. A corner in the frame errs by u of itself,
// its offset from a child's middle by u more, each product and sum by u: in all by less than
// 8u (|corner| + 2) times the sum of the direction's absolute components, as no middle is larger
// than 1. The map to floats moves a point of the frame by 2^-24 at most, and the middle and size of
// a node that is found by halving another one up to 20 times err by less than 2^-20. All is less
// than what is added to the child's half size. Products that underflow err by less than kUnderflow.
// Infinities and NaN part nothing.
#include "vcg_ext/arrange/cell_clip.h"

#include "vcg_ext/exact/exact_number.h"

#include <cmath>

namespace index_boolean {

namespace {

// A face in the frame, and the directions that may part it from a box.
class FramedFace {
public:
	FramedFace(const Triangle& corners, const Points& points, const BoxFrame& frame) {
		for (std::size_t i = 0; i < 3; ++i) {
			for (std::size_t k = 0; k < 3; ++k) {
				const double x = (at(points, corners[i])[k] - frame.centre[k]) * frame.scale;
				corner_[i][k] = x;
				farthest_ = std::max(farthest_, std::fabs(x));
			}
		}
		const auto edge = [this](std::size_t i, std::size_t k) {
			return corner_[(i + 1) % 3][k] - corner_[i][k];
		};
		for (std::size_t k = 0; k < 3; ++k) {
			const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
			direction_[9][k] = edge(0, i) * edge(1, j) - edge(0, j) * edge(1, i);
			for (std::size_t e = 0; e < 3; ++e) {  // across an edge and axis k
				direction_[3 * e + k][k] = 0;
				direction_[3 * e + k][i] = edge(e, j);
				direction_[3 * e + k][j] = -edge(e, i);
			}
		}
	}

	bool isPartedFrom(const Point& middle, double half) const {
		const double reach = half + 0x1p-19 + 0x1p-48 * farthest_;
		std::array<Point, 3> offset;
		for (std::size_t i = 0; i < 3; ++i) {
			for (std::size_t k = 0; k < 3; ++k) {
				offset[i][k] = corner_[i][k] - middle[k];
			}
		}
		for (const Point& d : direction_) {
			const double room =
			    reach * (std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2])) + kUnderflow;
			const auto along = [&d](const Point& p) {
				return d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
			};
			const double p = along(offset[0]), q = along(offset[1]), r = along(offset[2]);
			if ((p > room && q > room && r > room) || (p < -room && q < -room && r < -room)) {
				return true;
			}
		}
		return false;
	}

private:
	std::array<Point, 3> corner_;
	std::array<Point, 10> direction_;
	double farthest_ = 0;
};

}  // namespace

ChildSet CellClip::reached(FaceId face, ChildSet children, const OctreeCell& node) const {
	const FramedFace framed(at(mesh_.triangles, face), mesh_.points, frame_);
	const double half = node.half / 2;
	unsigned result = children;
	for (unsigned child = 0; child < 8; ++child) {
		if ((children >> child & 1U) == 0) {
			continue;
		}
		Point middle;
		for (std::size_t k = 0; k < 3; ++k) {
			middle[k] = node.middle[k] + ((child >> k & 1U) != 0 ? half : -half);
		}
		if (framed.isPartedFrom(middle, half)) {
			result &= ~(1U << child);
		}
	}
	return static_cast<ChildSet>(result);
}

}  // namespace index_boolean
