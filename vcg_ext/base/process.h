// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the system says of this process, and what its threads are to be like. Nothing here
// allocates.
#pragma once

#ifndef _WIN32
#include <csignal>
#endif

namespace index_boolean {

// How many threads this process may run at once, at least 1: the cores that it may use, or
// OMP_NUM_THREADS if that is set. Complexity: O(1); the first call asks the system.
int availableThreads();

// Tells a child that fork() has made from its parent, also where it has been given the same number.
struct ProcessId {
	long number, forks;

	friend bool operator==(const ProcessId& a, const ProcessId& b) {
		return a.number == b.number && a.forks == b.forks;
	}
};

// Complexity: O(1), one call of the system.
ProcessId currentProcess();

// Lets this thread run on the cores and with the priority that the process's first thread has, not
// with those of the thread that has started it. What the system forbids is left as it is.
// Complexity: O(1).
void runAsProcess();

// While it lives, this thread takes no signals but those of its own faults: nor do threads that it
// starts meanwhile. What a host has handlers for is to happen on its own threads.
class SignalsBlocked {
public:
	SignalsBlocked();
	~SignalsBlocked();
	SignalsBlocked(const SignalsBlocked&) = delete;
	SignalsBlocked& operator=(const SignalsBlocked&) = delete;

#ifndef _WIN32
private:
	sigset_t before_;
#endif
};

}  // namespace index_boolean
