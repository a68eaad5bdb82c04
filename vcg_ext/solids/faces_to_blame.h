// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of an operand that a refusal is about; out: the status that names them.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/status.h"

#include <algorithm>
#include <vector>

namespace index_boolean {

// A refusal of an operand. \param faces of the operand, in any order, repeated or not; at the first
// corner of the first of them is the status's place, and if there is none it has no place
// Complexity: O(k log k) for k faces.
inline Status refusalOf(const Arrangement& arrangement, StatusCode code, OperandId operand,
                        std::vector<FaceId> faces) {
	Status status;
	status.code = code;
	status.operand = numberOf(operand);
	std::sort(faces.begin(), faces.end());
	faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
	for (const FaceId face : faces) {
		status.faces.push_back(arrangement.givenFace(face));
	}
	status.count = status.faces.size();
	if (!faces.empty()) {
		status.hasPlace = true;
		status.place = at(arrangement.mesh.points, at(arrangement.mesh.triangles, faces[0])[0]);
	}
	return status;
}

}  // namespace index_boolean
