# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A small scene with all that a checkpoint has to keep: two bodies whose contact follows the
motion, with friction, on a mesh that changes; and runs of it that may be ended from outside."""

import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import time

import check_history

SCENE = """
set Dimension = 2
subsection Time
  set Scheme    = contact-stabilized-projected
  set Step size = 4e-3
  set End time  = 0.32
end
subsection Adaptivity
  set Indicator                = residual
  set Distance                 = 0.05
  set Maximum level            = 3
  set Steps between remeshings = 3
end
subsection Bodies
  set Names = ball, block
  subsection ball
    set Shape            = ball
    set Centre           = 0, 1.51
    set Radius           = 0.5
    set Refinements      = 2
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0.8; -1
  end
  subsection block
    set Shape           = box
    set Lower corner    = -1, 0
    set Upper corner    = 1, 1
    set Repetitions     = 2, 1
    set Refinements     = 2
    set Young's modulus = 800
    set Poisson's ratio = 0.3
    set Density         = 1
    set Dirichlet       = 2: 0; 0
  end
end
subsection Contact
  set Pairs = ball : block
  subsection ball : block
    set Friction coefficient = 0.3
  end
end
subsection Checkpoint
  set Every steps = 5
end
"""


class InterruptedRun:
    """A run in a folder of its own, that can be started again."""

    def __init__(self, name, processes=1, overrides=()):
        self.folder = pathlib.Path(check_history.settings["folder"]) / name
        self.output = self.folder / "output"
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        (self.folder / "written.prm").write_text(SCENE, encoding="utf-8")
        self.processes, self.overrides = processes, overrides
        self.process = None

    def start(self, *options, processes=None, **how):
        """The program, from the beginning or with --resume."""
        overrides = (f"Output directory={self.output}", "Output/VTU=false", *self.overrides)
        scene = self.folder / "written.prm"
        # A session of its own, so that all of its processes can be killed at once.
        self.process = subprocess.Popen(
            check_history.command(scene, overrides, processes or self.processes, options),
            env=check_history.environment(),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            **how,
        )
        return self

    def end(self, timeout=check_history.TIMEOUT):
        """Status and messages, without warnings."""
        _, errors = self.process.communicate(timeout=timeout)
        messages = [line for line in errors.splitlines() if line.startswith("signorini: ")]
        return self.process.returncode, [
            line for line in messages if not line.startswith("signorini: warning")
        ]

    def wait_for_steps(self, number):
        table = self.output / "history.csv"
        for _ in range(6000):
            if table.exists() and table.read_text(encoding="utf-8").count("\n") > number:
                return
            if self.process.poll() is not None:
                raise AssertionError("the run ended by itself: " + self.process.stderr.read())
            time.sleep(0.005)

    def kill(self):
        """All processes of the run, at once: those of mpirun are in sessions of their own."""
        pids = [int(entry.name) for entry in pathlib.Path("/proc").glob("[0-9]*")]
        for pid in [self.process.pid, *pids]:
            with contextlib.suppress(OSError):
                if str(self.output) in pathlib.Path(f"/proc/{pid}/cmdline").read_text():
                    os.kill(pid, signal.SIGKILL)
        self.end()

    def signal(self, kind=signal.SIGTERM):
        """To one process of the run; mpirun would kill them all."""
        pid = self.process.pid
        os.kill(check_history.last_process(pid) if self.processes > 1 else pid, kind)

    def table(self, name):
        return check_history.read_table(self.output / f"{name}.csv")

    def has_checkpoint(self):
        names = ("checkpoint", "checkpoint.previous")
        return any((self.output / name / "manifest").exists() for name in names)


def differences(run, other):
    """The largest difference in each column of each table, relative to the largest value."""
    result = {}
    for name in ("history", "bodies", "pairs", "supports"):
        first, second = run.table(name), other.table(name)
        assert list(first) == list(second), name
        for column, values in first.items():
            if column == "wall_time":
                continue
            assert len(values) == len(second[column]), (name, len(values), len(second[column]))
            scale = max(map(abs, values)) or 1.0
            difference = max(abs(a - b) for a, b in zip(values, second[column]))
            result[f"{name}/{column}"] = difference / scale
    return result
