// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: work that any number of threads can do together; out: done, by this thread and by those
// helpers that came in time. Nobody waits for a thread that the system has not woken: on a busy
// machine that takes milliseconds, and a short loop is long done by then.
#pragma once

namespace index_boolean {

// Calls work(context) on this thread, and help(context) on up to `helpers` others, which are kept
// for later calls; returns when all calls have returned. A helper that finds work(context) ended
// is not let in. If a thread cannot be had, there are fewer. From any thread, and from several at
// once; a child made by fork() has helpers of its own, but if it was made from inside work, this
// call never returns in it. Not to be called from inside help.
// \pre neither throws. Complexity: that of the work, and O(helpers) calls of the system.
void workWithHelpers(int helpers, void* context, void (*work)(void* context),
                     void (*help)(void* context));

// Whether helpers should leave the rest to whom they help, since the process ends or this library
// is unloaded. From inside help. Complexity: O(1).
bool areHelpersToLeave();

}  // namespace index_boolean
