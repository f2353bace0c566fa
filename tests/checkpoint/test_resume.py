#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A run goes on from its checkpoint on another number of processes as far as the order of sums
allows, after a signal and beyond its end. What cannot be gone on with is refused, with the reason.
"""

import pathlib
import re
import shutil
import signal
import subprocess

import check_history
from interrupted_scene import InterruptedRun, differences

#: Of the largest value of a column. Solvers leave 2e-11 of the energy open.
OTHER_PROCESSES = 1e-8


class Resume(check_history.SceneTest):
    def ended_by_signal(self, name, processes=1, kind=signal.SIGTERM):
        run = InterruptedRun(name, processes).start()
        run.wait_for_steps(40)
        run.signal(kind)
        status, messages = run.end()
        self.assertIn(status, (128 + kind, kind), messages)
        return run, messages

    def test_other_numbers_of_processes(self):
        calm = InterruptedRun("calm").start()
        self.assertEqual(calm.end()[0], 0)
        for before, after in ((1, 2), (2, 1)):
            run, messages = self.ended_by_signal(f"from_{before}_on_{after}", before)
            self.assertIn("To go on: signorini --resume ", messages[0])
            run.start("--resume", processes=after)
            self.assertEqual(run.end()[0], 0)
            # What is round-off, or counts what it took, may be anything; the smallest gap jumps
            # from node to node.
            skipped = ("iterations", "products", "nodes", "residual", "penetration", "geometry")
            skipped += ("external", "smallest_gap")
            for column, by in differences(calm, run).items():
                if not any(word in column for word in skipped):
                    self.assertLess(by, OTHER_PROCESSES, (column, before, after))

    def test_contact_that_does_not_follow(self):
        """Finer meshes admit nodes that penetrate: a checkpoint must not push them out."""
        linearised = [
            "Contact/Motion=linearised",
            "Contact/ball : block/Friction coefficient=0",
            "Adaptivity/Distance=0",  # contact is refined when it is there
            "Adaptivity/Maximum level=4",
        ]
        runs = []
        for name, every in (("admitted", 5), ("admitted_without_checkpoints", 1000)):
            run = InterruptedRun(name, 1, [*linearised, f"Checkpoint/Every steps={every}"]).start()
            self.assertEqual(run.end(), (0, []))
            runs.append(run)
        by = differences(*runs)
        for column in ("contact_force", "elastic_energy", "total_energy"):
            self.assertLess(by[f"history/{column}"], OTHER_PROCESSES, column)

    def test_what_may_change(self):
        run, _ = self.ended_by_signal("changed")
        run.overrides = ("Bodies/ball/Density=2",)
        status, messages = run.start("--resume").end()
        self.assertEqual(status, 2)
        self.assertIn("`Bodies/ball/Density` is `2` and was `1`", messages[0])
        self.assertIn("Time/End time", messages[0])
        run.overrides = ("Time/End time=0.34",)
        self.assertEqual(run.start("--resume").end()[0], 0)
        self.assertAlmostEqual(run.table("history")["time"][-1], 0.34, delta=1e-12)
        # The end has a checkpoint of its own.
        run.overrides = ("Time/End time=0.36",)
        self.assertEqual(run.start("--resume").end()[0], 0)
        times = run.table("history")["time"]
        for row in range(1, len(times)):
            self.assertAlmostEqual(times[row] - times[row - 1], 4e-3, delta=1e-12)

    def test_damaged_checkpoints(self):
        calm = InterruptedRun("undamaged").start()
        self.assertEqual(calm.end()[0], 0)
        run, _ = self.ended_by_signal("damaged")
        files = [run.output / name / "memory" for name in ("checkpoint", "checkpoint.previous")]
        for damaged, file in enumerate(files):
            content = bytearray(file.read_bytes())
            content[len(content) // 2] ^= 1
            file.write_bytes(content)
            status, messages = run.start("--resume").end()
            if damaged == 0:
                self.assertEqual(status, 0, messages)
                log = (run.output / "log.txt").read_text(encoding="utf-8")
                self.assertIn("memory` is damaged; an earlier", log)
                self.assertEqual(max(differences(calm, run).values()), 0.0)
                # Both that the resumed run has left.
                files[0].write_bytes(b"")
            else:
                self.assertEqual(status, 2)
                self.assertIn("there is no checkpoint to go on from: ", messages[0])

    def test_a_table_is_gone_or_short(self):
        run, _ = self.ended_by_signal("without_table")
        table = run.output / "history.csv"
        content = table.read_bytes()
        for lacking in (content[: len(content) // 2], None):
            if lacking is None:
                table.unlink()
            else:
                table.write_bytes(lacking)
            status, messages = run.start("--resume").end()
            self.assertEqual(status, 2)
            self.assertIn("history.csv`: ", messages[0])
            self.assertIn("Put the file of the run back", messages[0])

    def test_series_name_what_is_there(self):
        """Files that somebody took away are not named, and those of steps to come do not stay."""
        run = InterruptedRun("fields")
        run.overrides = ("Output/VTU=true", "Output/VTU every=4", "Time/End time=0.1")
        self.assertEqual(run.start().end()[0], 0)
        fields = run.output / "fields"
        (fields / "volume_000004.pvtu").unlink()
        (fields / "volume_000099.pvtu").write_text("of a run that was killed", encoding="utf-8")
        run.overrides = (*run.overrides[:2], "Time/End time=0.14")
        self.assertEqual(run.start("--resume").end()[0], 0)
        series = (run.output / "volume.pvd").read_text(encoding="utf-8")
        named = re.findall(r'file="fields/(volume_\d+)\.pvtu"', series)
        self.assertNotIn("volume_000004", named)
        self.assertEqual(len(named), len(set(named)))
        self.assertIn("volume_000028", named)
        there = {path.stem for path in fields.glob("volume_*.pvtu")}
        self.assertEqual(there, set(named))

    def test_another_mesh(self):
        """The scene is the same, but not the file that it names."""
        folder = pathlib.Path(check_history.settings["folder"]) / "mesh"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(check_history.PARAMETERS / "meshes", folder / "meshes")
        scene = shutil.copy(check_history.scene_file("hammer_and_anvil"), folder)
        keys = (f"Output directory={folder / 'output'}", "Output/VTU=false")
        keys += ("Time/End time=0.02", "Checkpoint/Every steps=2")
        for options, status in (((), 0), (("--resume",), 2)):
            done = subprocess.run(
                check_history.command(scene, keys, 1, options),
                env=check_history.environment(),
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual(done.returncode, status, done.stderr)
            with open(folder / "meshes" / "hammer.inp", "a", encoding="utf-8") as mesh:
                mesh.write("** a line more\n")
        self.assertIn("the file of `Bodies/hammer/File` has changed", done.stderr)

    def test_another_version(self):
        run, _ = self.ended_by_signal("version")
        for manifest in run.output.glob("checkpoint*/manifest"):
            text = manifest.read_text(encoding="utf-8")
            manifest.write_text(text.replace("signorini 0", "signorini 7", 1), encoding="utf-8")
        status, messages = run.start("--resume").end()
        self.assertEqual(status, 2)
        self.assertRegex(messages[0], "was written by signorini 7.*; this is signorini 0")

    def test_without_a_checkpoint(self):
        run = InterruptedRun("none")
        run.output.mkdir(exist_ok=True)
        status, messages = run.start("--resume").end()
        self.assertEqual(status, 2)
        self.assertIn("Run without --resume.", messages[0])

    def test_one_run_at_a_time(self):
        """A second run into the folder of one that goes on is refused, and harms nothing."""
        first = InterruptedRun("first", overrides=("Time/Step size=1e-5",)).start()
        first.wait_for_steps(20)
        second = InterruptedRun("second")
        second.output = first.output
        status, messages = second.start().end()
        self.assertEqual(status, 1)
        self.assertIn("another run is writing to `", messages[0])
        first.signal()
        self.assertEqual(first.end()[0], 143)
        steps = first.table("history")["step"]
        self.assertEqual(steps, list(range(len(steps))))


if __name__ == "__main__":
    check_history.main()
