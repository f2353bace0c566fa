#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The studies with a name: their files fit together, a variant that fails stops nothing, tables,
figures and page are written, and what the page says follows the numbers: the same sentences with
two runs exchanged name the other run.
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
from studies import bar_table, judge, observe, statements, tables  # noqa: E402
from studies.definition import Mistake, Study  # noqa: E402

try:
    from studies import comparison
except ImportError as error:
    comparison, missing = None, str(error)

STUDIES = check_history.PARAMETERS / "studies"
STEP, APPROACH = 0.01, 2.0
#: What a picture of the committed page may have.
LARGEST_PICTURE = 80_000


def write_run(folder, force, energy, depth, velocity):
    """A made-up run: its history and its probe, which touches while there is force."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "history.csv", "w", encoding="utf-8") as file:
        file.write(
            "step,time,step_size,contact_force,total_energy,total_energy_modified,"
            "kinetic_energy_modified,elastic_energy,max_penetration,wall_time\n"
        )
        for n, (f, e, d) in enumerate(zip(force, energy, depth)):
            file.write(f"{n},{n * STEP},{STEP},{f},{e},{e},{e},0,{d},0\n")
    with open(folder / "probe_p.csv", "w", encoding="utf-8") as file:
        file.write("time,gap,normal_displacement,normal_velocity,pressure,normal_force\n")
        for n, (f, v, d) in enumerate(zip(force, velocity, depth)):
            file.write(f"{n * STEP},{-d},{d},{v},{f},{f}\n")
    return observe.Result(folder)


def good_and_bad(folder):
    """A smooth run that loses energy, and one that zigzags, gains energy and penetrates; both touch
    from row 1 to 19."""
    hump = [math.sin(math.pi * n / 20) if 0 < n < 20 else 0.0 for n in range(25)]
    rest = [APPROACH] + [0.0] * 19 + [-1.0] * 5
    good = write_run(
        folder / "good", hump, [1.0 - 1e-3 * (n > 5) for n in range(25)], [0.0] * 25, rest
    )
    alternating = [APPROACH] + [APPROACH * (-1) ** n for n in range(19)] + [-5.0, 3.0] * 2 + [-5.0]
    bad = write_run(
        folder / "bad",
        [f * (1 + 0.8 * (-1) ** n) for n, f in enumerate(hump)],
        [1.0 + 1e-2 * (n > 15) for n in range(25)],
        [0.5 * STEP * APPROACH * (n > 3) for n in range(25)],
        alternating,
    )
    return good, bad


def scene_of(**results):
    """What statements need of a scene."""
    return types.SimpleNamespace(
        variants=[types.SimpleNamespace(name=name) for name in results],
        numbers=[
            {name: observation(result) for name, observation in observe.OBSERVATIONS.items()}
            for result in results.values()
        ],
    )


class Measures(unittest.TestCase):
    def test_zigzag(self):
        self.assertAlmostEqual(
            observe.zigzag([0.0, 1.0] * 10), 18 / 19
        )  # all of the 19 changes but the last are taken back
        self.assertLess(observe.zigzag([math.sin(math.pi * n / 30) for n in range(31)]), 0.01)
        self.assertEqual(observe.zigzag([1.0, 2.0, 4.0]), 0.0)
        self.assertEqual(observe.zigzag([3.0]), 0.0)

    def test_verdicts(self):
        for paper, here, verdict in (
            ("3.5", "4", "agrees"),
            ("3.5", "7", "ratio 2"),
            ("-9", "2", "differs in sign"),
            ("-9", "0", "none here"),
            ("0", "0", "agrees"),
            ("0", "0.01", "differs"),
            ("yes", "no", "differs"),
            ("smooth", "smooth", "agrees"),
            ("-18 to 22", "-16 to 21", "agrees"),
            ("2 to 5", "1 to 7", "ratio 2"),
            ("5", "-", "-"),
        ):
            self.assertEqual(judge.verdict(paper, here), verdict, (paper, here))

    def test_deviation_from_a_rounded_reference(self):
        for reference, here, good in (
            ("-0.51", -0.5066, True),
            ("-0.51", -0.55, False),
            ("0.001", 0.0005, True),
            ("0.001", 0.002, False),
            ("0", 1e-3, True),
            ("0.000", 1e-3, False),
            ("1e4", 1.02e4, True),
            ("1", math.nan, False),
        ):
            self.assertEqual(bar_table.deviation(reference, here)[1], good, (reference, here))


class Statements(unittest.TestCase):
    def setUp(self):
        self.good, self.bad = good_and_bad(
            pathlib.Path(check_history.settings["folder"]) / "made-up"
        )

    def expect(self, scene, smooth, rough):
        said = statements.by_figure(scene)
        self.assertIn(f"Smooth force: {smooth}.", said["force"])
        self.assertTrue(said["force"][0].startswith(f"Oscillating force: {rough} ("), said["force"])
        self.assertIn(
            f"Never above the initial energy (change at the end in %): {smooth} (-0.1).",
            said["energy"],
        )
        self.assertIn(
            f"At some time above the initial energy (at most, in %): {rough} (+1).", said["energy"]
        )
        self.assertEqual(
            said["displacement"],
            [
                f"Penetrates (depth in steps of approach): {rough} (0.5).",
                f"Does not penetrate: {smooth}.",
            ],
        )
        self.assertIn(f"At rest in contact: {smooth}.", said["velocity"])
        self.assertTrue(said["velocity"][0].endswith(f": {rough} (1)."), said["velocity"])
        self.assertIn(
            f"Widest range after release: {rough}, -3 to 5; narrowest: {smooth}, 1 to 1.",
            said["velocity"],
        )
        self.assertTrue(
            statements.summary([scene])[-1].endswith(f": {smooth} (0.1)."),
            statements.summary([scene])[-1],
        )

    def test_they_follow_the_data(self):
        self.expect(scene_of(first=self.good, second=self.bad), smooth="first", rough="second")
        self.expect(scene_of(first=self.bad, second=self.good), smooth="second", rough="first")

    def test_a_failed_run_is_not_judged(self):
        scene = scene_of(good=self.good, lost=observe.Result(self.bad.folder, "broken"))
        self.assertNotIn(
            "lost", str(statements.by_figure(scene)) + str(statements.summary([scene]))
        )

    def test_two_scenes_differ(self):
        one, other = scene_of(a=self.good, b=self.bad), scene_of(a=self.good, b=self.good)
        self.assertIn(
            "Smooth force in all 2 scenes: a. Oscillating in all: none.",
            statements.summary([one, other]),
        )


class Files(unittest.TestCase):
    def test_bar_table_fits_together(self):
        study, rows = Study(STUDIES / "bar_table.ini"), tables.read_rows(STUDIES / "bar_table.csv")
        bar_table.check("bar_table.csv", rows, study)
        self.assertEqual(
            sorted(row["variant"] for row in rows),
            sorted(variant.name for variant in study.variants),
        )
        for column, text in (("variant", "nobody"), ("energy_change", "a lot")):
            self.assertRaises(
                Mistake, bar_table.check, "bar_table.csv", [{**rows[0], column: text}], study
            )

    def test_variants_need_different_folders(self):
        file = pathlib.Path(check_history.settings["folder"]) / "twins.ini"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(
            f"[study]\nscene = {check_history.PARAMETERS / 'bar_2d.prm'}\n[variant a b]\n[variant"
            " a-b]\n",
            encoding="utf-8",
        )
        self.assertRaisesRegex(Mistake, "folder of their own", Study, file)
        file.write_text(
            f"[study]\nscene = {check_history.PARAMETERS / 'bar_2d.prm'}\n[variant a b]\n",
            encoding="utf-8",
        )
        self.assertRaisesRegex(Mistake, r"needs a section \[coarse\]", Study, file, coarse=True)


@unittest.skipUnless(comparison, "python3 lacks matplotlib or meshio")
class Comparison(check_history.SceneTest):
    def test_krause_walloth_fits_together(self):
        variants = [
            variant
            for name in comparison.SCENES
            for coarse in (False, True)
            for variant in Study(STUDIES / f"{name}.ini", coarse).variants
        ]
        rows = tables.read_rows(STUDIES / comparison.PAPER)
        comparison.check_paper("paper.csv", rows, variants)
        for column in ("variant", "quantity"):
            self.assertRaises(
                Mistake,
                comparison.check_paper,
                "paper.csv",
                [{**rows[0], column: "nothing"}],
                variants,
            )

    def write_study(self, folder):
        """A coarse ball with three schemes, one unknown; the paper's number is wrong on purpose."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        (folder / "tiny.ini").write_text(
            f"""
[study]
scene = {check_history.PARAMETERS / "geometry_a.prm"}
title = Tiny
geometry = A
pressure at = 0.2
observe = energy_change, force_roughness
[scene]
Bodies/ball/Refinements = 2
Time/End time = 0.4
Output/VTU every = 40
[variant classical]
group = a
Time/Scheme = newmark
[variant nonsense]
group = b
Time/Scheme = nonsense
[variant stabilized]
group = a
Time/Scheme = contact-stabilized
""",
            encoding="utf-8",
        )
        (folder / "paper.csv").write_text(
            "section,geometry,variant,quantity,paper\n"
            "1,A,stabilized,energy_grows,no\n"
            "1,A,stabilized,penetrates,yes\n"
            "1,A,nonsense,penetrates,yes\n"
            "1,A,classical,energy_most,1e-3\n",
            encoding="utf-8",
        )

    def compare(self, folder, **options):
        return comparison.compare(
            check_history.settings["executable"],
            [folder / "tiny.ini"],
            folder / "paper.csv",
            folder / "results",
            **options,
        )

    def test_a_failing_variant_does_not_stop_the_others(self):
        folder = pathlib.Path(check_history.settings["folder"]) / "tiny"
        self.write_study(folder)
        self.assertFalse(self.compare(folder))
        with open(folder / "results" / "tiny.csv", newline="", encoding="utf-8") as file:
            rows = {row["variant"]: row for row in csv.DictReader(file)}
        self.assertEqual(rows["nonsense"]["energy at the end, %"], "nan")
        self.assertLess(float(rows["stabilized"]["energy at the end, %"]), 0.0)
        self.assertGreater(
            float(rows["classical"]["roughness of the force"]),
            float(rows["stabilized"]["roughness of the force"]),
        )
        page = (folder / "results" / "page.md").read_text(encoding="utf-8")
        self.assertRegex(page, r"Some runs failed[^#]*Tiny, nonsense: `.*nonsense")
        self.assertNotIn(str(check_history.SOURCE), page)
        self.assertEqual(  # the committed page is checked like other documents
            [line for line in page.splitlines() if len(line) > 100 and not line.startswith("| ")],
            [],
        )
        with open(folder / "results" / "paper_A.csv", newline="", encoding="utf-8") as file:
            beside = [row[-2:] for row in csv.reader(file)][1:]
        self.assertEqual(beside[:3], [["no", "agrees"], ["no", "differs"], ["-", "-"]])
        history = observe.Result(folder / "results" / "tiny" / "classical").history
        gains = [
            time
            for time, energy in zip(history["time"], history["total_energy"])
            if energy > (1 + 1e-5) * history["total_energy"][0]
        ]
        self.assertEqual(
            beside[3][1].partition(", ")[2], f"passes the paper's at t = {gains[0]:.3g}"
        )
        pictures = sorted(path.name for path in (folder / "results").glob("*.png"))
        self.assertEqual(
            pictures,
            [
                f"tiny_{name}.png"
                for name in (
                    "displacement",
                    "energy",
                    "force",
                    "pressure",
                    "pressure_from_above",
                    "velocity",
                )
            ],
        )
        comparison.copy_page(folder / "results", folder / "doc" / "copy.md")
        copy = (folder / "doc" / "copy.md").read_text(encoding="utf-8")
        for picture in pictures:
            self.assertIn(f"](pictures/{picture})", copy)
            self.assertLess((folder / "doc" / "pictures" / picture).stat().st_size, LARGEST_PICTURE)

    def test_no_result_is_older_than_its_run(self):
        """A run that fails now does not show what an earlier one left, nor the other way round;
        without runs, everything is as it was."""
        folder = pathlib.Path(check_history.settings["folder"]) / "again"
        self.write_study(folder)
        self.compare(folder)
        first = [
            (folder / "results" / name).read_text(encoding="utf-8")
            for name in ("tiny.csv", "page.md")
        ]
        self.compare(folder, draw_only=True)
        self.assertEqual(
            [
                (folder / "results" / name).read_text(encoding="utf-8")
                for name in ("tiny.csv", "page.md")
            ],
            first,
        )
        text = (folder / "tiny.ini").read_text(encoding="utf-8")
        (folder / "tiny.ini").write_text(text.replace("= newmark", "= newmork"), encoding="utf-8")
        self.compare(folder)
        self.assertIn(
            "\nclassical,nan", (folder / "results" / "tiny.csv").read_text(encoding="utf-8")
        )
        (folder / "tiny.ini").write_text(text.replace("= nonsense", "= newmark"), encoding="utf-8")
        self.compare(folder)
        self.assertTrue(self.compare(folder, draw_only=True))


if __name__ == "__main__":
    check_history.main()
