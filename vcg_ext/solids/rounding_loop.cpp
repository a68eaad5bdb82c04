// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A round that leaves much fewer faults is where the next one goes on. Else it is tried again with
// vertices joined from farther away: to arrange without joining, again and again, makes more faults
// than it cures on surfaces that are nearly the same, and may come back to where it was.
#include "vcg_ext/solids/rounding_loop.h"

#include "vcg_ext/arrange/near_places.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/stored_operands.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

// The least and the largest winding number of each operand, 0 among them.
using WindingRange = PerOperand<std::array<std::int32_t, 2>>;

WindingRange windingRange(const Arrangement& arrangement) {
	WindingRange range(arrangement.mesh.operands().count());
	if (!arrangement.cells.areKnown()) {  // embedded, right side out
		std::fill(range.begin(), range.end(), std::array<std::int32_t, 2>{0, 1});
	}
	for (const PerOperand<std::int32_t>& windings : arrangement.cells.windings) {
		for (const OperandId operand : windings.operands()) {
			auto& [least, most] = range[operand];
			least = std::min(least, windings[operand]);
			most = std::max(most, windings[operand]);
		}
	}
	return range;
}

// What rounding has folded is inside twice, or the wrong way round: no cell's winding number is
// beyond those of the exact operands then.
void keepWithin(const WindingRange& range, CellLabels& cells) {
	for (PerOperand<std::int32_t>& windings : cells.windings) {
		for (const OperandId operand : windings.operands()) {
			const auto [least, most] = range[operand];
			windings[operand] = std::clamp(windings[operand], least, most);
		}
	}
}

Points placesConcerned(const Arrangement& arrangement) {
	Points places;
	for (const VertexId v : arrangement.placeRepair.concerned) {
		places.push_back(outputCoordinates(arrangement, v));
	}
	return places;
}

std::size_t sizeOf(const Arrangement& arrangement) {
	return arrangement.mesh.triangles.size() + arrangement.refinement.pieces.size();
}

double distance(const Point& a, const Point& b) {
	return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class RoundingLoop {
public:
	RoundingLoop(const ArrangeSoup& arrangeAgain, Monitor& monitor, Arrangement& first)
	    : arrangeAgain_(arrangeAgain), monitor_(monitor), first_(first),
	      range_(windingRange(first)) {}

	Status run();

private:
	Status takeLatest(double reach, StoredOperands& operands);
	Status arrangeOnceMore(StoredOperands operands, StoredAgain& next);
	void nameAsFirst(const StoredOperands& operands, const OperandOffsets& given,
	                 StoredAgain& next) const;
	std::vector<std::uint8_t> ranksOf(const StoredOperands& operands) const;
	VertexId firstVertex(VertexId v) const {  // of a vertex of the latest arrangement
		if (latest_ == nullptr) {
			return v;
		}
		return v.value < latest_->vertexOf.size() ? at(latest_->vertexOf, v) : VertexId::none();
	}
	static bool takesRound(const PlaceRepair& before, const PlaceRepair& after, double reach);
	bool hasGrown() const;
	void report();
	const Arrangement& latest() const { return latest_ ? latest_->arrangement : first_; }

	const ArrangeSoup& arrangeAgain_;
	Monitor& monitor_;
	Arrangement& first_;
	WindingRange range_;
	std::shared_ptr<StoredAgain> latest_, best_;
};

// Notes what the elements of the next arrangement are in the first one. \param operands that it is
// of, as they were taken from the latest one \param given where each one's faces began
void RoundingLoop::nameAsFirst(const StoredOperands& operands, const OperandOffsets& given,
                               StoredAgain& next) const {
	const Arrangement& arrangement = next.arrangement;
	for (std::uint32_t f = 0; f < arrangement.mesh.triangles.size(); ++f) {
		const std::size_t taken =
		    given.begin(arrangement.mesh.operandOf({f})) + arrangement.givenFace({f});
		FaceSource source = operands.faceOf[taken];
		std::uint32_t piece = operands.pieceOf[taken];
		if (latest_ != nullptr) {
			const FaceSource& before = at(latest_->faceOf, source.face);
			piece = at(latest_->pieceOf, source.face);
			source = {before.face, source.turned != before.turned};
		}
		next.faceOf.push_back(source);
		next.pieceOf.push_back(piece);
	}
	for (VertexId& v : next.vertexOf) {
		v = firstVertex(v);
	}
}

// Which vertices stay where others are joined to them: input vertices of the first arrangement.
std::vector<std::uint8_t> RoundingLoop::ranksOf(const StoredOperands& operands) const {
	std::vector<std::uint8_t> ranks;
	ranks.reserve(operands.vertexOf.size());
	for (const VertexId taken : operands.vertexOf) {
		const VertexId v = firstVertex(taken);
		const bool isInput = v != VertexId::none() && !first_.isCurvePoint(v);
		ranks.push_back(isInput ? 0 : 1);
	}
	return ranks;
}

// Takes the latest arrangement's refined operands as they are stored, near vertices joined.
// \param reach within which vertices are joined, in units of the scalar; 0: none is
Status RoundingLoop::takeLatest(double reach, StoredOperands& operands) {
	const Status status = takeStoredOperands(latest(), monitor_, operands);
	if (status.ok() && reach > 0) {
		Points& points = operands.mesh.points;
		joinNearPlaces(placesConcerned(latest()), ranksOf(operands),
		               reach * unitOf(points, first_.options.outputScalar), points);
	}
	return status;
}

Status RoundingLoop::arrangeOnceMore(StoredOperands operands, StoredAgain& next) {
	next.vertexOf = std::move(operands.vertexOf);
	Options options = first_.options;
	options.selfIntersections = SelfIntersections::Resolve;
	// A tangle of needles may become any number of pieces: that is too large, and no help.
	constexpr std::size_t kMostGrowth = 32, kRoom = 1000;
	options.mostElements = std::min(options.mostElements, kMostGrowth * sizeOf(first_) + kRoom);
	options.thoroughRepair = false;  // what takes many trials, the next round cures sooner
	// The pieces of a face are faces now; their classes let only them be merged again.
	options.mergeCoplanar = options.mergeCoplanar || options.mergeFragments;
	const OperandOffsets given = operands.mesh.faceOffsets;
	const Status status = arrangeAgain_(std::move(operands.mesh), options, next.arrangement);
	if (status.ok()) {
		keepWithin(range_, next.arrangement.cells);
		nameAsFirst(operands, given, next);
	}
	return status;
}

void RoundingLoop::report() {
	PlaceRepair& report = first_.placeRepair;
	const Arrangement& again = best_->arrangement;
	report.faultsAfter = again.placeRepair.faultsAfter;
	report.concernedAfter = again.placeRepair.concernedAfter;
	report.isGivenUp = again.placeRepair.isGivenUp;
	report.areFacesFine = false;  // of this arrangement's faces
	report.largestMove = again.placeRepair.largestMove;
	for (std::size_t v = 0; v < best_->vertexOf.size(); ++v) {
		const VertexId before = best_->vertexOf[v];
		if (before != VertexId::none()) {
			const Point stored = outputCoordinates(again, makeId<VertexTag>(v));
			report.largestMove =
			    std::max(report.largestMove, distance(stored, roundedPlace(first_, before)));
		}
	}
}

// Whether the next round goes on from this one: it has left much fewer faults, or fewer of few, or
// there is no wider reach to try from where it began.
bool RoundingLoop::takesRound(const PlaceRepair& before, const PlaceRepair& after, double reach) {
	constexpr double kLargestReach = 8;
	constexpr std::size_t kFewFaults = 50;
	const bool isBetter = after.faultsAfter < before.faultsAfter;
	return after.faultsAfter <= before.faultsAfter / 4 ||
	       (isBetter && before.faultsAfter <= kFewFaults) || reach >= kLargestReach;
}

// Whether the next round would be of much more than the first: it grows then from round to round,
// on walls that are nearly coplanar.
bool RoundingLoop::hasGrown() const {
	constexpr std::size_t kRoom = 200;
	return sizeOf(latest()) > 2 * sizeOf(first_) + kRoom;
}

Status RoundingLoop::run() {
	constexpr std::size_t kMostRounds = 8;
	// Few faults are cut and gone; to join the vertices of nearly coplanar walls makes more of
	// them.
	constexpr std::size_t kFewFaces = 300;
	double reach = first_.placeRepair.concernedAfter <= kFewFaces ? 0 : 1;
	std::size_t fewest = first_.placeRepair.faultsAfter;
	std::shared_ptr<StoredAgain> next;
	Points arranged;  // of the operands of `next`
	std::size_t rounds = 0;
	while (rounds < kMostRounds && fewest > 0 && !hasGrown()) {
		StoredOperands operands;
		Status status = takeLatest(reach, operands);
		if (!status.ok()) {
			return status;
		}
		// A wider reach need not join more.
		if (next == nullptr || operands.mesh.points != arranged) {
			arranged = operands.mesh.points;
			next = std::make_shared<StoredAgain>();
			status = arrangeOnceMore(std::move(operands), *next);
			if (status.code == StatusCode::Cancelled || status.code == StatusCode::OutOfMemory) {
				return status;
			}
			if (!status.ok()) {
				break;  // it has become too large, or nothing is left of an operand
			}
			++rounds;
		}
		const PlaceRepair& left = next->arrangement.placeRepair;
		if (left.faultsAfter < fewest) {
			fewest = left.faultsAfter;
			best_ = next;
		}
		if (takesRound(latest().placeRepair, left, reach)) {
			latest_ = next;
			next = nullptr;
		} else {
			reach = reach == 0 ? 1 : 2 * reach;
		}
	}
	first_.placeRepair.rounds += rounds;
	if (best_ != nullptr) {
		report();
		first_.again = best_;
	}
	return {};
}

}  // namespace

Status holdAsStored(const ArrangeSoup& arrangeAgain, Monitor& monitor, Arrangement& out) {
	return RoundingLoop(arrangeAgain, monitor, out).run();
}

}  // namespace index_boolean
