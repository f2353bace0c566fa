#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Contact that comes and goes smoothly: all schemes but backward Euler are of second order in time. The manufactured solution of parameters/manufactured_bar.prm
has active contact half of the time, with approach and release at zero speed; the mesh's own error is hundreds of times smaller.
"""

import math

import check_history

SMOOTH = [scheme for scheme in (*check_history.SCHEMES, *check_history.FURTHER_SCHEMES)
          if scheme not in ("laursen-chawla", "moreau-jean", "backward-euler")]
STEPS = (0.025, 0.0125, 0.00625)


class Order(check_history.SceneTest):
    def errors(self, scheme):
        runs = [check_history.Run(check_history.PARAMETERS / "manufactured_bar.prm", f"order-{scheme}-{step}",
                                  [f"Time/Scheme={scheme}", f"Time/Step size={step}"]) for step in STEPS]
        for run in runs:
            self.expect_contact(run)
        return [(run["relative_displacement_error"][-1], run["relative_velocity_error"][-1]) for run in runs]

    def test_order_two(self):
        for scheme in SMOOTH:
            with self.subTest(scheme=scheme):
                errors = self.errors(scheme)
                order_u, order_v = (math.log2(errors[0][i] / errors[2][i]) / 2 for i in range(2))
                self.assertGreater(order_u, 1.9, f"{errors}")
                self.assertLess(order_u, 2.15, f"{errors}")
                self.assertGreater(order_v, 1.2 if scheme == "newmark" else 1.5, f"{errors}")

    def test_backward_euler_has_order_one(self):
        errors = self.errors("backward-euler")
        for i in range(2):
            self.expect_close(math.log2(errors[0][i] / errors[2][i]) / 2, 1., 0.1, f"{errors}")

    def test_conditions_of_velocities_scatter_around_order_two(self):
        for scheme in ("laursen-chawla", "moreau-jean"):
            with self.subTest(scheme=scheme):
                errors = self.errors(scheme)
                self.assertGreater(math.log2(errors[0][0] / errors[2][0]) / 2, 1.7, f"{errors}")


if __name__ == "__main__":
    check_history.main()
