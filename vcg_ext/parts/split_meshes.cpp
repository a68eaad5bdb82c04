// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces of the complex are chosen, then written with new numbers for their vertices, in the order
// of the old ones: so a mesh does not depend on the others.
#include "vcg_ext/parts/split_meshes.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/stored_operands.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/carry/certificates.h"
#include "vcg_ext/carry/polygons.h"
#include "vcg_ext/mesh/clean.h"
#include "vcg_ext/mesh/face_key.h"

#include <algorithm>
#include <map>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

// A face of the complex as a mesh has it.
struct ChosenFace {
	std::uint32_t face;
	FaceSource source;
	bool turned;  // the other way than the complex has it
};

class SplitMeshCollector {
public:
	SplitMeshCollector(const Arrangement& arrangement, const SubSurfaces& surfaces,
	                   const SubBlocks& blocks, Monitor& monitor, SplitMesh& out)
	    : arrangement_(arrangement), stored_(asStored(arrangement)), surfaces_(surfaces),
	      blocks_(blocks), monitor_(monitor), out_(out) {}

	// Makes room for faces to be chosen.
	void expect(std::size_t faceCount) { chosen_.reserve(faceCount); }
	void choose(const ChosenFace& face);
	// Makes the mesh of the chosen faces. \param isOneSurface else each sub-surface is one
	Status run(bool isOneSurface);

private:
	void dropFolds(bool isOneSurface);
	Status cleanOneSurface();
	Status nameSources();
	void listVertices();
	std::uint32_t numberOf(VertexId v) const;
	Status placeVertices();
	Status writeFaces();
	Status clean();
	std::vector<std::uint32_t> subSurfaceOfFaces() const;
	Status certify(bool isOneSurface);
	Status markPolygons();
	std::array<std::int32_t, 2> besideOf(const ChosenFace& face) const;
	const Triangle& cornersOf(std::size_t chosen) const {
		return corners_.empty() ? surfaces_.complex.faces[chosen_[chosen].face].corners
		                        : corners_[chosen];
	}

	const Arrangement& arrangement_;
	const Arrangement& stored_;  // that the vertices are of
	const SubSurfaces& surfaces_;
	const SubBlocks& blocks_;
	Monitor& monitor_;
	SplitMesh& out_;
	HugeVector<ChosenFace> chosen_;
	Triangles corners_;                  // of each, where other triangles are stored; else empty
	HugeVector<std::uint32_t> numbers_;  // per vertex, kNone without; empty: look it up
};

void SplitMeshCollector::choose(const ChosenFace& face) {
	const StoredTriangles& stored = surfaces_.stored;
	if (!stored.areThere()) {
		chosen_.push_back(face);
		return;
	}
	for (std::uint32_t i = stored.first[face.face]; i < stored.first[face.face + 1]; ++i) {
		chosen_.push_back(face);
		corners_.push_back(stored.triangles[i]);
	}
}

// Of triangles stored on the same corners, those that are turned against each other are one sheet
// folded onto itself: they go in pairs, from a sub-block, or from one sub-surface each.
void SplitMeshCollector::dropFolds(bool isOneSurface) {
	using Part = std::pair<std::uint32_t, std::array<VertexId, 3>>;
	std::map<Part, std::array<std::vector<std::size_t>, 2>> standing;  // each way round
	std::vector<std::uint8_t> isGone(chosen_.size(), 0);
	for (std::size_t i = 0; i < chosen_.size(); ++i) {
		const FaceKey<VertexId> key = faceKeyOf(corners_[i]);
		const bool isForward = key.ascending != chosen_[i].turned;
		const std::uint32_t part = isOneSurface ? 0 : surfaces_.ofFace[chosen_[i].face].value;
		auto& ways = standing[{part, key.corners}];
		auto& same = ways[isForward ? 1 : 0];
		auto& opposite = ways[isForward ? 0 : 1];
		if (opposite.empty()) {
			same.push_back(i);
		} else {
			isGone[i] = isGone[opposite.back()] = 1;
			opposite.pop_back();
		}
	}
	std::size_t kept = 0;
	for (std::size_t i = 0; i < chosen_.size(); ++i) {
		if (isGone[i] == 0) {
			chosen_[kept] = chosen_[i];
			corners_[kept++] = corners_[i];
		}
	}
	chosen_.resize(kept);
	corners_.resize(kept);
}

std::array<std::int32_t, 2> SplitMeshCollector::besideOf(const ChosenFace& face) const {
	std::array<std::int32_t, 2> beside = at(blocks_.beside, surfaces_.ofFace[face.face]);
	if (face.turned != (surfaces_.turned[face.face] != 0)) {
		std::swap(beside[0], beside[1]);
	}
	return beside;
}

// Lists the vertices of the chosen faces, ascending: by marks unless few of all are chosen.
void SplitMeshCollector::listVertices() {
	const HugeVector<RefinedFace>& faces = surfaces_.complex.faces;
	HugeVector<VertexId>& used = out_.vertexSource;
	constexpr std::size_t kFewOf = 64;
	if (chosen_.size() < faces.size() / kFewOf) {
		for (std::size_t i = 0; i < chosen_.size(); ++i) {
			const Triangle& t = cornersOf(i);
			used.insert(used.end(), t.begin(), t.end());
		}
		std::sort(used.begin(), used.end());
		used.erase(std::unique(used.begin(), used.end()), used.end());
		return;
	}
	numbers_.assign(stored_.mesh.points.size() + stored_.curve.pointCount(), kNone);
	for (std::size_t i = 0; i < chosen_.size(); ++i) {
		for (const VertexId v : cornersOf(i)) {
			at(numbers_, v) = 0;
		}
	}
	used.reserve(numbers_.size());
	for (std::uint32_t v = 0; v < numbers_.size(); ++v) {
		if (numbers_[v] != kNone) {
			numbers_[v] = static_cast<std::uint32_t>(used.size());
			used.push_back({v});
		}
	}
}

std::uint32_t SplitMeshCollector::numberOf(VertexId v) const {
	if (!numbers_.empty()) {
		return at(numbers_, v);
	}
	const auto it = std::lower_bound(out_.vertexSource.begin(), out_.vertexSource.end(), v);
	return static_cast<std::uint32_t>(it - out_.vertexSource.begin());
}

Status SplitMeshCollector::placeVertices() {
	listVertices();
	const HugeVector<VertexId>& used = out_.vertexSource;
	out_.points.resizeForOverwrite(used.size());
	return parallelFor(used.size(), kGrain, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t v = begin; v < end; ++v) {
			                   out_.points[v] = outputCoordinates(stored_, used[v]);
		                   }
	                   });
}

Status SplitMeshCollector::clean() {
	CleanResult cleaned;
	const Status status =
	    cleanMesh(FaceRange{0, out_.triangles.size()}, arrangement_.options.threads, monitor_,
	              out_.points, out_.triangles, cleaned);
	if (status.ok()) {
		out_.zeroAreaFacesRemoved = cleaned.zeroAreaFacesRemoved;
		cleaned.faces.apply(out_.faceSource);
		cleaned.faces.apply(out_.subSurface);
		cleaned.faces.apply(out_.beside);
		cleaned.vertices.apply(out_.vertexSource);
	}
	return status;
}

// Per face, the number of its sub-surface.
std::vector<std::uint32_t> SplitMeshCollector::subSurfaceOfFaces() const {
	std::vector<std::uint32_t> part;
	for (const SubSurfaceId id : out_.subSurface) {
		part.push_back(id.value);
	}
	return part;
}

Status SplitMeshCollector::certify(bool isOneSurface) {
	const std::vector<std::uint32_t> part =
	    isOneSurface ? std::vector<std::uint32_t>{} : subSurfaceOfFaces();
	const bool isAsCut = out_.zeroAreaFacesRemoved == 0 && out_.wallMerge.vertices == 0;
	return index_boolean::certify(arrangement_, out_, part, isAsCut, monitor_, out_.certificate);
}

// Polygons end where sub-surfaces do.
Status SplitMeshCollector::markPolygons() {
	const bool anyPolygon = !arrangement_.polygons.polygon.empty();
	const std::vector<std::uint32_t> part =
	    anyPolygon ? subSurfaceOfFaces() : std::vector<std::uint32_t>{};
	return findFauxEdges(arrangement_, part, monitor_, out_);
}

Status SplitMeshCollector::writeFaces() {
	const std::size_t n = chosen_.size();
	out_.triangles.resizeForOverwrite(n);
	out_.faceSource.resizeForOverwrite(n);
	out_.subSurface.resizeForOverwrite(n);
	out_.beside.resizeForOverwrite(n);
	const auto write = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			const ChosenFace& face = chosen_[i];
			const Triangle& t = cornersOf(i);
			out_.triangles[i] = {numberOf(t[0]), numberOf(t[face.turned ? 2 : 1]),
			                     numberOf(t[face.turned ? 1 : 2])};
			out_.faceSource[i] = face.source;
			out_.subSurface[i] = surfaces_.ofFace[face.face];
			out_.beside[i] = besideOf(face);
		}
	};
	return parallelFor(n, kGrain, arrangement_.options.threads, monitor_, write);
}

Status SplitMeshCollector::cleanOneSurface() {
	const BlockMeasure unrepaired = measureUnrepaired(stored_, out_, out_.repair);
	const Status status = clean();
	compareWithUnrepaired(stored_, unrepaired, out_, out_.repair);
	return status;
}

Status SplitMeshCollector::nameSources() {
	if (arrangement_.again != nullptr) {
		nameVerticesAsFirst(*arrangement_.again, out_.vertexSource);
		out_.repair.movedVertices = countMoved(arrangement_, out_);
	}
	return {};
}

Status SplitMeshCollector::run(bool isOneSurface) {
	if (!corners_.empty()) {
		dropFolds(isOneSurface);
	}
	out_.wallMerge = surfaces_.wallMerge;
	return inOrder([this] { return placeVertices(); }, [this] { return writeFaces(); },
	               [&] { return isOneSurface ? cleanOneSurface() : clean(); },
	               [&] { return certify(isOneSurface); }, [this] { return nameSources(); },
	               [this] { return markPolygons(); });
}

}  // namespace

Status collectSubSurfaces(const Arrangement& arrangement, const SubSurfaces& surfaces,
                          const SubBlocks& blocks, const SurfaceChoice& choice, Monitor& monitor,
                          SplitMesh& out) {
	out = SplitMesh{};
	SplitMeshCollector collector(arrangement, surfaces, blocks, monitor, out);
	const HugeVector<RefinedFace>& faces = surfaces.complex.faces;
	collector.expect(faces.size());
	const auto isWanted = [&](std::size_t face) {
		return choice.isChosen.empty() || at(choice.isChosen, surfaces.ofFace[face]) != 0;
	};
	const auto choose = [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			bool isStillWanted = isWanted(f);  // once, however often the operand has it
			surfaces.complex.visitSources(faces[f], [&](FaceId source, bool opposed) {
				if (isStillWanted && arrangement.mesh.operandOf(source) == choice.operand) {
					collector.choose({static_cast<std::uint32_t>(f), {source, false}, opposed});
					isStillWanted = false;
				}
			});
		}
	};
	const Status status = inOrderFor(faces.size(), kGrain, monitor, choose);
	return status.ok() ? collector.run(false) : status;
}

Status collectSubBlock(const Arrangement& arrangement, const SubSurfaces& surfaces,
                       const SubBlocks& blocks, SubBlockId block, Monitor& monitor,
                       SplitMesh& out) {
	out = SplitMesh{};
	SplitMeshCollector collector(arrangement, surfaces, blocks, monitor, out);
	std::size_t faceCount = 0;
	for (const SubSurfaceSide& side : at(blocks.all, block).sides) {
		faceCount += at(surfaces.all, side.of).faceCount;
	}
	collector.expect(faceCount);
	for (const SubSurfaceSide& side : at(blocks.all, block).sides) {
		const SubSurface& surface = at(surfaces.all, side.of);
		for (std::uint32_t i = surface.firstFace; i < surface.firstFace + surface.faceCount; ++i) {
			const std::uint32_t face = surfaces.faces[i];
			const bool turned = side.isBack == (surfaces.turned[face] != 0);
			collector.choose({face, {surfaces.complex.faces[face].source, turned}, turned});
		}
	}
	return collector.run(true);
}

}  // namespace index_boolean
