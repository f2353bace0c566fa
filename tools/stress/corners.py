# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Scenes with corners and edges, and scenes that are nearly singular: what holds a body there is
little, or nothing."""

import math

from .scene import Scene, point, vector
from .scenes import MOST_PROBES, changed, floor, impact, probes, rest


def corner(angle, **what):
    """A box lands on the corner about which it is turned, by an angle from 0 to 90 degrees."""
    scene = impact(**what)
    turned = math.radians(angle)
    keys = {
        "Bodies/upper/Rotation": angle,
        "Bodies/upper/Rotation centre": point(0.0, 0.0),
    }
    parts = MOST_PROBES - 1
    edge = [(math.cos(turned) * n / parts, math.sin(turned) * n / parts) for n in range(parts + 1)]
    return changed(scene, {**keys, **probes(edge)})


def corner_on_floor(angle):
    """A square lands on its corner, on a floor."""
    return corner(angle)


def corner_on_body(angle):
    """A square lands on its corner, on the face of another body; the corner is slave."""
    return corner(angle, master=(4, 3))


def corner_below(angle):
    """The same, but the face is the slave, and has the corner between its nodes."""
    scene = corner(angle, master=(6, 3))
    face = probes([(-0.25 + 0.25 * n, 0.0) for n in range(7)])
    return changed(scene, {"Contact/Pairs": "lower : upper", **face})


def edge_of_floor(overlap):
    """A box lands on a floor that ends; so much of its width is above it."""
    scene = impact(steps=60)
    keys = {"Obstacles/floor/Point": point(overlap - 1.0, 0.0), "Obstacles/floor/Extent": 2.0}
    return changed(scene, keys)


def edge_on_edge(overlap):
    """Two boxes of which so much of the width is above each other."""
    scene = impact(master=(4, 4))
    keys = {
        "Bodies/lower/Lower corner": point(overlap - 1.5, -1.0),
        "Bodies/lower/Upper corner": point(overlap, 0.0),
    }
    return changed(scene, keys)


def overhang(support):
    """A box rests on a floor that carries so much of its width; less than one half tips it."""
    keys = {"Obstacles/floor/Point": point(support - 1.0, 0.0), "Obstacles/floor/Extent": 2.0}
    return changed(rest(gravity=1e-4, cells=(8, 8)), keys)


def slope(excess):
    """A block rests on a slope; the coefficient of friction is that of the limit and so much more
    of it."""
    gravity, angle = 1e-3, math.radians(20)
    scene = rest(friction=math.tan(angle) * (1 + excess), courant=10.0)
    force = vector(gravity * math.sin(angle), -gravity * math.cos(angle))
    return changed(scene, {"Bodies/upper/Body force": force})


def cap(radius):
    """The bottom becomes part of a circle; one of half the width would make cells without area."""
    return changed(
        impact(), {"Bodies/upper/Cap radius": radius / 2, "Bodies/upper/Cap boundary": 2}
    )


def funnel(angle):
    """A square between two walls that include an angle, in degrees; small ones wedge it."""
    scene = impact(speed=0.003, gap=0.0)
    half = math.radians(angle / 2)
    normal, keys = (math.cos(half), math.sin(half)), floor(2)
    walls = {
        "Obstacles/Names": "left, right",
        "Obstacles/left/Point": point(-1e-9, 0.0),
        "Obstacles/left/Normal": point(*normal),
        "Obstacles/right/Point": point(1.0 + 1e-9, 0.0),
        "Obstacles/right/Normal": point(-normal[0], normal[1]),
        "Contact/Pairs": "upper[0] : left, upper[1] : right",
    }
    kept = {key: v for key, v in scene.settings.items() if key not in keys}
    sides = probes([(x, y) for x in (0.0, 1.0) for y in (0.0, 0.5, 1.0)])
    return Scene({**kept, **walls, **sides})


def soft_support(stiffness):
    """A box rests on another one, which is held, so much less stiff."""
    keys = {
        "Bodies/lower/Young's modulus": stiffness,
        "Bodies/lower/Dirichlet": "2: " + vector(0, 0),
    }
    return changed(rest(gravity=1e-3 * stiffness, master=(4, 3)), keys)


ANGLES = (0.0, 1e-9, 1e-3, 1.0, 30.0, 44.999999, 45.0)
OVERLAPS = (0.5, 0.1, 1e-3, 1e-9, 0.0, -1e-9)
#: Name, quantity, values and builder of each family.
ROWS = [
    ("corner", "angle", ANGLES, corner_on_floor),
    ("corner-on-body", "angle", ANGLES, corner_on_body),
    ("corner-as-master", "angle", ANGLES, corner_below),
    ("edge-of-floor", "overlap", OVERLAPS, edge_of_floor),
    ("edge-on-edge", "overlap", OVERLAPS, edge_on_edge),
    ("overhang", "support", (1.0, 0.7, 0.51, 0.5, 0.49, 0.2), overhang),
    ("slope", "friction above limit", (0.1, 1e-3, 1e-9, 0.0, -1e-9, -1e-3, -0.1), slope),
    ("cap", "radius / half width", (20.0, 2.0, 1.1, 1.001, 1.000001, 1.0, 0.9), cap),
    ("funnel", "angle", (90.0, 30.0, 5.0, 0.1, 0.0), funnel),
    ("soft-support", "stiffness", (1.0, 1e-3, 1e-6, 1e-9, 1e-12), soft_support),
]
