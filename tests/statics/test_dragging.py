#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A block is pressed onto a floor with friction and dragged to and fro by its upper face. Each time
it starts or turns, slips are next to nothing, and their directions next to infinitely stiff. The
ledger of every step closes to the tolerance of the solver all the same, and where all nodes slip,
friction is the coefficient times the force of contact.
"""

import check_history
from test_loose_bodies import box, scene

COEFFICIENT, STEPS = 0.3, 10
TO_AND_FRO = "0.05*sin(6.28318*max(0,t-0.3)/0.7)"


class Dragging(check_history.SceneTest):
    def test_the_ledger_closes(self):
        block = box(
            "block",
            "0, 0, 0",
            "2, 2, 1",
            "4, 4, 2",
            1000,
            f"Dirichlet = 5: {TO_AND_FRO}; 0; -0.01*min(t/0.3,1)",
        )
        floor = {"floor": ["Normal = 0, 0, 1"]}
        run = check_history.Run(
            scene(3, STEPS, {"block": block}, floor, ["block[4] : floor"], COEFFICIENT), "block"
        )
        self.assertEqual(sum(run["fallbacks"]), 0)
        self.assertIn(25, run["slip_nodes"])
        self.assertIn(25, run["stick_nodes"])
        energy = max(run["elastic_energy"])
        for step, residual in enumerate(run["energy_residual"]):
            self.assertLess(abs(residual), 1e-11 * energy, f"step {step}")
        for step, slipping in enumerate(run["slip_nodes"]):
            if slipping == 25:
                self.assertLess(run["work_friction"][step], 0.0)
                bound = COEFFICIENT * run["contact_force_z"][step]
                self.expect_close(run["friction_force"][step], bound, 1e-9, f"friction at {step}")


if __name__ == "__main__":
    check_history.main()
