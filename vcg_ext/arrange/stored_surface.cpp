// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// With nothing but curve points rounded, only pieces are suspect: uncut faces are looked at once,
// by their boxes, where they are. Else, or if they are few beside the pieces, all are taken.
#include "vcg_ext/arrange/stored_surface.h"

#include "vcg_ext/arrange/near_faces.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/face_key.h"
#include "vcg_ext/mesh/vertex_table.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

class Collector {
public:
	Collector(const Arrangement& arrangement, double reach, Monitor& monitor, StoredSurface& out)
	    : arrangement_(arrangement), reach_(reach), monitor_(monitor), out_(out) {}

	Status run();

private:
	bool isExact(VertexId v) const {
		return areInputsRounded_ ? isStoredExactly(arrangement_, v) : !arrangement_.isCurvePoint(v);
	}
	bool isSuspect(const Triangle& t) const {
		return !std::all_of(t.begin(), t.end(), [this](VertexId v) { return isExact(v); });
	}
	bool isTaken(std::size_t face) const {
		const MeshArrays& mesh = arrangement_.mesh;
		const FaceId id = makeId<FaceTag>(face);
		const bool isTwin = mesh.quietTwin(id) != Twin::None && mesh.operandOf(id) != kFirst;
		return arrangement_.refinement.isCut[face] == 0 && !isTwin;
	}
	Status lookAtInputs();
	void addBox(const Triangle& t);
	void markMovable();
	void listBoxes();
	Status listUncut();
	void numberVertices();
	void add(const Triangle& corners, FaceId face);
	void addFaces();
	Status findPlaces();
	void weld();

	const Arrangement& arrangement_;
	const double reach_;
	Monitor& monitor_;
	StoredSurface& out_;
	bool areInputsRounded_ = false;
	bool areAll_ = false;                 // all uncut faces are taken, so each vertex is whole
	HugeVector<std::uint8_t> isMovable_;  // per input vertex: a piece's corner; or empty
	std::vector<BoundingBox> boxes_;      // of suspect faces; also of those at movable vertices
	std::vector<std::uint32_t> uncut_;    // faces
	HugeVector<std::uint32_t> number_;    // per vertex of the arrangement that is used
	Points places_;                       // per vertex of the surface
};

Status Collector::lookAtInputs() {
	if (arrangement_.options.outputScalar == OutputScalar::Double) {
		return {};
	}
	const Triangles& triangles = arrangement_.mesh.triangles;
	std::atomic<bool> found{false};
	const Status status = parallelFor(triangles.size(), kGrain, arrangement_.options.threads,
	                                  monitor_, [&](std::size_t begin, std::size_t end) {
		                                  for (std::size_t f = begin; f < end && !found; ++f) {
			                                  for (const VertexId v : triangles[f]) {
				                                  if (!isStoredExactly(arrangement_, v)) {
					                                  found = true;
				                                  }
			                                  }
		                                  }
	                                  });
	areInputsRounded_ = found;
	return status;
}

// With the reach. It stays finite.
void Collector::addBox(const Triangle& t) {
	constexpr double kMost = std::numeric_limits<double>::max();
	BoundingBox box = emptyBox();
	for (const VertexId v : t) {
		box.add(outputCoordinates(arrangement_, v));
	}
	for (std::size_t axis = 0; axis < 3; ++axis) {
		box.lo[axis] = std::max(box.lo[axis] - reach_, -kMost);
		box.hi[axis] = std::min(box.hi[axis] + reach_, kMost);
	}
	boxes_.push_back(box);
}

void Collector::markMovable() {
	isMovable_.assign(arrangement_.mesh.points.size(), 0);
	for (const Triangle& t : arrangement_.refinement.pieces) {
		for (const VertexId v : t) {
			if (!arrangement_.isCurvePoint(v)) {
				at(isMovable_, v) = 1;
			}
		}
	}
}

void Collector::listBoxes() {
	for (const Triangle& t : arrangement_.refinement.pieces) {
		if (isSuspect(t) || !isMovable_.empty()) {
			addBox(t);
		}
	}
	const Triangles& triangles = arrangement_.mesh.triangles;
	for (std::size_t f = 0; f < triangles.size() && !isMovable_.empty(); ++f) {
		const Triangle& t = triangles[f];
		if (isTaken(f) && std::any_of(t.begin(), t.end(),
		                              [this](VertexId v) { return at(isMovable_, v) != 0; })) {
			addBox(t);
		}
	}
}

Status Collector::listUncut() {
	const MeshArrays& mesh = arrangement_.mesh;
	areAll_ = areInputsRounded_ || mesh.triangles.size() <= arrangement_.refinement.pieces.size();
	if (areAll_) {
		uncut_.resize(mesh.triangles.size());
		for (std::size_t f = 0; f < uncut_.size(); ++f) {
			uncut_[f] = static_cast<std::uint32_t>(f);
		}
	} else {
		if (reach_ > 0) {
			markMovable();
		}
		listBoxes();
		const FacesView faces(mesh.points, mesh.triangles.data(), mesh.triangles.size());
		const Status status =
		    findFacesNear(faces, boxes_, arrangement_.options.threads, monitor_, uncut_);
		if (!status.ok()) {
			return status;
		}
	}
	uncut_.erase(std::remove_if(uncut_.begin(), uncut_.end(),
	                            [this](std::uint32_t f) { return !isTaken(f); }),
	             uncut_.end());
	return {};
}

void Collector::numberVertices() {
	const MeshArrays& mesh = arrangement_.mesh;
	number_.resizeForOverwrite(mesh.points.size() + arrangement_.curve.pointCount());
	std::vector<std::uint64_t> used(number_.size() / 64 + 1);
	const auto use = [&used](const Triangle& t) {
		for (const VertexId v : t) {
			used[v.value / 64] |= std::uint64_t{1} << v.value % 64;
		}
	};
	for (const std::uint32_t f : uncut_) {
		use(mesh.triangles[f]);
	}
	for (const Triangle& t : arrangement_.refinement.pieces) {
		use(t);
	}
	for (std::size_t word = 0; word < used.size(); ++word) {
		for (std::size_t v = 64 * word; used[word] != 0; used[word] >>= 1U, ++v) {
			if ((used[word] & 1U) != 0) {
				number_[v] = static_cast<std::uint32_t>(out_.vertices.size());
				out_.vertices.push_back(makeId<VertexTag>(v));
				const bool isInput = v < mesh.points.size();
				const bool isMovable = isInput && !isMovable_.empty() && isMovable_[v] != 0;
				out_.isWhole.push_back(!isInput || areAll_ || isMovable ? 1 : 0);
			}
		}
	}
}

void Collector::add(const Triangle& corners, FaceId face) {
	out_.corners.push_back(
	    {at(number_, corners[0]), at(number_, corners[1]), at(number_, corners[2])});
	out_.inputFaces.push_back(face);
	out_.isSuspect.push_back(isSuspect(corners) ? 1 : 0);
	out_.anySuspect |= out_.isSuspect.back() != 0;
}

void Collector::addFaces() {
	const Refinement& refinement = arrangement_.refinement;
	for (const std::uint32_t f : uncut_) {
		add(arrangement_.mesh.triangles[f], makeId<FaceTag>(f));
	}
	out_.firstPiece = uncut_.size();
	for (std::size_t i = 0; i < refinement.cutFaces.size(); ++i) {
		const Refinement::PieceRange pieces = refinement.piecesOf(i);
		for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) {
			add(refinement.pieces[piece], refinement.cutFaces[i].face);
		}
	}
}

Status Collector::findPlaces() {
	places_.resizeForOverwrite(out_.vertices.size());
	return parallelFor(places_.size(), kGrain, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t v = begin; v < end; ++v) {
			                   places_[v] = outputCoordinates(arrangement_, out_.vertices[v]);
			                   for (double& x : places_[v]) {
				                   x += 0.0;  // of both zeros the positive one
			                   }
		                   }
	                   });
}

void Collector::weld() {
	VertexTable table(places_, places_.size());
	out_.placeOf.resize(places_.size());
	out_.places.reserve(places_.size());
	for (std::uint32_t v = 0; v < places_.size(); ++v) {
		const std::uint32_t first = table.findOrAdd(v);
		const auto next = static_cast<std::uint32_t>(out_.places.size());
		out_.placeOf[v] = first == v ? next : out_.placeOf[first];
		if (first == v) {
			out_.places.push_back(places_[v]);
		}
	}
	out_.stored.reserve(out_.corners.size());
	for (const IndexTriangle& t : out_.corners) {
		out_.stored.push_back({out_.placeOf[t[0]], out_.placeOf[t[1]], out_.placeOf[t[2]]});
	}
}

Status Collector::run() {
	const Status status = lookAtInputs();
	if (!status.ok() || (!areInputsRounded_ && arrangement_.curve.pointCount() == 0)) {
		return status;
	}
	return inOrder([this] { return listUncut(); },
	               [this] {
		               numberVertices();
		               addFaces();
		               return findPlaces();
	               },
	               [this] {
		               weld();
		               return Status{};
	               });
}

}  // namespace

Status collectStoredSurface(const Arrangement& arrangement, double reach, Monitor& monitor,
                            StoredSurface& out) {
	out = {};
	return Collector(arrangement, reach, monitor, out).run();
}

Status findFaults(const StoredSurface& surface, const std::vector<std::uint32_t>& which,
                  int threads, Monitor& monitor, WrongPairs& out) {
	IndexTriangles triangles;
	std::vector<std::uint8_t> isSuspect;
	triangles.reserve(which.size());
	isSuspect.reserve(which.size());
	for (const std::uint32_t face : which) {
		triangles.push_back(surface.stored[face]);
		isSuspect.push_back(surface.isSuspect[face]);
	}
	const FacesView view(surface.places, triangles.data(), triangles.size());
	const Status status = findWrongPairs(view, {threads, false, &isSuspect}, monitor, out);
	for (FacePair& pair : out.pairs) {
		pair = {{which[pair.a.value]}, {which[pair.b.value]}};
	}
	for (std::uint32_t& face : out.zeroAreaFaces) {
		face = which[face];
	}
	return status;
}

// Twins are pieces of both operands.
Status findDistinctFaces(const Arrangement& arrangement, const StoredSurface& surface,
                         Monitor& monitor, std::vector<std::uint32_t>& out) {
	std::vector<KeyedFace<std::uint32_t>> keyed;
	std::vector<std::uint8_t> isLeftOut(surface.corners.size());
	for (std::uint32_t f = 0; f < surface.corners.size(); ++f) {
		const IndexTriangle& corners = surface.corners[f];
		const auto isOnOther = [&](std::uint32_t v) {
			return arrangement.isOnOther(surface.vertices[v]);
		};
		isLeftOut[f] = isCollapsed(surface.stored[f]) ? 1 : 0;
		if (isLeftOut[f] == 0 && f >= surface.firstPiece &&
		    std::all_of(corners.begin(), corners.end(), isOnOther)) {
			keyed.push_back({faceKeyOf(corners), f});
		}
	}
	const auto firstCorner = [](const auto& item) { return item.key.corners[0]; };
	const auto isBefore = [](const auto& a, const auto& b) {
		return a.key != b.key ? a.key < b.key : a.face < b.face;
	};
	const Status status = bucketSort(keyed, surface.vertices.size(), firstCorner, isBefore,
	                                 arrangement.options.threads, monitor);
	for (std::size_t i = 1; i < keyed.size(); ++i) {
		isLeftOut[keyed[i].face] = keyed[i].key == keyed[i - 1].key ? 1 : 0;
	}
	out.clear();
	for (std::uint32_t f = 0; f < isLeftOut.size(); ++f) {
		if (isLeftOut[f] == 0) {
			out.push_back(f);
		}
	}
	return status;
}

}  // namespace index_boolean
