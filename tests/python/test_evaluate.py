# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m indexboolean evaluate, resolve, and batch with expressions: files, names, statuses."""

import itertools
import json

import numpy as np
import pymeshlab
import pytest

import batch_support
from conftest import box, crossing_bars
from indexboolean.expression_text import ExpressionError, ExpressionText, default_names
from test_command_line import files_of, load, run, volume

ROW = [box((k, 0, 0), (k + 2, 2, 2)) for k in range(3)]


@pytest.fixture
def files(tmp_path):
    """NAME=FILE for three boxes in a row, a, b and c."""
    named = []
    for name, mesh in zip("abc", ROW):
        path = tmp_path / f"{name} = box;.ply"
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(*mesh))
        meshes.save_current_mesh(str(path))
        named.append(f"{name}={path}")
    return named


class TestEvaluate:
    def test_aFileForEachStatement(self, tmp_path, files):
        text = "walls = a - b; at_least(2, all); rest = c - walls - b"
        done = run("evaluate", text, *files, "-o", tmp_path / "out")
        assert done.returncode == 0, done.stderr
        written = files_of(tmp_path / "out")
        assert written == ["rest.ply", "result.json", "result_1.ply", "walls.ply"]
        record = json.loads((tmp_path / "out" / "result.json").read_text())
        assert record["files"] == {
            "result_0": "walls.ply", "result_1": "result_1.ply", "result_2": "rest.ply",
        }
        assert record["expression"] == text and list(record["operand_files"]) == ["a", "b", "c"]
        assert record["results"] == 3
        for name, wanted in (("walls", 4), ("result_1", 8), ("rest", 4)):
            assert volume(*load(tmp_path / "out" / f"{name}.ply")) == pytest.approx(wanted)

    def test_idsArePositionsAndVisibleIsAll(self, tmp_path, files):
        done = run("evaluate", "2 - b; union(visible)", *files, "-o", tmp_path / "out")
        assert done.returncode == 0, done.stderr
        assert volume(*load(tmp_path / "out/result_0.ply")) == pytest.approx(4)
        assert volume(*load(tmp_path / "out/result_1.ply")) == pytest.approx(16)

    def test_stlIsCertifiedAsFloat(self, tmp_path, files):
        done = run("evaluate", "all_of = union(all)", *files, "-o", tmp_path, "--format", "stl")
        assert done.returncode == 0, done.stderr
        assert "single precision" in done.stderr
        assert (tmp_path / "all_of.stl").stat().st_size > 84

    @pytest.mark.parametrize(
        ("text", "column", "shown", "sentence"),
        [
            ("a - longer", 5, "a - longer", 'defines the name "longer"'),
            ("a - b - 7", 9, "a - b - 7", "no layer with id 7"),
            ("a |", 4, "a |", "the text ends"),
            ("x = a; b = 1", 8, "x = a; b = 1", 'name of a file'),
        ],
    )
    def test_refusalsShowTheTextAsWritten(self, tmp_path, files, text, column, shown, sentence):
        done = run("evaluate", text, *files, "-o", tmp_path / "out")
        assert done.returncode == 1
        first, line, caret = done.stderr.rstrip("\n").split("\n")[-3:]
        assert f"column {column}: " in first and sentence in first
        assert line == shown and caret == " " * (column - 1) + "^"

    @pytest.mark.parametrize("operand", ["a", "a=", "union=x.ply", "1a=x.ply", "=x.ply"])
    def test_usage(self, tmp_path, operand):
        assert run("evaluate", "0", operand, "-o", tmp_path).returncode == 2

    def test_namesAreUnique(self, tmp_path, files):
        assert run("evaluate", "a", *files, files[0], "-o", tmp_path / "o").returncode == 2
        done = run("evaluate", "a; result_0 = b", *files, "-o", tmp_path / "o")
        assert done.returncode == 1 and "one file" in done.stderr


class TestTexts:
    @pytest.mark.parametrize(
        ("text", "translated"),
        [
            ("a - b", "0 - 1"), ('"a" - b', '"a" - 1'), (r'"\"a" | a', r'"\"a" | 0'),
            ("ab|a*a2", "ab|0*2"), ("union(a,\n b)", "union(0,\n 1)"), ("x=a;x", "x=0;x"),
        ],
    )
    def test_namesBecomeIds(self, text, translated):
        assert ExpressionText(text, ["a", "b", "a2"]).translated == translated

    def test_placesAreThoseOfTheText(self):
        names = [f"long_{number}" for number in range(12)]
        text = ExpressionText("long_0 -\n  long_11 - (oops", names)
        assert text.translated == "0 -\n  11 - (oops"
        explained = text.explained(
            'Expression, line 2, column 9: no such name.\n  11 - (oops\n        ^'
        )
        assert explained == (
            "Expression, line 2, column 14: no such name.\n  long_11 - (oops\n             ^"
        )
        assert text.explained("Layer 3 is open.") == "Layer 3 is open."

    def test_statementNames(self):
        text = ExpressionText('x = "; y = 1"; 0 ; z=1;', [])
        assert text.statement_names() == ["x", None, "z"]
        with pytest.raises(ExpressionError, match="line 1, column 4: "):
            ExpressionText("0; a = 1", ["a"])

    def test_defaultNames(self):
        names = list(itertools.islice(default_names(), 54))
        assert names[:2] + names[25:28] + names[52:] == ["A", "B", "Z", "A1", "B1", "A2", "B2"]


def test_resolve(tmp_path):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*crossing_bars()))
    meshes.save_current_mesh(str(tmp_path / "bars.ply"))
    done = run("resolve", tmp_path / "bars.ply", "-o", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert files_of(tmp_path / "out") == ["resolved.ply", "result.json"]
    assert volume(*load(tmp_path / "out" / "resolved.ply")) == pytest.approx(8.0625)
    done = run("resolve", tmp_path / "bars.ply", "--winding-rule", "odd", "-o", tmp_path / "odd")
    assert volume(*load(tmp_path / "odd" / "resolved.ply")) == pytest.approx(7.125)
    done = run("resolve", tmp_path / "bars.ply", "--outer-hull", "-o", tmp_path / "hull")
    assert volume(*load(tmp_path / "hull" / "resolved.ply")) == pytest.approx(8.0625)
    assert run("resolve", tmp_path / "none.ply", "-o", tmp_path).returncode == 1


class TestBatch:
    COLUMNS = ("name", "expression", "operands")

    def test_expressionsAndOperands(self, tmp_path, files):
        paths = [file.partition("=")[2] for file in files]
        quoted = [f'"{path}"' for path in paths]
        rows = [
            ("letters", "A - B", f"{quoted[0]}; {quoted[1]}"),
            ("names", "walls = first - B; union(all)", ";".join(
                [f"first={quoted[0]}", quoted[1], quoted[2]])),
            ("open text", "A -", quoted[0]),
        ]
        table = batch_support.write_table(tmp_path / "jobs.csv", rows, self.COLUMNS)
        done = batch_support.run(table, tmp_path / "out")
        assert done.returncode == 3, done.stderr
        found = batch_support.results(tmp_path / "out")
        assert found["letters"]["status"] == "done" and found["letters"]["expression"] == "A - B"
        assert float(found["letters"]["result_0_volume"]) == pytest.approx(4)
        assert float(found["names"]["walls_volume"]) == pytest.approx(4)
        assert float(found["names"]["result_1_volume"]) == pytest.approx(16)
        assert found["names"]["walls_self_intersections"] == "0"
        assert found["open text"]["status"] == "refused"
        assert "column 4: the text ends" in found["open text"]["message"]
        assert files_of(tmp_path / "out" / "names") == [
            "job.json", "result.json", "result_1.ply", "walls.ply",
        ]
        again = batch_support.run(table, tmp_path / "out")
        assert "3 of 3 jobs are finished already" in again.stderr

    def test_anOtherExpressionIsDoneAgainAndLeavesNoFiles(self, tmp_path, files):
        path = files[0].partition("=")[2]
        for text in ("old = A", "new = A"):
            table = batch_support.write_table(
                tmp_path / "jobs.csv", [("job", text, f'"{path}"')], self.COLUMNS
            )
            assert batch_support.run(table, tmp_path / "out").returncode == 0
        assert files_of(tmp_path / "out" / "job") == ["job.json", "new.ply", "result.json"]

    @pytest.mark.parametrize(
        ("expression", "operands", "problem"),
        [
            ("A", "", "operands is empty"), ("", "a.ply", "expression is empty"),
            ("A", "a.ply;;b.ply", "does not read"), ("A", "x=a.ply;x=b.ply", "the name x"),
            ("A", "union=a.ply", "is a word"), ("A", 'a"b.ply', "does not read"),
            ("A = 1", "a.ply", "name of a file"), ("A; result_0 = A", "a.ply", "one file"),
        ],
    )
    def test_wrongRows(self, tmp_path, expression, operands, problem):
        table = batch_support.write_table(
            tmp_path / "jobs.csv", [("job", expression, operands)], self.COLUMNS
        )
        done = batch_support.run(table, tmp_path / "out")
        assert done.returncode == 1 and "line 2: " in done.stderr and problem in done.stderr

    def test_columnsOfOneKind(self, tmp_path):
        table = batch_support.write_table(
            tmp_path / "jobs.csv", [("a.ply", "A", "b.ply")], ("first", "expression", "operands")
        )
        done = batch_support.run(table, tmp_path / "out")
        assert done.returncode == 1 and "must name the columns expression, operands" in done.stderr


def test_arraysAreReadable(tmp_path, files):
    """A layer's numbers survive the file: what is read back is what was certified."""
    run("evaluate", "union(all)", *files, "-o", tmp_path / "out")
    vertices, faces = load(tmp_path / "out" / "result_0.ply")
    assert np.isfinite(vertices).all() and len(faces) >= 12
