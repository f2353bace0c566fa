# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The table of a run of extremes: all of it as CSV, and a line for each value as Markdown."""

import csv

from studies import tables

from . import laws, verdict

NUMBERS = (
    "residual",
    "energy",
    "depth",
    "force",
    "steps",
    "contacts",
    "mean iterations",
    "most iterations",
    "most linear iterations",
    "fallbacks",
    "rejected",
)
HEADING = ["family", "value", "scheme", "outcome", "why", "laws broken", *NUMBERS, "seconds"]
CONDENSED = ["family", "value", "outcome", "residual", "laws", "iterations", "why"]
#: Columns of a text in Markdown.
WIDTH = 42
#: From the worst.
ORDER = (verdict.WRONG, verdict.REFUSED, verdict.WARNED, verdict.FINISHED)


class Line:
    """One run."""

    def __init__(self, family, value, scheme, judged, seconds):
        self.family, self.value, self.scheme = family, value, scheme
        self.verdict, self.seconds = judged, seconds

    def in_words(self):
        """For the progress."""
        return f"{' '.join(self.row()[:4])}: {shortened(self.verdict.why, 2 * WIDTH)}"

    def row(self):
        """Texts for the CSV."""
        return [
            self.family.name,
            label(self.value),
            self.scheme,
            self.verdict.outcome,
            self.verdict.why,
            " ".join(self.verdict.laws),
            *(f"{self.verdict.numbers[n]:.4g}" if self.verdict.numbers else "" for n in NUMBERS),
            f"{self.seconds:.2f}",
        ]


def label(value):
    """A value as a word, also of a folder."""
    return f"{value:.9g}"


def write(lines, folder):
    """folder/table.csv and folder/table.md."""
    with open(folder / "table.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([HEADING, *(line.row() for line in lines)])
    (folder / "table.md").write_text(markdown(lines), encoding="utf-8")


def markdown(lines):
    """One line for each family and value, over all schemes."""
    groups = {}
    for line in lines:
        groups.setdefault((line.family.name, line.value), []).append(line)
    return tables.markdown([CONDENSED, *map(condensed, groups.values())]) + "\n"


def condensed(lines):
    """The texts for all schemes of one scene."""
    counts = {o: sum(line.verdict.outcome == o for line in lines) for o in ORDER}
    said = [line.verdict.numbers for line in lines if line.verdict.numbers]
    broken = sorted({law for line in lines for law in line.verdict.laws}, key=order_of_law)
    mean = max((n["mean iterations"] for n in said), default=0.0)
    most = max((n["most iterations"] for n in said), default=0.0)
    return [
        lines[0].family.name,
        label(lines[0].value),
        ", ".join(f"{count} {o}" for o, count in counts.items() if count),
        f"{max(n['residual'] for n in said):.0e}" if said else "",
        ", ".join(broken) or "all" if said else "",
        f"{mean:.1f}, {most:.0f}" if said else "",
        reasons(lines),
    ]


def order_of_law(name):
    """The place of a law in the list of laws."""
    return [*laws.LAWS, "finite"].index(name)


def reasons(lines):
    """What the worst of the runs say: kinds of warnings, or the beginning of the first reason."""
    worst = next(o for o in ORDER if any(line.verdict.outcome == o for line in lines))
    said = [line.verdict.why for line in lines if line.verdict.outcome == worst]
    if worst == verdict.WARNED:
        said = dict.fromkeys(kind for text in said for kind in text.split(", "))
        return ", ".join(said)
    return shortened(next(iter(said), ""), WIDTH)


def shortened(text, width):
    """The beginning of a text."""
    return text if len(text) <= width else text[: width - 3].rstrip() + "..."
