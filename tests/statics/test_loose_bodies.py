#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Bodies that only supports with friction hold are in equilibrium, and the program says so: a block
falls onto a floor below it, however far that is and however stiff the block; a plate on balls bears
its load and gives it back; a block that slides between two others has the same friction on both
sides; stacks that nothing presses stay where they are. All forces balance the loads. (The guard of
laws ends a run whose forces do not.)
"""

import check_history


def box(name, lower, upper, cells, modulus, *entries, poisson=0.3):
    """The section of a body; corners and cells as a scene has them."""
    lines = [
        "Shape = box",
        f"Lower corner = {lower}",
        f"Upper corner = {upper}",
        f"Repetitions = {cells}",
        f"Young's modulus = {modulus}",
        f"Poisson's ratio = {poisson}",
        "Density = 1000",
        *entries,
    ]
    return f"subsection {name}\n" + "".join(f"set {line}\n" for line in lines) + "end\n"


def scene(dimension, steps, bodies, obstacles, pairs, friction, motion="automatic"):
    """bodies: {name: section}, obstacles: {name: entries}; n equal steps to the time 1."""
    planes = "".join(
        f"subsection {name}\n" + "".join(f"set {entry}\n" for entry in entries) + "end\n"
        for name, entries in obstacles.items()
    )
    sections = "".join(
        f"subsection {pair}\nset Friction coefficient = {friction}\nend\n" for pair in pairs
    )
    return f"""set Dimension = {dimension}
subsection Time
set Scheme = static
set Step size = {1 / steps}
set End time = 1
end
subsection Bodies
set Names = {", ".join(bodies)}
{"".join(bodies.values())}end
subsection Obstacles
set Names = {", ".join(obstacles)}
{planes}end
subsection Contact
set Motion = {motion}
set Pairs = {", ".join(pairs)}
{sections}end
"""


FLOOR = {"floor": ["Normal = 0, 1"]}


class LooseBodies(check_history.SceneTest):
    def test_a_block_falls_as_far_as_it_takes(self):
        for modulus, gap in ((1e7, 0.1), (1e7, 1.0), (2.1e11, 1e-5), (2.1e11, 0.01)):
            with self.subTest(modulus=modulus, gap=gap):
                block = box(
                    "b", f"0, {gap}", f"1, {0.5 + gap}", "8, 4", modulus, "Body force = 0; -9.81"
                )
                text = scene(2, 1, {"b": block}, FLOOR, ["b[2] : floor"], 0.3)
                run = check_history.Run(text, f"fall_{modulus:g}_{gap:g}")
                self.expect_close(run["contact_force"][1], 0.5 * 9810, 1e-8, "weight")
                self.assertLess(abs(run["contact_force_x"][1]), 1e-6 * 0.5 * 9810)

    def test_a_plate_on_balls(self):
        """Of 2 x 2 cells, a ball under each corner; pressed, and nearly unloaded again."""
        plate = box(
            "p",
            "-0.2, -0.2, 0",
            "0.2, 0.2, 0.01",
            "2, 2, 1",
            7e10,
            "Traction = 5: 0; 0; -2e4*(1.01-t)",
            "Body force = 0; 0; -9.81",
        )
        balls = {
            f"ball{i}": ["Shape = sphere", f"Centre = {x}, {y}, -0.02", "Radius = 0.02"]
            for i, (x, y) in enumerate(((-0.2, -0.2), (0.2, -0.2), (-0.2, 0.2), (0.2, 0.2)))
        }
        pairs = [f"p[4] : {ball}" for ball in balls]
        run = check_history.Run(scene(3, 4, {"p": plate}, balls, pairs, 0.2, "linearised"), "plate")
        for row in range(1, len(run)):
            load = 0.16 * (2e4 * (1.01 - run["time"][row]) + 10 * 9.81)
            self.expect_close(run["contact_force_z"][row], load, 1e-7, "load")
            self.assertLess(abs(run["contact_force_x"][row]), 1e-6 * load)

    def test_a_block_that_slides_between_two(self):
        """Its place is where friction leaves it; what pushes it on both sides is equal."""
        lower = box("lower", "-0.5, 0", "0.5, 1", "6, 6", 5.54945e7, poisson=0.45)
        upper = box(
            "upper",
            "-0.45, 1",
            "0.45, 1.3",
            "6, 1",
            1.80161e7,
            "Dirichlet = 3: 7.83818e-05*sin(6*t); -0.000339654*t",
            poisson=0,
        )
        pairs = ["lower[2] : floor", "upper[2] : lower[3]"]
        text = scene(2, 20, {"lower": lower, "upper": upper}, FLOOR, pairs, 0.1, "linearised")
        run = check_history.Run(text, "between")
        self.assertGreater(max(run["slip_nodes"]), 10)
        self.expect_ledger_closes(run, driven=True, accuracy=1e-7)

    def test_what_squeezes_may_add_up_to_nothing(self):
        """A block is pressed and unloaded to round-off."""
        block = box(
            "b",
            "-500, 0",
            "500, 300",
            "9, 2",
            2676.49,
            "Traction = 3: 0.206758*sin(9*t)*sin(3.14159265*t); -4.13516*sin(3.14159265*t)",
            poisson=0,
        )
        text = scene(2, 10, {"b": block}, FLOOR, ["b[2] : floor"], 0.1)
        run = check_history.Run(text, "unloaded")
        self.assertEqual(len(run), 11)
        self.assertLess(abs(run["contact_force"][10]), 1e-8 * max(run["contact_force"]))

    def test_stacks_that_nothing_presses(self):
        """Until a round ram comes down."""
        bodies = {
            "a": box("a", "-0.5, 0", "0.5, 0.3", "9, 3", 1e7),
            "b": box("b", "-0.45, 0.3", "0.45, 0.6", "9, 3", 5e6),
        }
        ram = {
            "ram": ["Shape = sphere", "Centre = 0, 0.91", "Radius = 0.3", "Motion = 0; -0.02*t"]
        }
        pairs = ["a[2] : floor", "b[2] : a[3]", "b[3] : ram"]
        text = scene(2, 10, bodies, {**FLOOR, **ram}, pairs, 0.6, "follow")
        run = check_history.Run(text, "ram")
        self.assertLess(max(run["contact_force"][:6]), 1e-9 * run["contact_force"][10])


if __name__ == "__main__":
    check_history.main()
