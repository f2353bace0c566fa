# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Obstacles as far as the copy of the scene in the output directory tells them."""

import dataclasses
import re

import numpy
from matplotlib.collections import LineCollection
from matplotlib.patches import Circle, Polygon

from . import solids

COLOUR = "#D5DBE3"
EDGE = "#6B7280"
#: Keys of what moves an obstacle, which is zero by default.
MOTIONS = ("Motion", "Velocity", "Angular velocity")


@dataclasses.dataclass
class Obstacle:
    """Section `Obstacles/<name>` of the scene; vectors have three components."""

    shape: str
    point: numpy.ndarray
    normal: numpy.ndarray
    centre: numpy.ndarray
    axis: numpy.ndarray
    radius: float
    bodies_inside: bool


def read_obstacles(directory):
    """Obstacles of the first .prm in the directory that has some; no .prm, no obstacles. Those that
    move are not among them: where they are is in the series obstacles.pvd."""
    for path in sorted(directory.glob("*.prm"), key=lambda path: "parameters" not in path.name):
        try:
            sections = read_sections(path.read_text(encoding="utf-8"))
            names = sections.get(("Obstacles",), {}).get("Names", "")
            found = [sections.get(("Obstacles", name.strip())) for name in names.split(",")]
            obstacles = [obstacle_from(values) for values in found if values and not moves(values)]
        except (OSError, ValueError):
            continue
        if any(found):
            return obstacles
    return []


def moves(values):
    """Whether an obstacle moves by the keys of its section."""
    return any(re.search(r"[^0.;,\s]", values.get(key, "")) for key in MOTIONS)


def obstacle_from(values):
    """An obstacle from the keys of its section."""

    def vector(key, default="0"):
        numbers = [float(entry) for entry in values.get(key, default).split(",")]
        return numpy.array(numbers + [0.0] * (3 - len(numbers)))

    def direction(key):
        length = numpy.linalg.norm(vector(key))
        return vector(key) / length if length > 0 else numpy.array([0.0, 0.0, 1.0])

    return Obstacle(
        values.get("Shape", "plane"),
        vector("Point"),
        direction("Normal"),
        vector("Centre"),
        direction("Axis"),
        float(values.get("Radius", "1")),
        values.get("Bodies inside", "false") == "true",
    )


def read_sections(text):
    """{path of a section: {key: value}} of a .prm."""
    sections, path = {}, ()
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        word, _, rest = line.partition(" ")
        if word == "subsection":
            path += (rest.strip(),)
        elif word == "end":
            path = path[:-1]
        elif word == "set" and "=" in rest:
            key, _, value = rest.partition("=")
            sections.setdefault(path, {})[key.strip()] = value.strip()
    return sections


def draw_2d(axes, obstacle, centre, reach):
    """Filled half plane or disc behind the bodies."""
    look = {"facecolor": COLOUR, "edgecolor": EDGE, "linewidth": 1.2, "zorder": 0}
    if obstacle.shape == "plane":
        normal = obstacle.normal[:2]
        along = numpy.array([-normal[1], normal[0]])
        foot = centre - normal * numpy.dot(centre - obstacle.point[:2], normal)
        axes.add_patch(
            Polygon(
                [
                    foot - reach * along,
                    foot + reach * along,
                    foot + reach * (along - normal),
                    foot - reach * (along + normal),
                ],
                **look
            )
        )
    elif obstacle.shape == "sphere":
        axes.add_patch(
            Circle(obstacle.centre[:2], obstacle.radius, fill=not obstacle.bodies_inside, **look)
        )


def draw_moving_2d(axes, walls):
    """The outlines of obstacles that move, at one moment."""
    axes.add_collection(
        LineCollection(walls.points[walls.cells][:, :, :2], colors=EDGE, linewidths=1.2, zorder=0)
    )


def moving_faces_3d(walls):
    """The surfaces of obstacles that move as faces to be painted; normals away from the middle."""
    corners = walls.points[walls.cells]
    if corners.shape[1] == 3:
        corners = numpy.concatenate([corners, corners[:, -1:]], axis=1)
    normals = unit_rows(
        numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    )
    middles = corners.mean(axis=1)
    inwards = numpy.einsum("ij,ij->i", normals, middles - middles.mean(axis=0)) < 0.0
    normals[inwards] *= -1.0
    return solids.Faces(corners, normals, numpy.zeros(len(corners), dtype=int))


def faces_3d(obstacle, centre, reach):
    """Surface of an obstacle near the bodies as faces to be painted, or None."""
    if obstacle.bodies_inside:
        return None
    if obstacle.shape == "plane":
        return plane(obstacle.point, obstacle.normal, centre, reach)
    if obstacle.shape == "sphere":
        return sphere(obstacle.centre, obstacle.radius)
    if obstacle.shape == "cylinder":
        return cylinder(obstacle.point, obstacle.axis, obstacle.radius, centre, reach)
    return None


def plane(point, normal, centre, reach):
    foot = centre - normal * numpy.dot(centre - point, normal)
    across, along = frame(normal)
    grid = numpy.linspace(-reach, reach, 13)
    points = foot + grid[:, None, None] * across + grid[None, :, None] * along
    return patches(points, lambda middles: numpy.tile(normal, (len(middles), 1)))


def sphere(centre, radius):
    polar, azimuth = numpy.linspace(0, numpy.pi, 25)[:, None], numpy.linspace(0, 2 * numpy.pi, 49)
    unit = numpy.stack(
        [
            numpy.sin(polar) * numpy.cos(azimuth),
            numpy.sin(polar) * numpy.sin(azimuth),
            numpy.cos(polar) * numpy.ones_like(azimuth),
        ],
        axis=-1,
    )
    return patches(centre + radius * unit, lambda middles: unit_rows(middles - centre))


def cylinder(point, axis, radius, centre, reach):
    foot = point + axis * numpy.dot(centre - point, axis)
    across, along = frame(axis)
    angle = numpy.linspace(0, 2 * numpy.pi, 49)[None, :, None]
    points = (
        foot
        + numpy.linspace(-reach, reach, 13)[:, None, None] * axis
        + radius * (numpy.cos(angle) * across + numpy.sin(angle) * along)
    )
    return patches(
        points,
        lambda middles: unit_rows(middles - foot - numpy.outer((middles - foot) @ axis, axis)),
    )


def frame(normal):
    """Two unit vectors that complete a normal to an orthogonal frame."""
    across = numpy.cross(normal, numpy.eye(3)[numpy.argmin(abs(normal))])
    across /= numpy.linalg.norm(across)
    return across, numpy.cross(normal, across)


def unit_rows(vectors):
    return vectors / numpy.maximum(numpy.linalg.norm(vectors, axis=1, keepdims=True), 1e-300)


def patches(points, normals):
    """Quadrilaterals of a rectangular grid of points."""
    corners = numpy.stack(
        [points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]], axis=2
    ).reshape(-1, 4, 3)
    return solids.Faces(
        corners, normals(corners.mean(axis=1)), numpy.zeros(len(corners), dtype=int)
    )
