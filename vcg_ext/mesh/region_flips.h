// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces of regions near planes, some of which are new; out: the same vertices and borders with
// constrained Delaunay triangles in each of these regions, as seen along its plane's axis.
// Guarantee: as DelaunayFlips, by the places; no edge comes to be where another one is.
#pragma once

#include "vcg_ext/mesh/plane_regions.h"

namespace index_boolean {

// A face of a region, and the face of the surface that it is or stands for.
struct RegionFace {
	IndexTriangle corners;
	std::uint32_t region, origin;
};

// Which regions' edges are flipped. Borrows all.
struct RegionFlips {
	const ClassedSurface& surface;
	const PlaneRegions& regions;
	const std::vector<std::uint8_t>& isWanted;  // per region of several faces
	const std::vector<std::uint8_t>& isKept;    // per face of the surface: its edges stay
};

// Flips edges between faces of each wanted region until none wants to.
// \param isAlive per face, not 0: it counts
// \param faces   those of these regions and all that may have an edge in common with them; changed
//                in place: of two faces that a flip replaces, both origins stay
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: that of sorting the faces' sides, and of DelaunayFlips.
Status flipRegions(const RegionFlips& flips, const std::vector<std::uint8_t>& isAlive,
                   Monitor& monitor, std::vector<RegionFace>& faces);

}  // namespace index_boolean
