# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: C++ source text; out: the functions that it defines, with their lines and parameters.

By brackets alone, without a compiler: good for code that clang-format has formatted. Lambdas count
as functions; the bodies of GoogleTest's macros do not."""

import re
from dataclasses import dataclass

# What is not code, and what is no bracket of the code: comments, literals, directives.
NOT_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^\s()\\]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
# What may stand before a list of parameters.
CANDIDATE = re.compile(r"(?P<name>operator\s*(?:\(\)|[^\s\w(]+)|~?[A-Za-z_]\w*|\])\s*\(")
NO_FUNCTION = re.compile(
    r"if|for|while|switch|catch|return|sizeof|alignof|alignas|decltype|noexcept|constexpr"
    r"|static_assert|TEST(_\w+)?")
QUALIFIER = re.compile(r"\s*(?:(?:const|override|final|mutable|noexcept|try)\b|&&?)")
RESULT_TYPE = re.compile(r"\s*->\s*[\w:<>,\s*&]+")
MEMBER = re.compile(r"\s*[\w:]+\s*(?:<[^(){};]*>)?\s*(?=[({])")
CLOSING = {"(": ")", "{": "}"}


@dataclass
class Function:
    name: str
    line: int  # of its name, from 1
    lines: int  # from there to the end of its body
    parameters: int


def bare(text):
    """The code, and blanks in place of all else; lines and columns stay."""
    return NOT_CODE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def end_of(code, begin):
    """The place behind the bracket that closes the one at `begin`."""
    opening, depth = code[begin], 0
    for place in range(begin, len(code)):
        if code[place] == opening:
            depth += 1
        elif code[place] == CLOSING[opening]:
            depth -= 1
            if depth == 0:
                return place + 1
    raise ValueError(f"a bracket without its end: {code[begin:begin + 60]}")


def parameter_count(parameters):
    """Of the text between the brackets."""
    depth, commas = 0, 0
    for letter in parameters.replace("->", "  "):
        depth += (letter in "([{<") - (letter in ")]}>")
        commas += letter == "," and depth == 0
    return 0 if parameters.strip() in ("", "void") else commas + 1


def body_begin(code, place):
    """Where the body opens of the function whose parameters end at `place`; None: it has none."""
    while match := QUALIFIER.match(code, place) or RESULT_TYPE.match(code, place):
        place = match.end()
    if match := re.compile(r"\s*:(?!:)").match(code, place):  # the members of a constructor
        place = match.end()
        while match := MEMBER.match(code, place):
            place = end_of(code, match.end())
            if not (comma := re.compile(r"\s*,").match(code, place)):
                break
            place = comma.end()
    match = re.compile(r"\s*\{").match(code, place)
    return match.end() - 1 if match else None


def body_end(code, begin):
    """Behind the body that opens at `begin`, and what it catches, if it is a try block."""
    end = end_of(code, begin)
    while match := re.compile(r"\s*catch\s*(?=\()").match(code, end):
        end = end_of(code, code.index("{", end_of(code, match.end())))
    return end


def functions_of(text):
    """All functions with a body, in the order of their names."""
    code = bare(text)
    found = []
    for match in CANDIDATE.finditer(code):
        if NO_FUNCTION.fullmatch(match["name"]):
            continue
        opening = match.end() - 1
        closing = end_of(code, opening)
        body = body_begin(code, closing)
        if body is not None:
            found.append(Function(
                "a lambda" if match["name"] == "]" else match["name"],
                code.count("\n", 0, match.start()) + 1,
                code.count("\n", match.start(), body_end(code, body)) + 1,
                parameter_count(code[opening + 1:closing - 1]),
            ))
    return found
