# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Texts of scenes (.prm) from nested dictionaries, and back.

The syntax alone: which keys there are, and what their values mean, the program knows.
"""

import pathlib

from .errors import SceneError


def parse(text, folder="."):
    """The nested dictionary of a text: sections are dictionaries, values are texts as they stand
    there. Included files are read; they are relative to folder."""
    top = {}
    _scan(text, pathlib.Path(folder), [top])
    return top


def _scan(text, folder, sections):
    """Enter the statements of a text into the innermost of the open sections."""
    depth, pending = len(sections), ""
    for line in text.removeprefix("\ufeff").splitlines():
        line = (pending + line.split("#")[0]).rstrip()
        if line.endswith("\\"):
            pending = line[:-1]
            continue
        pending = ""
        verb, _, rest = line.strip().partition(" ")
        verb, rest = verb.lower(), rest.strip()
        if verb == "subsection" and rest:
            sections.append(sections[-1].setdefault(rest, {}))
        elif verb == "end" and not rest and len(sections) > depth:
            sections.pop()
        elif verb == "set" and "=" in rest:
            key, _, value = rest.partition("=")
            sections[-1][key.strip()] = value.strip()
        elif verb == "include" and rest:
            path = folder / rest
            _scan(read(path), path.parent, sections)
        elif verb:
            raise SceneError(
                f"`{line.strip()}` is not a statement. Valid: `set key = value`, `subsection"
                " name`, `end`, `include file`; comments start with #.",
                2,
            )
    if pending or len(sections) > depth:
        raise SceneError("the scene ends within a section or a line. Add the missing `end`.", 2)


def read(path):
    """The text of a file. Raises SceneError."""
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise SceneError(f"{path}: cannot read this scene: {error.strerror}", 2) from None
    except UnicodeDecodeError:
        raise SceneError(f"{path}: it is not a text file. Name a .prm file.", 2) from None


def text_of(sections, indent=""):
    """The text of a nested dictionary whose values are texts: keys first, then the sections."""
    lines = []
    for key, value in sections.items():
        if not isinstance(value, dict):
            if any(sign in value for sign in "#\n") or value.endswith("\\"):
                raise SceneError(
                    f"{key} = {value!r}: # and line breaks cannot stand in a value.", 2
                )
            lines.append(f"{indent}set {key} = {value}\n")
    for name, inner in sections.items():
        if isinstance(inner, dict):
            lines.append(f"{indent}subsection {name}\n{text_of(inner, indent + '  ')}{indent}end\n")
    return "".join(lines)
