# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of batches share: tables of sample pairs, the command, a job that hangs.

A job hangs while it reads a named pipe that a test holds open and writes nothing to.
"""

import contextlib
import csv
import os
import pathlib
import signal
import subprocess
import sys
import time

SAMPLES = pathlib.Path(__file__).parents[2] / "sample_meshes"
PAIR = (SAMPLES / "wide_cylinder.ply", SAMPLES / "narrow_cylinder.ply")


def write_table(path, rows, columns=("first", "second", "name")):
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows([columns, *rows])
    return path


def table_of_copies(path, count):
    """A table of `count` jobs on one pair."""
    return write_table(path, [(*PAIR, f"job {number}") for number in range(count)])


def command(table, folder, *options):
    words = [sys.executable, "-m", "indexboolean", "batch", table, "-o", folder, *options]
    return [str(word) for word in words]


def run(table, folder, *options, **details):
    return subprocess.run(
        command(table, folder, *options), capture_output=True, text=True, timeout=120, **details
    )


def start(table, folder, *options):
    """The command as a process that leads a group of its own, as a terminal's job does."""
    return subprocess.Popen(
        command(table, folder, *options), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        text=True, start_new_session=True,
    )


def press_ctrl_c(batch):
    os.killpg(batch.pid, signal.SIGINT)


def results(folder):
    """The rows of results.csv by the jobs' names."""
    with open(folder / "results.csv", newline="") as file:
        return {row["name"]: row for row in csv.DictReader(file)}


def statuses(folder):
    return {name: row["status"] for name, row in results(folder).items()}


def records(folder):
    """When each finished job was recorded."""
    return {path.parent.name: path.stat().st_mtime_ns for path in folder.glob("*/job.json")}


@contextlib.contextmanager
def endless_mesh(path):
    """A mesh file that never ends; yields a function that waits until a process reads it.

    That function returns the process's id.
    """
    os.mkfifo(path)
    writers = []

    def wait_for_reader():
        # Opening for writing waits for a reader, which waits on.
        writers.append(os.open(path, os.O_WRONLY))
        return reader_of(path)

    try:
        yield wait_for_reader
    finally:
        for writer in writers:
            os.close(writer)


def reader_of(path):
    for process in pathlib.Path("/proc").iterdir():
        if not process.name.isdigit() or int(process.name) == os.getpid():
            continue
        with contextlib.suppress(OSError):
            if any(os.readlink(link) == str(path) for link in (process / "fd").iterdir()):
                return int(process.name)
    raise AssertionError(f"no process reads {path}")


def wait_until(condition, seconds=60.0):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it did not come true"
        time.sleep(0.02)


def is_running(pid):
    """Zombies, which wait for their parent to take note, do not run."""
    try:
        state = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"
