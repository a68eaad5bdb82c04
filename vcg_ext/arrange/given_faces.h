// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces and vertices as the operands were given, before anything was welded, dropped or split: what
// the caller's attributes belong to.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

#include <functional>

namespace index_boolean {

// A face of an operand, by its number as given.
struct GivenFace {
	OperandId operand;
	std::uint32_t index;

	friend bool operator==(GivenFace a, GivenFace b) {
		return a.operand == b.operand && a.index == b.index;
	}
};

// The corners of a face as given: vertices in the numbering of the arrays that were given. Called
// from several threads.
using GivenTriangles = std::function<Triangle(GivenFace)>;

// The given face that an arrangement's face is or is a piece of.
inline GivenFace givenFaceOf(const Arrangement& arrangement, FaceId face) {
	return {arrangement.mesh.operandOf(face), arrangement.givenFace(face)};
}

}  // namespace index_boolean
