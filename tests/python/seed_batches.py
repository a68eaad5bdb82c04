# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many random cases in few tests: every case of a batch is tried, and those that fail are named."""


def check_batch(batch, size, check):
    """Calls check(seed) for the `size` seeds of a batch; fails with those at which it raised."""
    seeds = range(batch * size, (batch + 1) * size)
    print(f"seeds {seeds.start} to {seeds.stop - 1}")
    failures = []
    for seed in seeds:
        try:
            check(seed)
        except Exception as failure:
            reason = str(failure).splitlines()[0]
            failures.append(f"seed {seed}: {type(failure).__name__}: {reason}")
    assert not failures, f"{len(failures)} of {len(seeds)} pairs:\n" + "\n".join(failures)
