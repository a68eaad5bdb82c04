// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A component is asked for the others' winding number at one place, inside its first face. If the
// operand is right, its whole winding number is 1 behind the face and 0 in front of it. If the
// place lies on a wall of another component, and all is right, then that wall faces the other way:
//  - behind both there is material, and between them a gap without width: 1 on both sides;
//  - or in front of both there is none, and between them a wall without width: 0 on both sides.
// Where walls face the same way, the numbers differ by 2. So what is asked of each side is to be 0
// or 1; the component's own share is that of an embedded one, as its volume's sign tells.
#include "vcg_ext/solids/nesting.h"

#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/solids/faces_to_blame.h"

namespace index_boolean {

namespace {

// The components of one operand, numbered in the order of their first faces.
struct ComponentList {
	std::vector<std::uint32_t> ofFace;  // per face of the operand
	std::vector<FaceId> firstFace;      // per component
};

ComponentList listComponents(const MeshArrays& mesh, OperandId operand,
                             const Components& components) {
	ComponentList list;
	std::vector<std::uint32_t> number(components.idLimit(), kNone);
	for (std::uint32_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand);
	     ++f) {
		std::uint32_t& component = number[components.of({f})];
		if (component == kNone) {
			component = static_cast<std::uint32_t>(list.firstFace.size());
			list.firstFace.push_back({f});
		}
		list.ofFace.push_back(component);
	}
	return list;
}

// The signs of the components' volumes.
std::vector<int> volumeSigns(const MeshArrays& mesh, OperandId operand, const ComponentList& list) {
	const std::size_t count = list.firstFace.size();
	std::vector<Bounded> sums(count, Bounded(0));
	const std::uint32_t first = mesh.faceOffsets.begin(operand);
	const Point& reference = at(mesh.points, mesh.triangles[first][0]);
	for (std::uint32_t i = 0; i < list.ofFace.size(); ++i) {
		const Triangle& t = mesh.triangles[first + i];
		Bounded& sum = sums[list.ofFace[i]];
		sum = sum - orient3dBounded(at(mesh.points, t[0]), at(mesh.points, t[1]),
		                            at(mesh.points, t[2]), reference);
	}
	std::vector<int> signs(count);
	std::vector<Triangles> unsure(count);
	for (std::size_t c = 0; c < count; ++c) {
		signs[c] = sums[c].sign();
	}
	for (std::uint32_t i = 0; i < list.ofFace.size(); ++i) {
		if (signs[list.ofFace[i]] == kUnknownSign) {
			unsure[list.ofFace[i]].push_back(mesh.triangles[first + i]);
		}
	}
	for (std::size_t c = 0; c < count; ++c) {
		if (signs[c] == kUnknownSign) {
			signs[c] =
			    exactVolumeSign(mesh.points, unsure[c].data(), unsure[c].data() + unsure[c].size());
		}
	}
	return signs;
}

}  // namespace

bool isPlacedRight(const WindingQuery& others, int volumeSign) {
	const int ownBehind = volumeSign > 0 ? 1 : 0;
	const int behind = others.behind + ownBehind, inFront = others.inFront + ownBehind - 1;
	return volumeSign != 0 && behind >= 0 && behind <= 1 && inFront >= 0 && inFront <= 1;
}

Status checkNesting(const Arrangement& arrangement, OperandId operand, const Components& components,
                    Monitor& monitor) {
	const MeshArrays& mesh = arrangement.mesh;
	const ComponentList list = listComponents(mesh, operand, components);
	const std::uint32_t first = mesh.faceOffsets.begin(operand);
	std::vector<WindingQuery> queries;
	queries.reserve(list.firstFace.size());
	for (const FaceId face : list.firstFace) {
		queries.push_back(queryInside(mesh, face));
	}
	const auto isOwn = [&](std::size_t query, FaceId face) {
		return list.ofFace[face.value - first] == query;
	};
	Status status =
	    findWindings(mesh, operand, isOwn, arrangement.options.threads, monitor, queries);
	if (!status.ok()) {
		return status;
	}
	const std::vector<int> signs = volumeSigns(mesh, operand, list);
	std::vector<std::uint8_t> wrong(queries.size());
	std::size_t wrongCount = 0;
	for (std::size_t c = 0; c < queries.size(); ++c) {
		wrong[c] = isPlacedRight(queries[c], signs[c]) ? 0 : 1;
		wrongCount += wrong[c];
	}
	std::vector<FaceId> faces;
	for (std::size_t i = 0; i < list.ofFace.size(); ++i) {
		if (wrong[list.ofFace[i]] != 0) {
			faces.push_back({first + static_cast<std::uint32_t>(i)});
		}
	}
	if (wrongCount > 0) {
		status = refusalOf(arrangement, StatusCode::NestedComponents, operand, std::move(faces));
		status.count = wrongCount;
	}
	return status;
}

}  // namespace index_boolean
