#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""`Start = equilibrium`: what is at rest under its loads stays at rest with every scheme, and what
cannot be at rest starts with the right rigid acceleration and without vibration.
"""

import math
import re

import check_history

GRAVITY = 10.0
SCHEMES = (
    "newmark",
    "laursen-chawla",
    "laursen-love",
    "khenous-laborde-renard",
    "hager-hueeber-wohlmuth",
    "contact-implicit",
    "contact-stabilized",
    "contact-stabilized-projected",
    "hht-alpha",
    "generalized-alpha",
    "moreau-jean",
    "nonsmooth-generalized-alpha",
    "backward-euler",
)

MASS = 0.5
#: The block of parameters/sliding_block.prm, larger, lighter and so soft that its weight shows.
SOFT = [
    "Bodies/block/Upper corner=1, 0.5",
    "Bodies/block/Repetitions=6, 3",
    "Bodies/block/Young's modulus=2000",
    "Bodies/block/Poisson's ratio=0.3",
    "Bodies/block/Density=1",
    "Time/Step size=2e-2",
    "Time/End time=0.6",
]
#: The stack of parameters/stack_of_boxes.prm, without gaps, speeds and fine meshes.
AT_REST = ["Time/Start=equilibrium", "Time/Step size=2e-2", "Time/End time=0.4"]
for name in ("lower", "middle", "upper"):
    AT_REST += [f"Bodies/{name}/Initial velocity=0; 0; 0", f"Bodies/{name}/Refinements=0"]
AT_REST += [
    "Bodies/lower/Lower corner=-0.5, -0.5, 0",
    "Bodies/lower/Upper corner=0.5, 0.5, 0.4",
    "Bodies/middle/Lower corner=-0.4, -0.4, 0.4",
    "Bodies/middle/Upper corner=0.4, 0.4, 0.8",
    "Bodies/upper/Lower corner=-0.3, -0.3, 0.8",
    "Bodies/upper/Upper corner=0.3, 0.3, 1.2",
]
PAIRS = ("lower[4] : floor", "middle[4] : lower[5]", "upper[4] : middle[5]")
#: What each pair bears: the weight of the boxes above it.
STACK_FORCE = 0.4 * GRAVITY * ((1.0 + 0.64 + 0.36) + (0.64 + 0.36) + 0.36)


def run_block(name, coefficient=0.0, angle=0.0, speed=0.0, overrides=(), processes=1):
    """On a plane that is turned by an angle with everything, gravity included."""
    turned = [
        f"Contact/block[2] : floor/Friction coefficient={coefficient}",
        f"Bodies/block/Initial velocity={speed}; 0",
        f"Bodies/block/Body force={GRAVITY * math.sin(angle)}; {-GRAVITY * math.cos(angle)}",
    ]
    return check_history.Run(
        check_history.PARAMETERS / "sliding_block.prm",
        f"equilibrium-{name}",
        [*SOFT, *turned, *overrides],
        processes,
    )


def run_stack(name, coefficient, processes=1):
    friction = [f"Contact/{pair}/Friction coefficient={coefficient}" for pair in PAIRS]
    return check_history.Run(
        check_history.PARAMETERS / "stack_of_boxes.prm",
        f"equilibrium-{name}",
        AT_REST + friction,
        processes,
    )


class Equilibrium(check_history.SceneTest):
    def expect_rest(self, run, weight):
        """Nothing moves, and the contact force is the weight."""
        elastic = run["elastic_energy"][0]
        self.assertGreater(elastic, 0.0)
        for row in range(len(run)):
            self.assertLess(run["kinetic_energy"][row], 1e-16 * max(elastic, 1e-3), f"step {row}")
            self.assertAlmostEqual(run["elastic_energy"][row], elastic, delta=1e-8 * elastic)
            self.assertAlmostEqual(run["contact_force"][row], weight, delta=1e-8 * weight)

    def test_block_rests_with_every_scheme(self):
        for scheme in SCHEMES:
            with self.subTest(scheme):
                self.expect_rest(
                    run_block(f"rest-{scheme}", overrides=[f"Time/Scheme={scheme}"]), MASS * GRAVITY
                )

    def test_stack_rests(self):
        for coefficient in (0.0, 0.5):
            with self.subTest(coefficient):
                self.expect_rest(run_stack(f"stack-{coefficient}", coefficient), STACK_FORCE)

    def test_block_sticks_on_an_incline(self):
        angle = 0.3
        weight = MASS * GRAVITY
        run = run_block("stick", 1.05 * math.tan(angle), angle)
        self.expect_rest(run, weight * math.cos(angle))
        self.assertAlmostEqual(
            run.vector("contact_force", 0)[0], -weight * math.sin(angle), delta=1e-8 * weight
        )

    def expect_acceleration(self, run, acceleration, speed=0.0):
        """Uniform, without vibration: the energy of the deformation stays."""
        for row, time in enumerate(run["time"]):
            self.assertAlmostEqual(
                run["momentum_x"][row] / MASS, speed + acceleration * time, delta=1e-7
            )
            self.assertAlmostEqual(
                run["elastic_energy"][row],
                run["elastic_energy"][0],
                delta=1e-8 * run["elastic_energy"][0],
            )

    def test_block_slides_down(self):
        angle, coefficient = 0.3, 0.9 * math.tan(0.3)
        run = run_block("slide", coefficient, angle)
        self.expect_acceleration(run, GRAVITY * (math.sin(angle) - coefficient * math.cos(angle)))

    def test_moving_block_is_slowed_down(self):
        run = run_block("slow-down", 0.2, 0.0, 3.0)
        self.expect_acceleration(run, -0.2 * GRAVITY, 3.0)

    def test_moving_block_costs_what_any_other_start_does(self):
        """Nodes that slide never stick: one that did would have to go back all its way, and take
        Newton's method along, the more iterations the finer the mesh."""
        run = check_history.Run(
            check_history.PARAMETERS / "sliding_block.prm",
            "equilibrium-fine",
            ["Bodies/block/Refinements=5", "Bodies/block/Element=standard", "Time/End time=0.01"],
        )
        n_products = int(re.search(r"found with (\d+) products", run.log)[1])
        self.assertLess(n_products, 120)

    def test_block_slides_without_friction(self):
        run = run_block("frictionless", 0.0, 0.3)
        self.expect_acceleration(run, GRAVITY * math.sin(0.3))

    def test_free_fall_is_not_deformed(self):
        run = run_block("fall", overrides=["Obstacles/floor/Point=0, -50"])
        self.assertLess(max(run["elastic_energy"]), 1e-10 * run["kinetic_energy"][-1])
        self.assertAlmostEqual(run["momentum_y"][-1] / MASS, -GRAVITY * run["time"][-1], delta=1e-8)

    def test_processes_agree(self):
        for run in (
            lambda n: run_stack(f"stack-{n}", 0.3, n),
            lambda n: run_block(f"slide-{n}", 0.2, 0.3, processes=n),
        ):
            one, two = run(1), run(2)
            self.assertAlmostEqual(
                one["contact_force"][-1],
                two["contact_force"][-1],
                delta=1e-9 * one["contact_force"][-1],
            )
            self.assertAlmostEqual(one["momentum_x"][-1], two["momentum_x"][-1], delta=1e-8)
            self.assertAlmostEqual(
                one["elastic_energy"][0],
                two["elastic_energy"][0],
                delta=1e-8 * one["elastic_energy"][0],
            )


if __name__ == "__main__":
    check_history.main()
