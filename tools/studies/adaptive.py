# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study adaptive: errors against degrees of freedom and run time, for uniform and for adaptive
meshes and steps."""

import json
import math
import pathlib
import resource
import time

from . import adaptive_figures, adaptive_measures as measures, runs, tables
from .definition import Study
from .observe import Result

#: Study files. The variants of the group "uniform" are what the others are compared with.
CASES = ("adaptive_bar", "adaptive_geometry_a", "adaptive_geometry_b", "adaptive_sliding_block")
UNIFORM = "uniform"
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
        self.folder = folder / self.study.name.removeprefix("adaptive_")
        self.folder.mkdir(parents=True, exist_ok=True)
        self.tasks = runs.tasks(self.study, self.folder)
        settings = {"Output/VTU": "false", **self.study.reference, **self.study.common}
        self.reference = self.study.reference and runs.Task(
            self.study, "reference", settings, self.folder / "reference"
        )

    def groups(self):
        """(variant, numbers) by group, in the order of the file."""
        found = {}
        for variant, numbers in zip(self.study.variants, self.numbers):
            found.setdefault(variant.group, []).append((variant, numbers))
        return found

    def read(self, done, reference):
        """Measure what was run."""
        self.results = done
        for result in done:
            result.exact_force = self.study.exact_force
        self.numbers = [measures.measure(result, reference) for result in done]
        for numbers in self.numbers:
            uniform = [other for _, other in self.groups()[UNIFORM]]
            for cost in ("dofs", "seconds"):
                for name in measures.ERRORS:
                    numbers[f"{name} per {cost}"] = measures.gain(numbers, uniform, cost, name)


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


def text(value):
    """Three digits, a dash for what is not known."""
    return "-" if math.isnan(value) else f"{value:.0f}" if value >= 1000 else f"{value:.3g}"


def finished(task):
    """The result of a run that was done before; an interrupted one left tables, but no time."""
    result = runs.read(task)
    return (
        result
        if not result or (task.folder / TIME).exists()
        else Result(task.folder, "was interrupted. Run the study again.")
    )


def errors_of(case):
    """The errors that are known in a case."""
    return [
        name
        for name in measures.ERRORS
        if any(not math.isnan(numbers[name]) for numbers in case.numbers)
    ]


def table(case):
    """One line for each run."""
    names = ["dofs", "largest_dofs", "steps", "changes", "seconds", *errors_of(case), "roughness"]
    rows = [["run", *(measures.HEADINGS[name] for name in names)]]
    return rows + [
        [variant.name, *(text(numbers[name]) for name in names)]
        for variant, numbers in zip(case.study.variants, case.numbers)
    ]


def gains(case):
    """How many times fewer dofs and seconds than uniform meshes with the same error."""
    names = [f"{name} per {cost}" for name in errors_of(case) for cost in ("dofs", "seconds")]
    rows = [
        [
            "run",
            *(
                f"{name.split()[0]}: {'dofs' if name.endswith('dofs') else 'time'}"
                for name in names
            ),
        ]
    ]
    return rows + [
        [variant.name, *(text(numbers[name]) for name in names)]
        for variant, numbers in zip(case.study.variants, case.numbers)
        if variant.group != UNIFORM
    ]


def times(case):
    """Where the run time went."""
    rows = [
        [
            "run",
            "seconds",
            *(f"{name}, %" for name in (*dict.fromkeys(measures.SECTIONS.values()), "rest")),
        ]
    ]
    for variant, result, numbers in zip(case.study.variants, case.results, case.numbers):
        if result:
            parts = measures.where_the_time_went(result)
            rows.append(
                [
                    variant.name,
                    text(numbers["seconds"]),
                    *(f"{part:.0f}" for part in parts.values()),
                ]
            )
    return rows


def adaptive(arguments, root):
    """The study as the command line wants it. Returns whether no run failed."""
    folder = pathlib.Path(arguments.folder or "output/adaptive").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    good, page = True, ""
    for name in CASES:
        case = Case(root / "parameters" / "studies" / f"{name}.ini", arguments.coarse, folder)
        print(case.study.title, flush=True)
        exact = (
            reference(arguments.executable, case.reference, arguments.draw_only)
            if case.reference
            else None
        )
        done = (
            list(map(finished, case.tasks))
            if arguments.draw_only
            else [timed(arguments.executable, task) for task in case.tasks]
        )
        good = good and bool(exact or not case.reference) and all(done)
        if case.reference and not exact:
            print(f"  left out: its reference failed: {exact.failure}", flush=True)
            continue
        case.read(done, exact)
        adaptive_figures.draw(case, errors_of(case), folder / f"{case.folder.name}.png")
        page += f"## {case.study.title}\n\n"
        for part, rows in (("errors", table(case)), ("gains", gains(case)), ("times", times(case))):
            tables.write(rows, folder / f"{case.folder.name}_{part}")
            page += tables.markdown(rows) + "\n\n"
        page += f"![Errors]({case.folder.name}.png)\n\n"
        (folder / "tables.md").write_text(page, encoding="utf-8")
    print(f"\n{page}{folder / 'tables.md'}")
    return good
