// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/arrange/face_classes.h"

#include <map>

namespace index_boolean {

namespace {

// Per input face: the first face of its polygon if that has several faces, else none.
std::vector<std::uint32_t> polygonsOfSeveral(const Arrangement& arrangement) {
	const std::vector<FaceId>& polygon = arrangement.polygons.polygon;
	std::vector<std::uint32_t> count(polygon.size(), 0), of(polygon.size(), kNone);
	for (const FaceId first : polygon) {
		++count[first.value];
	}
	for (std::size_t f = 0; f < polygon.size(); ++f) {
		of[f] = count[polygon[f].value] > 1 ? polygon[f].value : kNone;
	}
	return of;
}

}  // namespace

std::array<std::uint32_t, 2> givenClassOf(const Arrangement& arrangement, FaceId face) {
	const MeshArrays& mesh = arrangement.mesh;
	const std::vector<std::uint32_t>& given = mesh.faceClass[mesh.operandOf(face)];
	return given.empty() ? std::array{0u, 0u} : std::array{1u, given[arrangement.givenFace(face)]};
}

void listFaceClasses(const Arrangement& arrangement, const HugeVector<FaceSource>& sources,
                     std::vector<std::uint32_t>& classes) {
	const std::vector<std::uint32_t> polygons = polygonsOfSeveral(arrangement);
	std::map<std::array<std::uint32_t, 3>, std::uint32_t> numbers;
	const auto classOf = [&](FaceId face) {
		const std::array<std::uint32_t, 2> given = givenClassOf(arrangement, face);
		return std::array{given[0], given[1], polygons.empty() ? kNone : polygons[face.value]};
	};
	classes.clear();
	classes.reserve(sources.size());
	for (const FaceSource& source : sources) {
		const auto number = static_cast<std::uint32_t>(numbers.size());
		classes.push_back(numbers.emplace(classOf(source.face), number).first->second);
	}
}

}  // namespace index_boolean
