# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of options as the host takes them; of another type, a TypeError that says what is wanted.
"""

import operator

import numpy as np

from .plugin import LENGTHS

_WORDS = {  # options whose values are words, which the host knows by numbers, too
    "certify_as": "host", "self_intersections": "refuse", "winding_rule": "positive",
}


def taken(name, value, default):
    """The value for an option with that default; of a length a float."""
    if name in LENGTHS:
        return length(name, value)
    if isinstance(default, bool):
        return truth(name, value)
    if name in _WORDS:
        if isinstance(value, str):
            return value
        return _whole(name, value, f'a word such as "{_WORDS[name]}"')
    return _whole(name, value, "a whole number") if isinstance(default, int) else value


def length(name, value):
    """A float."""
    try:
        if not isinstance(value, str):
            return float(value)
    except TypeError:
        pass
    raise _other(name, value, "a number")


def truth(name, value):
    """True or False, which 1 and 0 are, too."""
    if isinstance(value, (bool, np.bool_, int, np.integer)) and value in (0, 1):
        return bool(value)
    raise _other(name, value, "True or False")


def _whole(name, value, wanted):
    try:
        if not isinstance(value, bool):
            return operator.index(value)
    except TypeError:
        pass
    raise _other(name, value, wanted)


def _other(name, value, wanted):
    return TypeError(f"{name} is {wanted}, not {value!r}")
