# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One thread at a time in pymeshlab.

The host lets other threads run while a filter does, but all its filters write to one log, which
several threads at once destroy, and the process with it.
"""

import os
import threading

_lock = threading.RLock()


def host_lock():
    """What to hold (`with host_lock():`) around calls of pymeshlab; a thread may hold it twice."""
    return _lock


def _renew():
    global _lock
    _lock = threading.RLock()


if hasattr(os, "register_at_fork"):
    # Whoever held it has no thread in the child.
    os.register_at_fork(after_in_child=_renew)
