# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Long calls into pymeshlab, with its progress and its log, and with Ctrl+C at work.

pymeshlab gives Python no progress callback: a verbose MeshSet prints each report as a line on the
process's standard error (and noise on its standard output). And Python handles Ctrl+C only between
calls, on the main thread. So the call runs on a thread of its own, with the two descriptors turned
elsewhere, and the main thread reads what is printed.
"""

import contextlib
import ctypes
import io
import os
import re
import sys
import threading

_C_LIBRARY = ctypes.CDLL("ucrtbase" if os.name == "nt" else None)
_PROGRESS = re.compile(r"LOG: \d+ (?P<stage>.*?)\s*\[ *(?P<percent>\d+)% \]$")
_MESSAGE = re.compile(r"LOG: \d+ (?P<text>.+)$")


def host_call(call, on_progress):
    """Runs call() and returns (its value, the messages that the host logged meanwhile).

    on_progress(stage, percent) is called on this thread. What call() raises is raised here;
    KeyboardInterrupt comes at once, while call() may go on behind.
    """
    outcome = {}

    def run(end_of_output):
        try:
            outcome["value"] = call()
        except BaseException as error:  # handed over to the thread that waits
            outcome["error"] = error
        finally:
            _C_LIBRARY.fflush(None)  # while the host's own prints still go elsewhere
            end_of_output()

    messages = []
    with _output_through_pipe() as (lines, forward, end_of_output), contextlib.redirect_stdout(
        io.StringIO()
    ):
        threading.Thread(target=run, args=(end_of_output,), daemon=True).start()
        for line in lines:
            if report := _PROGRESS.match(line):
                on_progress(report["stage"], int(report["percent"]))
            elif message := _MESSAGE.match(line):
                messages.append(message["text"])
            else:
                forward(line)
    if "error" in outcome:
        raise outcome["error"]
    return outcome["value"], messages


@contextlib.contextmanager
def _output_through_pipe():
    """Turns descriptor 2 into a pipe, and descriptor 1 into nothing.

    Yields (the lines that come through the pipe, a function that writes a line to the real standard
    error, a function that ends the lines).
    """
    saved = {1: os.dup(1), 2: os.dup(2)}
    reading, writing = os.pipe()
    nowhere = os.open(os.devnull, os.O_WRONLY)

    def restore():
        for descriptor, real in saved.items():
            os.dup2(real, descriptor)

    sys.stdout.flush()
    os.dup2(nowhere, 1)
    os.dup2(writing, 2)
    os.close(nowhere)
    os.close(writing)
    try:
        with os.fdopen(reading, errors="replace") as lines:
            yield lines, lambda line: os.write(saved[2], line.encode()), restore
    finally:
        restore()
        for real in saved.values():
            os.close(real)
