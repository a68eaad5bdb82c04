# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `batch`: a table of jobs in, results.csv out; what is printed meanwhile.

What is finished is known from the jobs' own records (batch_job.py), so that nothing is lost with
this process; results.csv is written from outcomes, again and again and at the end.
"""

import collections
import contextlib
import csv
import os
import sys
import time

from rich.console import Console
from rich.progress import (
    BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn,
)

from .batch_job import (
    DISTANCE_FIGURES, FIGURES, job_of, outcome_on_disk, remove_unfinished,
)
from .batch_pool import available_cores, outcomes_on_this_machine
from .batch_process import Limits
from .batch_table import TableError, read_table
from .boolean_job import BLOCKS
from .plugin import HostError
from .printed_table import new_table

_RESULTS_EVERY = 2.0  # seconds


def run_batch_command(options):
    """Runs the command with the options of the command line; returns the exit status."""
    console = Console(stderr=True, soft_wrap=True, highlight=False)
    try:
        jobs = _read_jobs(options)
        results = Results(options.folder / "results.csv", jobs)
        with contextlib.closing(_outcomes(options, results.missing())) as outcomes:
            _collect(outcomes, results, console)
        remove_unfinished(options.folder)
    except KeyboardInterrupt:
        console.print("the same command goes on where this one was interrupted", markup=False)
        raise
    except (HostError, TableError, OSError) as error:
        console.print(f"error: {error}", style="red", markup=False)
        return 1
    _print_summary(results)
    return 0 if results.all_done() else 3


def _read_jobs(options):
    rows = read_table(options.table, options.only)
    options.folder.mkdir(parents=True, exist_ok=True)
    parameters = {name: getattr(options, name) for name in options.filter_options}
    return [job_of(row, options.folder, options.format, parameters) for row in rows]


def _outcomes(options, jobs):
    """An iterator over (job, outcome) in the order in which jobs end."""
    limits = Limits(options.timeout, options.memory)
    if options.scheduler:
        from .batch_cluster import outcomes_on_cluster

        return outcomes_on_cluster(options.scheduler, jobs, limits)
    return outcomes_on_this_machine(jobs, options.workers or available_cores(), limits)


class Results:
    """The outcomes so far, by the jobs' names, and their file, a row a job in the table's order."""

    def __init__(self, path, jobs):
        self.path = path
        self._jobs = jobs
        self._outcomes = {
            job["name"]: outcome for job in jobs if (outcome := outcome_on_disk(job))
        }
        self.kept = len(self._outcomes)
        self._written = time.monotonic()

    def __len__(self):
        return len(self._jobs)

    def missing(self):
        """The jobs without an outcome."""
        return [job for job in self._jobs if job["name"] not in self._outcomes]

    def add(self, job, outcome):
        self._outcomes[job["name"]] = outcome
        if time.monotonic() - self._written > _RESULTS_EVERY:
            self.write()

    def all_done(self):
        return len(self._outcomes) == len(self) == self.statuses()["done"]

    def statuses(self):
        """How many jobs have each status."""
        return collections.Counter(outcome["status"] for outcome in self._outcomes.values())

    def _blocks(self):
        """The names of all jobs' blocks: those of the Boolean, then others as they come."""
        names = dict.fromkeys(name for job in self._jobs for name in job["blocks"])
        return [*(b for b in BLOCKS if b in names), *(n for n in names if n not in BLOCKS)]

    def write(self):
        """Replaces the file by one with a row for each job that has an outcome."""
        figures = [f"{block}_{figure}" for block in self._blocks() for figure in FIGURES]
        if any(job.get("kind") == "distance" for job in self._jobs):
            figures += DISTANCE_FIGURES
        is_evaluation = "expression" in self._jobs[0]
        columns = [
            "name", *(("expression", "operands") if is_evaluation else ("first", "second")),
            "status", "seconds", "message", "closed", *figures,
        ]
        unfinished = self.path.with_suffix(".unfinished")
        with open(unfinished, "w", newline="", encoding="utf-8") as file:
            rows = csv.DictWriter(file, columns, restval="", extrasaction="ignore")
            rows.writeheader()
            for job in self._jobs:
                if outcome := self._outcomes.get(job["name"]):
                    rows.writerow(_cells({**job, **outcome}))
            file.flush()
            os.fsync(file.fileno())
        os.replace(unfinished, self.path)
        self._written = time.monotonic()


def _cells(row):
    closed = {True: "yes", False: "no"}
    cells = {
        key: closed[value] if isinstance(value, bool) else value for key, value in row.items()
    }
    if "expression" in cells:
        cells["operands"] = ";".join(f'{name}="{path}"' for name, path in row["operands"].items())
    return cells


def _collect(outcomes, results, console):
    """Takes every outcome as it comes, tells of the bad ones, and draws a bar on a terminal."""
    columns = (
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(),
        TimeRemainingColumn(),
    )
    if results.kept:
        console.print(f"{results.kept} of {len(results)} jobs are finished already", markup=False)
    try:
        with Progress(
            *columns, console=console, transient=True, disable=not console.is_terminal
        ) as progress:
            task = progress.add_task("jobs", total=len(results), completed=results.kept)
            for job, outcome in outcomes:
                results.add(job, outcome)
                if outcome["status"] != "done":
                    console.print(
                        f"{job['name']}: {outcome['status']}: {outcome['message']}", markup=False
                    )
                progress.advance(task)
    finally:
        results.write()


def _print_summary(results):
    table = new_table("status", "jobs")
    for status, count in results.statuses().most_common():
        table.add_row(status, str(count))
    console = Console(file=sys.stdout, soft_wrap=True, highlight=False)
    console.print(table)
    console.print(f"{results.path}", markup=False)
