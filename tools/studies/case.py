# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A study file whose runs are timed and compared with a reference run that is kept."""

import json
import math
import resource
import time

from . import runs
from .definition import Study
from .observe import Result

#: Beside the results of a reference run: from what it was computed. Beside all others: their
#: processor time.
ORIGIN, TIME = "origin.json", "processor_time.txt"


class Case:
    """A study file with its runs. The reference run, if there is one, takes the keys of [scene],
    [coarse] and [reference], the former win."""

    def __init__(self, path, coarse, folder):
        self.study = Study(path, coarse)
        self.study.variants = [
            variant for variant in self.study.variants if not (coarse and variant.full)
        ]
        self.folder = folder / self.study.name
        self.folder.mkdir(parents=True, exist_ok=True)
        settings = {"Output/VTU": "false", **self.study.reference, **self.study.common}
        self.reference = self.study.reference and runs.Task(
            self.study, "reference", settings, self.folder / "reference"
        )

    @property
    def tasks(self):
        """The runs but for the reference."""
        return runs.tasks(self.study, self.folder)

    def run(self, executable, draw_only):
        """(results of the runs, that of the reference or None), read again if nothing is to run."""
        print(self.study.title, flush=True)
        exact = reference(executable, self.reference, draw_only) if self.reference else None
        if exact is not None and not exact:
            print(f"  left out: its reference failed: {exact.failure}", flush=True)
        elif draw_only:
            return list(map(finished, self.tasks)), exact
        else:
            return [timed(executable, task) for task in self.tasks], exact
        return [], exact


def origin(task):
    """What a run depends on, but for the program."""
    return json.dumps(
        {"scene": task.study.scene.read_text(encoding="utf-8"), "keys": task.settings}, indent=1
    )


def reference(executable, task, draw_only):
    """The reference run: kept from an earlier study if it was the same."""
    path = task.folder / ORIGIN
    if draw_only or (path.exists() and path.read_text(encoding="utf-8") == origin(task)):
        return runs.read(task)
    path.unlink(missing_ok=True)
    result = timed(executable, task)
    if result:
        path.write_text(origin(task), encoding="utf-8")
    return result


def timed(executable, task):
    """A run, with its processor time beside its results: other programs on the machine disturb it
    less than the wall time."""
    (task.folder / TIME).unlink(missing_ok=True)
    start, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    result = runs.run(executable, task)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(
        f"  {task.study.title}, {task.name}: {used:.1f} s of a processor,"
        f" {time.monotonic() - start:.1f} s"
        + (f"  failed: {result.failure}" if result.failure else ""),
        flush=True,
    )
    (task.folder / TIME).write_text(f"{used:.2f}\n", encoding="utf-8")
    return result


def finished(task):
    """The result of a run that was done before; an interrupted one left tables, but no time."""
    result = runs.read(task)
    return (
        result
        if not result or (task.folder / TIME).exists()
        else Result(task.folder, "was interrupted. Run the study again.")
    )


def seconds(result):
    """Processor time of a run, as it was written beside the results; else the wall time."""
    path = result.folder / TIME
    return float(path.read_text(encoding="utf-8")) if path.exists() else result["wall_time"][-1]


def text(value):
    """Three digits, a dash for what is not known."""
    return "-" if math.isnan(value) else f"{value:.0f}" if value >= 1000 else f"{value:.3g}"
