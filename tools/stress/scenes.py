# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Small scenes that the sweeps change: a box is thrown onto a floor or onto another box, or lies
there under its weight. Lengths, densities and moduli are 1 where nothing else is said."""

import math

from .scene import Scene, point, vector

POISSON = 0.3
#: Of compression, with E = 1, density 1 and POISSON.
WAVE_SPEED = math.sqrt((1 - POISSON) / (1 + POISSON) / (1 - 2 * POISSON))
FLOOR, BODIES = "upper : floor", "upper : lower"
#: Probes along one edge, at most.
MOST_PROBES = 5


def box(name, lower, upper, cells):
    """The keys of a box of this material."""
    return {
        f"Bodies/{name}/Shape": "box",
        f"Bodies/{name}/Lower corner": point(*lower),
        f"Bodies/{name}/Upper corner": point(*upper),
        f"Bodies/{name}/Repetitions": point(*cells),
        f"Bodies/{name}/Young's modulus": 1.0,
        f"Bodies/{name}/Poisson's ratio": POISSON,
        f"Bodies/{name}/Density": 1.0,
    }


def probes(places):
    """Probes of contact near these points."""
    keys = {"Probes/Names": ", ".join(f"p{n}" for n in range(len(places)))}
    keys.update({f"Probes/p{n}/Point": point(*place) for n, place in enumerate(places)})
    return keys


def bottom(lower, upper, cells):
    """Points of the lower side of a box at its nodes, or some of them."""
    along = []
    for low, high, count in list(zip(lower, upper, cells))[:-1]:
        parts = min(count, MOST_PROBES - 1)
        along.append([low + (high - low) * n / parts for n in range(parts + 1)])
    if len(along) == 1:
        return [(x, lower[-1]) for x in along[0]]
    return [(x, y, lower[-1]) for x in along[0] for y in along[1]]


def times(step, steps):
    """The keys of so many steps."""
    return {"Time/Step size": step, "Time/End time": step * steps}


def upwards(dimension):
    """The normal of a floor."""
    return [0.0] * (dimension - 1) + [1.0]


def floor(dimension, height=0.0):
    """The keys of a floor."""
    up = upwards(dimension)
    return {
        "Obstacles/Names": "floor",
        "Obstacles/floor/Point": point(*(height * n for n in up)),
        "Obstacles/floor/Normal": point(*up),
        "Contact/Pairs": FLOOR,
    }


def below(dimension, cells, height=1.0):
    """The keys of a second box, somewhat wider, on whose top the first one lands."""
    lower = [-0.25] * (dimension - 1) + [-height]
    upper = [1.25] * (dimension - 1) + [0.0]
    keys = {"Bodies/Names": "upper, lower", **box("lower", lower, upper, cells)}
    return {**keys, "Contact/Pairs": BODIES}


def impact(
    dimension=2,
    cells=(4, 4, 4),
    edges=(1.0, 1.0, 1.0),
    courant=1.0,
    speed=0.01,
    sideways=0.0,
    gap=None,
    steps=40,
    friction=0.0,
    master=None,
):
    """A box is thrown down with a speed in wave speeds; it lands within the first step unless a gap
    is given. The Courant number is that of its smallest edge of a cell. master: cells of a second
    box below, free to move, instead of the floor."""
    cells, edges = cells[-dimension:], edges[-dimension:]
    step = courant * min(e / n for e, n in zip(edges, cells)) / WAVE_SPEED
    down, along = speed * WAVE_SPEED, sideways * WAVE_SPEED
    gap = 0.5 * down * step if gap is None else gap
    lower = [0.0] * (dimension - 1) + [gap]
    upper = [l + e for l, e in zip(lower, edges)]
    keys = {"Dimension": dimension, **times(step, steps), "Bodies/Names": "upper"}
    keys.update(box("upper", lower, upper, cells))
    keys["Bodies/upper/Initial velocity"] = vector(*[along] + [0.0] * (dimension - 2) + [-down])
    keys.update(floor(dimension) if master is None else below(dimension, master))
    if friction > 0:
        keys[f"Contact/{keys['Contact/Pairs']}/Friction coefficient"] = friction
    keys.update(probes(bottom(lower, upper, cells)))
    return Scene({**keys, "Output/VTU": "false"}, size=min(edges))


def rest(gravity=1e-3, **what):
    """The box lies there in equilibrium under its weight."""
    scene = impact(speed=0.0, gap=0.0, **what)
    dimension = scene.settings["Dimension"]
    weight = vector(*(-gravity * n for n in upwards(dimension)))
    return changed(scene, {"Time/Start": "equilibrium", "Bodies/upper/Body force": weight})


def ball(dimension=2, courant=1.0, speed=0.01, refinements=2, steps=60):
    """A disc or a ball is thrown down."""
    scene = impact(dimension, courant=courant, speed=speed, steps=steps)
    gap = 0.5 * speed * WAVE_SPEED * scene.number("Time/Step size")
    centre = [0.0] * (dimension - 1) + [1.0 + gap]
    keys = {key: value for key, value in scene.settings.items() if "corner" not in key}
    del keys["Bodies/upper/Repetitions"]
    keys["Bodies/upper/Shape"] = "ball"
    keys["Bodies/upper/Centre"] = point(*centre)
    keys["Bodies/upper/Refinements"] = refinements
    angles = [-0.4, -0.2, 0.0, 0.2, 0.4]
    rest_of = [0.0] * (dimension - 2)
    places = [(math.sin(a), *rest_of, 1.0 + gap - math.cos(a)) for a in angles]
    return Scene({**keys, **probes(places)}, size=2.0)


def changed(scene, settings, size=None):
    """The scene with other values."""
    return Scene({**scene.settings, **settings}, scene.size if size is None else size)


def keys_of(scheme):
    """The keys of a scheme; macro-elements are not definite on every mesh."""
    keys = {"Time/Scheme": scheme["name"]}
    if scheme["massless_nodes"] == "needed":
        keys |= {"Time/Mass": "redistributed", "Time/Mass redistribution": "extrapolation"}
    return keys
