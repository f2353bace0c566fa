#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study benchmark: on the first mesh of each case every quantity lies within its reference, the
error bar of that, and the error that is expected of the mesh; with references that are wrong the
same runs fail. Error bars from refinement contain the limit of series that have one, and those of
series that contradict each other contain both. The page says what its table of results says, of
every case, with the references as they are.
"""

import csv
import math
import pathlib
import re
import shutil
import sys
import types
import unittest

import check_history

sys.path.insert(0, str(check_history.SOURCE / "tools"))
from studies import instants  # noqa: E402
from studies.observe import Result  # noqa: E402
from studies.quantities import read_quantities  # noqa: E402

try:
    from studies.benchmark import certificate, page, problem, study
except ImportError as error:
    study, missing = None, str(error)

SOURCE = check_history.SOURCE
#: Beside what an expected error leaves open of a quantity, references are moved by so much of it.
WRONG = 2.1


def setUpModule():
    if not study:
        raise unittest.SkipTest(missing)
    instants.use(check_history.settings["executable"])


def folder_of(name):
    """For the results of this test."""
    return pathlib.Path(check_history.settings["folder"]).resolve() / name


def read(path):
    """Rows of a table."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def copy_of_sources(name):
    """A root with study files that may be changed, and links to the scenes."""
    root = folder_of(name)
    shutil.rmtree(root, ignore_errors=True)
    shutil.copytree(SOURCE / study.STUDIES, root / study.STUDIES)
    for path in SOURCE.glob("parameters/*"):
        if path.name != "studies":
            (root / "parameters" / path.name).symlink_to(path)
    (root / "doc").mkdir()
    for path in (study.PEERS, "doc/benchmarks.md"):
        shutil.copy(SOURCE / path, root / path)
    return root


def problems(folder, coarse=True, certified=None):
    """All cases."""
    known = read(SOURCE / study.CERTIFIED) if certified is None else certified
    paths = sorted((SOURCE / study.STUDIES).glob("*.ini"))
    return [problem.Problem(path, coarse, folder, known) for path in paths]


class Certificates(unittest.TestCase):
    def test_the_limit_is_within_the_error_bar(self):
        for order in (0.6, 1.0, 1.7, 2.0, 2.3, 3.0):
            for error in (0.3, -2e-3):
                for mixed in (0.0, 0.4):
                    sizes = [1.0, 0.5, 0.25]
                    values = [7 + error * (h**order + mixed * h ** (order + 1)) for h in sizes]
                    found = certificate.extrapolate(values)
                    self.assertLessEqual(abs(found.value - 7), found.uncertainty)
                    self.assertLess(found.uncertainty, 1.01 * abs(error) / 0.5)
        found = certificate.extrapolate([7 + h**2 for h in (1.0, 0.5, 0.25)])
        self.assertAlmostEqual(found.value, 7)
        self.assertAlmostEqual(found.order, 2)

    def test_what_does_not_converge_from_one_side_is_not_extrapolated(self):
        for values, bar in (([1.0, 1.2, 1.1], 0.2), ([1.0, 1.1, 1.3], 0.2)):
            found = certificate.extrapolate(values)
            self.assertEqual(found.value, values[-1])
            self.assertAlmostEqual(found.uncertainty, bar)
            self.assertTrue(math.isnan(found.order))
        self.assertLess(certificate.extrapolate([3.0, 3.0, 3.0]).uncertainty, 1e-6)

    def test_series_that_contradict_each_other(self):
        one, other = (certificate.Certificate(value, 0.1, 1.0) for value in (1.0, 1.15))
        self.assertEqual(certificate.combine([one, other]), one)
        other.value = 1.5
        found = certificate.combine([one, other])
        self.assertEqual((found.value, found.uncertainty), (1.0, 0.5))

    def test_digits(self):
        for value, bar, texts in (
            (16.15789, 0.00123, ("16.1579", "0.0013")),
            (2309.4, 31.2, ("2309", "32")),
            (5.23412e-5, 1e-8, ("0.000052341", "0.000000010")),
        ):
            found = certificate.rounded(certificate.Certificate(value, bar, 1.0))
            self.assertEqual(found, texts)
            self.assertLessEqual(bar, float(found[1]))


class Quantities(unittest.TestCase):
    def test_functions_of_columns(self):
        run = Result(folder_of("made") / "run")
        run.folder.mkdir(parents=True, exist_ok=True)
        run.folder.joinpath("history.csv").write_text("time,a\n0,3\n1,1\n3,-3\n4,2\n")
        run.folder.joinpath("probe_p.csv").write_text("time,a\n0,1\n2,0\n3,5\n")
        for text, expected in (
            ("smallest(a)", -3),
            ("total(a)", 3),
            ("zero(a)", 1.5),
            ("zero(p.a)", 2),
            ("largest(p.a) + last(a)", 7),
        ):
            self.assertEqual(read_quantities({"q": text}, "made", None)["q"](run), expected, text)
        self.assertTrue(math.isnan(read_quantities({"q": "zero(time)"}, "made", None)["q"](run)))


class Study(check_history.SceneTest):
    """The first mesh of all cases, run once."""

    @classmethod
    def setUpClass(cls):
        cls.folder = folder_of("coarse")
        shutil.rmtree(cls.folder, ignore_errors=True)
        cls.good = study.benchmark(cls.arguments(cls.folder), SOURCE)
        cls.rows = read(cls.folder / "results.csv")

    @staticmethod
    def arguments(folder, draw_only=False, page_file=None):
        return types.SimpleNamespace(
            executable=check_history.settings["executable"],
            folder=folder,
            coarse=True,
            certify=False,
            draw_only=draw_only,
            page=page_file,
        )

    def test_all_quantities_are_within_their_tolerances(self):
        self.assertTrue(self.good)
        own = [row for row in self.rows if row["code"] == page.OWN]
        expected = {(one.name, name) for one in problems(folder_of("x")) for name in one.references}
        self.assertEqual({(row["case"], row["quantity"]) for row in own}, expected)
        self.assertGreaterEqual(len({row["case"] for row in own}), 12)
        for row in own:
            self.assertEqual(row["verdict"], "within", row)
            for name in ("value", "dofs", "steps", "processor_s", "scheme", "settings", "version"):
                self.assertTrue(row[name], f"{name} of {row}")

    def test_tolerances_can_tell_a_wrong_value(self):
        """They are at most a sixth of the reference, on the first mesh."""
        for one in problems(folder_of("x")):
            for name, known in one.references.items():
                if known.value:
                    part = one.tolerance(name, 0) / abs(known.value)
                    self.assertLess(part, 1 / 6, f"{one.name}: {name}")

    def test_wrong_references_fail(self):
        """Each one, by itself: moved a little more than twice the tolerance, it is out of reach of
        a value that is within it."""
        root = copy_of_sources("wrong")
        certified = read(SOURCE / study.CERTIFIED)
        for one in problems(folder_of("x")):
            path = root / study.STUDIES / f"{one.name}.ini"
            text = path.read_text(encoding="utf-8")
            for name, known in one.references.items():
                moved = known.value + WRONG * one.tolerance(name, 0)
                if known.kind == problem.EXACT:
                    before, section, after = text.partition("[exact]\n")
                    after = re.sub(rf"^{name} = .*$", f"{name} = {moved!r}", after, 1, re.M)
                    text = before + section + after
                for row in certified:
                    if (row["case"], row["quantity"]) == (one.name, name):
                        row["value"] = repr(moved)
            path.write_text(text, encoding="utf-8")
        with open(root / study.CERTIFIED, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, certified[0])
            writer.writeheader()
            writer.writerows(certified)
        folder = folder_of("wrong_results")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.folder, folder)
        self.assertFalse(study.benchmark(self.arguments(folder, draw_only=True), root))
        for row in read(folder / "results.csv"):
            self.assertNotEqual(row["verdict"], "within", row)

    def test_a_run_that_fails_has_rows(self):
        """They say so, and the study fails."""
        folder = folder_of("failed")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.folder, folder)
        (folder / "bar" / "1" / "failure.txt").write_text("too long a day\n", encoding="utf-8")
        self.assertFalse(study.benchmark(self.arguments(folder, draw_only=True), SOURCE))
        rows = [row for row in read(folder / "results.csv") if row["case"] == "bar"]
        self.assertEqual({row["verdict"] for row in rows}, {"FAILED"})
        self.assertIn("| signorini: failed |", (folder / "tables.md").read_text(encoding="utf-8"))

    def test_the_page_is_made_anew(self):
        root = copy_of_sources("page")
        target = root / "doc" / "benchmarks.md"
        study.benchmark(self.arguments(self.folder, draw_only=True, page_file=target), root)
        text = target.read_text(encoding="utf-8")
        self.assertIn(page.parts(self.rows)["ball"], text)
        self.assertEqual(read(root / study.RESULTS), self.rows)
        with self.assertRaisesRegex(study.Mistake, "for ball"):
            page.renew(text.replace("benchmark: ball", "benchmark: wall"), self.rows)


class Page(unittest.TestCase):
    """doc/benchmarks.md, as it is shipped."""

    def test_it_says_what_its_results_say(self):
        rows = read(SOURCE / study.RESULTS)
        text = (SOURCE / "doc" / "benchmarks.md").read_text(encoding="utf-8")
        self.assertEqual(page.renew(text, rows), text)

    def test_results_are_complete_and_belong_to_the_references(self):
        rows = [row for row in read(SOURCE / study.RESULTS) if row["code"] == page.OWN]
        found = {}
        for row in rows:
            found.setdefault((row["case"], row["quantity"]), []).append(row)
        expected = {}
        for one in problems(folder_of("x"), coarse=False):
            for name, known in one.references.items():
                expected[one.name, name] = (known, len(one.tasks))
        self.assertEqual(set(found), set(expected))
        for key, (known, runs) in expected.items():
            self.assertEqual(len(found[key]), runs, key)
            for row in found[key]:
                self.assertEqual(row["verdict"], "within", row)
                error = abs(float(row["reference"]) - known.value)
                self.assertLessEqual(error, 1e-6 * abs(known.value), row)

    def test_a_better_peer_is_named(self):
        """Unless the reference leaves open who is better; on the same mesh, if there is one."""
        mine = {"code": page.OWN, "quantity": "q", "reference": "2", "error": "-0.1", "dofs": "8"}
        mine |= {"scheme": "ours", "processor_s": "3", "uncertainty": "0"}
        theirs = {**mine, "code": "other", "error": "0.01", "scheme": "theirs"}
        finer = {**mine, "dofs": "99", "error": "0.001"}
        said = page.beaten([mine, finer, theirs]).splitlines()[-1]
        run = "8 dofs, 3 s)"
        expected = f"| q | other (theirs, {run}: +0.5 % | signorini (ours, {run}: -5 % |"
        self.assertEqual(said, f"{expected} **the other** |")
        said = page.beaten([mine, {**theirs, "error": "0.2"}])
        self.assertTrue(said.endswith("| signorini |"), said)
        said = page.beaten([{**row, "uncertainty": "0.3"} for row in (mine, theirs)])
        self.assertTrue(said.endswith("| none |"), said)


if __name__ == "__main__":
    check_history.main()
