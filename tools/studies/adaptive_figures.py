# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Figures of the study adaptive: each error over dofs (above) and over run time (below)."""

import math

from plotting import style  # first, it chooses the backend

from matplotlib import pyplot

from .adaptive_measures import HEADINGS

COLOURS = (
    style.BLACK,
    style.BLUE,
    style.VERMILION,
    style.GREEN,
    style.ORANGE,
    style.PURPLE,
    style.SKY,
    style.GREY,
)
MARKERS = "os^vDPX*"
COSTS = {"dofs": "degrees of freedom (mean)", "seconds": "processor time, s"}


def panel(axes, case, cost, error):
    """One error over one cost, a curve for each group."""
    for number, (group, members) in enumerate(case.groups().items()):
        points = [
            (numbers[cost], numbers[error])
            for _, numbers in members
            if numbers[error] > 0 and not math.isnan(numbers[cost])
        ]
        if points:
            axes.plot(
                *zip(*points),
                marker=MARKERS[number % len(MARKERS)],
                color=COLOURS[number % len(COLOURS)],
                markersize=6,
                linewidth=1.9 if number == 0 else 1.0,
                label=group,
            )
    axes.set(xscale="log", yscale="log", xlabel=COSTS[cost])


def draw(case, errors, path):
    """The figure of a case, as a file."""
    style.use()
    figure, axes = pyplot.subplots(
        len(COSTS), len(errors), squeeze=False, figsize=(4.2 * len(errors), 7.6)
    )
    for row, cost in zip(axes, COSTS):
        for cell, error in zip(row, errors):
            panel(cell, case, cost, error)
    for cell, error in zip(axes[0], errors):
        cell.set_title(f"error: {HEADINGS[error]}")
    axes[0][0].legend()
    figure.suptitle(case.study.title)
    figure.savefig(path, dpi=90)
    pyplot.close(figure)
