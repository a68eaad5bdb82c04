# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: a refusal in the words of MeshLab's users; out: the same for users of the command line, or of
the functions on other libraries' meshes.

Nothing is selected there, and parameters and filters have other names.
"""

import re

_SELECTED = (r"(?<=\. )[^.]*\b(?:is|are) selected\. ", "")
_HOSTS_FILTER = (r'"([^"]*)" \((meshing_\w+)\)', r"""MeshLab's "\1" (pymeshlab: \2)""")
_OF_THE_COMMAND_LINE = (
    _SELECTED,
    (r'generate_index_boolean_(\w+) \("[^"]*"\)', r"the command \1"),
    (
        r"\b(self_intersections|winding_rule|weld_distance) = ([\w.+-]*\w)",
        lambda found: f"--{found[1].replace('_', '-')} {found[2]}",
    ),
    (r"With certify_as = host\b", "With another --format than stl"),
    (r"\bweld_distance\b", "--weld-distance"),
    (r"\bmerge_tolerance\b", "--merge-tolerance"),
    _HOSTS_FILTER,
)
_OF_PYTHON = (
    _SELECTED,
    (r'generate_index_boolean_(\w+) \("[^"]*"\)', r"indexboolean.\1"),
    (r"\b(self_intersections|winding_rule|certify_as) = (\w+)", r'\1="\2"'),
    (r"\bweld_distance = ", "weld_distance="),
    (r'\bLayer ("[^"]*") \(id \d+\)', r"Mesh \1"),
    (r'("[^"]*") \(id \d+\)', r"\1"),
    (r"\bLayers\b", "Meshes"),
    (r"\blayer(s?) with id\b", r"mesh\1 with number"),
    (r' with "Delete Selected Faces and Vertices" \(\w+\)', ""),
    (r"If the layer's matrix is to blame, correct it\. Else delete", "Delete"),
    (r"The layer is damaged: load its file again", "The mesh is damaged"),
    (r"\blayers\b", "meshes"),
    (r"\blayer\b", "mesh"),
    _HOSTS_FILTER,
)


def in_words_of_the_command_line(sentences):
    """The sentences without what only holds for layers in a window."""
    return _in_words(sentences, _OF_THE_COMMAND_LINE)


def in_words_of_python(sentences):
    """The same with the names of the package's functions and their keywords."""
    return _in_words(sentences, _OF_PYTHON)


def _in_words(sentences, table):
    for pattern, words in table:
        sentences = re.sub(pattern, words, sentences)
    return sentences
