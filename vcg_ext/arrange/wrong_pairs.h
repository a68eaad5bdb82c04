// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of one surface; out: all pairs of them that meet wrongly, and the zero-area faces.
// Two faces meet wrongly if they have a point in common that is neither a common vertex nor on a
// common edge of both: faces that cross, touch, lie on one another from a common edge on, or have
// the same three corners. Zero-area faces are listed as such and take no part in pairs.
// Guarantee: decided by exact signs, for every two faces, at any magnitude; no other number decides
// anything. What is found does not depend on threads, nor on how vertices, faces and corners are
// ordered. Surfaces may be open, not orientable, no manifold.
#pragma once

#include "vcg_ext/arrange/faces_view.h"
#include "vcg_ext/arrange/pair_judge.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <vector>

namespace index_boolean {

// How to search.
struct WrongPairOptions {
	int threads = 0;          // 0: as many as there are
	bool isBalanced = false;  // the caller knows that each edge has as many faces each way
	// Per face, not 0: suspect. Only pairs with a suspect face are found, and suspect zero-area
	// faces: of a surface of which all other pairs are known. Null: all are suspect.
	const std::vector<std::uint8_t>* isSuspect = nullptr;
};

// What has been found, by the indices of faces.
struct WrongPairs {
	std::vector<FacePair> pairs;               // a < b; sorted by a, then by b; each once
	std::vector<std::uint32_t> zeroAreaFaces;  // ascending
};

// The faces that are in a pair or have no area, ascending. Throws std::bad_alloc.
// Complexity: O(k log k) for k of them.
std::vector<std::uint32_t> facesConcerned(const WrongPairs& found);

// Finds all pairs of faces that meet wrongly, and all zero-area faces.
// \param faces borrowed; finite, and welded: vertices in one place have one index. (Two that have
// not are two vertices, and faces that meet there do so wrongly.)
// \param out   replaced
// \return Ok, Cancelled, OutOfMemory; InternalError if exact signs contradict each other
// Complexity: O(n + p) for n faces and p pairs of faces with boxes that meet and no certified star
// in common, in parallel; O(n) memory, about 100 bytes a face, and what is found.
Status findWrongPairs(const FacesView& faces, const WrongPairOptions& options, Monitor& monitor,
                      WrongPairs& out);

// The same for a surface with few suspect faces. It need not be welded.
// \pre options.isSuspect is not null
// \return as above. Complexity: one pass over the faces; then as above, for the suspect faces and
// those near them.
Status findWrongPairsNearSuspects(const FacesView& faces, const WrongPairOptions& options,
                                  Monitor& monitor, WrongPairs& out);

// Hands all pairs of faces that meet wrongly to a taker, as they are found, for whom a list may be
// too long: a tangle of n faces may have n^2 of them.
// \param taker     called on several threads, with a pair once or twice
// \param zeroAreaFaces replaced; ascending
// \return, Complexity: as findWrongPairs
Status visitWrongPairs(const FacesView& faces, const WrongPairOptions& options, Monitor& monitor,
                       WrongPairTaker& taker, std::vector<std::uint32_t>& zeroAreaFaces);

}  // namespace index_boolean
