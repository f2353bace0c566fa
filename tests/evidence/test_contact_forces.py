#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The contact force on each body by three routes: what changes its momentum is the sum of the
multipliers, to the accuracy of the solver, for every scheme that has one force in a step; the
stress at the boundary comes to it with the mesh, at first order.
"""

import check_history

AXES = "xyz"
#: One contact force in a step, see doc/output.md.
ONE_FORCE = (
    "contact-stabilized-projected",
    "contact-stabilized",
    "contact-implicit",
    "laursen-chawla",
    "laursen-love",
    "hager-hueeber-wohlmuth",
    "newmark",
    "backward-euler",
    "moreau-jean",
)


class ContactForces(check_history.SceneTest):
    def run_scene(self, scene, name, *overrides, processes=1):
        run = check_history.Run(
            check_history.scene_file(scene), f"forces-{name}", list(overrides), processes
        )
        self.expect_contact(run)
        return run

    def routes(self, run, body, route):
        table = run.table("forces")
        return list(zip(*(table[f"force_{body}_{route}_{axis}"] for axis in AXES)))

    def expect_momentum(self, run, *bodies):
        """Relative to the largest force on any body."""
        pairs = [
            (body, row, a, b)
            for body in bodies
            for row, (a, b) in enumerate(
                zip(self.routes(run, body, "multiplier"), self.routes(run, body, "momentum"))
            )
        ]
        largest = max(abs(c) for _, _, force, _ in pairs for c in force)
        self.assertGreater(largest, 0)
        for body, row, a, b in pairs:
            for c in range(3):
                self.assertLess(
                    abs(a[c] - b[c]), 1e-7 * largest, f"{body}, {AXES[c]} in row {row}: {a} {b}"
                )

    def mean_spread(self, run, body):
        """Over the rows in which the force is more than half of the largest one."""
        forces = [max(map(abs, force)) for force in self.routes(run, body, "multiplier")]
        spreads = run.table("forces")[f"force_{body}_spread"]
        kept = [s for s, force in zip(spreads, forces) if force > 0.5 * max(forces)]
        return sum(kept) / len(kept)

    def test_momentum_of_every_scheme(self):
        for scheme in ONE_FORCE:
            with self.subTest(scheme=scheme):
                run = self.run_scene(
                    "disc_2d", scheme, "Bodies/disc/Refinements=3", f"Time/Scheme={scheme}"
                )
                self.expect_momentum(run, "disc")

    def test_momentum_with_loads_supports_friction_and_damping(self):
        """And several bodies, whose forces add up to those of the obstacles."""
        run = self.run_scene("stack_of_boxes", "stack", "Time/End time=0.08")
        self.expect_momentum(run, "lower", "middle", "upper")
        run = self.run_scene("hammer_and_anvil", "hammer", processes=2)
        self.expect_momentum(run, "hammer", "anvil")
        run = self.run_scene("two_balls_off_centre", "balls", "Time/End time=0.2")
        self.expect_momentum(run, "upper", "lower")
        for a, b in zip(
            self.routes(run, "upper", "multiplier"), self.routes(run, "lower", "multiplier")
        ):
            for c in range(3):
                self.assertLess(abs(a[c] + b[c]), 1e-9 * max(run["contact_force"]))
        run = self.run_scene("sliding_block", "sliding", "Time/End time=0.1")
        self.assertGreater(max(run["friction_force"]), 0)
        self.expect_momentum(run, "block")
        run = self.run_scene(
            "disc_2d", "damped", "Bodies/disc/Refinements=3", "Bodies/disc/Damping=3, 1e-3"
        )
        self.expect_momentum(run, "disc")

    def test_stress_comes_with_the_mesh(self):
        """At first order: half of the spread on half the cells, or nearly."""
        for scene, body, key, levels in (
            ("disc_2d", "disc", "Refinements", (3, 4, 5)),
            ("static_hertz", "dome", "Local refinements", (1, 2, 3)),
        ):
            spreads = [
                self.mean_spread(
                    self.run_scene(scene, f"{scene}-{level}", f"Bodies/{body}/{key}={level}"), body
                )
                for level in levels
            ]
            self.assertLess(spreads[0], 0.06, scene)
            for coarse, fine in zip(spreads, spreads[1:]):
                self.assertLess(fine, coarse / 1.6, f"{scene}: {spreads}")

    def test_processes_and_rows(self):
        """The same on two processes; rows that are left out change nothing in those that stay."""
        one, two, seldom = (
            self.run_scene(
                "disc_2d",
                f"rows-{every}-{processes}",
                "Bodies/disc/Refinements=4",
                f"Output/History every={every}",
                processes=processes,
            ).table("forces")
            for every, processes in ((1, 1), (1, 2), (5, 1))
        )
        for column, values in one.items():
            largest = max(max(map(abs, values)), 1e-6)
            for a, b in zip(values, two[column]):
                self.assertLess(abs(a - b), 1e-6 * max(largest, 1.0), column)
            for a, b in zip(values[::5], seldom[column]):
                self.assertLess(abs(a - b), 1e-9 * max(largest, 1.0), column)


if __name__ == "__main__":
    check_history.main()
