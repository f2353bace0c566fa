# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Views of two-dimensional bodies."""

import numpy
from matplotlib import colors
from matplotlib.collections import LineCollection, PolyCollection

from . import obstacles, style
from .moments import (
    BODY,
    PRESSURE_MAP,
    STRESS_MAP,
    colour_scale,
    same_view,
    surroundings,
    von_mises,
)


def draw_stress(panels, moments, walls):
    """The deformed cells."""
    stresses = [von_mises(moment) for moment in moments]
    scale = colour_scale(panels, stresses, STRESS_MAP, "von Mises stress")
    for panel, moment, stress in zip(panels, moments, stresses):
        draw_cells(panel, moment, scale.to_rgba(stress)[:, :3])
    finish(panels, moments, walls)


def draw_pressure(panels, moments, walls):
    """The pressure as a hill that stands on the contact surface."""
    pressures = [moment.surface.at_points("CPRESS") for moment in moments]
    scale = colour_scale(panels, pressures, PRESSURE_MAP, "contact pressure")
    height = 0.25 * surroundings(moments)[1] / scale.norm.vmax
    for panel, moment, pressure in zip(panels, moments, pressures):
        draw_cells(panel, moment, numpy.array([colors.to_rgb(BODY)]))
        draw_hill(panel, moment, pressure, height, scale)
        edges = moment.surface_positions[moment.surface.cells][:, :, :2]
        panel.add_collection(LineCollection(edges, colors=style.BLACK, linewidths=1.2))
    finish(panels, moments, walls)


def draw_hill(panel, moment, pressure, height, scale, pieces=6):
    """Each edge with pressure carries a strip into the body: outside is the obstacle."""
    pressed = pressure[moment.surface.cells].max(axis=1) > 1e-3 * scale.norm.vmax
    edges = moment.surface.cells[pressed]
    feet = moment.surface_positions[edges][:, :, :2]
    tops = feet + (height * pressure[:, None] * inner_normals(moment))[edges]
    values = pressure[edges]
    for n in range(pieces):
        start, end = n / pieces, (n + 1) / pieces
        (a, d), (b, c) = [
            [(1.0 - s) * ends[:, 0] + s * ends[:, 1] for ends in (feet, tops)] for s in (start, end)
        ]
        middle = 0.5 * (start + end)
        colours = scale.to_rgba((1.0 - middle) * values[:, 0] + middle * values[:, 1])
        panel.add_collection(
            PolyCollection(
                numpy.stack([a, b, c, d], axis=1),
                facecolors=colours,
                edgecolors=colours,
                linewidths=0.3,
            )
        )


def inner_normals(moment):
    """At each point of the surface, into the body, averaged over the edges that meet there."""
    edges = moment.surface.cells
    ends = moment.surface_positions[edges][:, :, :2]
    along = ends[:, 1] - ends[:, 0]
    normal = numpy.stack([along[:, 1], -along[:, 0]], axis=1)
    centres = moment.positions[moment.volume.cells].mean(axis=1)[:, :2]
    for n, middle in enumerate(ends.mean(axis=1)):
        nearest = centres[numpy.argmin(((centres - middle) ** 2).sum(axis=1))]
        normal[n] *= 1.0 if normal[n] @ (nearest - middle) > 0 else -1.0
    size = numpy.ptp(moment.positions, axis=0).max() or 1.0
    same = numpy.unique(
        numpy.round(moment.surface.points[:, :2] / size * 1e5), axis=0, return_inverse=True
    )[1].ravel()
    total = numpy.zeros((same.max() + 1, 2))
    for end in (0, 1):
        numpy.add.at(total, same[edges[:, end]], normal)
    total /= numpy.maximum(numpy.linalg.norm(total, axis=1, keepdims=True), 1e-300)
    return total[same]


def draw_cells(panel, moment, colours):
    corners = moment.positions[moment.volume.cells][:, :, :2]
    panel.add_collection(
        PolyCollection(corners, facecolors=colours, edgecolors=0.85 * colours, linewidths=0.35)
    )


def finish(panels, moments, walls):
    """Obstacles, and the same part of the plane in each panel."""
    middle, size = surroundings(moments)
    for panel, moment in zip(panels, moments):
        for wall in walls:
            obstacles.draw_2d(panel, wall, middle[:2], 2.0 * size)
        if moment.moving_walls:
            obstacles.draw_moving_2d(panel, moment.moving_walls)
    same_view(panels, [moment.positions[:, :2] for moment in moments])
