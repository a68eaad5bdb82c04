# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One job of a batch, from its files to its folder: the same function on every machine.

in: a job, a dict of plain values (job_of), which pickle and JSON keep; out: its outcome, a dict,
and in the job's folder the files of the command `boolean` and, last of all, job.json, the record
that the job is finished. Guarantee: a record speaks of files that are complete and on the disk;
running a job that has its record does nothing.
"""

import concurrent.futures
import hashlib
import importlib.metadata
import json
import os
import pathlib
import re
import shutil
import tempfile
import time

from .batch_table import Evaluation
from .boolean_job import BLOCKS, FORMATS, run_boolean_job
from .distance_job import SIDES, STATISTICS, run_distance_job
from .evaluate_job import run_evaluate_job
from .job import Job, JobError, LayersJob, Refusal
from .plugin import HostError

UNFINISHED = ".unfinished"  # beside the jobs' folders: what interrupted jobs leave
FIGURES = ("faces", "volume", "self_intersections")  # of each block
DISTANCE_FIGURES = ("hausdorff", *(f"{name}_{side}" for side in SIDES for name in STATISTICS))
_DISTANCE_PARAMETERS = ("self_intersections", "winding_rule", "weld_distance")
_RECORD = "job.json"
_IN_COLUMNS = re.compile(
    r'".*": \d+ faces?|Certified:|Index Boolean took|Hausdorff|Distance of|Colours:'
)
_FILES = {
    "result.json", *(f"{side}.ply" for side in SIDES),
    *(f"{block}.{suffix}" for block in BLOCKS for suffix in FORMATS),
}


def job_of(row, folder, file_format, parameters):
    """The job of a row of the table; its folder is folder/<the row's name>."""
    if isinstance(row, Evaluation):
        operands = {
            "expression": row.expression,
            "operands": {name: str(path) for name, path in row.operands.items()},
        }
    else:
        operands = {
            "first": str(row.first),
            "second": str(row.second),
            "first_transform": row.first_transform,
            "second_transform": row.second_transform,
            "kind": row.kind,
        }
    job = {**operands, "blocks": row.blocks, "format": file_format, "parameters": parameters}
    return {
        **job,
        "name": row.name,
        "folder": str(folder.absolute() / row.name),
        "fingerprint": _fingerprint(job),
    }


def outcome_on_disk(job):
    """The outcome of the job if it is finished and neither it nor its inputs have changed since."""
    folder = pathlib.Path(job["folder"])
    try:
        record = json.loads((folder / _RECORD).read_text(encoding="utf-8"))
        if record["fingerprint"] != job["fingerprint"]:
            return None
        whole = all(
            (folder / name).stat().st_size == size for name, size in record["bytes"].items()
        )
        return record["outcome"] if whole else None
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None  # absent, or damaged: the job is done again


def run_job(job):
    """Does the job, unless it is done; returns its outcome and raises nothing.

    An outcome has a status (done, refused, out_of_memory, failed), a message, seconds, and, if
    done, closed and the figures of each block, or those of the distances.
    """
    start = time.monotonic()
    finished = outcome_on_disk(job)
    if finished:
        return finished
    try:
        outcome = _do(job, start)
    except MemoryError as error:
        outcome = {"status": "out_of_memory", "message": f"memory ran out: {error}"}
    except (HostError, JobError, OSError) as error:
        outcome = {"status": "failed", "message": str(error)}
    return {"seconds": time.monotonic() - start, **outcome}


def _do(job, start):
    folder = pathlib.Path(job["folder"])
    unfinished = folder.parent / UNFINISHED
    unfinished.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=f"{job['name']}-", dir=unfinished) as new:
        new = pathlib.Path(new)
        try:
            run = (
                _evaluation if "expression" in job
                else _distance if job["kind"] == "distance" else _boolean
            )
            outcome, messages = run(job, new)
            outcome.update(status="done", message=_remarks(messages))
        except Refusal as error:
            outcome = {"status": "refused", "message": str(error)}
        outcome["seconds"] = time.monotonic() - start
        _publish(new, folder, {"fingerprint": job["fingerprint"], "outcome": outcome})
    return outcome


def _boolean(job, folder):
    """The figures of a Boolean, and what it logged."""
    result, messages = run_boolean_job(
        _document(job, folder), job["blocks"], job["format"], **job["parameters"]
    )
    return _figures(result, job), messages


def _distance(job, folder):
    """The figures of a distance, and what it logged."""
    parameters = {name: job["parameters"][name] for name in _DISTANCE_PARAMETERS}
    result, messages = run_distance_job(_document(job, folder), **parameters)
    return {name: result[name] for name in DISTANCE_FIGURES if name in result}, messages


def _document(job, folder):
    return Job(
        pathlib.Path(job["first"]), pathlib.Path(job["second"]), folder, lambda *_: None,
        transforms=(job["first_transform"], job["second_transform"]),
    )


def _evaluation(job, folder):
    """The figures of an expression's results, and what it logged."""
    files = {name: pathlib.Path(path) for name, path in job["operands"].items()}
    run = LayersJob(files, folder, lambda *_: None)
    result, messages = run_evaluate_job(
        run, job["expression"], job["format"], **job["parameters"]
    )
    return _figures(result, job), messages


def _remarks(messages):
    """What the filter logged beside the figures that have columns of their own."""
    return " ".join(message for message in messages if not _IN_COLUMNS.match(message))


def _figures(result, job):
    """The figures of each block; in the map those of a statement have its number."""
    keys = {
        block: f"result_{number}" if "expression" in job else block
        for number, block in enumerate(job["blocks"])
    }
    figures = {
        f"{block}_{figure}": result[f"{key}_{figure}"]
        for block, key in keys.items() for figure in FIGURES
    }
    return {"closed": all(result[f"{key}_closed"] for key in keys.values()), **figures}


def _publish(new, folder, record):
    """Moves the files of `new` into the job's folder, and the record when all are there.

    Two workers may do this for one job at a time, as their files are the same, byte for byte.
    """
    names = sorted(path.name for path in new.iterdir())
    record["bytes"] = {name: (new / name).stat().st_size for name in names}
    (new / _RECORD).write_text(json.dumps(record, indent="\t") + "\n", encoding="utf-8")
    folder.mkdir(exist_ok=True)
    for stale in {_RECORD} | ((_FILES | _recorded(folder)) - set(names)):
        (folder / stale).unlink(missing_ok=True)
    with concurrent.futures.ThreadPoolExecutor(len(names) + 1) as threads:
        list(threads.map(_onto_disk, new.iterdir()))  # together: one write of the disk's journal
    for name in names:
        os.replace(new / name, folder / name)
    _onto_disk(folder)
    os.replace(new / _RECORD, folder / _RECORD)
    _onto_disk(folder)


def _recorded(folder):
    """The files that an earlier run of the job has left, by its record."""
    try:
        record = json.loads((folder / _RECORD).read_text(encoding="utf-8"))
        return {pathlib.Path(name).name for name in record["bytes"]}
    except (OSError, ValueError, KeyError, TypeError):
        return set()


def _onto_disk(path):
    """Returns when the file, or the folder's list of files, is on the disk."""
    if os.name == "nt" and path.is_dir():
        return  # Windows keeps its folders itself
    descriptor = os.open(path, os.O_RDONLY if path.is_dir() else os.O_RDWR)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def remove_unfinished(folder):
    """Removes what interrupted jobs have left in the batch's folder."""
    shutil.rmtree(folder / UNFINISHED, ignore_errors=True)


def _fingerprint(job):
    """Changes with the row, the options, the input files and the version of this package."""
    operands = job["operands"].values() if "expression" in job else (job["first"], job["second"])
    files = [_state_of(path) for path in operands]
    version = importlib.metadata.version("indexboolean")
    text = json.dumps([job, files, version], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def _state_of(path):
    try:
        found = os.stat(path)
    except OSError:
        return None
    return found.st_size, found.st_mtime_ns
