#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Blocks of two cells that slide on curved obstacles on their corners, one of which may carry next
to nothing. What is small beside everything else is still right: no obstacle pulls, smooth sliding
needs no smaller steps, and the ledger closes the better the smaller the tolerance is.
"""

import check_history

SCENE = """
set Dimension = 2
subsection Time
  set Step size = {step}
  set End time  = {end}
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Lower corner     = -{half}, 0
    set Upper corner     = {half}, {half}
    set Repetitions      = 2, 1
    set Rotation         = {turn}
    set Rotation centre  = 0, 0
    set Translation      = {place}
    set Young's modulus  = {modulus}
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Damping          = 0, {damping}
    set Initial velocity = {velocity}; 0
    set Body force       = 0; -{gravity}
  end
end
subsection Obstacles
  set Names = hill
  subsection hill
    {obstacle}
  end
end
subsection Contact
  set Pairs = block : hill
  subsection block : hill
    set Friction coefficient = {friction}
  end
end
subsection Solver
  set Tolerance = {tolerance}
end
"""

#: A hill that falls ever more steeply.
STEEP = "set Shape = function\n    set Signed distance = (y + x^2)/sqrt(1 + 4*x^2)"

#: A hollow in the form of a parabola.
PARABOLA = "set Shape = function\n    set Signed distance = (y - 0.5*x^2)/sqrt(1 + x^2)"


class LightCorners(check_history.SceneTest):
    """See the beginning of the file."""

    def test_nothing_is_pulled_on_a_hill(self):
        """The second corner is held in every other step. Its velocity is not stopped where the hill
        would have to pull it: the guard, which watches that, lets the run go on."""
        for step in (0.004, 0.0042, 0.005):
            with self.subTest(step=step):
                scene = SCENE.format(
                    step=step,
                    end=0.6,
                    half=0.01020622941295956,
                    turn=-11.537568221839965,
                    place="0.2, 0.9798077381109644",
                    modulus=1e4,
                    damping=0.001,
                    velocity=0,
                    gravity=1,
                    obstacle="set Shape = sphere",
                    friction=0,
                    tolerance=2e-11,
                )
                run = check_history.Run(scene, f"hill_{step}")
                energies = run["total_energy"]
                gain = max(new - old for old, new in zip(energies, energies[1:]))
                self.assertLess(gain, check_history.ACCURACY * max(run["kinetic_energy"]))
                self.expect_no_penetration(run, 0.01)

    def steep(self, name, more, processes=1):
        """A block takes off from a hill, goes thirty times its size and turns by two radians."""
        values = {"step": 0.004, "end": 2, "half": 0.05, "turn": 0, "place": "0, 0.001"}
        values |= {"modulus": 1e4, "damping": 0.001, "velocity": 1.5, "gravity": 2}
        values |= {"obstacle": STEEP, "friction": 0, "tolerance": 2e-11}
        return check_history.Run(SCENE.format(**values), name, more, processes)

    def test_forces_of_what_hardly_deforms(self):
        """The elastic energy is 1e-4 of that of the motion, and what a tolerance of the motion
        leaves in it is 1e-6. It is right to 1e-8 nevertheless, wherever the body is: one and two
        processes agree."""
        mesh = ["Bodies/block/Repetitions=8, 4"]
        one, two = (self.steep(f"steep_{n}", mesh, n) for n in (1, 2))
        self.assertLess(max(one["elastic_energy"]), 1e-3 * max(one["kinetic_energy"]))
        self.expect_same_history(two, one, 1e-8)
        energies = list(zip(one["elastic_energy"], two["elastic_energy"]))
        most = max(one["elastic_energy"])
        self.assertLess(max(abs(a - b) for a, b in energies), 1e-8 * most)
        residual = max(map(abs, one["energy_residual"]))
        self.assertLess(residual, 1e-11 * max(one["kinetic_energy"]))

    def test_ledger_of_a_stiff_body_far_from_home(self):
        """Courant number 90, two cells: forces on what has gone thirty times its size have
        round-off that is 1e-9 of the energy, if it is thought to work along that way."""
        run = self.steep("stiff", ["Bodies/block/Young's modulus=1e6"])
        residual = max(map(abs, run["energy_residual"]))
        self.assertLess(residual, 1e-10 * max(run["kinetic_energy"]))

    def parabola(self, name, **values):
        """A block that slides in the parabola."""
        usual = {"damping": 0.01, "gravity": 10, "obstacle": PARABOLA, "modulus": 15856.5}
        usual |= {"half": 0.005014844555333743, "turn": -4.409604889029034, "tolerance": 2e-11}
        usual |= {"place": "-0.0771144381190551, 0.0030858182832087895", "velocity": -0.115}
        return check_history.Run(SCENE.format(**(usual | values)), name)

    def test_smooth_sliding_needs_no_smaller_steps(self):
        """What the discrete gradient of an expression leaves of a gap is within what is
        accepted."""
        calm = {"half": 0.0050735569859873385, "turn": -9.768309829725377, "modulus": 626.2682}
        calm |= {"place": "-0.17216044726485613, 0.014832109801317654", "velocity": 0}
        run = self.parabola(
            "smooth", **calm, step=0.002, end=0.6, friction=0, damping=0, gravity=0.3
        )
        self.assertEqual(sum(run["rejected_steps"]), 0)
        self.expect_no_penetration(run, 0.01)

    def test_smaller_tolerances_close_the_ledger(self):
        """With friction, whose linear systems have as many unknowns here as their solver makes
        steps: residuals stay those of the solution when its space is exhausted."""
        worst = []
        for tolerance in (2e-11, 2e-12, 2e-13):
            name = f"tolerance_{tolerance}"
            run = self.parabola(name, step=0.0005, end=0.03, friction=0.05, tolerance=tolerance)
            residual = max(map(abs, run["energy_residual"]))
            worst.append(residual / max(run["kinetic_energy"]))
        self.assertLess(worst[0], 1e-10)
        self.assertLess(worst[2], 1e-11)


if __name__ == "__main__":
    check_history.main()
