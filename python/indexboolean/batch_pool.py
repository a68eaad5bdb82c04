# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: jobs; out: their outcomes, from processes on this machine."""

import concurrent.futures
import contextlib
import os
import queue

from .batch_process import JobProcess


def outcomes_on_this_machine(jobs, workers, limits):
    """Yields (job, outcome) in the order in which jobs end; closing it ends the processes."""
    threads = max(1, available_cores() // workers)  # results do not depend on it
    environment = {"OMP_NUM_THREADS": str(threads), **os.environ}
    processes = [JobProcess(limits, environment) for _ in range(min(workers, len(jobs)))]
    idle = queue.SimpleQueue()
    for process in processes:
        idle.put(process)

    def run(job):
        process = idle.get()
        try:
            return process.run(job)
        finally:
            idle.put(process)

    pool = concurrent.futures.ThreadPoolExecutor(max(1, len(processes)))
    try:
        futures = {pool.submit(run, job): job for job in jobs}
        for future in concurrent.futures.as_completed(futures):
            yield futures.pop(future), future.result()
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in processes:
            process.close()


def available_cores():
    """How many cores this process may use."""
    with contextlib.suppress(AttributeError):  # Linux alone
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
