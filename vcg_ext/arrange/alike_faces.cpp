// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a face to its neighbours, part by part.
#include "vcg_ext/arrange/alike_faces.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/mesh/boundary_checksum.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

// A neighbour across an edge with two faces.
struct Neighbour {
	std::uint32_t face = kNone;
	bool runsAlike = false;  // both run along the edge in one direction: one is turned wrongly
};

// Of each face of one operand, its neighbours; faces are numbered from the operand's first on.
struct Adjacency {
	std::vector<std::array<Neighbour, 3>> of;
	bool isEven = true;  // each edge has an even number of faces
};

Status findNeighbours(const MeshArrays& mesh, OperandId operand, int threads, Monitor& monitor,
                      Adjacency& out) {
	const std::uint32_t first = mesh.faceOffsets.begin(operand);
	std::vector<HalfEdge> edges;
	for (std::uint32_t f = first; f < mesh.faceOffsets.end(operand); ++f) {
		const Triangle& t = mesh.triangles[f];
		for (std::size_t i = 0; i < 3; ++i) {
			edges.push_back(makeHalfEdge(t[i].value, t[(i + 1) % 3].value, f - first, i));
		}
	}
	out.of.resize(mesh.faceOffsets.size(operand));
	const Status status = sortByEdge(edges, mesh.points.size(), threads, monitor);
	forEachSortedEdge(edges.data(), edges.data() + edges.size(),
	                  [&](const HalfEdge* begin, const HalfEdge* end) {
		                  out.isEven = out.isEven && (end - begin) % 2 == 0;
		                  if (end - begin == 2) {
			                  const bool runsAlike = begin[0].forward == begin[1].forward;
			                  out.of[begin[0].face][begin[0].corner] = {begin[1].face, runsAlike};
			                  out.of[begin[1].face][begin[1].corner] = {begin[0].face, runsAlike};
		                  }
	                  });
	return status;
}

// What a face adds to a part's area, and to its volume about the origin.
struct FaceSize {
	double area, volume;
};

FaceSize sizeOf(const MeshArrays& mesh, const Triangle& t) {
	const Point &a = at(mesh.points, t[0]), &b = at(mesh.points, t[1]), &c = at(mesh.points, t[2]);
	Point n{};
	for (std::size_t k = 0; k < 3; ++k) {
		const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
		n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
	}
	return {std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2,
	        (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / 6};
}

// The faces that are turned against the first one of their part, or those that are not.
class PartTurner {
public:
	PartTurner(const Adjacency& adjacency, const MeshArrays& mesh, std::uint32_t firstFace)
	    : adjacency_(adjacency), mesh_(mesh), firstFace_(firstFace),
	      side_(adjacency.of.size(), kUnseen) {}

	// The faces to turn, in no order.
	std::vector<std::uint32_t> run() {
		std::vector<std::uint32_t> wrong;
		for (std::uint32_t face = 0; face < side_.size(); ++face) {
			if (side_[face] == kUnseen && collectPart(face)) {
				const std::uint8_t turned = sideToTurn();
				std::copy_if(part_.begin(), part_.end(), std::back_inserter(wrong),
				             [&](std::uint32_t f) { return side_[f] == turned; });
			}
		}
		return wrong;
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
	// makes the volume positive.
	std::uint8_t sideToTurn() const {
		std::array<double, 2> area{};
		double volume = 0;  // with the faces of side 1 turned
		for (const std::uint32_t face : part_) {
			const FaceSize size = sizeOf(mesh_, mesh_.triangles[firstFace_ + face]);
			area[side_[face]] += size.area;
			volume += side_[face] == 0 ? size.volume : -size.volume;
		}
		const bool isFirstSmaller = area[0] < area[1] || (area[0] == area[1] && volume < 0);
		return isFirstSmaller ? 0 : 1;
	}

	const Adjacency& adjacency_;
	const MeshArrays& mesh_;
	std::uint32_t firstFace_;
	std::vector<std::uint8_t> side_;  // per face
	std::vector<std::uint32_t> part_;
};

}  // namespace

Status turnFacesAlike(Arrangement& arrangement, Monitor& monitor) {
	MeshArrays& mesh = arrangement.mesh;
	const int threads = arrangement.options.threads;
	return forEachOperand(mesh.operands(), [&](OperandId operand) {
		Adjacency adjacency;
		Status status;
		if (!arrangement.closed[operand]) {
			status = findNeighbours(mesh, operand, threads, monitor, adjacency);
		}
		if (!status.ok() || arrangement.closed[operand] || !adjacency.isEven) {
			return status;
		}
		const std::uint32_t first = mesh.faceOffsets.begin(operand);
		const std::vector<std::uint32_t> wrong = PartTurner(adjacency, mesh, first).run();
		for (const std::uint32_t face : wrong) {
			std::swap(mesh.triangles[first + face][1], mesh.triangles[first + face][2]);
			if (!mesh.faux.empty()) {
				mesh.faux[first + face] = turnedFaux(mesh.faux[first + face]);
			}
		}
		arrangement.turnedAlike[operand] = wrong.size();
		std::uint64_t sum = 0;
		status = boundaryChecksum(mesh.triangles.data() + first,
		                          mesh.triangles.data() + mesh.faceOffsets.end(operand), threads,
		                          monitor, sum);
		arrangement.closed[operand] = sum == 0;
		return status;
	});
}

}  // namespace index_boolean
