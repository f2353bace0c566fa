# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The table of results: one row for each quantity of each run of this program, and of those of
other programs that parameters/studies/peers.csv has."""

import csv
import math

import signorini

from ..case import seconds
from ..tables import read_rows
from ..work_precision import peers

#: Headings, and what stands below them (doc/benchmarks.md).
COLUMNS = (
    "case",
    "code",
    "version",
    "scheme",
    "contact",
    "settings",
    "cells",
    "dofs",
    "steps",
    "processor_s",
    "quantity",
    "value",
    "reference",
    "uncertainty",
    "kind",
    "error",
    "tolerance",
    "verdict",
)
#: How this program is called, and what it does to contact.
OWN, MORTAR, NODES = "signorini", "mortar, exact inequality", "nodes, exact inequality"
#: Verdicts.
WITHIN, OUTSIDE, FAILED = "within", "OUTSIDE", "FAILED"


def number(value):
    """Seven digits, nothing for what is not known."""
    return "" if math.isnan(value) else f"{value:.7g}"


def compared(problem, name, value):
    """The columns from the quantity on, but for tolerance and verdict."""
    known = problem.references[name]
    return {
        "quantity": name,
        "value": number(value),
        "reference": number(known.value),
        "uncertainty": f"{known.uncertainty:.2g}",
        "kind": known.kind,
        "error": number(value - known.value),
    }


def judge(problem, name, level, value):
    """Tolerance and verdict of a value on a mesh; the first one is number 0."""
    tolerance = problem.tolerance(name, level)
    error = abs(value - problem.references[name].value)
    verdict = FAILED if math.isnan(value) else WITHIN if error <= tolerance else OUTSIDE
    return {"tolerance": f"{tolerance:.3g}", "verdict": verdict}


def own(problem, executable, draw_only):
    """Rows of the runs of this program."""
    version = signorini.ask("--version", executable=executable).split()[1].rstrip(",")
    rows = []
    for settings, level, result in problem.results(executable, draw_only):
        text = "; ".join(f"{key} = {value}" for key, value in settings.items())
        run = dict.fromkeys(COLUMNS, "")
        run |= {"case": problem.name, "code": OWN, "version": version, "settings": text}
        if result:
            run |= {
                "scheme": result.keys_of_time["Scheme"],
                "contact": MORTAR if problem.study.geometry == "bodies" else NODES,
                "cells": f"{result['cells'][-1]:.0f}",
                "dofs": f"{result['dofs'][-1]:.0f}",
                "steps": f"{result['step'][-1]:.0f}",
                "processor_s": f"{seconds(result):.2f}",
            }
        for name in problem.references:
            value = problem.value(name, result)
            judged = judge(problem, name, level, value)
            rows.append({**run, **compared(problem, name, value), **judged})
    return rows


def others(problem, path):
    """Rows of other programs: of those runs that came to an end."""
    rows = []
    for row in read_rows(path) if problem.study.peers else ():
        if row["case"] != problem.study.peers:
            continue
        cost = peers.seconds(row)
        run = {
            **{name: row.get(name, "") for name in COLUMNS},
            "case": problem.name,
            "settings": f"step size {row['step_size']}; {row['linear_solver']}",
            "processor_s": number(cost),
        }
        for name in filter(problem.references.__contains__, peers.COMPARED):
            if row[name]:
                rows.append({**run, **compared(problem, name, float(row[name]))})
    return rows


def write(rows, path):
    """The table as a file."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
