# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Dirichlet conditions at the start of a run and at obstacles, against statics and the theory of
plane waves. What the conditions of a scene leave open is refused with the place and the values."""

import math
import pathlib
import subprocess

import check_history

BLOCK = """
set Dimension = 2
subsection Time
  set Start     = equilibrium
  set Step size = 1e-2
  set End time  = 0.3
end
subsection Bodies
  set Names = block
  subsection block
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = 2, 1
    set Repetitions     = 4, 2
    set Young's modulus = 500
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; -10
    set Dirichlet       = 2: 0; -
  end
end
subsection Obstacles
  set Names = slope
  subsection slope
    set Normal = 0.5, 1
  end
end
subsection Contact
  set Pairs = block[2] : slope
end
subsection Probes
  set Names = foot
  subsection foot
    set Point = 0, 0
  end
end
"""

#: A bar of length 10 and cross section 0.1 that is pulled at its end, without any contact.
PULLED_BAR = (
    """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = 0.3
end
subsection Bodies
  set Names = bar
"""
    + check_history.bar("bar", "Dirichlet=0: -t; 0")
    + """end
"""
)


class Conditions(check_history.SceneTest):
    def test_guided_nodes_rest_on_a_slope(self):
        """The base moves along y only; the slope carries the weight with a force along its normal,
        of which the guides take the part along x. At rest nothing changes; dropped from above, the
        energy is explained and no node goes through."""
        rest = check_history.Run(BLOCK, "slope-rest")
        for row in range(len(rest)):
            force = rest.vector("contact_force", row)
            self.expect_close(force[1], 20.0, 1e-9, f"weight in row {row}")
            self.expect_close(force[0], 10.0, 1e-9, f"force that the guides take in row {row}")
            self.expect_close(
                rest["contact_force"][row], math.hypot(*force), 1e-9, f"along the normal, row {row}"
            )
        self.assertIn("an obstacle is oblique to prescribed directions", rest.log)

        drop = check_history.Run(
            BLOCK, "slope-drop", ["Time/Start=given", "Bodies/block/Initial velocity=0; -2"]
        )
        self.expect_contact(drop)
        self.expect_ledger_closes(drop)
        self.expect_no_gain_of_energy(drop)
        self.expect_no_penetration(drop, 2.0)
        self.assertGreaterEqual(min(drop.probes["foot"]["gap"]), -1e-12)

    def test_a_condition_that_starts_with_a_velocity_does_not_alternate(self):
        """A plane wave with the stress rho c v runs into the bar, c = 30: until it comes back, the
        reaction is rho c v times the cross section. Nodes that started at rest would alternate
        between rest and twice the velocity for ever."""
        run = check_history.Run(PULLED_BAR, "pulled")
        reaction = [
            work / step for work, step in zip(run["work_external"][1:], run["step_size"][1:])
        ]
        for row, force in enumerate(reaction):
            # The first steps smear the front of the wave.
            self.expect_close(force, 3.0, 0.6 if row < 6 else 0.1, f"reaction in row {row + 1}")
        for row in range(10, len(reaction)):
            self.assertLess(abs(reaction[row] - reaction[row - 1]), 0.1)
        self.assertIn("prescribed nodes start with the velocity of their condition", run.log)

    def refusal(self, name, scene, overrides):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{name}.prm").write_text(scene, encoding="utf-8")
        command = [check_history.settings["executable"], str(folder / f"{name}.prm"), "--validate"]
        for override in overrides:
            command += ["--set", override]
        result = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        return result.stderr

    def test_conditions_that_contradict_each_other_are_refused(self):
        message = self.refusal(
            "contradiction", BLOCK, ["Bodies/block/Dirichlet=2: 0; - | 0: 0.1*t; 0"]
        )
        for part in ("Bodies/block/Dirichlet", "boundaries 2 and 0", "(0 0)", "in x", "(-)"):
            self.assertIn(part, message)

    def test_what_becomes_no_number_is_named(self):
        """With key, boundary and time, on one and two processes; what was computed stays."""
        for key, value in (
            ("Dirichlet", "0: 0; 0*sqrt(abs(t-0.105)-0.001)"),
            ("Traction", "1: 0; sqrt(abs(t-0.105)-0.001)"),
        ):
            for processes in (1, 2):
                with self.subTest(key=key, processes=processes):
                    with self.assertRaises(AssertionError) as failure:
                        check_history.Run(
                            PULLED_BAR, "number", [f"Bodies/bar/{key}={value}"], processes
                        )
                    message = str(failure.exception)
                    self.assertIn("exit status 1", message)
                    self.assertIn(f"{key}", message)
                    self.assertIn("is not a finite number at the time 0.10", message)
                    self.assertEqual(message.count("the run failed"), 1)

    def test_a_moving_condition_oblique_to_an_obstacle_is_refused(self):
        message = self.refusal("moving", BLOCK, ["Bodies/block/Dirichlet=2: 0.1*t; -"])
        for part in ("Bodies/block/Dirichlet", "'slope'", "in x", "changes in time"):
            self.assertIn(part, message)

    def test_it_is_refused_at_any_obstacle_that_a_node_may_meet(self):
        """A block that is drawn along a floor, which is parallel, onto a ramp."""
        overrides = [
            "Bodies/block/Dirichlet=2: 0.1*t; -",
            "Obstacles/Names=slope, ramp",
            "Obstacles/slope/Normal=0, 1",
            "Obstacles/ramp/Point=3, 0",
            "Obstacles/ramp/Normal=-1, 1",
            "Contact/Pairs=block[2] : slope, block[2] : ramp",
        ]
        self.assertIn("'ramp' is oblique", self.refusal("ramp", BLOCK, overrides))


if __name__ == "__main__":
    check_history.main()
