#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Nodes that several obstacles hold at once, in grooves and corners, stay outside of all of them,
and carry their forces; and no step takes them through an obstacle.
"""

import math

import check_history
import following_scenes as following

GROOVE = """
set Dimension = 2
subsection Time
  set Start     = equilibrium
  set Step size = 0.01
  set End time  = 0.1
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape           = ball
    set Centre          = 0, {height!r}
    set Radius          = 1
    set Refinements     = 3
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; -1
  end
end
subsection Obstacles
  set Names = left, right
  subsection left
    set Normal = {cosine!r}, {sine!r}
  end
  subsection right
    set Normal = -{cosine!r}, {sine!r}
  end
end
subsection Contact
  set Pairs  = disc : left, disc : right
  set Motion = follow
end
"""

ROOM = """
set Dimension = 3
subsection Time
  set Scheme    = {scheme}
  set Step size = 0.005
  set End time  = 0.5
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Lower corner     = 0, 0, 0
    set Upper corner     = 1, 1, 0.5
    set Repetitions      = 4, 4, 2
    set Young's modulus  = 1000
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 1; 0.7; 0
    set Body force       = 0; 0; -1
  end
end
subsection Obstacles
  set Names = floor, wall, side
  subsection floor
    set Normal = 0.1, 0, 1
  end
  subsection wall
    set Point  = 1.1, 0, 0
    set Normal = -1, 0.2, 0.1
  end
  subsection side
    set Point  = 0, 1.15, 0
    set Normal = 0, -1, 0.3
  end
end
subsection Contact
  set Pairs  = block : floor, block : wall, block : side
  set Motion = follow
end
"""

BULLET = """
set Dimension = 2
subsection Time
  set Step size = 0.02
  set End time  = 0.4
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Lower corner     = -2, -0.5
    set Upper corner     = -1, 0.5
    set Repetitions      = 16, 16
    set Young's modulus  = 1e6
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 20; 0
  end
end
subsection Obstacles
  set Names = pole
  subsection pole
    set Shape  = sphere
    set Centre = 0, 0.03
    set Radius = 0.12
  end
end
subsection Contact
  set Pairs  = block : pole
  set Motion = follow
end
"""

HELD = following.scene(
    [following.block_on_rails("set Initial velocity = 1; 0")],
    ["block : floor", "block : wall"],
    1,
    "contact-stabilized-projected",
    obstacles=following.obstacles(
        {"floor": ["set Normal = 0, 1"], "wall": ["set Point = 1.2, 0", "set Normal = -1, 0"]}
    ),
)


class Corners(check_history.SceneTest):
    """See the beginning of the file."""

    def test_disc_rests_in_a_groove(self):
        """Two planes at angles alpha to the vertical carry the weight W by N = W/(2 sin alpha)."""
        for alpha in (0.5, 1.0):
            sine, cosine = math.sin(alpha), math.cos(alpha)
            scene = GROOVE.format(sine=sine, cosine=cosine, height=1 / sine)
            run = check_history.Run(scene, f"groove_{alpha}")
            pairs = run.table("pairs")
            weight = run.history["contact_force_y"][-1]
            for k in range(2):
                force = pairs[f"pair_{k}_normal_force"][-1]
                self.assertAlmostEqual(force, weight / (2 * sine), delta=1e-8 * weight)

    def test_block_hits_the_corner_of_a_room(self):
        """Floor and walls are oblique to each other. Nodes at two and three of them stay outside of
        all, and no preconditioner changes the result."""
        for scheme in ("contact-stabilized-projected", "contact-implicit"):
            energies = []
            for kind in ("automatic", "multigrid", "incomplete-cholesky", "jacobi"):
                with self.subTest(scheme=scheme, preconditioner=kind):
                    history = check_history.Run(
                        ROOM.format(scheme=scheme), "room", [f"Solver/Preconditioner={kind}"]
                    ).history
                    self.expect_losses(history)
                    self.assertLess(max(history["geometric_penetration"]), 1e-12)
                    energies.append(history["elastic_energy"])
                    largest = max(energies[0])
                    for here, first in zip(energies[-1], energies[0]):
                        self.assertAlmostEqual(here, first, delta=1e-8 * largest)

    def test_nodes_on_rails_meet_the_wall(self):
        """The bottom moves along the floor only, which it cannot leave nor enter; the wall stops
        it, as it does the rest of the block."""
        history = check_history.Run(HELD, "rails").history
        self.assertLess(max(history["geometric_penetration"]), 1e-12)
        self.assertLess(history["momentum_x"][-1], -0.5 * history["momentum_x"][0])

    def test_block_does_not_pass_through_a_pole(self):
        """It moves by more than the diameter of the pole in each step. Steps that would end beyond
        it are cut."""
        history = check_history.Run(BULLET, "bullet").history
        self.assertGreater(max(history["contact_force"]), 0)
        self.assertGreater(sum(history["rejected_steps"]), 0)
        self.assertLess(history["momentum_x"][-1], 0.1 * history["momentum_x"][0])


if __name__ == "__main__":
    check_history.main()
