// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parallel loops: what runs, what stops them, what comes out, in which floating-point environment.
#include "core/fp_environment.h"

#include <vcg_ext/base/parallel.h>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <limits>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <vector>

using namespace index_boolean;

namespace {

using Chunk = std::tuple<std::size_t, std::size_t, std::size_t>;

// The chunks that a loop runs, sorted.
std::multiset<Chunk> chunksOf(std::size_t n, std::size_t grain, int threads) {
	Monitor monitor;
	std::mutex mutex;
	std::multiset<Chunk> chunks;
	const Status status = parallelForChunks(
	    n, grain, threads, monitor, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    const std::lock_guard<std::mutex> lock(mutex);
		    chunks.emplace(chunk, begin, end);
	    });
	EXPECT_TRUE(status.ok());
	return chunks;
}

}  // namespace

TEST(Parallel, everyItemIsVisitedOnce) {
	for (const std::size_t n : {0u, 1u, 2u, 7u, 8u, 9u, 1000u}) {
		for (const std::size_t grain : {1u, 3u, 8u, 2000u}) {
			for (const int threads : {0, 1, 2, 8}) {
				Monitor monitor;
				std::vector<std::atomic<int>> visits(n);
				const Status status = parallelFor(n, grain, threads, monitor,
				                                  [&](std::size_t begin, std::size_t end) {
					                                  for (std::size_t i = begin; i < end; ++i) {
						                                  ++visits[i];
					                                  }
				                                  });
				EXPECT_TRUE(status.ok());
				for (std::size_t i = 0; i < n; ++i) {
					EXPECT_EQ(visits[i], 1) << i << " of " << n << " by " << grain;
				}
			}
		}
	}
}

TEST(Parallel, chunksDependOnTheGrainOnly) {
	const std::multiset<Chunk> expected = {{0, 0, 4}, {1, 4, 8}, {2, 8, 10}};
	for (const int threads : {0, 1, 2, 3, 8}) {
		EXPECT_EQ(chunksOf(10, 4, threads), expected) << threads;
	}
	EXPECT_EQ(chunkCount(10, 4), 3U);
	EXPECT_EQ(chunkCount(8, 4), 2U);
	EXPECT_EQ(chunkCount(0, 4), 0U);
	EXPECT_EQ(chunkCount(std::numeric_limits<std::size_t>::max(), 2), std::size_t{1} << 63);
}

TEST(Parallel, oneChunkOrOneThreadCallsNobody) {
	for (const auto& [n, threads] : {std::pair{8, 4}, {100, 1}}) {
		Monitor monitor;
		const Status status =
		    parallelFor(static_cast<std::size_t>(n), 8, threads, monitor,
		                [caller = std::this_thread::get_id()](std::size_t, std::size_t) {
			                EXPECT_EQ(std::this_thread::get_id(), caller);
		                });
		EXPECT_TRUE(status.ok());
	}
}

TEST(Parallel, runningOutOfMemoryBecomesAStatus) {
	for (const int threads : {1, 4}) {
		Monitor monitor;
		const Status status =
		    parallelFor(100, 1, threads, monitor, [](std::size_t begin, std::size_t) {
			    if (begin == 40) {
				    throw std::bad_alloc();
			    }
		    });
		EXPECT_EQ(status.code, StatusCode::OutOfMemory);
	}
}

TEST(Parallel, otherExceptionsBecomeAnInternalError) {
	for (const int threads : {1, 4}) {
		Monitor monitor;
		const Status status =
		    parallelFor(100, 1, threads, monitor, [](std::size_t begin, std::size_t) {
			    if (begin == 40) {
				    throw std::runtime_error("thrown by a test");
			    }
		    });
		EXPECT_EQ(status.code, StatusCode::InternalError);
	}
}

TEST(Parallel, chunksAfterAFailureAreSkipped) {
	for (const bool outOfMemory : {false, true}) {
		Monitor monitor;
		std::size_t last = 0;
		const Status status = parallelFor(100, 1, 1, monitor, [&](std::size_t begin, std::size_t) {
			last = begin;
			if (begin == 40 && outOfMemory) {
				throw std::bad_alloc();
			}
			if (begin == 40) {
				throw std::runtime_error("thrown by a test");
			}
		});
		EXPECT_EQ(status.code, outOfMemory ? StatusCode::OutOfMemory : StatusCode::InternalError);
		EXPECT_EQ(last, 40U);
	}
}

TEST(Parallel, cancelSkipsTheRemainingChunks) {
	for (const int threads : {1, 4}) {
		Monitor monitor([](double fraction, const char*) { return fraction == 0; });
		monitor.beginStage("test", 0, 1);
		std::atomic<int> runs{0};
		const Status status =
		    parallelFor(1000, 1, threads, monitor, [&runs](std::size_t, std::size_t) {
			    ++runs;
			    std::this_thread::sleep_for(std::chrono::milliseconds(1));
		    });
		EXPECT_EQ(status.code, StatusCode::Cancelled);
		EXPECT_LT(runs, 500);
	}
}

TEST(Parallel, cancelledRunStartsNothing) {
	Monitor monitor([](double, const char*) { return false; });
	monitor.beginStage("test", 0, 1);
	for (const int threads : {1, 4}) {
		std::atomic<int> runs{0};
		const Status status =
		    parallelFor(10, 1, threads, monitor, [&runs](std::size_t, std::size_t) { ++runs; });
		EXPECT_EQ(status.code, StatusCode::Cancelled);
		EXPECT_EQ(runs, 0);
	}
}

TEST(Parallel, callbackIsCalledOnTheCallingThreadOnly) {
	std::set<std::thread::id> callers;
	Monitor monitor([&callers](double, const char*) {
		callers.insert(std::this_thread::get_id());
		return true;
	});
	monitor.beginStage("test", 0, 1);
	const Status status = parallelFor(100, 1, 4, monitor, [&monitor](std::size_t, std::size_t) {
		std::this_thread::sleep_for(std::chrono::milliseconds(2));
		pollCancelled(monitor);
	});
	EXPECT_TRUE(status.ok());
	EXPECT_EQ(callers, std::set<std::thread::id>{std::this_thread::get_id()});
}

// A host may start runs from several threads of its own at once.
TEST(Parallel, anyThreadOfAHostIsAskedAboutItsOwnRun) {
	for (const int threads : {1, 4}) {
		std::array<StatusCode, 2> codes{StatusCode::Ok, StatusCode::Ok};
		std::array<std::atomic<int>, 2> calls{}, callsElsewhere{}, polls{};
		const auto runOne = [&](std::size_t host) {
			Monitor monitor([&, host, caller = std::this_thread::get_id()](double, const char*) {
				++calls[host];
				callsElsewhere[host] += std::this_thread::get_id() == caller ? 0 : 1;
				return calls[host] < 3;
			});
			const Status status =
			    parallelFor(200, 1, threads, monitor, [&](std::size_t, std::size_t) {
				    std::this_thread::sleep_for(std::chrono::milliseconds(2));
				    polls[host] += pollCancelled(monitor) ? 1 : 0;
			    });
			codes[host] = status.code;
		};
		std::thread first(runOne, 0), second(runOne, 1);
		first.join();
		second.join();
		for (const std::size_t host : {0U, 1U}) {
			EXPECT_EQ(codes[host], StatusCode::Cancelled) << host << ", " << threads << " threads";
			EXPECT_EQ(calls[host], 3);
			EXPECT_EQ(callsElsewhere[host], 0) << "the thread that started the run is asked";
			EXPECT_GT(polls[host], 0);
		}
	}
}

TEST(Parallel, finishedChunksAreReported) {
	double last = 0;
	int calls = 0;
	Monitor monitor([&](double fraction, const char*) {
		last = fraction;
		++calls;
		return true;
	});
	monitor.beginStage("test", 0.5, 0.75);
	const Status status = parallelFor(10, 1, 1, monitor, [](std::size_t, std::size_t) {
		std::this_thread::sleep_for(std::chrono::milliseconds(12));
	});
	EXPECT_TRUE(status.ok());
	EXPECT_EQ(calls, 11);
	EXPECT_DOUBLE_EQ(last, 0.75);
}

TEST(Parallel, pollHearsACancelInsideAChunk) {
	int calls = 0;
	Monitor monitor([&calls](double, const char*) { return ++calls < 3; });
	monitor.beginStage("test", 0, 1);
	int polls = 0;
	const Status status = parallelFor(1, 1, 0, monitor, [&](std::size_t, std::size_t) {
		for (; polls < 100 && !pollCancelled(monitor); ++polls) {
			std::this_thread::sleep_for(std::chrono::milliseconds(6));
		}
	});
	EXPECT_EQ(status.code, StatusCode::Cancelled);
	EXPECT_LT(polls, 20);
}

TEST(Parallel, bodiesComputeInTheDefaultEnvironment) {
	FpEnvironment before;
	before.save();
	for (const int threads : {1, 4}) {
		for (const std::size_t n : {1u, 64u}) {
			Monitor monitor;
			std::atomic<int> spoilt{0};
			spoilEnvironmentOfAllThreads(threads);
			const Status status =
			    parallelFor(n, 1, threads, monitor, [&spoilt](std::size_t, std::size_t) {
				    if (!environmentIsDefault()) {
					    ++spoilt;
				    }
				    std::this_thread::sleep_for(std::chrono::microseconds(200));
			    });
			EXPECT_TRUE(status.ok());
			EXPECT_FALSE(environmentIsDefault()) << "the host's environment is given back";
			EXPECT_EQ(std::fegetround(), FE_UPWARD);
			EXPECT_EQ(spoilt, 0) << n << " chunks, " << threads << " threads";
		}
	}
	before.restore();
	EXPECT_TRUE(environmentIsDefault());
}

TEST(Parallel, aCallbackThatSpoilsTheEnvironmentSpoilsNothingAfterIt) {
	FpEnvironment before;
	before.save();
	{
		const FpEnvironmentGuard guard;
		Monitor monitor([](double, const char*) {
			spoilEnvironment();
			return true;
		});
		monitor.beginStage("test", 0, 1);
		EXPECT_TRUE(environmentIsDefault()) << "what is not in a parallel region";
		int spoilt = 0;
		const Status status = parallelFor(1, 1, 1, monitor, [&spoilt](std::size_t, std::size_t) {
			spoilt += environmentIsDefault() ? 0 : 1;
		});
		EXPECT_TRUE(status.ok());
		EXPECT_EQ(spoilt, 0);
	}
	before.restore();
}

TEST(Parallel, guardRestoresTheHostsEnvironment) {
	FpEnvironment before;
	before.save();
	spoilEnvironment();
	{
		const FpEnvironmentGuard guard;
		EXPECT_TRUE(environmentIsDefault());
		{ const FpEnvironmentGuard inner; }
		EXPECT_TRUE(environmentIsDefault()) << "an inner guard gives nothing back";
	}
	EXPECT_FALSE(environmentIsDefault());
	{
		const FpEnvironmentGuard guard;
		EXPECT_TRUE(environmentIsDefault()) << "a second one guards as the first";
	}
	before.restore();
}
