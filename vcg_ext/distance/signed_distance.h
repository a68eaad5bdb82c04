// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a surface, once; then points, as often as wanted; out: for each its signed distance, the
// nearest point and face, and the gradient of the distance: the surface as an implicit function.
// Guarantee: negative inside. The sign of a closed surface is exact: the winding number's, and 0 on
// the surface, for all finite points. Distances err by less than errorBound. What is found does not
// depend on the numbering of vertices and faces, nor on threads, nor on the other points. Questions
// may be asked from several threads at once.
//
// A sign is passed on from point to point: the ball around a point with its distance as radius
// holds no surface, so all in it are on one side. One line a ball that touches no other decides.
#pragma once

#include "vcg_ext/distance/face_tree.h"
#include "vcg_ext/distance/inside_test.h"
#include "vcg_ext/distance/pseudonormals.h"
#include "vcg_ext/distance/reference.h"

#include <limits>

namespace index_boolean {

// What is known of one point.
struct DistanceSample {
	// NaN beyond the maximum, and for a point that is not finite. Never 0 but on the surface.
	double distance = std::numeric_limits<double>::quiet_NaN();
	int sign = 0;                // -1 inside, 0 on the surface, +1 outside, or without signs; known
	                             // beyond the maximum, too
	std::uint32_t face = kNone;  // the nearest one as given; kNone where the distance is NaN
	Point closest{};             // its nearest point; NaN there
	Point gradient{};  // of length 1, towards larger values; NaN there. On the surface, and as near
	                   // to it as the bound on errors, the surface's own direction there
};

struct DistanceOptions {
	double maximum = std::numeric_limits<double>::infinity();  // farther: NaN
	bool negate = false;  // values and gradient: positive inside
};

// The points that are asked for, and where what is found goes: as many samples, in their order.
struct DistanceQuery {
	const Point* points = nullptr;
	std::size_t count = 0;
	DistanceSample* samples = nullptr;
};

class SignedDistance {
public:
	// Takes a surface, and builds its tree. \param threads 0: as many as there are
	// \return Ok, Cancelled, OutOfMemory; EmptyOperand if it has no faces
	// Complexity: O(n log n), in parallel. Some 300 bytes a face.
	Status build(Reference reference, int threads, Monitor& monitor);

	// What is known of one point, any. From any thread. Complexity: as FaceTree::nearest, and as
	// windingAround where the sign is wanted of a closed surface.
	DistanceSample at(const Point& point, const DistanceOptions& options) const;

	// The same of many points, in parallel.
	// \return Ok, Cancelled, OutOfMemory. Complexity: of that; neighbours share what they know.
	Status sample(const DistanceQuery& query, const DistanceOptions& options, int threads,
	              Monitor& monitor) const;

	// No distance of this size is farther from the true one.
	double errorBound(double distance) const;

	const Reference& reference() const { return reference_; }

private:
	struct Trail;

	DistanceSample sampleAt(const Point& point, const DistanceOptions& options, Trail& trail) const;
	int signAt(const Point& point, const NearestInFace& nearest, const NearFace& near,
	           double distance, Trail& trail) const;
	int sideOfFeature(const Point& point, const NearestInFace& nearest, const NearFace& near) const;
	int windingSign(const Point& point) const;
	Point closestPoint(const Point& scaled, const NearestInFace& nearest,
	                   const FeatureVertices& feature) const;
	FeatureVertices verticesOf(std::uint32_t face, Feature feature) const;
	SearchedFaces searched() const {
		return {reference_.points, reference_.triangles, tree_, box_};
	}

	Reference reference_;
	FaceTree tree_;
	BoundingBox box_{};
};

}  // namespace index_boolean
