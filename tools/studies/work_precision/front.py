# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Which runs are worth their cost: the Pareto front, and the cheapest one that is good enough."""

import math


def pareto(points):
    """Numbers of the points (cost, error) than which no other is better in one and as good in the
    other, by their cost; those with nan are left out."""
    known = [
        (cost, error, number)
        for number, (cost, error) in enumerate(points)
        if not math.isnan(cost + error)
    ]
    front, least = [], math.inf
    for _, error, number in sorted(known):
        if error < least:
            front.append(number)
            least = error
    return front


def cheapest(points, most):
    """The number of the cheapest point (cost, error) with an error of at most so much, or None."""
    good = [
        (cost, error, number)
        for number, (cost, error) in enumerate(points)
        if not math.isnan(cost) and error <= most
    ]
    return min(good)[2] if good else None


def points(rows, names, cost="seconds"):
    """(cost, error) of all runs; of several errors, the largest counts, and one that is not known
    makes it unknown. rows: (variant, numbers)."""
    return [
        (numbers.get(cost, math.nan), worst([numbers.get(name, math.nan) for name in names]))
        for _, numbers in rows
    ]


def worst(errors):
    """The largest, nan if one of them is."""
    return math.nan if any(map(math.isnan, errors)) else max(errors)
