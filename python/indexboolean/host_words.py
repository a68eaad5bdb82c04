# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: a refusal in the words of MeshLab's users; out: the same for users of the command line.

Nothing is selected there, and parameters and filters have other names.
"""

import re

_WORDS = (
    (r"(?<=\. )[^.]*\b(?:is|are) selected\. ", ""),
    (r'generate_index_boolean_(\w+) \("[^"]*"\)', r"the command \1"),
    (
        r"\b(self_intersections|winding_rule|weld_distance) = ([\w.+-]*\w)",
        lambda found: f"--{found[1].replace('_', '-')} {found[2]}",
    ),
    (r"With certify_as = host\b", "With another --format than stl"),
    (r"\bweld_distance\b", "--weld-distance"),
    (r"\bmerge_tolerance\b", "--merge-tolerance"),
    (r'"([^"]*)" \((meshing_\w+)\)', r"""MeshLab's "\1" (pymeshlab: \2)"""),
)


def in_words_of_the_command_line(sentences):
    """The sentences without what only holds for layers in a window."""
    for pattern, words in _WORDS:
        sentences = re.sub(pattern, words, sentences)
    return sentences
