// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layers of boxes with small integer corners, and what they enclose, by counting for the middle of
// each unit cube the boxes around it: cells, volumes, walls, and where four walls meet in an edge.
// No surface, no sum over faces, no code of the core.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace index_boolean::voxels {

using Place = std::array<int, 3>;

struct SignedBox {
	Place low, high;
	int sign;  // -1: it is given inside out
};

using BoxLayer = std::vector<SignedBox>;
using WindingVector = std::vector<std::int32_t>;
using Predicate = std::function<bool(const WindingVector&)>;

inline int countAround(const BoxLayer& layer, const Place& cube) {
	int winding = 0;
	for (const SignedBox& box : layer) {
		bool isInside = true;
		for (std::size_t k = 0; k < 3; ++k) {
			isInside = isInside && box.low[k] <= cube[k] && cube[k] < box.high[k];
		}
		winding += isInside ? box.sign : 0;
	}
	return winding;
}

class Oracle {
public:
	// \param span all corners' coordinates are 0 to span
	Oracle(const std::vector<BoxLayer>& layers, int span) : size_(span + 2) {
		for (int i = 0; i < size_ * size_ * size_; ++i) {
			WindingVector windings;
			for (const BoxLayer& layer : layers) {
				windings.push_back(countAround(layer, placeOf(i)));
			}
			windings_.push_back(windings);
		}
		for (std::size_t k = 0; k < layers.size(); ++k) {
			turnIfNowherePositive(k);
		}
	}

	// The bounded cells: windings and volume, sorted. Unit cubes of one cell are joined by faces.
	std::vector<std::pair<WindingVector, double>> cells() const {
		std::vector<std::pair<WindingVector, double>> all;
		std::vector<bool> isSeen(windings_.size(), false);
		for (int first = 0; first < static_cast<int>(windings_.size()); ++first) {
			if (isSeen[index(first)]) {
				continue;
			}
			std::vector<int> cell{first};
			isSeen[index(first)] = true;
			for (std::size_t i = 0; i < cell.size(); ++i) {
				for (const int next : neighbours(cell[i])) {
					if (!isSeen[index(next)] && windings_[index(next)] == windings_[index(first)]) {
						isSeen[index(next)] = true;
						cell.push_back(next);
					}
				}
			}
			if (first > 0) {  // the first cube is beyond the low corner of all boxes
				all.emplace_back(windings_[index(first)], static_cast<double>(cell.size()));
			}
		}
		std::sort(all.begin(), all.end());
		return all;
	}

	double volume(const Predicate& isInside) const {
		return static_cast<double>(std::count_if(windings_.begin(), windings_.end(), isInside));
	}

	// How many unit squares part inside and outside.
	double area(const Predicate& isInside) const {
		double squares = 0;
		for (int i = 0; i < static_cast<int>(windings_.size()); ++i) {
			for (const int next : neighbours(i)) {
				squares +=
				    isInside(windings_[index(i)]) != isInside(windings_[index(next)]) ? 1 : 0;
			}
		}
		return squares / 2;  // each has been met from both sides
	}

	// The length of edges at which two opposite quarters are inside, and the others are not.
	double lengthOfFourWalls(const Predicate& isInside) const {
		double length = 0;
		const auto at = [&](const Place& p) { return isInside(windings_[index(indexOf(p))]); };
		for (int i = 0; i < static_cast<int>(windings_.size()); ++i) {
			const Place p = placeOf(i);
			for (std::size_t axis = 0; axis < 3; ++axis) {
				Place x = p, y = p;
				++x[(axis + 1) % 3];
				++y[(axis + 2) % 3];
				Place xy = x;
				++xy[(axis + 2) % 3];
				if (isPlace(xy) && at(p) == at(xy) && at(x) == at(y) && at(p) != at(x)) {
					length += 1;
				}
			}
		}
		return length;
	}

private:
	static std::size_t index(int i) { return static_cast<std::size_t>(i); }

	// The low corner of a unit cube; those of -1 lie beyond all boxes.
	Place placeOf(int i) const {
		return {i % size_ - 1, i / size_ % size_ - 1, i / size_ / size_ - 1};
	}
	int indexOf(const Place& p) const { return p[0] + 1 + size_ * (p[1] + 1 + size_ * (p[2] + 1)); }
	bool isPlace(const Place& p) const {
		return std::all_of(p.begin(), p.end(), [this](int c) { return c >= -1 && c < size_ - 1; });
	}
	std::vector<int> neighbours(int i) const {
		std::vector<int> all;
		for (std::size_t axis = 0; axis < 3; ++axis) {
			for (const int step : {-1, 1}) {
				Place p = placeOf(i);
				p[axis] += step;
				if (isPlace(p)) {
					all.push_back(indexOf(p));
				}
			}
		}
		return all;
	}

	void turnIfNowherePositive(std::size_t operand) {
		const auto isPositive = [operand](const WindingVector& w) { return w[operand] > 0; };
		if (std::none_of(windings_.begin(), windings_.end(), isPositive)) {
			for (WindingVector& w : windings_) {
				w[operand] = -w[operand];
			}
		}
	}

	int size_;
	std::vector<WindingVector> windings_;  // of each unit cube
};

}  // namespace index_boolean::voxels
