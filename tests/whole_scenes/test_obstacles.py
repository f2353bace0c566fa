# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What an obstacle does to a body depends neither on the place of the origin nor on the unit of
length: a scene moved by 1e6, or with lengths and times multiplied by 1e-9, has the same contact
force, up to the round-off of its coordinates."""

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
  set Pairs = disc : wave
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


if __name__ == "__main__":
    check_history.main()
