#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Equilibria at curved obstacles: the normals of contact are those of the place that is found. So a
body that starts in equilibrium stays at rest, its forces carry its weight, and load steps come to
the same state however many they are.
"""

import math

import check_history
from following_scenes import box, friction, obstacles, scene
import test_moving_obstacles as punches

LYING = """
set Dimension = 2
subsection Time
  set Start     = equilibrium
  set Step size = 0.01
  set End time  = 0.5
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape           = ball
    set Centre          = 0, -1.495
    set Radius          = 0.5
    set Refinements     = 5
    set Young's modulus = 300
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; -5
  end
end
subsection Obstacles
  set Names = bowl
  subsection bowl
    set Shape         = sphere
    set Radius        = 2
    set Bodies inside = true
    {motion}
  end
end
subsection Contact
  set Pairs  = disc : bowl
  set Motion = follow
  subsection disc : bowl
    set Friction coefficient = 0.3
  end
end
"""


class Equilibria(check_history.unittest.TestCase):
    """See the beginning of the file."""

    def test_disc_lies_in_a_bowl(self):
        """At rest for 50 steps, and outside: with the normals of where it was without load its
        nodes would end inside of the bowl. The bowl carries its weight, also one that is told how
        to move and does not."""
        for motion in ("", "set Velocity = 0; 0"):
            with self.subTest(motion=motion):
                history = check_history.Run(LYING.format(motion=motion), "lying").history
                energy = max(history["elastic_energy"])
                self.assertLess(max(history["kinetic_energy"]), 1e-15 * energy)
                mass = 0.25 * math.pi
                self.assertAlmostEqual(history["contact_force_y"][0] / (5 * mass), 1, delta=1e-3)
                for row in (0, -1):
                    self.assertAlmostEqual(
                        history["contact_force_y"][row], history["contact_force_y"][1], delta=1e-8
                    )
                    self.assertLess(abs(history["contact_force_x"][row]), 1e-8)
                self.assertLess(max(history["geometric_penetration"]), 1e-12)

    def test_a_round_body_that_would_spin_up_is_told(self):
        """A disc that slides finds an equilibrium that friction could not let it have; the same
        disc at rest, and a block that slides, have one."""
        disc = LYING.format(motion="").replace("0, -1.495", "0, -1.5")
        flat = [
            "Time/End time=0.02",
            "Obstacles/bowl/Shape=plane",
            "Obstacles/bowl/Point=0, -2",
            "Obstacles/bowl/Normal=0, 1",
            "Contact/disc : bowl/Friction coefficient=0.01",
        ]
        block = ["Bodies/disc/Shape=box", "Bodies/disc/Lower corner=-0.2, -2"]
        block += ["Bodies/disc/Upper corner=0.2, -1.6"]
        sliding = "Bodies/disc/Initial velocity=0.1; 0"
        for overrides, is_told in (([sliding], True), ([], False), ([*block, sliding], False)):
            run = check_history.Run(disc, "turned", [*flat, *overrides])
            self.assertEqual("holds the body 'disc' because" in run.log, is_told, overrides)

    def test_what_is_held_only_far_away_is_refused(self):
        """A block without friction on a soft one, under a load along it: contact of its deformed
        surfaces holds it, by their linear conditions, after a way of many times its size. From no
        deformation the run starts as ever."""
        above = box("s", "-0.2, 1", "0.2, 1.3", "4, 3", "set Body force = 0.3; -1")
        below = box("l", "-1, 0", "1, 1", "8, 4", "set Dirichlet = 2: 0; 0")
        text = scene([above, below], ["s : l"], 0.02)
        with self.assertRaisesRegex(AssertionError, "moved along each other by more than half"):
            check_history.Run(text, "far", ["Time/Start=equilibrium"])
        check_history.Run(text, "near")

    def test_what_is_laid_onto_its_floor_is_told(self):
        """A soft block that loads would press onto the floor below it begins there; the run says
        so, unless the gap is one of the mesh. On the floor there is nothing to say."""
        floor = obstacles({"floor": ["set Normal = 0, 1"]})
        for gap, is_told in ((0, False), (1e-4, False), (0.04, True)):
            block = box("s", f"0, {gap}", f"1, {gap + 1}", "4, 4", "set Body force = 0; -1")
            text = scene([block], ["s : floor"], 0.02, obstacles=floor)
            soft = ["Time/Start=equilibrium", "Bodies/s/Young's modulus=500"]
            run = check_history.Run(text, "laid", soft)
            self.assertAlmostEqual(run["contact_force"][0], 1, delta=1e-6)
            self.assertEqual("which was apart by 4 %" in run.log, is_told, gap)

    def test_friction_of_what_begins_to_slide(self):
        """A block at rest that friction does not hold: from the start friction is mu times the
        weight, against the load that is about to move it, on a body and on a plane."""
        above = box("s", "-0.2, 1", "0.2, 1.3", "4, 3", "set Body force = 3; -10")
        below = box("l", "-1, 0", "1, 1", "8, 4", "set Dirichlet = 2: 0; 0")
        plane = obstacles({"l": ["set Point = 0, 1", "set Normal = 0, 1"]})
        stiff = ["Time/Start=equilibrium", "Bodies/s/Young's modulus=1e6"]
        weight = 1.2
        for bodies, more, overrides in (
            ([above, below], {}, ["Bodies/l/Young's modulus=1e6"]),
            ([above], {"obstacles": plane}, []),
        ):
            text = scene(bodies, ["s : l"], 0.004, step=1e-3, laws=friction("s : l", 0.2), **more)
            run = check_history.Run(text, "begins", [*stiff, *overrides])
            for row in range(3):
                force = run.table("pairs")["pair_0_force_x"][row]
                self.assertAlmostEqual(force / (-0.2 * weight), 1, delta=1e-3)

    def test_load_steps_come_to_the_same_state_however_many_they_are(self):
        """A round punch is pressed into a block and drawn aside. Without friction the state depends
        on its place alone, and with friction as well once all nodes slip."""
        for friction in (0, 0.3):
            states = []
            for step in (0.25, 0.125, 0.0625):
                scene = punches.PUNCH.format(
                    scheme="static", motion="Motion = 0.2*t; -0.1*sin(pi*t/4)", friction=friction
                )
                overrides = [f"Time/Step size={step}", "Time/End time=2"]
                history = check_history.Run(scene, "static", overrides).history
                self.assertEqual(history["stick_nodes"][-1] if friction else 0, 0)
                self.assertLess(max(history["geometric_penetration"]), 1e-12)
                energy = max(history["elastic_energy"])
                self.assertLess(max(map(abs, history["energy_residual"])), 1e-10 * energy)
                states.append(
                    [
                        history[column][-1]
                        for column in ("contact_force_x", "contact_force_y", "elastic_energy")
                    ]
                )
            for state in states[1:]:
                for here, there in zip(state, states[0]):
                    self.assertAlmostEqual(here, there, delta=1e-7 * max(map(abs, states[0])))


if __name__ == "__main__":
    check_history.main()
