// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces on the same three places are mates. Those that cleaning cancels out take no part, and of
// twins, on the same vertices, only one. So a trial concerns the faces that change and their mates,
// before and after. Whether vertices in one place are united may change with a face that collapses:
// the mates at its corners are looked at again.
#include "vcg_ext/arrange/stored_faults.h"

#include "vcg_ext/arrange/parted_faces.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/zero_area.h"
#include "vcg_ext/mesh/face_key.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

bool meet(const BoundingBox& a, const BoundingBox& b) {
	return a.lo[0] <= b.hi[0] && b.lo[0] <= a.hi[0] && a.lo[1] <= b.hi[1] && b.lo[1] <= a.hi[1] &&
	       a.lo[2] <= b.hi[2] && b.lo[2] <= a.hi[2];
}

}  // namespace

StoredFaults::StoredFaults(const Arrangement& arrangement, StoredSurface& surface,
                           std::vector<std::uint32_t> classOf, Monitor& monitor)
    : arrangement_(arrangement), surface_(surface), classOf_(std::move(classOf)), monitor_(monitor),
      view_(surface.places, surface.stored.data(), surface.stored.size()) {}

BoundingBox StoredFaults::boxOf(std::uint32_t face) const {
	BoundingBox box = emptyBox();
	for (const std::uint32_t place : surface_.stored[face]) {
		box.add(surface_.places[place]);
	}
	return box;
}

// Which faces are at each vertex, which vertices in each place, which number each place has.
Status StoredFaults::listNeighbours() {
	facesAt_.resize(surface_.vertices.size());
	verticesAt_.resize(surface_.places.size());
	return inOrder(
	    [&] {
		    return inOrderFor(surface_.corners.size(), kGrain, monitor_,
		                      [this](std::size_t begin, std::size_t end) {
			                      for (std::size_t f = begin; f < end; ++f) {
				                      for (const std::uint32_t v : surface_.corners[f]) {
					                      facesAt_[v].push_back(static_cast<std::uint32_t>(f));
				                      }
			                      }
		                      });
	    },
	    [&] {
		    return inOrderFor(surface_.vertices.size(), kGrain, monitor_,
		                      [this](std::size_t begin, std::size_t end) {
			                      for (std::size_t v = begin; v < end; ++v) {
				                      const std::uint32_t place = surface_.placeOf[v];
				                      verticesAt_[place].push_back(static_cast<std::uint32_t>(v));
				                      numberOf_[surface_.places[place]] = place;
			                      }
		                      });
	    });
}

// A tree for so many faces each: none takes long.
Status StoredFaults::plantTrees() {
	const std::size_t faceCount = surface_.corners.size();
	trees_.resize(chunkCount(faceCount, kGrain));
	return parallelForChunks(faceCount, kGrain, arrangement_.options.threads, monitor_,
	                         [this](std::size_t chunk, std::size_t begin, std::size_t end) {
		                         std::vector<BoundingBox> boxes;
		                         for (std::size_t f = begin; f < end; ++f) {
			                         boxes.push_back(boxOf(static_cast<std::uint32_t>(f)));
		                         }
		                         trees_[chunk] = BoxTree(std::move(boxes));
	                         });
}

Status StoredFaults::find() {
	const std::size_t faceCount = surface_.corners.size();
	const Status listed =
	    inOrder([this] { return listNeighbours(); }, [this] { return plantTrees(); });
	if (!listed.ok()) {
		return listed;
	}
	home_.resize(faceCount, Home::First);
	isTouched_.resize(faceCount);
	stands_.resize(faceCount);
	chooseStanding();
	std::vector<std::uint32_t> standing;
	for (std::uint32_t f = 0; f < faceCount; ++f) {
		if (stands_[f] != 0) {
			standing.push_back(f);
		}
	}
	WrongPairs wrong;
	const Status status =
	    findFaults(surface_, standing, arrangement_.options.threads, monitor_, wrong);
	for (const FacePair& pair : wrong.pairs) {
		addPair(pair.a.value, pair.b.value);
	}
	zeroAreaFaces_.insert(wrong.zeroAreaFaces.begin(), wrong.zeroAreaFaces.end());
	return status;
}

// At first: each face that is not collapsed, but for mates that do not.
void StoredFaults::chooseStanding() {
	std::vector<KeyedFace<std::uint32_t>> keyed;
	for (std::uint32_t f = 0; f < stands_.size(); ++f) {
		stands_[f] = isCollapsed(surface_.stored[f]) ? 0 : 1;
		if (stands_[f] != 0) {
			keyed.push_back({faceKeyOf(surface_.stored[f]), f});
		}
	}
	std::sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) {
		return a.key != b.key ? a.key < b.key : a.face < b.face;
	});
	for (std::size_t i = 1; i < keyed.size(); ++i) {
		if (keyed[i].key == keyed[i - 1].key && isTouched_[keyed[i].face] == 0 &&
		    !pollCancelled(monitor_)) {
			chooseAmongMates(keyed[i].face);
		}
	}
	forget();
}

std::vector<std::uint32_t> StoredFaults::facesConcerned() const {
	std::vector<std::uint32_t> faces(zeroAreaFaces_.begin(), zeroAreaFaces_.end());
	for (const auto& [face, others] : partners_) {
		faces.push_back(face);
	}
	std::sort(faces.begin(), faces.end());
	return faces;
}

// The faces with boxes that meet that of one, without it.
void StoredFaults::findNear(std::uint32_t face) {
	near_.clear();
	const BoundingBox box = boxOf(face);
	for (std::size_t tree = 0; tree < trees_.size(); ++tree) {
		const auto first = static_cast<std::uint32_t>(tree * kGrain);
		trees_[tree].visit(
		    0, [&box](const BoundingBox& other) { return meet(box, other); },
		    [&](std::uint32_t i) {
			    if (first + i != face && home_[first + i] == Home::First) {
				    near_.push_back(first + i);
			    }
		    });
	}
	changedTree_.visit(
	    0, [&box](const BoundingBox& other) { return meet(box, other); },
	    [&](std::uint32_t i) {
		    if (changed_[i] != face && home_[changed_[i]] == Home::Changed) {
			    near_.push_back(changed_[i]);
		    }
	    });
	for (const auto& [other, before] : recent_) {
		if (other != face && meet(box, boxOf(other))) {
			near_.push_back(other);
		}
	}
}

// The faces on the same three places as one, with it, ascending; itself alone if it is collapsed.
void StoredFaults::findMates(std::uint32_t face) {
	mates_.assign(1, face);
	if (isCollapsed(surface_.stored[face])) {
		return;
	}
	const auto key = faceKeyOf(surface_.stored[face]);
	for (const std::uint32_t v : verticesAt_[surface_.stored[face][0]]) {
		for (const std::uint32_t other : facesAt_[v]) {
			if (other != face && faceKeyOf(surface_.stored[other]) == key) {
				mates_.push_back(other);
			}
		}
	}
	std::sort(mates_.begin(), mates_.end());
}

// A face that is about to change, or that others leave or join.
void StoredFaults::touch(std::uint32_t face) {
	if (isTouched_[face] == 0) {
		isTouched_[face] = 1;
		touched_.push_back(face);
		stoodBefore_.push_back(stands_[face]);
	}
}

// A face of which no tree knows where it is any more.
void StoredFaults::leaveHome(std::uint32_t face) {
	if (home_[face] != Home::Recent) {
		recent_.emplace_back(face, home_[face]);
		home_[face] = Home::Recent;
	}
}

// Gathers the faces that have changed so far in a tree, so that the list of recent ones stays
// short.
void StoredFaults::plantChanged() {
	for (const auto& [face, before] : recent_) {
		if (before == Home::First) {
			changed_.push_back(face);
		}
		home_[face] = Home::Changed;
	}
	recent_.clear();
	std::vector<BoundingBox> boxes;
	boxes.reserve(changed_.size());
	for (const std::uint32_t face : changed_) {
		boxes.push_back(boxOf(face));
	}
	changedTree_ = BoxTree(std::move(boxes));
}

std::uint32_t StoredFaults::placeNumber(const Point& place) {
	const auto next = static_cast<std::uint32_t>(surface_.places.size());
	const auto [it, isNew] = numberOf_.emplace(place, next);
	if (isNew) {
		surface_.places.push_back(place);
		verticesAt_.emplace_back();
	}
	return it->second;
}

void StoredFaults::write(std::uint32_t face, const IndexTriangle& corners) {
	for (const std::uint32_t v : surface_.corners[face]) {
		auto& list = facesAt_[v];
		list.erase(std::find(list.begin(), list.end(), face));
	}
	for (const std::uint32_t v : corners) {
		facesAt_[v].push_back(face);
	}
	surface_.corners[face] = corners;
	for (std::size_t i = 0; i < 3; ++i) {
		surface_.stored[face][i] = surface_.placeOf[corners[i]];
	}
}

void StoredFaults::writePlace(std::uint32_t vertex, std::uint32_t place) {
	std::vector<std::uint32_t>& before = verticesAt_[surface_.placeOf[vertex]];
	before.erase(std::find(before.begin(), before.end(), vertex));
	verticesAt_[place].push_back(vertex);
	surface_.placeOf[vertex] = place;
	for (const std::uint32_t face : facesAt_[vertex]) {
		for (std::size_t i = 0; i < 3; ++i) {
			surface_.stored[face][i] = surface_.placeOf[surface_.corners[face][i]];
		}
	}
}

void StoredFaults::setPlace(std::uint32_t vertex, const Point& place) {
	for (const std::uint32_t face : facesAt_[vertex]) {
		findMates(face);
		std::for_each(mates_.begin(), mates_.end(), [this](std::uint32_t f) { touch(f); });
		leaveHome(face);
	}
	placesBefore_.push_back({vertex, surface_.placeOf[vertex]});
	writePlace(vertex, placeNumber(place));
}

void StoredFaults::setCorners(std::uint32_t face, const IndexTriangle& corners) {
	if (faceKeyOf(corners) == faceKeyOf(surface_.corners[face])) {
		return;
	}
	findMates(face);
	std::for_each(mates_.begin(), mates_.end(), [this](std::uint32_t f) { touch(f); });
	leaveHome(face);
	cornersBefore_.emplace_back(face, surface_.corners[face]);
	write(face, corners);
}

// Whether edges of faces of one class lead from one vertex to another, all in one place: then
// cleaning unites them.
bool StoredFaults::areUnited(std::uint32_t from, std::uint32_t to, std::uint32_t inClass) const {
	std::vector<std::uint32_t> reached{from};
	for (std::size_t i = 0; i < reached.size() && reached[i] != to; ++i) {
		for (const std::uint32_t face : facesAt_[reached[i]]) {
			for (const std::uint32_t v : surface_.corners[face]) {
				if (classOf_[face] == inClass && surface_.placeOf[v] == surface_.placeOf[from] &&
				    std::find(reached.begin(), reached.end(), v) == reached.end()) {
					reached.push_back(v);
				}
			}
		}
	}
	return std::find(reached.begin(), reached.end(), to) != reached.end();
}

// Whether two mates are one sheet folded onto itself, which cleaning takes away.
bool StoredFaults::cancel(std::uint32_t a, std::uint32_t b) const {
	const MeshArrays& mesh = arrangement_.mesh;
	if (faceKeyOf(surface_.stored[a]).ascending == faceKeyOf(surface_.stored[b]).ascending ||
	    mesh.operandOf(surface_.inputFaces[a]) != mesh.operandOf(surface_.inputFaces[b]) ||
	    classOf_[a] != classOf_[b]) {
		return false;
	}
	for (const std::uint32_t v : surface_.corners[a]) {
		const IndexTriangle& other = surface_.corners[b];
		const auto w = std::find_if(other.begin(), other.end(), [&](std::uint32_t u) {
			return surface_.placeOf[u] == surface_.placeOf[v];
		});
		if (!areUnited(v, *w, classOf_[a])) {
			return false;
		}
	}
	return true;
}

// Which of a face's mates stand: those that none cancels out; of twins, one for both.
void StoredFaults::chooseAmongMates(std::uint32_t face) {
	if (isCollapsed(surface_.stored[face])) {
		stands_[face] = 0;
		return;
	}
	findMates(face);
	std::vector<std::uint8_t> isGone(mates_.size());
	for (std::size_t i = 0; i < mates_.size(); ++i) {
		for (std::size_t j = i + 1; j < mates_.size() && isGone[i] == 0; ++j) {
			if (isGone[j] == 0 && cancel(mates_[i], mates_[j])) {
				isGone[i] = isGone[j] = 1;
			}
		}
		const auto key = faceKeyOf(surface_.corners[mates_[i]]);
		for (std::size_t j = i + 1; j < mates_.size() && isGone[i] == 0; ++j) {
			if (faceKeyOf(surface_.corners[mates_[j]]) == key) {
				isGone[j] = 1;
			}
		}
	}
	for (std::size_t i = 0; i < mates_.size(); ++i) {
		touch(mates_[i]);
		stands_[mates_[i]] = isGone[i] == 0 ? 1 : 0;
	}
}

void StoredFaults::addPair(std::uint32_t a, std::uint32_t b) {
	partners_[a].insert(b);
	partners_[b].insert(a);
	++pairCount_;
}

void StoredFaults::removePair(std::uint32_t a, std::uint32_t b) {
	for (const auto& [of, other] : {std::pair{a, b}, std::pair{b, a}}) {
		const auto it = partners_.find(of);
		it->second.erase(other);
		if (it->second.empty()) {
			partners_.erase(it);
		}
	}
	--pairCount_;
}

void StoredFaults::removeFaults(std::uint32_t face) {
	if (zeroAreaFaces_.erase(face) != 0) {
		zeroAreaRemoved_.push_back(face);
	}
	const auto it = partners_.find(face);
	if (it == partners_.end()) {
		return;
	}
	const std::vector<std::uint32_t> others(it->second.begin(), it->second.end());
	for (const std::uint32_t other : others) {
		pairsRemoved_.push_back({{std::min(face, other)}, {std::max(face, other)}});
		removePair(face, other);
	}
}

bool StoredFaults::meetWrongly(const FacePair& pair) const {
	return !arePartedFaces(view_, pair) && meetingOf(view_, pair) != Meeting::Proper;
}

// How many of the pairs that have been removed will come again.
// \pre which touched faces have no area is known
std::size_t StoredFaults::countLasting() const {
	const auto hasGone = [this](FaceId face) {
		return stands_[face.value] == 0 || zeroAreaFaces_.count(face.value) != 0;
	};
	return static_cast<std::size_t>(
	    std::count_if(pairsRemoved_.begin(), pairsRemoved_.end(), [&](const FacePair& pair) {
		    return !hasGone(pair.a) && !hasGone(pair.b) && meetWrongly(pair);
	    }));
}

// The pairs of a touched face that stands; with another touched one, if it comes first.
// \pre which touched faces have no area is known
void StoredFaults::addFaults(std::uint32_t face) {
	if (stands_[face] == 0 || zeroAreaFaces_.count(face) != 0) {
		return;
	}
	findNear(face);
	for (const std::uint32_t other : near_) {
		const bool isLater = isTouched_[other] != 0 && other < face;
		if (isLater || stands_[other] == 0 || zeroAreaFaces_.count(other) != 0) {
			continue;
		}
		const FacePair pair{{std::min(face, other)}, {std::max(face, other)}};
		if (meetWrongly(pair)) {
			pairsAdded_.push_back(pair);
			addPair(pair.a.value, pair.b.value);
		}
	}
}

// Which touched faces stand now, and their mates. Those around a face that collapses may be united
// by it.
void StoredFaults::chooseAgain() {
	for (std::size_t i = 0, most = touched_.size(); i < most; ++i) {
		const IndexTriangle corners = surface_.corners[touched_[i]];
		for (std::size_t k = 0;
		     k < 3 && (stoodBefore_[i] == 0 || isCollapsed(surface_.stored[touched_[i]])); ++k) {
			const std::vector<std::uint32_t>& around = facesAt_[corners[k]];
			std::for_each(around.begin(), around.end(), [this](std::uint32_t f) { touch(f); });
		}
	}
	for (std::size_t i = 0; i < touched_.size(); ++i) {  // mates join them meanwhile
		chooseAmongMates(touched_[i]);
	}
}

bool StoredFaults::settle() {
	const std::size_t before = count();
	chooseAgain();
	work_ += touched_.size();
	for (const std::uint32_t face : touched_) {
		removeFaults(face);
	}
	for (const std::uint32_t face : touched_) {
		const IndexTriangle& t = surface_.stored[face];
		const Points& p = surface_.places;
		if (stands_[face] != 0 && hasZeroArea(p[t[0]], p[t[1]], p[t[2]])) {
			zeroAreaFaces_.insert(face);
			zeroAreaAdded_.push_back(face);
		}
	}
	// Most trials are no good, and the faults that there were tell it soonest.
	bool isBetter = count() < before && count() + countLasting() < before;
	for (std::size_t i = 0; i < touched_.size() && isBetter; ++i) {
		addFaults(touched_[i]);
		isBetter = count() < before && !pollCancelled(monitor_);
	}
	if (!isBetter) {
		undo();
	}
	forget();
	return isBetter;
}

void StoredFaults::undo() {
	for (const FacePair& pair : pairsAdded_) {
		removePair(pair.a.value, pair.b.value);
	}
	for (const FacePair& pair : pairsRemoved_) {
		addPair(pair.a.value, pair.b.value);
	}
	for (const std::uint32_t face : zeroAreaAdded_) {
		zeroAreaFaces_.erase(face);
	}
	zeroAreaFaces_.insert(zeroAreaRemoved_.begin(), zeroAreaRemoved_.end());
	for (std::size_t i = 0; i < touched_.size(); ++i) {
		stands_[touched_[i]] = stoodBefore_[i];
	}
	for (std::size_t i = cornersBefore_.size(); i-- > 0;) {
		write(cornersBefore_[i].first, cornersBefore_[i].second);
	}
	for (std::size_t i = placesBefore_.size(); i-- > 0;) {
		writePlace(placesBefore_[i][0], placesBefore_[i][1]);
	}
	while (recent_.size() > recentBefore_) {
		home_[recent_.back().first] = recent_.back().second;
		recent_.pop_back();
	}
}

// Before the next trial.
void StoredFaults::forget() {
	for (const std::uint32_t face : touched_) {
		isTouched_[face] = 0;
	}
	touched_.clear();
	stoodBefore_.clear();
	cornersBefore_.clear();
	placesBefore_.clear();
	pairsAdded_.clear();
	pairsRemoved_.clear();
	zeroAreaAdded_.clear();
	zeroAreaRemoved_.clear();
	constexpr std::size_t kMostRecent = 64;
	if (recent_.size() > kMostRecent) {
		plantChanged();
	}
	recentBefore_ = recent_.size();
}

}  // namespace index_boolean
