// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: n items and a body for a range of them; out: the body run over fixed chunks on all threads.
// Guarantee: the chunks depend on n and grain only, never on the threads; no exception leaves the
// parallel region; a cancelled run skips what is left; every thread computes in the default
// floating-point environment (round to nearest, no flush to zero), whatever the host has set.
#pragma once

#include "vcg_ext/base/fp_environment.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace index_boolean {

// Sets this thread's floating-point environment to the default while it lives, then restores it.
// Within another guard of the thread it does nothing: setting costs as much as a small stage. What
// could change the environment meanwhile is the host's callback alone, and Monitor undoes that.
class FpEnvironmentGuard {
public:
	FpEnvironmentGuard();
	~FpEnvironmentGuard();
	FpEnvironmentGuard(const FpEnvironmentGuard&) = delete;
	FpEnvironmentGuard& operator=(const FpEnvironmentGuard&) = delete;

private:
	bool isOutermost_;
	FpEnvironment saved_;
};

// How many chunks of `grain` items (at least 1) cover n items.
constexpr std::size_t chunkCount(std::size_t n, std::size_t grain) {
	return n / grain + (n % grain == 0 ? 0 : 1);
}

// Threads for two tasks of about half of `work` items each: one where waking another costs more
// than it saves.
constexpr int threadsForHalves(std::size_t work, int threads) {
	return work < (std::size_t{1} << 15) ? 1 : threads;
}

// How many threads at most work on chunks if `threads` are asked for (0: as many as there are).
// For memory alone: results never depend on it. Complexity: O(1).
int mostWorkers(int threads);

// Calls run(context, chunk) once for each chunk in [0, chunks); see parallelForChunks.
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: that of the chunks.
Status runChunks(std::size_t chunks, int threads, Monitor& monitor, void* context,
                 void (*run)(void* context, std::size_t chunk));

// For long work inside a chunk: lets the monitor call back if this is the thread that started the
// run. \return true if the work should stop (the run is cancelled). From any thread.
// Complexity: O(1).
bool pollCancelled(Monitor& monitor);

// Calls body(chunk, begin, end) once for each of the chunkCount(n, grain) chunks, in any order and
// on several threads; chunk k holds the items from k * grain on. Opens no parallel region for one
// chunk or one thread. Reports the share of finished chunks. Not to be called from inside a body.
// \param grain   items of a chunk, at least 1
// \param threads 0: as many as there are
// \return Ok, Cancelled, OutOfMemory (the body ran out of memory) or InternalError (it threw
//         something else). Unless Ok, some chunks may not have run.
template <class Body>
Status parallelForChunks(std::size_t n, std::size_t grain, int threads, Monitor& monitor,
                         Body&& body) {
	const auto runOne = [&body, n, grain](std::size_t chunk) {
		const std::size_t begin = chunk * grain;
		body(chunk, begin, begin + std::min(grain, n - begin));
	};
	using RunOne = decltype(runOne);
	const auto run = [](void* context, std::size_t chunk) {
		(*static_cast<RunOne*>(context))(chunk);
	};
	void* context = const_cast<void*>(static_cast<const void*>(std::addressof(runOne)));
	return runChunks(chunkCount(n, grain), threads, monitor, context, run);
}

// The same for a body(begin, end) that need not know its chunk.
template <class Body>
Status parallelFor(std::size_t n, std::size_t grain, int threads, Monitor& monitor, Body&& body) {
	return parallelForChunks(
	    n, grain, threads, monitor,
	    [&body](std::size_t, std::size_t begin, std::size_t end) { body(begin, end); });
}

// Calls body(begin, end) for the same chunks one after another on this thread, for work whose order
// matters, and polls between them. \return Ok or Cancelled; what the body throws leaves it.
template <class Body>
Status inOrderFor(std::size_t n, std::size_t grain, Monitor& monitor, Body&& body) {
	Status status;
	for (std::size_t begin = 0; begin < n && status.ok(); begin += grain) {
		body(begin, begin + std::min(grain, n - begin));
		if (pollCancelled(monitor)) {
			status.code = StatusCode::Cancelled;
		}
	}
	return status;
}

}  // namespace index_boolean
