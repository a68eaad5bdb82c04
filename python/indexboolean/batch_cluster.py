# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: jobs and the address of a Dask cluster; out: their outcomes, from its workers.

A thread of a Dask worker has a process of its own for its jobs, as on one machine, so that no job
can harm the worker. If a worker is lost, Dask gives its jobs to others; those that were finished
have their records, and are not done again.
"""

import collections
import concurrent.futures
import contextlib
import logging
import queue

from .batch_process import JobProcess
from .plugin import HostError

_CONNECT_SECONDS = 10

# On a worker: processes that wait for a job, by their limits.
_idle = collections.defaultdict(queue.SimpleQueue)


def outcomes_on_cluster(address, jobs, limits):
    """Yields (job, outcome) in the order in which jobs end; closing it cancels what is not begun.

    Raises HostError without Dask, OSError if the cluster is not there or is lost.
    """
    try:
        import dask
        import distributed
    except ImportError as error:
        raise HostError(
            f'--scheduler needs Dask: {error}; install it by: python -m pip install '
            '"indexboolean[dask]"'
        ) from error
    with _no_logging(), dask.config.set(
        {"distributed.comm.timeouts.connect": _CONNECT_SECONDS}
    ), distributed.Client(address, timeout=_CONNECT_SECONDS) as client:
        futures = {
            client.submit(
                run_on_worker, job, limits, key=f"{job['name']}-{job['fingerprint']}", pure=False
            ): job
            for job in jobs
        }
        try:
            for future in distributed.as_completed(futures):
                job = futures.pop(future)
                yield job, _outcome_of(future)
                future.release()
        finally:
            if client.status == "running":
                client.cancel(list(futures))
        client.run(end_idle_processes)


@contextlib.contextmanager
def _no_logging():
    """Dask's own account of a lost connection is pages long; here one sentence tells of it."""
    before = logging.root.manager.disable
    logging.disable(logging.CRITICAL)
    try:
        yield
    finally:
        logging.disable(before)


def _outcome_of(future):
    lost = OSError(
        "the connection to the Dask scheduler is lost; the same command goes on from here"
    )
    if future.status in ("cancelled", "lost"):
        raise lost
    if future.status == "finished":
        try:
            return future.result()
        except (concurrent.futures.CancelledError, OSError) as error:
            raise lost from error
    error = future.exception()
    if isinstance(error, HostError):  # on that worker
        return {"status": "failed", "message": str(error), "seconds": ""}
    # The worker itself was lost, time and again, or cannot run this package.
    return {"status": "crashed", "message": f"{type(error).__name__}: {error}", "seconds": ""}


def run_on_worker(job, limits):
    """What Dask calls for each job."""
    waiting = _idle[limits]
    try:
        process = waiting.get_nowait()
    except queue.Empty:
        process = JobProcess(limits)
    try:
        return process.run(job)
    finally:
        waiting.put(process)


def end_idle_processes():
    """Called on each worker when a batch is over."""
    for waiting in list(_idle.values()):
        while not waiting.empty():
            waiting.get_nowait().close()
