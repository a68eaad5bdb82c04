// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a number of chunks and a function for one; out: all chunks run. Threads take chunks from one
// counter, so that an expensive chunk holds up nobody else. Works the same without OpenMP.
#include "vcg_ext/base/parallel.h"

#include <atomic>
#include <exception>
#include <new>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace index_boolean {

namespace {

// Whether this thread has a guard of its floating-point environment already.
thread_local bool guarded = false;

int maxThreads() {
#ifdef _OPENMP
	return omp_get_max_threads();
#else
	return 1;
#endif
}

// Whether this thread helps another one, which called runChunks. That one may have any number in a
// team of the host's own, so what tells is that a region of ours has been entered as a helper.
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
	while (!run.stopped()) {
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

#ifdef _OPENMP
void help(Run& run) {
	const bool outer = helping;
	helping = true;
	work(run);
	helping = outer;
}

// Thread 0 of a region is the thread that opened it.
void workTogether(Run& run, int team) {
#pragma omp parallel num_threads(team) default(none) shared(run)
	if (omp_get_thread_num() == 0) {
		work(run);
	} else {
		help(run);
	}
}
#else
void workTogether(Run& run, int) { work(run); }
#endif

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

int mostWorkers(int threads) { return threads > 0 ? threads : maxThreads(); }

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
		workTogether(state, static_cast<int>(std::min(chunks, static_cast<std::size_t>(wanted))));
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
