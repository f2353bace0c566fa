# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The keys of scenes, as the program itself prints them."""

import difflib
import functools
import re

from . import prm
from .executable import ask


@functools.lru_cache(maxsize=None)
def declared(program):
    """All sections and keys with example values, for one body, one obstacle, one pair and one
    probe. program: the executable, and options that add to its keys."""
    executable, *options = program
    return prm.parse(ask("--print-parameters", *options, executable=executable))


def section(program, path):
    """What is declared in a section, {} if there is none. The sections of all bodies are alike,
    whatever their names, and so are those of obstacles, pairs and probes."""
    found = declared(program)
    for name in path:
        inner = [value for value in found.values() if isinstance(value, dict)]
        alike = inner[0] if len(inner) == 1 else {}
        found = found.get(name, alike)
    return found


def word(key):
    """A key as a name of Python: `Young's modulus` is youngs_modulus."""
    return re.sub(r"[^a-z0-9]+", "_", key.lower().replace("'", "")).strip("_")


def key_of(program, path, name):
    """The key or section in a section that a name of Python means. Raises AttributeError."""
    known = {word(key): key for key in section(program, path)}
    if name not in known:
        close = difflib.get_close_matches(name, known, 1)
        where = f"section `{'/'.join(path)}`" if path else "scene"
        raise AttributeError(
            f"{name}: there is no such key in the {where}."
            + (f" Did you mean {close[0]}?" if close else "")
            + f" Valid: {', '.join(known)}."
        )
    return known[name]


def separator(program, path, key):
    """Between the numbers of a value: semicolons for components of expressions, commas for other
    lists; the example of the key tells which."""
    return "; " if ";" in section(program, path).get(key, "") else ", "
