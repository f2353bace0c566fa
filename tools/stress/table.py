# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The table of a run of extremes: all of it as CSV, and a line for each value as Markdown."""

import csv
import textwrap

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
#: Letters of the outcomes, from the worst.
LETTERS = {verdict.WRONG: "X", verdict.REFUSED: "R", verdict.WARNED: "w", verdict.FINISHED: "f"}
#: Columns of a text in Markdown.
WIDTH = 42


def label(value):
    """A value as a word, also of a folder."""
    return f"{value:.9g}"


def row(family, value, scheme, judged, seconds):
    """The texts of one run by heading."""
    said = {name: f"{number:.4g}" for name, number in judged.numbers.items()}
    return {
        "family": family.name,
        "value": label(value),
        "scheme": scheme["name"],
        "outcome": judged.outcome,
        "why": judged.why,
        "laws broken": " ".join(judged.laws),
        **{name: said.get(name, "") for name in NUMBERS},
        "seconds": f"{seconds:.2f}",
    }


def in_words(line):
    """One run, for the progress."""
    run = " ".join(line[name] for name in ("family", "value", "scheme", "outcome"))
    return f"{run}: {shortened(line['why'], 2 * WIDTH)}".removesuffix(": ")


def write(lines, path):
    """All runs as CSV."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, HEADING)
        writer.writeheader()
        writer.writerows(lines)


def markdown(lines, families):
    """A table for each family with a line for each value, over all schemes."""
    parts = []
    for family in families:
        groups = {}
        for line in lines:
            if line["family"] == family.name:
                groups.setdefault(line["value"], []).append(line)
        if groups:
            said = " ".join(family.build.__doc__.split())
            heading = [family.quantity, "ends", "residual", "laws", "iterations", "why"]
            parts.append(textwrap.fill(f"**{family.name}**: {said}", 100))
            parts.append(tables.markdown([heading, *map(condensed, groups.values())]))
    return "\n\n".join(parts) + "\n"


def condensed(lines):
    """The texts for all schemes of one scene."""
    judged = [line for line in lines if line["residual"]]
    broken = {law for line in lines for law in line["laws broken"].split()}
    most = {
        name: max((float(line[name]) for line in judged), default=0.0)
        for name in ("residual", "mean iterations", "most iterations")
    }
    iterations = f"{most['mean iterations']:.1f}, {most['most iterations']:.0f}"
    return [
        lines[0]["value"],
        "".join(LETTERS[line["outcome"]] for line in lines),
        f"{most['residual']:.0e}" if judged else "",
        ", ".join(sorted(broken, key=order_of_law)) or ("all" if judged else ""),
        iterations if judged else "",
        reasons(lines),
    ]


def order_of_law(name):
    """The place of a law in the list of laws."""
    return [*laws.LAWS, "finite"].index(name)


def reasons(lines):
    """What the worst of the runs say: kinds of warnings, or the beginning of the first reason."""
    worst = min((line["outcome"] for line in lines), key=list(LETTERS).index)
    said = [line["why"] for line in lines if line["outcome"] == worst]
    if worst == verdict.WARNED:
        said = [", ".join(dict.fromkeys(kind for text in said for kind in text.split(", ")))]
    return shortened(said[0], WIDTH)


def shortened(text, width):
    """The beginning of a text."""
    return text if len(text) <= width else text[: width - 3].rstrip() + "..."
