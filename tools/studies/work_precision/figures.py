# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Figures of the study work-precision: errors over processor time, a colour for each scheme."""

from plotting import style  # first, it chooses the backend

from matplotlib import pyplot
from matplotlib.lines import Line2D

from .. import instants
from ..adaptive_figures import COLOURS, MARKERS
from ..comparison import save
from .front import pareto, points
from .problem import PATH

#: Beside the palette of all figures, for more schemes than it has colours.
FURTHER = ("#7A5195", "#8C564B", "#B5BD00", "#E377C2", "#17BECF", "#2F4B7C", "#A05195")
ACROSS = 3
#: Errors below this, in per cent, are drawn there: round-off would stretch the axis.
SMALLEST = 1e-3
GREY = style.GREY


def draw(problem, path):
    """A panel for each error, with the Pareto front as a line, and one with the legend."""
    style.use()
    names = problem.quantities
    down = -(-(len(names) + 1) // ACROSS)
    figure, axes = pyplot.subplots(
        down, ACROSS, squeeze=False, figsize=(4.4 * ACROSS, 3.9 * down), sharex=True
    )
    used = {problem.scheme(variant) for variant, _ in problem.rows}
    # Of all schemes of the program, so that one has the same colour in all figures.
    colours = {
        scheme: colour
        for scheme, colour in zip(instants.schemes, (*COLOURS, *FURTHER))
        if scheme in used
    }
    groups = dict.fromkeys(variant.group for variant, _ in problem.rows)
    markers = dict(zip(groups, MARKERS))
    for panel, name in zip(axes.flat, names):
        for (variant, _), (cost, error) in zip(problem.rows, points(problem.rows, [name])):
            panel.plot(
                cost,
                max(error, SMALLEST),
                markers[variant.group],
                color=colours[problem.scheme(variant)],
                markersize=6 if variant.group == PATH else 8,
                markerfacecolor=None if variant.group == PATH else "none",
            )
        draw_front(panel, points(problem.rows, [name]))
        if name in problem.floor:
            panel.axhline(problem.floor[name], color=GREY, linestyle="--", linewidth=1.0)
        panel.set(xscale="log", yscale="log", title=f"{name.replace('_', ' ')}, error in %")
    for panel in axes.flat[len(names) :]:
        panel.set_axis_off()
    for panel in axes.flat[max(0, len(names) - ACROSS) : len(names)]:
        panel.tick_params(labelbottom=True)
        panel.set_xlabel("processor time, s")
    legend(axes.flat[len(names)], colours, markers, bool(problem.floor))
    figure.suptitle(problem.study.title)
    save(figure, path)


def draw_front(panel, all_points):
    """The Pareto front as a staircase."""
    front = [all_points[number] for number in pareto(all_points)]
    if front:
        costs, errors = zip(*front)
        panel.step(
            costs,
            [max(error, SMALLEST) for error in errors],
            where="post",
            color=style.BLACK,
            linewidth=1.2,
            zorder=1.5,
        )


def legend(panel, colours, markers, floor):
    """What colours, markers and lines mean."""
    entries = [
        Line2D([], [], color=colour, marker="s", linestyle="none", label=scheme)
        for scheme, colour in colours.items()
    ]
    entries += [
        Line2D(
            [],
            [],
            color=GREY,
            marker=marker,
            linestyle="none",
            markerfacecolor=GREY if group == PATH else "none",
            label=group,
        )
        for group, marker in markers.items()
    ]
    entries.append(Line2D([], [], color=style.BLACK, label="Pareto front"))
    if floor:
        entries.append(
            Line2D([], [], color=GREY, linestyle="--", label="what the reference leaves open")
        )
    panel.legend(handles=entries, loc="upper left", fontsize=9, borderaxespad=0)


def draw_peers(title, rows, names, path):
    """Runs of this program and of others in the numbers that both have. rows: (code, cost, errors
    by name), an empty code for runs of this one."""
    style.use()
    figure, axes = pyplot.subplots(
        1, len(names), squeeze=False, figsize=(3.7 * len(names), 4.6), sharex=True
    )
    codes = list(dict.fromkeys(code for code, _, _ in rows))
    for panel, name in zip(axes.flat, names):
        for code, colour, marker in zip(codes, COLOURS, MARKERS):
            shown = [
                (cost, max(errors[name], SMALLEST)) for other, cost, errors in rows if other == code
            ]
            if shown:
                panel.plot(*zip(*shown), marker, color=colour, linestyle="none", markersize=6)
        panel.set(xscale="log", yscale="log", title=f"{name.replace('_', ' ')}, %")
        panel.set_xlabel("processor time, s")
    # Not every code has a point in every panel: the legend is made of all codes.
    axes[0, -1].legend(
        handles=[
            Line2D([], [], color=colour, marker=marker, linestyle="none", label=code)
            for code, colour, marker in zip(codes, COLOURS, MARKERS)
        ],
        loc="center left",
        bbox_to_anchor=(1.01, 0.5),
    )
    figure.suptitle(title)
    save(figure, path)
