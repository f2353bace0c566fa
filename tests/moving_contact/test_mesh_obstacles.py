#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Obstacles from mesh files do what obstacles of the same shape do that are given by formulas:
boxes and grooves to round-off, slopes as mechanics says; and they may move. Nodes come to rest in
the grooves between facets, deep and shallow ones. Where a function has no value, and no contact is,
nothing happens.
"""

import math
import pathlib
import re

import check_history
import following_scenes as following
from following_scenes import entries

def scene(dimension, shape, body, obstacles, friction=0.0, end=1.0, scheme="contact-implicit"):
    """A block, or what else it is, and obstacles: lines by name."""
    pairs = [f"block : {name}" for name in obstacles]
    laws = [following.friction(pair, friction) for pair in pairs if friction]
    return following.scene(
        [following.body("block", f"set Shape = {shape}", *body)],
        pairs,
        end,
        scheme,
        obstacles=following.obstacles(obstacles),
        laws="".join(laws),
        dimension=dimension,
    )


def line(points):
    """The text of an .obj file with a line; closed if it ends where it begins."""
    different = points[:-1] if points[0] == points[-1] else points
    numbers = [str(different.index(point) + 1) for point in points]
    return "".join(f"v {x!r} {y!r}\n" for x, y in different) + f"l {' '.join(numbers)}\n"


def cuboid(lower, upper):
    """The text of an STL file with a box of twelve triangles."""
    (x, y, z), (u, v, w) = lower, upper
    corners = [(a, b, c) for c in (z, w) for b in (y, v) for a in (x, u)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    text = "solid box\n"
    for a, b, c, d in faces:
        for triangle in ((a, b, c), (a, c, d)):
            text += "facet normal 0 0 0\nouter loop\n"
            for corner in triangle:
                text += "vertex {!r} {!r} {!r}\n".format(*corners[corner])
            text += "endloop\nendfacet\n"
    return text + "endsolid box\n"


class MeshObstacles(check_history.SceneTest):
    def mesh(self, name, text):
        """Write a mesh. Returns its path."""
        path = pathlib.Path(check_history.settings["folder"]) / "meshes" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path.resolve()

    def expect_same_motion(self, run, other, relative=1e-11):
        for column in ("kinetic_energy", "elastic_energy", "momentum_x", "momentum_y"):
            size = max(map(abs, other[column] + other["total_energy"]))
            for row, (own, expected) in enumerate(zip(run[column], other[column])):
                self.assertLessEqual(abs(own - expected), relative * size, f"{column} in {row}")
        self.assertGreater(max(run["contact_force"]), 0)

    def test_box_of_triangles(self):
        """A block falls onto the flat face of a box, with friction, and hops to its edge. As an STL
        file and as a `box` it is the same, and so are one process and two."""
        body = entries(
            Lower_corner="1, 1, 0.05",
            Upper_corner="1.5, 1.5, 0.55",
            Repetitions="2, 2, 2",
            Initial_velocity="3; 0.2; -1",
            Body_force="0; 0; -1",
        )
        path = self.mesh("box.stl", cuboid((0.0, 0.0, -1.0), (2.0, 4.0, 0.0)))
        box = entries(Shape="box", Lower_corner="0, 0, -1", Upper_corner="2, 4, 0")
        facets = entries(Shape="mesh", File=path)
        texts = [scene(3, "box", body, {"base": base}, 0.2, 0.6) for base in (box, facets)]
        formula = check_history.Run(texts[0], "mesh-box-formula")
        run = check_history.Run(texts[1], "mesh-box-facets")
        self.expect_same_motion(run, formula)
        two = check_history.Run(texts[1], "mesh-box-two", processes=2)
        self.expect_contact(run)
        self.expect_same_history(two, run, 1e-9)  # the solver promises 1e-10

    def test_groove_of_one_obstacle(self):
        """A square falls into a groove of 100 degrees with its edge ahead. One line of
        two segments holds it as two planes do."""
        angle = math.radians(40)
        cosine, sine = math.cos(angle), math.sin(angle)
        body = entries(
            Lower_corner="-0.5, 0.25",
            Upper_corner="0.5, 1.25",
            Repetitions="4, 4",
            Rotation=45,
            Initial_velocity="0.2; -0.5",
            Body_force="0; -1",
        )
        path = self.mesh(
            "groove.obj",
            line([(6 * cosine, 6 * sine), (0.0, 0.0), (-6 * cosine, 6 * sine)]),
        )
        planes = {
            "left": entries(Normal=f"{sine!r}, {cosine!r}"),
            "right": entries(Normal=f"-{sine!r}, {cosine!r}"),
        }
        facets = {"groove": entries(Shape="mesh", File=path, Open="true")}
        run = check_history.Run(scene(2, "box", body, facets), "mesh-groove-facets")
        other = check_history.Run(scene(2, "box", body, planes), "mesh-groove-planes")
        self.expect_same_motion(run, other)
        self.assertLess(max(run["geometric_penetration"]), 1e-12)

    def test_rest_in_a_shallow_groove(self):
        """A damped disc comes to rest in a groove of 0.05 rad without friction: its lowest node
        needs both sides, and the weight is carried, to what is left of the vibration."""
        weight = 16 * math.sin(math.pi / 16)  # of a disc of 32 chords
        for scheme in ("contact-implicit", "contact-stabilized-projected"):
            with self.subTest(scheme=scheme):
                body = entries(
                    Centre="0, 1.005",
                    Radius=1,
                    Refinements=3,
                    Damping="2, 0",
                    Initial_velocity="0.02; 0",
                    Body_force="0; -1",
                )
                rise = 6 * math.tan(0.025)
                path = self.mesh(
                    "shallow.obj", line([(6.0, rise), (0.0013, 0.0), (-6.0, rise)])
                )
                groove = {"groove": entries(Shape="mesh", File=path, Open="true")}
                run = check_history.Run(
                    scene(2, "ball", body, groove, end=4.0, scheme=scheme), f"mesh-shallow-{scheme}"
                )
                self.assertLess(max(run["geometric_penetration"]), 1e-11)
                self.assertEqual(sum(run["rejected_steps"]), 0)
                forces = run["contact_force_y"][-100:]
                self.assertAlmostEqual(sum(forces) / len(forces), weight, delta=0.01)

    def test_slide_down_a_ramp(self):
        """On a slope of 20 degrees, a box of triangles that is rotated, a stiff block with friction
        0.1 is accelerated by g (sin - 0.1 cos). The load comes within 0.1, which counts for half;
        vibrations are a per cent of the velocity."""
        angle = math.radians(20)
        cosine, sine = math.cos(angle), math.sin(angle)
        # Down the slope is +x after a rotation about y; the middle of the box stays at the origin,
        # and that of the block is 0.75 above it and 1.5 up the slope.
        middle = (-1.5 * cosine + 0.75 * sine, 1.5 * sine + 0.75 * cosine)
        body = entries(
            Lower_corner="-0.25, -0.25, -0.25",
            Upper_corner="0.25, 0.25, 0.25",
            Repetitions="3, 3, 3",
            Rotation="0, 20, 0",
            Translation=f"{middle[0]!r}, 0, {middle[1]!r}",
            Damping="0, 0.003",
            Body_force="0; 0; -10*min(10*t, 1)",
        )
        path = self.mesh("ramp.stl", cuboid((-2.0, -1.0, -0.5), (2.0, 1.0, 0.5)))
        ramp = {"ramp": entries(Shape="mesh", File=path, Rotation="0, 20, 0")}
        text = scene(3, "box", body, ramp, 0.1, 0.9, scheme="contact-stabilized-projected")
        run = check_history.Run(text, "mesh-ramp")
        speed = 10 * (sine - 0.1 * cosine) * (0.9 - 0.05)
        momentum = math.hypot(run["momentum_x"][-1], run["momentum_z"][-1])
        self.assertAlmostEqual(momentum / 0.125 / speed, 1, delta=0.02)
        self.assertLess(max(run["geometric_penetration"]), 1e-11)

    def test_chute(self):
        """The shipped scene: in a groove of a right angle each wall presses with the load over
        twice the sine of 45 degrees, and friction at both brakes. The load comes within 0.1; the
        block vibrates by some 1e-4 of its velocity."""
        run = check_history.Run(check_history.scene_file("chute"), "chute")
        slope, half = math.radians(30), math.radians(45)
        mass = 0.8 * 0.4 * 0.4
        acceleration = 10 * (math.sin(slope) - 0.2 * math.cos(slope) / math.sin(half))
        force = mass * 10 * math.cos(slope) / math.sin(half)
        self.assertAlmostEqual(run["momentum_x"][-1] / mass / acceleration, 0.95, delta=1e-3)
        self.assertAlmostEqual(run["contact_force"][-1] / force, 1, delta=1e-3)
        self.assertLess(max(map(abs, run["momentum_y"])), 1e-9 * max(run["momentum_x"]))
        self.assertLess(max(run["geometric_penetration"]), 1e-12)
        self.expect_ledger_closes(run, driven=True)

    def test_obstacle_that_moves(self):
        """A rectangle that turns and pushes a block is the same as four segments and as a `box`,
        and its work is in the ledger. Its surface is written with the fields, where it is."""
        body = entries(
            Lower_corner="0, 0.01",
            Upper_corner="1, 1.01",
            Repetitions="4, 4",
            Body_force="0; -1",
        )
        motion = entries(
            Velocity="0; 0.3*sin(3*t)", Angular_velocity="0.3", Rotation_centre="0.5, 0"
        )
        corners = [(-2.0, -1.0), (3.0, -1.0), (3.0, 0.0), (-2.0, 0.0), (-2.0, -1.0)]
        path = self.mesh("pad.obj", line(corners))
        box = entries(Shape="box", Lower_corner="-2, -1", Upper_corner="3, 0")
        facets = entries(Shape="mesh", File=path)
        texts = [scene(2, "box", body, {"pad": pad + motion}, 0.4) for pad in (box, facets)]
        formula = check_history.Run(texts[0], "mesh-moving-formula")
        run = check_history.Run(texts[1], "mesh-moving-facets", ["Output/VTU=true"])
        self.expect_same_motion(run, formula)
        self.assertGreater(max(run["work_external"]), 0)
        self.expect_ledger_closes(run, driven=True)

        output = run.folder / "output"
        self.assertFalse((output / "obstacles.vtu").exists())
        times = [
            re.findall('timestep="([^"]*)"', (output / f"{name}.pvd").read_text(encoding="utf-8"))
            for name in ("obstacles", "volume")
        ]
        self.assertGreater(len(times[0]), 2)
        self.assertEqual(times[0], times[1])

    def test_function_without_values_elsewhere(self):
        """Half a circle as the graph of a root, which has no value beside it: the nodes there are
        free. A wide block that falls on it does what it does on a whole circle, but for what a step
        knows of a curve through a function, 1e-3 of the motion."""
        body = entries(
            Lower_corner="-2, 1.01",
            Upper_corner="2, 1.51",
            Repetitions="32, 4",
            Initial_velocity="0.1; -0.5",
        )
        root = entries(Shape="function", Signed_distance="y - sqrt(1 - x^2)")
        circle = entries(Shape="sphere")
        run, other = (
            check_history.Run(
                scene(2, "box", body, {"hill": hill}, end=0.3), f"function-without-values-{number}"
            )
            for number, hill in enumerate((root, circle))
        )
        self.expect_same_motion(run, other, 1e-3)


if __name__ == "__main__":
    check_history.main()
