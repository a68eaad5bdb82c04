# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions on meshes in several threads at once, and in a child of a process with threads."""

import os
import subprocess
import sys

import pytest

CUBES = """
import os, signal, threading, time
import numpy as np
import indexboolean
V = np.array([(x, y, z) for z in (0.0, 1) for y in (0.0, 1) for x in (0.0, 1)])
Q = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
def union():
    return len(indexboolean.boolean((V, Q), (V + 0.5, Q))[0])
"""
# Most unions of two threads at once do no harm, so that it is also counted who is in the host.
THREADS = CUBES + """
import pymeshlab
inside, most = [], 0
apply_filter = pymeshlab.MeshSet.apply_filter
def counted(*arguments, **parameters):
    global most
    inside.append(1)
    most = max(most, len(inside))
    time.sleep(0.001)
    try:
        return apply_filter(*arguments, **parameters)
    finally:
        inside.pop()
pymeshlab.MeshSet.apply_filter = counted
def work(number):
    start.wait()
    for turn in range(20):
        if (number + turn) % 4 == 0:
            try:
                indexboolean.boolean((V, Q), (V + 0.5, Q[1:]))
            except indexboolean.MeshRefusal as refusal:
                counts[number] += 20 * (len(refusal.faces) > 0)
        else:
            counts[number] += union()
start, counts = threading.Barrier(6), [0] * 6
threads = [threading.Thread(target=work, args=(number,)) for number in range(6)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(counts == [400] * 6 and most == 1)
"""
CHILDREN = CUBES + """
from indexboolean.host_lock import host_lock
held, enough = threading.Event(), threading.Event()
def hold():
    with host_lock():
        held.set()
        enough.wait()
union()
thread = threading.Thread(target=hold)
thread.start()
held.wait()
child = os.fork()
if child == 0:
    signal.alarm(60)
    os._exit(0 if union() == 20 else 1)
print(os.waitpid(child, 0)[1] == 0)
enough.set()
thread.join()
"""


def run(program):
    done = subprocess.run(
        [sys.executable, "-X", "faulthandler", "-c", program], capture_output=True, text=True,
        timeout=300,
    )
    assert done.returncode == 0 and done.stdout == "True\n", done.stdout + done.stderr


@pytest.mark.parametrize("before", ["", "union()"], ids=["first call", "later calls"])
def test_severalThreadsMayCallAtOnce(before):
    run(THREADS.replace("start, counts", f"{before}\nstart, counts"))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_aChildDoesNotWaitForAThreadThatItDoesNotHave():
    run(CHILDREN)
