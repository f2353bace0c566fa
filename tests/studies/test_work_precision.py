#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study work-precision: a run is on the front if none is cheaper and as accurate; errors are
those of curves and numbers that are known, whatever the steps; a run that fails, or one of the
check, is on no front; the study files fit together, and the page of a small study says what its
runs say, the second time without running them.
"""

import csv
import math
import pathlib
import shutil
import sys
import types
import unittest

import check_history

sys.path.insert(0, str(check_history.SOURCE / "tools"))
from studies import instants, observe  # noqa: E402
from studies.expressions import Expression  # noqa: E402
from studies.quantities import read_quantities  # noqa: E402

try:
    from studies.work_precision import errors, front, page, peers, problem, study
except ImportError as error:
    front, missing = None, str(error)

STUDIES = check_history.PARAMETERS / "studies" / "work_precision"
PEERS = check_history.PARAMETERS / "studies" / "peers.csv"
NAN = math.nan
#: A study of a known force, with one variant that cannot run.
SMALL = """
[study]
scene = {scene}
title = Small
observe = impulse
peers = ball
[curves]
force = contact_force_x
[quantities]
impulse = integral(contact_force_x)
force_largest = largest(contact_force)
[exact]
force = -60*min(1, max(0, 1e9*(1/3 - t)))
impulse = -20
force_largest = 200
[scene]
Bodies/block/Element = standard
Bodies/block/Refinements = 0
[coarse]
Time/End time = 0.4
[schemes]
Time/Step size = 4e-2; 1e-2
[variant short steps]
group = further
Time/Scheme = contact-stabilized
Time/Step size = 2e-3
[variant impossible]
group = further
Time/Scheme = contact-stabilized
Time/Step size = -1
[variant too long for the quick version]
group = further
full = yes
Time/Scheme = contact-stabilized
Time/Step size = 1e-6
"""


def setUpModule():
    if not front:
        raise unittest.SkipTest(missing)
    instants.use(check_history.settings["executable"])


def folder_of(name):
    """A new folder for the results of a test."""
    folder = pathlib.Path(check_history.settings["folder"]) / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


class Front(unittest.TestCase):
    def test_what_nothing_beats(self):
        points = [(1, 8), (2, 9), (2, 4), (3, 4), (NAN, 1), (4, NAN), (5, 1), (5, 2)]
        self.assertEqual(front.pareto(points), [0, 2, 6])
        self.assertEqual(front.pareto([]), [])

    def test_the_cheapest_that_is_good_enough(self):
        points = [(3, 0.5), (1, 5), (2, 0.5), (0.5, NAN), (NAN, 0.1)]
        self.assertEqual(front.cheapest(points, 1), 2)
        self.assertEqual(front.cheapest(points, 10), 1)
        self.assertIsNone(front.cheapest(points, 0.1))

    def test_the_worst_of_several_errors_counts(self):
        rows = [(None, {"seconds": 1, "a": 1, "b": 7}), (None, {"seconds": 2, "a": 3}), (None, {})]
        one, other, none = front.points(rows, ["a", "b"])
        self.assertEqual(one, (1, 7))
        self.assertTrue(math.isnan(other[1]) and math.isnan(none[0]))


def made_up(folder, steps, factor):
    """A run whose force is 3 t times a factor in the middle of its steps, and a probe."""
    ends = [0.0]
    for step in steps:
        ends.append(ends[-1] + step)
    folder.mkdir()
    (folder / "parameters.prm").write_text(
        "subsection Time\n  set Scheme = contact-stabilized\nend\n", encoding="utf-8"
    )
    rows = zip(ends, [0.0, *steps])
    (folder / "history.csv").write_text(
        "time,step_size,contact_force\n"
        + "".join(f"{t},{s},{factor * 3 * (t - s / 2)}\n" for t, s in rows),
        encoding="utf-8",
    )
    (folder / "probe_p.csv").write_text(
        "time,displacement_x\n" + "".join(f"{t},{2 * factor * t}\n" for t in ends),
        encoding="utf-8",
    )
    return observe.Result(folder)


class Errors(unittest.TestCase):
    def small(self, **exact):
        """What errors need of a study."""
        return types.SimpleNamespace(
            curves={"force": "contact_force", "displacement": "p.displacement_x"},
            observe=["impulse"],
            observations=observe.OBSERVATIONS,
            exact={name: Expression(text, name) for name, text in exact.items()},
        )

    def test_one_per_cent_is_one_per_cent_whatever_the_steps(self):
        folder = folder_of("errors")
        right = made_up(folder / "right", [0.1] * 10, 1.0)
        wrong = made_up(folder / "wrong", [0.2, 0.1, 0.4, 0.2, 0.1], 1.01)
        for exact in ({}, {"force": "3*t", "displacement": "2*t", "impulse": "3/2"}):
            expected = errors.Expected(self.small(**exact), right, right)
            found = expected.errors(wrong)
            self.assertEqual(list(found), expected.names())
            # Between the last force and the end the curve is constant: a trace of the step size.
            self.assertAlmostEqual(found["force"], 1.0, delta=0.4 if exact else 0.1)
            self.assertAlmostEqual(found["displacement"], 1.0, places=6)
            self.assertAlmostEqual(found["impulse"], 1.0, places=6)
            self.assertLess(expected.errors(right)["displacement"], 1e-9)

    def test_times_are_known_to_a_step(self):
        made = self.small()
        made.observe = ["impulse", "ends"]
        made.observations = {
            **made.observations,
            **read_quantities({"ends": "end(contact_force)"}, "made", None),
        }
        run = made_up(folder_of("steps") / "run", [0.1] * 10, 1.0)
        expected = errors.Expected(made, run, run)
        self.assertAlmostEqual(expected.resolution("ends"), 10.0)
        self.assertEqual(expected.resolution("impulse"), 0.0)
        self.assertEqual(expected.resolution("force"), 0.0)

    def test_too_little_is_as_wrong_as_too_much(self):
        for value, exact in ((0.99, 1.0), (1.01, 1.0), (-2.02, -2.0), (-1.98, -2.0)):
            self.assertAlmostEqual(errors.relative(value, exact), 1.0)

    def test_a_number_that_should_be_zero_has_no_relative_error(self):
        self.assertTrue(math.isnan(errors.relative(1.0, 0.0)))


class Peers(unittest.TestCase):
    def test_every_line_has_its_numbers(self):
        with open(PEERS, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertLessEqual({"ball", "cubes"}, {row["case"] for row in rows})
        for row in rows:
            self.assertNotIn(None, row)
            self.assertTrue(row["code"] and row["version"] and row["measured"], row)
            for name in ("dofs", "steps", *peers.COMPARED):
                peers.number(row[name])

    def test_a_force_that_alternates_counts_with_its_mean(self):
        """At the ends of steps it is twice the mean; in the middle it is what it is."""
        made = observe.Result("none")
        made.history = {
            "time": [0.0, 0.1, 0.2, 0.3],
            "step_size": [0.0, 0.1, 0.1, 0.1],
            "contact_force": [0.0, 8.0, 0.0, 8.0],
        }
        made.keys_of_time = {"Scheme": "newmark"}
        self.assertAlmostEqual(peers.mean_force(made), 4.0)
        made.keys_of_time = {"Scheme": "contact-stabilized"}
        self.assertAlmostEqual(peers.mean_force(made), 8.0)

    def test_the_time_of_a_run_is_that_of_its_steps_if_not_noted(self):
        row = {"processor_s": "", "steps": "100", "processor_s_per_step": "0.13"}
        self.assertAlmostEqual(peers.seconds(row), 13.0)
        self.assertEqual(peers.seconds({**row, "processor_s": "9.7"}), 9.7)
        self.assertTrue(math.isnan(peers.seconds({**row, "processor_s_per_step": ""})))


class Files(check_history.SceneTest):
    def test_they_fit_together(self):
        """Of each group of variants the last one, and the reference, are scenes that can run."""
        folder = folder_of("files")
        for path in sorted(STUDIES.glob("*.ini")):
            case = problem.Case(path, False, folder)
            self.assertTrue(case.study.path_of_schemes, path.name)
            last = {variant.group: task for variant, task in zip(case.study.variants, case.tasks)}
            for task in [*last.values(), *([case.reference] if case.reference else [])]:
                self.expect_valid(task)


class Study(unittest.TestCase):
    def arguments(self, root, draw_only):
        return types.SimpleNamespace(
            executable=check_history.settings["executable"],
            folder=root / "results",
            coarse=True,
            draw_only=draw_only,
        )

    def test_a_small_one(self):
        root = folder_of("small")
        (root / "parameters" / "studies" / "work_precision").mkdir(parents=True)
        (root / "parameters" / "studies" / "work_precision" / "block.ini").write_text(
            SMALL.format(scene=check_history.PARAMETERS / "sliding_block.prm"), encoding="utf-8"
        )
        shutil.copy(PEERS, root / "parameters" / "studies")
        self.assertTrue(study.work_precision(self.arguments(root, False), root))
        text = (root / "results" / "tables.md").read_text(encoding="utf-8")
        for picture in ("block.png", "block_peers.png"):
            self.assertTrue((root / "results" / picture).is_file())
        with open(root / "results" / "block.csv", newline="", encoding="utf-8") as file:
            rows = {row["run"]: row for row in csv.DictReader(file)}
        # One run for each scheme that knows friction; those that do not are named, with a reason.
        self.assertIn("contact-implicit 1", rows)
        self.assertNotIn("contact-implicit 2", rows)
        self.assertNotIn("too long for the quick version", rows)
        self.assertRegex(text, r"Not run along the path: `hht-alpha` \(.*friction")
        # Twenty times shorter steps make the impulse better and cost more products.
        short, coarse = rows["short steps"], rows["contact-stabilized 1"]
        self.assertLess(5 * float(short["impulse, %"]), float(coarse["impulse, %"]))
        self.assertGreater(float(short["products"]), 2 * float(coarse["products"]))
        self.assertIn("force", short["front"])
        # The failed run is a line of dashes, on no front, and the page says so.
        self.assertEqual(rows["impossible"]["front"], "-")
        self.assertIn("Failed: `impossible`", text)
        self.assertIn("CalculiX", text)
        self.assertTrue(study.work_precision(self.arguments(root, True), root))
        self.assertEqual((root / "results" / "tables.md").read_text(encoding="utf-8"), text)

    def test_a_level_below_what_the_reference_leaves_open(self):
        rows = [
            (types.SimpleNamespace(name="one"), {"seconds": 1.0, "products": 5, "force": 0.05}),
        ]
        made = types.SimpleNamespace(rows=rows, floor={"force": 0.3}, quantities=["force"])
        self.assertIn("one", page.answer(made, ["force"], 1))
        self.assertIn("not known", page.answer(made, ["force"], 0.1))
        made.floor = {}
        self.assertIn("one", page.answer(made, ["force"], 0.1))
        self.assertEqual(page.answer(made, ["force"], 0.01), "none of these")


if __name__ == "__main__":
    check_history.main()
