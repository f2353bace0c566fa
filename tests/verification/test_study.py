#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A study runs all combinations of its variations and tabulates them: one row per run, rates between neighbours of a refinement (which
for the impact of a bar lie between one half and two). Mistakes in the file are named, and a run that fails does not spoil the others.
"""

import csv
import pathlib
import subprocess
import sys

import check_history

TOOL = check_history.SOURCE / "tools" / "study.py"


class StudyTest(check_history.SceneTest):
    def run_study(self, name, text):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / f"{name}.ini"
        file.write_text(text, encoding="utf-8")
        result = subprocess.run([sys.executable, str(TOOL), check_history.settings["executable"], str(file), str(folder / name)],
                                capture_output=True, text=True, timeout=check_history.TIMEOUT, check=False)
        table = folder / name / "table.csv"
        if not table.exists():
            return result, []
        with open(table, newline="", encoding="utf-8") as lines:
            return result, list(csv.reader(lines))

    def test_combinations_and_rates(self):
        result, rows = self.run_study("impact", f"""
[study]
scene = {check_history.PARAMETERS / "bar_2d.prm"}
observe = energy_change, displacement_error
[variations]
Time/Scheme = contact-implicit; laursen-chawla
Time/End time = 1
[together]
Time/Step size = 6e-3; 3e-3
Bodies/bar/Repetitions = 1, 50; 1, 100
""")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(rows[0], ["Scheme", "End time", "Step size", "Repetitions", "energy at the end, %", "e_u, %", "rate"])
        self.assertEqual([row[0] for row in rows[1:]], ["contact-implicit"] * 2 + ["laursen-chawla"] * 2)
        self.assertEqual([row[2] for row in rows[1:]], ["6e-3", "3e-3"] * 2)
        self.assertLess(abs(float(rows[3][4])), 1e-8)
        self.assertLess(float(rows[1][4]), 1.5 * float(rows[2][4]))
        for first, second in ((rows[1], rows[2]), (rows[3], rows[4])):
            self.assertEqual(first[6], "")
            self.assertGreater(float(second[6]), 0.4)
            self.assertLess(float(second[6]), 2.2)

    def test_mistakes_are_named(self):
        for text, message in (("[study]\nscene = nowhere.prm\n[variations]\na = 1\n", "there is no file"),
                              ("[study]\n[variations]\na = 1\n", "needs `scene = ...`"),
                              ("[study]\nscene = mistake.ini\n", "nothing varies"),
                              ("[study]\nscene = mistake.ini\nobserve = forse\n[variations]\na = 1\n", "forse is not known"),
                              ("[study]\nscene = mistake.ini\n[together]\na = 1; 2\nb = 1\n", "the same number of values"),
                              ("[studie]\n", "unknown section [studie]")):
            result, _ = self.run_study("mistake", text)
            self.assertEqual(result.returncode, 1)
            self.assertIn(message, result.stderr)

    def test_a_failing_run_is_reported_and_the_others_are_not_lost(self):
        result, rows = self.run_study("failing", f"""
[study]
scene = {check_history.PARAMETERS / "bar_2d.prm"}
observe = impulse
[variations]
Time/Scheme = nonsense; newmark
Time/End time = 0.06
""")
        self.assertEqual(result.returncode, 1)
        self.assertIn("nonsense", result.stdout)
        self.assertEqual(rows[1][2], "nan")
        self.assertEqual(float(rows[2][2]), 0.)


if __name__ == "__main__":
    check_history.main()
