# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions of the command line, in which names stand for files, as the filter reads them.

The filter knows layers by their ids: each name of a file becomes the id of its layer. What the
filter says of a place is brought back to the text as it was written.
"""

import itertools
import re

_WORD = re.compile(r'"(?:[^"\\]|\\.)*"?|[A-Za-z_][A-Za-z0-9_]*|[0-9]+|\S', re.ASCII | re.DOTALL)
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*", re.ASCII)
_PLACE = re.compile(r"Expression, line (\d+), column (\d+): (.*)\n.*\n *\^", re.DOTALL)
_RESERVED = (
    "visible", "all", "union", "intersection", "difference", "xor", "at_least", "winding", "odd",
    "positive", "nonzero",
)


class ExpressionError(Exception):
    """A text that does not read, with its place."""


def check_operand_name(name, kind="file"):
    """Raises ValueError if it cannot stand for a file, or a mesh, in an expression."""
    if not _NAME.fullmatch(name):
        raise ValueError(f"{name!r} is no name: a letter or _, then letters, digits and _")
    if name in _RESERVED:
        raise ValueError(f"{name!r} is a word of expressions and cannot be a {kind}'s name")


def default_names():
    """A, B, ..., Z, A1, B1, ..."""
    for turn in itertools.count():
        for letter in range(ord("A"), ord("Z") + 1):
            yield chr(letter) + (str(turn) if turn else "")


class ExpressionText:
    """A text, and the same as the filter reads it: `translated`.

    names are those of the files, or of what else `kind` says; a file's place among them is its
    layer's id. Raises ExpressionError where a statement is given a file's name.
    """

    def __init__(self, text, names, kind="file"):
        self.text = text
        self._starts = []  # (offset in translated, offset in text) of each word
        ids = {name: str(number) for number, name in enumerate(names)}
        words = list(_WORD.finditer(text))
        parts, length, end = [], 0, 0
        for word, following in itertools.zip_longest(words, words[1:]):
            blanks = text[end:word.start()]
            new = ids.get(word[0], word[0])
            if new != word[0] and following and following[0] == "=":
                raise ExpressionError(
                    self._at(word.start(), f'"{word[0]}" is the name of a {kind}, and cannot be '
                             "that of a statement")
                )
            parts += [blanks, new]
            self._starts.append((length + len(blanks), word.start()))
            length += len(blanks) + len(new)
            end = word.end()
        self.translated = "".join([*parts, text[end:]])
        self._starts.append((length, end))

    def statement_names(self):
        """The name of each statement, or None."""
        statements, words = [None], [word[0] for word in _WORD.finditer(self.text)]
        for number, word in enumerate(words):
            first = number == 0 or words[number - 1] == ";"
            if word == ";" and number + 1 < len(words):
                statements.append(None)
            elif first and _NAME.fullmatch(word) and words[number + 1:number + 2] == ["="]:
                statements[-1] = word
        return statements

    def explained(self, refusal):
        """The filter's refusal, its place that in the text."""
        found = _PLACE.fullmatch(refusal.strip())
        if not found:
            return refusal
        lines = self.translated.split("\n")[:int(found[1]) - 1]
        offset = sum(len(line) + 1 for line in lines) + int(found[2]) - 1
        start, place = max(pair for pair in self._starts if pair[0] <= offset)
        return self._at(min(place + offset - start, len(self.text)), found[3].rstrip("."))

    def _at(self, offset, problem):
        line = self.text.count("\n", 0, offset)
        begin = self.text.rfind("\n", 0, offset) + 1
        shown = self.text.split("\n")[line].replace("\t", " ")
        column = offset - begin
        return (
            f"Expression, line {line + 1}, column {column + 1}: {problem}.\n{shown}\n"
            f"{' ' * column}^"
        )
