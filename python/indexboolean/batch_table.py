# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: a CSV table of pairs, or of expressions; out: one Pair or Evaluation a row, or every row that
is wrong, with its line."""

import csv
import dataclasses
import math
import pathlib
import re
from typing import Optional

from .boolean_job import BLOCKS
from .evaluate_job import result_names
from .expression_text import ExpressionError, ExpressionText, check_operand_name, default_names

# The columns that the rows of each kind have, and may have.
PAIR_COLUMNS = ("first", "second"), (
    "name", "first_transform", "second_transform", "blocks", "job",
)
EVALUATION_COLUMNS = ("expression", "operands"), ("name",)
_OPERAND = re.compile(r'\s*(?:([^;="]+?)\s*=\s*)?("[^"]*"|[^;="]+?)\s*(?:;|$)')
KINDS = ("boolean", "distance")
_SHOWN = 10  # of the rows that are wrong
_AFFINE_LAST_ROW = (0.0, 0.0, 0.0, 1.0)


class TableError(Exception):
    """A table that cannot be read, or rows that make no pair; names each line."""


@dataclasses.dataclass(frozen=True)
class Pair:
    """One row: absolute paths, 4 x 4 matrices row by row (None: as the file is), block names (of a
    distance none), what is done."""

    name: str
    first: pathlib.Path
    second: pathlib.Path
    first_transform: Optional[tuple]
    second_transform: Optional[tuple]
    blocks: tuple
    kind: str = KINDS[0]


@dataclasses.dataclass(frozen=True)
class Evaluation:
    """One row: an expression, the absolute path of each operand by its name, results' names."""

    name: str
    expression: str
    operands: dict
    blocks: tuple


def read_table(path, default_blocks):
    """The rows of the table at path, whose files are relative to its folder: all of one kind.

    Raises TableError or OSError before any row is done: no file is opened but the table.
    """
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            reader = csv.DictReader(file, strict=True)
            row_of = _kind_of_rows(path, reader.fieldnames or ())
            rows = [(reader.line_num, row) for row in reader]
    except (csv.Error, UnicodeDecodeError) as error:
        raise TableError(f"{path} is no CSV table in UTF-8: {error}") from error
    pairs, wrong, names = [], [], {}
    for number, (line, row) in enumerate(rows, start=1):
        try:
            pair = row_of(_cells_of(row), number, path.absolute().parent, default_blocks)
            if pair.name in names:
                raise ValueError(f"line {names[pair.name]} has the name {pair.name!r}, too")
            names[pair.name] = line
            pairs.append(pair)
        except ValueError as error:
            wrong.append(f"line {line}: {error}")
    if wrong:
        more = [f"and {len(wrong) - _SHOWN} more"] if len(wrong) > _SHOWN else []
        raise TableError("\n".join([f"{path} has wrong rows:", *wrong[:_SHOWN], *more]))
    if not pairs:
        raise TableError(f"{path} has no rows below its header")
    return pairs


def _kind_of_rows(path, columns):
    """The function that reads a row, by the columns that the table has."""
    is_evaluation = any(column in columns for column in EVALUATION_COLUMNS[0])
    required, optional = EVALUATION_COLUMNS if is_evaluation else PAIR_COLUMNS
    absent = [column for column in required if column not in columns]
    unknown = [column for column in columns if column not in required + optional]
    if absent or unknown or len(set(columns)) < len(columns):
        raise TableError(
            f"{path}: the first line must name the columns {', '.join(required)} and may name "
            f"{', '.join(optional)}, each once; it names {', '.join(columns) or 'none'}"
        )
    return _evaluation_of if is_evaluation else _pair_of


def _cells_of(row):
    if None in row or None in row.values():
        raise ValueError("it has more or fewer cells than the header")
    row = {column: cell.strip() for column, cell in row.items()}
    for column in (*PAIR_COLUMNS[0], *EVALUATION_COLUMNS[0]):
        if row.get(column) == "":
            raise ValueError(f"{column} is empty")
    return row


def _evaluation_of(row, number, folder, _):
    operands = _operands_of(row["operands"], folder)
    try:
        blocks = result_names(ExpressionText(row["expression"], list(operands)))
    except ExpressionError as error:
        raise ValueError(str(error)) from error
    if len(set(blocks)) < len(blocks):
        raise ValueError("two results would have one file; give each statement a name of its own")
    return Evaluation(
        name=_name_of(row.get("name") or f"{number:04}"),
        expression=row["expression"],
        operands=operands,
        blocks=tuple(blocks),
    )


def _operands_of(text, folder):
    """{name: path} of files that semicolons separate, some with names of their own."""
    operands, names, end = {}, default_names(), 0
    while end < len(text):
        found = _OPERAND.match(text, end)
        if not found:
            raise ValueError(
                f"operands: {text[end:]!r} does not read; files are separated by semicolons, may "
                "have a name as in name=file, and those with ; or = are put in double quotes"
            )
        default = next(names)
        name = found[1] or default
        check_operand_name(name)
        if name in operands:
            raise ValueError(f"operands: two files have the name {name}")
        operands[name] = folder / found[2].strip('"')
        end = found.end()
    return operands


def _pair_of(row, number, folder, default_blocks):
    kind = row.get("job") or KINDS[0]
    if kind not in KINDS:
        raise ValueError(f"no job {kind!r}; there are {', '.join(KINDS)}")
    if kind == "distance" and row.get("blocks"):
        raise ValueError("a distance has no blocks")
    return Pair(
        name=_name_of(row.get("name") or f"{number:04}"),
        first=folder / row["first"],
        second=folder / row["second"],
        first_transform=_matrix_of("first_transform", row),
        second_transform=_matrix_of("second_transform", row),
        blocks=_blocks_of(row.get("blocks", ""), default_blocks) if kind == "boolean" else (),
        kind=kind,
    )


def _name_of(text):
    """The name of a folder beside those of the other jobs."""
    if not re.fullmatch(r"[\w(][\w .,+=()-]*", text) or text.endswith("."):
        raise ValueError(
            f"{text!r} cannot be a folder's name here: take letters, digits, spaces and _ . - + ="
        )
    return text


def _matrix_of(column, row):
    """The 16 numbers of a 3 x 4 or 4 x 4 matrix; None if the cell is empty or absent."""
    words = re.split(r"[\s,;]+", row.get(column, "").strip("[]() "))
    if words == [""]:
        return None
    numbers = tuple(float(word) for word in words)
    if len(numbers) == 12:
        numbers += _AFFINE_LAST_ROW
    if len(numbers) != 16:
        raise ValueError(f"{column} has {len(numbers)} numbers; 12 or 16 make a matrix")
    if not all(map(math.isfinite, numbers)):
        raise ValueError(f"{column} has a number that is not finite")
    if numbers[12:] != _AFFINE_LAST_ROW:
        raise ValueError(f"{column}: the last row of a 4 x 4 matrix must be 0 0 0 1")
    return numbers


def _blocks_of(text, default_blocks):
    names = re.split(r"[\s,;]+", text) if text else default_blocks
    for name in names:
        if name not in BLOCKS:
            raise ValueError(f"no block {name!r}; there are {', '.join(BLOCKS)}")
    return tuple(block for block in BLOCKS if block in names)
