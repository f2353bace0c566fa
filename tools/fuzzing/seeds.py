# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What is mutated: shipped scenes made small, and small scenes with meshes of all formats. An input
is a dictionary of files, with the scene in scene.prm; contents are bytes."""

import pathlib
import re

from . import meshes

PARAMETERS = pathlib.Path(__file__).resolve().parents[2] / "parameters"
#: The largest values of keys that decide about the cost, in what is mutated.
MOST = {
    "Refinements": 1,
    "Local refinements": 1,
    "Repetitions": 4,
    "Maximum level": 2,
    "Maximum cells": 60,
}
N_STEPS = 5
#: How keys are followed by their values.
KEY = r"(?m)^(\s*set\s+%s\s*=)([^#\n]*)"

SMALL = """
set Dimension = %(dim)d
subsection Time
  set Step size = 0.02
  set End time  = 0.1
end
subsection Bodies
  set Names = body
  subsection body
%(shape)s
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = %(velocity)s
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
%(floor)s
  end
end
subsection Contact
  set Pairs = %(pair)s
  subsection %(pair)s
    set Friction coefficient = 0.2
  end
end
subsection Output
  set VTU = false
end
"""


def small(dim, shape, floor, pair="body : floor"):
    """A body above the origin that falls; shape and floor: lines of keys."""
    return SMALL % {
        "dim": dim,
        "shape": indent(shape),
        "floor": indent(floor),
        "velocity": "0.1; -1" if dim == 2 else "0.1; 0; -1",
        "pair": pair,
    }


def indent(keys):
    """The keys of a section."""
    return "\n".join(f"    set {key}" for key in keys)


def with_meshes():
    """Scenes with a mesh from a file, of each format."""
    for name, make, dimensions in meshes.BODIES:
        for dim in dimensions:
            up = "0, 0.01" if dim == 2 else "0, 0, 0.01"
            shape = ["Shape = file", f"File = {name}", f"Translation = {up}"]
            floor = ["Shape = plane", f"Normal = {'0, 1' if dim == 2 else '0, 0, 1'}"]
            pair = "body[1] : floor"
            yield {"scene.prm": small(dim, shape, floor, pair), name: make(dim)}
    for name, make, dimensions in meshes.NAMED:
        for dim in dimensions:
            up = "0, 0.001" if dim == 2 else "0, 0, 0.001"
            shape = ["Shape = file", f"File = {name}", f"Translation = {up}"]
            shape += ["Part = block", "Scale = 0.1", "Traction = below: " + "; ".join("0" * dim)]
            floor = ["Shape = plane", f"Normal = {'0, 1' if dim == 2 else '0, 0, 1'}"]
            yield {
                "scene.prm": small(dim, shape, floor, "body[below] : floor"),
                name: make(dim),
            }
    for name, make, dimensions in meshes.SURFACES:
        for dim in dimensions:
            corners = [("0, 0.01", "1, 1.01"), ("0, 0, 0.01", "1, 1, 1.01")][dim - 2]
            shape = [f"Lower corner = {corners[0]}", f"Upper corner = {corners[1]}"]
            floor = ["Shape = mesh", f"File = {name}", "Open = true"]
            yield {
                "scene.prm": small(dim, ["Shape = box", *shape], floor),
                name: make(dim),
            }


def at_most(values, most):
    """A list of integers, none above."""
    numbers = [number.strip() for number in values.split(",")]
    # Python makes no number of thousands of digits; all that are so long are too large.
    return ", ".join(str(min(int(n[:18]), most)) if n.isdigit() else n for n in numbers)


def made_small(text):
    """The same scene with few cells and steps."""
    for key, most in MOST.items():
        text = re.sub(KEY % key, lambda m, n=most: f"{m[1]} {at_most(m[2], n)}", text)
    step = re.search(KEY % "Step size", text)
    if step:
        text = re.sub(KEY % "End time", rf"\g<1> {N_STEPS * float(step[2])!r}", text)
    return text


def shipped():
    """Scenes of the folder parameters, with their meshes beside them."""
    for path in sorted(PARAMETERS.rglob("*.prm")):
        text = made_small(path.read_text(encoding="utf-8"))
        files = {}
        for match in re.finditer(KEY % "File", text):
            mesh = (path.parent / match[2].strip()).resolve()
            files[mesh.name] = mesh.read_bytes()
        files["scene.prm"] = re.sub(
            KEY % "File", lambda m: f"{m[1]} {pathlib.Path(m[2].strip()).name}", text
        )
        yield files


def load():
    """(all inputs with a mesh that is small, all others)."""
    as_bytes = lambda text: text if isinstance(text, bytes) else text.encode()
    found = [
        {name: as_bytes(text) for name, text in files.items()}
        for files in [*with_meshes(), *shipped()]
    ]
    n_with_meshes = sum(1 for _ in with_meshes())
    return found[:n_with_meshes], found
