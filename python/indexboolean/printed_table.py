# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How all commands lay out the tables that they print."""

from rich import box
from rich.table import Column, Table


def new_table(*columns):
    """A table whose first column is text, the others numbers."""
    numbers = [Column(name, justify="right", no_wrap=True) for name in columns[1:]]
    return Table(
        Column(columns[0], no_wrap=True), *numbers, box=box.SIMPLE_HEAD, pad_edge=False
    )
