# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A process that does jobs one after another, and may be lost with any of them.

in: jobs; out: an outcome for each, also when the process crashes, is killed or takes too long: it
is then started anew for the next one. Not multiprocessing's: a worker of a Dask cluster is itself
one of its daemons, which may have no children of that kind.
"""

import dataclasses
import json
import os
import queue
import signal
import subprocess
import sys
import tempfile
import threading
import time
from typing import Optional

from .plugin import HostError

_START_SECONDS = 120.0  # for the interpreter and the host, from a slow disk, say


@dataclasses.dataclass(frozen=True)
class Limits:
    """What one job may take: seconds and bytes of address space. None: as much as there is."""

    timeout: Optional[float] = None
    memory: Optional[int] = None


class JobProcess:
    """Used by one thread at a time; close() may be called by any.

    environment: its variables, by default those of this process.
    """

    def __init__(self, limits, environment=None):
        self._limits = limits
        self._environment = {**os.environ, **(environment or {})}
        if limits.memory:  # else glibc sets 64 MB of address space aside for each thread
            self._environment.setdefault("MALLOC_ARENA_MAX", "2")
        self._process = None
        self._closed = False
        self._lock = threading.Lock()

    def run(self, job):
        """The job's outcome, as run_job's, or with the status crashed or timed_out.

        Raises HostError if the process finds no host: then no job can be done here.
        """
        start = time.monotonic()
        outcome = self._start() or self._ask(job)
        if outcome["status"] != "done":
            # The next job has a fresh one: whatever happened to this one, and because pymeshlab
            # goes on logging to the document of a call that has thrown when that is gone.
            self._end()
        return {"seconds": time.monotonic() - start, **outcome}

    def close(self):
        """Ends the process, in the middle of a job, too; run() then gives crashed outcomes."""
        with self._lock:
            self._closed = True
            self._end()

    @property
    def pid(self):
        """The process's id, None before the first job."""
        return self._process.pid if self._process else None

    def _start(self):
        """Starts the process if there is none; returns an outcome if that fails."""
        with self._lock:
            if self._process and self._process.poll() is None:
                return None
            if self._closed:
                return {"status": "crashed", "message": "the worker was ended"}
            self._complaints = tempfile.TemporaryFile()
            self._answers = queue.SimpleQueue()
            self._process = subprocess.Popen(
                [sys.executable, "-m", f"{__package__}.batch_worker",
                 "--memory", str(self._limits.memory or 0)],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._complaints,
                env=self._environment,
                start_new_session=True,  # the terminal's Ctrl+C is for the batch as a whole
            )
            threading.Thread(
                target=_read_lines, args=(self._process.stdout, self._answers), daemon=True
            ).start()
        ready = self._answer(_START_SECONDS)
        if ready["status"] == "no_host":
            raise HostError(ready["message"])
        return None if ready["status"] == "ready" else ready

    def _ask(self, job):
        try:
            self._process.stdin.write(json.dumps(job).encode() + b"\n")
            self._process.stdin.flush()
        except OSError:
            pass  # it is gone: then there is no answer either
        return self._answer(self._limits.timeout)

    def _answer(self, seconds):
        try:
            line = self._answers.get(timeout=seconds)
        except queue.Empty:
            return {"status": "timed_out", "message": f"not done after {seconds:g} seconds"}
        return json.loads(line) if line else self._crash()

    def _crash(self):
        code = self._process.wait()
        self._complaints.seek(0)
        lines = self._complaints.read().decode(errors="replace").strip().splitlines()
        last = lines[-1] if lines else ""
        message = f"the process {_ending(code)}{': ' if last else ''}{last}"
        out_of_memory = "MemoryError" in last or "bad_alloc" in last
        return {"status": "out_of_memory" if out_of_memory else "crashed", "message": message}

    def _end(self):
        if self._process:
            self._process.kill()
            self._process.wait()


def _read_lines(stream, answers):
    """Puts each line, then None when the process is gone."""
    with stream:
        for line in stream:
            answers.put(line)
    answers.put(None)


def _ending(code):
    """How a process ended, in words."""
    if code >= 0:
        return f"ended itself with status {code}"
    name = signal.Signals(-code).name
    if name == "SIGKILL":
        return "was killed (SIGKILL), as the system does when memory runs out; --memory caps it"
    return f"was ended by {name}"
