// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work that wants helpers lies on a list. A helper takes a place at the first that has one; who put
// it there takes it off the list when done, and waits for those inside alone. (A region of OpenMP
// ends when all its threads have been there, one that the system has taken away and that has done
// nothing, too.)
#include "vcg_ext/base/helper_threads.h"

#include "vcg_ext/base/process.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <thread>
#include <vector>

namespace index_boolean {

namespace {

#ifdef _WIN32
constexpr bool kCanThreadsEndAtUnload = false;
#else
constexpr bool kCanThreadsEndAtUnload = true;
#endif

struct Work {
	void* context;
	void (*help)(void*);
	int places;            // left
	Work* next = nullptr;  // on the list
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

// Sleeps until it is notified and the condition holds. (What GCC 12 makes of wait() needs a newer
// C++ library than hosts do; with a limit it is the system's own.)
template <class Condition>
void sleepUntil(std::condition_variable& notified, std::unique_lock<std::mutex>& lock,
                Condition&& condition) {
	while (!condition()) {
#ifdef __GLIBCXX__
		notified.wait_for(lock, std::chrono::hours(1));
#else
		notified.wait(lock);
#endif
	}
}

class Helpers {
public:
	void call(Work& work);
	void close(Work& work);
	void end();
	bool haveEnded() const { return hasEnded_; }

private:
	void startThreads(std::size_t count);
	void takeOff(Work& work);
	void helpForever();

	std::mutex mutex_;  // of all below, and of what is on the list
	std::condition_variable called_;
	Work* first_ = nullptr;  // of those with places left, in the order of calls
	std::atomic<bool> isAnyOpen_{false}, hasEnded_{false};
	std::vector<std::thread> threads_;
};

void Helpers::startThreads(std::size_t count) {
	const SignalsBlocked signals;
	try {
		for (std::size_t i = 0; i < count; ++i) {
			threads_.emplace_back([this] { helpForever(); });
		}
	} catch (const std::exception&) {  // no memory, or no more threads: there are as many as can be
	}
}

void Helpers::takeOff(Work& work) {
	Work** place = &first_;
	while (*place != &work) {
		place = &(*place)->next;
	}
	*place = work.next;
	isAnyOpen_ = first_ != nullptr;
}

void Helpers::call(Work& work) {
	const auto wanted = static_cast<std::size_t>(work.places);
	{
		const std::unique_lock<std::mutex> lock = lockBriefly(mutex_);
		Work** last = &first_;
		while (*last != nullptr) {
			last = &(*last)->next;
		}
		*last = &work;
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
	sleepUntil(work.left, lock, [&work] { return work.inside == 0; });
}

void Helpers::helpForever() {
	runAsProcess();
	while (true) {
		comesSoon([this] { return isAnyOpen_.load(); });
		std::unique_lock<std::mutex> lock = lockBriefly(mutex_);
		sleepUntil(called_, lock, [this] { return hasEnded_ || first_ != nullptr; });
		if (hasEnded_) {
			return;
		}
		Work& work = *first_;
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

// Ends the threads, each when it has done what it is at; none is started after that. What is called
// for later gets no help.
void Helpers::end() {
	{
		const std::unique_lock<std::mutex> lock = lockBriefly(mutex_);
		hasEnded_ = true;
	}
	called_.notify_all();
	for (std::thread& thread : threads_) {
		if (thread.get_id() != std::this_thread::get_id()) {  // whose own fault ends the process
			thread.join();
		}
	}
}

struct HelpersOfProcess {
	ProcessId process = currentProcess();
	Helpers helpers{};
};

// Never freed: a run may be on when the process ends.
std::atomic<HelpersOfProcess*> current{nullptr};

// Those of this process. A child has none of its parent's threads, whose state it leaves alone.
// \return null if there is no memory for them
Helpers* helpersOfProcess() {
	HelpersOfProcess* found = current.load(std::memory_order_acquire);
	if (found != nullptr && found->process == currentProcess()) {
		return &found->helpers;
	}
	try {
		auto made = std::make_unique<HelpersOfProcess>();
		if (current.compare_exchange_strong(found, made.get(), std::memory_order_acq_rel)) {
			found = made.release();
		}
		return &found->helpers;  // another thread's, if that was first
	} catch (const std::bad_alloc&) {
		return nullptr;
	}
}

// Before the code that the threads run is unloaded. (On Windows no thread can end while a library
// is unloaded; when a process ends, it has none left by then.)
struct AtUnload {
	~AtUnload() {
		HelpersOfProcess* const found = current.load(std::memory_order_acquire);
		if (kCanThreadsEndAtUnload && found != nullptr && found->process == currentProcess()) {
			found->helpers.end();
		}
	}
} atUnload;

}  // namespace

void workWithHelpers(int helpers, void* context, void (*work)(void* context),
                     void (*help)(void* context)) {
	Helpers* const all = helpers > 0 ? helpersOfProcess() : nullptr;
	if (all == nullptr) {
		return work(context);
	}
	Work offered{context, help, helpers};
	all->call(offered);
	work(context);
	all->close(offered);
}

bool areHelpersToLeave() {
	const HelpersOfProcess* const found = current.load(std::memory_order_acquire);
	return found != nullptr && found->helpers.haveEnded();
}

}  // namespace index_boolean
