# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The deformed bodies: von Mises stress in the upper row, contact pressure in the lower row."""

from matplotlib import pyplot

from . import bodies_2d, bodies_3d, obstacles
from .moments import read_moments

HEXAHEDRON = 8


def bodies(directory, history):
    """One column for each moment."""
    moments = read_moments(directory, history)
    views, walls = views_of(moments), obstacles.read_obstacles(directory)
    rows = 1 + has_surface(moments)
    figure, axes = pyplot.subplots(
        rows,
        len(moments),
        squeeze=False,
        figsize=(4.2 * len(moments) + 0.8, 4.2 * rows),
    )
    views.draw_stress(axes[0], moments, walls)
    if rows > 1:
        views.draw_pressure(axes[1], moments, walls)
    for panel, moment in zip(axes[0], moments):
        panel.set_title(moment.title)
    for panel in axes.flat:
        finish_panel(panel)
    return figure


def views_of(moments):
    """The functions that draw bodies of this dimension."""
    return bodies_3d if moments[0].volume.cells.shape[1] == HEXAHEDRON else bodies_2d


def has_surface(moments):
    """Whether the contact surface is known at all of them."""
    return all(moment.surface is not None for moment in moments)


def finish_panel(panel):
    """No axes: there is nothing to be read off."""
    panel.set(aspect="equal", xticks=[], yticks=[])
    panel.grid(False)
    panel.spines[:].set_visible(False)
