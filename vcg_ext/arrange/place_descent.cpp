// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances are measured in doubles: they say what is tried, never what is kept.
#include "vcg_ext/arrange/place_descent.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"
#include "vcg_ext/base/union_find.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace index_boolean {

namespace {

// Along each axis.
double distance(const Point& a, const Point& b) {
	return std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])});
}

}  // namespace

bool PlaceDescent::isDone() const {
	constexpr std::size_t kMostWork = 4000000;  // faces
	return faults_.count() == 0 || arrangement_.placeRepair.trials >= mostTrialsInAll_ ||
	       faults_.work() >= kMostWork || pollCancelled(monitor_);
}

bool PlaceDescent::isInput(std::uint32_t vertex) const {
	return !arrangement_.isCurvePoint(nameOf(vertex));
}

// Whether it is an input vertex that the output scalar can hold.
bool PlaceDescent::isHeld(std::uint32_t vertex) const {
	const VertexId v = nameOf(vertex);
	return isInput(vertex) && roundedPlace(arrangement_, v) == arrangement_.coordinates(v);
}

bool PlaceDescent::isFixed(std::uint32_t vertex) const {
	return faults_.surface().isWhole[vertex] == 0 || (!mayMoveInputs_ && isHeld(vertex));
}

bool PlaceDescent::mayBeAt(std::uint32_t vertex, const Point& place) const {
	const Point rounded = roundedPlace(arrangement_, nameOf(vertex));
	return !isFixed(vertex) && distance(rounded, place) <= kMostUnits * unit_ &&
	       std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); });
}

bool PlaceDescent::areNear(std::uint32_t a, std::uint32_t b, double reach) const {
	return distance(faults_.place(a), faults_.place(b)) <= reach;
}

void PlaceDescent::setPlace(const Move& move) {
	const VertexId v = nameOf(move.vertex);
	Point rounded = roundedPlace(arrangement_, v);
	if (rounded == move.place) {
		arrangement_.movedPlaces.erase(v);
	} else {
		arrangement_.movedPlaces[v] = move.place;
	}
}

// \return whether it is better now; else nothing has changed
bool PlaceDescent::attempt(const std::vector<Move>& moves) {
	if (moves.empty() || arrangement_.placeRepair.trials >= mostTrials_ || isDone()) {
		return false;
	}
	std::vector<Move> before;
	std::vector<std::uint32_t> vertices;
	for (const Move& move : moves) {
		before.push_back({move.vertex, faults_.place(move.vertex)});
		vertices.push_back(move.vertex);
		faults_.setPlace(move.vertex, move.place);
		setPlace(move);
	}
	patches_.flipAround(vertices);
	++arrangement_.placeRepair.trials;
	if (faults_.settle()) {
		return true;
	}
	for (const Move& move : before) {
		setPlace(move);
	}
	return false;
}

// In the order of exact places: the first is that of an input vertex, if there is any.
std::vector<PlaceDescent::Move>
PlaceDescent::movesToOne(const std::vector<std::uint32_t>& vertices) const {
	std::uint32_t target = vertices.front();
	for (const std::uint32_t v : vertices) {
		const auto rank = [this](std::uint32_t u) {
			return isFixed(u) ? 0 : isHeld(u) ? 1 : isInput(u) ? 2 : 3;
		};
		if (rank(v) != rank(target) ? rank(v) < rank(target)
		                            : faults_.place(v) < faults_.place(target)) {
			target = v;
		}
	}
	std::vector<Move> moves;
	const Point& place = faults_.place(target);
	for (const std::uint32_t v : vertices) {
		if (faults_.place(v) != place && mayBeAt(v, place)) {
			moves.push_back({v, place});
		}
	}
	return moves;
}

bool PlaceDescent::join(const Cluster& cluster, double reach) {
	const std::vector<std::uint32_t>& vertices = cluster.vertices;
	UnionFind sets(vertices.size());
	for (std::uint32_t i = 0; i < vertices.size(); ++i) {
		for (std::uint32_t j = i + 1; j < vertices.size(); ++j) {
			if (areNear(vertices[i], vertices[j], reach)) {
				sets.unite(i, j);
			}
		}
	}
	std::map<std::uint32_t, std::vector<std::uint32_t>> members;
	for (std::uint32_t i = 0; i < vertices.size(); ++i) {
		members[sets.find(i)].push_back(vertices[i]);
	}
	std::vector<std::vector<Move>> each;
	std::vector<Move> all;
	for (const auto& [root, set] : members) {
		each.push_back(movesToOne(set));
		all.insert(all.end(), each.back().begin(), each.back().end());
	}
	return attempt(all) ||
	       (each.size() > 1 && std::any_of(each.begin(), each.end(),
	                                       [this](const auto& moves) { return attempt(moves); }));
}

bool PlaceDescent::joinPairs(const Cluster& cluster, double reach) {
	const std::vector<std::uint32_t>& vertices = cluster.vertices;
	for (const std::uint32_t v : vertices) {
		if (isDone()) {
			return false;
		}
		for (const std::uint32_t other : vertices) {
			if (v != other && faults_.place(v) != faults_.place(other) &&
			    areNear(v, other, reach) && mayBeAt(v, faults_.place(other)) &&
			    attempt({{v, faults_.place(other)}})) {
				return true;
			}
		}
	}
	return false;
}

// The 26 neighbours of a vertex's place in steps of its own coordinates, and in steps that are the
// same for all: nearest first.
std::vector<Point> PlaceDescent::placesAround(std::uint32_t vertex, double reach) const {
	const OutputScalar scalar = arrangement_.options.outputScalar;
	const Point at = faults_.place(vertex);
	std::vector<std::pair<double, Point>> found;
	for (const bool isOwn : {true, false}) {
		for (int i = 0; i < 27; ++i) {
			const std::array<int, 3> way{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
			Point place = at;
			double square = 0;
			for (std::size_t axis = 0; axis < 3; ++axis) {
				const double gap = isOwn ? gapAt(at[axis], scalar) / unit_ : 1;
				place[axis] = inScalar(at[axis] + way[axis] * gap * reach, scalar);
				const double moved = (place[axis] - at[axis]) / unit_;
				square += moved * moved;
			}
			if (place != at && mayBeAt(vertex, place)) {
				found.emplace_back(square, place);
			}
		}
	}
	std::sort(found.begin(), found.end());
	found.erase(std::unique(found.begin(), found.end()), found.end());
	std::vector<Point> places;
	for (const auto& [square, place] : found) {
		places.push_back(place);
	}
	return places;
}

// Input vertices come last.
bool PlaceDescent::moveOne(const Cluster& cluster, double reach) {
	for (const bool areInput : {false, true}) {
		for (const std::uint32_t v : cluster.vertices) {
			if (isDone()) {
				return false;
			}
			if (isInput(v) != areInput || isFixed(v)) {
				continue;
			}
			for (const Point& place : placesAround(v, reach)) {
				if (attempt({{v, place}})) {
					return true;
				}
			}
		}
	}
	return false;
}

bool PlaceDescent::improve(const Cluster& cluster, double reach, Kind kind) {
	constexpr std::size_t kMostTrials = 1000;  // so that others have their turn
	mostTrials_ = arrangement_.placeRepair.trials + kMostTrials;
	mayMoveInputs_ = kind == Kind::JoinInputs || kind == Kind::MoveInputs;
	return kind == Kind::Join || kind == Kind::JoinInputs
	           ? join(cluster, reach)
	           : joinPairs(cluster, reach) || moveOne(cluster, reach);
}

// Ranks the corners of faces in the order of their exact places. Comparing takes long, so each is
// put among the others once.
void PlaceDescent::rankVertices(const std::vector<std::uint32_t>& faces) {
	isRanked_.resize(faults_.surface().vertices.size());
	rankOf_.resize(isRanked_.size());
	const auto isBefore = [this](std::uint32_t a, std::uint32_t b) {
		return comparePlaces(arrangement_, nameOf(a), nameOf(b)) < 0;
	};
	for (const std::uint32_t face : faces) {
		for (const std::uint32_t v : faults_.surface().corners[face]) {
			if (isRanked_[v] == 0 && !pollCancelled(monitor_)) {
				isRanked_[v] = 1;
				ranked_.insert(std::lower_bound(ranked_.begin(), ranked_.end(), v, isBefore), v);
			}
		}
	}
	for (std::uint32_t rank = 0; rank < ranked_.size(); ++rank) {
		rankOf_[ranked_[rank]] = rank;
	}
}

// How many faults the faces at a vertex have; those that two of them have count twice.
std::size_t PlaceDescent::faultsAt(std::uint32_t vertex) const {
	std::size_t count = 0;
	for (const std::uint32_t face : faults_.facesAt(vertex)) {
		const auto* partners = faults_.partnersOf(face);
		count += partners != nullptr ? partners->size() : faults_.isConcerned(face) ? 1 : 0;
	}
	return count;
}

// Those with most faults come first, since few trials are left for the last of many.
void PlaceDescent::sortVertices(Cluster& cluster) const {
	std::vector<std::uint32_t> vertices;
	for (const std::uint32_t face : cluster.faces) {
		const IndexTriangle& t = faults_.surface().corners[face];
		vertices.insert(vertices.end(), t.begin(), t.end());
	}
	sortUnique(vertices);
	struct Order {
		std::size_t faults;
		std::uint32_t rank, vertex;
	};
	std::vector<Order> order;
	cluster.firstRank = rankOf_[vertices[0]];
	for (const std::uint32_t v : vertices) {
		order.push_back({faultsAt(v), rankOf_[v], v});
		cluster.firstRank = std::min(cluster.firstRank, rankOf_[v]);
	}
	std::sort(order.begin(), order.end(), [](const Order& a, const Order& b) {
		return a.faults != b.faults ? a.faults > b.faults : a.rank < b.rank;
	});
	for (const Order& o : order) {
		cluster.vertices.push_back(o.vertex);
	}
}

// Faces that meet wrongly, or have a place in common, are of one cluster. In the order of places.
std::vector<PlaceDescent::Cluster> PlaceDescent::clusters() {
	const std::vector<std::uint32_t> faces = faults_.facesConcerned();
	rankVertices(faces);
	UnionFind sets(faces.size());
	const auto indexOf = [&faces](std::uint32_t face) {
		return static_cast<std::uint32_t>(std::lower_bound(faces.begin(), faces.end(), face) -
		                                  faces.begin());
	};
	std::map<std::uint32_t, std::uint32_t> firstAt;  // per place
	for (std::uint32_t i = 0; i < faces.size(); ++i) {
		for (const std::uint32_t place : faults_.surface().stored[faces[i]]) {
			sets.unite(i, firstAt.emplace(place, i).first->second);
		}
		if (const auto* partners = faults_.partnersOf(faces[i])) {
			for (const std::uint32_t other : *partners) {
				sets.unite(i, indexOf(other));
			}
		}
	}
	std::map<std::uint32_t, Cluster> found;
	for (std::uint32_t i = 0; i < faces.size(); ++i) {
		found[sets.find(i)].faces.push_back(faces[i]);
	}
	std::vector<Cluster> list;
	for (auto& [root, cluster] : found) {
		sortVertices(cluster);
		list.push_back(std::move(cluster));
	}
	std::sort(list.begin(), list.end(),
	          [](const Cluster& a, const Cluster& b) { return a.firstRank < b.firstRank; });
	return list;
}

// Whether a cluster is no longer what it was when the round began.
bool PlaceDescent::isStale(const Cluster& cluster) const {
	return !std::all_of(cluster.faces.begin(), cluster.faces.end(),
	                    [this](std::uint32_t face) { return faults_.isConcerned(face); });
}

// Whether most of the faces concerned hang together in clusters that are not tried.
bool PlaceDescent::isMostlyTooLarge() {
	std::size_t faces = 0;
	for (const Cluster& cluster : clusters()) {
		faces += cluster.faces.size() > kMostFacesTogether ? cluster.faces.size() : 0;
	}
	return 2 * faces > faults_.concernedCount();
}

// \return whether any cluster is better now
bool PlaceDescent::runRound(double reach, Kind kind) {
	isAnyTooLarge_ = false;
	++arrangement_.placeRepair.rounds;
	std::set<std::vector<std::uint32_t>>& failed = failed_[static_cast<std::size_t>(kind)];
	bool isBetter = false;
	for (const Cluster& cluster : clusters()) {
		if (isDone()) {
			break;
		}
		if (isMany_ && cluster.faces.size() > kMostFacesTogether) {
			isAnyTooLarge_ = true;
			continue;
		}
		if (isStale(cluster) || failed.count(cluster.faces) != 0) {
			continue;
		}
		if (improve(cluster, reach, kind)) {
			isBetter = true;
		} else {
			failed.insert(cluster.faces);
		}
	}
	return isBetter;
}

// Whether there are too many faults to try all that can be tried on each: some more are not too
// many in a small arrangement, where trials take little.
bool PlaceDescent::areMany() const {
	constexpr std::size_t kFewFaces = 300;
	constexpr std::size_t kSmall = 1500, kMoreFaces = 500, kMoreFaults = 700;
	const std::size_t concerned = faults_.concernedCount();
	const bool isSmall = arrangement_.refinement.pieces.size() <= kSmall;
	return concerned > (isSmall ? kMoreFaces : kFewFaces) ||
	       (concerned > kFewFaces && faults_.count() > kMoreFaults);
}

Status PlaceDescent::run() {
	constexpr double kMostSteps = 16;
	PlaceRepair& report = arrangement_.placeRepair;
	report.concernedBefore = faults_.concernedCount();
	report.faultsBefore = faults_.count();
	// A fault that goes takes about ten; what needs many more, the rounding loop cures sooner.
	constexpr std::size_t kFewTrials = 1000, kTrialsPerFault = 10, kMostTrials = 60000;
	isMany_ = areMany();
	mostTrialsInAll_ = arrangement_.options.thoroughRepair && !isMany_
	                       ? kMostTrials
	                       : std::min(kMostTrials, kFewTrials + kTrialsPerFault * faults_.count());
	if (isMany_ && isMostlyTooLarge()) {
		report.isGivenUp = true;
		report.concernedAfter = report.concernedBefore;
		report.faultsAfter = report.faultsBefore;
		return pollCancelled(monitor_) ? statusOf(StatusCode::Cancelled) : Status{};
	}
	double steps = 1;
	while (steps <= kMostSteps && !isDone()) {
		const auto isBetter = [&](Kind kind) { return runRound(steps * unit_, kind); };
		if (!isBetter(Kind::Join) && !isBetter(Kind::Move) && !isBetter(Kind::JoinInputs) &&
		    !isBetter(Kind::MoveInputs)) {
			steps *= 2;
			failed_ = {};
		}
	}
	report.isGivenUp = (isAnyTooLarge_ || steps <= kMostSteps) && faults_.count() != 0;
	report.concernedAfter = faults_.concernedCount();
	report.faultsAfter = faults_.count();
	for (const auto& [vertex, place] : arrangement_.movedPlaces) {
		const Point rounded = roundedPlace(arrangement_, vertex);
		report.largestMove =
		    std::max(report.largestMove, std::hypot(place[0] - rounded[0], place[1] - rounded[1],
		                                            place[2] - rounded[2]));
	}
	return pollCancelled(monitor_) ? statusOf(StatusCode::Cancelled) : Status{};
}

}  // namespace index_boolean
