# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the pictures show: phases of contact, skins of meshes; unfinished runs give no traceback."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import meshio
import numpy

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
sys.path[:0] = [str(TOOLS)]
from plotting import curves, fields, moments, obstacles, solids  # noqa: E402
from plotting.problem import Problem  # noqa: E402
from plotting.tables import read_table  # noqa: E402

HISTORY = (
    "time,kinetic_energy,elastic_energy,external_energy,total_energy,work_contact,"
    "contact_force,active_nodes,momentum_x"
)
UNIT_CUBE = numpy.array(
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
    dtype=float,
)


def block_of_cubes(n):
    """n^3 unit cubes with points repeated for each cell, as the program writes them."""
    corners = numpy.array([(x, y, z) for x in range(n) for y in range(n) for z in range(n)])
    points = (corners[:, None] + UNIT_CUBE).reshape(-1, 3)
    return points, numpy.arange(len(points)).reshape(-1, 8)


def fields_of(points, cells, **cell_data):
    return fields.Fields(points, cells, {}, cell_data)


class Phases(unittest.TestCase):
    time = numpy.arange(6.0)

    def test_contact_begins_one_step_before_the_first_force(self):
        force = numpy.array([0.0, 0.0, 3.0, 2.0, 0.0, 0.0])
        self.assertEqual(curves.contact_phases(self.time, force), [(1.0, 3.0)])

    def test_several_impacts(self):
        force = numpy.array([0.0, 3.0, 0.0, 0.0, 1.0, 1.0])
        self.assertEqual(curves.contact_phases(self.time, force), [(0.0, 1.0), (3.0, 5.0)])

    def test_none(self):
        self.assertEqual(curves.contact_phases(self.time, 0.0 * self.time), [])


class Probes(unittest.TestCase):
    def test_a_contact_node_and_a_point_of_a_body(self):
        """Components that are zero throughout are left out."""
        time = numpy.arange(3.0)
        node = {"time": time, "gap": time, "normal_velocity": time, "pressure": time}
        point = {"time": time, "von_mises": time}
        for quantity in ("position", "displacement", "velocity"):
            for axis in "xyz":
                point[f"{quantity}_{axis}"] = time * (axis == "y")
        for table, titles in (
            (node, ["Position", "Normal velocity", "Contact pressure"]),
            (point, ["Displacement", "Velocity", "Stress"]),
        ):
            axes = curves.probe(table, "tip").axes
            self.assertEqual(
                [panel.get_title() or panel.get_title("left") for panel in axes], titles
            )
        lines = [line for line in axes[0].lines if line.get_label() in "xyz"]
        self.assertEqual([line.get_label() for line in lines], ["y"])


class Momentum(unittest.TestCase):
    def test_components_only(self):
        """The drift of the angular momentum is no component of it."""
        time = numpy.arange(6.0)
        figure = curves.momentum(
            {
                "time": time,
                "contact_force": 0.0 * time,
                "momentum_x": 0.0 * time,
                "momentum_y": time - 3.0,
                "angular_momentum_z": time,
                "angular_momentum_drift": time,
            }
        )
        linear, angular = figure.axes[:2]
        self.assertEqual(linear.get_title(), "Linear momentum (x: zero)")
        self.assertEqual(angular.get_title(), "Angular momentum")
        self.assertEqual(len(angular.lines), 1)


class Skin(unittest.TestCase):
    def test_block(self):
        """27 cubes have 6 x 9 outer faces, and their area vectors cancel."""
        points, cells = block_of_cubes(3)
        skin = solids.boundary_faces(fields_of(points, cells), points)
        self.assertEqual(len(skin.cell), 54)
        numpy.testing.assert_allclose(skin.normals.sum(axis=0), 0.0, atol=1e-12)
        outwards = numpy.einsum("ij,ij->i", skin.normals, skin.corners.mean(axis=1) - 1.5)
        numpy.testing.assert_allclose(outwards, 1.5)

    def test_touching_bodies_keep_their_faces(self):
        points = numpy.concatenate([UNIT_CUBE, UNIT_CUBE + [0.0, 0.0, 1.0]])
        cells = numpy.arange(16).reshape(2, 8)
        for body, n_faces in (([0.0, 1.0], 12), ([0.0, 0.0], 10)):
            skin = solids.boundary_faces(fields_of(points, cells, body=numpy.array(body)), points)
            self.assertEqual(len(skin.cell), n_faces)

    def test_subdivision_of_a_bilinear_field(self):
        """The mean of the small faces is the mean of the field, the corners stay in place."""
        faces, values = solids.subdivide(
            UNIT_CUBE[None, :4], numpy.array([[0.0, 0.0, 1.0]]), numpy.array([[0.0, 2.0, 6.0, 4.0]])
        )
        self.assertAlmostEqual(values.mean(), 3.0)
        numpy.testing.assert_allclose(
            2.0 * faces.corners.mean(axis=1)[:, 0] + 4.0 * faces.corners.mean(axis=1)[:, 1], values
        )


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.run = pathlib.Path(folder.name)

    def plot(self):
        return subprocess.run(
            [sys.executable, "-B", TOOLS / "plot.py", self.run],
            capture_output=True,
            text=True,
            check=False,
        )

    def pictures(self):
        return {path.name for path in (self.run / "pictures").glob("*.png")}

    def write_history(self, *rows):
        (self.run / "history.csv").write_text("\n".join((HISTORY, *rows)), encoding="utf-8")

    def write_fields(self):
        """Two moments in two pieces, one of them empty."""
        (self.run / "fields").mkdir()
        points, cells = block_of_cubes(2)
        top = points[:, 2].max()
        for n in range(2):
            data = {
                "displacement": 0.0 * points - [0.0, 0.0, n],
                "CPRESS": n * (top - points[:, 2]),
            }
            meshio.write(
                self.run / f"fields/volume_{n}.0.vtu",
                meshio.Mesh(points, [("hexahedron", cells)], data),
            )
            skin = solids.boundary_faces(fields_of(points, cells), points).corners.reshape(-1, 3)
            data = {"displacement": 0.0 * skin - [0.0, 0.0, n], "CPRESS": n * (top - skin[:, 2])}
            meshio.write(
                self.run / f"fields/surface_{n}.0.vtu",
                meshio.Mesh(skin, [("quad", numpy.arange(len(skin)).reshape(-1, 4))], data),
            )
        for kind in ("volume", "surface"):
            for n in range(2):
                (self.run / f"fields/{kind}_{n}.1.vtu").write_text(
                    '<VTKFile><Piece NumberOfPoints="0" NumberOfCells="0" ></Piece></VTKFile>'
                )
                (self.run / f"fields/{kind}_{n}.pvtu").write_text(
                    f'<VTKFile><Piece Source="{kind}_{n}.0.vtu"/><Piece'
                    f' Source="{kind}_{n}.1.vtu"/></VTKFile>'
                )
            (self.run / f"{kind}.pvd").write_text(
                "<VTKFile>"
                + "".join(
                    f'<DataSet timestep="{n}" file="fields/{kind}_{n}.pvtu"/>' for n in range(2)
                )
                + "</VTKFile>"
            )

    def test_half_a_row_is_skipped(self):
        self.write_history("0,1,0,0,1,0,0,0,2", "1,1,0,0,1,0,5,1,2", "2,1,0")
        numpy.testing.assert_allclose(
            read_table(self.run / "history.csv")["contact_force"], [0.0, 5.0]
        )

    def test_header_only(self):
        self.write_history()
        self.assertRaises(Problem, read_table, self.run / "history.csv")

    def test_empty_folder(self):
        result = self.plot()
        self.assertEqual(result.returncode, 1)
        self.assertIn("history.csv", result.stderr)
        self.assertNotIn("Traceback", result.stderr)

    def test_one_row_and_nothing_else(self):
        self.write_history("0,1,0,0,1,0,0,0,2")
        result = self.plot()
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.pictures(), {"energy.png", "contact_force.png", "momentum.png"})

    def test_all_pictures(self):
        self.write_history("0,1,0,0,1,0,0,0,2", "1,.5,.4,0,.9,-.1,5,1,0")
        self.write_fields()
        result = self.plot()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("bodies.png", self.pictures())
        start, end = moments.read_moments(self.run, read_table(self.run / "history.csv"))
        self.assertEqual(start.title, "start, time 0")
        self.assertEqual(end.positions[:, 2].min(), -1.0)
        self.assertEqual(end.surface.at_cells("CPRESS").max(), 2.0)

    def test_obstacles_that_move(self):
        """They are drawn where they are at each moment, from their series; others by their keys."""
        self.write_history("0,1,0,0,1,0,0,0,2", "1,.5,.4,0,.9,-.1,5,1,0")
        self.write_fields()
        self.assertEqual(
            [m.moving_walls for m in moments.read_moments(self.run, None)], [None, None]
        )
        corners = numpy.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0]])
        for n in range(2):
            meshio.write(
                self.run / f"fields/obstacles_{n}.vtu",
                meshio.Mesh(corners - [0.0, 0.0, n], [("triangle", numpy.array([[0, 1, 2]]))]),
            )
        (self.run / "obstacles.pvd").write_text(
            "<VTKFile>"
            + "".join(
                f'<DataSet timestep="{n}" file="fields/obstacles_{n}.vtu"/>' for n in range(2)
            )
            + "</VTKFile>"
        )
        (self.run / "parameters.prm").write_text(
            "subsection Obstacles\n set Names = punch, floor\n"
            " subsection punch\n  set Motion = 0; 0; -t\n end\n"
            " subsection floor\n  set Motion = 0; 0; 0\n  set Velocity = 0; 0; 0\n"
            "  set Point = 0, 0, -7\n end\nend\n"
        )
        (wall,) = obstacles.read_obstacles(self.run)
        self.assertEqual(wall.point[2], -7.0)
        walls = [m.moving_walls for m in moments.read_moments(self.run, None)]
        self.assertEqual([w.points[0, 2] for w in walls], [0.0, -1.0])
        self.assertEqual(obstacles.moving_faces_3d(walls[1]).corners.shape, (1, 4, 3))
        result = self.plot()
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_missing_and_broken_pieces(self):
        self.write_history("0,1,0,0,1,0,0,0,2")
        self.write_fields()
        piece = self.run / "fields/volume_1.0.vtu"
        whole = piece.read_bytes()
        piece.write_bytes(whole[: len(whole) // 2])
        self.assertRaises(Problem, fields.read_fields, self.run / "fields/volume_1.pvtu")
        piece.unlink()
        self.assertRaises(Problem, fields.read_fields, self.run / "fields/volume_1.pvtu")


if __name__ == "__main__":
    unittest.main()
