# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m indexboolean batch --scheduler: the same jobs on a Dask cluster of two workers."""

import os
import signal

import distributed
import pytest

from batch_support import (
    PAIR, endless_mesh, is_running, press_ctrl_c, records, results, run, start, statuses,
    table_of_copies, wait_until, write_table,
)
from indexboolean import batch_cluster
from indexboolean.command_line import main


@pytest.fixture(scope="module")
def cluster():
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=":0", silence_logs=50
    ) as running:
        yield running


def worker_pids(cluster):
    with distributed.Client(cluster) as client:
        client.wait_for_workers(2, timeout=60)  # one that was killed is on its way back
        return list(client.run(os.getpid).values())


def test_resultsAreThoseOfOneMachine(cluster, tmp_path):
    table = write_table(
        tmp_path / "jobs.csv", [(*PAIR, "good"), (PAIR[0], "absent.ply", "absent")]
    )
    here = run(table, tmp_path / "here")
    there = run(table, tmp_path / "there", "--scheduler", cluster.scheduler_address)
    assert here.returncode == there.returncode == 3, there.stderr
    rows = [results(tmp_path / folder) for folder in ("here", "there")]
    for row in (*rows[0].values(), *rows[1].values()):
        del row["seconds"]
    assert rows[0] == rows[1] and rows[0]["good"]["status"] == "done"
    for block in (tmp_path / "here/good").glob("*.ply"):
        assert block.read_bytes() == (tmp_path / "there/good" / block.name).read_bytes()


def test_killedWorkerLosesNoFinishedJob(cluster, tmp_path):
    table, folder = table_of_copies(tmp_path / "jobs.csv", 60), tmp_path / "out"
    victim = worker_pids(cluster)[0]
    batch = start(table, folder, "--scheduler", cluster.scheduler_address)
    wait_until(lambda: len(records(folder)) >= 8)
    os.kill(victim, signal.SIGKILL)
    finished = records(folder)
    _, errors = batch.communicate(timeout=90)
    assert batch.returncode == 0, errors
    assert len(finished) < 60 and set(statuses(folder).values()) == {"done"}
    assert len(statuses(folder)) == 60
    after = records(folder)
    assert {name: after[name] for name in finished} == finished


def test_killedJobIsReportedAndItsWorkerLives(cluster, tmp_path):
    rows = [(tmp_path / "endless.ply", PAIR[0], "killed"), (*PAIR, "good")]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    workers = sorted(worker_pids(cluster))
    with endless_mesh(tmp_path / "endless.ply") as wait_for_reader:
        batch = start(table, folder, "--scheduler", cluster.scheduler_address)
        os.kill(wait_for_reader(), signal.SIGKILL)
        batch.communicate(timeout=60)
    assert batch.returncode == 3
    assert statuses(folder) == {"killed": "crashed", "good": "done"}
    assert sorted(worker_pids(cluster)) == workers


def test_interruptEndsAtOnceAndTheClusterStaysUsable(cluster, tmp_path):
    rows = [(tmp_path / "endless.ply", PAIR[0], "hangs"), (*PAIR, "good")]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    with endless_mesh(tmp_path / "endless.ply") as wait_for_reader:
        batch = start(table, folder, "--scheduler", cluster.scheduler_address, "--timeout", "3")
        reader = wait_for_reader()
        wait_until(lambda: records(folder))
        press_ctrl_c(batch)
        _, errors = batch.communicate(timeout=10)
        assert batch.returncode == 130 and "Traceback" not in errors
        wait_until(lambda: not is_running(reader))  # its time is over
    os.remove(tmp_path / "endless.ply")
    again = run(table, folder, "--scheduler", cluster.scheduler_address)
    assert again.returncode == 3 and "1 of 2 jobs are finished already" in again.stderr


def test_absentSchedulerEndsWithOne(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(batch_cluster, "_CONNECT_SECONDS", 0.5)
    table = str(table_of_copies(tmp_path / "jobs.csv", 1))
    address = "tcp://127.0.0.1:9"
    assert main(["batch", table, "-o", str(tmp_path / "out"), "--scheduler", address]) == 1
    assert address in capsys.readouterr().err


def test_lostSchedulerIsToldAndTheNextRunGoesOn(tmp_path):
    rows = [(*PAIR, "good"), (tmp_path / "endless.ply", PAIR[0], "hangs")]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    with endless_mesh(tmp_path / "endless.ply") as wait_for_reader:
        with distributed.LocalCluster(
            n_workers=1, threads_per_worker=1, dashboard_address=":0", silence_logs=50
        ) as lost:
            batch = start(table, folder, "--scheduler", lost.scheduler_address)
            wait_for_reader()
            wait_until(lambda: records(folder))
        _, errors = batch.communicate(timeout=60)
    assert batch.returncode == 1
    assert "connection to the Dask scheduler is lost" in errors and "Traceback" not in errors
    os.remove(tmp_path / "endless.ply")
    again = run(table, folder)
    assert again.returncode == 3 and "1 of 2 jobs are finished already" in again.stderr


def test_absentDaskIsNamedWithWhatToInstall(tmp_path):
    (tmp_path / "distributed.py").write_text("raise ImportError('no distributed')\n")
    table = table_of_copies(tmp_path / "jobs.csv", 1)
    done = run(
        table, tmp_path / "out", "--scheduler", "tcp://127.0.0.1:9",
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    assert done.returncode == 1
    assert 'pip install "indexboolean[dask]"' in done.stderr
