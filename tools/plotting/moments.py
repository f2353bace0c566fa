# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The moments of a run that are drawn, and what their panels share."""

import dataclasses

import numpy
from matplotlib import cm, colors

from . import fields as vtu
from .problem import Problem

# Both maps start at the grey of a body without load and darken steadily, so that they also work in
# grey print.
BODY = "#E6E8EB"
STRESS_MAP = colors.LinearSegmentedColormap.from_list(
    "stress", [BODY, "#B5DCC9", "#5BBBC2", "#2C7FB8", "#253494", "#0B1A4F"]
)
PRESSURE_MAP = colors.LinearSegmentedColormap.from_list(
    "pressure", [BODY, "#FBD18B", "#F58A4B", "#D3436E", "#7B2382", "#2D115F"]
)


@dataclasses.dataclass
class Moment:
    """What is drawn in one column."""

    title: str
    volume: vtu.Fields
    surface: vtu.Fields  # None if there is no surface series
    positions: numpy.ndarray
    surface_positions: numpy.ndarray
    moving_walls: vtu.Fields = None  # the obstacles that move, where they are; None: none is known


def read_moments(directory, history):
    """The start, the moment of the largest contact force, and the end."""
    return [read_moment(*entry) for entry in choose(directory, history)]


def choose(directory, history):
    """(title, volume file, surface file, file of moving obstacles) of up to three moments."""
    series = vtu.read_series(directory / "volume.pvd")
    surface, walls = (by_time(directory / name) for name in ("surface.pvd", "obstacles.pvd"))
    times = numpy.array([time for time, _ in series])
    wanted = [("start", 0), ("end", len(series) - 1)]
    if history and "contact_force" in history and history["contact_force"].max() > 0:
        peak = history["time"][numpy.argmax(history["contact_force"])]
        nearest = int(numpy.argmin(abs(times - peak)))
        # Fields are not written in every step.
        exact = abs(times[nearest] - peak) <= 1e-6 * abs(times[-1])
        wanted.append((("" if exact else "near the ") + "largest contact force", nearest))
    chosen = {}
    for title, n in wanted:
        chosen.setdefault(n, f"{title}, time {times[n]:.4g}")
    return [
        (chosen[n], series[n][1], surface.get(series[n][0]), walls.get(series[n][0]))
        for n in sorted(chosen)
    ]


def by_time(path):
    """The files of a series; none if there is no such series."""
    try:
        return dict(vtu.read_series(path))
    except Problem:
        return {}


def fields_or_none(path):
    """What may be missing."""
    try:
        return path and vtu.read_fields(path)
    except Problem:
        return None


def read_moment(title, volume_file, surface_file, walls_file=None):
    """The fields of one column."""
    volume, surface = vtu.read_fields(volume_file), fields_or_none(surface_file)
    return Moment(
        title,
        volume,
        surface,
        volume.points + volume.displacement(),
        surface and surface.points + surface.displacement(),
        fields_or_none(walls_file),
    )


def von_mises(moment):
    """One value per cell; zero where the series has no stress."""
    values = moment.volume.at_cells("von_mises")
    return numpy.zeros(len(moment.volume.cells)) if values is None else values


def colour_scale(panels, arrays, colour_map, label):
    """One scale for a row of panels, with its bar."""
    largest = max((float(array.max()) for array in arrays if len(array)), default=0.0)
    scale = cm.ScalarMappable(colors.Normalize(0.0, largest if largest > 0.0 else 1.0), colour_map)
    panels[0].figure.colorbar(scale, ax=list(panels), label=label, shrink=0.75, pad=0.02, aspect=25)
    return scale


def same_view(panels, points):
    """Show the same part of the plane in each panel: all the bodies at all the moments."""
    low = numpy.min([p.min(axis=0) for p in points], axis=0)
    high = numpy.max([p.max(axis=0) for p in points], axis=0)
    margin = 0.1 * max(high - low)
    for panel in panels:
        panel.set(
            xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin)
        )


def surroundings(moments):
    """Middle and size of what the bodies pass through."""
    points = numpy.concatenate([moment.positions for moment in moments])
    return 0.5 * (points.min(axis=0) + points.max(axis=0)), numpy.ptp(points, axis=0).max()
