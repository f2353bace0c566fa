#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Contact is a matter of nodes, and begins between them. With a target for its error the mesh is
refined where something comes in between nodes, and the step is made again: a disc whose pole lies
between two nodes meets a floor, or a body, when the same disc with a node at its pole does, and
with the same force; a small obstacle holds a wide face; a ball of steel has the force of Hertz.
Meshes that stay as they are say that they miss it.
"""

import math

import check_history

PARTS = 32  # of the rim of the disc on level 3
BETWEEN_NODES = 0.5 * 360 / PARTS
SPEED, GAP, STEP_SIZE = 0.1, 0.02, 2e-3
TOLD = "between nodes"

ADAPTIVITY = """subsection Adaptivity
  set Indicator     = residual
  set Goal          = contact force
  set Target error  = TARGET
  set Maximum level = LEVEL
end
"""


def adaptivity(target, level):
    """The section with a target."""
    return ADAPTIVITY.replace("TARGET", str(target)).replace("LEVEL", str(level))


def scene(dimension, step_size, end_time, bodies, obstacles, pairs):
    """bodies, obstacles: {name: entries}"""

    def sections(kind, named):
        if not named:
            return ""
        lines = ""
        for name, entries in named.items():
            own = "".join(f"    set {entry}\n" for entry in entries)
            lines += f"  subsection {name}\n{own}  end\n"
        return f"subsection {kind}\n  set Names = {', '.join(named)}\n{lines}end\n"

    return f"""set Dimension = {dimension}
subsection Time
  set Step size = {step_size}
  set End time  = {end_time}
end
{sections("Bodies", bodies)}{sections("Obstacles", obstacles)}subsection Contact
  set Pairs = {pairs}
end
"""


def material(modulus, density):
    """Entries of a body."""
    return [f"Young's modulus = {modulus}", "Poisson's ratio = 0.3", f"Density = {density}"]


def disc(rotation):
    """Above the height 0, with its pole at a node or, turned, between two."""
    return [
        "Shape = ball",
        f"Centre = 0, {1 + GAP}",
        "Radius = 1",
        "Refinements = 3",
        f"Rotation = {rotation}",
        f"Initial velocity = 0; {-SPEED}",
        *material(5000, 1),
    ]


def beyond_a_rim():
    """A long block above a turned one whose upper side alone is a part of the pair: beyond the end
    of this side the long block is below its plane, and touches nothing."""
    below = [
        "Shape = box",
        "Lower corner = 0, -1",
        "Upper corner = 1, 0",
        "Repetitions = 2, 2",
        "Rotation = 2",
        *material(5000, 1),
    ]
    above = [
        "Shape = box",
        "Lower corner = 0.2, 0.02",
        "Upper corner = 3.2, 0.5",
        "Repetitions = 3, 1",
        *material(5000, 1),
    ]
    return scene(2, STEP_SIZE, 0.01, {"above": above, "below": below}, {}, "above : below[3]")


def disc_on_floor(rotation):
    """The floor is an obstacle."""
    return scene(2, STEP_SIZE, 0.35, {"disc": disc(rotation)}, {"floor": ["Normal = 0, 1"]},
                 "disc : floor")


def disc_on_block(rotation):
    """The floor is a body that is clamped below."""
    block = [
        "Shape = box",
        "Lower corner = -0.8, -0.4",
        "Upper corner = 0.8, 0",
        "Repetitions = 8, 2",
        "Dirichlet = 2: 0; 0",
        *material(50000, 1),
    ]
    return scene(2, STEP_SIZE, 0.35, {"disc": disc(rotation), "block": block}, {},
                 "disc : block[3]")


def box_on_knob(level):
    """The knob meets the middle of a face of the box, which has 8 faces below."""
    box = [
        "Shape = box",
        "Lower corner = -1, 0.02",
        "Upper corner = 1, 0.5",
        "Repetitions = 8, 2",
        f"Refinements = {level}",
        "Initial velocity = 0; -0.2",
        *material(2000, 1),
    ]
    knob = ["Shape = sphere", "Centre = 0.125, -0.05", "Radius = 0.05"]
    return scene(2, 1e-3, 0.35, {"box": box}, {"knob": knob}, "box : knob")


class UnseenContact(check_history.SceneTest):
    def start_of_contact(self, run):
        """The time of the first row with contact."""
        return next(time for time, force in zip(run["time"], run["contact_force"]) if force > 0)

    def test_a_pole_between_nodes(self):
        for name, on_ground in (("floor", disc_on_floor), ("block", disc_on_block)):
            with self.subTest(ground=name):
                target = adaptivity(0.02, 8)
                at_node = check_history.Run(on_ground(0) + target, f"{name}_at_node")
                between = check_history.Run(on_ground(BETWEEN_NODES) + target, f"{name}_between")
                start = self.start_of_contact(at_node)
                self.assertLess(abs(start - GAP / SPEED), 2.5 * STEP_SIZE)
                self.assertLess(abs(self.start_of_contact(between) - start), 1.5 * STEP_SIZE)
                self.expect_close(between.impulse(), at_node.impulse(), 0.01, "impulse")
                self.expect_close(
                    max(between["contact_force"]), max(at_node["contact_force"]), 0.03, "force"
                )
                self.assertNotIn(TOLD, at_node.log + between.log)

    def test_the_same_cells_on_two_processes(self):
        text = disc_on_block(BETWEEN_NODES) + adaptivity(0.05, 7)
        one = check_history.Run(text, "one")
        two = check_history.Run(text, "two", processes=2)
        self.assertEqual(one["cells"], two["cells"])
        largest = max(one["contact_force"])
        for a, b in zip(one["contact_force"], two["contact_force"]):
            self.assertLess(abs(a - b), 1e-7 * largest)

    def test_a_knob_under_the_middle_of_a_face(self):
        uniform = check_history.Run(box_on_knob(3), "fine")
        adaptive = check_history.Run(box_on_knob(0) + adaptivity(0.03, 6), "adaptive")
        start = self.start_of_contact(uniform)
        self.assertLess(abs(self.start_of_contact(adaptive) - start), 2.5e-3)
        self.expect_close(
            max(adaptive["contact_force"]), max(uniform["contact_force"]), 0.1, "force"
        )

    def test_meshes_that_miss_it_say_so(self):
        self.assertIn(TOLD, check_history.Run(box_on_knob(0), "missed").log)
        self.assertIn(TOLD, check_history.Run(disc_on_floor(BETWEEN_NODES), "late").log)
        self.assertNotIn(TOLD, check_history.Run(disc_on_floor(0), "in_time").log)
        self.assertNotIn("warning", check_history.Run(beyond_a_rim(), "rim").log)

    def test_hertz(self):
        """A ball of steel falls on a rigid plane: the force by the energy of the impact."""
        radius, modulus, density = 0.01, 210e9, 7850
        ball = [
            "Shape = ball",
            f"Centre = 0, 0, {radius + 5e-6}",
            f"Radius = {radius}",
            "Refinements = 2",
            "Element = standard",
            "Rotation = 20, 11, 0",
            "Initial velocity = 0; 0; -1",
            *material(modulus, density),
        ]
        run = check_history.Run(
            scene(3, 1e-6, 7e-5, {"ball": ball}, {"floor": ["Normal = 0, 0, 1"]}, "ball : floor")
            + adaptivity(0.05, 7),
            "hertz",
        )
        mass = density * 4 / 3 * math.pi * radius**3
        stiffness = 4 / 3 * modulus / (1 - 0.3**2) * math.sqrt(radius)
        depth = (5 / 4 * mass / stiffness) ** (2 / 5)
        self.expect_close(
            max(run["contact_force"]), stiffness * depth**1.5, 0.06, "force of Hertz"
        )
        self.assertLess(self.start_of_contact(run), 7.5e-6)


if __name__ == "__main__":
    check_history.main()
