// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the boxes of the faces near the other operand; out: the wide fans, which are the vertices of
// both operands at which so many faces of each meet that their pairs, d^2 of d faces, are too many
// to be looked at. Also: boxes of the directions in which such faces leave their vertex.
// Guarantee: two faces at one vertex whose directions have boxes apart meet in this vertex only.
#pragma once

#include "vcg_ext/arrange/face_boxes.h"
#include "vcg_ext/arrange/face_pair.h"
#include "vcg_ext/base/ids.h"
#include "vcg_ext/mesh/mesh_arrays.h"

#include <vector>

namespace index_boolean {

// The faces of both operands at a common vertex, in the order of their boxes.
struct CommonFan {
	VertexId vertex;
	PerOperand<std::vector<FaceId>> faces;
};

// All wide fans. Borrows the arrays.
class CommonFans {
public:
	// \param boxes the faces that count; all others are left aside
	// Complexity: O(m) for m boxes, and O(n) for n vertices of the first operand if any is one of
	// the second too. Throws std::bad_alloc.
	CommonFans(const MeshArrays& mesh, const FaceBoxes& boxes);

	bool empty() const { return fans_.empty(); }
	const std::vector<CommonFan>& fans() const { return fans_; }

	// The index of the fan at a vertex, or kNone.
	std::uint32_t fanAt(VertexId vertex) const {
		return vertex.value < fanOfVertex_.size() ? at(fanOfVertex_, vertex) : kNone;
	}

	// Calls visit(fan) for each fan that a face belongs to.
	template <class Visit>
	void forEachFan(FaceId face, Visit&& visit) const {
		for (const VertexId v : at(mesh_.triangles, face)) {
			if (fanAt(v) != kNone) {
				visit(fanAt(v));
			}
		}
	}

	// Whether a face is of a fan.
	bool has(std::uint32_t fan, FaceId face) const {
		const Triangle& t = at(mesh_.triangles, face);
		const VertexId v = fans_[fan].vertex;
		return t[0] == v || t[1] == v || t[2] == v;
	}

	// Whether both faces belong to one fan.
	bool share(FacePair pair) const {
		bool any = false;
		forEachFan(pair.a, [&](std::uint32_t fan) { any |= has(fan, pair.b); });
		return any;
	}

private:
	const MeshArrays& mesh_;
	std::vector<CommonFan> fans_;
	std::vector<std::uint32_t> fanOfVertex_;  // per vertex of the first operand
};

// The boxes of an operand's faces in a fan as seen from its vertex, each of the arc that the
// directions to the face's other two corners bound on the unit sphere.
// Complexity: O(d) for d faces.
constexpr float kDirectionsHalfSize = 2;  // of the cube that holds the boxes
HugeVector<FaceBox> boxesOfDirections(const MeshArrays& mesh, const CommonFan& fan,
                                      OperandId operand);

}  // namespace index_boolean
