// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work that wants helpers lies on a list. A helper takes a place at the first that has one; who put
// it there takes it off the list when done, and waits for those inside alone. (A region of OpenMP
// ends when all its threads have been there, one that the system has taken away and that has done
// nothing, too.)
#include "vcg_ext/base/helper_threads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace index_boolean {

namespace {

struct Work {
	void* context;
	void (*help)(void*);
	int places;  // left
	std::atomic<int> inside{0};
	std::condition_variable left{};
};

// Waits for what is mostly a matter of microseconds, when to sleep and to be woken takes longer:
// leaves the core to whoever else wants it meanwhile. \return whether it came to pass
template <class Condition>
bool comesSoon(Condition&& condition) {
	using Clock = std::chrono::steady_clock;
	constexpr std::chrono::microseconds kSoon{500};
	for (const Clock::time_point end = Clock::now() + kSoon; Clock::now() < end;) {
		if (condition()) {
			return true;
		}
		std::this_thread::yield();
	}
	return false;
}

// Locks what is never locked for longer than it takes to be put to sleep.
std::unique_lock<std::mutex> lockBriefly(std::mutex& mutex) {
	constexpr int kTries = 64;
	for (int i = 0; i < kTries; ++i) {
		std::unique_lock<std::mutex> lock(mutex, std::try_to_lock);
		if (lock.owns_lock()) {
			return lock;
		}
		std::this_thread::yield();
	}
	return std::unique_lock<std::mutex>(mutex);
}

class Helpers {
public:
	void call(Work& work);
	void close(Work& work);
	void end();

private:
	void startThreads(std::size_t count);
	void takeOff(Work& work);
	void helpForever();

	std::mutex mutex_;  // of all below, and of what is on the list
	std::condition_variable called_;
	std::vector<Work*> open_;  // those with places left
	std::atomic<bool> isAnyOpen_{false};
	bool hasEnded_ = false;
	std::vector<std::thread> threads_;
};

void Helpers::startThreads(std::size_t count) {
	try {
		for (std::size_t i = 0; i < count; ++i) {
			threads_.emplace_back([this] { helpForever(); });
		}
	} catch (const std::exception&) {  // no memory, or no more threads: there are as many as can be
	}
}

void Helpers::takeOff(Work& work) {
	open_.erase(std::find(open_.begin(), open_.end(), &work));
	isAnyOpen_ = !open_.empty();
}

void Helpers::call(Work& work) {
	const auto wanted = static_cast<std::size_t>(work.places);
	{
		const std::unique_lock<std::mutex> lock = lockBriefly(mutex_);
		open_.push_back(&work);
		isAnyOpen_ = true;
		if (threads_.size() < wanted && !hasEnded_) {
			startThreads(wanted - threads_.size());
		}
	}
	for (std::size_t i = 0; i < wanted; ++i) {
		called_.notify_one();
	}
}

void Helpers::close(Work& work) {
	std::unique_lock<std::mutex> lock = lockBriefly(mutex_);
	if (work.places > 0) {
		takeOff(work);
	}
	if (work.inside > 0) {
		lock.unlock();
		comesSoon([&work] { return work.inside == 0; });
		lock = lockBriefly(mutex_);
	}
	work.left.wait(lock, [&work] { return work.inside == 0; });
}

void Helpers::helpForever() {
	while (true) {
		comesSoon([this] { return isAnyOpen_.load(); });
		std::unique_lock<std::mutex> lock = lockBriefly(mutex_);
		called_.wait(lock, [this] { return hasEnded_ || !open_.empty(); });
		if (hasEnded_) {
			return;
		}
		Work& work = *open_.front();
		if (--work.places == 0) {
			takeOff(work);
		}
		++work.inside;
		lock.unlock();
		work.help(work.context);
		lock = lockBriefly(mutex_);
		if (--work.inside == 0) {
			work.left.notify_one();
		}
	}
}

// Ends the threads, each when it has done what it is at. What is called for later gets none.
void Helpers::end() {
	std::vector<std::thread> threads;
	{
		const std::unique_lock<std::mutex> lock = lockBriefly(mutex_);
		hasEnded_ = true;
		threads.swap(threads_);
	}
	called_.notify_all();
	for (std::thread& thread : threads) {
		thread.join();
	}
}

long processNumber() {
#ifdef _WIN32
	return 0;  // which has no fork()
#else
	return getpid();
#endif
}

struct HelpersOfProcess {
	long process = processNumber();
	Helpers helpers{};
};

// Never freed: a run may be on when the process ends.
std::atomic<HelpersOfProcess*> current{nullptr};

// Those of this process. A child has none of its parent's threads, whose state it leaves alone.
Helpers& helpersOfProcess() {
	HelpersOfProcess* found = current.load(std::memory_order_acquire);
	if (found != nullptr && found->process == processNumber()) {
		return found->helpers;
	}
	auto made = std::make_unique<HelpersOfProcess>();
	if (current.compare_exchange_strong(found, made.get(), std::memory_order_acq_rel)) {
		return made.release()->helpers;
	}
	return found->helpers;  // another thread was first
}

#ifndef _WIN32
// Before the code that the threads run is unloaded. (On Windows no thread can end while a library
// is unloaded; when a process ends, it has none left by then.)
struct AtUnload {
	~AtUnload() {
		HelpersOfProcess* const found = current.load(std::memory_order_acquire);
		if (found != nullptr && found->process == processNumber()) {
			found->helpers.end();
		}
	}
} atUnload;
#endif

int askForThreads() {
	const char* const asked = std::getenv("OMP_NUM_THREADS");
	const long number = asked == nullptr ? 0 : std::strtol(asked, nullptr, 10);
	constexpr long kMost = 1024;
	return static_cast<int>(number > 0 ? std::min(number, kMost)
	                                   : std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace

int availableThreads() {
	static const int number = askForThreads();
	return number;
}

void workWithHelpers(int helpers, void* context, void (*work)(void* context),
                     void (*help)(void* context)) {
	if (helpers <= 0) {
		return work(context);
	}
	Helpers& all = helpersOfProcess();
	Work offered{context, help, helpers};
	all.call(offered);
	work(context);
	all.close(offered);
}

}  // namespace index_boolean
