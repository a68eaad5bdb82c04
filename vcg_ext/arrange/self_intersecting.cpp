// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of one face have one index as given, so faces are made unique by that.
#include "vcg_ext/arrange/self_intersecting.h"

#include <algorithm>

namespace index_boolean {

Status selfIntersecting(const Arrangement& arrangement, OperandId operand,
                        const std::vector<FaceId>& faces, const Point& place) {
	Status status;
	status.code = StatusCode::SelfIntersecting;
	status.operand = numberOf(operand);
	status.hasPlace = true;
	status.place = place;
	for (const FaceId face : faces) {
		status.faces.push_back(arrangement.givenFace(face));
	}
	std::sort(status.faces.begin(), status.faces.end());
	status.faces.erase(std::unique(status.faces.begin(), status.faces.end()), status.faces.end());
	status.count = status.faces.size();
	return status;
}

}  // namespace index_boolean
