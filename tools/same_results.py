# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares what two builds of the plugin for pymeshlab make, byte for byte.

in: two plugins; out: their lists of hashes in out/same_results/before.txt and after.txt, the lines
that differ, and the exit status: 1 if any differs, or is in one list only, or if a case has ended
its process, other than those of excepted cases; 2 if there are no lists to compare.
"""

import argparse
import fnmatch
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDER = ROOT / "out" / "same_results"
PROGRAM = ROOT / "tests" / "python" / "result_hashes.py"
ENDED = " - - ended"


def write_list(plugin, cases, path):
    """Runs all cases with a plugin and writes its list."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", encoding="utf-8") as file:
        command = [sys.executable, str(PROGRAM), plugin, "--cases", cases]
        if subprocess.run(command, stdout=file).returncode != 0:
            sys.exit(2)


def read_list(path):
    """{what is hashed: hash}, in the order of the list."""
    lines = path.read_text(encoding="utf-8").splitlines()
    return dict(line.rsplit(" ", 1) for line in lines)


def compare(before, after):
    """(How many entries are equal, the names of those that are not or that one list lacks.)

    A process that has ended is never equal: all that would have come after it is unknown.
    """
    names = list({**before, **after})
    differing = [n for n in names if before.get(n) != after.get(n) or n.endswith(ENDED)]
    return len(names) - len(differing), differing


def what_differs(name, before, after):
    """In words, an entry that is not equal."""
    if name.endswith(ENDED):
        return "not run to its end"
    if name not in before:
        return "new"
    return "differs" if name in after else "gone"


def report(before, after, exceptions):
    """Prints the comparison; how many entries differ that are not excepted."""
    equal, differing = compare(before, after)
    unexpected = 0
    for name in differing:
        case = name.split(" ", 1)[0]
        excepted = any(fnmatch.fnmatchcase(case, pattern) for pattern in exceptions)
        unexpected += not excepted
        print(f"{what_differs(name, before, after)}{' (excepted)' * excepted}: {name}")
    print(
        f"{equal} results are equal, {unexpected} differ, "
        f"{len(differing) - unexpected} more differ in excepted cases"
    )
    return unexpected


def main():
    parser = argparse.ArgumentParser(prog="same_results", description=__doc__.splitlines()[0])
    parser.add_argument("before", help="the plugin to compare with")
    parser.add_argument("after")
    parser.add_argument("--cases", default="", help="only cases whose name contains this")
    parser.add_argument(
        "--except", dest="exceptions", action="append", default=[], metavar="CASE",
        help="a case that may differ, or a pattern of names like 'contacts/*'; may be repeated",
    )
    args = parser.parse_args()

    lists = []
    for name in ("before", "after"):
        path = FOLDER / f"{name}.txt"
        write_list(getattr(args, name), args.cases, path)
        lists.append(read_list(path))
    if not any(lists):
        print(f"same_results: no case has {args.cases!r} in its name", file=sys.stderr)
        sys.exit(2)
    sys.exit(1 if report(*lists, args.exceptions) else 0)


if __name__ == "__main__":
    main()
