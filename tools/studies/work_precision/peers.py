# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Other programs on the same problem, from parameters/studies/peers.csv, beside the runs of this
one."""

import math

import numpy

from ..adaptive_measures import force_curve
from ..case import text
from ..tables import read_rows
from .errors import relative

#: Numbers that were noted of other programs, by the names of quantities here.
FORCE = "force_largest"
COMPARED = (FORCE, "contact_end", "velocity_after", "energy_kept")
#: How a run of this program is called in the table.
OWN = "signorini"


def number(value):
    """Of a cell of the table; nan if it is empty."""
    return float(value) if value else math.nan


def seconds(row):
    """Processor time of a run: all of it where it was noted, else that of all its steps."""
    return (
        number(row["processor_s"])
        if row["processor_s"]
        else number(row["steps"]) * number(row["processor_s_per_step"])
    )


def mean_force(result):
    """The largest force in the middle of a step: of other programs it was noted as a mean over the
    step, and where forces alternate, those at its end are twice as large."""
    ends, sizes = numpy.array(result["time"]), numpy.array(result["step_size"])
    return float(max(force_curve(result, ends - sizes / 2)))


def values_of(result, study, names):
    """The numbers that are compared, of a run of this program."""
    return {
        name: mean_force(result) if name == FORCE else study.observations[name](result)
        for name in names
    }


def beside(problem, path):
    """(name, code, step size, dofs, processor time, errors) of the runs of this program along its
    path, and of those of the others that came to an end."""
    study = problem.study
    names = [name for name in COMPARED if name in study.observations]
    own = values_of(problem.reference_result, study, names) if problem.reference else {}
    expected = {
        name: (study.exact[name](0.0) if name in study.exact else own[name]) for name in names
    }
    lines = []
    for variant, numbers in problem.rows:
        if numbers:
            result = problem.results[variant.name]
            values = values_of(result, study, names)
            lines.append((variant.name, OWN, numbers["dofs"], numbers["seconds"], values))
    for row in read_rows(path):
        values = {name: number(row[name]) for name in names}
        if row["case"] == study.peers and not all(map(math.isnan, values.values())):
            name = f"{row['code']} {row['version']}: {row['scheme']}; {row['contact']}"
            lines.append((name, row["code"], number(row["dofs"]), seconds(row), values))
    errors = [
        {name: relative(value, expected[name]) for name, value in values.items()}
        for *_, values in lines
    ]
    return names, [(*line[:-1], wrong) for line, wrong in zip(lines, errors)]


def table(names, lines):
    """Sorted by processor time, those without at the end."""
    rows = [["run", "dofs", "processor s", *(f"{name}, %" for name in names)]]
    for name, _, dofs, cost, errors in sorted(
        lines, key=lambda line: (math.isnan(line[3]), line[3])
    ):
        rows.append([name, text(dofs), text(cost), *(text(errors[name]) for name in names)])
    return rows
