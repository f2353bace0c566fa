#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""`Start = equilibrium`: what is at rest under its loads stays at rest with every scheme, and what cannot be at rest starts with the
right rigid acceleration and without vibration.
"""

import math

import check_history

GRAVITY = 10.
SCHEMES = ("newmark", "laursen-chawla", "laursen-love", "khenous-laborde-renard", "hager-hueeber-wohlmuth", "contact-implicit",
           "contact-stabilized", "contact-stabilized-projected", "hht-alpha", "generalized-alpha", "moreau-jean",
           "nonsmooth-generalized-alpha", "backward-euler")

#: A block on a plane that is turned by an angle with everything, gravity included.
BLOCK = """
set Dimension = 2
subsection Time
  set Step size = 2e-2
  set End time  = 0.6
  set Start     = equilibrium
end
subsection Bodies
  set Names = block
  subsection block
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = 1, 0.5
    set Repetitions     = 6, 3
    set Young's modulus = 2000
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = {force_x}; {force_y}
    set Initial velocity = {speed}; 0
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Shape  = plane
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = block[2] : floor
  subsection block[2] : floor
    set Friction coefficient = {coefficient}
  end
end
subsection Probes
  set Names = corner
  subsection corner
    set Point = 0, 0
  end
end
"""

STACK = """
set Dimension = 3
subsection Time
  set Step size = 2e-2
  set End time  = 0.4
  set Start     = equilibrium
end
subsection Bodies
  set Names = upper, lower
  subsection upper
    set Shape           = box
    set Lower corner    = 0.2, 0.2, 1
    set Upper corner    = 0.9, 0.8, 1.6
    set Repetitions     = 3, 3, 2
    set Young's modulus = 2000
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; 0; -10
  end
  subsection lower
    set Shape           = box
    set Lower corner    = 0, 0, 0
    set Upper corner    = 1, 1, 1
    set Repetitions     = 4, 4, 3
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
    set Density         = 2
    set Body force      = 0; 0; -10
    set Dirichlet       = 4: 0; 0; 0
  end
end
subsection Contact
  set Pairs = upper[4] : lower[5]
  subsection upper[4] : lower[5]
    set Friction coefficient = {coefficient}
  end
end
"""


def block(coefficient=0., angle=0., speed=0.):
    return BLOCK.format(force_x=GRAVITY * math.sin(angle), force_y=-GRAVITY * math.cos(angle), coefficient=coefficient, speed=speed)


class Equilibrium(check_history.SceneTest):
    def expect_rest(self, run, weight):
        """Nothing moves, and the contact force is the weight."""
        elastic = run["elastic_energy"][0]
        self.assertGreater(elastic, 0.)
        for row in range(len(run)):
            self.assertLess(run["kinetic_energy"][row], 1e-16 * max(elastic, 1e-3), f"step {row}")
            self.assertAlmostEqual(run["elastic_energy"][row], elastic, delta=1e-8 * elastic)
            self.assertAlmostEqual(run["contact_force"][row], weight, delta=1e-8 * weight)

    def test_block_rests_with_every_scheme(self):
        for scheme in SCHEMES:
            with self.subTest(scheme):
                self.expect_rest(check_history.Run(block(), f"equilibrium-rest-{scheme}", [f"Time/Scheme={scheme}"]), 0.5 * GRAVITY)

    def test_stack_rests(self):
        for coefficient in (0., 0.5):
            with self.subTest(coefficient):
                run = check_history.Run(STACK.format(coefficient=coefficient), f"equilibrium-stack-{coefficient}")
                self.expect_rest(run, 0.7 * 0.6 * 0.6 * GRAVITY)

    def test_block_sticks_on_an_incline(self):
        angle = 0.3
        run = check_history.Run(block(1.05 * math.tan(angle), angle), "equilibrium-stick")
        self.expect_rest(run, 0.5 * GRAVITY * math.cos(angle))
        self.assertAlmostEqual(run.vector("contact_force", 0)[0], -0.5 * GRAVITY * math.sin(angle), delta=1e-7)

    def expect_acceleration(self, run, acceleration, speed=0.):
        """Uniform, without vibration: the energy of the deformation stays."""
        for row, time in enumerate(run["time"]):
            self.assertAlmostEqual(run["momentum_x"][row] / 0.5, speed + acceleration * time, delta=1e-7)
            self.assertAlmostEqual(run["elastic_energy"][row], run["elastic_energy"][0], delta=1e-8 * run["elastic_energy"][0])

    def test_block_slides_down(self):
        angle, coefficient = 0.3, 0.9 * math.tan(0.3)
        run = check_history.Run(block(coefficient, angle), "equilibrium-slide")
        self.expect_acceleration(run, GRAVITY * (math.sin(angle) - coefficient * math.cos(angle)))

    def test_moving_block_is_slowed_down(self):
        run = check_history.Run(block(0.2, 0., 3.), "equilibrium-slow-down")
        self.expect_acceleration(run, -0.2 * GRAVITY, 3.)

    def test_block_slides_without_friction(self):
        run = check_history.Run(block(0., 0.3), "equilibrium-frictionless")
        self.expect_acceleration(run, GRAVITY * math.sin(0.3))

    def test_free_fall_is_not_deformed(self):
        run = check_history.Run(block(), "equilibrium-fall", ["Obstacles/floor/Point=0, -50"])
        self.assertLess(max(run["elastic_energy"]), 1e-10 * run["kinetic_energy"][-1])
        self.assertAlmostEqual(run["momentum_y"][-1] / 0.5, -GRAVITY * run["time"][-1], delta=1e-8)

    def test_processes_agree(self):
        for name, scene in (("stack", STACK.format(coefficient=0.3)), ("slide", block(0.2, 0.3))):
            runs = [check_history.Run(scene, f"equilibrium-{name}-{n}", processes=n) for n in (1, 2)]
            self.assertAlmostEqual(*(run["contact_force"][-1] for run in runs), delta=1e-8)
            self.assertAlmostEqual(*(run["momentum_x"][-1] for run in runs), delta=1e-8)
            self.assertAlmostEqual(*(run["elastic_energy"][0] for run in runs), delta=1e-9)


if __name__ == "__main__":
    check_history.main()
