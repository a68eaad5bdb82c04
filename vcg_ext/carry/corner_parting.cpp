// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a corner stands for is its identity. The first corner at a vertex keeps it; corners of other
// identities are strangers there, and are given copies, one for each identity.
#include "vcg_ext/carry/corner_parting.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

// The operand of a corner, and the sides of seams that its vertices as given are on, whatever their
// weights; kNone where there are fewer, and no seam.
using Identity = std::array<std::uint32_t, 4>;

// Gives corners at one vertex that stand for different ones a vertex each.
class CornerParting {
public:
	CornerParting(const Arrangement& arrangement, const FaceLocator& locator, const Seams& seams,
	              bool partCurve, SourcedMesh& mesh)
	    : arrangement_(arrangement), locator_(locator), seams_(seams), partCurve_(partCurve),
	      mesh_(mesh) {}

	Status run(Monitor& monitor);

private:
	struct Stranger {  // a corner that stands for something else than the first at its vertex
		std::uint32_t vertex;
		Identity identity;
		std::uint32_t face, corner;
	};

	OperandId operandOf(std::size_t face) const {
		return arrangement_.mesh.operandOf(mesh_.faceSource[face].face);
	}
	bool isWithSeams(std::size_t face) const {
		return seams_.any() && arrangement_.seams[operandOf(face)];
	}
	Status locateCorners(Monitor& monitor);
	const PlaceInFace& placeOf(const WantedPlace& wanted) const;
	bool findIdentity(std::size_t face, std::uint32_t vertex, Identity& identity) const;
	void listStrangers(std::uint32_t face);
	void addVertices();

	const Arrangement& arrangement_;
	const FaceLocator& locator_;
	const Seams& seams_;
	bool partCurve_;
	SourcedMesh& mesh_;
	std::vector<WantedPlace> cut_;     // corners on seams that are none of their given face, sorted
	std::vector<PlaceInFace> places_;  // of each
	std::vector<Identity> first_;      // per vertex
	std::vector<Stranger> strangers_;
};

// Finds the places of all corners of which findIdentity asks them.
Status CornerParting::locateCorners(Monitor& monitor) {
	const std::size_t n = seams_.any() ? mesh_.triangles.size() : 0;
	std::vector<std::vector<WantedPlace>> found(chunkCount(n, kGrain));
	const Status status =
	    parallelForChunks(n, kGrain, arrangement_.options.threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t f = begin; f < end; ++f) {
			                      const FaceId source = mesh_.faceSource[f].face;
			                      if (!isWithSeams(f)) {
				                      continue;
			                      }
			                      const Triangle given = locator_.givenTriangle(source);
			                      for (const std::uint32_t v : mesh_.triangles[f]) {
				                      if (locator_.cornerOf(given, v) < 0) {
					                      found[chunk].push_back({source, v});
				                      }
			                      }
		                      }
	                      });
	for (const std::vector<WantedPlace>& part : found) {
		cut_.insert(cut_.end(), part.begin(), part.end());
	}
	std::sort(cut_.begin(), cut_.end());
	cut_.erase(std::unique(cut_.begin(), cut_.end()), cut_.end());
	return status.ok() ? locator_.locate(cut_, monitor, places_) : status;
}

const PlaceInFace& CornerParting::placeOf(const WantedPlace& wanted) const {
	const auto found = std::lower_bound(cut_.begin(), cut_.end(), wanted);
	return places_[static_cast<std::size_t>(found - cut_.begin())];
}

// False for a corner of a merged face that lies outside of what the face came from: it may stand
// for any.
bool CornerParting::findIdentity(std::size_t face, std::uint32_t vertex, Identity& identity) const {
	const OperandId operand = operandOf(face);
	identity = {operand.value, kNone, kNone, kNone};
	if (!isWithSeams(face)) {
		return true;
	}
	const FaceId source = mesh_.faceSource[face].face;
	const Triangle given = locator_.givenTriangle(source);
	if (const int corner = locator_.cornerOf(given, vertex); corner >= 0) {
		identity[1] = seams_.sideOf(given[static_cast<std::size_t>(corner)]).value;
		return true;
	}
	const PlaceInFace& place = placeOf({source, vertex});
	const Triangle corners = locator_.givenTriangle(place.face);
	for (std::size_t j = 0; j < 3; ++j) {
		identity[j + 1] = place.weights[j] > 0 ? seams_.sideOf(corners[j]).value : kNone;
	}
	std::sort(identity.begin() + 1, identity.end());
	return place.isThere;
}

void CornerParting::listStrangers(std::uint32_t face) {
	for (std::uint32_t i = 0; i < 3; ++i) {
		const std::uint32_t v = mesh_.triangles[face][i];
		Identity& first = first_[v];
		const bool isOthers = first[0] != kNone && first[0] != operandOf(face).value;
		Identity identity;
		if ((isOthers && !partCurve_) || !findIdentity(face, v, identity)) {
			continue;
		}
		if (first[0] == kNone) {
			first = identity;
		} else if (identity != first) {
			strangers_.push_back({v, identity, face, i});
		}
	}
}

void CornerParting::addVertices() {
	std::sort(strangers_.begin(), strangers_.end(), [](const Stranger& a, const Stranger& b) {
		return a.vertex != b.vertex       ? a.vertex < b.vertex
		       : a.identity != b.identity ? a.identity < b.identity
		       : a.face != b.face         ? a.face < b.face
		                                  : a.corner < b.corner;
	});
	for (std::size_t i = 0; i < strangers_.size(); ++i) {
		const Stranger& s = strangers_[i];
		if (i == 0 || strangers_[i - 1].vertex != s.vertex ||
		    strangers_[i - 1].identity != s.identity) {
			mesh_.points.push_back(Point(mesh_.points[s.vertex]));
			mesh_.vertexSource.push_back(VertexId(mesh_.vertexSource[s.vertex]));
		}
		mesh_.triangles[s.face][s.corner] = static_cast<std::uint32_t>(mesh_.points.size() - 1);
	}
}

// The first operand's faces come first: a vertex of both is theirs.
Status CornerParting::run(Monitor& monitor) {
	Status status;
	if (!partCurve_ && !seams_.any()) {
		return status;
	}
	first_.assign(mesh_.points.size(), Identity{kNone, kNone, kNone, kNone});
	const auto listAll = [&](OperandId operand) {
		return inOrderFor(mesh_.triangles.size(), kGrain, monitor,
		                  [&](std::size_t begin, std::size_t end) {
			                  for (std::size_t f = begin; f < end; ++f) {
				                  if (operandOf(f) == operand) {
					                  listStrangers(static_cast<std::uint32_t>(f));
				                  }
			                  }
		                  });
	};
	status = inOrder([&] { return locateCorners(monitor); },
	                 [&] { return forEachOperand(arrangement_.mesh.operands(), listAll); });
	if (status.ok()) {
		addVertices();
	}
	return status;
}

}  // namespace

Status partCorners(const Arrangement& arrangement, const FaceLocator& locator, const Seams& seams,
                   bool partCurve, Monitor& monitor, SourcedMesh& mesh) {
	return CornerParting(arrangement, locator, seams, partCurve, mesh).run(monitor);
}

}  // namespace index_boolean
