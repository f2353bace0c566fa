# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Curves over time: energy, contact force, momentum, probes."""

import re

import numpy

from . import style
from .problem import Problem
from .tables import require

COLOURS = {"x": style.BLUE, "y": style.ORANGE, "z": style.GREEN}


def contact_phases(time, force):
    """Intervals [a, b] of the time axis in which a contact force acts."""
    active = numpy.concatenate(([False], force > 1e-9 * max(force.max(), 1e-300), [False]))
    starts = numpy.flatnonzero(active[1:] & ~active[:-1])
    ends = numpy.flatnonzero(~active[1:] & active[:-1]) - 1
    # The force of a step acts over the step that leads to its time.
    return [(time[max(start - 1, 0)], time[end]) for start, end in zip(starts, ends)]


def shade_contact(axes, table):
    """Tint the time of contact."""
    if "contact_force" not in table or "time" not in table:
        return
    for n, (begin, end) in enumerate(contact_phases(table["time"], table["contact_force"])):
        for panel in axes:
            panel.axvspan(
                begin,
                end,
                color=style.CONTACT_SHADE,
                zorder=0,
                linewidth=0,
                label="contact" if n == 0 else None,
            )


def energy_scale(total, *parts):
    """What energies are divided by: the initial total energy, or the largest energy of a run that
    starts at rest, or nearly so."""
    largest = max(abs(part).max() for part in (total, *parts))
    if abs(total[0]) > 0.01 * largest:
        return abs(total[0]), "initial total energy"
    return (largest or 1.0), "largest energy of the run"


def energy(history):
    """Energies above, and below where the total energy is gained or lost."""
    time, kinetic, elastic, external, total = require(
        history, "time", "kinetic_energy", "elastic_energy", "external_energy", "total_energy"
    )
    scale, scale_name = energy_scale(total, kinetic, elastic, external)
    figure, axes = style.panels(2, height=3.3)
    shade_contact(axes, history)

    for part, colour, label in (
        (kinetic, style.BLUE, "kinetic"),
        (elastic, style.ORANGE, "elastic"),
        (external, style.GREEN, "of the loads"),
    ):
        if part is not external or numpy.any(part):
            style.line(axes[0], time, part / scale, colour, label)
    style.line(axes[0], time, total / scale, style.BLACK, "total", linewidth=2.4)
    axes[0].set(title="Energy", ylabel=f"energy / {scale_name}")
    style.legend_beside(axes[0])

    percent = 100.0 / scale
    style.line(
        axes[1], time, (total - total[0]) * percent, style.BLACK, "total energy", linewidth=2.4
    )
    modified = history.get("total_energy_modified", total)
    if abs(modified - total).max() > 1e-9 * scale:
        style.line(
            axes[1],
            time,
            (modified - modified[0]) * percent,
            style.GREY,
            "with the mass of\nthe scheme",
            linestyle=":",
        )
    for column, colour, label in (
        ("work_contact", style.VERMILION, "contact forces"),
        ("work_predictor", style.PURPLE, "predictor"),
        ("work_friction", style.SKY, "friction"),
        ("work_damping", style.BLUE, "damping of bodies"),
        ("work_scheme", style.GREY, "damping of the scheme"),
        ("work_external", style.GREEN, "external work"),
        ("energy_transfer", style.ORANGE, "new meshes"),
    ):
        work = history.get(column, numpy.zeros(1))
        if numpy.any(abs(work) > 1e-14 * scale):
            style.line(axes[1], time, numpy.cumsum(work) * percent, colour, label, linestyle="--")
    axes[1].axhline(0.0, color=style.GREY, linewidth=0.8, zorder=1)
    change = percent * (total[-1] - total[0])
    axes[1].set(
        title=f"Change of the total energy: {change:+.3g} % at the end, and its causes",
        ylabel=f"change in % of\n{scale_name}",
    )
    figure.supxlabel(ledger_note(history, scale, scale_name), fontsize=10, color=style.GREY)
    keep_round_off_flat(axes[1], minimum=1e-6)
    style.legend_beside(axes[1])
    return figure


def ledger_note(history, scale, scale_name):
    """How well the columns of work explain the change of the total energy."""
    if "energy_residual" not in history:
        return ""
    worst = abs(history["energy_residual"]).max() / scale
    return f"unexplained change in any step: at most {worst:.1e} of the {scale_name}"


def keep_round_off_flat(axes, minimum):
    """Do not blow up a curve of round-off to the height of the panel."""
    low, high = axes.get_ylim()
    if high - low < minimum:
        axes.set_ylim(-minimum, minimum)


def contact_force(history):
    """Total contact force above, number of active nodes below."""
    time, force, nodes = require(history, "time", "contact_force", "active_nodes")
    figure, axes = style.panels(2, heights=(2.2, 1.0))
    style.line(axes[0], time, force, style.BLUE)
    axes[0].fill_between(time, force, color=style.BLUE, alpha=0.12, linewidth=0)
    title = "Contact force"
    phases = contact_phases(time, force)
    if phases:
        peak = int(numpy.argmax(force))
        title += (
            f": largest {force[peak]:.4g} at time {time[peak]:.4g}, contact from "
            f"{phases[0][0]:.4g} to {phases[-1][1]:.4g}"
        )
        axes[0].plot(time[peak], force[peak], "o", color=style.VERMILION, markersize=6)
    else:
        title += ": none"
    axes[0].set(title=title, ylabel="sum of normal forces")
    axes[0].set_ylim(bottom=0.0)

    style.line(axes[1], time, nodes, style.VERMILION, drawstyle="steps-pre")
    axes[1].set_ylabel("nodes in contact")
    axes[1].set_ylim(0.0, max(1.0, 1.08 * nodes.max()))
    axes[1].yaxis.get_major_locator().set_params(integer=True)
    return figure


def momentum(history):
    """Linear and angular momentum, the components that are not zero throughout."""
    (time,) = require(history, "time")
    kinds = [
        (title, [name for name in history if re.fullmatch(kind + "_[xyz]", name)])
        for title, kind in (
            ("Linear momentum", "momentum"),
            ("Angular momentum", "angular_momentum"),
        )
    ]
    kinds = [(title, names) for title, names in kinds if names]
    if not kinds:
        raise Problem("the history has no column of momentum")
    figure, axes = style.panels(len(kinds))
    shade_contact(axes, history)
    negligible = 1e-9 * max(abs(history[name]).max() for _, names in kinds for name in names)
    for panel, (title, names) in zip(axes, kinds):
        shown = [name for name in names if abs(history[name]).max() > negligible]
        for name in shown:
            component = name[-1]
            style.line(panel, time, history[name], COLOURS[component], component)
        zero = ", ".join(name[-1] for name in names if name not in shown)
        panel.set(title=title + (f" ({zero}: zero)" if zero else ""), ylabel="momentum")
        if shown:
            style.legend_beside(panel)
        else:
            style.line(panel, time, 0.0 * time, style.GREY)
            panel.set_ylim(-1.0, 1.0)
            panel.set_yticks([0.0])
    return figure


def rows_of_point(table):
    """What a probe in a body has to show."""
    rows = []
    for title, quantity in (("Displacement", "displacement"), ("Velocity", "velocity")):
        components = [
            (f"{quantity}_{axis}", axis, colour)
            for axis, colour in COLOURS.items()
            if numpy.any(table.get(f"{quantity}_{axis}", 0.0))
        ]
        rows.append((title, quantity, components or [(f"{quantity}_x", "x", style.BLUE)]))
    return rows + [("Stress", "von Mises", (("von_mises", None, style.VERMILION),))]


def probe(table, name):
    """Displacement, velocity and stress of a point; of a contact node gap and displacement,
    velocity and pressure."""
    (time,) = require(table, "time")
    rows = rows_of_point(table) if "von_mises" in table else rows_of_contact_node()
    rows = [row for row in rows if any(column in table for column, _, _ in row[2])]
    if not rows:
        raise Problem(
            f"the table of probe {name} has none of the columns gap, normal_displacement, "
            "normal_velocity, pressure"
        )
    figure, axes = style.panels(len(rows), height=2.5)
    figure.suptitle(f"Probe {name}", x=0.01, ha="left", fontsize=14)
    for panel, (title, ylabel, curves) in zip(axes, rows):
        for column, label, colour in curves:
            if column in table:
                style.line(panel, time, table[column], colour, label)
        panel.axhline(0.0, color=style.GREY, linewidth=0.8, zorder=1)
        panel.set(title=title, ylabel=ylabel)
        if curves[0][1]:
            panel.legend(loc="best")
    return figure


def rows_of_contact_node():
    """What a probe on a contact surface has to show."""
    return [
        (
            "Position",
            "distance",
            (
                ("gap", "gap", style.BLUE),
                ("normal_displacement", "normal displacement", style.ORANGE),
            ),
        ),
        ("Normal velocity", "velocity", (("normal_velocity", None, style.GREEN),)),
        ("Contact pressure", "pressure", (("pressure", None, style.VERMILION),)),
    ]
