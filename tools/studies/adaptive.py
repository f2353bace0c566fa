# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study adaptive: errors against degrees of freedom and run time, for uniform and for adaptive
meshes and steps."""

import math
import pathlib

from . import adaptive_figures, adaptive_measures as measures, tables
from .case import Case as TimedCase, text

#: Study files. The variants of the group "uniform" are what the others are compared with.
CASES = (
    "bar",
    "disc_oblique",
    "disc_slow",
    "ball_slow",
    "geometry_a",
    "geometry_b",
    "punch_2d",
    "punch_3d",
    "roller_2d",
    "roller_3d",
    "sliding_block",
)
UNIFORM = "uniform"


class Case(TimedCase):
    """A scene with its uniform and its adaptive runs."""

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


def errors_of(case):
    """The errors that are known in a case."""
    return [
        name
        for name in measures.ERRORS
        if any(not math.isnan(numbers[name]) for numbers in case.numbers)
    ]


def estimates_of(case):
    """What any run of a case says of its errors."""
    return [
        name
        for name in ("estimate", "stress_estimate")
        if any(not math.isnan(numbers[name]) for numbers in case.numbers)
    ]


def table(case):
    """One line for each run."""
    estimates = estimates_of(case)
    names = ["dofs", "largest_dofs", "steps", "changes", "seconds"]
    names += [*errors_of(case), *estimates, "roughness"]
    rows = [["run", *(measures.HEADINGS[name] for name in names)]]
    words = {name: measures.said if name in estimates else text for name in names}
    return rows + [
        [variant.name, *(words[name](numbers[name]) for name in names)]
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
    files = root / "parameters" / "studies" / "adaptive"
    for name in CASES:
        case = Case(files / f"{name}.ini", arguments.coarse, folder)
        done, exact = case.run(arguments.executable, arguments.draw_only)
        good = good and bool(done) and all(done)
        if not done:
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
