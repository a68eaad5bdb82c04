// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two faces that may meet.
#pragma once

#include "vcg_ext/base/ids.h"

namespace index_boolean {

// A face of operand 0 and a face of operand 1, or two faces a < b of one surface.
struct FacePair {
	FaceId a, b;

	friend bool operator==(const FacePair& p, const FacePair& q) {
		return p.a == q.a && p.b == q.b;
	}
};

}  // namespace index_boolean
