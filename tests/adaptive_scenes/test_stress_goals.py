#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs on meshes that are made for a stress: of a contact that is small beside the body the
pressure is several times better than on a uniform mesh with as many unknowns, and what the run
says of it is right but for a factor; the stress at probes comes with its own line; two processes
make the same meshes, and so does a run that goes on from a checkpoint.
"""

import re

import check_history
import test_adaptivity as mesh_runs
from test_force_goal import SLOW_DISC

#: A point inside the disc beside the node at its lower end that the scene has.
PROBES = [
    "Probes/Names=south_pole, inside",
    "Probes/inside/Body=disc",
    "Probes/inside/Point=0.02, 0.2",
]


#: What runs are compared with: an equally fine disc whose contact is four times finer still.
FINE = [
    "Bodies/disc/Refinements=6",
    "Bodies/disc/Local refinements=2",
    "Bodies/disc/Refine where=0.1 - sqrt(x^2 + y^2)",
]


def goal(name, target, levels):
    """Keys for meshes of these levels."""
    return [
        f"Bodies/disc/Refinements={levels[0]}",
        "Adaptivity/Indicator=residual",
        f"Adaptivity/Goal={name}",
        f"Adaptivity/Target error={target}",
        f"Adaptivity/Maximum level={levels[1]}",
    ]


class StressGoals(check_history.SceneTest):
    expect_account = mesh_runs.Adaptivity.expect_account
    expect_same_meshes = mesh_runs.Adaptivity.expect_same_meshes

    def run_disc(self, name, overrides, processes=1):
        scene = check_history.PARAMETERS / "disc_2d.prm"
        return check_history.Run(scene, name, SLOW_DISC + overrides, processes)

    def estimated_error(self, run, what):
        """Of a stress, as the summary says."""
        return 0.01 * float(re.search(rf"error of stress +about (\S+) % of {what}", run.log)[1])

    def pressure_error(self, run, fine):
        """At the lower end of the disc."""
        one, other = (r.probes["south_pole"]["pressure"] for r in (run, fine))
        return mesh_runs.distance(one, other)

    def test_contact_pressure(self):
        fine = self.run_disc("fine", FINE)
        coarse = self.run_disc("coarse", ["Bodies/disc/Refinements=4"])
        run = self.run_disc("pressure", goal("contact pressure", 0.1, (4, 8)))
        self.expect_account(run, 1e-9)
        self.assertLess(sum(run["dofs"]) / len(run), 1.5 * coarse["dofs"][0])
        self.assertLess(self.pressure_error(run, fine), 0.2 * self.pressure_error(coarse, fine))
        self.assertLess(self.estimated_error(run, "the contact pressure"), 0.15)
        self.assertNotIn("the target was", run.log)

        # Judged only: the estimate of uniform meshes, and that they miss the target.
        judged = self.run_disc("judged", goal("contact pressure", 0.1, (4, 4)))
        self.assertEqual(mesh_runs.n_meshes(judged), 1)
        self.assertGreater(self.estimated_error(judged, "the contact pressure"), 0.15)
        self.assertIn("the target was 10 %", judged.log)

    def test_probes(self):
        """Each probe has its estimate, and both are right but for a factor of 4."""
        fine = self.run_disc("probes-fine", [*PROBES, *FINE])
        run = self.run_disc("probes", [*PROBES, *goal("probe", 0.1, (4, 7))])
        self.expect_account(run, 1e-9)
        places = ("the pressure at the probe 'south_pole'", "the stress at the probe 'inside'")
        estimates = [self.estimated_error(run, place) for place in places]
        self.assertLess(self.pressure_error(run, fine), 4.0 * estimates[0])
        components = [f"stress_{c}" for c in ("xx", "yy", "zz", "xy")]
        stress, exact = (
            [value for c in components for value in r.probes["inside"][c]] for r in (run, fine)
        )
        self.assertLess(mesh_runs.distance(stress, exact), 4.0 * estimates[1])
        for estimate in estimates:
            self.assertLess(estimate, 0.15)

    def test_no_stress_to_be_known(self):
        """A disc that turns freely has the stress of round-off and of its linear strains: beside
        that of the impact of the other one it needs no cells. Nor is there anything to be known of
        a node that touches nothing."""
        other = {
            "Shape": "ball",
            "Centre": "5, 6",
            "Radius": "1",
            "Refinements": "3",
            "Young's modulus": "500",
            "Poisson's ratio": "0.3",
            "Density": "1",
            "Initial velocity": "-1e-3*(y - 6); 1e-3*(x - 5) - 0.1",
        }
        run = self.run_disc(
            "free",
            [
                *goal("probe", 0.1, (4, 5)),
                "Bodies/disc/Initial velocity=0; -0.6",
                "Time/End time=0.16",
                "Bodies/Names=disc, other",
                *(f"Bodies/other/{key}={value}" for key, value in other.items()),
                "Contact/Pairs=disc : floor, other : floor",
                "Probes/Names=south_pole, inside",
                "Probes/south_pole/Point=4, 6",
                "Probes/inside/Body=other",
                "Probes/inside/Point=5.02, 6.2",
            ],
        )
        disc, free = 5 * 4**4, 5 * 4**3
        self.assertGreater(max(run["contact_force"]), 0.0)
        self.assertLess(max(run["cells"]), disc + free + 0.2 * free)
        self.assertIn("none of the pressure at the probe 'south_pole'", run.log)
        self.assertLess(self.estimated_error(run, "the stress at the probe 'inside'"), 0.1)

    def test_two_processes(self):
        for name in ("contact pressure", "probe"):
            with self.subTest(goal=name):
                keys = [*PROBES, *goal(name, 0.1, (4, 7)), "Time/End time=0.24"]
                one, two = (self.run_disc(f"{name[:5]}-{n}", keys, n) for n in (1, 2))
                self.expect_same_meshes(one, two, "momentum_y")


if __name__ == "__main__":
    check_history.main()
