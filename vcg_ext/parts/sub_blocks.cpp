// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sides of sub-surfaces that face the same part of space are united: around each loop, the facing
// sides of neighbouring half-planes; then each *part*, what edges join, is united with others by a
// line upwards from its top, and with the outside if nothing lies there. What is united with
// nothing is bounded.
//
// Why one line a part is enough. The sides of a part P that edges have united are one set for each
// component of space without P, in particular one, its outer set, for the unbounded component (P
// hangs together across edges, so around a vertex, too, the sides between two of its umbrellas are
// one set elsewhere). The top of P is its vertex that comes last in exact lexicographic order. The
// line starts inside a face at the top, infinitely near to it, and is united with, in order, all
// faces whose planes hold the top and the first other one. All that it meets but for P and other
// parts with the same top has a higher top, since going up raises a place in that order.
// Add the parts in groups of equal tops, from the highest on. Let P be of the group, R the part of
// space among all parts so far into which its outer set faces, and follow the line from where it
// last leaves P. All P's points lie lower, so it leaves P into R. Whatever it then enters belongs
// to the group or to the parts before. While it is near the top, all sides between neighbours are
// united, so going through a part within R it comes out on the set on which it went in, still in
// R. So one of these comes to pass:
//  - it leaves R through the set that encloses R: P is united with that;
//  - it ends its way near the top inside a part within R. That is not of the group, nothing of
//    which lies higher; so its top is higher, and it was united with R's other sets before;
//  - it ends its way near the top in R. The first face beyond belongs to a part before, and its
//    lower side faces into R; or there is none, and R is the outside.
// So P's outer set is united with one that faces into R, and by induction all that face into R are
// united. (Without the tops it would not do: of two linked rings each may lie above the other.)
#include "vcg_ext/parts/sub_blocks.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/radial_order.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/exact/box_tree.h"
#include "vcg_ext/parts/line_hits.h"
#include "vcg_ext/parts/winding_rays.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kPollGrain = 1024;  // edges, or blocks, between two looks at the monitor

// How often an operand winds around some place.
struct Winding {
	OperandId operand;
	std::int32_t number;
};

// Side 2 * s of sub-surface s is its front, 2 * s + 1 its back.
class Assembler {
public:
	Assembler(const Arrangement& arrangement, const SubSurfaces& surfaces, Walls walls,
	          Monitor& monitor, SubBlocks& out)
	    : arrangement_(arrangement), surfaces_(surfaces), complex_(surfaces.complex), walls_(walls),
	      monitor_(monitor), out_(out), sides_(2 * surfaces.all.size() + 1),
	      parts_(surfaces.all.size()),
	      outside_(static_cast<std::uint32_t>(2 * surfaces.all.size())) {}

	Status run();

private:
	void uniteAtBorders();
	Status uniteAtLoops();
	Status uniteAround(const PartingEdge& edge);
	Status uniteAlongLines();
	Status findTops(std::vector<LineStart>& tops);
	LineStart topOf(std::uint32_t begin, std::uint32_t end) const;
	bool isUpright(std::uint32_t face) const;
	bool isHigher(LineStart a, LineStart b) const;
	void numberBlocks();
	void fillBlocks();
	Status walkWindings();
	Status checkWindings();
	void turnInsideOut();
	Status checkWindings(OperandId operand, const std::vector<std::uint32_t>& faces);
	int windingAt(OperandId operand, std::uint32_t side) const;
	Status refuseWindings(OperandId operand, std::uint32_t surface) const;
	int windingStep(OperandId operand, std::uint32_t surface) const;
	std::vector<OperandId> closedOperandsOf(std::uint32_t surface) const;
	std::vector<Winding> windingsBehind(const PerOperand<std::int32_t>& before,
	                                    std::uint32_t surface, bool toBack,
	                                    std::uint64_t& sum) const;
	std::vector<std::uint32_t> witnessFaces() const;
	std::vector<BoundingBox> boxesOf(const std::vector<std::uint32_t>& faces) const;
	PerOperand<BoundingBox> operandBoxes() const;
	Status refuseWitness(OperandId operand, std::uint32_t face) const;
	Status checkFarWindings(const std::vector<std::uint32_t>& faces,
	                        const std::vector<BoundingBox>& faceBoxes,
	                        const PerOperand<BoundingBox>& boxes);
	std::int32_t counted(std::int32_t winding) const;

	std::uint32_t surfaceOf(std::uint32_t face) const { return surfaces_.ofFace[face].value; }
	std::uint32_t sideOf(std::uint32_t face, bool isBack) const {
		return 2 * surfaceOf(face) + (isBack != (surfaces_.turned[face] != 0) ? 1 : 0);
	}

	const Arrangement& arrangement_;
	const SubSurfaces& surfaces_;
	const SurfaceComplex& complex_;
	Walls walls_;
	Monitor& monitor_;
	SubBlocks& out_;
	UnionFind sides_;  // of sub-surfaces, and the outside; sets: the parts of space
	UnionFind parts_;  // sub-surfaces; sets: what edges join
	std::uint32_t outside_;
};

// At a free border both sides face the same part of space; so do those of a one-sided surface, and
// of what is not to count as a wall.
void Assembler::uniteAtBorders() {
	const auto changesNothing = [&](std::uint32_t s) {
		bool isWall = false;
		complex_.visitSources(complex_.faces[surfaces_.faces[surfaces_.all[s].firstFace]],
		                      [&](FaceId source, bool) {
			                      const OperandId operand = arrangement_.mesh.operandOf(source);
			                      isWall = isWall || !arrangement_.closed[operand] ||
			                               counted(windingStep(operand, s)) != 0;
		                      });
		return !isWall;
	};
	for (std::uint32_t s = 0; s < surfaces_.all.size(); ++s) {
		if (surfaces_.all[s].oneSided || (walls_ == Walls::Jumps && changesNothing(s))) {
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
		halfPlanes.push_back({complex_.faceOf(h).source, complex_.beginOf(h) == edge.low});
	}
	std::vector<RadialPlace> places;
	bool sorted = sortAround(arrangement_, edge.low, edge.high, halfPlanes, places);
	for (std::size_t i = 0; i + 1 < places.size() && sorted; ++i) {
		sorted = places[i].slot != places[i + 1].slot;
	}
	if (!sorted) {
		const FaceId face = halfPlanes[0].face;
		if (arrangement_.isSoup) {
			return statusOf(StatusCode::InternalError);
		}
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
// In a soup a loop's edges may have others, and each is looked at.
Status Assembler::uniteAtLoops() {
	std::vector<std::uint8_t> done(complex_.parting.size());
	Status status;
	for (const Loop& loop : arrangement_.loops) {
		for (std::size_t i = 0; i + 1 < loop.points.size() && !arrangement_.isSoup; ++i) {
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
	const auto uniteSome = [&](std::size_t begin, std::size_t end) {
		for (std::size_t e = begin; e < end && status.ok(); ++e) {
			if (done[e] == 0 && complex_.parting[e].count > 1) {
				status = uniteAround(complex_.parting[e]);
			}
		}
	};
	const Status polled = inOrderFor(complex_.parting.size(), kPollGrain, monitor_, uniteSome);
	return status.ok() ? polled : status;
}

// Whether a face runs along the lines. A line from within it can pass all else by, and so be slow.
bool Assembler::isUpright(std::uint32_t face) const {
	const Triangle& t = at(arrangement_.mesh.triangles, complex_.faces[face].source);
	const Points& points = arrangement_.mesh.points;
	return orient2d(at(points, t[0]), at(points, t[1]), at(points, t[2]), kLineAxis) == 0;
}

// Whether a is the better top of a part.
bool Assembler::isHigher(LineStart a, LineStart b) const {
	const VertexId v = complex_.faces[a.face].corners[a.corner];
	const VertexId w = complex_.faces[b.face].corners[b.corner];
	if (v == w) {
		return isUpright(b.face) && !isUpright(a.face);
	}
	const Point &place = arrangement_.coordinates(v), &other = arrangement_.coordinates(w);
	if (place[kLineAxis] != other[kLineAxis]) {
		return place[kLineAxis] > other[kLineAxis];  // rounding keeps the order
	}
	if (!arrangement_.isCurvePoint(v) && !arrangement_.isCurvePoint(w)) {
		return place > other;  // which are exact
	}
	const ExactPoint p = exactPoint(arrangement_, v), q = exactPoint(arrangement_, w);
	int order = 0;
	for (int axis = 0; axis < 3 && order == 0; ++axis) {
		order = compareCoordinate(p, q, axis);
	}
	return order > 0;
}

// The top of surfaces_.faces[begin .. end): as isHigher finds it, with one look at each height, and
// at a face only where its corner is the top so far.
LineStart Assembler::topOf(std::uint32_t begin, std::uint32_t end) const {
	const auto vertexOf = [this](LineStart s) { return complex_.faces[s.face].corners[s.corner]; };
	const auto heightOf = [this](VertexId v) { return arrangement_.coordinates(v)[kLineAxis]; };
	LineStart top{surfaces_.faces[begin], 0};
	VertexId highest = vertexOf(top);
	double height = heightOf(highest);
	bool mayBeUpright = true;
	for (std::uint32_t i = begin; i < end; ++i) {
		for (std::uint32_t corner = 0; corner < 3; ++corner) {
			const LineStart other{surfaces_.faces[i], corner};
			const VertexId v = vertexOf(other);
			if (v == highest) {
				mayBeUpright = mayBeUpright && isUpright(top.face);
				if (mayBeUpright && isHigher(other, top)) {
					top = other;
				}
			} else if (const double z = heightOf(v); z >= height && isHigher(other, top)) {
				top = other;
				highest = v;
				height = z;
				mayBeUpright = true;
			}
		}
	}
	return top;
}

// One for each part, in the order of their smallest sub-surface.
Status Assembler::findTops(std::vector<LineStart>& tops) {
	constexpr std::size_t kGrain = 1 << 14;
	struct PartTop {
		std::uint32_t part;
		LineStart top;
	};
	const std::size_t count = surfaces_.faces.size();
	std::vector<std::vector<PartTop>> chunks(chunkCount(count, kGrain));
	const auto find = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		for (auto first = static_cast<std::uint32_t>(begin); first < end;) {
			const std::uint32_t s = surfaceOf(surfaces_.faces[first]);
			const SubSurface& surface = surfaces_.all[s];
			const std::uint32_t last =
			    std::min(static_cast<std::uint32_t>(end), surface.firstFace + surface.faceCount);
			chunks[chunk].push_back({parts_.root(s), topOf(first, last)});
			first = last;
		}
	};
	const Status status =
	    parallelForChunks(count, kGrain, arrangement_.options.threads, monitor_, find);
	std::vector<std::uint32_t> number(surfaces_.all.size(), kNone);  // per root of a part
	for (const std::vector<PartTop>& chunk : chunks) {
		for (const PartTop& found : chunk) {
			if (number[found.part] == kNone) {
				number[found.part] = static_cast<std::uint32_t>(tops.size());
				tops.push_back(found.top);
			}
			LineStart& top = tops[number[found.part]];
			if (isHigher(found.top, top)) {
				top = found.top;
			}
		}
	}
	return status;
}

Status Assembler::uniteAlongLines() {
	std::vector<LineStart> tops;
	std::vector<LineHit> hits;
	Status status = findTops(tops);
	if (status.ok()) {
		status = findLineHits(arrangement_, complex_, tops, monitor_, hits);
	}
	for (std::size_t i = 0; i < hits.size() && status.ok(); ++i) {
		if (hits[i].isBeyond) {
			continue;  // what lies above it is not looked at
		}
		const bool isLast = i + 1 == hits.size() || hits[i + 1].line != hits[i].line;
		const std::uint32_t above = sideOf(hits[i].face, !hits[i].facesUp);
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
	if (!arrangement_.closed[operand]) {
		return 0;
	}
	const std::uint32_t first = surfaces_.faces[surfaces_.all[surface].firstFace];
	int step = 0;
	complex_.visitSources(complex_.faces[first], [&](FaceId source, bool opposed) {
		if (arrangement_.mesh.operandOf(source) == operand) {
			step += opposed != (surfaces_.turned[first] != 0) ? -1 : 1;
		}
	});
	return arrangement_.insideOut[operand] ? -step : step;
}

// The closed operands that have a sub-surface, each once.
std::vector<OperandId> Assembler::closedOperandsOf(std::uint32_t surface) const {
	std::vector<OperandId> operands;
	const std::uint32_t first = surfaces_.faces[surfaces_.all[surface].firstFace];
	complex_.visitSources(complex_.faces[first], [&](FaceId source, bool) {
		const OperandId operand = arrangement_.mesh.operandOf(source);
		const bool isNew = std::find(operands.begin(), operands.end(), operand) == operands.end();
		if (arrangement_.closed[operand] && isNew) {
			operands.push_back(operand);
		}
	});
	return operands;
}

// Of an operand of which only the parity of windings counts.
std::int32_t Assembler::counted(std::int32_t winding) const {
	const bool isOdd = arrangement_.isSoup && arrangement_.options.windingRule == WindingRule::Odd;
	return isOdd ? winding & 1 : winding;
}

// A closed operand that does not part space consistently intersects itself; a soup's operand does
// part it so.
Status Assembler::refuseWindings(OperandId operand, std::uint32_t surface) const {
	if (arrangement_.isSoup) {
		return statusOf(StatusCode::InternalError);
	}
	const SubSurface& wrong = surfaces_.all[surface];
	std::vector<FaceId> faces;
	VertexId corner{};
	for (std::uint32_t i = wrong.firstFace; i < wrong.firstFace + wrong.faceCount; ++i) {
		const RefinedFace& face = complex_.faces[surfaces_.faces[i]];
		complex_.visitSources(face, [&](FaceId source, bool) {
			if (arrangement_.mesh.operandOf(source) == operand) {
				faces.push_back(source);
			}
		});
		corner = face.corners[0];
	}
	return selfIntersecting(arrangement_, operand, faces, arrangement_.coordinates(corner));
}

// What a winding number adds to the sum that stands for all operands'. (A sum can hide a difference
// once in 2^64 times. Nothing is decided by it: equal sums only spare a comparison of what has to
// be equal, and is counted again by rays.)
std::uint64_t summandOf(OperandId operand, std::int32_t winding) {
	if (winding == 0) {
		return 0;
	}
	std::uint64_t bits = std::uint64_t{operand.value} << 32 | static_cast<std::uint32_t>(winding);
	bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9U;
	bits = (bits ^ bits >> 27) * 0x94d049bb133111ebU;
	return bits ^ bits >> 31;
}

PerOperand<std::int32_t> changed(PerOperand<std::int32_t> windings,
                                 const std::vector<Winding>& changes) {
	for (const Winding& change : changes) {
		windings[change.operand] = change.number;
	}
	return windings;
}

// \pre they differ
OperandId firstDifference(const PerOperand<std::int32_t>& a, const PerOperand<std::int32_t>& b) {
	const auto all = a.operands();
	return *std::find_if(all.begin(), all.end(), [&](OperandId o) { return a[o] != b[o]; });
}

// The winding numbers on the other side of a sub-surface, of the operands that have it. The sum is
// that of the numbers before, and becomes that of those behind.
std::vector<Winding> Assembler::windingsBehind(const PerOperand<std::int32_t>& before,
                                               std::uint32_t surface, bool toBack,
                                               std::uint64_t& sum) const {
	std::vector<Winding> changes;
	for (const OperandId operand : closedOperandsOf(surface)) {
		const int step = (toBack ? 1 : -1) * windingStep(operand, surface);
		changes.push_back({operand, counted(before[operand] + step)});
		sum += summandOf(operand, changes.back().number) - summandOf(operand, before[operand]);
	}
	return changes;
}

// Goes from block to block through the sub-surfaces between them, from the outside on.
Status Assembler::walkWindings() {
	const std::size_t outside = out_.all.size();
	std::vector<PerOperand<std::int32_t>> windings(outside + 1, PerOperand<std::int32_t>(0));
	std::vector<std::uint64_t> sums(outside + 1, 0);
	std::vector<std::size_t> reached{outside};
	windings[outside] = PerOperand<std::int32_t>(arrangement_.mesh.operands().count());
	const auto blockAt = [&](std::uint32_t surface, std::size_t side) {
		const std::int32_t block = out_.beside[surface][side];
		return block == kNoBlock ? outside : static_cast<std::size_t>(block);
	};
	std::vector<std::vector<std::uint32_t>> around(outside + 1);
	for (std::uint32_t s = 0; s < surfaces_.all.size(); ++s) {
		around[blockAt(s, 0)].push_back(s);
		around[blockAt(s, 1)].push_back(s);
	}
	for (std::size_t walked = 1; !reached.empty(); ++walked) {
		if (walked % kPollGrain == 0 && pollCancelled(monitor_)) {
			return statusOf(StatusCode::Cancelled);
		}
		const std::size_t block = reached.back();
		reached.pop_back();
		for (const std::uint32_t s : around[block]) {
			const bool toBack = blockAt(s, 0) == block;
			const std::size_t next = blockAt(s, toBack ? 1 : 0);
			std::uint64_t sum = sums[block];
			const std::vector<Winding> changes = windingsBehind(windings[block], s, toBack, sum);
			if (windings[next].size() == 0) {
				windings[next] = changed(windings[block], changes);
				sums[next] = sum;
				reached.push_back(next);
			} else if (sums[next] != sum) {
				const auto there = changed(windings[block], changes);
				return refuseWindings(firstDifference(there, windings[next]), s);
			}
		}
	}
	for (std::size_t i = 0; i < outside; ++i) {
		out_.all[i].windings = std::move(windings[i]);
	}
	return {};
}

// What a soup's operand encloses inside out as a whole is taken right side out.
void Assembler::turnInsideOut() {
	const auto operands = arrangement_.mesh.operands();
	out_.turned = PerOperand<bool>(operands.count());
	PerOperand<std::int32_t> least(operands.count()), most(operands.count());
	for (const SubBlock& block : out_.all) {
		for (const OperandId operand : operands) {
			least[operand] = std::min(least[operand], block.windings[operand]);
			most[operand] = std::max(most[operand], block.windings[operand]);
		}
	}
	for (const OperandId operand : operands) {
		out_.turned[operand] = arrangement_.isSoup && least[operand] < 0 && most[operand] == 0;
	}
	for (SubBlock& block : out_.all) {
		for (const OperandId operand : operands) {
			std::int32_t& winding = block.windings[operand];
			winding = out_.turned[operand] ? -winding : winding;
		}
	}
}

int Assembler::windingAt(OperandId operand, std::uint32_t side) const {
	const std::int32_t block = out_.beside[side / 2][side % 2];
	return block == kNoBlock ? 0 : out_.all[static_cast<std::size_t>(block)].windings[operand];
}

// A count at a face is another than the walk gives. A soup's never is.
Status Assembler::refuseWitness(OperandId operand, std::uint32_t face) const {
	const FaceId source = complex_.faces[face].source;
	if (arrangement_.isSoup) {
		return statusOf(StatusCode::InternalError);
	}
	return selfIntersecting(arrangement_, operand,
	                        operand == arrangement_.mesh.operandOf(source)
	                            ? std::vector<FaceId>{source}
	                            : std::vector<FaceId>{},
	                        arrangement_.coordinates(complex_.faces[face].corners[0]));
}

// Counts an operand's winding number at some faces, and compares.
Status Assembler::checkWindings(OperandId operand, const std::vector<std::uint32_t>& faces) {
	std::vector<WindingQuery> queries(faces.size());
	for (std::size_t i = 0; i < faces.size(); ++i) {
		const Triangle& t = complex_.faces[faces[i]].corners;
		for (std::size_t corner = 0; corner < 3; ++corner) {
			queries[i].inside[corner] = exactPoint(arrangement_, t[corner]);
		}
	}
	// Of many operands each has few faces: threads would wait for each other.
	constexpr std::size_t kManyOperands = 8;
	const bool areMany = arrangement_.mesh.operands().count() >= kManyOperands;
	const Status status =
	    findWindings(arrangement_.mesh, operand, {}, areMany ? 1 : arrangement_.options.threads,
	                 monitor_, queries);
	const int sign = arrangement_.insideOut[operand] ? -1 : 1;
	for (std::size_t i = 0; i < faces.size() && status.ok(); ++i) {
		const auto [inFront, behind] = std::pair(queries[i].inFront, queries[i].behind);
		if (windingAt(operand, sideOf(faces[i], false)) != counted(sign * inFront) ||
		    windingAt(operand, sideOf(faces[i], true)) != counted(sign * behind)) {
			return refuseWitness(operand, faces[i]);
		}
	}
	return status;
}

// A face of each part and of each block. (Of very many blocks some are chosen: where all walls are
// large, each ray passes all of them.)
std::vector<std::uint32_t> Assembler::witnessFaces() const {
	constexpr std::size_t kManyBlocks = 4096;
	const std::size_t stride = 1 + out_.all.size() / kManyBlocks;
	std::vector<std::uint32_t> faces;
	std::vector<std::uint8_t> isWitnessed(out_.all.size(), 0);
	const auto needsWitness = [&](std::int32_t block) {
		const auto number = static_cast<std::size_t>(block);
		return block != kNoBlock && number % stride == 0 && isWitnessed[number] == 0;
	};
	for (std::uint32_t s = 0; s < surfaces_.all.size(); ++s) {
		const std::array<std::int32_t, 2>& beside = out_.beside[s];
		if (parts_.root(s) == s || needsWitness(beside[0]) || needsWitness(beside[1])) {
			faces.push_back(surfaces_.faces[surfaces_.all[s].firstFace]);
			for (const std::int32_t block : beside) {
				if (block != kNoBlock) {
					isWitnessed[static_cast<std::size_t>(block)] = 1;
				}
			}
		}
	}
	return faces;
}

// Boxes of faces, of rounded places: what lies beyond a box of doubles does so once rounded, too.
std::vector<BoundingBox> Assembler::boxesOf(const std::vector<std::uint32_t>& faces) const {
	std::vector<BoundingBox> boxes(faces.size(), emptyBox());
	for (std::size_t i = 0; i < faces.size(); ++i) {
		for (const VertexId corner : complex_.faces[faces[i]].corners) {
			boxes[i].add(arrangement_.coordinates(corner));
		}
	}
	return boxes;
}

PerOperand<BoundingBox> Assembler::operandBoxes() const {
	const MeshArrays& mesh = arrangement_.mesh;
	PerOperand<BoundingBox> boxes(mesh.operands().count());
	for (const OperandId operand : mesh.operands()) {
		boxes[operand] = emptyBox();
		for (std::uint32_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand);
		     ++f) {
			for (const VertexId corner : mesh.triangles[f]) {
				boxes[operand].add(at(mesh.points, corner));
			}
		}
	}
	return boxes;
}

// No operand winds around a face that its box does not meet.
Status Assembler::checkFarWindings(const std::vector<std::uint32_t>& faces,
                                   const std::vector<BoundingBox>& faceBoxes,
                                   const PerOperand<BoundingBox>& boxes) {
	for (std::size_t i = 0; i < faces.size(); ++i) {
		for (const bool isBack : {false, true}) {
			const std::uint32_t side = sideOf(faces[i], isBack);
			const std::int32_t block = out_.beside[side / 2][side % 2];
			if (block == kNoBlock) {
				continue;
			}
			const auto& windings = out_.all[static_cast<std::size_t>(block)].windings;
			for (const OperandId operand : windings.operands()) {
				if (windings[operand] != 0 && commonBox(boxes[operand], faceBoxes[i]).empty()) {
					return refuseWitness(operand, faces[i]);
				}
			}
		}
	}
	return {};
}

// Parts of an operand that pass through each other have no common edge, so the walk may not show
// it: a count at one face of each part is a witness of its own. So it is at one face of each block:
// that the walk agrees with itself says nothing of the order of faces around an edge. Where there
// are many operands, most are far from most faces.
Status Assembler::checkWindings() {
	const std::vector<std::uint32_t> faces = witnessFaces();
	const std::vector<BoundingBox> faceBoxes = boxesOf(faces);
	const PerOperand<BoundingBox> boxes = operandBoxes();
	const BoxTree tree(faceBoxes);
	Status status = checkFarWindings(faces, faceBoxes, boxes);
	for (const OperandId operand : boxes.operands()) {
		if (!status.ok() || !arrangement_.closed[operand]) {
			continue;
		}
		std::vector<std::uint32_t> near;
		const auto meets = [&](const BoundingBox& box) {
			return !commonBox(boxes[operand], box).empty();
		};
		tree.visit(0, meets, [&](std::uint32_t i) { near.push_back(faces[i]); });
		std::sort(near.begin(), near.end());
		status = checkWindings(operand, near);
	}
	return status;
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
		status = inOrder([this] { return walkWindings(); }, [this] { return checkWindings(); });
		turnInsideOut();
	}
	return status;
}

}  // namespace

bool isInside(WindingRule rule, std::int32_t winding) {
	switch (rule) {
	case WindingRule::Positive:
		return winding > 0;
	case WindingRule::Odd:
		return winding % 2 != 0;
	case WindingRule::Nonzero:
		break;
	}
	return winding != 0;
}

Status findSubBlocks(const Arrangement& arrangement, const SubSurfaces& surfaces, Walls walls,
                     Monitor& monitor, SubBlocks& out) {
	out = SubBlocks{};
	return Assembler(arrangement, surfaces, walls, monitor, out).run();
}

}  // namespace index_boolean
