#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The bar that hits a wall, of which the exact solution is known: energy, errors and contact force
of each scheme are those that an independent computation in one dimension gives for 100 elements and
Courant number 0.9, to three percent.
"""

import statistics

import check_history

AREA = 0.1
PRESSURE = 300.0  # rho c v: the exact contact pressure
START, END = 0.5, 7.0 / 6.0  # of the exact contact


class Bar(check_history.SceneTest):
    def run_bar(self, scheme, *overrides):
        run = check_history.Run(
            check_history.PARAMETERS / "bar_2d.prm",
            "-".join(["bar", scheme, *map(str, range(len(overrides)))]),
            [f"Time/Scheme={scheme}", *overrides],
        )
        run.pressure = [force / (PRESSURE * AREA) for force in run["contact_force"]]
        margin = 0.1 * (END - START)
        middle = [
            p for p, t in zip(run.pressure, run["time"]) if START + margin <= t <= END - margin
        ]
        run.deviation = statistics.pstdev(middle)
        run.changes = [energy / run["total_energy"][0] - 1 for energy in run["total_energy"]]
        return run

    def expect_errors(self, run, displacement, velocity):
        self.expect_close(run["relative_displacement_error"][-1], displacement, 0.03, "e_u")
        self.expect_close(run["relative_velocity_error"][-1], velocity, 0.03, "e_v")

    def expect_impulse(self, run, tolerance):
        """2 m v: the bar flies back as fast as it came."""
        self.expect_close(run.impulse(), 2 * 10 * 10 * AREA, tolerance, "impulse")

    def test_newmark_gains_energy(self):
        run = self.run_bar("newmark")
        self.expect_close(run.changes[-1], 0.364, 0.03, "energy change at the end")
        self.expect_close(max(run.changes), 0.432, 0.03, "largest energy change")
        self.expect_errors(run, 0.0110, 0.37)
        self.expect_close(max(run.pressure), 3.97, 0.03, "largest contact pressure")
        self.expect_close(run.deviation, 1.42, 0.03, "deviation of the contact pressure")

    def test_contact_implicit(self):
        run = self.run_bar("contact-implicit")
        self.expect_close(run.changes[-1], -0.0048, 0.03, "energy change at the end")
        self.expect_errors(run, 0.0083, 0.082)
        self.expect_close(max(run.pressure), 1.24, 0.03, "largest contact pressure")
        self.expect_close(run.deviation, 0.214, 0.03, "deviation of the contact pressure")
        self.expect_impulse(run, 0.02)

    def test_contact_stabilized(self):
        run = self.run_bar("contact-stabilized")
        self.expect_close(run.changes[-1], -0.0068, 0.03, "energy change at the end")
        self.expect_errors(run, 0.0112, 0.096)
        self.expect_close(max(run.pressure), 1.10, 0.03, "largest contact pressure")
        self.assertLess(run.deviation, 0.002, "deviation of the contact pressure")
        self.expect_impulse(run, 0.02)

    def test_contact_stabilized_with_lumped_predictor(self):
        run = self.run_bar("contact-stabilized", "Time/Predictor mass=lumped")
        self.expect_close(run.changes[-1], -0.0112, 0.03, "energy change at the end")
        self.assertLess(max(run.changes), 1e-10, "gain of energy")
        self.expect_errors(run, 0.0133, 0.097)
        self.expect_close(max(run.pressure), 1.02, 0.03, "largest contact pressure")
        self.assertLess(run.deviation, 0.002, "deviation of the contact pressure")

    def test_laursen_chawla_conserves_energy_and_penetrates(self):
        run = self.run_bar("laursen-chawla")
        self.assertLess(max(abs(change) for change in run.changes), 1e-10)
        self.expect_errors(run, 0.0092, 0.092)
        self.expect_close(max(run.pressure), 1.68, 0.03, "largest contact pressure")
        self.expect_close(run.deviation, 0.641, 0.03, "deviation of the contact pressure")
        self.expect_close(max(run["max_penetration"]), 0.01, 0.03, "penetration")

    def test_laursen_love_conserves_energy(self):
        run = self.run_bar("laursen-love", "Time/Impulses=common")
        self.assertLess(max(abs(change) for change in run.changes), 1e-10)
        self.expect_close(max(run.pressure), 1.92, 0.03, "largest contact pressure")
        self.assertLess(max(run["max_penetration"]), 1e-9)

    def test_impulses_per_node_make_the_force_of_laursen_love_smooth(self):
        run = self.run_bar("laursen-love")
        self.assertLess(max(abs(change) for change in run.changes), 1e-10)
        self.expect_errors(run, 0.0065, 0.094)
        self.expect_close(max(run.pressure), 1.92, 0.03, "largest contact pressure")
        self.assertLess(run.deviation, 0.002, "deviation of the contact pressure")
        self.assertLess(max(run["max_penetration"]), 1e-9)
        self.assertIn("impulses          of single nodes", run.log)
        self.assertNotIn("the common factor", run.log)

    def test_projected_velocity_is_the_best_of_the_dissipative(self):
        run = self.run_bar("contact-stabilized-projected")
        self.expect_close(run.changes[-1], -0.0051, 0.03, "energy change at the end")
        self.expect_errors(run, 0.0090, 0.084)
        self.expect_close(max(run.pressure), 1.10, 0.03, "largest contact pressure")
        self.assertLess(run.deviation, 0.002, "deviation of the contact pressure")
        self.assertLess(
            max(
                abs(velocity)
                for time, velocity in zip(run["time"], run.probes["contact_end"]["normal_velocity"])
                if START + 0.01 < time < END - 0.01
            ),
            1e-7,
            "normal velocity in contact",
        )

    def test_hht_alpha(self):
        run = self.run_bar("hht-alpha")
        self.expect_close(run.changes[-1], -0.0143, 0.03, "energy change at the end")
        self.expect_errors(run, 0.0106, 0.077)
        self.expect_close(max(run.pressure), 1.84, 0.03, "largest contact pressure")

    def test_moreau_jean(self):
        run = self.run_bar("moreau-jean")
        self.expect_close(run.changes[-1], -0.0054, 0.03, "energy change at the end")
        self.expect_errors(run, 0.0166, 0.091)
        self.expect_close(max(run.pressure), 1.09, 0.03, "largest contact pressure")
        self.expect_close(max(run["max_penetration"]), 0.025, 0.03, "penetration")

    def test_nonsmooth_generalized_alpha(self):
        run = self.run_bar("nonsmooth-generalized-alpha")
        self.expect_close(run.changes[-1], -0.0080, 0.03, "energy change at the end")
        self.assertLess(max(run.changes), 1e-10, "gain of energy")
        self.expect_errors(run, 0.0170, 0.090)
        self.expect_close(max(run.pressure), 1.08, 0.03, "largest contact pressure")
        self.assertLess(run.deviation, 0.002, "deviation of the contact pressure")
        self.expect_close(max(run["max_penetration"]), 0.025, 0.03, "penetration")

    def test_backward_euler(self):
        run = self.run_bar("backward-euler")
        self.expect_close(run.changes[-1], -0.179, 0.03, "energy change at the end")
        self.assertLess(max(run.changes), 1e-10, "gain of energy")
        self.expect_errors(run, 0.082, 0.148)
        self.expect_close(max(run.pressure), 1.02, 0.03, "largest contact pressure")
        self.expect_close(run.deviation, 0.016, 0.03, "deviation of the contact pressure")
        self.assertLess(max(run["max_penetration"]), 1e-9)


if __name__ == "__main__":
    check_history.main()
