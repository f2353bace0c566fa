# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What happens to one body has no influence on another that it does not touch: a block at rest on a
floor keeps its pressure, the one of equilibrium, while a ball lands a hundred lengths away. Steps
are solved for all bodies together, to an accuracy that belongs to the largest energy of the run;
more than that the block must not feel, whatever the scheme.

Bodies that no pair connects are separate problems: two discs that hit a floor one after the other
do what each of them does alone, and while the late one flies, which is half of the time, iterations
go on without it: a quarter of the work of solving for both is left out."""

import check_history


def ball(name, x, height):
    """The section of a disc that falls."""
    return f"""  subsection {name}
    set Shape            = ball
    set Centre           = {x}, {height}
    set Radius           = 1
    set Refinements      = 3
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0; -2
  end
"""


BLOCK_AND_BALL = (
    """
set Dimension = 2
subsection Time
  set Start     = equilibrium
  set Step size = 5e-3
  set End time  = 0.3
end
subsection Bodies
  set Names = block, ball
  subsection block
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = 1, 1
    set Repetitions     = 4, 4
    set Young's modulus = 500
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; -10
  end
"""
    + ball("ball", 100, 1.2)
    + "end\n"
    + check_history.on_floor("block[2]", "ball")
    + """subsection Probes
  set Names = foot, pole
  subsection foot
    set Point = 0.5, 0
  end
  subsection pole
    set Point = 100, 0.2
  end
end
"""
)

DISCS = {"early": (0, 1.05), "late": (10, 1.6)}  # centres


def discs(*names):
    """Discs that hit a floor at times 0.025 and 0.3, each of them within 0.25."""
    bodies = "".join(ball(name, *DISCS[name]) for name in names)
    probes = "".join(
        f"  subsection of_{name}\n    set Point = {DISCS[name][0]}, {DISCS[name][1] - 1}\n  end\n"
        for name in names
    )
    return (
        "set Dimension = 2\nsubsection Time\n  set Step size = 5e-3\n  set End time  = 0.6\nend\n"
        f"subsection Bodies\n  set Names = {', '.join(names)}\n{bodies}end\n"
        + check_history.on_floor(*names)
        + f"subsection Probes\n  set Names = {', '.join('of_' + name for name in names)}\n"
        + f"{probes}end\n"
    )


class SeparateContacts(check_history.SceneTest):
    def test_a_ball_that_lands_far_away_does_not_lift_a_block(self):
        for scheme in check_history.SCHEMES + check_history.FURTHER_SCHEMES:
            with self.subTest(scheme=scheme):
                run = check_history.Run(BLOCK_AND_BALL, scheme, [f"Time/Scheme={scheme}"])
                self.assertGreater(max(run.probes["pole"]["pressure"]), 10, "the ball lands")
                pressure = run.probes["foot"]["pressure"]
                self.expect_close(pressure[0], 10.0, 0.1, "weight over width, more in the middle")
                for row, value in enumerate(pressure):
                    self.expect_close(value, pressure[0], 1e-7, f"pressure in row {row}")

    def test_discs_that_hit_one_after_the_other_do_what_each_does_alone(self):
        together = check_history.Run(discs("early", "late"), "together")
        line = next(x for x in together.log.splitlines() if "separate bodies" in x)
        self.assertGreater(float(line.split()[2]), 20, line)
        for name in DISCS:
            alone = check_history.Run(discs(name), name)
            self.assertNotIn("separate bodies", alone.log)
            for column in ("pressure", "normal_displacement", "normal_velocity"):
                here, there = (run.probes[f"of_{name}"][column] for run in (together, alone))
                largest = max(abs(value) for value in there)
                self.assertGreater(largest, 0.1, column)
                for row, (a, b) in enumerate(zip(here, there)):
                    self.assertLess(abs(a - b), 1e-8 * largest, f"{name}: {column} in row {row}")


if __name__ == "__main__":
    check_history.main()
