# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""From what a finished run was made, kept beside its results, so that it need not be run again."""

import hashlib
import json
import pathlib

from .executable import ask
from .scene import PLUGINS, Scene

FILE = "origin.json"


def of(scene, settings, executable):
    """Scene, contents of the files it names, and version of the program."""
    if isinstance(scene, dict):
        scene = Scene(scene, executable=executable)
    elif not isinstance(scene, Scene):
        scene = Scene.read(scene, executable=executable)
    sections = scene.changed(settings).dictionary()
    return {
        "scene": sections,
        "files": {path: _checksum(path) for path in sorted(_files(sections)) if path},
        "program": ask("--version", executable=executable or scene.executable),
    }


def _files(sections):
    """Mesh files and plug-ins."""
    for key, value in sections.items():
        if isinstance(value, dict):
            yield from _files(value)
        elif key == "File":
            yield value
        elif key == PLUGINS:
            yield from value.split(", ")


def _checksum(path):
    """None if the file cannot be read; the program will say so."""
    try:
        return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()
    except OSError:
        return None


def read(folder):
    """What was written beside the results in a folder, None if nothing was."""
    try:
        return json.loads((pathlib.Path(folder) / FILE).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


def write(folder, origin):
    """To be done when the run has come to its end."""
    (pathlib.Path(folder) / FILE).write_text(json.dumps(origin, indent=1), encoding="utf-8")


def remove(folder):
    """To be done before a run begins."""
    (pathlib.Path(folder) / FILE).unlink(missing_ok=True)
