#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""All frames that move with a constant velocity are alike (Galilei): a body and what it meets get
the same additional velocity, and forces, steps and meshes stay as they are, to what solvers leave.
Schemes, the sizes of steps, indicators and probes have to look at motions relative to obstacles.

And steps of variable size see a touch ahead, be it of an obstacle that comes or of two bodies whose
normals follow their motion: the last step of the flight does not lead across it, and an impact
takes next to no energy.
"""

import math

import check_history
import following_scenes as scenes


def plane(velocity):
    keys = scenes.entries(Shape="plane", Normal="0, 1", Velocity=f"0; {velocity!r}")
    return scenes.obstacles({"floor": keys})


def rocking_box(frame):
    """It falls with a spin, and hits with one end after the other."""
    motion = f"set Initial velocity = 0; {frame!r} - x"
    box = scenes.box("box", "-1, 0.02", "1, 0.3", "24, 4", motion, "set Body force = 0; -1")
    return scenes.scene(
        [box],
        ["box : floor"],
        0.8,
        scheme="contact-stabilized-projected",
        step=4e-3,
        obstacles=plane(frame),
    )


def falling_disc(frame, level=3):
    """It touches after 0.25."""
    ball = scenes.entries(Shape="ball", Centre="0, 0.8", Radius=0.5, Refinements=level)
    disc = scenes.body("disc", *ball, f"set Initial velocity = 0; {frame - 1.2!r}")
    return scenes.scene([disc], ["disc : floor"], 0.6, step=4e-3, obstacles=plane(frame))


def block_in_a_bowl(frame):
    """It slides along a hollow circle, without weight."""
    block = scenes.box(
        "block",
        "-0.01, -0.9999499987499375",
        "0.01, -0.97995",
        "2, 2",
        f"set Initial velocity = -0.5*y + {frame!r}; 0.5*x",
    )
    bowl = scenes.entries(Shape="sphere", Radius=1, Bodies_inside="true", Velocity=f"{frame!r}; 0")
    return scenes.scene(
        [block],
        ["block : bowl"],
        0.6,
        scheme="contact-stabilized-projected",
        step=0.02,
        obstacles=scenes.obstacles({"bowl": bowl}),
    )


def two_discs(angle):
    """One flies to the other, along a direction, and touches after 0.5."""
    c, s = math.cos(angle), math.sin(angle)
    discs = [
        scenes.body(
            name,
            *scenes.entries(
                Shape="ball", Centre=f"{x * c!r}, {x * s!r}", Radius=0.5, Refinements=4
            ),
            f"set Initial velocity = {v * c!r}; {v * s!r}",
        )
        for name, x, v in (("a", 0.0, 0.6), ("b", 1.3, 0.0))
    ]
    return scenes.scene(discs, ["a : b"], 0.8, step=4e-3)


def lost(run):
    """Of the energy, in the frame of the scene."""
    energy = run["total_energy"]
    return (energy[0] - energy[-1]) / energy[0]


class MovingFrames(check_history.SceneTest):
    def expect_alike(self, runs, columns, tolerance):
        for other in runs[1:]:
            self.assertEqual(len(other), len(runs[0]))
            for column in columns:
                scale = max(map(abs, runs[0][column]))
                self.assertGreater(scale, 0.0)
                for row, (a, b) in enumerate(zip(runs[0][column], other[column])):
                    self.assertLess(abs(a - b), tolerance * scale, f"{column} in row {row}")

    def test_a_box_that_rocks(self):
        """Predictors that stopped a node in vain are found in any frame."""
        runs = [
            check_history.Run(rocking_box(frame), f"rocks-{frame}") for frame in (0.0, 0.7, -2.0)
        ]
        self.expect_alike(runs, ["contact_force", "elastic_energy"], 1e-6)

    def test_a_block_in_a_bowl_that_moves(self):
        """It keeps its energy as in one that is at rest: to round-off, not to first order."""
        rest = check_history.Run(block_in_a_bowl(0.0), "bowl-0")
        self.assertLess(abs(lost(rest)), 1e-6)
        for frame in (1e-9, 0.1):
            run = check_history.Run(block_in_a_bowl(frame), f"bowl-{frame}")
            self.expect_alike([rest, run], ["contact_force"], 1e-5)
            self.assertLess(max(map(abs, run["work_predictor"])), 1e-9 * run["total_energy"][0])

    def test_sizes_of_steps(self):
        """Their errors are parts of the energy, and that depends on the frame; but a touch is seen
        ahead in all of them, and the impact is the same."""
        settings = ["Time/Step tolerance=0.3", "Time/Maximum step size=1"]
        for control in ("embedded", "doubling"):
            largest = []
            for frame in (0.0, 0.7, 1.8):
                run = check_history.Run(
                    falling_disc(frame),
                    f"{control}-{frame}",
                    [*settings, f"Time/Step size control={control}"],
                )
                touch = next(k for k, force in enumerate(run["contact_force"]) if force > 0.0)
                self.assertLess(run["time"][touch] - run["time"][touch - 1], 0.01)
                largest.append(max(run["contact_force"]))
            self.assertLess(max(largest), 1.1 * min(largest))

    def test_meshes(self):
        settings = [
            "Adaptivity/Indicator=distance",
            "Adaptivity/Distance=0.02",
            "Adaptivity/Maximum level=6",
        ]
        runs = [
            check_history.Run(falling_disc(frame), f"mesh-{frame}", settings)
            for frame in (0.0, 1.2)
        ]
        self.expect_alike(runs, ["cells", "contact_force"], 1e-5)

    def test_probes(self):
        """A node that rests on a floor that rises has no velocity relative to it."""
        probe = "subsection Probes\n set Names = p\n subsection p\n set Point = 0, 0.3\n end\nend\n"
        readings = []
        for frame in (0.0, 1.2):
            run = check_history.Run(falling_disc(frame) + probe, f"probe-{frame}")
            readings.append(run.probes["p"]["normal_velocity"])
        self.assertGreater(max(map(abs, readings[0])), 1.0)
        for row, (a, b) in enumerate(zip(*readings)):
            if row > 0:  # before the first step nobody has seen the floor move
                self.assertLess(abs(a - b), 1e-6, f"row {row}")


class Ahead(check_history.SceneTest):
    def test_two_bodies(self):
        settings = ["Time/Step tolerance=0.3", "Time/Maximum step size=1"]
        for control in ("embedded", "doubling"):
            for angle in (0.0, 0.5, math.pi):
                run = check_history.Run(
                    two_discs(angle),
                    f"discs-{control}-{angle:.1f}",
                    [*settings, f"Time/Step size control={control}"],
                )
                touch = next(k for k, force in enumerate(run["contact_force"]) if force > 0.0)
                across = run["time"][touch] - run["time"][touch - 1]
                self.assertLess(across, 0.02, f"{control}: step of {across} across the touch")
                self.assertLess(abs(lost(run)), 0.01)


if __name__ == "__main__":
    check_history.main()
