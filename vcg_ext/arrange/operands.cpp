// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closedness costs one pass: a signed checksum over directed edges is zero iff each is matched;
// only a sum that is not zero starts the search for the places.
#include "vcg_ext/arrange/operands.h"

#include "vcg_ext/arrange/alike_faces.h"
#include "vcg_ext/arrange/duplicate_faces.h"
#include "vcg_ext/arrange/joined_polygons.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/mesh/boundary_checksum.h"
#include "vcg_ext/mesh/clean.h"
#include "vcg_ext/mesh/corner_weld.h"
#include "vcg_ext/mesh/element_counts.h"
#include "vcg_ext/mesh/non_manifold.h"
#include "vcg_ext/mesh/soup_weld.h"
#include "vcg_ext/mesh/unmatched_edges.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

Status failure(StatusCode code, OperandId operand, std::size_t count) {
	Status status;
	status.code = code;
	status.operand = numberOf(operand);
	status.count = count;
	return status;
}

Status checkSizes(const MeshArrays& mesh, std::size_t most) {
	const std::size_t points = mesh.points.size(), faces = mesh.triangles.size();
	const Status status = inOrder([&] { return checkCounts(points, faces, most); },
	                              [&] { return checkNumbering(3 * faces, most); });
	if (!status.ok()) {
		return status;
	}
	for (const OperandId operand : mesh.operands()) {
		if (mesh.faceOffsets.size(operand) == 0) {
			return failure(StatusCode::EmptyOperand, operand, 0);
		}
	}
	return {};
}

// The largest double that rounds to a finite number of the output scalar. If it can hold the
// corners of a face, it can hold all points between them.
double largestCoordinate(OutputScalar scalar) {
	constexpr double kRoundsToLargestFloat = 0x1.fffffefffffffp127;
	return scalar == OutputScalar::Float ? kRoundsToLargestFloat
	                                     : std::numeric_limits<double>::max();
}

bool cornersExist(const MeshArrays& mesh, std::size_t face) {
	const OperandId operand = mesh.operandOf(makeId<FaceTag>(face));
	const std::uint32_t begin = mesh.vertexOffsets.begin(operand);
	const std::uint32_t end = mesh.vertexOffsets.end(operand);
	const auto exists = [=](VertexId v) { return v.value >= begin && v.value < end; };
	const Triangle& t = mesh.triangles[face];
	return exists(t[0]) && exists(t[1]) && exists(t[2]);
}

// The first defect of one face's corners, or Ok.
StatusCode cornerDefect(const MeshArrays& mesh, std::size_t face, OutputScalar scalar) {
	if (!cornersExist(mesh, face)) {
		return StatusCode::IndexOutOfRange;
	}
	const Triangle& t = mesh.triangles[face];
	const auto areWithin = [&](OutputScalar limit) {
		const double most = largestCoordinate(limit);
		return std::all_of(t.begin(), t.end(),
		                   [&](VertexId v) { return isWithin(at(mesh.points, v), most); });
	};
	if (!areWithin(OutputScalar::Double)) {
		return StatusCode::NotFinite;
	}
	return areWithin(scalar) ? StatusCode::Ok : StatusCode::BeyondFloat;
}

// Lists the faces of one operand that have the given defect.
Status refuseCorners(const Arrangement& arrangement, StatusCode code) {
	const MeshArrays& mesh = arrangement.mesh;
	const OutputScalar scalar = arrangement.options.outputScalar;
	Status status;
	for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
		const OperandId operand = mesh.operandOf(makeId<FaceTag>(face));
		if (cornerDefect(mesh, face, scalar) == code &&
		    (status.ok() || status.operand == numberOf(operand))) {
			status.code = code;
			status.operand = numberOf(operand);
			status.faces.push_back(
			    static_cast<std::uint32_t>(face - mesh.faceOffsets.begin(operand)));
		}
	}
	status.count = status.faces.size();
	return status;
}

// Of corners some of which the output scalar cannot hold, if a face uses them.
Status refusePlaces(const Arrangement& arrangement) {
	return inOrder([&] { return refuseCorners(arrangement, StatusCode::NotFinite); },
	               [&] { return refuseCorners(arrangement, StatusCode::BeyondFloat); });
}

bool hasEqualCorners(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Whether all faces have corners that exist; whether any has two equal ones.
struct CornerFacts {
	bool allExist = true;
	bool anyEqual = false;
};

Status lookAtCorners(const Arrangement& arrangement, Monitor& monitor, CornerFacts& out) {
	const MeshArrays& mesh = arrangement.mesh;
	std::vector<CornerFacts> parts(chunkCount(mesh.triangles.size(), kGrain));
	const Status status =
	    parallelForChunks(mesh.triangles.size(), kGrain, arrangement.options.threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      CornerFacts facts;
		                      for (std::size_t face = begin; face < end; ++face) {
			                      facts.allExist &= cornersExist(mesh, face);
			                      facts.anyEqual |= hasEqualCorners(mesh.triangles[face]);
		                      }
		                      parts[chunk] = facts;
	                      });
	for (const CornerFacts& part : parts) {
		out.allExist &= part.allExist;
		out.anyEqual |= part.anyEqual;
	}
	return status;
}

// Two streams, over points and over triangles, tell that all is well; only a defect in one of them
// starts the search for faces, since a bad vertex that no face uses does not matter.
Status checkCorners(const Arrangement& arrangement, Monitor& monitor, CornerWelder& welder,
                    CornerFacts& facts) {
	bool inRange = true;
	Status status = lookAtCorners(arrangement, monitor, facts);
	if (status.ok()) {
		status = welder.findSuspects(largestCoordinate(arrangement.options.outputScalar), inRange);
	}
	if (status.ok() && !facts.allExist) {
		status = refuseCorners(arrangement, StatusCode::IndexOutOfRange);
	}
	return status.ok() && !inRange ? refusePlaces(arrangement) : status;
}

// Faces with two equal corners go: their edges cancel, so closedness stays as it is.
Status dropCollapsedFaces(Arrangement& arrangement) {
	MeshArrays& mesh = arrangement.mesh;
	std::size_t kept = 0;
	std::vector<std::uint32_t> given;
	OperandOffsets offsets(mesh.operands().count());
	for (const OperandId operand : mesh.operands()) {
		const std::uint32_t begin = mesh.faceOffsets.begin(operand);
		const std::uint32_t end = mesh.faceOffsets.end(operand);
		for (std::uint32_t face = begin; face < end; ++face) {
			if (!hasEqualCorners(mesh.triangles[face])) {
				mesh.triangles[kept] = mesh.triangles[face];
				if (!mesh.faux.empty()) {
					mesh.faux[kept] = mesh.faux[face];
				}
				++kept;
				given.push_back(face - begin);
			}
		}
		offsets.setEnd(operand, kept);
	}
	mesh.faceOffsets = std::move(offsets);
	mesh.triangles.resize(kept);
	mesh.faux.resize(mesh.faux.empty() ? 0 : kept);
	arrangement.faceGiven = std::move(given);
	return checkSizes(mesh, arrangement.options.mostElements);
}

// Whether the edge from a to b lies on the line of an edge of a triangle.
bool liesOnEdge(const MeshArrays& mesh, std::uint32_t a, std::uint32_t b, VertexId from,
                VertexId to) {
	const Point &p = at(mesh.points, from), &q = at(mesh.points, to);
	return hasZeroArea(p, q, mesh.points[a]) && hasZeroArea(p, q, mesh.points[b]);
}

// The faux edges of a face, or of a piece of a face of the arrays: those that lie on such an edge
// of that face, and those inside it.
std::uint8_t pieceFaux(const MeshArrays& mesh, std::uint32_t whole, const IndexTriangle& piece) {
	const Triangle& t = mesh.triangles[whole];
	unsigned mask = 0;
	for (unsigned i = 0; i < 3; ++i) {
		bool isFaux = true;
		for (unsigned side = 0; side < 3; ++side) {
			if (liesOnEdge(mesh, piece[i], piece[(i + 1) % 3], t[side], t[(side + 1) % 3])) {
				isFaux = (mesh.faux[whole] >> side & 1U) != 0;
			}
		}
		mask |= isFaux ? 1U << i : 0U;
	}
	return static_cast<std::uint8_t>(mask);
}

// The faces of all operands, one after another, as they replace those of the arrays.
struct NewFaces {
	Triangles triangles;
	std::vector<std::uint32_t> given;
	std::vector<std::uint8_t> faux;  // if the arrays have any
	OperandOffsets offsets;
};

// Takes an operand as it is.
void keepOperand(const Arrangement& arrangement, OperandId operand, NewFaces& out) {
	const MeshArrays& mesh = arrangement.mesh;
	const std::uint32_t begin = mesh.faceOffsets.begin(operand);
	const std::uint32_t end = mesh.faceOffsets.end(operand);
	out.triangles.insert(out.triangles.end(), mesh.triangles.begin() + begin,
	                     mesh.triangles.begin() + end);
	for (std::uint32_t face = begin; face < end; ++face) {
		out.given.push_back(arrangement.givenFace({face}));
	}
	if (!mesh.faux.empty()) {
		out.faux.insert(out.faux.end(), mesh.faux.begin() + begin, mesh.faux.begin() + end);
	}
}

// Splits the zero-area faces of one operand away across their longest edges: a face of three
// collinear corners cannot be dropped without opening the surface.
Status cleanOperand(const Arrangement& arrangement, OperandId operand, Monitor& monitor,
                    NewFaces& out) {
	const MeshArrays& mesh = arrangement.mesh;
	const int threads = arrangement.options.threads;
	IndexTriangles triangles;
	std::vector<std::uint32_t> before;  // the face that each is or is a piece of
	for (std::uint32_t face = mesh.faceOffsets.begin(operand); face < mesh.faceOffsets.end(operand);
	     ++face) {
		const Triangle& t = mesh.triangles[face];
		triangles.push_back({t[0].value, t[1].value, t[2].value});
		before.push_back(face);
	}
	std::vector<std::uint32_t> zeroAreaFaces;
	CleanResult cleaned;
	Status status = findZeroAreaFaces(mesh.points, triangles, FaceRange{0, triangles.size()},
	                                  threads, monitor, zeroAreaFaces);
	if (status.ok()) {
		status = cleanSurface(mesh.points, zeroAreaFaces, threads, monitor, triangles, cleaned);
	}
	if (!status.ok()) {
		return status;
	}
	cleaned.faces.apply(before);
	for (std::size_t f = 0; f < triangles.size(); ++f) {
		const IndexTriangle& piece = triangles[f];
		const Triangle& t = mesh.triangles[before[f]];
		out.triangles.push_back({VertexId{piece[0]}, VertexId{piece[1]}, VertexId{piece[2]}});
		out.given.push_back(arrangement.givenFace({before[f]}));
		if (!mesh.faux.empty()) {
			const bool isWhole = piece == IndexTriangle{t[0].value, t[1].value, t[2].value};
			out.faux.push_back(isWhole ? mesh.faux[before[f]] : pieceFaux(mesh, before[f], piece));
		}
	}
	return status;
}

Status findClosed(Arrangement& arrangement, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	return forEachOperand(mesh.operands(), [&](OperandId operand) {
		const Triangle* begin = mesh.triangles.data() + mesh.faceOffsets.begin(operand);
		const Triangle* end = mesh.triangles.data() + mesh.faceOffsets.end(operand);
		std::uint64_t sum = 0;
		const Status status =
		    boundaryChecksum(begin, end, arrangement.options.threads, monitor, sum);
		arrangement.closed[operand] = sum == 0;
		return status;
	});
}

// Ok, or where an operand is not closed or not consistently oriented.
Status checkClosed(Arrangement& arrangement, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	Status status = findClosed(arrangement, monitor);
	const auto isOpen = [&](OperandId operand) { return !arrangement.closed[operand]; };
	const auto all = mesh.operands();
	const auto open = std::find_if(all.begin(), all.end(), isOpen);
	if (!status.ok() || open == all.end()) {
		return status;
	}
	const std::uint32_t first = mesh.faceOffsets.begin(*open);
	UnmatchedEdges found;
	findUnmatchedEdges(mesh.triangles.data() + first,
	                   mesh.triangles.data() + mesh.faceOffsets.end(*open), found);
	const bool hasBorder = found.borderEdges > 0;
	status = failure(hasBorder ? StatusCode::NotClosed : StatusCode::NotOriented, *open,
	                 hasBorder ? found.borderEdges : found.conflictingEdges);
	status.hasPlace = true;
	status.place = at(mesh.points, found.firstEdge[0]);
	for (const std::uint32_t face : found.faces) {
		status.faces.push_back(arrangement.givenFace({face + first}));
	}
	return status;
}

struct VolumeSum {
	double value = 0;
	double bound = 0;
};

// Six times the volume of the tetrahedron between a face and a point, and a bound on its error: as
// orient3dBounded, but from the face's normal, whose parts are small where the face is. Eight
// rounded operations lie on each path, so the error is below 9u times `size`.
VolumeSum sixVolumes(const Point& corner, const RoundedNormal& normal, const Point& reference) {
	VolumeSum result;
	double size = 0, room = 1;
	for (std::size_t k = 0; k < 3; ++k) {
		const double height = corner[k] - reference[k];
		result.value += normal.value[k] * height;
		size += normal.size[k] * std::fabs(height);
		room += std::fabs(height);
	}
	result.bound = 10 * kRoundoff * size + kUnderflow * room;
	return result;
}

// What one pass over an operand's faces tells.
struct FacesSeen {
	VolumeSum sixVolumes;                 // signed
	std::vector<std::uint32_t> zeroArea;  // the faces without area, ascending
};

FacesSeen lookAtFaces(const MeshArrays& mesh, std::size_t begin, std::size_t end,
                      const Point& reference) {
	FacesSeen seen;
	VolumeSum& sum = seen.sixVolumes;
	for (std::size_t face = begin; face < end; ++face) {
		const Triangle& t = mesh.triangles[face];
		const Point &a = at(mesh.points, t[0]), &b = at(mesh.points, t[1]),
		            &c = at(mesh.points, t[2]);
		const RoundedNormal normal(a, b, c);
		if (!normal.isCertain() && hasZeroArea(a, b, c)) {
			seen.zeroArea.push_back(static_cast<std::uint32_t>(face));
		}
		const VolumeSum term = sixVolumes(a, normal, reference);
		sum.value += term.value;
		// Each of the partial sums is rounded once more.
		sum.bound += term.bound + 2 * kRoundoff * std::fabs(sum.value);
	}
	return seen;
}

// Looks at both operands' faces, in fixed chunks.
Status lookAtFaces(const Arrangement& arrangement, Monitor& monitor, PerOperand<FacesSeen>& out) {
	const MeshArrays& mesh = arrangement.mesh;
	out = PerOperand<FacesSeen>(mesh.operands().count());
	return forEachOperand(mesh.operands(), [&](OperandId operand) {
		const std::size_t first = mesh.faceOffsets.begin(operand);
		const std::size_t count = mesh.faceOffsets.size(operand);
		const Point& reference = at(mesh.points, mesh.triangles[first][0]);
		std::vector<FacesSeen> parts(chunkCount(count, kGrain));
		const Status status =
		    parallelForChunks(count, kGrain, arrangement.options.threads, monitor,
		                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			                      parts[chunk] =
			                          lookAtFaces(mesh, first + begin, first + end, reference);
		                      });
		VolumeSum& sum = out[operand].sixVolumes;
		std::vector<std::uint32_t>& zeroArea = out[operand].zeroArea;
		for (const FacesSeen& part : parts) {
			sum.value += part.sixVolumes.value;
			sum.bound += part.sixVolumes.bound + 2 * kRoundoff * std::fabs(sum.value);
			zeroArea.insert(zeroArea.end(), part.zeroArea.begin(), part.zeroArea.end());
		}
		sum.bound *= 1 + 1e-6;  // the bound's own rounding: far above n * u for any n that fits
		return status;
	});
}

// Cleans the operands that have faces without area, and looks at the faces again then.
// \param seen    what was seen, and then what is there
// \param cleaned whether there were any
Status cleanZeroAreaFaces(Arrangement& arrangement, Monitor& monitor, PerOperand<FacesSeen>& seen,
                          bool& cleaned) {
	cleaned = std::any_of(seen.begin(), seen.end(),
	                      [](const FacesSeen& faces) { return !faces.zeroArea.empty(); });
	if (!cleaned) {
		return {};
	}
	MeshArrays& mesh = arrangement.mesh;
	NewFaces faces;
	faces.offsets = OperandOffsets(mesh.operands().count());
	const Status status = forEachOperand(mesh.operands(), [&](OperandId operand) {
		Status cleaning;
		if (seen[operand].zeroArea.empty()) {
			keepOperand(arrangement, operand, faces);
		} else {
			cleaning = cleanOperand(arrangement, operand, monitor, faces);
		}
		faces.offsets.setEnd(operand, faces.triangles.size());
		return cleaning;
	});
	if (!status.ok()) {
		return status;
	}
	mesh.triangles = std::move(faces.triangles);
	mesh.faux = std::move(faces.faux);
	mesh.faceOffsets = std::move(faces.offsets);
	arrangement.faceGiven = std::move(faces.given);
	return inOrder([&] { return checkSizes(mesh, arrangement.options.mostElements); },
	               [&] { return lookAtFaces(arrangement, monitor, seen); });
}

// Finds the volumes of the closed operands, and on which side of each its solid lies. An operand
// without volume is refused, if it must not be.
Status findVolumes(Arrangement& arrangement, const PerOperand<FacesSeen>& seen,
                   bool mustHaveVolume) {
	const MeshArrays& mesh = arrangement.mesh;
	for (const OperandId operand : mesh.operands()) {
		if (!arrangement.closed[operand]) {
			continue;
		}
		const VolumeSum& sum = seen[operand].sixVolumes;
		int sign = Bounded(sum.value, sum.bound).sign();
		if (sign == kUnknownSign || sign == 0) {
			sign = exactVolumeSign(mesh.points,
			                       mesh.triangles.data() + mesh.faceOffsets.begin(operand),
			                       mesh.triangles.data() + mesh.faceOffsets.end(operand));
		}
		if (sign == 0 && mustHaveVolume) {
			return failure(StatusCode::NoVolume, operand, 0);
		}
		arrangement.insideOut[operand] = sign < 0;
		arrangement.volume[operand] = std::fabs(sum.value) / 6;
	}
	return {};
}

void turnFaux(MeshArrays& mesh, OperandId operand) {
	for (std::size_t f = mesh.faceOffsets.begin(operand);
	     !mesh.faux.empty() && f < mesh.faceOffsets.end(operand); ++f) {
		mesh.faux[f] = turnedFaux(mesh.faux[f]);
	}
}

Status turnRightSideOut(Arrangement& arrangement, const PerOperand<FacesSeen>& seen) {
	MeshArrays& mesh = arrangement.mesh;
	const Status status = findVolumes(arrangement, seen, true);
	for (const OperandId operand : mesh.operands()) {
		if (status.ok() && arrangement.insideOut[operand]) {
			std::for_each(mesh.triangles.begin() + mesh.faceOffsets.begin(operand),
			              mesh.triangles.begin() + mesh.faceOffsets.end(operand),
			              [](Triangle& t) { std::swap(t[1], t[2]); });
			turnFaux(mesh, operand);
		}
	}
	return status;
}

// A part of an operand's vertices.
struct VertexTask {
	OperandId operand;
	VertexRange vertices;
};

// Tasks for all vertices of both operands: each looks at all faces of its operand, so that few are
// best, of about the same size. Once welded, the second operand has vertices of the first.
std::vector<VertexTask> divideVertices(const MeshArrays& mesh) {
	std::vector<VertexTask> tasks;
	for (const OperandId operand : mesh.operands()) {
		const std::uint32_t end = mesh.vertexOffsets.end(operand);
		const std::size_t faces = mesh.faceOffsets.size(operand);
		const bool isLarge = faces > kGrain && faces > mesh.triangles.size() / 3 * 2;
		const std::uint32_t middle = isLarge ? mesh.vertexOffsets.begin(operand) +
		                                           (end - mesh.vertexOffsets.begin(operand)) / 2
		                                     : 0;
		if (isLarge) {
			tasks.push_back({operand, {0, middle}});
		}
		tasks.push_back({operand, {middle, end}});
	}
	return tasks;
}

// Calls body(task, begin, end) for each task with the faces of its operand.
template <class Body>
Status forEachTask(const Arrangement& arrangement, const std::vector<VertexTask>& tasks,
                   Monitor& monitor, Body&& body) {
	const MeshArrays& mesh = arrangement.mesh;
	const int threads = threadsForHalves(mesh.triangles.size(), arrangement.options.threads);
	return parallelForChunks(
	    tasks.size(), 1, threads, monitor, [&](std::size_t task, std::size_t, std::size_t) {
		    const Triangle* all = mesh.triangles.data();
		    const OperandId operand = tasks[task].operand;
		    body(task, all + mesh.faceOffsets.begin(operand), all + mesh.faceOffsets.end(operand));
	    });
}

// Finds which operands are closed manifolds: nearly all are, and need no other check.
Status findClosedManifolds(const Arrangement& arrangement, Monitor& monitor,
                           PerOperand<bool>& out) {
	const std::vector<VertexTask> tasks = divideVertices(arrangement.mesh);
	std::vector<std::uint8_t> manifold(tasks.size(), 0);
	const Status status =
	    forEachTask(arrangement, tasks, monitor,
	                [&](std::size_t task, const Triangle* begin, const Triangle* end) {
		                manifold[task] = isClosedManifold(begin, end, tasks[task].vertices) ? 1 : 0;
	                });
	std::fill(out.begin(), out.end(), true);
	for (std::size_t task = 0; task < tasks.size(); ++task) {
		out[tasks[task].operand] &= manifold[task] != 0;
	}
	return status;
}

Status findNonManifold(Arrangement& arrangement, Monitor& monitor) {
	const std::vector<VertexTask> tasks = divideVertices(arrangement.mesh);
	std::vector<std::vector<VertexId>> found(tasks.size());
	const Status status =
	    forEachTask(arrangement, tasks, monitor,
	                [&](std::size_t task, const Triangle* begin, const Triangle* end) {
		                findNonManifoldVertices(begin, end, tasks[task].vertices, found[task]);
	                });
	std::vector<VertexId>& all = arrangement.nonManifold;
	for (const std::vector<VertexId>& part : found) {
		all.insert(all.end(), part.begin(), part.end());
	}
	std::sort(all.begin(), all.end());
	all.erase(std::unique(all.begin(), all.end()), all.end());
	return status;
}

// Checks the arrays, welds each operand's vertices and drops faces with two equal corners.
Status weldOperands(Arrangement& arrangement, Monitor& monitor, CornerWelder& welder) {
	CornerFacts facts;
	PerOperand<bool>& welded = arrangement.seams;
	const auto lookAgain = [&] {
		const bool any = std::find(welded.begin(), welded.end(), true) != welded.end();
		return any ? lookAtCorners(arrangement, monitor, facts) : Status{};
	};
	return inOrder([&] { return checkSizes(arrangement.mesh, arrangement.options.mostElements); },
	               [&] { return checkCorners(arrangement, monitor, welder, facts); },
	               [&] { return welder.weldWithinOperands(welded); }, lookAgain,
	               [&] { return facts.anyEqual ? dropCollapsedFaces(arrangement) : Status{}; });
}

// Ok if the output scalar can hold the places of all corners.
Status checkPlaces(const Arrangement& arrangement, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	const double most = largestCoordinate(arrangement.options.outputScalar);
	const auto isFine = [&](VertexId v) { return isWithin(at(mesh.points, v), most); };
	std::atomic<bool> areFine{true};
	const auto look = [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			const Triangle& t = mesh.triangles[f];
			if (!isFine(t[0]) || !isFine(t[1]) || !isFine(t[2])) {
				areFine = false;
			}
		}
	};
	return inOrder(
	    [&] {
		    return parallelFor(mesh.triangles.size(), kGrain, arrangement.options.threads, monitor,
		                       look);
	    },
	    [&] { return areFine ? Status{} : refusePlaces(arrangement); });
}

// Checks the arrays of a soup, welds each operand's vertices and drops faces with equal corners.
Status weldSoup(Arrangement& arrangement, Monitor& monitor) {
	MeshArrays& mesh = arrangement.mesh;
	CornerFacts facts;
	return inOrder([&] { return checkSizes(mesh, arrangement.options.mostElements); },
	               [&] { return lookAtCorners(arrangement, monitor, facts); },
	               [&] {
		               return facts.allExist
		                          ? checkPlaces(arrangement, monitor)
		                          : refuseCorners(arrangement, StatusCode::IndexOutOfRange);
	               },
	               [&] { return weldEachOperand(mesh, monitor, arrangement.seams); },
	               [&] { return lookAtCorners(arrangement, monitor, facts); },
	               [&] { return facts.anyEqual ? dropCollapsedFaces(arrangement) : Status{}; });
}

// Lists the vertices of a welded soup whose faces are not one umbrella.
// A part of the vertices looks at all faces: it is to be large, but not to take long.
Status findUmbrellas(Arrangement& arrangement, Monitor& monitor) {
	constexpr std::size_t kFacesOfPart = 1 << 20;
	const MeshArrays& mesh = arrangement.mesh;
	const std::size_t faceCount = mesh.triangles.size(), vertexCount = mesh.points.size();
	const int threads = threadsForHalves(faceCount, arrangement.options.threads);
	const std::size_t parts =
	    faceCount < kGrain ? 1 : std::max<std::size_t>(2, faceCount / kFacesOfPart);
	const std::size_t grain = vertexCount / parts + 1;
	std::vector<std::vector<VertexId>> found(chunkCount(vertexCount, grain));
	const Triangle* const faces = mesh.triangles.data();
	const Status status =
	    parallelForChunks(vertexCount, grain, threads, monitor,
	                      [&](std::size_t part, std::size_t begin, std::size_t end) {
		                      const VertexRange range{static_cast<std::uint32_t>(begin),
		                                              static_cast<std::uint32_t>(end)};
		                      findNonManifoldVertices(faces, faces + faceCount, range, found[part]);
	                      });
	for (const std::vector<VertexId>& part : found) {
		arrangement.nonManifold.insert(arrangement.nonManifold.end(), part.begin(), part.end());
	}
	return status;
}

// Lists the vertices that several operands have.
Status findShared(Arrangement& arrangement, Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	std::vector<OperandId> owner(mesh.points.size(), OperandId::none());
	return forEachOperand(mesh.operands(), [&](OperandId operand) {
		const std::size_t first = mesh.faceOffsets.begin(operand);
		return inOrderFor(mesh.faceOffsets.size(operand), kGrain, monitor,
		                  [&](std::size_t begin, std::size_t end) {
			                  for (std::size_t f = first + begin; f < first + end; ++f) {
				                  for (const VertexId v : mesh.triangles[f]) {
					                  if (at(owner, v) != OperandId::none() &&
					                      at(owner, v) != operand) {
						                  arrangement.nonManifold.push_back(v);
					                  }
					                  at(owner, v) = operand;
				                  }
			                  }
		                  });
	});
}

// The vertices of a welded soup that several operands have, or whose faces are not one umbrella.
Status findSoupNonManifold(Arrangement& arrangement, Monitor& monitor) {
	return inOrder([&] { return findUmbrellas(arrangement, monitor); },
	               [&] { return findShared(arrangement, monitor); },
	               [&] {
		               std::vector<VertexId>& all = arrangement.nonManifold;
		               std::sort(all.begin(), all.end());
		               all.erase(std::unique(all.begin(), all.end()), all.end());
		               return Status{};
	               });
}

// Makes room for what is known of each operand.
void makeRoomForOperands(Arrangement& arrangement) {
	const std::size_t count = arrangement.mesh.operands().count();
	arrangement.seams = arrangement.closed = arrangement.insideOut = PerOperand<bool>(count);
	arrangement.duplicates.cancelledPairs = PerOperand<std::size_t>(count);
	arrangement.duplicates.takenOnce = PerOperand<std::size_t>(count);
	arrangement.selfIntersecting = PerOperand<std::size_t>(count);
	arrangement.turnedAlike = PerOperand<std::size_t>(count);
	arrangement.volume = PerOperand<double>(count);
}

}  // namespace

Status prepareOperands(Arrangement& arrangement, Monitor& monitor) {
	CornerWelder welder(arrangement.mesh, arrangement.options.threads, monitor);
	PerOperand<bool>& manifold = arrangement.closed;
	PerOperand<FacesSeen> seen;
	bool allManifold = false, cleaned = false;
	return inOrder([&] { return weldOperands(arrangement, monitor, welder); },
	               [&] { return findClosedManifolds(arrangement, monitor, manifold); },
	               [&] {
		               allManifold =
		                   std::find(manifold.begin(), manifold.end(), false) == manifold.end();
		               return allManifold ? Status{} : removeDuplicateFaces(arrangement, monitor);
	               },
	               [&] { return allManifold ? Status{} : checkClosed(arrangement, monitor); },
	               [&] { return lookAtFaces(arrangement, monitor, seen); },
	               [&] { return cleanZeroAreaFaces(arrangement, monitor, seen, cleaned); },
	               [&] { return welder.weldSecondToFirst(); },
	               [&] {
		               const bool isKnown = allManifold && !cleaned;
		               return isKnown ? Status{} : findNonManifold(arrangement, monitor);
	               },
	               [&] { return turnRightSideOut(arrangement, seen); },
	               [&] { return joinPolygons(arrangement, monitor); });
}

Status prepareSurfaces(Arrangement& arrangement, Monitor& monitor) {
	CornerWelder welder(arrangement.mesh, arrangement.options.threads, monitor);
	PerOperand<FacesSeen> seen;
	bool cleaned = false;
	std::size_t faceCount = 0;
	return inOrder([&] { return weldOperands(arrangement, monitor, welder); },
	               [&] { return lookAtFaces(arrangement, monitor, seen); },
	               [&] { return cleanZeroAreaFaces(arrangement, monitor, seen, cleaned); },
	               [&] {
		               faceCount = arrangement.mesh.triangles.size();
		               return takeDuplicateFacesOnce(arrangement, monitor);
	               },
	               [&] {
		               const bool anyDropped = arrangement.mesh.triangles.size() < faceCount;
		               return anyDropped ? lookAtFaces(arrangement, monitor, seen) : Status{};
	               },
	               [&] { return welder.weldSecondToFirst(); },
	               [&] { return findClosed(arrangement, monitor); },
	               [&] { return findNonManifold(arrangement, monitor); },
	               [&] { return joinPolygons(arrangement, monitor); },
	               [&] { return findVolumes(arrangement, seen, false); });
}

Status prepareSoup(Arrangement& arrangement, Monitor& monitor) {
	PerOperand<FacesSeen> seen;
	bool cleaned = false;
	arrangement.isSoup = true;
	makeRoomForOperands(arrangement);
	return inOrder([&] { return weldSoup(arrangement, monitor); },
	               [&] { return lookAtFaces(arrangement, monitor, seen); },
	               [&] { return cleanZeroAreaFaces(arrangement, monitor, seen, cleaned); },
	               [&] { return weldOperandsTogether(arrangement.mesh, monitor); },
	               [&] { return findClosed(arrangement, monitor); },
	               [&] { return takeRepeatedFacesOnce(arrangement, monitor); },
	               [&] { return turnFacesAlike(arrangement, monitor); },
	               [&] { return findSoupNonManifold(arrangement, monitor); },
	               [&] { return lookAtFaces(arrangement, monitor, seen); },
	               [&] {
		               for (const OperandId operand : arrangement.mesh.operands()) {
			               arrangement.volume[operand] = seen[operand].sixVolumes.value / 6;
		               }
		               return joinPolygons(arrangement, monitor);
	               });
}

}  // namespace index_boolean
