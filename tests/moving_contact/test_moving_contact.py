#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Contact that follows the motion (`Contact/Motion = follow`) does what rigid bodies do where they
are stiff and small: they slide along a bowl with the speed, the force and the period of a mass
point, fly past what they do not touch, and fall off a table. Nodes end steps outside of the true
obstacle, and the ledger holds as it does with fixed normals.
"""

import math
import re

import check_history
import following_scenes as following

#: Radius of the bowl and half the width of the block in it. Its strains are linear: what a turn by
#: an angle makes of it is an error of second order in the angle and first order in its size.
RADIUS, HALF = 1.0, 0.001
#: Of energies, relative to that of the motion: round-off of positions that are 1000 times the size.
ACCURACY = 1e-9

BOWL = """
set Dimension = 2
subsection Time
  set Scheme          = {scheme}
  set Spectral radius = 1
  set Step size       = {step}
  set End time        = {end}
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Lower corner     = -{half}, {bottom!r}
    set Upper corner     = {half}, {top!r}
    set Repetitions      = 2, 1
    set Young's modulus  = 10
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = -{speed!r}*y; {speed!r}*x
    set Body force       = 0; -{gravity}
  end
end
subsection Obstacles
  set Names = bowl
  subsection bowl
    set Shape         = sphere
    set Bodies inside = true
  end
end
subsection Contact
  set Pairs  = block : bowl
  set Motion = follow
end
"""

FLIGHT = """
set Dimension = 2
subsection Time
  set Step size = 0.01
  set End time  = 3
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape            = ball
    set Centre           = -1.5, 2.1
    set Radius           = 1
    set Refinements      = 3
    set Young's modulus  = 100
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 1; 0
  end
end
subsection Obstacles
  set Names = circle
  subsection circle
    set Shape = sphere
  end
end
subsection Contact
  set Pairs  = disc : circle
  set Motion = {motion}
end
"""

TABLE = """
set Dimension = 2
subsection Time
  set Start     = equilibrium
  set Step size = 0.005
  set End time  = 1.6
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Lower corner     = -2.2, 1
    set Upper corner     = -2, 1.1
    set Repetitions      = 8, 4
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 20; 0
    set Body force       = 0; -1
  end
end
subsection Obstacles
  set Names = table, floor
  subsection table
    set Point  = -2, 1
    set Normal = 0, 1
    set Extent = 4
  end
  subsection floor
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs  = block : table, block : floor
  set Motion = follow
end
"""

FLOORS = """
set Dimension = 2
subsection Time
  set Start     = equilibrium
  set Step size = 0.01
  set End time  = 1.5
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Lower corner     = -1.5, 0
    set Upper corner     = -0.5, 0.1
    set Repetitions      = 10, 2
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0
    set Density          = 1
    set Initial velocity = 2; 0
    set Body force       = 0; -1
  end
end
subsection Obstacles
  set Names = rough, smooth
  subsection rough
    set Point  = -5, 0
    set Normal = 0, 1
    set Extent = 10
  end
  subsection smooth
    set Point  = 5, 0
    set Normal = 0, 1
    set Extent = 10
  end
end
subsection Contact
  set Pairs  = block : rough, block : smooth
  set Motion = follow
  subsection block : rough
    set Friction coefficient = 0.3
  end
end
"""


def in_bowl(scheme, step, end, speed, gravity=0.0, half=HALF):
    """A block whose lower corners are on the bowl, turning about its centre."""
    bottom = -math.sqrt(RADIUS**2 - half**2)
    return BOWL.format(
        scheme=scheme,
        step=step,
        end=end,
        speed=speed,
        gravity=gravity,
        half=half,
        bottom=bottom,
        top=bottom + half,
    )


def arm(half):
    """Distance from the centre of the bowl to the centre of the block."""
    return math.sqrt(RADIUS**2 - half**2) - half / 2


#: Of the block, and its mass.
ARM, MASS = arm(HALF), 2 * HALF * HALF


class MovingContact(check_history.SceneTest):
    """See the beginning of the file."""

    def expect_laws(self, run, largest_change):
        """True gaps, which conditions at obstacles do not miss by anything; a ledger that explains
        all, and no energy gained."""
        self.expect_no_penetration(run, HALF)
        self.expect_losses(run, ACCURACY)
        energies = run["total_energy"]
        gain = max(new - old for old, new in zip(energies, energies[1:]))
        self.assertLess(gain, ACCURACY * max(run["kinetic_energy"]))
        self.assertLess(abs(run.energy_change()), largest_change)
        self.assertEqual(max(map(abs, run["work_geometry"])), 0)

    def test_block_slides_in_a_bowl_as_a_mass_point(self):
        """Energy to 1e-10 in 1000 steps, angle V t/R and force m V^2/R to 1e-3 (for a block of half
        the size: what linear strains make of its turn is proportional to it)."""
        speed, end = 0.3, 1.0
        for scheme in ("contact-implicit", "contact-stabilized-projected"):
            with self.subTest(scheme=scheme):
                run = check_history.Run(in_bowl(scheme, 0.001, end, speed), f"bowl_{scheme}")
                self.expect_laws(run, 1e-10)
                half = HALF / 2
                scene = in_bowl(scheme, 0.001, end, speed, half=half)
                history = check_history.Run(scene, f"small_{scheme}").history
                angle = math.atan2(history["momentum_y"][-1], history["momentum_x"][-1])
                self.assertAlmostEqual(angle / (speed * end), 1, delta=1e-3)
                second_half = history["contact_force"][500:]
                force = sum(second_half) / len(second_half)
                expected = 2 * half**2 * speed**2 * arm(half)
                self.assertAlmostEqual(force / expected, 1, delta=1e-3)

    def test_sliding_in_a_bowl_is_of_second_order(self):
        """Where the block is after 0.3 radians, at steps of 0.04, 0.02 and 0.01 against 0.001: the
        error falls by 4 with every half."""

        def place(scheme, step):
            bodies = check_history.Run(in_bowl(scheme, step, 1.0, 0.3), "order").table("bodies")
            return [bodies[f"body_block_centroid_{axis}"][-1] for axis in "xy"]

        for scheme in ("contact-implicit", "contact-stabilized-projected"):
            with self.subTest(scheme=scheme):
                exact = place(scheme, 0.001)
                errors = [math.dist(place(scheme, step), exact) for step in (0.04, 0.02, 0.01)]
                self.assertLess(errors[0], 1e-5)
                for coarse, fine in zip(errors, errors[1:]):
                    self.assertAlmostEqual(math.log2(coarse / fine), 2, delta=0.2)

    def test_predictor_without_projection_is_late_in_a_bowl(self):
        """contact-stabilized keeps the approach velocity of nodes in contact, so that their mass
        gets no centripetal impulse: dissipative, but with an angle that is too small. The run says
        so when normals have turned by 3 degrees, which takes 0.175 and more as it is late."""
        run = check_history.Run(in_bowl("contact-stabilized", 0.004, 1.0, 0.3), "bowl_late")
        angle = math.atan2(run.history["momentum_y"][-1], run.history["momentum_x"][-1])
        self.assertLess(angle, 0.9 * 0.3)
        warning = re.search(r"at time (\S+) the body 'block' is (\S+) degrees round", run.log)
        self.assertIsNotNone(warning)
        self.assertAlmostEqual(float(warning.group(1)), 0.18, delta=0.02)
        self.assertIn("Take `Time/Scheme = contact-stabilized-projected`", run.log)
        self.assertIn("(the most of the run)", run.log)

    def test_pendulum_of_large_amplitude_has_its_period(self):
        """2 pi sqrt(r/g) / agm(1, cos(amplitude/2)): from zeros of the momentum at a quarter and
        three quarters of the period."""
        amplitude, gravity = 0.6, 1.0
        a, b = 1.0, math.cos(amplitude / 2)
        for _ in range(10):
            a, b = (a + b) / 2, math.sqrt(a * b)
        period = 2 * math.pi * math.sqrt(ARM / gravity) / a
        speed = 2 * math.sin(amplitude / 2) * math.sqrt(gravity / ARM)
        step = period / 800
        run = check_history.Run(
            in_bowl("contact-stabilized-projected", step, 0.8 * period, speed, gravity), "pendulum"
        )
        self.expect_laws(run, 2e-3)
        time, momentum = run.history["time"], run.history["momentum_x"]
        zeros = [
            t + (after_t - t) * p / (p - after_p)
            for t, after_t, p, after_p in zip(time, time[1:], momentum, momentum[1:])
            if p * after_p < 0
        ]
        self.assertEqual(len(zeros), 2)
        self.assertAlmostEqual(2 * (zeros[1] - zeros[0]) / period, 1, delta=1e-3)

    def test_disc_flies_past_a_circle(self):
        """With a clearance of 0.1. The tangent planes of the start, which reach as far as one
        likes, are in its way."""
        run = check_history.Run(FLIGHT.format(motion="follow"), "flight")
        self.assertEqual(max(run.history["contact_force"]), 0)
        self.assertLess(abs(run.energy_change()), 1e-10)
        linearised = check_history.Run(FLIGHT.format(motion="linearised"), "flight_linearised")
        self.assertGreater(max(linearised.history["contact_force"]), 1)

    def test_block_slides_off_a_table_and_lands_on_the_floor(self):
        """Its last node passes the edge after 0.11, when it has hardly begun to tip over
        its edge, and lands sqrt(2) after its centre has passed the edge, within a few steps. It
        is not braked."""
        run = check_history.Run(TABLE, "table")
        history, step = run.history, 0.005
        touching = [force > 0 for force in history["contact_force"]]
        lost = touching.index(False, 2)
        landed = touching.index(True, lost)
        self.assertAlmostEqual(history["time"][lost], 0.11, delta=2.01 * step)
        # Half of the time between the centre and the last node at the edge is no flight.
        self.assertAlmostEqual(
            history["time"][landed] - history["time"][lost], math.sqrt(2), delta=2.01 * step
        )
        momentum = history["momentum_x"]
        self.assertAlmostEqual(momentum[-1] / momentum[0], 1, delta=1e-8)
        self.assertLess(max(history["max_penetration"]), 1e-11)

    def test_block_slides_from_a_rough_floor_onto_a_smooth_one(self):
        """Each floor has its own law. The friction mu W acts on the part of the block that is on
        the rough one, so that of the square of its speed 2 mu g times the way there is lost: 0.5
        until it reaches the smooth one, and half of its length 1 while it passes over."""
        run = check_history.Run(FLOORS, "floors")
        history = run.history
        mass, friction, speed = 0.1, 0.3, 2.0
        self.assertAlmostEqual(history["contact_force_x"][10], -friction * mass, delta=1e-6)
        self.assertEqual(history["contact_force_x"][-1], 0)
        expected = math.sqrt(speed**2 - 2 * friction * (0.5 + 0.5))
        self.assertAlmostEqual(history["momentum_x"][-1] / mass, expected, delta=1e-4)
        # What carries the block is below its middle: force and moment know where it is now.
        pairs = run.table("pairs")
        velocity = [momentum / mass for momentum in history["momentum_x"]]
        way = sum(0.01 * (a + b) / 2 for a, b in zip(velocity, velocity[1:]))
        lever = pairs["pair_1_moment_z"][-1] / pairs["pair_1_force_y"][-1]
        self.assertAlmostEqual(lever, -1 + way, delta=1e-3)

    def test_obstacles_of_large_radius(self):
        """Gaps to a circle have the round-off of its radius, and those to what turns that of the
        distance from the centre: a block is laid on circles that are up to a thousand times as
        large, hit by them, and dragged by them."""
        for radius in (100, 500, 1000):
            circle = [
                "set Shape = sphere",
                f"set Centre = 0.5, {-radius}",
                f"set Radius = {radius}",
            ]
            turning = [
                f"set Rotation centre = 0.5, {-radius}",
                f"set Angular velocity = {0.1 / radius}*sin(10*t)",
            ]
            for what, keys, more in (
                ("laid", ["set Body force = 0; -1"], []),
                ("hit", ["set Initial velocity = 0; -0.1"], []),
                ("dragged", ["set Body force = 0; -1"], turning),
            ):
                with self.subTest(radius=radius, what=what):
                    block = following.box("block", "0, 0", "1, 1", "4, 4", *keys)
                    run = check_history.Run(
                        following.scene(
                            [block],
                            ["block : floor"],
                            0.5,
                            obstacles=following.obstacles({"floor": circle + more}),
                            laws=following.friction("block : floor", 0.2),
                        ),
                        "large",
                        ["Bodies/block/Young's modulus=100"],
                    )
                    self.expect_ledger_closes(run, driven=True)
                    self.expect_no_penetration(run, 1)
                    self.assertGreater(max(run["contact_force"]), 0.01)

    def test_flat_obstacles_cost_nothing(self):
        """Where nothing turns the first solution of a step is the only one."""
        products = []
        for motion in ("follow", "linearised"):
            run = check_history.Run(
                check_history.scene_file("disc_2d"), f"disc_{motion}", [f"Contact/Motion={motion}"]
            )
            products.append(sum(run.history["linear_iterations"]))
        self.assertLess(products[0], 1.02 * products[1])

    def test_processes_agree(self):
        """A box that bounces off a sphere, on one process and on two."""
        one, two = (
            check_history.Run(
                check_history.scene_file("box_on_sphere"),
                f"sphere_{processes}",
                ["Contact/Motion=follow", "Time/End time=0.2"],
                processes,
            )
            for processes in (1, 2)
        )
        self.expect_contact(one)
        self.expect_same_history(two, one, 1e-9)
        self.expect_no_penetration(one, 1)


if __name__ == "__main__":
    check_history.main()
