# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Drives the program signorini (elastic bodies in contact) and reads its results.

    scene = signorini.Scene.read("parameters/disc_2d.prm")
    scene["Time/Step size"] = 1e-3
    result = signorini.run(scene, "output/disc")
    result.history.plot("time", "contact_force")

Nothing is computed here: scenes are texts, and the program says what is wrong with them.
"""

from .errors import Interrupted, ProgramNotFound, RunError, SceneError, SignoriniError
from .executable import ask, find_executable
from .result import Result
from .run import Run, resume, run, start
from .scene import Scene
from .sweep import Sweep

__all__ = [
    "Interrupted",
    "ProgramNotFound",
    "Result",
    "Run",
    "RunError",
    "Scene",
    "SceneError",
    "SignoriniError",
    "Sweep",
    "ask",
    "find_executable",
    "resume",
    "run",
    "start",
]
