// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sides of sub-surfaces that face the same part of space are united: around each loop, the facing
// sides of neighbouring half-planes; along a line through each part that no edge joins to others,
// the facing sides of neighbouring hits. What is united with nothing beyond the ends of such a line
// is bounded.
#include "vcg_ext/parts/sub_blocks.h"

#include "vcg_ext/arrange/radial_order.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/parts/line_hits.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

// Side 2 * s of sub-surface s is its front, 2 * s + 1 its back.
class Assembler {
public:
	Assembler(const Arrangement& arrangement, const SubSurfaces& surfaces, Monitor& monitor,
	          SubBlocks& out)
	    : arrangement_(arrangement), surfaces_(surfaces), complex_(surfaces.complex),
	      monitor_(monitor), out_(out), sides_(2 * surfaces.all.size() + 1),
	      parts_(surfaces.all.size()),
	      outside_(static_cast<std::uint32_t>(2 * surfaces.all.size())) {}

	Status run();

private:
	void uniteAtBorders();
	Status uniteAtLoops();
	Status uniteAround(const PartingEdge& edge);
	Status uniteAlongLines();
	bool findLine(const std::vector<std::uint32_t>& faces, AxisLine& line) const;
	void numberBlocks();
	void fillBlocks();
	Status findWindings();
	Status refuseWindings(OperandId operand, std::uint32_t surface) const;
	int windingStep(OperandId operand, std::uint32_t surface) const;

	std::uint32_t surfaceOf(std::uint32_t face) const { return surfaces_.ofFace[face].value; }
	std::uint32_t sideOf(std::uint32_t face, bool isBack) const {
		return 2 * surfaceOf(face) + (isBack != (surfaces_.turned[face] != 0) ? 1 : 0);
	}

	const Arrangement& arrangement_;
	const SubSurfaces& surfaces_;
	const SurfaceComplex& complex_;
	Monitor& monitor_;
	SubBlocks& out_;
	UnionFind sides_;  // of sub-surfaces, and the outside; sets: the parts of space
	UnionFind parts_;  // sub-surfaces; sets: what edges join
	std::uint32_t outside_;
};

// At a free border both sides face the same part of space; so do those of a one-sided surface.
void Assembler::uniteAtBorders() {
	for (std::uint32_t s = 0; s < surfaces_.all.size(); ++s) {
		if (surfaces_.all[s].oneSided) {
			sides_.unite(2 * s, 2 * s + 1);
		}
	}
	for (const PartingEdge& edge : complex_.parting) {
		const std::uint32_t first = surfaceOf(complex_.faceAt(complex_.halfEdges[edge.first]));
		if (edge.count == 1) {
			sides_.unite(2 * first, 2 * first + 1);
		}
		for (std::uint32_t i = 1; i < edge.count; ++i) {
			parts_.unite(first, surfaceOf(complex_.faceAt(complex_.halfEdges[edge.first + i])));
		}
	}
	parts_.flatten();
}

// Sorts the faces at one edge around it and unites the sides that face each other.
Status Assembler::uniteAround(const PartingEdge& edge) {
	std::vector<HalfPlane> halfPlanes;
	for (std::uint32_t i = edge.first; i < edge.first + edge.count; ++i) {
		const HalfEdgeId h = complex_.halfEdges[i];
		halfPlanes.push_back({complex_.faceOf(h).source(), complex_.beginOf(h) == edge.low});
	}
	std::vector<RadialPlace> places;
	bool sorted = sortAround(arrangement_, edge.low, edge.high, halfPlanes, places);
	for (std::size_t i = 0; i + 1 < places.size() && sorted; ++i) {
		sorted = places[i].slot != places[i + 1].slot;
	}
	if (!sorted) {
		const FaceId face = halfPlanes[0].face;
		return selfIntersecting(arrangement_, arrangement_.mesh.operandOf(face), {face},
		                        arrangement_.coordinates(edge.low));
	}
	// Going round, a face to the left of the edge is met from behind and left in front.
	for (std::size_t i = 0; i < places.size(); ++i) {
		const std::uint32_t here = places[i].index;
		const std::uint32_t next = places[(i + 1) % places.size()].index;
		const auto faceAt = [&](std::uint32_t index) {
			return complex_.faceAt(complex_.halfEdges[edge.first + index]);
		};
		sides_.unite(sideOf(faceAt(here), !halfPlanes[here].left),
		             sideOf(faceAt(next), halfPlanes[next].left));
	}
	return {};
}

// All edges of a loop have the same sub-surfaces around them in the same order: one edge will do.
Status Assembler::uniteAtLoops() {
	std::vector<std::uint8_t> done(complex_.parting.size());
	Status status;
	for (const Loop& loop : arrangement_.loops) {
		for (std::size_t i = 0; i + 1 < loop.points.size(); ++i) {
			const PartingEdge* edge = complex_.partingEdge(loop.points[i], loop.points[i + 1]);
			if (edge == nullptr) {
				continue;
			}
			if (i == 0 && edge->count > 1 && status.ok()) {
				status = uniteAround(*edge);
			}
			done[static_cast<std::size_t>(edge - complex_.parting.data())] = 1;
		}
	}
	for (std::size_t e = 0; e < complex_.parting.size() && status.ok(); ++e) {
		if (done[e] == 0 && complex_.parting[e].count > 1) {
			status = uniteAround(complex_.parting[e]);
		}
	}
	return status;
}

// A line that meets the first of the faces for which one is found.
bool Assembler::findLine(const std::vector<std::uint32_t>& faces, AxisLine& line) const {
	for (const std::uint32_t face : faces) {
		const Triangle& t = complex_.faces[face].corners;
		std::array<Point, 4> places{};  // the centre and the corners, as rounded
		for (std::size_t corner = 0; corner < 3; ++corner) {
			places[corner + 1] = arrangement_.coordinates(t[corner]);
			for (std::size_t k = 0; k < 3; ++k) {
				places[0][k] += places[corner + 1][k] / 3;
			}
		}
		for (line.axis = 0; line.axis < 3; ++line.axis) {
			for (const Point& place : places) {
				line.place = place;
				if (meets(arrangement_, line, t) != 0) {
					return true;
				}
			}
		}
	}
	return false;
}

Status Assembler::uniteAlongLines() {
	std::vector<AxisLine> lines;
	std::vector<std::vector<std::uint32_t>> faces(surfaces_.all.size());
	Status status;
	for (std::uint32_t s = 0; s < surfaces_.all.size(); ++s) {
		const SubSurface& surface = surfaces_.all[s];
		const auto first = surfaces_.faces.begin() + surface.firstFace;
		std::vector<std::uint32_t>& all = faces[parts_.root(s)];
		all.insert(all.end(), first, first + surface.faceCount);
	}
	for (const std::vector<std::uint32_t>& part : faces) {
		AxisLine line{};
		if (part.empty()) {
			continue;
		}
		if (!findLine(part, line)) {
			status.code = StatusCode::InternalError;
			return status;
		}
		lines.push_back(line);
	}
	std::vector<LineHit> hits;
	status = castLines(arrangement_, complex_, lines, monitor_, hits);
	for (std::size_t i = 0; i < hits.size() && status.ok(); ++i) {
		const bool isFirst = i == 0 || hits[i - 1].line != hits[i].line;
		const bool isLast = i + 1 == hits.size() || hits[i + 1].line != hits[i].line;
		const std::uint32_t below = sideOf(hits[i].face, hits[i].facesUp);
		const std::uint32_t above = sideOf(hits[i].face, !hits[i].facesUp);
		if (isFirst) {
			sides_.unite(below, outside_);
		}
		sides_.unite(above, isLast ? outside_ : sideOf(hits[i + 1].face, hits[i + 1].facesUp));
	}
	return status;
}

// In the order of their smallest sub-surface. Of two with the same smallest one, the first is that
// behind its smallest face, if that face ran through its corners in lexicographic order.
void Assembler::numberBlocks() {
	sides_.flatten();
	const std::uint32_t outside = sides_.root(outside_);
	std::vector<std::int32_t> number(sides_.size(), kNoBlock);
	out_.beside.resize(surfaces_.all.size());
	out_.separates.resize(surfaces_.all.size());
	for (std::uint32_t s = 0; s < surfaces_.all.size(); ++s) {
		const std::uint32_t backFirst = surfaces_.all[s].frontFirst ? 0 : 1;
		for (const std::uint32_t side : {2 * s + backFirst, 2 * s + 1 - backFirst}) {
			const std::uint32_t root = sides_.root(side);
			if (root != outside && number[root] == kNoBlock) {
				number[root] = static_cast<std::int32_t>(out_.all.size());
				out_.all.emplace_back();
			}
			out_.beside[s][side % 2] = number[root];
		}
		out_.separates[s] = sides_.root(2 * s) != sides_.root(2 * s + 1) ? 1 : 0;
	}
}

void Assembler::fillBlocks() {
	std::vector<SurfaceSums> sums(out_.all.size());
	for (std::uint32_t s = 0; s < surfaces_.all.size(); ++s) {
		for (std::size_t side = 0; side < 2; ++side) {
			const std::int32_t number = out_.beside[s][side];
			if (number == kNoBlock) {
				continue;
			}
			const auto block = static_cast<std::size_t>(number);
			if (out_.separates[s] != 0) {
				out_.all[block].sides.push_back({{s}, side == 1});
				sums[block].add(surfaces_.sums[s], side == 1 ? 1 : -1);
			} else if (side == 0) {
				out_.all[block].dangling.push_back({s});
			}
		}
	}
	for (std::size_t i = 0; i < out_.all.size(); ++i) {
		out_.all[i].volume = volumeOf(sums[i], surfaces_.frame);
		out_.all[i].area = areaOf(sums[i], surfaces_.frame);
	}
}

// How an operand's winding number rises from the front of a sub-surface to its back.
int Assembler::windingStep(OperandId operand, std::uint32_t surface) const {
	const std::uint32_t first = surfaces_.faces[surfaces_.all[surface].firstFace];
	const RefinedFace& face = complex_.faces[first];
	if (!arrangement_.closed[operand] || face.sources[operand.value] == FaceId::none()) {
		return 0;
	}
	const bool isOther = operand == kSecond && face.sources[0] != FaceId::none() && face.opposed;
	const bool runsAlike = isOther == (surfaces_.turned[first] != 0);
	return runsAlike != arrangement_.insideOut[operand] ? 1 : -1;
}

// A closed operand that does not part space consistently intersects itself.
Status Assembler::refuseWindings(OperandId operand, std::uint32_t surface) const {
	const SubSurface& wrong = surfaces_.all[surface];
	std::vector<FaceId> faces;
	VertexId corner{};
	for (std::uint32_t i = wrong.firstFace; i < wrong.firstFace + wrong.faceCount; ++i) {
		const RefinedFace& face = complex_.faces[surfaces_.faces[i]];
		faces.push_back(face.sources[operand.value]);
		corner = face.corners[0];
	}
	return selfIntersecting(arrangement_, operand, faces, arrangement_.coordinates(corner));
}

// Goes from block to block through the sub-surfaces between them, from the outside on.
Status Assembler::findWindings() {
	const std::size_t outside = out_.all.size();
	std::vector<PerOperand<std::int32_t>> windings(outside + 1);
	std::vector<std::uint8_t> known(outside + 1);
	std::vector<std::size_t> reached{outside};
	known[outside] = 1;
	const auto blockAt = [&](std::uint32_t surface, std::size_t side) {
		const std::int32_t block = out_.beside[surface][side];
		return block == kNoBlock ? outside : static_cast<std::size_t>(block);
	};
	std::vector<std::vector<std::uint32_t>> around(outside + 1);
	for (std::uint32_t s = 0; s < surfaces_.all.size(); ++s) {
		around[blockAt(s, 0)].push_back(s);
		around[blockAt(s, 1)].push_back(s);
	}
	while (!reached.empty()) {
		const std::size_t block = reached.back();
		reached.pop_back();
		for (const std::uint32_t s : around[block]) {
			const bool toBack = blockAt(s, 0) == block;
			const std::size_t next = blockAt(s, toBack ? 1 : 0);
			PerOperand<std::int32_t> there = windings[block];
			for (const OperandId operand : there.operands()) {
				there[operand] += (toBack ? 1 : -1) * windingStep(operand, s);
				if (known[next] != 0 && windings[next][operand] != there[operand]) {
					return refuseWindings(operand, s);
				}
			}
			if (known[next] == 0) {
				known[next] = 1;
				windings[next] = there;
				reached.push_back(next);
			}
		}
	}
	for (std::size_t i = 0; i < outside; ++i) {
		out_.all[i].windings = windings[i];
	}
	return {};
}

Status Assembler::run() {
	uniteAtBorders();
	Status status = uniteAtLoops();
	if (status.ok()) {
		status = uniteAlongLines();
	}
	if (status.ok()) {
		numberBlocks();
		fillBlocks();
		status = findWindings();
	}
	return status;
}

}  // namespace

Status findSubBlocks(const Arrangement& arrangement, const SubSurfaces& surfaces, Monitor& monitor,
                     SubBlocks& out) {
	out = SubBlocks{};
	return Assembler(arrangement, surfaces, monitor, out).run();
}

}  // namespace index_boolean
