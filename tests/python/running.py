# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the tests of the Python package share: where things are, and a small scene.

A test calls main(), which takes EXECUTABLE and FOLDER (for results) from the command line.
"""

import os
import pathlib
import shutil
import sys
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PARAMETERS = SOURCE / "parameters"
sys.path.insert(0, str(SOURCE / "python"))

import signorini  # noqa: E402  pylint: disable=wrong-import-position

#: Of the test, emptied at its start.
folder = pathlib.Path("output")


def disc(**time):
    """A disc that hits a floor, as objects; 40 steps in a third of a second."""
    scene = signorini.Scene(dimension=2)
    scene.time.update(step_size=5e-3, end_time=0.2, **time)
    body = scene.bodies.add(
        "disc",
        shape="ball",
        centre=(0, 1.02),
        radius=1,
        refinements=1,
        youngs_modulus=500,
        poissons_ratio=0.3,
        density=1,
        initial_velocity=(0, -1),
    )
    floor = scene.obstacles.add("floor", normal=(0, 1))
    scene.contact.add(body, floor, friction_coefficient=0.2)
    scene.output.vtu = False
    return scene


def main():
    """python3 test.py EXECUTABLE FOLDER [unittest arguments]"""
    global folder  # pylint: disable=global-statement
    os.environ["SIGNORINI"] = sys.argv[1]
    folder = pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    # A test must not depend on where it is called.
    os.chdir(folder)
    folder = pathlib.Path.cwd()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
