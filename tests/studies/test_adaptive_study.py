#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study of adaptive runs: curves with different steps are compared at the instants to which
forces belong, so that a linear force has no error whatever the steps are; a uniform mesh that is as
accurate as an adaptive run is found on the curve through the uniform runs, and nowhere beyond it;
its files fit together and the scenes of their variants are valid.
"""

import math
import pathlib
import sys
import types
import unittest

import check_history
import numpy

sys.path.insert(0, str(check_history.SOURCE / "tools"))
from studies import adaptive, adaptive_measures as measures, instants  # noqa: E402


def setUpModule():
    instants.use(check_history.settings["executable"])


class Run(types.SimpleNamespace):
    """What is looked at of a run."""

    def __getitem__(self, column):
        return self.history[column]


def linear_force(steps):
    """A run with the force 3 t, taken in the middle of its steps."""
    ends = [0.0, *numpy.cumsum(steps)]
    forces = [0.0, *(3 * (end - step / 2) for end, step in zip(ends[1:], steps))]
    return Run(
        keys_of_time={"Scheme": "contact-stabilized"},
        history={"time": ends, "step_size": [0.0, *steps], "contact_force": forces},
    )


class Measures(unittest.TestCase):
    def test_steps_do_not_matter_for_a_linear_force(self):
        times = numpy.linspace(0.0, 0.8, 101)
        one, other = (
            measures.force_curve(linear_force(steps), times)
            for steps in ([0.1] * 10, [0.2, 0.1, 0.4, 0.2, 0.1])
        )
        self.assertLess(measures.distance(one, other), 1e-10)
        self.assertAlmostEqual(measures.distance(1.01 * one, other), 1.0, places=8)

    def test_a_uniform_mesh_of_the_same_error(self):
        uniform = [
            {"force": 8.0, "dofs": 100.0},
            {"force": 4.0, "dofs": 400.0},
            {"force": 2.0, "dofs": 1600.0},
        ]
        self.assertAlmostEqual(measures.needed(math.sqrt(8.0), uniform, "dofs", "force"), 800.0)
        self.assertAlmostEqual(
            measures.gain({"force": 4.0, "dofs": 50.0}, uniform, "dofs", "force"), 8.0
        )
        self.assertTrue(math.isnan(measures.needed(1.0, uniform, "dofs", "force")))
        self.assertTrue(math.isnan(measures.needed(9.0, uniform, "dofs", "force")))

    def test_parts_of_the_run_time(self):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "log.txt").write_text(
            """
| Total wallclock time elapsed   |  10.0s     0 |  10.0s |  10.0s     0 |
| Section            | no. calls |   min time  rank |   avg time |   max time  rank |
| first step on a mesh           |    24 |    1.5s     0 |  1.5s |  1.5s     0 |
| later steps on a mesh          |    76 |    2.5s     0 |  2.5s |  2.5s     0 |
| mesh: indicator and marking    |   100 |    3e-1s    0 |  0.3s |  0.3s     0 |
""",
            encoding="utf-8",
        )
        parts = measures.where_the_time_went(Run(folder=folder))
        self.assertEqual([round(part) for part in parts.values()], [40, 3, 0, 0, 57])

    def test_estimates_as_runs_say_them(self):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "log.txt").write_text(
            "  error of force    about 3.4 % by the mesh (estimated; L2 in time)\n"
            "  error of stress   more than 100 % by the mesh (estimated)\n",
            encoding="utf-8",
        )
        self.assertEqual(measures.estimated(Run(folder=folder), "force"), 3.4)
        self.assertEqual(measures.said(measures.estimated(Run(folder=folder), "stress")), "> 100")
        self.assertTrue(math.isnan(measures.estimated(Run(folder=folder), "pressure")))


class Files(check_history.SceneTest):
    def test_they_fit_together(self):
        for name in adaptive.CASES:
            for coarse in (False, True):
                case = adaptive.Case(
                    check_history.PARAMETERS / "studies" / "adaptive" / f"{name}.ini",
                    coarse,
                    pathlib.Path(check_history.settings["folder"]),
                )
                groups = [variant.group for variant in case.study.variants]
                self.assertGreater(groups.count(adaptive.UNIFORM), 1, name)
                self.assertGreater(len(set(groups)), 2, name)
            last = {
                variant.group.split(",")[0]: task
                for variant, task in zip(case.study.variants, case.tasks)
            }
            for task in [*last.values(), *([case.reference] if case.reference else [])]:
                self.expect_valid(task)


if __name__ == "__main__":
    check_history.main()
