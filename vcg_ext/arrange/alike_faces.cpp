// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a face to its neighbours, part by part.
#include "vcg_ext/arrange/alike_faces.h"

#include "vcg_ext/arrange/hanging_edges.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/area_order.h"
#include "vcg_ext/mesh/boundary_checksum.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

// A neighbour across an edge with two faces.
struct Neighbour {
	std::uint32_t face = kNone;
	bool runsAlike = false;  // both run along the edge in one direction: one is turned wrongly
};

// Of each face of one operand, its neighbours; faces are numbered from the operand's first on.
struct Adjacency {
	std::vector<std::array<Neighbour, 3>> of;
	bool isEven = true;              // each edge has an even number of faces
	std::vector<UnevenEdge> uneven;  // those that have not as many faces each way
};

Status findNeighbours(const MeshArrays& mesh, OperandId operand, int threads, Monitor& monitor,
                      Adjacency& out) {
	const std::size_t first = mesh.faceOffsets.begin(operand);
	const std::size_t count = mesh.faceOffsets.size(operand);
	std::vector<HalfEdge> edges;
	edges.reserve(3 * count);
	out.of.resize(count);
	const auto list = [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			const Triangle& t = mesh.triangles[first + f];
			for (std::size_t i = 0; i < 3; ++i) {
				edges.push_back(makeHalfEdge(t[i].value, t[(i + 1) % 3].value, f, i));
			}
		}
	};
	std::size_t seen = 0;
	const auto join = [&](const HalfEdge* begin, const HalfEdge* end) {
		out.isEven = out.isEven && (end - begin) % 2 == 0;
		const auto forward = std::count_if(begin, end, [](const HalfEdge& e) { return e.forward; });
		if (2 * forward != end - begin) {
			out.uneven.push_back(
			    {begin->low, begin->high, static_cast<std::int32_t>(2 * forward - (end - begin))});
		}
		if (end - begin == 2) {
			const bool runsAlike = begin[0].forward == begin[1].forward;
			out.of[begin[0].face][begin[0].corner] = {begin[1].face, runsAlike};
			out.of[begin[1].face][begin[1].corner] = {begin[0].face, runsAlike};
		}
		if (++seen % kGrain == 0) {
			pollCancelled(monitor);
		}
	};
	return inOrder([&] { return inOrderFor(count, kGrain, monitor, list); },
	               [&] { return sortByEdge(edges, mesh.points.size(), threads, monitor); },
	               [&] {
		               forEachSortedEdge(edges.data(), edges.data() + edges.size(), join);
		               return statusOf(monitor.cancelled() ? StatusCode::Cancelled
		                                                   : StatusCode::Ok);
	               });
}

// A face by the places of its corners, from the first one on.
std::array<Point, 3> placesOf(const MeshArrays& mesh, const Triangle& t) {
	std::array<Point, 3> places{at(mesh.points, t[0]), at(mesh.points, t[1]),
	                            at(mesh.points, t[2])};
	std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
	return places;
}

// The faces that are turned against the first one of their part, or those that are not.
class PartTurner {
public:
	PartTurner(const Adjacency& adjacency, const MeshArrays& mesh, std::uint32_t firstFace,
	           Monitor& monitor)
	    : adjacency_(adjacency), mesh_(mesh), firstFace_(firstFace), monitor_(monitor),
	      side_(adjacency.of.size(), kUnseen) {}

	// \param wrong replaced: the faces to turn, in no order. \return Ok or Cancelled
	Status run(std::vector<std::uint32_t>& wrong) {
		wrong.clear();
		for (std::uint32_t face = 0; face < side_.size() && !monitor_.cancelled(); ++face) {
			if (side_[face] == kUnseen && collectPart(face)) {
				const std::uint8_t turned = sideToTurn();
				std::copy_if(part_.begin(), part_.end(), std::back_inserter(wrong),
				             [&](std::uint32_t f) { return side_[f] == turned; });
			}
		}
		return statusOf(monitor_.cancelled() ? StatusCode::Cancelled : StatusCode::Ok);
	}

private:
	static constexpr std::uint8_t kUnseen = 2;

	// False if the part has one side only.
	bool collectPart(std::uint32_t start) {
		bool hasTwoSides = true;
		part_.assign(1, start);
		side_[start] = 0;
		for (std::size_t next = 0; next < part_.size(); ++next) {
			const std::uint32_t face = part_[next];
			if (next % kGrain == 0 && pollCancelled(monitor_)) {
				return false;
			}
			for (const Neighbour& n : adjacency_.of[face]) {
				if (n.face == kNone) {
					continue;
				}
				const auto side = static_cast<std::uint8_t>(side_[face] ^ (n.runsAlike ? 1 : 0));
				if (side_[n.face] == kUnseen) {
					side_[n.face] = side;
					part_.push_back(n.face);
				}
				hasTwoSides = hasTwoSides && side_[n.face] == side;
			}
		}
		return hasTwoSides;
	}

	// Of the part's two sorts of faces, the one with less area; of equal ones, the one whose turn
	// makes the volume positive; if that is none, the one whose turn leaves the faces that come
	// first. None of it depends on how faces are numbered.
	std::uint8_t sideToTurn() const {
		std::array<Triangles, 2> sides;
		for (const std::uint32_t face : part_) {
			sides[side_[face]].push_back(mesh_.triangles[firstFace_ + face]);
		}
		const auto turnedIf = [](int isFirst) {
			return static_cast<std::uint8_t>(isFirst ? 0 : 1);
		};
		if (sides[0].empty() || sides[1].empty()) {
			return turnedIf(sides[0].empty());
		}
		const int area = compareAreas(mesh_.points, sides[0], sides[1], monitor_);
		if (area != 0) {
			return turnedIf(area < 0);
		}
		const int volume = compareVolumesBelow(mesh_.points, sides[0], sides[1], monitor_);
		return turnedIf(volume != 0 ? volume < 0 : isBefore(sides[1], sides[0]));
	}

	// Of two sets of faces, whether both come first if the second is turned, or else if the first
	// is.
	bool isBefore(const Triangles& kept, const Triangles& turned) const {
		std::array<std::vector<std::array<Point, 3>>, 2> left;  // or the same, turned
		for (const auto* const faces : {&kept, &turned}) {
			for (const Triangle& t : *faces) {
				left[faces == &kept ? 0 : 1].push_back(placesOf(mesh_, t));
				left[faces == &kept ? 1 : 0].push_back(placesOf(mesh_, {t[0], t[2], t[1]}));
			}
		}
		for (auto& places : left) {
			std::sort(places.begin(), places.end());
		}
		return left[0] < left[1];
	}

	const Adjacency& adjacency_;
	const MeshArrays& mesh_;
	std::uint32_t firstFace_;
	Monitor& monitor_;
	std::vector<std::uint8_t> side_;  // per face
	std::vector<std::uint32_t> part_;
};

void turnFaces(const std::vector<std::uint32_t>& faces, std::uint32_t first, MeshArrays& mesh) {
	for (const std::uint32_t face : faces) {
		std::swap(mesh.triangles[first + face][1], mesh.triangles[first + face][2]);
		if (!mesh.faux.empty()) {
			mesh.faux[first + face] = turnedFaux(mesh.faux[first + face]);
		}
	}
}

// Turns an operand's faces, if it is closed then.
Status turnIfClosedThen(Arrangement& arrangement, OperandId operand,
                        const std::vector<std::uint32_t>& wrong, Monitor& monitor) {
	MeshArrays& mesh = arrangement.mesh;
	const std::uint32_t first = mesh.faceOffsets.begin(operand);
	turnFaces(wrong, first, mesh);
	std::uint64_t sum = 0;
	const Status status = boundaryChecksum(mesh.triangles.data() + first,
	                                       mesh.triangles.data() + mesh.faceOffsets.end(operand),
	                                       arrangement.options.threads, monitor, sum);
	arrangement.closed[operand] = sum == 0;
	arrangement.turnedAlike[operand] = sum == 0 ? wrong.size() : 0;
	if (sum != 0) {
		turnFaces(wrong, first, mesh);
	}
	return status;
}

}  // namespace

Status turnFacesAlike(Arrangement& arrangement, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	return forEachOperand(mesh.operands(), [&](OperandId operand) {
		Adjacency adjacency;
		std::vector<std::uint32_t> wrong;
		if (arrangement.closed[operand]) {
			return Status{};
		}
		const std::uint32_t first = mesh.faceOffsets.begin(operand);
		bool isClosedAsCut = false;
		const Status status = inOrder(
		    [&] {
			    return findNeighbours(mesh, operand, arrangement.options.threads, monitor,
			                          adjacency);
		    },
		    [&] {
			    return adjacency.isEven ? findWhetherEdgesCancel(mesh.points, adjacency.uneven,
			                                                     monitor, isClosedAsCut)
			                            : Status{};
		    });
		if (!status.ok() || !adjacency.isEven || isClosedAsCut) {
			return status;
		}
		return inOrder([&] { return PartTurner(adjacency, mesh, first, monitor).run(wrong); },
		               [&] { return turnIfClosedThen(arrangement, operand, wrong, monitor); });
	});
}

}  // namespace index_boolean
