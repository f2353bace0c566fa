# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The figure of a study: one quantity over another, a point for each run, beside a curve."""

from plotting import style  # first, it chooses the backend

from matplotlib import pyplot

COLOURS = (style.VERMILION, style.BLUE, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)
MARKERS = "os^vDP"


def series(study, results):
    """The results by the group of their variant, by its name if it has none, or by the title of a
    study without variants."""
    found = {}
    for (variant, _), result in zip(study.runs(), results):
        if result:
            found.setdefault(
                (variant.group or variant.name) if variant else study.title, []
            ).append(result)
    return found


def draw(study, results, path):
    """The figure, as a file."""
    abscissa, ordinate = (study.observations[name] for name in study.figure)
    style.use()
    figure, axes = pyplot.subplots(figsize=(6.4, 4.4))
    if study.curve:
        axes.plot(
            study.curve.times,
            study.curve.values,
            color=style.BLACK,
            linewidth=1.2,
            label=study.curve_names[1],
        )
    for number, (name, runs) in enumerate(series(study, results).items()):
        axes.plot(
            [abscissa(run) for run in runs],
            [ordinate(run) for run in runs],
            linestyle="none",
            markersize=6,
            marker=MARKERS[number % len(MARKERS)],
            color=COLOURS[number % len(COLOURS)],
            label=name,
        )
    axes.set(xlabel=abscissa.heading, ylabel=ordinate.heading)
    axes.legend()
    figure.savefig(path, dpi=110)
    pyplot.close(figure)
