#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A study runs all combinations of its variations and tabulates them: one row per run, rates
between neighbours of a refinement (which for the impact of a bar lie between one half and two).
Runs are compared with an exact force and with a reference run; a run equal to its reference has no
distance from it. Mistakes in the file are named, and a run that fails does not spoil the others.
"""

import csv
import math
import pathlib
import re
import subprocess
import sys

import check_history

sys.path.insert(0, str(check_history.SOURCE / "tools"))
from studies import distances, instants  # noqa: E402
from studies.expressions import Expression  # noqa: E402
from studies.mistake import Mistake  # noqa: E402
from studies.quantities import read_quantities  # noqa: E402

TOOL = check_history.SOURCE / "tools" / "study.py"
BAR = check_history.PARAMETERS / "bar_2d.prm"
STUDY, VARIATIONS = "[study]\nscene = mistake.ini\n", "[variations]\na = 1\n"
#: A study file, and what the answer must say.
MISTAKES = (
    ("[study]\nscene = nowhere.prm\n" + VARIATIONS, "there is no file"),
    ("[study]\n" + VARIATIONS, "needs `scene = ...`"),
    (STUDY, "nothing varies"),
    (STUDY + "observe = forse\n" + VARIATIONS, "forse is not known"),
    (STUDY + "[together]\na = 1; 2\nb = 1\n", "the same number of values"),
    ("[studie]\n", "unknown section [studie]"),
    (STUDY + "observe = force_distance\n" + VARIATIONS, "needs a section [reference]"),
    (STUDY + "observe = force_error\n" + VARIATIONS, "needs `exact force = ...`"),
    (STUDY + "exact force = 2*x\n" + VARIATIONS, "exact force = 2*x: x is not known"),
    (STUDY + "obsreve = impulse\n" + VARIATIONS, "no key `obsreve`"),
    (STUDY + VARIATIONS + "[reference]\n", "[reference] is empty"),
    (STUDY + VARIATIONS + "[reference]\nb = 1\n", "needs the step size of each run"),
    (STUDY + "figure = impulse\n" + VARIATIONS, "give two observations or quantities"),
    (STUDY + "curve = nowhere.csv\n" + VARIATIONS, "curve = "),
    (STUDY + "[quantities]\na b = 1\n" + VARIATIONS, "is no name"),
    (
        f"[study]\nscene = {BAR}\n[variations]\nTime/Step size = 2e-3; 3e-3\n[reference]\nb = 1\n",
        "the step size 0.003 is no whole multiple of it. Give `Time/Step size` in [reference]",
    ),
    (
        f"[study]\nscene = {BAR}\n{VARIATIONS}[reference]\nTime/Step size = 2e-3\n",
        "[reference] Time/Step size = 2e-3: the step size 0.003 of a run is no whole multiple",
    ),
)


class StudyTest(check_history.SceneTest):
    def run_study(self, name, text):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / f"{name}.ini"
        file.write_text(text, encoding="utf-8")
        result = subprocess.run(
            [
                sys.executable,
                str(TOOL),
                check_history.settings["executable"],
                str(file),
                str(folder / name),
            ],
            capture_output=True,
            text=True,
            timeout=check_history.TIMEOUT,
            check=False,
        )
        table = folder / name / "table.csv"
        if not table.exists():
            return result, []
        with open(table, newline="", encoding="utf-8") as lines:
            return result, list(csv.reader(lines))

    def test_combinations_and_rates(self):
        result, rows = self.run_study(
            "impact",
            f"""
[study]
scene = {BAR}
observe = energy_change, displacement_error
[variations]
Time/Scheme = contact-implicit; laursen-chawla
Time/End time = 1
[together]
Time/Step size = 6e-3; 3e-3
Bodies/bar/Repetitions = 1, 50; 1, 100
""",
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(
            rows[0],
            [
                "Scheme",
                "End time",
                "Step size",
                "Repetitions",
                "energy at the end, %",
                "e_u, %",
                "rate",
            ],
        )
        self.assertEqual(
            [row[0] for row in rows[1:]], ["contact-implicit"] * 2 + ["laursen-chawla"] * 2
        )
        self.assertEqual([row[2] for row in rows[1:]], ["6e-3", "3e-3"] * 2)
        self.assertLess(abs(float(rows[3][4])), 1e-8)
        self.assertLess(float(rows[1][4]), 1.5 * float(rows[2][4]))
        for first, second in ((rows[1], rows[2]), (rows[3], rows[4])):
            self.assertEqual(first[6], "")
            self.assertGreater(float(second[6]), 0.4)
            self.assertLess(float(second[6]), 2.2)

    def test_mistakes_are_named(self):
        for text, message in MISTAKES:
            result, _ = self.run_study("mistake", text)
            self.assertEqual(result.returncode, 2)
            self.assertIn(message, result.stderr)

    def test_distance_from_a_reference(self):
        """The massless bar hits the wall: both step sizes share one reference for each mesh; the
        reference itself is at no distance. It accepts an error of 1e-10 in each of 90 steps, less
        than what is asked of their sum."""
        result, rows = self.run_study(
            "reference",
            f"""
[study]
scene = {BAR}
observe = displacement_distance, velocity_distance, force_distance, force_error
exact force = 30*max(0, min(1, 1e6*(t - 0.5)))
[scene]
Time/End time = 0.9
Time/Reference tolerance = 1e-10
[variant classical]
Time/Scheme = khenous-laborde-renard
Time/Newmark beta = 0.25
[variant exact]
Time/Scheme = reference
[variations]
Bodies/bar/Repetitions = 1, 10; 1, 20
[together]
Time/Step size = 2e-2; 1e-2
[reference]
Time/Scheme = reference
""",
        )
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        folder = pathlib.Path(check_history.settings["folder"]) / "reference" / "reference"
        self.assertEqual(sorted(path.name for path in folder.iterdir()), ["1", "2"])
        self.assertEqual(
            rows[0][3:],
            [
                "distance of the displacement, %",
                "rate",
                "distance of the velocity, %",
                "rate",
                "distance of the force, %",
                "rate",
                "e_r, %",
                "rate",
            ],
        )
        for coarse, fine in (
            (rows[1], rows[2]),
            (rows[3], rows[4]),
        ):  # second order on a given mesh; the exact bar is elsewhere
            self.assertGreater(float(fine[8]), 1.8)
            self.assertGreater(float(fine[9]), 4 * float(fine[7]))
            # Until release the contact node moves as that of the reference.
            for row in (coarse, fine):
                self.assertLess(float(row[3]), 1e-6)
                self.assertLess(float(row[5]), 1e-6)
        self.assertEqual([row[3:8:4] for row in (rows[6], rows[8])], [["0", "0"]] * 2)
        self.assertLess(float(rows[6][5]), 1e-11)
        for row in rows[5:]:  # the step size has no influence on the integrator
            self.assertLess(float(row[7]), 1e-4)

    def test_every_scheme_has_an_instant_of_its_force(self):
        instants.use(check_history.settings["executable"])
        self.assertIn("contact-stabilized", instants.schemes)
        for name, scheme in instants.schemes.items():
            keys = {"Scheme": name, scheme["parameter"]: "0.25"}
            self.assertTrue(-0.25 <= instants.before_end(keys) <= 1.0, name)
        with self.assertRaisesRegex(Mistake, "does not know the scheme"):
            instants.before_end({"Scheme": "unheard-of"})
        self.assertAlmostEqual(
            instants.before_end({"Scheme": "generalized-alpha", "Spectral radius": "1"}), 0.5
        )

    def test_expressions(self):
        value = Expression("0.005 * 5 * max(-sin(2*pi*(t + 0.05)), 0)**3", "file: exact force")
        self.assertAlmostEqual(value(0.7), 0.025)
        self.assertEqual(value(0.2), 0.0)
        self.assertEqual(Expression("-t^2 + min(3, abs(-2), 4)/sqrt(4)", "")(3.0), -8.0)
        for text, message in (
            ("2 +", "cannot be read"),
            ("a", "a is not known"),
            ("open('x')", "the function open is not known"),
            ("t.real", "not arithmetic"),
            ("'t'", "not arithmetic"),
            ("True", "not arithmetic"),
            ("t if t else 1", "not arithmetic"),
            ("sin(1, 2)", "wants one argument"),
            ("max(1)", "wants two arguments or more"),
            ("", "cannot be read"),
            ("sin", "sin is not known"),
        ):
            with self.assertRaisesRegex(Mistake, re.escape(message), msg=text):
                Expression(text, "file: exact force")
        for text in ("1/t", "sqrt(t - 1)", "(t - 1)**0.5", "9**9**9", "1e308*10"):
            with self.assertRaisesRegex(Mistake, "value at t = 0", msg=text):
                Expression(text, "file: exact force")(0.0)

    def test_quantities(self):
        """Of a history of three rows; a quantity can use those before it, and a curve."""

        class Run:
            columns = {
                "time": [0.0, 0.5, 0.75],
                "force": [9.0, 2.0, -4.0],
                "hit": [0.0, 0.0, 3.0],
                "rest": [0.0, 0.0, 0.0],
            }
            folder = pathlib.Path("run")

        curve = distances.Curve([0.0, 1.0], [0.0, 3.0])
        found = read_quantities(
            {
                "a": "first(force) - last(force)/2 + largest(force)",
                "b": "integral(force)",
                "c": "a + 2*b",
                "d": "curve(b + 0.5)",
                "e": "begin(hit) + 10*end(hit) + 100*duration(hit)",
                "f": "duration(force) + duration(rest)",
                "g": "end(rest)",
                "h": "2*g",
            },
            "file",
            curve,
        )
        self.assertEqual([found[name](Run()) for name in "abcd"], [20.0, 0.0, 20.0, 1.5])
        # The force acts all the time, the hit in the last quarter of a second, the rest never.
        self.assertEqual([found[name](Run()) for name in "ef"], [33.0, 0.75])
        self.assertTrue(math.isnan(found["g"](Run())) and math.isnan(found["h"](Run())))
        self.assertEqual(found["c"].heading, "c")
        self.assertTrue(math.isnan(found["a"](None)))
        for text, message in (
            ("b", "b is not known"),
            ("force", "force is not known"),
            ("last(2)", "last wants the name of a column"),
            ("last(force, force)", "last wants the name of a column"),
            ("curve(1)", "the function curve is not known"),
        ):
            with self.assertRaisesRegex(Mistake, re.escape(message), msg=text):
                read_quantities({"a": text}, "file", None)
        with self.assertRaisesRegex(Mistake, "has a column forse. There are time, force"):
            read_quantities({"a": "last(forse)"}, "file", None)["a"](Run())

    def test_quantities_of_a_study(self):
        """The wall takes twice the momentum of a bar that returns as it came; the points lie on the
        line of the curve, which the figure shows."""
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "line.csv").write_text("impulse,twice\n-100,200\n100,-200\n", encoding="utf-8")
        result, rows = self.run_study(
            "quantities",
            f"""
[study]
scene = {BAR}
observe = turned, deviation, difference
curve = line.csv
figure = impulse over turned
[scene]
Bodies/bar/Repetitions = 1, 20
Time/Step size = 1e-2
[quantities]
turned = last(momentum_y) - first(momentum_y)
deviation = integral(contact_force_y) - curve(-turned/2)
difference = duration(contact_force) - end(pair_0_normal_force) + begin(pair_0_normal_force)
[variations]
Time/Scheme = contact-implicit; laursen-chawla
""",
        )
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(rows[0], ["Scheme", "turned", "deviation", "difference"])
        for row in rows[1:]:
            self.assertGreater(abs(float(row[1])), 1.0)
            self.assertLess(abs(float(row[2])), 1e-8)
            self.assertLess(abs(float(row[3])), 0.05)
        self.assertTrue((folder / "quantities" / "figure.png").read_bytes().startswith(b"\x89PNG"))

    def test_distances(self):
        curve = distances.Curve([0.0, 1.0, 3.0], [0.0, 2.0, 6.0])
        self.assertEqual(
            [curve(time) for time in (-1.0, 0.0, 0.5, 1.0, 2.0, 3.0, 4.0)],
            [0.0, 0.0, 1.0, 2.0, 4.0, 6.0, 6.0],
        )
        self.assertAlmostEqual(distances.relative([(1.1, 1.0), (0.0, 0.0)]), 10.0)
        self.assertTrue(math.isnan(distances.relative([(1.0, 0.0)])))

    def test_a_failing_run_is_reported_and_the_others_are_not_lost(self):
        result, rows = self.run_study(
            "failing",
            f"""
[study]
scene = {BAR}
observe = impulse
[variations]
Time/Scheme = nonsense; newmark
Time/End time = 0.06
""",
        )
        self.assertEqual(result.returncode, 1)
        self.assertIn("nonsense", result.stdout)
        self.assertEqual(rows[1][2], "nan")
        self.assertEqual(float(rows[2][2]), 0.0)


if __name__ == "__main__":
    check_history.main()
