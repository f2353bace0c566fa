# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What an obstacle does to a body depends neither on the place of the origin nor on the unit of
length: a scene moved by 1e6, or with lengths and times multiplied by 1e-9, has the same contact
force, up to the round-off of its coordinates. And an obstacle that ends carries nothing past its
end."""

import check_history

#: A disc that falls on a hill of a wave, beside its top: force and resultant turn on the normals.
#: Lengths and times are in units of `unit`, the origin of the wave is at (`x0`, `x0`).
WAVE = """
set Dimension = 2
subsection Time
  set Step size = {step!r}
  set End time  = {end!r}
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape            = ball
    set Centre           = {x!r}, {y!r}
    set Radius           = {unit!r}
    set Refinements      = 3
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0; -2
  end
end
subsection Obstacles
  set Names = wave
  subsection wave
    set Shape           = function
    set Signed distance = y - {x0!r} - 0.1*{unit!r}*sin(3*(x - {x0!r})/{unit!r})
  end
end
subsection Contact
  set Motion = linearised
  set Pairs  = disc : wave
end
"""

#: A box that slides at speed 10 on a table that ends at x = 0.5; its rear is there at t = 0.03. It
#: is so fast that it has not tipped by then.
TABLE = """
set Dimension = 2
subsection Time
  set Step size = 1e-3
  set End time  = 0.06
end
subsection Bodies
  set Names = box
  subsection box
    set Shape            = box
    set Lower corner     = 0.2, 0
    set Upper corner     = 0.4, 0.1
    set Repetitions      = 4, 2
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 10; 0
    set Body force       = 0; -10
  end
end
subsection Obstacles
  set Names = table, floor
  subsection table
    set Normal = 0, 1
    set Extent = 1
  end
  subsection floor
    set Point  = 0, -0.5
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = box[2] : table
  subsection box[2] : table
    set Friction coefficient = 0.2
  end
end
"""


def wave(unit=1.0, x0=0.0):
    return WAVE.format(
        unit=unit, x0=x0, x=x0 + 0.3 * unit, y=x0 + 1.2 * unit, step=0.005 * unit, end=0.2 * unit
    )


class Obstacles(check_history.SceneTest):
    def expect_same_forces(self, run, other, unit, tolerance):
        self.expect_contact(run)
        self.assertEqual(run["active_nodes"], other["active_nodes"])
        scale = max(run["contact_force"])
        for column in ("contact_force", "contact_force_x", "contact_force_y"):
            for row, (a, b) in enumerate(zip(run[column], other[column])):
                self.assertLessEqual(
                    abs(a - b / unit), tolerance * scale, f"{column} in row {row}: {a} and {b}"
                )

    def test_a_function_far_from_the_origin(self):
        """Coordinates have 1e-10 of round-off there, a depth of contact is 0.05."""
        here, there = check_history.Run(wave(), "here"), check_history.Run(wave(x0=1e6), "there")
        self.expect_same_forces(here, there, 1.0, 1e-7)

    def test_a_function_in_small_units(self):
        """The force, per depth in 2d, is a stress times a length. A radius of less than 1e-8 is
        refused."""
        large = check_history.Run(wave(20.0), "large")
        small = check_history.Run(wave(20e-9), "small")
        self.expect_same_forces(large, small, 1e-9, 1e-8)

    def test_a_body_falls_from_the_end_of_its_obstacle(self):
        """While it is on the table something carries it; afterwards it falls freely, and nothing
        has been done to its energy but by friction."""
        with_friction = ("newmark", "contact-stabilized", "laursen-love", "hager-hueeber-wohlmuth")
        without = ("moreau-jean", "khenous-laborde-renard")
        for scheme in with_friction + without:
            with self.subTest(scheme=scheme):
                overrides = [f"Time/Scheme={scheme}"]
                if scheme in without:
                    overrides.append("Contact/box[2] : table/Friction coefficient=0")
                run = check_history.Run(TABLE, f"table_{scheme}", overrides)
                self.expect_contact(run)
                mass = 0.02
                late = [row for row, time in enumerate(run["time"]) if time > 0.0325]
                for row in late:
                    self.assertEqual(run["active_nodes"][row], 0)
                    if scheme in with_friction:
                        self.assertEqual(run["friction_force"][row], 0.0)
                    rate = (run["momentum_y"][row] - run["momentum_y"][row - 1]) / 1e-3
                    self.expect_close(rate, -10 * mass, 1e-8, "rate of momentum")
                self.expect_ledger_closes(run)
                self.assertGreater(
                    run["time"][
                        max(row for row, force in enumerate(run["contact_force"]) if force > 0)
                    ],
                    0.02,
                )

    def test_what_lies_past_the_end_at_the_start(self):
        """A box with the last of its five lowest nodes past the end of the table rests on the
        others; what has no end carries all of them."""
        lying = [
            "Bodies/box/Initial velocity=0;0",
            "Bodies/box/Lower corner=0.32,0",
            "Bodies/box/Upper corner=0.52,0.1",
            "Time/Start=equilibrium",
            "Time/End time=0.005",
        ]
        run = check_history.Run(TABLE, "past_the_end", lying)
        self.assertEqual(max(run["active_nodes"]), 4)
        self.expect_close(run["contact_force"][1], 0.2, 0.05, "weight")
        run = check_history.Run(TABLE, "endless", lying + ["Obstacles/table/Extent="])
        self.assertEqual(max(run["active_nodes"]), 5)


if __name__ == "__main__":
    check_history.main()
