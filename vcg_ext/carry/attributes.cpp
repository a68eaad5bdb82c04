// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Most elements have one source, found by comparing indices or coordinates. The others are listed,
// so that each point is looked at once for each face that it lies in.
#include "vcg_ext/carry/attributes.h"

#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/carry/corner_parting.h"
#include "vcg_ext/carry/face_locator.h"

#include <algorithm>
#include <atomic>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

// A face of the mesh at a vertex, first by operand.
using FaceRank = std::uint64_t;
constexpr FaceRank kNoFace = ~FaceRank{0};

constexpr FaceRank makeRank(OperandId operand, std::size_t face) {
	return FaceRank{operand.value} << 32U | static_cast<std::uint32_t>(face);
}
constexpr OperandId operandOf(FaceRank rank) { return {static_cast<std::uint32_t>(rank >> 32U)}; }
constexpr std::uint32_t faceOf(FaceRank rank) { return static_cast<std::uint32_t>(rank); }

class SourceFinder {
public:
	SourceFinder(const Arrangement& arrangement, const FaceLocator& locator, Monitor& monitor,
	             const SourcedMesh& mesh, AttributeSources& out)
	    : arrangement_(arrangement), locator_(locator), monitor_(monitor), mesh_(mesh), out_(out) {}

	Status run(bool corners);

private:
	// A vertex whose place in a face is wanted, and where its mix is to be written down.
	struct Wanted {
		WantedPlace place;
		std::uint32_t* slot;
		std::uint32_t firstMix;  // the number that stands for mix 0 there
	};

	bool isOfSeveralSheets(std::uint32_t v) const;
	bool isBefore(FaceRank a, FaceRank b, std::uint32_t v) const;
	Status findFaces();
	Status findVertices();
	Status findCorners();
	Status mixWanted();
	template <class List>
	Status listWanted(std::size_t n, List&& list);

	const Arrangement& arrangement_;
	const FaceLocator& locator_;
	Monitor& monitor_;
	const SourcedMesh& mesh_;
	AttributeSources& out_;
	HugeVector<std::atomic<FaceRank>> chosen_;  // per vertex: a face at it
	std::vector<Wanted> wanted_;
};

// Lowers a rank that other threads lower too.
template <class Before>
void lowerTo(FaceRank value, std::atomic<FaceRank>& rank, Before&& isBefore) {
	FaceRank known = rank.load(std::memory_order_relaxed);
	while (isBefore(value, known) &&
	       !rank.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
	}
}

// Whether sheets of one operand may meet at a vertex, which differ in their values there.
bool SourceFinder::isOfSeveralSheets(std::uint32_t v) const {
	const VertexId source = mesh_.vertexSource[v];
	return arrangement_.isSoup && (source == VertexId::none() || arrangement_.isOnOther(source));
}

// Whether a vertex takes its attributes rather through one face of the mesh at it than through
// another: by operand, and then by number, or, where sheets of one operand meet, by the places of
// the faces' corners and those of their sources, so that all is the same in any numbering.
bool SourceFinder::isBefore(FaceRank a, FaceRank b, std::uint32_t v) const {
	if (b == kNoFace || operandOf(a) != operandOf(b) || !isOfSeveralSheets(v)) {
		return a < b;
	}
	const auto placesOf = [](const auto& points, const auto& t) {
		std::array<Point, 3> places{points[t[0]], points[t[1]], points[t[2]]};
		std::sort(places.begin(), places.end());
		return places;
	};
	const auto ofMesh = [&](FaceRank rank) {
		return placesOf(mesh_.points, mesh_.triangles[faceOf(rank)]);
	};
	const auto ofSource = [&](FaceRank rank) {
		const Triangle& t = at(arrangement_.mesh.triangles, mesh_.faceSource[faceOf(rank)].face);
		return placesOf(arrangement_.mesh.points,
		                IndexTriangle{t[0].value, t[1].value, t[2].value});
	};
	const std::array<Point, 3> placesOfA = ofMesh(a), placesOfB = ofMesh(b);
	if (placesOfA != placesOfB) {
		return placesOfA < placesOfB;
	}
	const std::array<Point, 3> sourceOfA = ofSource(a), sourceOfB = ofSource(b);
	return sourceOfA != sourceOfB ? sourceOfA < sourceOfB : a < b;
}

// Each vertex takes its attributes through its first face of the first operand that it is on.
Status SourceFinder::findFaces() {
	const std::size_t n = mesh_.points.size();
	const int threads = arrangement_.options.threads;
	chosen_ = HugeVector<std::atomic<FaceRank>>::forOverwrite(n);
	out_.face.resizeForOverwrite(mesh_.triangles.size());
	const Status status =
	    parallelFor(n, kGrain, threads, monitor_, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t v = begin; v < end; ++v) {
			    chosen_[v].store(kNoFace, std::memory_order_relaxed);
		    }
	    });
	if (!status.ok()) {
		return status;
	}
	return parallelFor(
	    out_.face.size(), kGrain, threads, monitor_, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t f = begin; f < end; ++f) {
			    const GivenFace face = locator_.givenFace(mesh_.faceSource[f].face);
			    const FaceRank rank = makeRank(face.operand, f);
			    out_.face[f] = face;
			    for (const std::uint32_t v : mesh_.triangles[f]) {
				    lowerTo(rank, chosen_[v],
				            [&](FaceRank a, FaceRank b) { return isBefore(a, b, v); });
			    }
		    }
	    });
}

// Calls list(begin, end, wanted) for chunks of n items; joins what they want, in order.
template <class List>
Status SourceFinder::listWanted(std::size_t n, List&& list) {
	std::vector<std::vector<Wanted>> found(chunkCount(n, kGrain));
	const Status status =
	    parallelForChunks(n, kGrain, arrangement_.options.threads, monitor_,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      list(begin, end, found[chunk]);
	                      });
	for (const std::vector<Wanted>& part : found) {
		wanted_.insert(wanted_.end(), part.begin(), part.end());
	}
	return status;
}

Status SourceFinder::findVertices() {
	const std::size_t n = mesh_.points.size();
	out_.vertex.resizeForOverwrite(n);
	out_.turned.resizeForOverwrite(n);
	std::atomic<bool> isAlone{false};
	const auto find = [&](std::uint32_t v, std::vector<Wanted>& wanted) {
		const FaceRank chosen = chosen_[v].load(std::memory_order_relaxed);
		if (chosen == kNoFace) {
			isAlone = true;
			return;
		}
		const FaceSource& source = mesh_.faceSource[faceOf(chosen)];
		const VertexId vertex = mesh_.vertexSource[v];
		out_.turned[v] = source.turned ? 1 : 0;
		if (vertex != VertexId::none() && !arrangement_.isOnOther(vertex) &&
		    !arrangement_.seams[operandOf(chosen)]) {
			out_.vertex[v] = vertex.value;
			return;
		}
		const Triangle given = locator_.givenTriangle(source.face);
		if (const int corner = locator_.cornerOf(given, v); corner >= 0) {
			out_.vertex[v] = given[static_cast<std::size_t>(corner)].value;
		} else {
			wanted.push_back({{source.face, v}, &out_.vertex[v], out_.vertexCount});
		}
	};
	Status status =
	    listWanted(n, [&](std::size_t begin, std::size_t end, std::vector<Wanted>& wanted) {
		    for (std::size_t v = begin; v < end; ++v) {
			    find(static_cast<std::uint32_t>(v), wanted);
		    }
	    });
	if (status.ok() && isAlone) {  // a vertex without a face: no mesh of this core's
		status.code = StatusCode::InternalError;
	}
	return status;
}

Status SourceFinder::findCorners() {
	constexpr std::uint32_t kFirstMix = 3;
	const std::size_t n = mesh_.triangles.size();
	out_.corner.resizeForOverwrite(n);
	return listWanted(n, [&](std::size_t begin, std::size_t end, std::vector<Wanted>& wanted) {
		for (std::size_t f = begin; f < end; ++f) {
			const FaceId source = mesh_.faceSource[f].face;
			const Triangle given = locator_.givenTriangle(source);
			for (std::size_t i = 0; i < 3; ++i) {
				const std::uint32_t v = mesh_.triangles[f][i];
				const int corner = locator_.cornerOf(given, v);
				out_.corner[f][i] = static_cast<std::uint32_t>(corner);
				if (corner < 0) {
					wanted.push_back({{source, v}, &out_.corner[f][i], kFirstMix});
				}
			}
		}
	});
}

// Finds each place that is wanted once.
Status SourceFinder::mixWanted() {
	Status status = bucketSort(
	    wanted_, arrangement_.mesh.triangles.size(),
	    [](const Wanted& w) { return w.place.face.value; },
	    [](const Wanted& a, const Wanted& b) { return a.place < b.place; },
	    arrangement_.options.threads, monitor_);
	if (!status.ok()) {
		return status;
	}
	std::vector<WantedPlace> wanted;  // per mix
	for (const Wanted& w : wanted_) {
		if (wanted.empty() || !(wanted.back() == w.place)) {
			wanted.push_back(w.place);
		}
		*w.slot = w.firstMix + static_cast<std::uint32_t>(wanted.size() - 1);
	}
	std::vector<PlaceInFace> places;
	status = locator_.locate(wanted, monitor_, places);
	out_.mixes.reserve(places.size());
	for (const PlaceInFace& place : places) {
		out_.mixes.push_back({locator_.givenFace(place.face), place.weights});
	}
	return status;
}

Status SourceFinder::run(bool corners) {
	out_.vertexCount = static_cast<std::uint32_t>(arrangement_.mesh.points.size());
	return inOrder([this] { return findFaces(); }, [this] { return findVertices(); },
	               [&] { return corners ? findCorners() : Status{}; },
	               [this] { return mixWanted(); });
}

}  // namespace

Status findAttributeSources(const Arrangement& arrangement, const AttributeInput& input,
                            Monitor& monitor, SourcedMesh& mesh, AttributeSources& out) {
	out = AttributeSources{};
	const FaceLocator locator(arrangement, input.triangles, mesh);
	const AttributeNeeds needs = input.needs;
	return inOrder(
	    [&] {
		    return partCorners(arrangement, locator, input.seams, needs.partCurve, monitor, mesh);
	    },
	    [&] { return SourceFinder(arrangement, locator, monitor, mesh, out).run(needs.corners); });
}

}  // namespace index_boolean
