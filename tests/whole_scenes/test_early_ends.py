# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs that meet what cannot be solved, and runs that are told to end. A step that fails is made in
parts, and the times of the others stay what they are; where nothing helps, or at Ctrl-C, the run
ends with one message, a status that says why, the fields of the last state and whole tables. Both
happen alike on one and two processes."""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

import check_history

BAR = check_history.scene_file("bar_2d")
#: The fixed point of this scheme for the jumps of velocities does not converge in long steps.
LONG_STEPS = ("Time/Scheme=nonsmooth-generalized-alpha", "Time/Step size=0.2")
#: So rough that a step cannot be solved; with a direct factor it could.
HOPELESS = (*LONG_STEPS, "Solver/Tolerance=1e-2", "Solver/Condensation=never")


#: A block on changing cells is pulled until its load has no value any more.
PULLED = """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = 0.3
end
subsection Bodies
  set Names = block
  subsection block
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = 2, 1
    set Refinements     = 1
    set Young's modulus = 500
    set Poisson's ratio = 0.3
    set Density         = 1
    set Dirichlet       = 2: 0; 0
    set Body force      = sqrt(0.1525-t); -30
  end
end
subsection Adaptivity
  set Indicator        = residual
  set Refine fraction  = 0.7
  set Coarsen fraction = 0.1
  set Coarsen ratio    = 1
  set Maximum level    = 4
  set Hysteresis       = 0
end
subsection Output
  set VTU = false
end
"""


#: A box falls without turning, which is easily computed, and in its sixth step meets the floor at a
#: Courant number of 10 000: half a minute with a preconditioner that is none.
HARD_IMPACT = check_history.box_on_floor(
    0.3,
    ("Step size = 0.02", "End time = 0.14"),
    (
        "Lower corner = 0, 0, 0.11",
        "Upper corner = 1, 1, 1.11",
        "Refinements = 4",
        "Young's modulus = 1e9",
        "Poisson's ratio = 0.3",
        "Density = 1",
        "Initial velocity = 0.5; 0; -1",
    ),
)


class EarlyEnd:
    """A run that does not go to its end."""

    def __init__(self, scene, name, overrides=(), processes=1, end_by=None, delay=0.0):
        """end_by: what happens when the run has made some steps, and some seconds later: a signal,
        sent to the last process, or a function, called with the folder."""
        self.folder = pathlib.Path(check_history.settings["folder"]) / name / "output"
        if isinstance(scene, str):
            self.folder.mkdir(parents=True, exist_ok=True)
            (self.folder.parent / "written.prm").write_text(scene, encoding="utf-8")
            scene = self.folder.parent / "written.prm"
        overrides = (f"Output directory={self.folder}", *overrides)
        for old in self.folder.glob("history.csv"):
            old.unlink()
        with subprocess.Popen(
            check_history.command(scene, overrides, processes),
            env=check_history.environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as process:
            if end_by is not None:
                self.wait_for_steps(process)
                time.sleep(delay)
            if callable(end_by):
                end_by(self.folder)
            elif end_by is not None:
                pid = process.pid
                os.kill(check_history.last_process(pid) if processes > 1 else pid, end_by)
            _, self.errors = process.communicate(timeout=check_history.TIMEOUT)
        self.status = process.returncode
        self.message = [line for line in self.errors.splitlines() if line.startswith("signorini: ")]
        self.message = [line for line in self.message if "warning" not in line]
        self.history = check_history.read_table(self.folder / "history.csv")
        self.log = (self.folder / "log.txt").read_text(encoding="utf-8")

    def wait_for_steps(self, process):
        """Until some rows are there."""
        table = self.folder / "history.csv"
        for _ in range(6000):
            if process.poll() is not None:
                raise AssertionError("the run ended by itself: " + process.stderr.read())
            if table.exists() and table.read_text(encoding="utf-8").count("\n") > 5:
                return
            time.sleep(0.01)
        raise AssertionError("the run does not begin")

    def last_fields(self):
        """The time of the last fields, and whether they are there."""
        line = (self.folder / "volume.pvd").read_text(encoding="utf-8").split("<DataSet ")[-1]
        file = line.split('file="')[1].split('"')[0]
        return float(line.split('timestep="')[1].split('"')[0]), (self.folder / file).exists()


class EarlyEnds(check_history.SceneTest):
    def test_long_steps_are_made_in_parts(self):
        runs = [
            check_history.Run(BAR, f"parts_{processes}", LONG_STEPS, processes)
            for processes in (1, 2)
        ]
        run = runs[0]
        self.expect_ledger_closes(run)
        rejected = run["rejected_steps"]
        self.assertGreater(sum(rejected), 0)
        self.assertIn(f"rejected          {sum(rejected):.0f} attempts", run.log)
        for whole in range(1, 11):
            self.assertLess(min(abs(t - 0.2 * whole) for t in run["time"]), 1e-12, whole)
        for row in range(1, len(run)):
            self.assertEqual(run["step"][row], row)
            size = run["time"][row] - run["time"][row - 1]
            self.assertAlmostEqual(run["step_size"][row], size, delta=1e-12)
            if rejected[row]:
                self.assertAlmostEqual(size, 0.2 / 2 ** rejected[row], delta=1e-12)
        self.assertEqual(run["time"], runs[1]["time"])
        self.assertEqual(rejected, runs[1]["rejected_steps"])

    def test_what_cannot_be_solved_ends_the_run_with_its_last_state(self):
        for processes in (1, 2):
            run = EarlyEnd(BAR, f"hopeless_{processes}", HOPELESS, processes)
            self.assertEqual(run.status, 1, run.errors)
            self.assertEqual(len(run.message), 1, run.errors)
            end = run.history["time"][-1]
            self.assertIn(f"no step from the time {end:.6g} was possible", run.message[0])
            self.assertIn("were not found to nine digits. Choose", run.message[0])
            self.assertIn(run.message[0][len("signorini: ") :], run.log)
            self.assertIn("energy            changed by", run.log)
            last, exists = run.last_fields()
            self.assertAlmostEqual(last, end, delta=1e-5)
            self.assertTrue(exists)

    def test_the_last_step_has_a_row_whether_it_was_due_or_not(self):
        """The run ends at the same step however many rows it writes; what adds up is whole."""
        every = EarlyEnd(BAR, "every", HOPELESS, 1).history
        some = EarlyEnd(BAR, "some", (*HOPELESS, "Output/History every=1000"), 1).history
        self.assertGreater(len(every["time"]), 3)
        self.assertEqual(len(some["time"]), 2)
        for column in ("time", "total_energy", "contact_force", "momentum_x"):
            self.assertEqual(some[column][-1], every[column][-1], column)
        for column in ("work_contact", "work_external", "linear_iterations", "rejected_steps"):
            total = sum(every[column])
            self.assertAlmostEqual(some[column][-1], total, delta=1e-12 * abs(total), msg=column)

    def test_the_last_step_is_that_of_its_own_mesh(self):
        """The mesh changes after the last step that was possible; its reactions and cells are those
        of the mesh on which it was made."""
        rows = []
        for every in (1, 1000):
            run = EarlyEnd(PULLED, f"mesh_{every}", [f"Output/History every={every}"])
            self.assertIn("is not a finite number", run.message[0])
            supports = check_history.read_table(run.folder / "supports.csv")
            rows.append(
                [column[-1] for name, column in supports.items()]
                + [run.history[name][-1] for name in ("time", "cells", "total_energy")]
            )
        self.assertEqual(*rows)

    def test_signals_end_a_run_after_its_step(self):
        for kind, processes in (
            (signal.SIGINT, 1),
            (signal.SIGTERM, 1),
            (signal.SIGINT, 2),
        ):
            with self.subTest(signal=kind.name, processes=processes):
                run = EarlyEnd(
                    BAR,
                    f"{kind.name}_{processes}",
                    ["Time/Step size=1e-6", "Output/VTU states=1"],
                    processes,
                    kind,
                )
                self.assertEqual(run.status, 128 + kind, run.errors)
                self.assertEqual(len(run.message), 1, run.errors)
                end = run.history["time"][-1]
                self.assertIn(f"interrupted by {kind.name} at the time {end:.6g}.", run.message[0])
                self.assertIn("interrupted", run.log)
                self.assertLess(end, 0.5)
                last, exists = run.last_fields()
                self.assertAlmostEqual(last, end, delta=1e-5 * end)
                self.assertTrue(exists)

    def test_a_step_that_takes_long_is_left(self):
        """The run ends with the state before it, and goes on from there with what is better."""
        whole = check_history.Run(HARD_IMPACT, "hard_impact")
        for processes in (1, 2):
            with self.subTest(processes=processes):
                run = EarlyEnd(
                    HARD_IMPACT,
                    f"left_{processes}",
                    ["Solver/Preconditioner=jacobi", "Output/VTU=false"],
                    processes,
                    signal.SIGTERM,
                    delay=1.0,
                )
                self.assertEqual(run.status, 128 + signal.SIGTERM, run.errors)
                self.assertEqual(len(run.message), 1, run.errors)
                self.assertIn(
                    "at the time 0.1. The next step takes long and was left. To go on: ",
                    run.message[0],
                )
                self.assertEqual(len(run.history["time"]), 6)
                subprocess.run(
                    check_history.command(
                        run.folder.parent / "written.prm",
                        [f"Output directory={run.folder}", "Output/VTU=false"],
                        processes,
                        ["--resume"],
                    ),
                    env=check_history.environment(),
                    check=True,
                    capture_output=True,
                )
                resumed = check_history.read_table(run.folder / "history.csv")
                self.assertEqual(resumed["step"], whole["step"])
                for column in ("contact_force", "kinetic_energy", "momentum_x"):
                    largest = max(map(abs, whole[column]))
                    for value, expected in zip(resumed[column], whole[column]):
                        self.assertAlmostEqual(value, expected, delta=1e-8 * largest, msg=column)

    def test_a_lost_folder_of_fields_ends_a_run(self):
        """A file lies where the folder was: what cannot be written, in the background or not, is
        named, and the series names what was written before and nothing else."""

        def lose(folder):
            os.rename(folder / "fields", folder / "fields_away")
            (folder / "fields").write_text("a file", encoding="utf-8")

        for processes in (1, 2):
            with self.subTest(processes=processes):
                name = f"lost_{processes}"
                folder = pathlib.Path(check_history.settings["folder"]) / name / "output"
                for old in ("fields", "fields_away"):
                    if (folder / old).is_file():
                        (folder / old).unlink()
                    shutil.rmtree(folder / old, ignore_errors=True)
                run = EarlyEnd(
                    BAR,
                    name,
                    ["Time/Step size=1e-6", "Output/VTU every=1"],
                    processes,
                    lose,
                )
                self.assertEqual(run.status, 1, run.errors)
                self.assertEqual(len(run.message), 1, run.errors)
                self.assertIn(f"cannot write `{run.folder}/fields/", run.message[0])
                # The second one between the two steps of lose().
                self.assertRegex(run.message[0], "Not a directory|No such file or directory")
                self.assertIn(run.message[0][len("signorini: ") :], run.log)
                series = (run.folder / "volume.pvd").read_text(encoding="utf-8")
                named = re.findall('file="fields/([^"]*)"', series)
                # With the fifth row the fourth moment may still be in work.
                self.assertGreaterEqual(len(named), 3)
                for record in named:
                    text = (run.folder / "fields_away" / record).read_text(encoding="utf-8")
                    pieces = re.findall('Source="([^"]*)"', text)
                    self.assertEqual(len(pieces), processes)
                    for piece in pieces:
                        content = (run.folder / "fields_away" / piece).read_bytes()
                        self.assertTrue(content.rstrip().endswith(b"</VTKFile>"), piece)

    def test_the_reference_integration_fails_with_its_load(self):
        """An exception in a function that SUNDIALS calls ends the run; none is forgotten."""
        run = EarlyEnd(
            check_history.scene_file("disc_2d"),
            "reference",
            (
                "Time/Scheme=reference",
                "Time/End time=0.1",
                "Bodies/disc/Refinements=1",
                "Bodies/disc/Body force=sqrt(0.033-t); 0",
            ),
        )
        self.assertIn(run.status, (1, 2), run.errors)
        self.assertEqual(len(run.message), 1, run.errors)
        self.assertIn("'sqrt(0.033-t)' is not a finite number", run.message[0])
        self.assertAlmostEqual(run.history["time"][-1], 0.03, delta=1e-12)

    def test_sliding_on_many_cells(self):
        """A block slides as a rigid body although a wave crosses 2200 cells in a step: what the
        solver of friction falls back on meets tolerances that are below round-off, too."""
        for processes in (1, 2):
            run = check_history.Run(
                check_history.scene_file("sliding_block"),
                f"sliding_{processes}",
                ["Bodies/block/Repetitions=128, 64", "Time/End time=0.02"],
                processes,
            )
            # mass 20, velocity 1 - 3 t
            self.expect_close(run["momentum_x"][-1], 20 * (1 - 3 * 0.02), 1e-8, "momentum")
            self.expect_close(run["friction_force"][-1], 0.3 * 200, 1e-8, "friction")
            self.assertEqual(run["slip_nodes"][-1], 129)


if __name__ == "__main__":
    check_history.main()
