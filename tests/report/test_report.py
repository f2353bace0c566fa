# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What a report says: the laws are kept in runs of the program, and each of them is found broken in
a copy whose table was changed by hand, so the verdicts come from the numbers and not from the log.
Runs that were killed, have no fields, change their mesh or had two processes get a page, too.

test_report.py EXECUTABLE FOLDER
"""

import json
import re
import subprocess
import sys
import unittest

import numpy
from small_runs import SOURCE, Runs, change_column

from plotting import curves  # noqa: E402  (small_runs knows where)
from reporting import charts, citation, log
from reporting.laws import judge_laws
from reporting.page import make_page
from reporting.resolution import judge_resolution
from reporting.run import Run
from reporting.schemes import COMPARISON, SCHEMES
from reporting.view import View

EXECUTABLE, FOLDER = sys.argv[1:3]
RUNS = Runs(EXECUTABLE, FOLDER)
#: The balance of momentum is judged by the table, not by what forces.csv says about it, too.
WITHOUT_FORCES = "Output/Forces=false"


def states(folder):
    """The verdicts by name."""
    run = Run(folder)
    return {verdict.name: verdict.state for verdict in judge_laws(run) + judge_resolution(run)}


class Laws(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = RUNS.run("implicit", WITHOUT_FORCES)

    def expect_only(self, broken, folder):
        found = {name for name, state in states(folder).items() if state == "broken"}
        self.assertEqual(found, {broken})

    def spoil(self, table, column, change):
        folder = RUNS.copy(self.folder, "spoilt")
        change_column(folder / table, column, change)
        return folder

    def test_a_good_run_keeps_all_laws(self):
        laws = {verdict.name: verdict.state for verdict in judge_laws(Run(self.folder))}
        self.assertEqual(set(laws.values()), {"kept"}, laws)
        self.assertEqual(len(laws), 7)

    def test_energy_without_an_explanation(self):
        spoilt = self.spoil("history.csv", "energy_residual", lambda n, v: v + 1e-3 * (n == 5))
        self.expect_only("energy balance", spoilt)
        spoilt = self.spoil("history.csv", "total_energy_modified", lambda n, v: v + 1e-3 * (n > 5))
        self.expect_only("energy balance", spoilt)

    def test_energy_from_contact(self):
        spoilt = self.spoil("history.csv", "work_contact", lambda n, v: v + 1e-3 * (n == 5))
        # What the works bring has to be in the energy, or the balance is broken, too.
        change_column(
            spoilt / "history.csv", "total_energy_modified", lambda n, v: v + 1e-3 * (n >= 5)
        )
        self.expect_only("energy gained", spoilt)

    def test_momentum_penetration_complementarity_and_numbers(self):
        for law, table, column, change in (
            ("momentum", "history.csv", "momentum_y", lambda n, v: v * (1 + 1e-3 * (n == 5))),
            ("penetration", "history.csv", "max_penetration", lambda n, v: 1e-4 * (n == 5)),
            ("complementarity", "probe_south_pole.csv", "normal_force", lambda n, v: v - 0.1),
            ("complementarity", "probe_south_pole.csv", "gap", lambda n, v: v + 1e-3),
            ("numbers", "pairs.csv", "pair_0_force_x", lambda n, v: float("inf")),
        ):
            with self.subTest(law=law, column=column):
                self.expect_only(law, self.spoil(table, column, change))

    def test_momentum_of_each_body(self):
        folder = RUNS.run("disc", "Output/Forces=true")
        self.assertEqual(states(folder)["momentum"], "kept")
        change_column(
            folder / "forces.csv", "force_disc_multiplier_y", lambda n, v: v * (1 + 1e-3 * (n > 9))
        )
        self.expect_only("momentum", folder)

    def test_the_guard_is_heard(self):
        folder = RUNS.copy(self.folder, "spoilt")
        text = (folder / "log.txt").read_text(encoding="utf-8")
        warning = "  warning: at time 1 a law is broken that `Time/Scheme = newmark` keeps\n"
        (folder / "log.txt").write_text(text.replace("step 1 ", warning + "step 1 "), "utf-8")
        self.expect_only("guard", folder)
        (folder / "log.txt").write_text(
            text + "\nThe run ended early, at the time 1: a law is broken\n", "utf-8"
        )
        found = states(folder)
        self.assertEqual((found["guard"], found["end of the run"]), ("broken", "broken"))

    def test_what_a_scheme_does_not_promise_is_not_judged(self):
        found = states(RUNS.run("newmark"))
        self.assertIn(found["energy gained"], ("not judged", "look"))  # which is told, not blamed
        self.assertEqual(found["momentum"], "not judged")
        self.assertEqual(found["energy balance"], "kept")

    def test_resolution(self):
        spoilt = self.spoil("history.csv", "active_nodes", lambda n, v: float(n == 5))
        found = states(spoilt)
        self.assertEqual((found["nodes in contact"], found["steps in contact"]), ("look", "look"))

    def test_schemes_are_those_of_the_program(self):
        answer = subprocess.run(
            [EXECUTABLE, "--print-schemes=json"], capture_output=True, text=True, check=True
        )
        program = {scheme["name"]: scheme for scheme in json.loads(answer.stdout)}
        self.assertEqual(set(program), set(SCHEMES))
        for name, scheme in SCHEMES.items():
            for promise in ("energy", "penetrates", "predictor", "inertia", "moving_contact"):
                self.assertEqual(getattr(scheme, promise), program[name][promise], (name, promise))
            for key in (*scheme.sources, COMPARISON):
                self.assertIn(key, citation.reference(key))

    def test_balances_with_one_force_are_those_of_the_documentation(self):
        text = (SOURCE / "doc" / "output.md").read_text(encoding="utf-8")
        row = re.search(r"^\| (.*) \| P_1 - P_0 = tau Q_1, F the mean", text, re.MULTILINE)[1]
        with_one = {name for name, scheme in SCHEMES.items() if scheme.one_force}
        self.assertEqual(with_one, {*re.findall(r"`([\w-]+)`", row), "backward-euler"})


class Pages(unittest.TestCase):
    def view(self, folder, megabytes=30.0):
        return View(Run(folder), megabytes * 1e6)

    def page(self, folder):
        """The page with a view if there are fields, without the pictures, which take seconds."""
        run = Run(folder)
        view = self.view(folder) if (folder / "volume.pvd").exists() else None
        return make_page(run, view, "no fields", [])

    def test_the_command_writes_a_page_that_needs_nothing_else(self):
        folder = RUNS.run("two_bodies", "Output/Bodies=true", processes=2)
        command = [sys.executable, "-B", SOURCE / "tools" / "report.py", folder]
        answer = subprocess.run(command, capture_output=True, text=True, check=True)
        self.assertEqual(answer.stderr, "")
        page = (folder / "report.html").read_text(encoding="utf-8")
        self.assertIn("Content-Security-Policy", page)
        self.assertEqual(re.findall(r"(?:src|href)=\"(?!data:image/png|#)[^\"]*", page), [])
        for part in ("Bodies", "Pairs", "set End time", "krause", "step: inequality", "@misc"):
            self.assertIn(part, page)
        self.assertGreaterEqual(page.count("data:image/png"), 4)

    def test_two_processes_show_what_one_shows(self):
        both = [self.view(RUNS.run("two_bodies", processes=n)).data() for n in (1, 2)]
        for data in both:
            self.assertEqual(len(data["meshes"]), 1)
        sizes = [len(data["meshes"][0]["faces"]) for data in both]
        self.assertEqual(sizes[0], sizes[1])

    def test_meshes_and_obstacles_that_change(self):
        data = self.view(RUNS.run("adaptive")).data()
        self.assertGreater(len(data["meshes"]), 1)
        data = self.view(RUNS.run("roller")).data()
        obstacles = [moment["obstacle"] for moment in data["moments"]]
        self.assertEqual(len(set(obstacles)), len(obstacles))
        self.assertNotIn(None, obstacles)

    def test_a_large_run_is_thinned(self):
        folder = RUNS.run("ball")
        whole, small = self.view(folder), self.view(folder, 0.02)
        self.assertEqual(whole.notes, [])
        self.assertIn(f"of the {len(whole.moments)} moments", small.notes[-1])
        self.assertLess(len(json.dumps(small.data()["moments"])), 0.025e6)
        # Never so much that nothing is left.
        self.assertGreaterEqual(len(self.view(folder, 1e-4).moments), 2)

    def test_a_killed_run(self):
        folder = RUNS.copy(RUNS.run("disc"), "killed")
        history = (folder / "history.csv").read_text(encoding="utf-8")
        (folder / "history.csv").write_text(history[: len(history) // 2], "utf-8")
        text = (folder / "log.txt").read_text(encoding="utf-8")
        (folder / "log.txt").write_text(text[: text.index("  energy ")], "utf-8")
        last = sorted((folder / "fields").glob("volume_*.vtu"))[-1]
        last.write_bytes(last.read_bytes()[:1000])
        self.assertEqual(states(folder)["end of the run"], "look")
        self.assertNotIn("broken", states(folder).values())
        page = self.page(folder)
        self.assertIn("is not a whole .vtu file", page)
        self.assertIn("the run was killed, or goes on", page)

    def test_a_run_that_was_stopped_and_goes_on(self):
        folder, go_on, end = RUNS.interrupted("disc", further_steps=20)
        self.assertEqual(states(folder)["end of the run"], "look")
        for _ in range(2):  # the second time there is nothing to do
            subprocess.run(go_on, check=True, capture_output=True, timeout=300)
            found = states(folder)
            self.assertEqual(found["end of the run"], "kept")
            self.assertNotIn("broken", found.values())
        self.assertIn(f"Finished at the time {end:.6g}", self.page(folder))

    def test_static_runs_and_runs_without_fields(self):
        self.assertIn('id="view-canvas"', self.page(RUNS.run("static")))
        page = self.page(RUNS.run("implicit", fields=False))
        self.assertNotIn('id="view-canvas"', page)
        self.assertIn("Output/VTU = true", page)

    def test_a_folder_that_holds_nothing(self):
        empty = RUNS.folder / "empty"
        empty.mkdir(parents=True, exist_ok=True)
        for folder, message in ((empty, "has no table"), (empty / "none", "is not a directory")):
            answer = subprocess.run(
                [sys.executable, "-B", SOURCE / "tools" / "report.py", folder],
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual(answer.returncode, 1)
            self.assertIn(message, answer.stderr)
            self.assertNotIn("Traceback", answer.stderr)

    def test_every_column_is_in_a_chart(self):
        """Or named beside one as zero."""
        run = Run(RUNS.run("disc", "Output/Bodies=true"))
        for (title, found), table in zip(charts.sections(run), run.tables):
            labels = {label for chart in found for label in [*chart.curves, *chart.zero]}
            self.assertTrue(labels, (title, table))
        history = {
            label for chart in charts.sections(run)[0][1] for label in [*chart.curves, *chart.zero]
        }
        unseen = {name for name in run.history if run.history[name].any()} - history
        self.assertLessEqual(
            unseen,
            {*charts.NO_CURVES, *(name for name in run.history if name.endswith("_modified"))},
        )

    def test_long_tables_keep_their_peaks(self):
        values = numpy.zeros(100_000)
        values[54_321] = 1.0
        chart = charts.Chart("peak", numpy.arange(1e5), {"force": values})
        rows = chart.data()["rows"]
        self.assertLessEqual(len(rows), charts.MOST_ROWS + 2)
        self.assertIn([54_321.0, 1.0], rows)

    def test_a_warning_is_told_once_with_its_largest_value(self):
        found = log.parse_log(
            "signorini 1, commit abc\n\nstep 1  time 1\n"
            "  warning: at time 0.1 the body 'a' is 6 % strained at one place. Less load.\n"
            "  energy            changed by 1 %\n"
            "  warning: since time 0.1 the body 'a' is 9 % strained at one place"
            " (the most of the run). Less load.\n"
        )
        self.assertEqual(len(found.warnings), 1)
        self.assertIn("9 %", found.warnings[0])

    def test_warnings_of_two_bodies_are_two(self):
        deep = "  warning: at time 0.1 the body '{}' is 6 % of its size deep in 'f'. Add a pair.\n"
        strained = "{} time 0.{} the body '{}' is {} % strained at one place"
        found = log.parse_log(
            "signorini 1, commit abc\n\nstep 1  time 1\n"
            + deep.format("disc1")
            + deep.format("disc2")
            + "".join(f"  warning: {strained.format('at', n, f'disc{n}', 6)}.\n" for n in (1, 2))
            + "  energy            changed by 1 %\n  warning: "
            + ", ".join(strained.format("since", n, f"disc{n}", 7 + n) for n in (1, 2))
            + " (the most of the run). Less load.\n"
        )
        self.assertEqual(len(found.warnings), 3)
        for number, words in enumerate(("'disc1' is 6 % of", "'disc2' is 6 % of", "9 % strained")):
            self.assertIn(words, found.warnings[number])

    def test_what_has_hardly_touched_breaks_no_law(self):
        """Forces of round-off are no measure for the momentum of a body that flies."""
        folder = RUNS.run("disc", "Output/Forces=true", "Obstacles/floor/Point=0, -10")
        for column, value in (("multiplier", 1e-13), ("momentum", 2e-13)):
            change_column(
                folder / "forces.csv", f"force_disc_{column}_y", lambda n, v: value * (n == 5)
            )
        change_column(folder / "history.csv", "contact_force", lambda n, v: 1e-13 * (n == 5))
        self.assertNotEqual(states(folder)["momentum"], "broken")

    def test_energies_of_a_slow_start_are_parts_of_the_largest(self):
        """Beside the potential energy of a fall the first motion is nothing."""
        scale, name = curves.energy_scale(numpy.array([1e-6, 1e-6]), numpy.array([0.0, 2.0]))
        self.assertEqual((scale, name), (2.0, "largest energy of the run"))
        scale, name = curves.energy_scale(numpy.array([1.0, 0.9]), numpy.array([0.0, 2.0]))
        self.assertEqual((scale, name), (1.0, "initial total energy"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
