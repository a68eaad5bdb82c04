# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tree passes what .pre-commit-config.yaml has each commit checked by, at the same versions."""

import re
import subprocess
import sys
from pathlib import Path

import pytest
from cpp_functions import functions_of

ROOT = Path(__file__).resolve().parents[2]
TOOLS = Path(sys.prefix) / "bin"


def sources(*suffixes):
    folders = ("bench", "filter_indexboolean", "tests", "vcg_ext")
    return [
        path for folder in folders for path in sorted((ROOT / folder).rglob("*"))
        if path.suffix in suffixes
    ]


def test_cppIsFormatted():
    files = sources(".cpp", ".h")
    assert len(files) > 100
    done = subprocess.run(
        [TOOLS / "clang-format", "--dry-run", "-Werror", "--style=file", *files], cwd=ROOT,
        capture_output=True, text=True, timeout=120,
    )
    assert done.returncode == 0, done.stderr[-3000:]


MOST_LINES, MOST_PARAMETERS = 60, 6


def beyond_the_limits(text):
    """The functions with too many lines or parameters, as sentences."""
    return [
        f"line {f.line}: {f.name} has {f.lines} lines and {f.parameters} parameters"
        for f in functions_of(text) if f.lines > MOST_LINES or f.parameters > MOST_PARAMETERS
    ]


def test_noFunctionHasMoreThan60LinesOr6Parameters():
    texts = {
        path.relative_to(ROOT): path.read_text() for path in sources(".cpp", ".h")
        if not path.is_relative_to(ROOT / "tests")
    }
    assert sum(len(functions_of(text)) for text in texts.values()) > 1000
    found = [f"{path}, {each}" for path, text in texts.items() for each in beyond_the_limits(text)]
    assert not found, "\n".join(found)


SEVEN = "std::map<int, int> a, int b = f(1, 2), int (*c)(int, int), int d, int e, int f, int g"


@pytest.mark.parametrize("beyond", [
    f"int f({SEVEN}) {{ return '{{'; }}",
    f"template <class T>\nauto T::f({SEVEN}) const noexcept -> int {{}}",
    f"Name::Name({SEVEN})\n    : Base<int>(a), b_{{b}}, c_(\"{{\") {{}}",
    f"bool operator()({SEVEN}) {{}}",
    f"void g() {{\n\tcall([&]({SEVEN}) mutable {{}});\n}}",
    "int f(int a) {" + 60 * "\n" + "}",
    "int f(int a) try {" + 58 * "\n" + "} catch (const E& e) {\n\t// }\n}",
])
def test_aFunctionBeyondTheLimitsIsFound(beyond):
    assert len(beyond_the_limits(f"namespace n {{\n{beyond}\n}}")) == 1


@pytest.mark.parametrize("within", [
    f"int f({SEVEN.removesuffix(', int g')}) {{}}",
    f"int f({SEVEN});",
    f"// int f({SEVEN}) {{}}",
    "int f() { return g(1, 2, 3, 4, 5, 6, 7); }",
    "if (f(1, 2, 3, 4, 5, 6, 7)) {}",
    "int f(int a) {" + 59 * "\n" + "}",
    "TEST(Name, test) {" + 60 * "\n" + "}",
    "namespace n {" + 60 * "\n" + "}",
])
def test_aFunctionWithinTheLimitsIsLeftInPeace(within):
    assert not beyond_the_limits(within)


# Each wing may include itself and those before it.
WINGS = {
    "vcg_ext": ("base", "exact", "mesh", "arrange", "carry", "parts", "solids", "distance", ""),
    "filter_indexboolean": ("runs", "texts", "layers", "attributes", "filters", "hosts"),
}


def wing_of(path):
    """The wing of a file given by its place below the folder of the wings; '': the top."""
    return path.split("/")[0] if "/" in path else ""


def own_includes(folder, path):
    """The wings of the files of the same folder that a file includes."""
    for name in re.findall(r'^#include [<"]([^">]+)[">]', path.read_text(), re.M):
        if folder == "vcg_ext" and name.startswith("vcg_ext/"):
            yield name, wing_of(name.removeprefix("vcg_ext/"))
        elif folder != "vcg_ext" and wing_of(name) in WINGS[folder]:
            yield name, wing_of(name)


@pytest.mark.parametrize("folder", WINGS)
def test_filesIncludeNothingBehindTheirWing(folder):
    order = WINGS[folder]
    included = 0
    for path in (ROOT / folder).rglob("*.*"):
        if path.suffix not in (".cpp", ".h"):
            continue
        own = order.index(wing_of(path.relative_to(ROOT / folder).as_posix()))
        for name, wing in own_includes(folder, path):
            included += 1
            assert order.index(wing) <= own, f"{path}: {name}"
    assert included > 50


def test_theFilterKnowsThePublicHeadersOnly():
    """index_boolean.h; and, to read and write layers, the templates on vcglib's meshes."""
    public = {"vcg_ext/index_boolean.h", "vcg_ext/mesh/mesh_arrays_vcg.h"}
    for path in sources(".cpp", ".h"):
        if path.is_relative_to(ROOT / "filter_indexboolean"):
            names = re.findall(r'^#include [<"](vcg_ext/[^>"]+)', path.read_text(), re.M)
            assert set(names) <= public, path


def test_pythonPassesRuff():
    done = subprocess.run(
        [TOOLS / "ruff", "check", "--no-cache", "bench", "python", "sample_meshes", "tests",
         "tools"], cwd=ROOT, capture_output=True, text=True, timeout=120,
    )
    assert done.returncode == 0, done.stdout[-3000:]


@pytest.mark.parametrize("tool", ["clang-format", "ruff"])
def test_hooksHaveTheVersionsOfTheEnvironment(tool):
    pinned = re.search(rf"^{tool}==\S+$", (ROOT / "tools/requirements.txt").read_text(), re.M)[0]
    assert f"[{pinned}]" in (ROOT / ".pre-commit-config.yaml").read_text()


NO_FUNCTION = ("struct", "class", "enum", "using", "namespace", "friend", "extern", "static_assert",
               "constexpr std::", "typedef")


def top_level_functions(text):
    """(name, comment, code up to its body or end) of the functions of a header, but for members.

    A comment holds for all functions that follow it without a blank line.
    """
    depth, comment, code = 0, [], []
    for line in text.split("\n"):
        if depth == 0 and not code and line.startswith("//"):
            comment.append(line)
        elif depth == 0 and not code and line.startswith("#"):
            continue
        elif depth == 0 and not code and (not line.strip() or line.startswith("namespace")):
            comment = []
        elif depth == 0 and line.startswith("}"):
            continue
        else:
            statement = line.split("//")[0]
            if depth == 0:
                code.append(statement)
            depth += statement.count("{") - statement.count("}")
            if depth == 0 and statement.rstrip().endswith((";", "}")):
                whole = " ".join(code)
                whole = re.sub(r"^template <[^{]*?> (?=\\w)", "", whole)
                head = whole.split("{")[0]
                found = re.search(r"\b(\w+|operator\S+)\(", head)
                is_member = "::" in head.split("(")[0].split(" ")[-1]
                is_named = found and not whole.startswith(NO_FUNCTION) and not is_member
                if is_named and "=" not in head.split("(")[0]:
                    yield found[1], "\n".join(comment), whole
                code = []


@pytest.mark.parametrize(
    "header", sorted((ROOT / "vcg_ext").rglob("*.h")), ids=lambda path: path.name)
def test_publicFunctionsSayWhatTheyDoAndCost(header):
    """Purpose on each; on those defined elsewhere the errors and the complexity, too.

    Where all functions of a header cost the same, its head may say so once.
    """
    text = header.read_text()
    head = text.split("#pragma once")[0]
    lacking = []
    for name, comment, code in top_level_functions(text.split("#pragma once")[1]):
        if not comment and not name.startswith("operator"):
            lacking.append(f"{name}: a comment")
        elif "{" in code:
            continue
        elif "Complexity" not in comment + head:
            lacking.append(f"{name}: its complexity")
        elif code.startswith("Status ") and "\\return" not in comment:
            lacking.append(f"{name}: which errors it returns")
    assert not lacking
