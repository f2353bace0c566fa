# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""How wrong a run is: curves over time and single numbers, against what is known exactly or against
a reference run, relative, in per cent."""

import math
import re

import numpy

from ..adaptive_measures import SAMPLES, distance, force_curve
from ..mistake import Mistake
from ..observe import ERRORS, read_columns

#: In the texts of quantities: functions whose values are whole numbers of steps.
COUNTED = re.compile(r"\b(begin|end|duration)\(")


def curve(result, text, times):
    """A column over time, linear between steps: of the history and the tables beside it, or
    PROBE.COLUMN. Forces belong to instants of their own."""
    if text in result.history and "force" in text:
        return force_curve(result, times, text)
    table, _, column = text.rpartition(".")
    columns = read_columns(result.folder / f"probe_{table}.csv") if table else result.columns
    if column not in columns:
        raise Mistake(
            f"[curves] {text}: the results in {result.folder} have no such column. Valid:"
            f" {', '.join(columns)}."
        )
    return numpy.interp(times, columns["time"], columns[column])


class Expected:
    """What all runs of a study are compared with: of each curve and each quantity the value that
    [exact] gives, else that of the reference run. Observations that are errors stay what they
    are."""

    def __init__(self, study, reference, any_result):
        self.study, self.reference = study, reference
        self.times = numpy.linspace(0.0, any_result["time"][-1], SAMPLES)
        self.curves = {
            name: (
                numpy.array([study.exact[name](time) for time in self.times])
                if name in study.exact
                else curve(reference, text, self.times)
            )
            for name, text in study.curves.items()
        }
        self.numbers = {
            name: (
                study.exact[name](0.0)
                if name in study.exact
                else study.observations[name](reference)
            )
            for name in study.observe
            if name not in ERRORS
        }

    def names(self):
        """Of all errors: those that the program measures, curves, numbers."""
        known = [name.removesuffix("_error") for name in self.study.observe if name in ERRORS]
        return [*known, *self.curves, *self.numbers]

    def errors(self, result):
        """By name, in per cent."""
        return {
            **{
                name.removesuffix("_error"): self.study.observations[name](result)
                for name in self.study.observe
                if name in ERRORS
            },
            **{
                name: distance(curve(result, self.study.curves[name], self.times), exact)
                for name, exact in self.curves.items()
            },
            **{
                name: relative(self.study.observations[name](result), exact)
                for name, exact in self.numbers.items()
            },
        }

    def resolution(self, name):
        """What the step of the reference leaves open of a number, in per cent: times at which
        contact begins or ends are known to a step."""
        text = getattr(self.study.observations.get(name), "text", "")
        if name not in self.numbers or name in self.study.exact or not COUNTED.search(text):
            return 0.0
        return 100 * self.reference["step_size"][-1] / abs(self.numbers[name])


def relative(value, exact):
    """Of a number, in per cent; nan if it should be zero."""
    return 100 * abs(value - exact) / abs(exact) if exact else math.nan
