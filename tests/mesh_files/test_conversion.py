#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Meshes that only meshio reads are bodies like others, with their groups, on every process; what
is missing or broken is told in one sentence. Formats whose Python module is not there are left out.
"""

import importlib.util
import json
import os
import pathlib
import subprocess
import unittest

import check_history

POINTS = [(x, y, z) for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)]
CELLS = [
    (0, 1, 3, 7),
    (0, 3, 2, 7),
    (0, 2, 6, 7),
    (0, 6, 4, 7),
    (0, 4, 5, 7),
    (0, 5, 1, 7),
]
BELOW = [(0, 3, 1), (0, 2, 3)]

SCENE = """set Dimension = 3
subsection Time
  set Step size = 1e-2
  set End time  = 1e-2
end
subsection Bodies
  set Names = block
  subsection block
    set Shape     = file
    set File      = {file}
    set Traction  = 0: 0; 0; 0
    set Dirichlet = {below}: 0; 0; 0
{more}
  end
end
"""


def has(module):
    return importlib.util.find_spec(module) is not None


def write_exodus(path):
    """A block and a side set with names, as Cubit writes them."""
    import netCDF4
    import numpy

    with netCDF4.Dataset(path, "w") as data:
        sizes = {"num_nodes": 8, "len_name": 33, "num_el_blk": 1, "num_side_sets": 1, "sides": 2}
        for name, size in {**sizes, "cells": 6, "corners": 4}.items():
            data.createDimension(name, size)

        def variable(name, kind, sizes, values):
            data.createVariable(name, kind, sizes)[:] = values

        for axis, values in zip("xyz", zip(*POINTS)):
            variable(f"coord{axis}", "f8", ("num_nodes",), values)
        variable("eb_prop1", "i4", ("num_el_blk",), [10])
        variable("ss_prop1", "i4", ("num_side_sets",), [4])
        variable("connect1", "i4", ("cells", "corners"), numpy.array(CELLS) + 1)
        data.variables["connect1"].elem_type = "TETRA4"
        variable("elem_ss1", "i4", ("sides",), [1, 2])
        variable("side_ss1", "i4", ("sides",), [4, 4])
        for name, word in (("eb_names", "block"), ("ss_names", "below")):
            letters = numpy.array([[c.encode() for c in word.ljust(33, "\0")]])
            dimension = "num_el_blk" if name == "eb_names" else "num_side_sets"
            variable(name, "S1", (dimension, "len_name"), letters)


def write_with_meshio(path):
    """Binary Gmsh and MED have groups; the families of MED are negative."""
    import meshio
    import numpy

    med = path.suffix == ".med"
    tags = [numpy.array([-1] * 6), numpy.array([-2] * 2)] if med else [[7] * 6, [4] * 2]
    tags = [numpy.array(tag) for tag in tags]
    mesh = meshio.Mesh(POINTS, [("tetra", CELLS), ("triangle", BELOW)])
    if med:
        mesh.cell_data["cell_tags"] = tags
        mesh.cell_tags = {-1: ["block"], -2: ["below"]}
        mesh.point_tags = {}
        mesh.write(path)
    elif path.suffix == ".msh":
        mesh.cell_data = {"gmsh:physical": tags, "gmsh:geometrical": tags}
        mesh.field_data = {"block": numpy.array([7, 3]), "below": numpy.array([4, 2])}
        meshio.write(path, mesh, file_format="gmsh22", binary=True)
    else:
        mesh.cell_data = {"gmsh:physical": tags}
        meshio.write(path, mesh, binary=False)


class Conversion(unittest.TestCase):
    def validate(self, file, below, more="", processes=1, **environment):
        """The result of a check of a scene with a mesh."""
        folder = pathlib.Path(check_history.settings["folder"])
        scene = folder / f"{file.stem}.prm"
        scene.write_text(SCENE.format(file=file, below=below, more=more), encoding="utf-8")
        return subprocess.run(
            check_history.command(scene, (), processes, ("--validate=json",)),
            env={**check_history.environment(), **environment},
            capture_output=True,
            text=True,
            timeout=check_history.TIMEOUT,
            check=False,
        )

    def expect_block(self, write, name, below, more="    set Part = block", processes=1):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / name
        write(file)
        result = self.validate(file, below, more, processes)
        self.assertEqual(result.returncode, 0, result.stderr)
        facts = json.loads(result.stdout)
        self.assertEqual(facts["cells"], 24)
        self.assertIn("6 tetrahedra are split into 24 hexahedra", " ".join(facts["notes"]))
        return file

    @unittest.skipUnless(has("meshio"), "no meshio")
    def test_meshio(self):
        self.expect_block(write_with_meshio, "numbers.vtu", "4", "    set Part = 7", processes=2)
        self.expect_block(write_with_meshio, "binary.msh", "below")
        if has("h5py"):
            self.expect_block(write_with_meshio, "groups.med", "below")

    @unittest.skipUnless(has("netCDF4"), "no netCDF4")
    def test_exodus(self):
        self.expect_block(write_exodus, "sides.exo", "below")
        self.expect_block(write_exodus, "numbers.e", "4", "    set Part = 10")

    def expect_refusal(self, result, *words):
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    @unittest.skipUnless(has("meshio"), "no meshio")
    def test_refusals(self):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        broken = folder / "broken.vtu"
        broken.write_text("no mesh", encoding="utf-8")
        self.expect_refusal(self.validate(broken, "1"), "Write the mesh as .msh")
        missing = folder / "modules"
        missing.mkdir(exist_ok=True)
        (missing / "meshio.py").write_text(
            'raise ModuleNotFoundError("not there", name="meshio")', encoding="utf-8"
        )
        self.expect_refusal(
            self.validate(broken, "1", PYTHONPATH=os.fspath(missing)),
            "Python's module meshio is missing",
            "apt-get install python3-meshio",
        )


if __name__ == "__main__":
    check_history.main()
