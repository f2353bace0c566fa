# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Values with error bars from refinement: of a series of runs whose cells and steps become smaller
together by a factor of two, and of two such series with different schemes.

This is Richardson's extrapolation with the order that the last three values show (P. J. Roache,
Perspective: a method for uniform reporting of grid refinement studies, Journal of Fluids
Engineering 116 (1994) 405-413), as if it were second if it is better than that. The error bar
reaches back to the last value, so that the extrapolation need not be believed. Values that show no
order between 0.5 and 2.5 do not converge regularly: the larger of their last two changes is
their error bar.
"""

import dataclasses
import math

#: Orders of convergence that are regular, and the one that is believed at most.
LEAST, MOST, BELIEVED = 0.5, 2.5, 2.0
#: Relative, what solvers leave open.
ROUND_OFF = 1e-7


@dataclasses.dataclass
class Certificate:
    """A value, its error bar, and the order that was seen, nan if none was."""

    value: float
    uncertainty: float
    order: float


def extrapolate(values, resolution=0.0):
    """The certificate of the values of a series, the finest mesh last. resolution: what the last
    one cannot tell apart, as a time that is counted in steps."""
    before, change = values[-2] - values[-3], values[-1] - values[-2]
    floor = max(resolution, ROUND_OFF * abs(values[-1]))
    if abs(change) <= floor and abs(before) <= floor:
        return Certificate(values[-1], floor, math.nan)
    seen = math.log2(before / change) if before * change > 0 else math.nan
    if not LEAST <= seen <= MOST:
        return Certificate(values[-1], max(abs(before), abs(change), floor), math.nan)
    correction = change / (2 ** min(seen, BELIEVED) - 1)
    return Certificate(values[-1] + correction, max(abs(correction), floor), seen)


def combine(certificates):
    """That of the series with the smaller error bar. If the others are not within its reach and
    theirs, they extend it."""
    best = min(certificates, key=lambda one: one.uncertainty)
    distances = [
        abs(other.value - best.value)
        for other in certificates
        if abs(other.value - best.value) > other.uncertainty + best.uncertainty
    ]
    return Certificate(best.value, max([best.uncertainty, *distances]), best.order)


def rounded(certificate):
    """(value, uncertainty) as texts: two digits of the error bar, rounded up, and as many places of
    the value."""
    places = 1 - math.floor(math.log10(certificate.uncertainty))
    scale = 10.0**places
    bar = math.ceil(certificate.uncertainty * scale * (1 - 1e-12)) / scale
    digits = max(places, 0)
    return f"{round(certificate.value, places):.{digits}f}", f"{bar:.{digits}f}"
