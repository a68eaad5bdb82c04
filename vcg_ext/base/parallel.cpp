// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a number of chunks and a function for one; out: all chunks run. Threads take chunks from one
// counter, so that an expensive chunk holds up nobody else.
#include "vcg_ext/base/parallel.h"

#include "vcg_ext/base/helper_threads.h"
#include "vcg_ext/base/process.h"

#include <atomic>
#include <exception>
#include <new>

namespace index_boolean {

namespace {

// Whether this thread has a guard of its floating-point environment already.
thread_local bool guarded = false;

// Whether this thread helps another one, which called runChunks.
thread_local bool helping = false;

// What the threads of one region share.
struct Run {
	std::size_t chunks;
	Monitor& monitor;
	void* context;
	void (*run)(void*, std::size_t);
	std::atomic<std::size_t> next{0};
	std::atomic<std::size_t> finished{0};
	std::atomic<bool> outOfMemory{false};
	std::atomic<bool> threw{false};

	bool stopped() const { return monitor.cancelled() || outOfMemory.load() || threw.load(); }
};

void runOneChunk(Run& run, std::size_t chunk) {
	try {
		run.run(run.context, chunk);
	} catch (const std::bad_alloc&) {
		run.outOfMemory = true;
	} catch (...) {
		run.threw = true;
	}
}

// Takes chunks until none is left or the run stops. One call per thread.
void work(Run& run) {
	const FpEnvironmentGuard environment;
	while (!run.stopped() && !(helping && areHelpersToLeave())) {
		const std::size_t chunk = run.next.fetch_add(1, std::memory_order_relaxed);
		if (chunk >= run.chunks) {
			return;
		}
		runOneChunk(run, chunk);
		const std::size_t finished = run.finished.fetch_add(1, std::memory_order_relaxed) + 1;
		if (!helping) {
			run.monitor.report(static_cast<double>(finished) / static_cast<double>(run.chunks));
		}
	}
}

// Thread functions of workWithHelpers.
void workOn(void* run) { work(*static_cast<Run*>(run)); }

void helpWith(void* run) {
	helping = true;
	work(*static_cast<Run*>(run));
	helping = false;
}

}  // namespace

FpEnvironmentGuard::FpEnvironmentGuard() : isOutermost_(!guarded) {
	if (isOutermost_) {
		saved_.save();
		FpEnvironment::setDefault();
		guarded = true;
	}
}

FpEnvironmentGuard::~FpEnvironmentGuard() {
	if (isOutermost_) {
		saved_.restore();
		guarded = false;
	}
}

int mostWorkers(int threads) { return threads > 0 ? threads : availableThreads(); }

bool pollCancelled(Monitor& monitor) {
	if (!helping) {
		monitor.report(0);
	}
	return monitor.cancelled();
}

Status runChunks(std::size_t chunks, int threads, Monitor& monitor, void* context,
                 void (*run)(void* context, std::size_t chunk)) {
	Run state{chunks, monitor, context, run};
	const int wanted = mostWorkers(threads);
	if (chunks <= 1 || wanted == 1) {
		work(state);
	} else {
		const std::size_t workers = std::min(chunks, static_cast<std::size_t>(wanted));
		workWithHelpers(static_cast<int>(workers) - 1, &state, workOn, helpWith);
	}
	Status status;
	if (state.threw) {
		status.code = StatusCode::InternalError;
	} else if (state.outOfMemory) {
		status.code = StatusCode::OutOfMemory;
	} else if (monitor.cancelled()) {
		status.code = StatusCode::Cancelled;
	}
	return status;
}

}  // namespace index_boolean
