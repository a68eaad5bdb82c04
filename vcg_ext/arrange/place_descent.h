// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faults; out: fewer of them, by joining vertices that are stored near each other and by moving
// single ones, each with the flips that it causes. Guarantee: a trial stays only if the number of
// faults falls with it, so it ends; the order of trials depends on exact places and faults only.
#pragma once

#include "vcg_ext/arrange/piece_patches.h"
#include "vcg_ext/arrange/stored_faults.h"

#include <set>
#include <vector>

namespace index_boolean {

class PlaceDescent {
public:
	// No coordinate is stored farther than this from its rounded place.
	static constexpr double kMostUnits = 32;

	// Borrows all. \param unit the distance of the output scalar's values at the largest coordinate
	// of the operands
	PlaceDescent(Arrangement& arrangement, StoredFaults& faults, double unit, Monitor& monitor)
	    : arrangement_(arrangement), faults_(faults), unit_(unit), monitor_(monitor),
	      patches_(arrangement, faults, monitor) {}

	// Fills the arrangement's movedPlaces and placeRepair. \pre the faults have been found
	// \return Ok or Cancelled. Throws std::bad_alloc.
	// Complexity: for each cluster of faults some hundred trials, each of a few faces; no more than
	// a fixed amount of work in all.
	Status run();

private:
	// Another place for a vertex of the surface.
	struct Move {
		std::uint32_t vertex;
		Point place;
	};
	// Faces concerned that hang together, and their corners in the order in which they are tried;
	// the rank of the one whose exact place comes first.
	struct Cluster {
		std::vector<std::uint32_t> faces, vertices;
		std::uint32_t firstRank = 0;
	};

	// What is tried: to join all vertices that are near each other, which takes few trials, then
	// two of them, or to move one; at last the same with input vertices that the output scalar can
	// hold.
	enum class Kind : std::uint8_t { Join, Move, JoinInputs, MoveInputs };
	static constexpr std::size_t kKindCount = 4;

	// Larger clusters take too many trials: they are left to the rounding loop.
	static constexpr std::size_t kMostFacesTogether = 100;

	bool isDone() const;
	bool areMany() const;
	bool isMostlyTooLarge();
	bool runRound(double reach, Kind kind);
	std::vector<Cluster> clusters();
	void rankVertices(const std::vector<std::uint32_t>& faces);
	std::size_t faultsAt(std::uint32_t vertex) const;
	void sortVertices(Cluster& cluster) const;
	bool isStale(const Cluster& cluster) const;
	bool improve(const Cluster& cluster, double reach, Kind kind);
	bool join(const Cluster& cluster, double reach);
	bool joinPairs(const Cluster& cluster, double reach);
	bool moveOne(const Cluster& cluster, double reach);
	std::vector<Move> movesToOne(const std::vector<std::uint32_t>& vertices) const;
	std::vector<Point> placesAround(std::uint32_t vertex, double reach) const;
	bool attempt(const std::vector<Move>& moves);
	void setPlace(const Move& move);
	bool areNear(std::uint32_t a, std::uint32_t b, double reach) const;
	bool isInput(std::uint32_t vertex) const;
	bool isFixed(std::uint32_t vertex) const;
	bool isHeld(std::uint32_t vertex) const;
	bool mayBeAt(std::uint32_t vertex, const Point& place) const;
	VertexId nameOf(std::uint32_t vertex) const { return faults_.surface().vertices[vertex]; }

	Arrangement& arrangement_;
	StoredFaults& faults_;
	double unit_;
	Monitor& monitor_;
	PiecePatches patches_;
	std::size_t mostTrials_ = 0;  // until the cluster's turn ends
	std::size_t mostTrialsInAll_ = 0;
	bool mayMoveInputs_ = false;
	bool isMany_ = false;
	bool isAnyTooLarge_ = false;          // of the round's clusters
	std::vector<std::uint8_t> isRanked_;  // per vertex of the surface
	std::vector<std::uint32_t> rankOf_, ranked_;
	// Per kind: clusters, by their faces, that are no better for it at this reach.
	std::array<std::set<std::vector<std::uint32_t>>, kKindCount> failed_;
};

}  // namespace index_boolean
