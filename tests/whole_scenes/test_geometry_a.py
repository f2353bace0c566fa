#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The ball on a plane of Krause and Walloth at refinement 3: impulse, duration, rebound, force and
energy of the three schemes are those that independent computations give on the same mesh. What
friction costs is counted on it, too, as times depend on the machine.
"""

import check_history


class GeometryA(check_history.SceneTest):
    def run_ball(self, scheme):
        return check_history.Run(
            check_history.PARAMETERS / "geometry_a.prm",
            f"geometry-a-{scheme}",
            [f"Time/Scheme={scheme}", "Bodies/ball/Refinements=3"],
        )

    def test_newmark_gains_energy(self):
        self.expect_close(self.run_ball("newmark").energy_change(), 0.049, 0.05, "energy change")

    def test_contact_implicit(self):
        run = self.run_ball("contact-implicit")
        mass = run["momentum_z"][0] / -2.0
        contact = [time for time, force in zip(run["time"], run["contact_force"]) if force > 0.0]
        self.expect_close(run.impulse(), 16.4, 0.01, "impulse")
        self.expect_close(run["momentum_z"][-1] / mass, 1.98, 0.01, "rebound speed")
        self.expect_close(max(run["contact_force"]), 99.4, 0.01, "largest force")
        self.expect_close(run.energy_change(), -0.0030, 0.05, "energy change")
        self.assertLessEqual(contact[0], 0.005 + 1e-9, "first contact")
        self.assertGreaterEqual(contact[-1], 0.305 - 1e-9, "last contact")
        self.assertLessEqual(contact[-1], 0.310 + 1e-9, "last contact")

    def test_contact_stabilized(self):
        run = self.run_ball("contact-stabilized")
        force = run["contact_force"]
        self.expect_close(run.energy_change(), -0.0051, 0.05, "energy change")
        self.assertTrue(97.0 < max(force) < 100.0, max(force))
        variation = sum(abs(b - a) for a, b in zip(force, force[1:])) / (2 * max(force))
        self.assertLess(variation, 1.02, "one smooth hump")

    def test_price_of_friction(self):
        """Sweeps solve with the terms of slip as fast as without (11.2 instead of 10.5 iterations,
        4.5 instead of 4.1 products per step), and a factor with GMRES finds the same motion."""
        friction = "Contact/ball : plane/Friction coefficient"
        throw = (
            "Bodies/ball/Refinements=3",
            "Bodies/ball/Initial velocity=1; 0.3; -2",
            "Time/End time=0.25",
        )
        runs = {
            name: check_history.Run(
                check_history.scene_file("geometry_a"), f"friction-price-{name}", (*throw, *keys)
            )
            for name, keys in {
                "without": (),
                "with": (f"{friction}=0.3",),
                "factor": (f"{friction}=0.3", "Solver/Preconditioner=incomplete-cholesky"),
            }.items()
        }
        with_friction, factor = runs["with"], runs["factor"]
        self.assertGreater(max(with_friction["slip_nodes"]), 3)
        for column in ("linear_iterations", "products_combined"):
            price = sum(with_friction[column]) / sum(runs["without"][column])
            self.assertLess(price, 1.25, column)
        products = {name: sum(run["products_combined"]) for name, run in runs.items()}
        self.assertGreater(products["factor"], 2 * products["with"])
        for column in ("momentum_x", "contact_force", "friction_force", "total_energy"):
            scale = max(map(abs, with_friction[column]))
            for row in range(len(factor)):
                self.assertLessEqual(
                    abs(with_friction[column][row] - factor[column][row]),
                    1e-8 * scale,
                    f"{column} in row {row}",
                )


if __name__ == "__main__":
    check_history.main()
