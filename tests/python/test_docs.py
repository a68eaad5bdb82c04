# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the documents claim of the code: stages in order, links that exist, programs that run."""

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").glob("*.md"))]
SAMPLES = ROOT / "sample_meshes"
sys.path.append(str(ROOT / "tools"))

import readme_benchmark  # noqa: E402


def wing_tables():
    """{wing: [(stage, file)]} of the architecture page."""
    text = (ROOT / "docs" / "architecture.md").read_text()
    tables = text.split("<!-- stages -->")[1].split("<!-- /stages -->")[0]
    wings = {}
    for part in tables.split("**`vcg_ext/")[1:]:
        rows = [line.split("|") for line in part.splitlines() if line.startswith("|")][2:]
        wings[part.split("/")[0]] = [(row[1].strip(), row[2].strip(" `")) for row in rows]
    return wings


def stages():
    return [stage for table in wing_tables().values() for stage, _ in table]


def drivers_stages():
    driver = (ROOT / "vcg_ext" / "index_boolean.cpp").read_text()
    # A stage that both kinds of arrangement have is written twice.
    return [*dict.fromkeys(re.findall(r'stages\.run\("(\w+)"', driver)), "audit", "attributes"]


def test_stageTablesHaveTheDriversStagesInTheDriversOrder():
    run = drivers_stages()
    assert sorted(stages()) == sorted(run)
    for wing, table in wing_tables().items():
        assert [stage for stage, _ in table] == [
            stage for stage in run if stage in dict(table)
        ], wing


def test_everyStageIsAFilePairOfItsWing():
    for wing, table in wing_tables().items():
        for _, name in table:
            assert (ROOT / "vcg_ext" / wing / f"{name}.h").is_file(), name
            assert (ROOT / "vcg_ext" / wing / f"{name}.cpp").is_file(), name


def test_movedFilesAreWhereThePageSays():
    page = (ROOT / "docs" / "moved_files.md").read_text()
    places = re.findall(r"`((?:vcg_ext|filter_indexboolean)/[\w/]+\.h)`", page)
    assert len(places) > 70
    assert not [place for place in places if not (ROOT / place).is_file()]


def test_dataFlowHasEveryStageAndNoOther():
    source = (ROOT / "docs" / "data_flow.dot").read_text()
    drawn = re.findall(r"<title>(\w+)</title>", (ROOT / "docs" / "data_flow.svg").read_text())
    materials = {"layers", "solids", "pieces", "lines"}
    assert {name for name in drawn if not name.startswith(("cluster", "data_flow"))} == (
        set(stages()) | materials
    )
    assert all(re.search(rf"\b{name}\b", source) for name in drawn)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_to_files(page):
    links = re.findall(r"\]\((?!https?:|#)([^)#]+)", page.read_text())
    missing = [link for link in links if not (page.parent / link).exists()]
    assert not missing


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_paths_named_in_code_style_exist(page):
    known = (
        "vcg_ext/", "filter_indexboolean/", "tests/", "tools/", "bench/", "sample_meshes/", "docs/",
        "python/",
    )
    named = re.findall(r"`([\w./-]+)[^`]*`", page.read_text())
    missing = [n for n in named if n.startswith(known) and not (ROOT / n).exists()]
    assert not missing


def links_of(page):
    """The files that a page links to."""
    named = re.findall(r"\]\((?!https?:|#)([^)#]+)", page.read_text())
    return {(page.parent / name).resolve() for name in named}


def test_threeLinksLeadToWhereAFacesTriangulationIsDecidedAndToItsRule():
    reached = {ROOT / "README.md"}
    for _ in range(3):
        pages = [page for page in reached if page.suffix == ".md"]
        if ROOT / "vcg_ext/arrange/retriangulate.h" in reached:
            break
        reached = reached.union(*map(links_of, pages))
    assert ROOT / "vcg_ext/arrange/retriangulate.h" in reached
    page = (ROOT / "docs/architecture.md").read_text()
    row = re.search(r"^\| where is a face's triangulation decided\? .*$", page, re.M)[0]
    assert "base to arrange" in row
    wings = "base < exact < mesh < arrange < carry < parts < solids < distance < index_boolean"
    assert wings in page


def glossary():
    """[(word, header)] of the architecture page."""
    section = (ROOT / "docs/architecture.md").read_text().split("\n## Glossary\n")[1]
    rows = re.findall(r"^\| ([^|]+) \| [^|]+ \| `([^`]+)` \|$", section.split("\n## ")[0], re.M)
    return [(word.strip(), header) for words, header in rows for word in words.split(",")]


def test_eachWordOfTheGlossaryStandsInItsHeader():
    words = glossary()
    assert len(words) >= 30 and len(dict(words)) == len(words)
    for word, header in words:
        stem = word.removesuffix("s").replace("-", "[- ]?").replace(" ", "[ \n/]*")
        text = (ROOT / header).read_text()
        assert re.search(stem, text, re.I), (word, header)


def test_theArrangementNamesTheStageThatFillsEachField():
    header = (ROOT / "vcg_ext/arrange/arrangement.h").read_text()
    for struct in ("Curve", "Refinement", "Labels", "Arrangement"):
        body = re.search(rf"^struct {struct} {{\n(.*?)^}};", header, re.M | re.S)[1]
        first = body.lstrip().splitlines()[0]
        named = re.findall(r"^\t// .*?\[(\w+)\]", body, re.M)
        assert first.startswith("// ["), struct
        assert named and set(named) <= set(stages()), struct


def test_picturesAreSmall():
    pictures = list((ROOT / "docs").glob("*.png"))
    assert pictures and all(picture.stat().st_size < 300_000 for picture in pictures)


def test_readmeShowsAnExtractOfTheBenchmark():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert readme == readme_benchmark.readme_with_extract(), "run tools/readme_benchmark.py"


def run_program(code, folder):
    """What a program of a page prints, in a fresh folder beside the sample meshes."""
    (folder / "sample_meshes").symlink_to(SAMPLES)
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_readmeExampleRuns(tmp_path):
    code = (ROOT / "README.md").read_text().split("```python\n")[1].split("```")[0]
    volume, residual = run_program(code, tmp_path).split()[-2:]
    assert float(volume) == pytest.approx(3.151693102184, rel=1e-11)
    assert float(residual) < 1e-12
    assert (tmp_path / "difference.ply").stat().st_size > 0


def recipes():
    """(heading, program, what it prints) of each recipe of the cookbook."""
    sections = (ROOT / "docs" / "cookbook.md").read_text().split("\n## ")[1:]
    for section in sections:
        code = section.split("```python\n")[1].split("```")[0]
        printed = section.split("```text\n")[1].split("```")[0]
        yield pytest.param(code, printed, id=section.splitlines()[0].replace(" ", "_"))


@pytest.mark.parametrize("code, printed", list(recipes()))
def test_recipesPrintWhatTheySay(code, printed, tmp_path):
    (tmp_path / "out").mkdir()
    assert run_program(code, tmp_path) == printed


def programs_with_output(*pages):
    """(program, what it prints) of each program of the pages; all have what they print below."""
    for page in pages:
        text = (ROOT / "docs" / page).read_text()
        programs = re.findall(r"```python\n(.*?)```\n\n```text\n(.*?)```", text, re.S)
        assert len(programs) == text.count("```python\n"), page
        for number, (code, printed) in enumerate(programs):
            yield pytest.param(code, printed, id=f"{page}-{number}")


@pytest.mark.parametrize("code, printed", list(programs_with_output(
    "libraries.md", "from_trimesh.md", "from_pyvista.md", "from_meshio.md"
)))
def test_programsOnTheLibrariesPagesPrintWhatTheySay(code, printed, tmp_path):
    without_scipy = "import sys; sys.modules['scipy'] = None\n"  # which nothing here depends on
    assert run_program(without_scipy + code, tmp_path) == printed


def commands():
    """Each command line of this package on the pages, but for those that need a cluster."""
    lines = {}
    for page in PAGES:
        for line in re.findall(r"^ {4}(python -m indexboolean .*)$", page.read_text(), re.M):
            if "--scheduler" not in line:
                lines.setdefault(line, page.name)
    return lines


@pytest.mark.parametrize("line", list(commands()))
def test_commandsOnThePagesRun(line, tmp_path):
    for name, sample in (
        ("A.ply", "wide_cylinder"), ("B.ply", "narrow_cylinder"), ("statue.ply", "statue"),
        ("sheet.ply", "wavy_cutter"),
    ):
        (tmp_path / name).symlink_to(SAMPLES / f"{sample}.ply")
    write_stl(SAMPLES / "narrow_cylinder.ply", tmp_path / "B.stl")
    (tmp_path / "JOBS.csv").write_text("first,second\nA.ply,B.ply\n")
    words = shlex.split(line.replace("DIR", "out"))[1:]
    done = subprocess.run(
        [sys.executable, *words], cwd=tmp_path, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    assert any((tmp_path / "out").iterdir())


def write_stl(source, path):
    """In a process of its own: once a filter has refused in this one, the host may not load."""
    program = "import pymeshlab, sys; m = pymeshlab.MeshSet(); m.load_new_mesh(sys.argv[1])"
    program += "; m.save_current_mesh(sys.argv[2])"
    subprocess.run([sys.executable, "-c", program, source, path], check=True, capture_output=True)


def test_exampleTableOfTheBatchPageRuns(tmp_path):
    table = (ROOT / "docs" / "batch.md").read_text().split("```text\n")[1].split("```")[0]
    for sample in SAMPLES.glob("*.ply"):
        (tmp_path / sample.name).symlink_to(sample)
    (tmp_path / "JOBS.csv").write_text(table)
    done = subprocess.run(
        [sys.executable, "-m", "indexboolean", "batch", "JOBS.csv", "-o", "out"],
        cwd=tmp_path, capture_output=True, text=True, timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "as they are", "moved", "a hole", "results.csv",
    }
