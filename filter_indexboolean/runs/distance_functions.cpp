// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points are asked in portions, so that what is kept for them does not grow with their number.
#include "runs/distance_functions.h"

#include "runs/stopwatch.h"

#include <vcg_ext/index_boolean.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

using namespace index_boolean;

namespace {

struct Handle {
	SignedDistance distance;
	int threads;
};

void copyMessage(const std::string& text, char* message, std::int64_t size) {
	if (size > 0) {
		const std::size_t length = std::min(text.size(), static_cast<std::size_t>(size) - 1);
		std::memcpy(message, text.data(), length);
		message[length] = 0;
	}
}

void copyPoint(const Point& point, double* to) { std::copy(point.begin(), point.end(), to); }

// Writes one sample as the i-th.
void write(const DistanceSample& sample, std::size_t i, const IndexBooleanDistances& out) {
	if (out.distance != nullptr) {
		out.distance[i] = sample.distance;
	}
	if (out.gradient != nullptr) {
		copyPoint(sample.gradient, out.gradient + 3 * i);
	}
	if (out.face != nullptr) {
		out.face[i] = sample.face == kNone ? -1 : static_cast<std::int64_t>(sample.face);
	}
	if (out.closest != nullptr) {
		copyPoint(sample.closest, out.closest + 3 * i);
	}
	if (out.sign != nullptr) {
		out.sign[i] = static_cast<std::int8_t>(sample.sign);
	}
}

Points pointsOf(const double* coordinates, std::size_t count) {
	Points points;
	points.reserve(count);
	for (std::size_t i = 0; i < count; ++i) {
		points.push_back({coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]});
	}
	return points;
}

// One operand of the surface's arrays. An index that is negative names no point, like one that is
// too large.
Status arraysOf(const IndexBooleanSurface& surface, Monitor& monitor, MeshArrays& out) {
	const auto count = static_cast<std::size_t>(surface.triangleCount);
	const Points points = pointsOf(surface.points, static_cast<std::size_t>(surface.pointCount));
	IndexTriangles triangles;
	triangles.reserve(count);
	for (std::size_t i = 0; i < count; ++i) {
		const std::int32_t* t = surface.triangles + 3 * i;
		triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
		                     static_cast<std::uint32_t>(t[2])});
	}
	return joinSurfaces({viewOf(points, triangles)}, surface.threads, monitor, out);
}

Status make(const IndexBooleanSurface& surface, Handle& handle) {
	Options options;
	options.selfIntersections = static_cast<SelfIntersections>(surface.selfIntersections);
	options.windingRule = static_cast<WindingRule>(surface.windingRule);
	options.threads = surface.threads;
	Monitor monitor;
	MeshArrays arrays;
	Reference reference;
	return inOrder(
	    [&] { return arraysOf(surface, monitor, arrays); },
	    [&] {
		    return prepareReference(std::move(arrays), options, surface.isSigned != 0, monitor,
		                            reference);
	    },
	    [&] { return handle.distance.build(std::move(reference), surface.threads, monitor); });
}

}  // namespace

void* indexBooleanDistanceNew(const IndexBooleanSurface* surface, IndexBooleanSurfaceReport* report,
                              char* message, std::int64_t size) {
	try {
		const Stopwatch time;
		auto handle = std::make_unique<Handle>();
		handle->threads = surface->threads;
		const Status status = make(*surface, *handle);
		if (!status.ok()) {
			copyMessage(describe(status), message, size);
			return nullptr;
		}
		const Reference& reference = handle->distance.reference();
		report->isClosed = reference.isClosed ? 1 : 0;
		report->isResolved = reference.isResolved ? 1 : 0;
		report->wasInsideOut = reference.wasInsideOut ? 1 : 0;
		report->selfIntersectingFaces = static_cast<std::int64_t>(reference.selfIntersecting);
		report->volume = reference.volume;
		report->longestEdgeError = handle->distance.errorBound(0);
		report->seconds = time.seconds();
		return handle.release();
	} catch (...) {  // memory alone can run out here
		copyMessage(describe(statusOf(StatusCode::OutOfMemory)), message, size);
		return nullptr;
	}
}

std::int32_t indexBooleanDistanceSample(const void* handle, const double* points,
                                        std::int64_t count, double maximum, std::int32_t negate,
                                        const IndexBooleanDistances* out) {
	constexpr std::size_t kPortion = std::size_t{1} << 20;
	try {
		const Handle& of = *static_cast<const Handle*>(handle);
		DistanceOptions options;
		options.maximum = maximum;
		options.negate = negate != 0;
		std::vector<DistanceSample> samples;
		const auto all = static_cast<std::size_t>(count);
		for (std::size_t begin = 0; begin < all; begin += kPortion) {
			const std::size_t few = std::min(kPortion, all - begin);
			const Points some = pointsOf(points + 3 * begin, few);
			samples.assign(few, {});
			Monitor monitor;
			const Status status = of.distance.sample({some.data(), few, samples.data()}, options,
			                                         of.threads, monitor);
			if (!status.ok()) {
				return 1;
			}
			for (std::size_t i = 0; i < few; ++i) {
				write(samples[i], begin + i, *out);
			}
		}
		return 0;
	} catch (...) {
		return 1;
	}
}

void indexBooleanDistanceFree(void* handle) { delete static_cast<Handle*>(handle); }
