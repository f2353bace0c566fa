#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Bodies on what is driven: a base whose displacement is prescribed, and a belt. Where a run begins
in motion, nothing but friction changes the speed of a body, and what moves along with its base or
belt goes on so (Galilean invariance). What prescribed displacements cannot do is told: a slave
surface that is driven through its master, and a velocity that jumps, after which schemes without
damping alternate.
"""

import check_history

GRAVITY = 10.0
COEFFICIENT = 0.2


def box(name, lower, upper, repetitions, *entries):
    """The subsection of a body of soft rubber."""
    return f"""
  subsection {name}
    set Shape           = box
    set Lower corner    = {lower}
    set Upper corner    = {upper}
    set Repetitions     = {repetitions}
    set Young's modulus = 1e6
    set Poisson's ratio = 0
    set Density         = 100
    {chr(10).join("set " + entry for entry in entries)}
  end"""


def scene(time, bodies, pair, obstacles="", coefficient=0.0):
    """A scene of boxes with one pair."""
    entries = "".join(box(name, *values) for name, values in bodies.items())
    return f"""
set Dimension = 2
subsection Time
  {time}
end
subsection Bodies
  set Names = {", ".join(bodies)}{entries}
end
{obstacles}
subsection Contact
  set Pairs = {pair}
  subsection {pair}
    set Friction coefficient = {coefficient}
  end
end
"""


def on_base(motion, *entries):
    """A block on a base that moves along x."""
    driven = f"Dirichlet = 2: {motion}; 0 | 3: {motion}; 0"
    return scene(
        "set Step size = 2e-3\nset End time = 0.02\nset Start = equilibrium",
        {
            "base": ("-1, -0.1", "1, 0", "20, 1", driven),
            "block": ("-0.2, 0", "0.2, 0.1", "8, 2", f"Body force = 0; -{GRAVITY}", *entries),
        },
        "block[2] : base[3]",
        coefficient=COEFFICIENT,
    )


def on_belt(belt, speed):
    """A block on a belt."""
    return scene(
        "set Step size = 2e-3\nset End time = 0.04\nset Start = equilibrium",
        {
            "block": (
                "0, 0",
                "0.2, 0.1",
                "8, 4",
                f"Body force = 0; -{GRAVITY}",
                f"Initial velocity = {speed}; 0",
            )
        },
        "block[2] : belt",
        obstacles=f"""
subsection Obstacles
  set Names = belt
  subsection belt
    set Normal   = 0, 1
    set Velocity = {belt}; 0
  end
end""",
        coefficient=COEFFICIENT,
    )


def press(pair):
    """A ram that is driven down onto a block, and beyond its surface."""
    return scene(
        "set Step size = 1e-3\nset End time = 0.06",
        {
            "ram": ("0, 0.12", "0.2, 0.15", "8, 2", "Dirichlet = 2: -; -0.5*t | 3: -; -0.5*t"),
            "block": ("0, 0", "0.2, 0.1", "8, 4", "Dirichlet = 2: 0; 0"),
        },
        pair,
    )


def pull(motion):
    """A rod whose end is pulled, far from a wall."""
    return scene(
        "set Step size = 2e-4\nset End time = 0.02",
        {"rod": ("0, 0", "1, 0.1", "20, 2", f"Dirichlet = 0: {motion}; -")},
        "rod[1] : wall",
        obstacles="""
subsection Obstacles
  set Names = wall
  subsection wall
    set Point  = 5, 0
    set Normal = -1, 0
  end
end""",
    )


class DrivenBodies(check_history.SceneTest):
    def speeds(self, run):
        return run.table("bodies")["body_block_velocity_x"]

    def test_a_block_at_rest_does_not_start_with_the_base(self):
        run = check_history.Run(on_base("0.05*sin(10*t)"), "base")
        for time, speed in zip(run["time"], self.speeds(run)):
            self.assertAlmostEqual(speed, COEFFICIENT * GRAVITY * time, delta=1e-6)

    def test_what_moves_with_the_base_goes_on(self):
        run = check_history.Run(on_base("0.5*t", "Initial velocity = 0.5; 0"), "along")
        for speed in self.speeds(run):
            self.assertAlmostEqual(speed, 0.5, delta=1e-9)
        self.assertLess(max(run["friction_force"]), 1e-6)

    def test_belts_are_known_at_the_start(self):
        weight = 0.02 * 100 * GRAVITY
        for belt, speed, drag in ((0.3, 0.3, 0), (1, 0.5, 1), (-3, -3, 0), (0.2, 0, 1), (0, 1, -1)):
            with self.subTest(belt=belt, speed=speed):
                run = check_history.Run(on_belt(belt, speed), f"belt_{belt}_{speed}")
                friction = COEFFICIENT * weight * abs(drag)
                self.assertAlmostEqual(run["friction_force"][0], friction, delta=1e-6)
                for time, found in zip(run["time"], self.speeds(run)):
                    expected = speed + drag * COEFFICIENT * GRAVITY * time
                    self.assertAlmostEqual(found, expected, delta=1e-6)

    def test_a_driven_slave_that_goes_through_its_master_is_told(self):
        through = check_history.Run(press("ram[2] : block[3]"), "through")
        self.assertEqual(max(through["contact_force"]), 0)
        self.assertIn("'ram[2] : block[3]' go through each other", through.log)
        self.assertIn("exchange slave and master", through.log)
        against = check_history.Run(press("block[3] : ram[2]"), "against")
        self.assertGreater(max(against["contact_force"]), 1e4)
        self.assertNotIn("go through each other", against.log)

    def test_velocities_that_jump_are_told(self):
        jump, smooth = "0.1*max(0, t-0.004)", "0.1*max(0, t-0.004)^2/(max(0, t-0.004)+4e-3)"
        for motion, extra, is_told in (
            (jump, [], True),
            (smooth, [], False),
            (jump, ["Time/Scheme=generalized-alpha", "Time/Spectral radius=0.6"], False),
        ):
            with self.subTest(motion=motion, extra=extra):
                run = check_history.Run(pull(motion), f"pull_{is_told}_{len(extra)}", extra)
                self.assertEqual("velocity jumps" in run.log, is_told, run.log)


if __name__ == "__main__":
    check_history.main()
