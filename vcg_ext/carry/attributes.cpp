// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Most elements have one source, found by comparing indices or coordinates. The others are listed,
// so that each point is looked at once for each face that it lies in.
#include "vcg_ext/carry/attributes.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;
constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::uint32_t kSecondOperand = 0x80000000u;

// Where a point lies: in an input face, as the mean of the corners that it was given with.
struct Place {
	FaceId face;
	std::array<double, 3> weights;
	bool isThere = true;  // else the weights are those of a point nearby
};

// Places of a mesh's vertices in input faces.
class Locator {
public:
	Locator(const Arrangement& arrangement, const GivenTriangles& given, const SourcedMesh& mesh);

	GivenFace givenFace(FaceId face) const { return givenFaceOf(arrangement_, face); }
	Triangle givenTriangle(FaceId face) const { return given_(givenFace(face)); }
	// The corner of a given triangle that a vertex of the mesh is, or -1.
	int cornerOf(const Triangle& given, std::uint32_t vertex) const;
	Place locate(FaceId face, std::uint32_t vertex) const;

private:
	bool isAt(VertexId input, std::uint32_t vertex) const;
	int cornerOfName(const Triangle& given, std::uint32_t id) const;
	int zeroCorner(const Triangle& given, VertexId v) const;
	std::array<double, 3> weightsIn(const Triangle& given, std::uint32_t vertex) const;
	bool placeIn(FaceId face, std::uint32_t vertex, Place& place) const;

	const Arrangement& arrangement_;
	const GivenTriangles& given_;
	const SourcedMesh& mesh_;
	// Faces by the flat part of their polygon: those of part r are members_[begin_[r] ...).
	std::vector<std::uint32_t> begin_;
	std::vector<FaceId> members_;
};

Locator::Locator(const Arrangement& arrangement, const GivenTriangles& given,
                 const SourcedMesh& mesh)
    : arrangement_(arrangement), given_(given), mesh_(mesh) {
	const std::vector<FaceId>& flat = arrangement.polygons.flat;
	if (flat.empty()) {
		return;
	}
	begin_.assign(flat.size() + 1, 0);
	for (const FaceId root : flat) {
		++begin_[root.value + 1];
	}
	std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
	members_.resize(flat.size());
	std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
	for (std::uint32_t f = 0; f < flat.size(); ++f) {
		members_[next[flat[f].value]++] = {f};
	}
}

bool Locator::isAt(VertexId input, std::uint32_t vertex) const {
	const VertexId source = mesh_.vertexSource[vertex];
	if (source == input) {
		return true;
	}
	const Points& points = arrangement_.mesh.points;
	return source.value < points.size() && at(points, source) == at(points, input);
}

int Locator::cornerOf(const Triangle& given, std::uint32_t vertex) const {
	for (int j = 0; j < 3; ++j) {
		if (isAt(given[static_cast<std::size_t>(j)], vertex)) {
			return j;
		}
	}
	return -1;
}

// The corner of a given triangle at the place of an input vertex, or -1.
int Locator::cornerOfName(const Triangle& given, std::uint32_t id) const {
	const Points& points = arrangement_.mesh.points;
	for (int j = 0; j < 3; ++j) {
		if (at(points, given[static_cast<std::size_t>(j)]) == points[id]) {
			return j;
		}
	}
	return -1;
}

// The corner opposite the triangle's edge that a point of the curve is named by, or -1.
int Locator::zeroCorner(const Triangle& given, VertexId v) const {
	if (v == VertexId::none() || !arrangement_.isCurvePoint(v)) {
		return -1;
	}
	const PointName& name = at(arrangement_.curve.names, arrangement_.pointOf(v));
	const std::size_t edges = name.kind == PointKind::EdgeEdge ? 2 : 1;
	for (std::size_t edge = 0; edge < edges; ++edge) {
		const int low = cornerOfName(given, name.ids[2 * edge]);
		const int high = cornerOfName(given, name.ids[2 * edge + 1]);
		if (low >= 0 && high >= 0) {
			return 3 - low - high;
		}
	}
	return -1;
}

std::array<double, 3> Locator::weightsIn(const Triangle& given, std::uint32_t vertex) const {
	const Points& points = arrangement_.mesh.points;
	const VertexId v = mesh_.vertexSource[vertex];
	const ExactPoint point = v == VertexId::none() ? ExactPoint::explicitPoint(mesh_.points[vertex])
	                                               : exactPoint(arrangement_, v);
	int sign = 0;
	const int axis = projectionAxis(given, points, sign);
	return barycentricWeights({&at(points, given[0]), &at(points, given[1]), &at(points, given[2])},
	                          point, zeroCorner(given, v), axis);
}

bool isInside(const std::array<double, 3>& weights) {
	return std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0; });
}

// The nearest of the means that no weight is negative in: for a vertex that is no exact point of
// the face, or of a face whose corners all have the same attributes.
std::array<double, 3> clamped(std::array<double, 3> weights) {
	double sum = 0;
	for (double& w : weights) {
		w = w > 0 ? w : 0;
		sum += w;
	}
	for (double& w : weights) {
		w /= sum;
	}
	return weights;
}

// Fills the vertex's place in one face. \return whether it lies in that face
bool Locator::placeIn(FaceId face, std::uint32_t vertex, Place& place) const {
	const Triangle given = givenTriangle(face);
	place = {face, {}, true};
	if (const int corner = cornerOf(given, vertex); corner >= 0) {
		place.weights[static_cast<std::size_t>(corner)] = 1;
	} else {
		place.weights = weightsIn(given, vertex);
		place.isThere = isInside(place.weights);
	}
	return place.isThere;
}

// A face that was merged with others of its polygon may have corners outside of its own source:
// they lie in another triangle of the polygon.
Place Locator::locate(FaceId face, std::uint32_t vertex) const {
	Place own, other;
	if (placeIn(face, vertex, own)) {
		return own;
	}
	if (!members_.empty()) {
		const std::uint32_t part = at(arrangement_.polygons.flat, face).value;
		for (std::uint32_t i = begin_[part]; i < begin_[part + 1]; ++i) {
			if (placeIn(members_[i], vertex, other)) {
				return other;
			}
		}
	}
	own.weights = clamped(own.weights);
	return own;
}

// The operand of a corner, and the sides of seams that its vertices as given are on, whatever their
// weights; kNone where there are fewer.
using Identity = std::array<std::uint32_t, 4>;

// Gives corners at one vertex that stand for different ones a vertex each.
class Parting {
public:
	Parting(const Arrangement& arrangement, const Locator& locator, const Seams& seams,
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
	bool findIdentity(std::size_t face, std::uint32_t vertex, Identity& identity) const;
	void listStrangers(std::uint32_t face);
	void addVertices();

	const Arrangement& arrangement_;
	const Locator& locator_;
	const Seams& seams_;
	bool partCurve_;
	SourcedMesh& mesh_;
	std::vector<Identity> first_;  // per vertex
	std::vector<Stranger> strangers_;
};

// False for a corner of a merged face that lies outside of what the face came from: it may stand
// for any.
bool Parting::findIdentity(std::size_t face, std::uint32_t vertex, Identity& identity) const {
	const OperandId operand = operandOf(face);
	identity = {operand.value, kNone, kNone, kNone};
	if (!seams_.any() || !arrangement_.seams[operand]) {
		return true;
	}
	const FaceId source = mesh_.faceSource[face].face;
	const Triangle given = locator_.givenTriangle(source);
	if (const int corner = locator_.cornerOf(given, vertex); corner >= 0) {
		identity[1] = seams_.sideOf(given[static_cast<std::size_t>(corner)]).value;
		return true;
	}
	const Place place = locator_.locate(source, vertex);
	const Triangle corners = locator_.givenTriangle(place.face);
	for (std::size_t j = 0; j < 3; ++j) {
		identity[j + 1] = place.weights[j] > 0 ? seams_.sideOf(corners[j]).value : kNone;
	}
	std::sort(identity.begin() + 1, identity.end());
	return place.isThere;
}

void Parting::listStrangers(std::uint32_t face) {
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

void Parting::addVertices() {
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
Status Parting::run(Monitor& monitor) {
	Status status;
	if (!partCurve_ && !seams_.any()) {
		return status;
	}
	first_.assign(mesh_.points.size(), Identity{kNone, kNone, kNone, kNone});
	status = forEachOperand(arrangement_.mesh.operands(), [&](OperandId operand) {
		return inOrderFor(mesh_.triangles.size(), kGrain, monitor,
		                  [&](std::size_t begin, std::size_t end) {
			                  for (std::size_t f = begin; f < end; ++f) {
				                  if (operandOf(f) == operand) {
					                  listStrangers(static_cast<std::uint32_t>(f));
				                  }
			                  }
		                  });
	});
	if (status.ok()) {
		addVertices();
	}
	return status;
}

class SourceFinder {
public:
	SourceFinder(const Arrangement& arrangement, const Locator& locator, Monitor& monitor,
	             const SourcedMesh& mesh, AttributeSources& out)
	    : arrangement_(arrangement), locator_(locator), monitor_(monitor), mesh_(mesh), out_(out) {}

	Status run(bool corners);

private:
	// A vertex whose place in a face is wanted, and where its mix is to be written down.
	struct Wanted {
		FaceId face;
		std::uint32_t vertex;
		std::uint32_t* slot;
		std::uint32_t firstMix;  // the number that stands for mix 0 there
	};

	Status findFaces();
	Status findVertices();
	Status findCorners();
	Status mixWanted();
	template <class List>
	Status listWanted(std::size_t n, List&& list);

	const Arrangement& arrangement_;
	const Locator& locator_;
	Monitor& monitor_;
	const SourcedMesh& mesh_;
	AttributeSources& out_;
	// Per vertex: a face at it, the second operand's marked.
	HugeVector<std::atomic<std::uint32_t>> chosen_;
	std::vector<Wanted> wanted_;
};

// Lowers a number that other threads lower too.
void lowerTo(std::uint32_t value, std::atomic<std::uint32_t>& number) {
	std::uint32_t known = number.load(std::memory_order_relaxed);
	while (value < known &&
	       !number.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
	}
}

// Each vertex takes its attributes through its first face of the first operand, else of the second.
Status SourceFinder::findFaces() {
	const std::size_t n = mesh_.points.size();
	const int threads = arrangement_.options.threads;
	chosen_ = HugeVector<std::atomic<std::uint32_t>>(n);
	out_.face.resize(mesh_.triangles.size());
	const Status status =
	    parallelFor(n, kGrain, threads, monitor_, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t v = begin; v < end; ++v) {
			    chosen_[v].store(kNone, std::memory_order_relaxed);
		    }
	    });
	if (!status.ok()) {
		return status;
	}
	return parallelFor(
	    out_.face.size(), kGrain, threads, monitor_, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t f = begin; f < end; ++f) {
			    const GivenFace face = locator_.givenFace(mesh_.faceSource[f].face);
			    const auto key = static_cast<std::uint32_t>(f) |
			                     (face.operand == kFirst ? std::uint32_t{0} : kSecondOperand);
			    out_.face[f] = face;
			    for (const std::uint32_t v : mesh_.triangles[f]) {
				    lowerTo(key, chosen_[v]);
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
	out_.vertex.resize(n);
	out_.turned.resize(n);
	std::atomic<bool> isAlone{false};
	const auto find = [&](std::uint32_t v, std::vector<Wanted>& wanted) {
		const std::uint32_t chosen = chosen_[v].load(std::memory_order_relaxed);
		if (chosen == kNone) {
			isAlone = true;
			return;
		}
		const FaceSource& source = mesh_.faceSource[chosen & ~kSecondOperand];
		const VertexId vertex = mesh_.vertexSource[v];
		const OperandId operand = chosen >= kSecondOperand ? kSecond : kFirst;
		out_.turned[v] = source.turned ? 1 : 0;
		if (vertex != VertexId::none() && !arrangement_.isOnOther(vertex) &&
		    !arrangement_.seams[operand]) {
			out_.vertex[v] = vertex.value;
			return;
		}
		const Triangle given = locator_.givenTriangle(source.face);
		if (const int corner = locator_.cornerOf(given, v); corner >= 0) {
			out_.vertex[v] = given[static_cast<std::size_t>(corner)].value;
		} else {
			wanted.push_back({source.face, v, &out_.vertex[v], out_.vertexCount});
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
	out_.corner.resize(n);
	return listWanted(n, [&](std::size_t begin, std::size_t end, std::vector<Wanted>& wanted) {
		for (std::size_t f = begin; f < end; ++f) {
			const FaceId source = mesh_.faceSource[f].face;
			const Triangle given = locator_.givenTriangle(source);
			for (std::size_t i = 0; i < 3; ++i) {
				const std::uint32_t v = mesh_.triangles[f][i];
				const int corner = locator_.cornerOf(given, v);
				out_.corner[f][i] = static_cast<std::uint32_t>(corner);
				if (corner < 0) {
					wanted.push_back({source, v, &out_.corner[f][i], kFirstMix});
				}
			}
		}
	});
}

// Finds each place that is wanted once.
Status SourceFinder::mixWanted() {
	std::sort(wanted_.begin(), wanted_.end(), [](const Wanted& a, const Wanted& b) {
		return a.face != b.face ? a.face < b.face : a.vertex < b.vertex;
	});
	std::vector<const Wanted*> first;  // per mix
	for (const Wanted& w : wanted_) {
		if (first.empty() || first.back()->face != w.face || first.back()->vertex != w.vertex) {
			first.push_back(&w);
		}
		*w.slot = w.firstMix + static_cast<std::uint32_t>(first.size() - 1);
	}
	out_.mixes.resize(first.size());
	constexpr std::size_t kMixGrain = 256;
	return parallelFor(first.size(), kMixGrain, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t i = begin; i < end; ++i) {
			                   const Place place =
			                       locator_.locate(first[i]->face, first[i]->vertex);
			                   out_.mixes[i] = {locator_.givenFace(place.face), place.weights};
		                   }
	                   });
}

Status SourceFinder::run(bool corners) {
	out_.vertexCount = static_cast<std::uint32_t>(arrangement_.mesh.points.size());
	Status status = findFaces();
	if (status.ok()) {
		status = findVertices();
	}
	if (status.ok() && corners) {
		status = findCorners();
	}
	return status.ok() ? mixWanted() : status;
}

}  // namespace

Status findAttributeSources(const Arrangement& arrangement, const GivenTriangles& given,
                            const Seams& seams, AttributeNeeds needs, Monitor& monitor,
                            SourcedMesh& mesh, AttributeSources& out) {
	out = AttributeSources{};
	const Locator locator(arrangement, given, mesh);
	const Status status = Parting(arrangement, locator, seams, needs.partCurve, mesh).run(monitor);
	return status.ok() ? SourceFinder(arrangement, locator, monitor, mesh, out).run(needs.corners)
	                   : status;
}

}  // namespace index_boolean
