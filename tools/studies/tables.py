# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Tables as comma-separated values and as Markdown."""

import csv
import math

from .observe import DISTANCES, ERRORS


def number(value):
    """Four digits."""
    return f"{value:.4g}"


def markdown(rows):
    """Rows of texts, the first one with the headings, as a table of Markdown; a dash stands for
    what could not be observed."""
    return "\n".join(
        "| " + " | ".join("-" if text == "nan" else text for text in row) + " |"
        for row in [rows[0], ["---"] * len(rows[0]), *rows[1:]]
    )


def write(rows, path):
    """path.csv and path.md."""
    with open(path.with_suffix(".csv"), "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(rows)
    path.with_suffix(".md").write_text(markdown(rows) + "\n", encoding="utf-8")


def read_rows(path):
    """The rows of a table by the names of its columns."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def observed(study, results):
    """One row for each run, the first one with the headings."""
    known = next((result.history for result in results if result), {})
    given = {
        "displacement_error": "relative_displacement_error" in known,
        "velocity_error": "relative_velocity_error" in known,
        "force_error": study.exact_force,
        **dict.fromkeys(DISTANCES, study.reference),
    }
    names = [name for name in study.observe or study.observations if given.get(name, True)]
    rates = len(study.sequence) > 1
    heading = ["variant"] * bool(study.variants) + [
        key.split("/")[-1] for key in [*study.variations, *study.sequence[0]]
    ]
    for name in names:
        heading += [study.observations[name].heading] + (
            ["rate"] if rates and name in ERRORS else []
        )
    rows, before = [heading], None
    for position, ((variant, settings), result) in enumerate(zip(study.runs(), results)):
        row = ([variant.name] if variant else []) + list(settings.values())
        for name in names:
            value = study.observations[name](result)
            row.append(number(value))
            if rates and name in ERRORS:
                old = (
                    study.observations[name](before)
                    if before and position % len(study.sequence)
                    else math.nan
                )
                row.append(f"{math.log2(old / value):.2f}" if old > 0 and value > 0 else "")
        before = result
        rows.append(row)
    return rows
