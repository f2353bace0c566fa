# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Scenes in which something is pushed, piled up, damped, refined or measured beyond reason."""

import math

from . import scenes
from .scene import Scene, point, vector
from .scenes import WAVE_SPEED, changed, impact, rest


def squeeze(part):
    """The top is moved down by this part of the height, in 20 steps, and held there."""
    scene = impact(speed=0.0, gap=0.0, courant=5.0, friction=0.3)
    end = 20 * scene.number("Time/Step size")
    pushed = f"3: 0; {-part!r}*(1-cos(3.141592653589793*min(t,{end!r})/{end!r}))/2"
    return changed(scene, {"Bodies/upper/Dirichlet": pushed})


def push_from_rest(friction):
    """The first two steps of a block that is pushed onto the floor and would like to slip: later
    ones, with more energy, would hide what is wrong with them."""
    scene = impact(cells=(5, 4), speed=0.0, gap=0.0, courant=7.0, steps=2, friction=friction)
    pushed = {
        "Bodies/upper/Dirichlet": "3: 0; -1e-2*(1-cos(t/7))",
        "Bodies/upper/Poisson's ratio": 0.4,
    }
    return changed(scene, pushed)


def infeasible(depth):
    """The bottom itself is moved into the floor, so that nothing can give way there."""
    scene = impact(speed=0.0, gap=0.0, courant=5.0)
    end = scene.number("Time/End time")
    pushed = f"2: 0; {-depth!r}*(t/{end!r})^2"
    kept = {key: value for key, value in scene.settings.items() if not key.startswith("Probes")}
    return Scene({**kept, "Bodies/upper/Dirichlet": pushed})


def magnitude(factor):
    """Density and modulus beyond what the squares of numbers can hold."""
    return changed(
        impact(), {"Bodies/upper/Young's modulus": factor, "Bodies/upper/Density": factor}
    )


def damping(value):
    """Viscous damping of the stiffness, in steps."""
    scene = impact()
    return changed(
        scene, {"Bodies/upper/Damping": point(0.0, value * scene.number("Time/Step size"))}
    )


def local_refinement(levels):
    """Cells at one end of the bottom are halved so often."""
    keys = {
        "Bodies/upper/Local refinements": int(levels),
        "Bodies/upper/Refine where": "2*h - sqrt(x^2 + y^2)",
    }
    return changed(impact(courant=1.0, cells=(2, 2)), keys)


def pile(friction):
    """Three boxes fall on each other under gravity, each beside the one below by a third of its
    width."""
    base = impact(speed=0.003, steps=60, courant=2.0)
    keys = {"Bodies/Names": "upper, lower, third", **scenes.floor(2)}
    pairs = ("upper[2] : lower[3]", "lower[2] : third[3]", "third[2] : floor")
    for n, body in enumerate(("third", "lower", "upper")):
        low = 1.0 * n + 0.001 * (n + 1)
        cells = (4 + n, 4)
        keys |= scenes.box(body, (0.3 * n, low), (1.0 + 0.3 * n, low + 1.0), cells)
        keys[f"Bodies/{body}/Initial velocity"] = vector(0.002 * (n - 1), -0.003)
        keys[f"Bodies/{body}/Body force"] = vector(0.0, -1e-3)
    keys["Contact/Pairs"] = ", ".join(pairs)
    if friction > 0:
        keys |= {f"Contact/{pair}/Friction coefficient": friction for pair in pairs}
    places = scenes.probes([(0.6, 2.003), (1.0, 2.003), (1.6, 2.003)])
    kept = {key: value for key, value in base.settings.items() if not key.startswith("Probes")}
    return Scene({**kept, **keys, **places})


def stack_at_rest(ratio):
    """A heavy box rests on a light one, or the other way round, on a floor, with friction."""
    scene = rest(gravity=1e-8, friction=0.5, master=(5, 3), courant=20.0)
    pairs = f"{scenes.BODIES}, lower[2] : floor"
    keys = {
        "Obstacles/Names": "floor",
        "Obstacles/floor/Point": point(0.0, -1.0),
        "Obstacles/floor/Normal": point(0.0, 1.0),
        "Bodies/lower/Body force": vector(0.0, -1e-8),
        "Bodies/upper/Density": ratio,
        "Bodies/upper/Young's modulus": ratio,
        "Contact/Pairs": pairs,
    }
    return changed(scene, keys)


def corner_3d(angle):
    """A cube turned about two axes lands on its corner, or nearly on an edge or a face."""
    scene = impact(3, cells=(2, 2, 2), steps=25)
    keys = {
        "Bodies/upper/Rotation": point(angle, angle, 0.0),
        "Obstacles/floor/Point": point(0.0, 0.0, lowest(angle)),
    }
    return changed(scene, keys)


def lowest(angle):
    """The height of the lowest corner of the unit cube on the floor, turned about its centre about
    x and then about y."""
    turned = math.radians(angle)
    s, c = math.sin(turned), math.cos(turned)
    return 0.5 - 0.5 * (abs(s) + abs(s * c) + abs(c * c))


def spin(speed):
    """A box turns while it falls; the speed of its rim in wave speeds."""
    scene = impact(speed=0.01, gap=0.02)
    turning = f"{-speed * WAVE_SPEED!r}*(y-0.5); {speed * WAVE_SPEED!r}*(x-0.5)-0.0116"
    return changed(scene, {"Bodies/upper/Initial velocity": turning})


MAGNITUDES = (1e-300, 1e-150, 1e-30, 1e30, 1e150, 1e300)
COEFFICIENTS = (0.01, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0, 3.0, 10.0)
#: Name, quantity, values and builder of each family, and the values of a quick run.
ROWS = [
    ("squeeze", "part of the height", (1e-6, 0.01, 0.1, 0.5, 1.0, 2.0), squeeze, (1e-6, 2.0)),
    ("push-from-rest", "coefficient", COEFFICIENTS, push_from_rest, (0.1, 10.0)),
    ("infeasible", "depth", (1e-9, 0.1), infeasible),
    ("magnitude", "modulus, density", MAGNITUDES, magnitude, (1e-150, 1e150)),
    ("damping", "time / step", (1e-6, 1e-2, 1.0, 1e3, 1e6, 1e12), damping, (1e-6, 1e3)),
    ("local-refinement", "levels", (1.0, 4.0, 8.0, 12.0), local_refinement, (4.0,)),
    ("pile", "coefficient", (0.0, 0.01, 0.3, 1.0, 3.0, 10.0), pile, (0.3, 10.0)),
    ("stack-at-rest", "above / below", (1e-6, 1e-3, 1.0, 1e3, 1e6), stack_at_rest),
    ("corner-3d", "angle", (0.0, 1e-9, 1e-3, 1.0, 30.0, 45.0), corner_3d),
    ("spin", "speed of the rim", (1e-4, 1e-2, 0.1, 1 / 3), spin),
]
