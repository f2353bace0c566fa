#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Obstacles that move bring energy from outside, exactly as much as force times motion, and take
bodies along by friction.
"""

import math

import check_history
import following_scenes as following

PUNCH = """
set Dimension = 2
subsection Time
  set Scheme    = {scheme}
  set Step size = 0.01
  set End time  = 4
end
subsection Bodies
  set Names = block
  subsection block
    set Shape           = box
    set Lower corner    = -1, -1
    set Upper corner    = 1, 0
    set Repetitions     = 16, 8
    set Young's modulus = 100
    set Poisson's ratio = 0.3
    set Density         = 1
    set Dirichlet       = 2: 0; 0
  end
end
subsection Obstacles
  set Names = punch
  subsection punch
    set Shape  = sphere
    set Centre = 0.1, 0.51
    set Radius = 0.5
    set {motion}
  end
end
subsection Contact
  set Pairs  = block : punch
  set Motion = follow
  subsection block : punch
    set Friction coefficient = {friction}
  end
end
"""

SPIN = """
set Dimension = 2
subsection Time
  set Step size = 0.01
  set End time  = 0.05
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape           = ball
    set Centre          = 0, 1.1
    set Radius          = 0.5
    set Refinements     = 2
    set Young's modulus = 1e6
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; -10
  end
end
subsection Obstacles
  set Names = rotor
  subsection rotor
    set Shape            = box
    set Lower corner     = -0.5, -0.5
    set Upper corner     = 0.5, 0.5
    set Angular velocity = 200
  end
end
subsection Contact
  set Pairs  = disc : rotor
  set Motion = follow
end
"""


def wedge(scheme, rise):
    """An oblique plane that comes at a block on rails."""
    plane = following.entries(Point="1.01, 0", Normal="-1, 0.5", Velocity=f"-1; {rise}")
    return following.scene(
        [following.block_on_rails()],
        ["block : wedge"],
        0.5,
        scheme,
        obstacles=following.obstacles({"wedge": plane}),
    )


#: That work_of_punch() knows.
PUNCH_MOTION = "Motion = 0.05*t; -0.1*sin(pi*t/4)"


def work_of_punch(history):
    """Force times motion of the punch that moves by PUNCH_MOTION."""
    places = [(0.05 * t, -0.1 * math.sin(math.pi * t / 4)) for t in history["time"]]
    return sum(
        fx * (there[0] - here[0]) + fy * (there[1] - here[1])
        for here, there, fx, fy in zip(
            places,
            places[1:],
            history["contact_force_x"][1:],
            history["contact_force_y"][1:],
        )
    )


class MovingObstacles(check_history.SceneTest):
    """See the beginning of the file."""

    def test_work_of_a_punch_is_the_energy_that_it_brings(self):
        """A round punch is pressed into a block while it moves aside, and withdrawn. Its work from
        the table, force times motion, is the external work of the ledger, whatever the friction;
        contact and friction take energy and give none. A velocity is the derivative of a motion."""
        motions = (PUNCH_MOTION, "Velocity = 0.05; -pi/40*cos(pi*t/4)")
        for scheme, motion, friction in (
            ("contact-stabilized-projected", motions[0], 0),
            ("contact-stabilized-projected", motions[1], 0.3),
            ("contact-implicit", motions[0], 0.3),
        ):
            with self.subTest(scheme=scheme, motion=motion, friction=friction):
                scene = PUNCH.format(scheme=scheme, motion=motion, friction=friction)
                history = check_history.Run(scene, "punch").history
                energy = max(history["total_energy"])
                work = work_of_punch(history)
                self.assertAlmostEqual(work, sum(history["work_external"]), delta=1e-11 * energy)
                self.expect_losses(history)
                self.assertEqual(min(history["work_friction"]) < 0, friction > 0)
                self.assertLess(max(history["max_penetration"]), 1e-11)

    def test_wedge_works_on_a_block_on_rails(self):
        """An oblique plane comes while the bottom of a block is held in one direction. What the
        plane hands on to the support is a part of its work: contact itself brings none."""
        for scheme in ("contact-stabilized-projected", "contact-implicit"):
            for rise in (0, 0.5, -1):
                with self.subTest(scheme=scheme, rise=rise):
                    history = check_history.Run(wedge(scheme, rise), "wedge").history
                    self.assertGreater(max(history["contact_force"]), 0)
                    self.expect_losses(history)

    def test_turn_of_a_step_is_limited(self):
        """Two radians in a step, of which the mean is no rotation: the steps are cut."""
        history = check_history.Run(SPIN, "spin").history
        self.assertGreater(sum(history["rejected_steps"]), 0)
        self.assertLessEqual(max(history["step_size"][1:]), 0.0051)

    def test_half_steps_see_the_obstacle_where_it_is(self):
        """Steps that are doubled end a half step while the obstacle is known at the end of the
        second half; tables are those of the half."""
        scene = PUNCH.format(
            scheme="contact-implicit", motion="Motion = 0; -0.1*sin(pi*t/4)", friction=0
        )
        overrides = ["Time/Step size control=doubling", "Time/End time=1"]
        history = check_history.Run(scene, "doubled", overrides).history
        self.assertGreater(max(history["contact_force"]), 0)
        self.assertLess(max(history["geometric_penetration"]), 1e-11)

    def test_rollers_drag_a_strip(self):
        """Two rollers close on a strip and begin to turn. With friction the strip goes at the speed
        of their surfaces, 0.5, about which it vibrates, and does not slip."""
        history = check_history.Run(check_history.scene_file("rolling_mill"), "mill").history
        momentum = history["momentum_x"][-100:]
        self.assertAlmostEqual(sum(momentum) / len(momentum) / (3 * 0.2), 0.5, delta=0.005)
        self.assertGreater(min(history["stick_nodes"][-100:]), 0)
        self.assertEqual(max(history["slip_nodes"][-100:]), 0)
        self.expect_losses(history)


if __name__ == "__main__":
    check_history.main()
