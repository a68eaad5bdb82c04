// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thin is a component whose volume is less than about its area times the way that two of its sides
// may have been moved. Nearly always there is none. What lies where it may is asked as for the
// components of operands (nesting.h).
#include "vcg_ext/solids/turned_components.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/parts/winding_rays.h"
#include "vcg_ext/solids/block_elements.h"
#include "vcg_ext/solids/nesting.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace index_boolean {

namespace {

constexpr double kMostUnits = 64;  // between two sides: both rounded, and moved by the repair

class TurnedComponents {
public:
	TurnedComponents(const Arrangement& arrangement, std::size_t first, Monitor& monitor,
	                 Block& block)
	    : arrangement_(arrangement), first_(first), monitor_(monitor), block_(block),
	      sets_(block.triangles.size() - first) {}

	// \return Ok, or why it is not known. \param dropped how many components
	Status run(std::size_t& dropped);

private:
	using Faces = std::vector<std::uint32_t>;

	void joinAtVertices();
	void listThin();
	bool isThin(const Faces& faces) const;
	bool isClosed(const Faces& faces) const;
	Status findWrong();
	void drop();

	const Arrangement& arrangement_;
	const std::size_t first_;
	Monitor& monitor_;
	Block& block_;
	UnionFind sets_;                 // of the faces from the first on
	std::vector<Faces> components_;  // those that are thin, of the block's faces
};

void TurnedComponents::joinAtVertices() {
	HugeVector<std::uint32_t> faceAt;
	faceAt.assign(block_.points.size(), kNone);
	for (std::size_t f = first_; f < block_.triangles.size(); ++f) {
		for (const std::uint32_t v : block_.triangles[f]) {
			const auto face = static_cast<std::uint32_t>(f - first_);
			if (faceAt[v] == kNone) {
				faceAt[v] = face;
			} else {
				sets_.unite(faceAt[v], face);
			}
		}
	}
}

// Whether each edge has as many faces each way.
bool TurnedComponents::isClosed(const Faces& faces) const {
	std::vector<std::array<std::uint32_t, 2>> ways, back;
	for (const std::uint32_t f : faces) {
		const IndexTriangle& t = block_.triangles[f];
		for (std::size_t i = 0; i < 3; ++i) {
			ways.push_back({t[i], t[(i + 1) % 3]});
			back.push_back({t[(i + 1) % 3], t[i]});
		}
	}
	std::sort(ways.begin(), ways.end());
	std::sort(back.begin(), back.end());
	return ways == back;
}

// Squares of the longest edges stand for areas: those of needles are nothing but rounding. So more
// components are thin than need be: that only costs the question where they lie.
bool TurnedComponents::isThin(const Faces& faces) const {
	const Point& origin = block_.points[block_.triangles[faces.front()][0]];
	double volume = 0, squares = 0, largest = 0;
	for (const std::uint32_t f : faces) {
		std::array<Point, 3> p{};
		double square = 0;
		for (std::size_t i = 0; i < 3; ++i) {
			const Point& at = block_.points[block_.triangles[f][i]];
			for (std::size_t axis = 0; axis < 3; ++axis) {
				largest = std::max(largest, std::fabs(at[axis]));
				p[i][axis] = at[axis] - origin[axis];
			}
		}
		for (std::size_t i = 0; i < 3; ++i) {
			const Point &from = p[i], &to = p[(i + 1) % 3];
			square = std::max(square, std::pow(to[0] - from[0], 2) + std::pow(to[1] - from[1], 2) +
			                              std::pow(to[2] - from[2], 2));
			volume += p[0][i] * (p[1][(i + 1) % 3] * p[2][(i + 2) % 3] -
			                     p[1][(i + 2) % 3] * p[2][(i + 1) % 3]);
		}
		squares += square;
	}
	const double unit =
	    std::max(arrangement_.placeRepair.unit, gapAt(largest, arrangement_.options.outputScalar));
	return std::fabs(volume) <= kMostUnits * unit * squares;
}

void TurnedComponents::listThin() {
	std::map<std::uint32_t, Faces> facesOf;
	std::vector<std::uint32_t> size(block_.triangles.size() - first_);
	std::size_t count = 0;
	for (std::uint32_t f = 0; f < size.size(); ++f) {
		count += size[sets_.find(f)]++ == 0 ? 1 : 0;
	}
	if (count == 0 || (count == 1 && first_ == 0)) {
		return;  // nothing, or all there is
	}
	for (std::uint32_t f = 0; f < size.size(); ++f) {
		facesOf[sets_.find(f)].push_back(static_cast<std::uint32_t>(first_ + f));
	}
	for (auto& [root, faces] : facesOf) {
		if (isThin(faces) && isClosed(faces)) {
			components_.push_back(std::move(faces));
		}
	}
}

// Asks on which sides of the components there is material.
Status TurnedComponents::findWrong() {
	MeshArrays mesh;
	Status status = joinSurfaces({viewOf(block_.points, block_.triangles)},
	                             arrangement_.options.threads, monitor_, mesh);
	if (!status.ok()) {
		return status;
	}
	std::vector<std::uint32_t> componentOf(block_.triangles.size(), kNone);
	std::vector<WindingQuery> queries;
	for (std::uint32_t c = 0; c < components_.size(); ++c) {
		queries.push_back(queryInside(mesh, {components_[c].front()}));
		for (const std::uint32_t f : components_[c]) {
			componentOf[f] = c;
		}
	}
	const auto isOwn = [&](std::size_t query, FaceId face) {
		return componentOf[face.value] == query;
	};
	status = findWindings(mesh, kFirst, isOwn, arrangement_.options.threads, monitor_, queries);
	for (std::size_t c = 0; c < components_.size() && status.ok(); ++c) {
		Triangles triangles;
		for (const std::uint32_t f : components_[c]) {
			triangles.push_back(mesh.triangles[f]);
		}
		const int sign =
		    exactVolumeSign(mesh.points, triangles.data(), triangles.data() + triangles.size());
		if (isPlacedRight(queries[c], sign)) {
			components_[c].clear();
		}
	}
	return status;
}

void TurnedComponents::drop() {
	std::vector<std::uint8_t> isGone(block_.triangles.size(), 0);
	for (const Faces& faces : components_) {
		for (const std::uint32_t f : faces) {
			isGone[f] = 1;
		}
	}
	removeFaces(isGone, block_);
	isGone.assign(block_.points.size(), 1);
	for (const IndexTriangle& t : block_.triangles) {
		for (const std::uint32_t v : t) {
			isGone[v] = 0;
		}
	}
	removeVertices(isGone, block_);
}

Status TurnedComponents::run(std::size_t& dropped) {
	joinAtVertices();
	listThin();
	const Status status = components_.empty() ? Status{} : findWrong();
	if (!status.ok()) {
		return status;
	}
	components_.erase(std::remove_if(components_.begin(), components_.end(),
	                                 [](const Faces& faces) { return faces.empty(); }),
	                  components_.end());
	dropped = components_.size();
	if (dropped > 0) {
		drop();
	}
	return {};
}

}  // namespace

Status dropTurnedComponents(const Arrangement& arrangement, std::size_t firstRounded,
                            Monitor& monitor, Block& block) {
	// Of a surface that meets itself, what is inside depends on where it is asked.
	const bool isAsked = arrangement.options.certify && arrangement.placeRepair.faultsAfter == 0;
	std::size_t dropped = isAsked ? 1 : 0;
	Status status;
	while (status.ok() && dropped > 0) {  // what lay in another one may be right without it
		status = TurnedComponents(arrangement, firstRounded, monitor, block).run(dropped);
		block.repair.vanishedComponents += dropped;
	}
	return status;
}

}  // namespace index_boolean
