// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A layer as what is measured, and as what distances are measured to; and back: what was measured
// as qualities, attributes, colours, normals and selection of the layer itself.
#pragma once

#include "layers/layers.h"
#include "runs/distance_run.h"
#include "runs/progress.h"

#include <vcg_ext/mesh/mesh_arrays_vcg.h>

#include <host_document.h>

namespace index_boolean {

// One layer's arrays, with its matrix applied, and which elements of it theirs are.
struct MeasuredLayer {
	MeshModel* layer = nullptr;
	MeshArrays arrays;
	OperandElements elements;
};

// Reads a layer, which is not changed. \return Ok, Cancelled, OutOfMemory, TooLarge
// Complexity: O(n), in parallel.
Status readMeasured(MeshModel& layer, Progress& progress, double share, MeasuredLayer& out);

// The points that are measured of a layer: its vertices, then the centres of its faces, as far as
// they are asked for. Throws std::bad_alloc. Complexity: O(n).
Points pointsToMeasure(const MeasuredLayer& read, bool atVertices, bool atFaces);

// What is written, and from what.
struct DistanceWriting {
	const std::vector<DistanceSample>* samples = nullptr;  // of pointsToMeasure
	bool atVertices = true, atFaces = true;
	double maximum = 0;   // the quality of what is farther away
	bool negate = false;  // its sign is turned
	bool direction = false, closest = false, color = false;
	bool normals = false, selectInside = false;  // of vertices
	double colorRange = 0;  // colours are from minus this to this, or, unsigned, from 0
	// Of the elements of the layer that distances are measured to, the faces.
	const LiveElements* closestFaces = nullptr;
};

// Makes room in the layer, then writes; in the document's own scalar. Attributes of the same names
// are replaced, whatever their type. What is not asked for is left as it is.
// \return Ok or OutOfMemory: then some attributes may be lacking. Complexity: O(n).
Status writeDistances(const DistanceWriting& writing, const MeasuredLayer& read);

}  // namespace index_boolean
