// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces as stored; out: how much is wrong with them, kept up to date while vertices get other
// places and faces other corners. Faults are pairs of faces that meet wrongly and faces without
// area. Guarantee: exact. A change is tried: it stays if it leaves fewer faults, else it is undone.
// A look at the faces near those that change is all that a trial takes.
#pragma once

#include "vcg_ext/arrange/stored_surface.h"
#include "vcg_ext/exact/box_tree.h"

#include <map>
#include <set>
#include <vector>

namespace index_boolean {

class StoredFaults {
public:
	// \param surface borrowed, and changed
	// \param classOf per face: of one surface, faces of one class lie in the same blocks; those
	//                that coincide and are turned against each other are gone once it is cleaned
	StoredFaults(const Arrangement& arrangement, StoredSurface& surface,
	             std::vector<std::uint32_t> classOf, Monitor& monitor);

	// Finds all faults. \return Ok, Cancelled, OutOfMemory, InternalError. Once, before all else.
	Status find();

	std::size_t count() const { return pairCount_ + zeroAreaFaces_.size(); }

	// The faces concerned: in a pair, or without area. Ascending.
	std::vector<std::uint32_t> facesConcerned() const;
	std::size_t concernedCount() const { return partners_.size() + zeroAreaFaces_.size(); }
	bool isConcerned(std::uint32_t face) const {
		return partners_.count(face) != 0 || zeroAreaFaces_.count(face) != 0;
	}
	// The faces that meet one wrongly; or null.
	const std::set<std::uint32_t>* partnersOf(std::uint32_t face) const {
		const auto it = partners_.find(face);
		return it == partners_.end() ? nullptr : &it->second;
	}

	const StoredSurface& surface() const { return surface_; }
	const Point& place(std::uint32_t vertex) const {
		return surface_.places[surface_.placeOf[vertex]];
	}
	const std::vector<std::uint32_t>& facesAt(std::uint32_t vertex) const {
		return facesAt_[vertex];
	}

	// Changes, of which a trial consists.
	void setPlace(std::uint32_t vertex, const Point& place);
	void setCorners(std::uint32_t face, const IndexTriangle& corners);

	// Ends a trial. \return whether there are fewer faults: then the changes stay. Else they are
	// undone. Complexity: O(c k) for c faces changed and k faces near each of them.
	bool settle();

	// How many faces have been looked at in trials so far: the same in any numbering.
	std::size_t work() const { return work_; }

private:
	void touch(std::uint32_t face);
	void leaveHome(std::uint32_t face);
	void plantChanged();
	void write(std::uint32_t face, const IndexTriangle& corners);
	void writePlace(std::uint32_t vertex, std::uint32_t place);
	std::uint32_t placeNumber(const Point& place);
	BoundingBox boxOf(std::uint32_t face) const;
	void findNear(std::uint32_t face);
	void findMates(std::uint32_t face);
	void chooseAmongMates(std::uint32_t face);
	bool areUnited(std::uint32_t from, std::uint32_t to, std::uint32_t inClass) const;
	bool cancel(std::uint32_t a, std::uint32_t b) const;
	void removeFaults(std::uint32_t face);
	bool meetWrongly(const FacePair& pair) const;
	std::size_t countLasting() const;
	void addFaults(std::uint32_t face);
	void addPair(std::uint32_t a, std::uint32_t b);
	void removePair(std::uint32_t a, std::uint32_t b);
	void undo();
	void forget();
	Status listNeighbours();
	Status plantTrees();
	void chooseStanding();
	void chooseAgain();

	const Arrangement& arrangement_;
	StoredSurface& surface_;
	std::vector<std::uint32_t> classOf_;
	Monitor& monitor_;
	FacesView view_;                                      // by places
	std::vector<std::vector<std::uint32_t>> facesAt_;     // per vertex
	std::vector<std::vector<std::uint32_t>> verticesAt_;  // per place
	std::map<Point, std::uint32_t> numberOf_;             // places that faces have been tried in
	std::vector<std::uint8_t> stands_;  // per face: it is still there once cleaned
	// Where a face is found by its box: among the faces as they were at first, among those that had
	// changed when their tree was planted, or in the list of those that have changed since.
	enum class Home : std::uint8_t { First, Changed, Recent };
	std::vector<BoxTree> trees_;  // over the faces as they were at first
	BoxTree changedTree_;         // over `changed_`, by place in it
	std::vector<std::uint32_t> changed_;
	std::vector<Home> home_;                              // per face
	std::vector<std::pair<std::uint32_t, Home>> recent_;  // and where they were before

	std::map<std::uint32_t, std::set<std::uint32_t>> partners_;  // per face in a pair
	std::set<std::uint32_t> zeroAreaFaces_;
	std::size_t pairCount_ = 0, work_ = 0;

	// Of the trial.
	std::vector<std::uint8_t> isTouched_;  // per face
	std::vector<std::uint32_t> touched_;
	std::vector<std::uint8_t> stoodBefore_;  // per touched face
	std::vector<std::pair<std::uint32_t, IndexTriangle>> cornersBefore_;
	std::vector<std::array<std::uint32_t, 2>> placesBefore_;  // vertex, place
	std::vector<FacePair> pairsRemoved_, pairsAdded_;
	std::vector<std::uint32_t> zeroAreaRemoved_, zeroAreaAdded_;
	std::size_t recentBefore_ = 0;
	std::vector<std::uint32_t> near_, mates_;
};

}  // namespace index_boolean
