#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What friction costs is counted, as times depend on the machine: sweeps solve with the terms of
slip as fast as without (11.2 instead of 10.5 iterations, 4.5 instead of 4.1 products per step), and
an incomplete factor with GMRES in double precision finds the same motion.
"""

import check_history


class FrictionPrice(check_history.SceneTest):
    def test_price(self):
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
