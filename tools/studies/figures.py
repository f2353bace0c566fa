# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Figures that put schemes side by side: panel (a), (b), (c) for each group of them."""

import textwrap

import numpy
from matplotlib import pyplot

from plotting import style
from plotting.moments import PRESSURE_MAP

from .observe import approach, during_contact, touching, zigzag

COLOURS = (
    style.VERMILION,
    style.BLUE,
    style.GREEN,
    style.PURPLE,
    style.ORANGE,
    style.SKY,
    style.BLACK,
)
#: Forces with more zigzag than this are drawn thin; velocities beyond so many speeds of approach
#: are cut off.
WILD, FAST = 0.3, 6.0
GROUPS = {"a": "standard mass", "b": "redistributed mass", "c": "beyond the paper"}


def groups_of(pairs):
    """The (variant, result) that did not fail, by group, each with its own colour in the group."""
    members = {}
    for variant, result in pairs:
        members.setdefault(variant.group, []).append((variant, result))
    coloured = {
        name: [
            (variant, result, COLOURS[n % len(COLOURS)])
            for n, (variant, result) in enumerate(pairs)
            if result
        ]
        for name, pairs in members.items()
    }
    return {name: lines for name, lines in coloured.items() if lines}


def label(variant):
    """The name in a legend, with that of the paper."""
    return variant.name + (f" ({variant.paper})" if variant.paper else "")


def legend_below(axes):
    """A legend below the panel."""
    axes.legend(loc="upper left", bbox_to_anchor=(-0.05, -0.24), fontsize=9, borderaxespad=0)


def columns(n, rows=1, height=4.6, **options):
    """A row of n panels that share axes."""
    return pyplot.subplots(
        rows, n, squeeze=False, sharex=True, figsize=(4.2 * n + 0.6, height), **options
    )


def title(name):
    """Heading of the panel of a group."""
    return f"({name}) {GROUPS.get(name, name)}"


def compare_lines(groups, column, ylabel):
    """One panel for each group, all with the same scale."""
    figure, axes = columns(len(groups), sharey=True)
    for panel, (name, lines) in zip(axes[0], groups.items()):
        for variant, result, colour in lines:
            wild = (
                zigzag(during_contact(result)) > WILD
            )  # thin and behind, so that it does not hide the others
            style.line(
                panel,
                result["time"],
                result[column],
                colour,
                label(variant),
                linewidth=0.8 if wild else 1.5,
                zorder=1.5 if wild else 2,
            )
        panel.set(title=title(name), xlabel="time")
        legend_below(panel)
    axes[0, 0].set_ylabel(ylabel)
    return figure


def force(groups):
    """The total contact force, as in figure 2 of the paper."""
    return compare_lines(groups, "contact_force", "total contact force")


def energy(groups):
    """The change of the energy, as in figure 3; where the scheme has its own mass, of both."""
    panels = []
    for name, lines in groups.items():
        panels.append((title(name), "total_energy", lines))
        if any(differs(result) for _, result, _ in lines):
            panels.append(
                (title(name) + ",\nenergy with that mass", "total_energy_modified", lines)
            )
    figure, axes = columns(len(panels))
    for panel, (heading, column, lines) in zip(axes[0], panels):
        for variant, result, colour in lines:
            values = numpy.array(result[column])
            style.line(
                panel,
                result["time"],
                100 * (values / (values[0] or 1.0) - 1),
                colour,
                label(variant),
                linewidth=1.5,
            )
        panel.set(title=heading, xlabel="time")
        if numpy.ptp(panel.get_ylim()) < 1e-6:
            panel.set_ylim(-1e-6, 1e-6)
        legend_below(panel)
    axes[0, 0].set_ylabel("change of the energy in %")
    return figure


def differs(result):
    """Whether the scheme has a mass of its own."""
    own, standard = numpy.array(result["total_energy_modified"]), numpy.array(
        result["total_energy"]
    )
    return bool(numpy.any(abs(own - standard) > 1e-9 * abs(standard).max()))


def displacement(groups):
    """The normal displacement of the probe, as in figure 4; below, its way beyond the gap."""
    figure, axes = columns(len(groups), rows=2, height=7.6, sharey="row")
    for (upper, lower), (name, lines) in zip(axes.T, groups.items()):
        for variant, result, colour in lines:
            if not result.probe:
                continue
            time, way = result.probe["time"], approach(result) * result["step_size"][-1]
            style.line(upper, time, result.probe["normal_displacement"], colour, linewidth=1.3)
            style.line(
                lower,
                time,
                -numpy.array(result.probe["gap"]) / (way or 1.0),
                colour,
                label(variant),
                linewidth=1.3,
            )
        if lines[0][1].probe:
            start = lines[0][1].probe
            upper.axhline(
                start["gap"][0] + start["normal_displacement"][0],
                color=style.BLACK,
                linewidth=0.9,
                linestyle="--",
            )
        lower.axhline(0.0, color=style.BLACK, linewidth=0.9, linestyle="--")
        lower.set(ylim=(-1.0, 1.0), xlabel="time")
        upper.set_title(title(name))
        legend_below(lower)
    axes[0, 0].set_ylabel("relative normal displacement\n(dashed: gap)")
    axes[1, 0].set_ylabel("beyond the gap,\nin steps of approach")
    return figure


def velocity(groups):
    """The relative normal velocity of the probe, as in figure 5, a panel for each scheme; positive
    when it moves away."""
    rows = max(map(len, groups.values()))
    # Without the layout engine, which would make rows with an axis of time higher than the others.
    figure, axes = columns(
        len(groups), rows=rows, height=1.45 * rows + 0.8, sharey=True, layout="none"
    )
    figure.subplots_adjust(
        left=0.075,
        right=0.99,
        top=1 - 0.7 / (1.45 * rows + 0.8),
        bottom=0.5 / (1.45 * rows + 0.8),
        hspace=0.5,
        wspace=0.06,
    )
    for column, (name, lines) in zip(axes.T, groups.items()):
        for panel in column[len(lines) :]:
            panel.set_visible(False)
        column[0].annotate(title(name), (0.0, 1.35), xycoords="axes fraction", fontsize=13)
        for panel, (variant, result, colour) in zip(column, lines):
            panel.set_title(variant.name, fontsize=10, pad=3)
            panel.tick_params(labelbottom=panel is column[len(lines) - 1])
            if result.probe:
                style.line(
                    panel,
                    result.probe["time"],
                    -numpy.array(result.probe["normal_velocity"]),
                    colour,
                    linewidth=0.9,
                )
                shade(panel, result)
    cut_off(
        axes[0, 0], [result for lines in groups.values() for _, result, _ in lines if result.probe]
    )
    figure.supxlabel("time", fontsize=12)
    figure.supylabel("relative normal velocity", fontsize=12)
    return figure


def cut_off(panel, results):
    """Keep what grows without bound from flattening all others."""
    if results:
        low, high = panel.get_ylim()
        limit = FAST * max(map(approach, results))
        panel.set_ylim(max(low, -limit), min(high, limit))


def shade(panel, result):
    """Tint the contact of the probe."""
    rows = touching(result)
    if rows:
        panel.axvspan(
            result.probe["time"][max(rows[0] - 1, 0)],
            result.probe["time"][rows[1]],
            color=style.CONTACT_SHADE,
            zorder=0,
            linewidth=0,
        )


def small_multiples(pairs, across, **options):
    """A grid of panels, one for each (variant, pressure), those without one left out."""
    shown = [
        (variant, pressure)
        for variant, pressure in pairs
        if pressure is not None and (pressure.values > 0).any()
    ]
    if not shown:
        return None, None, []
    down = -(-len(shown) // across)
    figure, axes = pyplot.subplots(
        down,
        across,
        squeeze=False,
        sharex=True,
        sharey=True,
        figsize=(2.5 * across + 0.8, 2.6 * down + 0.3),
        **options,
    )
    for panel in axes.flat[len(shown) :]:
        panel.set_visible(False)
    for panel, (variant, _) in zip(axes.flat, shown):
        panel.set_title(
            textwrap.fill(variant.name, 28, break_on_hyphens=False, break_long_words=False),
            fontsize=9,
            pad=3,
        )
    return figure, axes, shown


def pressure_over_radius(pairs):
    """The contact pressure over the distance from the middle, a dot for each node, as a section
    through figure 6."""
    figure, axes, shown = small_multiples(pairs, 5)
    for panel, (_, pressure) in zip(axes.flat if shown else (), shown):
        pressed = pressure.values > 0
        panel.plot(
            pressure.radii()[pressed],
            pressure.values[pressed],
            "o",
            color=style.BLUE,
            markersize=2.5,
        )
        panel.set_ylim(bottom=0.0)
    if shown:
        figure.supxlabel("distance from the middle", fontsize=12)
        figure.supylabel("contact pressure", fontsize=12)
    return figure


def pressure_from_above(pairs):
    """The contact pressure as colour, as in figure 6."""
    figure, axes, shown = small_multiples(pairs, 5, subplot_kw={"aspect": "equal"})
    if not shown:
        return None
    # The classical scheme may have twice the pressure of all others and would leave them pale.
    top = numpy.median([pressure.values.max() for _, pressure in shown]) * 1.15
    reach = (
        1.1 * max(pressure.radii()[pressure.values > 0].max() for _, pressure in shown) or 1.0
    )  # a single node has no radius
    for panel, (_, pressure) in zip(axes.flat, shown):
        middle = pressure.points[pressure.values > 0, :2].mean(axis=0)
        x, y = (pressure.points[:, :2] - middle).T
        near = (pressure.values[pressure.faces] > 0).any(axis=1)
        triangles = numpy.concatenate(
            [pressure.faces[near][:, [0, 1, 2]], pressure.faces[near][:, [0, 2, 3]]]
        )
        colours = panel.tricontourf(
            x,
            y,
            triangles,
            pressure.values,
            levels=numpy.linspace(0.0, top, 15),
            cmap=PRESSURE_MAP,
            extend="max",
        )
        panel.set(xlim=(-reach, reach), ylim=(-reach, reach), xticks=[], yticks=[])
        panel.grid(False)
        panel.spines[:].set_visible(False)
    figure.colorbar(
        colours, ax=list(axes.flat), label="contact pressure", shrink=0.6, format="%.0f"
    )
    return figure
