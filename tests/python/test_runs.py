# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs by the Python package.

The rows that are followed are those of the history, each once and while the run goes on; a run
that fails or is ended raises what the program says, and can be resumed; the rows of a resumed run
are without gap or duplicate. A sweep runs what it must and nothing twice.
"""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

import running
import signorini
from signorini import executable, tables
from signorini.errors import error_of

#: Long enough to be ended before it is done.
LONG = {"Time/End time": 100, "Checkpoint/Every steps": 5}
#: A program of a user who presses Ctrl-C.
SCRIPT = """
import sys
sys.path[:0] = {path!r}
import signorini
try:
    signorini.run({scene!r}, {folder!r}, on_row=lambda row: print(row["step"], flush=True))
except KeyboardInterrupt:
    print("ended by hand", flush=True)
"""


class Runs(unittest.TestCase):
    def test_rows_are_the_history(self):
        """On two processes, too; the second run into a folder does not follow the first one."""
        for processes in (1, 2):
            rows = []
            result = signorini.run(
                running.disc(), running.folder / "run", processes=processes, on_row=rows.append
            )
            self.assertEqual([row["step"] for row in rows], list(range(41)))
            for column in ("time", "total_energy"):
                self.assertEqual([row[column] for row in rows], list(result.history[column]))
            self.assertIn(f"processes         {processes}", result.log)
        self.assertGreater(result.history.contact_force.max(), 0)
        self.assertEqual(result.parameters["Bodies"]["disc"]["Radius"], "1")
        self.assertIn("bodies", result.tables)
        self.assertEqual(len(result.table("bodies")), 41)

    def test_progress_while_it_goes_on_and_resume(self):
        scene = running.disc().changed(LONG)
        with self.assertRaisesRegex(signorini.Interrupted, "interrupted by SIGINT") as raised:
            with signorini.start(scene, running.folder / "resumed", processes=2) as run:
                for row in run.rows():
                    if row["step"] >= 10:  # also by the rows that come before it has ended
                        if row["step"] == 10:
                            self.assertIsNone(run.process.poll())
                        # Ctrl-C in a terminal does not reach it a second time.
                        self.assertNotEqual(os.getpgid(run.process.pid), os.getpgid(0))
                        run.interrupt()
        self.assertEqual(raised.exception.status, 130)
        done = signorini.Result(run.folder).history.step.iloc[-1]
        self.assertGreaterEqual(done, 10)
        end = (done + 5) * 5e-3
        resumed = signorini.resume(run.folder, {"Time/End time": end})
        self.assertEqual([row["step"] for row in resumed.rows()], list(range(int(done) + 6)))

    def test_resume_after_a_kill(self):
        """What was computed after the checkpoint is computed again, and told once."""
        scene = running.disc().changed({**LONG, "Checkpoint/Every steps": 50})
        run = signorini.start(scene, running.folder / "killed")
        self.addCleanup(run.kill)
        with self.assertRaisesRegex(signorini.RunError, "ended by the signal 9"):
            for row in run.rows():
                if row["step"] == 80:
                    run.kill()
        done = int(signorini.Result(run.folder).history.step.iloc[-1])
        resumed = signorini.resume(run.folder, {"Time/End time": (done + 20) * 5e-3})
        self.assertEqual([row["step"] for row in resumed.rows()], list(range(done + 21)))

    def test_an_event_ends_a_run_of_a_thread(self):
        stop = threading.Event()
        with self.assertRaises(signorini.Interrupted):
            signorini.run(
                running.disc().changed(LONG),
                running.folder / "stopped",
                stop=stop,
                on_row=lambda row: stop.set(),
            )

    def script(self, name):
        """SCRIPT in a process of its own, when its run has begun."""
        running.disc().changed(LONG).write(running.folder / "long.prm")
        text = SCRIPT.format(
            path=[str(running.SOURCE / "python")],
            scene=str(running.folder / "long.prm"),
            folder=str(running.folder / name),
        )
        process = subprocess.Popen(
            [sys.executable, "-c", text], stdout=subprocess.PIPE, text=True, start_new_session=True
        )
        self.assertEqual(process.stdout.readline(), "0.0\n")
        return process

    @unittest.skipUnless(executable.ended_with_us(), "setpriv is not there")
    def test_no_run_is_left_alone(self):
        """Python is killed, and cannot do anything about it any more."""
        with self.script("alone") as process:
            process.kill()
        result = signorini.Result(running.folder / "alone")
        for _ in range(600):
            if "interrupted by SIGTERM" in result.log:
                return
            time.sleep(0.1)
        self.fail("the program goes on")

    def test_ctrl_c_is_handed_on(self):
        with self.script("by_hand") as process:
            os.killpg(process.pid, signal.SIGINT)  # as a terminal does
            said = process.communicate(timeout=100)[0]
        self.assertTrue(said.endswith("ended by hand\n"), said)
        self.assertIn("interrupted by SIGINT", signorini.Result(running.folder / "by_hand").log)

    def test_mistakes_are_raised(self):
        path = running.folder / "mistakes"
        with self.assertRaisesRegex(
            signorini.SceneError, "input.prm, line .*Radius = -1"
        ) as raised:
            signorini.run(running.disc(), path, {"Bodies/disc/Radius": -1})
        self.assertEqual(raised.exception.status, 2)
        with self.assertRaisesRegex(signorini.SceneError, "nowhere.prm"):
            signorini.run(running.folder / "nowhere.prm", path)
        with self.assertRaisesRegex(signorini.RunError, "strained") as raised:
            fast = {"Bodies/disc/Initial velocity": (0, -5), "Time/Stop on warning": True}
            signorini.run(running.disc(), path, fast)
        self.assertEqual(raised.exception.status, 1)
        with self.assertRaisesRegex(signorini.ProgramNotFound, "no such program"):
            signorini.run(running.disc(), path, executable="/nowhere/signorini")

    def test_a_failure_is_what_the_program_says(self):
        """Not what a library says before, and no warning."""
        warning = "signorini: warning: strained\n"
        for messages, status, expected in (
            ("[hwloc] no topology\nsignorini: a.prm: wrong\nmore", 2, "a.prm: wrong"),
            (warning + "killed", 1, "killed"),
            (warning, 9, "ended with status 9"),
            ("", -11, "ended by the signal 11"),
        ):
            self.assertTrue(str(error_of(status, messages)).endswith(expected), messages)

    def test_tables_that_grow_and_are_cut_off(self):
        path = running.folder / "table.csv"
        table = tables.GrowingTable(path)
        self.assertEqual(table.new_rows(), [])
        path.write_text("step,x\n0,1\n1,", encoding="utf-8")
        self.assertEqual(table.new_rows(), [{"step": 0, "x": 1}])
        self.assertEqual(tables.read_columns(path), {"step": [0], "x": [1]})
        path.write_text("step,x\n0,1\n1,5\n2,7\n", encoding="utf-8")
        self.assertEqual([row["x"] for row in table.new_rows()], [5, 7])
        path.write_text("step,x\n0,1\n1,55\n", encoding="utf-8")
        self.assertEqual([row["x"] for row in table.new_rows()], [1, 55])

    def test_where_the_program_is_found(self):
        named = os.environ.pop("SIGNORINI")
        before, place = os.environ["PATH"], pathlib.Path.cwd()
        checkout = running.folder / "checkout"
        (checkout / "build/release").mkdir(parents=True)
        built = checkout / "build/release/signorini"
        try:
            built.symlink_to(named)
            os.environ["PATH"] = str(built.parent)
            self.assertEqual(signorini.find_executable(), str(built))
            os.environ["PATH"] = "/nowhere"
            os.chdir(built.parent)
            self.assertIn(
                signorini.find_executable(),
                (str(built), str(running.SOURCE / executable.IN_CHECKOUT)),
            )
        finally:
            os.environ.update(SIGNORINI=named, PATH=before)
            os.chdir(place)
        self.assertEqual(signorini.find_executable(), os.path.abspath(named))
        self.assertEqual(signorini.find_executable(built), str(built))


class Sweeps(unittest.TestCase):
    def test_combinations_two_at_a_time(self):
        variations = {"Time/Step size": [1e-2, 5e-3], "Bodies/disc/Density": [1, 2]}
        sweep = signorini.Sweep(running.disc(), variations, running.folder / "sweep").run(jobs=2)
        frame = sweep.frame(force=lambda result: result.history.contact_force.max())
        self.assertEqual(list(frame["Time/Step size"]), [1e-2, 1e-2, 5e-3, 5e-3])
        self.assertEqual(list(frame["Bodies/disc/Density"]), [1, 2, 1, 2])
        self.assertEqual(list(frame.failure), [""] * 4)
        self.assertEqual(len(set(frame.force)), 4)
        self.assertEqual(len(sweep.histories()), 2 * 21 + 2 * 41)

    def test_finished_runs_are_taken(self):
        """Unless the scene is another one; failures stop no other run."""
        runs = [{"Time/Step size": 1e-2}, {"Time/Step size": -1}]

        def started(scene, settings):
            sweep = signorini.Sweep(scene, settings, running.folder / "again").run()
            return [
                path.stat().st_mtime_ns for path in running.folder.glob("again/*/log.txt")
            ], sweep

        first, sweep = started(running.disc(), runs)
        frame = sweep.frame()
        self.assertEqual(frame.failure[0], "")
        self.assertIn("Time/Step size = -1", frame.failure[1])
        self.assertAlmostEqual(frame.time[0], 0.2)
        time.sleep(0.01)
        self.assertEqual(started(running.disc(), runs[:1])[0], first)
        self.assertNotEqual(started(running.disc(scheme="newmark"), runs[:1])[0], first)

    def test_a_mesh_that_has_changed_is_another_scene(self):
        mesh = running.folder / "hammer.inp"
        source = running.PARAMETERS / "meshes" / "hammer.inp"
        mesh.write_bytes(source.read_bytes())
        scene = signorini.Scene.read(running.PARAMETERS / "hammer_and_anvil.prm")
        settings = {"Bodies/hammer/File": str(mesh), "Time/End time": 0.005, "Output/VTU": False}

        def run():
            result = signorini.run(scene, running.folder / "mesh", settings, reuse=True)
            return (result.folder / "log.txt").stat().st_mtime_ns

        first = run()
        self.assertEqual(run(), first)
        mesh.write_bytes(source.read_bytes() + b"** a line more\n")
        self.assertNotEqual(run(), first)

    def test_runs_need_settings_of_their_own(self):
        with self.assertRaises(ValueError):
            signorini.Sweep(running.disc(), [{"Time/Step size": 1}] * 2, running.folder)


if __name__ == "__main__":
    running.main()
