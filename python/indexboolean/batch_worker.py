# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m indexboolean.batch_worker: does the jobs that come in, one after another.

in: a job a line (JSON) on standard input; out: on standard output a line when it is ready, then
the outcome of each job, a line. Ends at once when its input ends, so that it outlives nobody. What
the host prints goes to standard error. batch_process.py is the other side.
"""

import argparse
import json
import os
import queue
import sys
import threading

from .batch_job import run_job
from .plugin import HostError, load_plugin


def main():
    parser = argparse.ArgumentParser(prog="python -m indexboolean.batch_worker")
    parser.add_argument("--memory", type=int, default=0, help="bytes of address space; 0: any")
    memory = parser.parse_args().memory
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    if memory:
        _limit_memory(memory)
    jobs = queue.SimpleQueue()
    threading.Thread(target=_read_jobs, args=(jobs,), daemon=True).start()
    _answer(answers, _ready())
    while True:
        _answer(answers, run_job(jobs.get()))


def _limit_memory(memory):
    import resource  # not everywhere; asked for only where it is

    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    if hard != resource.RLIM_INFINITY:
        memory = min(memory, hard)
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))


def _read_jobs(jobs):
    for line in sys.stdin:
        jobs.put(json.loads(line))
    os._exit(0)  # even out of a call into the host


def _ready():
    try:
        load_plugin()
    except HostError as error:
        return {"status": "no_host", "message": str(error)}
    return {"status": "ready"}


def _answer(answers, value):
    answers.write(json.dumps(value) + "\n")
    answers.flush()


if __name__ == "__main__":
    main()
