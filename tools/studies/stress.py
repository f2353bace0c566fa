# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The contact pressure on a surface whose normal is about the z-axis, at one time."""

import dataclasses
import math

import numpy

from plotting import fields
from plotting.problem import Problem

#: Radii of nodes closer than this to that of the outermost one are the rim, where the pressure is
#: that of partly loaded faces.
RIM = 0.9


@dataclasses.dataclass
class Pressure:
    """Nodal values, each node once."""

    points: numpy.ndarray  # (nodes, 3), reference configuration
    faces: numpy.ndarray  # (faces, 4)
    values: numpy.ndarray  # (nodes)

    def radii(self):
        """Distances of the nodes from the middle of the pressed ones, seen along z."""
        pressed = self.points[self.values > 0, :2]
        return numpy.hypot(
            *(self.points[:, :2] - (pressed.mean(axis=0) if len(pressed) else 0.0)).T
        )

    def scatter(self):
        """Deviation of the pressure from the best p = a + b r^2 + c r^4 within the rim (r.m.s.),
        over the mean pressure."""
        radius, pressed = self.radii(), self.values > 0
        if not pressed.any():
            return math.nan
        inside = pressed & (radius < RIM * radius[pressed].max())
        if len(numpy.unique(radius[inside].round(6))) < 5:  # three coefficients would fit anything
            return math.nan
        powers = numpy.stack([radius[inside] ** k for k in (0, 2, 4)], axis=1)
        best = numpy.linalg.lstsq(powers, self.values[inside], rcond=None)[0]
        return float(
            numpy.sqrt(numpy.mean((self.values[inside] - powers @ best) ** 2))
            / self.values[pressed].mean()
        )


def read_pressure(folder, time):
    """The pressure at a time of which fields were written, or None."""
    try:
        series = dict(fields.read_series(folder / "surface.pvd"))
        nearest = min(series, key=lambda other: abs(other - time))
        if abs(nearest - time) > 1e-6 * max(series):
            return None
        surface = fields.read_fields(series[nearest])
    except Problem:
        return None
    size = numpy.ptp(surface.points, axis=0).max() or 1.0
    _, first, node = numpy.unique(
        (surface.points / size).round(7), axis=0, return_index=True, return_inverse=True
    )
    return Pressure(
        surface.points[first], node.reshape(-1)[surface.cells], surface.at_points("CPRESS")[first]
    )
