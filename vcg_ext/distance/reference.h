// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface that distances are measured to, as the driver's prepareReference makes it.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

#include <vector>

namespace index_boolean {

// A welded surface without zero-area faces.
struct Reference {
	Points points;  // finite
	IndexTriangles triangles;
	std::vector<std::uint32_t> faceGiven;  // per face: the face as given that it is, or a piece of
	// What is inside is known: the surface is closed. Else the side of the nearest feature decides.
	bool isClosed = false;
	bool isSigned = true;                     // else distances have no sign
	WindingRule rule = WindingRule::Nonzero;  // what is inside, of a closed one
	// What was found.
	bool isResolved = false;           // the boundary of what the rule calls inside, not all faces
	bool wasInsideOut = false;         // all of it was turned
	std::size_t selfIntersecting = 0;  // faces that meet others wrongly
	double volume = 0;                 // that is inside, if it is closed
	std::vector<StageTime> stageTimes;
};

}  // namespace index_boolean
