// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions that the plugin's library exports, for callers without a document, such as Python's
// ctypes: a surface as arrays in, a handle out; points in, distances out. Guarantee: no exception
// leaves them; a handle may be asked from several threads at once.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(_WIN32)
#define INDEXBOOLEAN_EXPORT __declspec(dllexport)
#else
#define INDEXBOOLEAN_EXPORT __attribute__((visibility("default")))
#endif

extern "C" {

// What a surface is made of, and how it is read.
struct IndexBooleanSurface {
	const double* points;  // 3 each
	std::int64_t pointCount;
	const std::int32_t* triangles;  // 3 indices of points each
	std::int64_t triangleCount;
	std::int32_t isSigned;           // 0: distances have no sign
	std::int32_t selfIntersections;  // 0 resolve, 1 trust, 2 refuse
	std::int32_t windingRule;        // 0 nonzero, 1 positive, 2 odd
	std::int32_t threads;            // 0: as many as there are
};

// What was found of it.
struct IndexBooleanSurfaceReport {
	std::int32_t isClosed, isResolved, wasInsideOut;
	std::int64_t selfIntersectingFaces;
	double volume;            // that is inside; 0 if it is open
	double seconds;           // that preparing it and building its tree took
	double longestEdgeError;  // the bound on the error of a distance of 0; that of another distance
	                          // is 2^-45 of it more
};

// Where the results go: for each point one value, or three; null where they are not wanted.
struct IndexBooleanDistances {
	double* distance;
	double* gradient;    // 3 each
	std::int64_t* face;  // the nearest one; -1: none
	double* closest;     // 3 each
	std::int8_t* sign;   // -1 inside, 0 on the surface, 1 outside
};

// Makes a handle, which indexBooleanDistanceFree ends; null if the surface cannot be used.
// \param report  filled if there is a handle
// \param message of `size` bytes: if there is none, why, as a sentence's end; cut off as needed
// Complexity: as prepareReference and SignedDistance::build.
INDEXBOOLEAN_EXPORT void* indexBooleanDistanceNew(const IndexBooleanSurface* surface,
                                                  IndexBooleanSurfaceReport* report, char* message,
                                                  std::int64_t size);

// Asks for the distances of points, 3 coordinates each.
// \param maximum farther: not a number \param negate not 0: positive inside
// \return 0; 1 if memory ran out
// Complexity: as SignedDistance::sample.
INDEXBOOLEAN_EXPORT std::int32_t
indexBooleanDistanceSample(const void* handle, const double* points, std::int64_t count,
                           double maximum, std::int32_t negate, const IndexBooleanDistances* out);

// Ends a handle; null is allowed. Complexity: O(1).
INDEXBOOLEAN_EXPORT void indexBooleanDistanceFree(void* handle);
}
