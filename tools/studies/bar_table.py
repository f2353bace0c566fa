# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The study bar-table: the bar that hits a wall, beside an independent computation in 1d."""

import math
import pathlib
import re
import statistics

from . import runs, tables
from .definition import Mistake, Study
from .observe import OBSERVATIONS, Observation

#: Of parameters/bar_2d.prm, whose solution is known: the contact force rho c v times the width, and
#: when it acts.
FORCE, START, END = 300.0 * 0.1, 0.5, 7.0 / 6.0
#: Entries that differ by less than this part, besides the rounding of the reference, agree.
CLOSE = 0.03


def force_deviation(result):
    """Standard deviation of the force over the exact one, in the middle four fifths of the exact
    time of contact."""
    margin = 0.1 * (END - START)
    middle = [
        force / FORCE
        for force, time in zip(result["contact_force"], result["time"])
        if START + margin <= time <= END - margin
    ]
    return statistics.pstdev(middle) if middle else math.nan


QUANTITIES = {
    **OBSERVATIONS,
    "force_deviation": Observation("deviation of the force / exact", force_deviation),
    "force_peak": Observation(
        "largest force / exact", lambda result: max(result["contact_force"]) / FORCE
    ),
}


def rounding(text):
    """Half a unit of the last digit of a number."""
    digits, _, power = text.lower().partition("e")
    return 0.5 * 10.0 ** (int(power or 0) - len(digits.partition(".")[2]))


def deviation(reference, here):
    """How much a number differs from the text of a reference, and whether it agrees."""
    if math.isnan(here):
        return "-", False
    value = float(reference)
    good = abs(here - value) <= CLOSE * abs(value) + rounding(reference)
    if value == 0.0:
        return f"{here - value:+.2g}", good
    return (
        f"{100 * (here / value - 1):+.1f} %"
        if abs(here) < 10 * abs(value)
        else f"times {here / value:.3g}"
    ), good


def put_beside(reference_rows, results):
    """(variant, quantity, reference, here, deviation, agrees) for each entry of the reference.
    results: by name of the variant."""
    entries = []
    for row in reference_rows:
        for quantity, reference in row.items():
            if quantity != "variant" and reference:
                here = QUANTITIES[quantity](results[row["variant"]])
                here = 0.0 if abs(here) < 1e-9 else here
                entries.append(
                    (row["variant"], quantity, reference, here, *deviation(reference, here))
                )
    return entries


def check(path, reference_rows, study):
    """Each line of the reference needs a variant and known quantities."""
    known = [variant.name for variant in study.variants]
    for row in reference_rows:
        if row.get("variant") not in known:
            raise Mistake(
                f"{path}: variant = {row.get('variant')} is not in {study.path}. Valid:"
                f" {', '.join(known)}."
            )
        for quantity, text in row.items():
            if quantity != "variant" and quantity not in QUANTITIES:
                raise Mistake(
                    f"{path}: the column {quantity} is not known. Valid: variant,"
                    f" {', '.join(QUANTITIES)}."
                )
            if quantity != "variant" and text and not re.fullmatch(r"-?\d+(\.\d+)?(e-?\d+)?", text):
                raise Mistake(
                    f"{path}: {row['variant']}, {quantity} = {text} is not a number. Write it like"
                    " -0.51, or leave it empty."
                )


def wide(reference_rows, entries):
    """A line for each variant with here, reference and deviation in each cell."""
    cells = {entry[:2]: entry[2:] for entry in entries}
    quantities = [name for name in reference_rows[0] if name != "variant"]
    rows = [["scheme"] + [QUANTITIES[name].heading for name in quantities]]
    for row in reference_rows:
        line = [row["variant"]]
        for name in quantities:
            if (row["variant"], name) not in cells:
                line.append("")
                continue
            reference, here, difference, _ = cells[row["variant"], name]
            line.append(
                "-" if math.isnan(here) else f"{tables.number(here)} / {reference} ({difference})"
            )
        rows.append(line)
    return rows


def summary(entries):
    """How many agree, and which do not."""
    known = [entry for entry in entries if not math.isnan(entry[3])]
    off = [entry for entry in known if not entry[5]]
    text = (
        f"Each entry: here / reference (deviation). {len(known) - len(off)} of {len(known)} entries"
        f" agree within {100 * CLOSE:g} % and the rounding of the reference."
    )
    if len(known) < len(entries):
        text += f" {len(entries) - len(known)} more could not be computed because runs failed."
    lines = [
        f"* {variant}, {QUANTITIES[name].heading}: {tables.number(here)} instead of {reference}"
        f" ({difference})"
        for variant, name, reference, here, difference, _ in off
    ]
    return text + ("\n\nThe others:\n\n" + "\n".join(lines) if lines else "") + "\n"


def bar_table(arguments, root):
    """The study as the command line wants it. Returns whether no run failed."""
    data = root / "parameters" / "studies"
    study = Study(data / "bar_table.ini", arguments.coarse)
    reference_rows = tables.read_rows(data / "bar_table.csv")
    check(data / "bar_table.csv", reference_rows, study)
    folder = pathlib.Path(arguments.folder or "output/bar-table").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    tasks = runs.tasks(study, folder)
    done = (
        runs.read_all(tasks)
        if arguments.draw_only
        else runs.run_all(arguments.executable, tasks, arguments.jobs or 2)
    )
    entries = put_beside(
        reference_rows, {variant.name: result for variant, result in zip(study.variants, done)}
    )
    long = [["variant", "quantity", "reference", "here", "deviation", "agrees"]]
    long += [
        [variant, name, reference, tables.number(here), difference, "yes" if good else "no"]
        for variant, name, reference, here, difference, good in entries
    ]
    tables.write(long, folder / "entries")
    rows = wide(reference_rows, entries)
    tables.write(rows, folder / "table")
    text = f"{tables.markdown(rows)}\n\n{summary(entries)}"
    (folder / "table.md").write_text(text, encoding="utf-8")
    print(f"\n{text}\n{folder / 'table.md'}")
    return all(done)
