# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The families of scenes: in each, one quantity goes to where the method may end."""

import dataclasses
import typing

from . import corners, pushed, scenes
from .scene import vector
from .scenes import WAVE_SPEED, changed, impact, rest


@dataclasses.dataclass(frozen=True)
class Family:
    """One base scene and the values of one quantity."""

    name: str
    quantity: str
    values: tuple
    build: typing.Callable  # a value to its Scene
    quick: tuple | None = None  # the values of a quick run, if not the first and the last

    def quick_values(self):
        """The ends of the sweep, or what it says itself."""
        return (self.values[0], self.values[-1]) if self.quick is None else self.quick


def ratio(key, dimension=2):
    """A sweep of one key of the lower body; the step suits the upper one."""
    master = (4, 3) if dimension == 2 else (2, 2, 2)
    base = {} if dimension == 2 else {"cells": (2, 2, 2), "steps": 25}

    def build(value):
        """The step suits the upper body, of modulus and density 1."""
        scene = impact(dimension, master=master, **base)
        return changed(scene, {f"Bodies/lower/{key}": value})

    return build


def stiff_and_heavy(value):
    """The lower body becomes stiffer and heavier, so that waves are as fast as in the upper one."""
    return changed(
        impact(master=(4, 3)),
        {"Bodies/lower/Young's modulus": value, "Bodies/lower/Density": value},
    )


def step(value):
    """A square lands on a floor, with steps over six decades."""
    return impact(courant=value)


def step_of_ball(value):
    """A disc lands on a floor, with steps over six decades."""
    return scenes.ball(courant=value)


def step_3d(value):
    """A cube lands on a floor, with steps over six decades."""
    return impact(3, cells=(2, 2, 2), courant=value, steps=25)


def poisson(value):
    """A square lands on a floor; its material becomes incompressible."""
    return changed(impact(), {"Bodies/upper/Poisson's ratio": value})


def poisson_pressed(value):
    """A square rests on another body; its material becomes incompressible."""
    return changed(rest(master=(4, 3)), held() | {"Bodies/upper/Poisson's ratio": value})


def held():
    """The lower body stands on what does not move."""
    return {"Bodies/lower/Dirichlet": "2: " + vector(0, 0)}


def speed(value):
    """A square hits a floor with up to a third of the wave speed."""
    return impact(speed=value)


def speed_of_ball(value):
    """A disc hits a floor with up to a third of the wave speed."""
    return scenes.ball(speed=value)


def friction(value):
    """A box lands obliquely."""
    return impact(sideways=0.02, friction=value)


def friction_3d(value):
    """A cube lands obliquely."""
    return impact(3, cells=(2, 2, 2), sideways=0.02, friction=value, steps=25)


def friction_of_bodies(value):
    """A box lands obliquely on another one."""
    return impact(sideways=0.02, friction=value, master=(4, 3))


def friction_long_step(value):
    """A square slides under its weight, with steps of Courant number 50."""
    sliding = {
        "Time/Start": "given",
        "Bodies/upper/Initial velocity": vector(0.01 * WAVE_SPEED, 0.0),
    }
    return changed(rest(friction=value, courant=50.0), sliding)


def friction_equilibrium(value):
    """A square rests in equilibrium under its weight; the ends of its bottom would like to slip."""
    return rest(friction=value, courant=50.0, steps=10)


def flat_cells(value):
    """A plate that becomes thinner."""
    return impact(edges=(1.0, 1.0 / value), courant=1.0, speed=0.01 / value)


def tall_cells(value):
    """A column that becomes thinner."""
    return impact(edges=(1.0 / value, 1.0), courant=1.0, speed=0.01 / value)


def flat_cells_of_a_square(value):
    """Many layers; contact nodes are far from each other and close to the next layer."""
    return impact(cells=(1, int(value)), courant=50.0)


def tall_cells_of_a_square(value):
    """Many columns; contact nodes are close to each other."""
    return impact(cells=(int(value), 2), courant=50.0)


def grazing(value):
    """Along the floor, with less and less speed towards it."""
    return impact(sideways=0.01, speed=0.01 * value, friction=0.3)


def mesh_ratio(value):
    """Cells of the master over those of the slave, in size; less than 1: finer."""
    slave, master = (2, 2), (2, 2)
    if value < 1:
        master = (round(2 / value), 2)
    else:
        slave = (round(2 * value), 2)
    return impact(cells=slave, master=master, courant=10.0)


def touching(value):
    """A gap of any sign and size at the start, between two bodies."""
    return impact(gap=value, master=(4, 3))


def touching_floor(value):
    """A gap of any sign and size at the start, above a floor."""
    return impact(gap=value)


def length(value):
    """The same scene in other units of length."""
    scene = impact(edges=(value, value), master=None)
    return scene


def preload(value):
    """Gravity that strains the box by more and more; it falls and stays."""
    return changed(
        impact(gap=0.0, speed=0.0, steps=100), {"Bodies/upper/Body force": vector(0.0, -value)}
    )


def control(value):
    """Steps that follow the motion within a tolerance (doubling)."""
    return changed(
        impact(steps=10), {"Time/Step size control": "doubling", "Time/Step tolerance": value}
    )


def bounces(value):
    """A small column bounces, with some 20 steps from one bounce to the next; a row of the table
    for every third step sees most of them."""
    scene = impact(cells=(1, 2), edges=(0.5, 1.0), speed=0.0, gap=1e-3, steps=25 * value)
    gravity = 8 * 1e-3 / (15 * scene.number("Time/Step size")) ** 2
    keys = {
        "Bodies/upper/Body force": vector(0.0, -gravity),
        "Contact/Pairs": "upper[2] : floor",
        "Output/History every": 3,
        "Output/Pairs": "false",
        "Output/Bodies": "false",
    }
    return changed(scene, keys)


SIX_DECADES = (1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1000.0)
RATIOS = (1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6)
FEW_RATIOS = (1e-6, 1e-3, 1e3, 1e6)
POISSON = (-0.9, 0.0, 0.4, 0.49, 0.499, 0.4999)
SPEEDS = (1e-6, 1e-3, 0.01, 0.03, 0.1, 1 / 3)
FRICTION = (0.0, 0.01, 0.3, 1.0, 3.0, 10.0)
ASPECTS = (1.0, 10.0, 100.0, 1000.0)
GAPS = (-0.01, -1e-6, -1e-12, -1e-17, 0.0, 1e-300, 1e-17, 1e-12, 1e-6)

FAMILIES = [
    Family("step", "Courant number", SIX_DECADES, step),
    Family("step-ball", "Courant number", SIX_DECADES, step_of_ball),
    Family("step-3d", "Courant number", SIX_DECADES, step_3d),
    Family("stiffness", "modulus below / above", RATIOS, ratio("Young's modulus")),
    Family("stiffness-3d", "modulus below / above", FEW_RATIOS, ratio("Young's modulus", 3)),
    Family("density", "density below / above", RATIOS, ratio("Density")),
    Family("density-3d", "density below / above", FEW_RATIOS, ratio("Density", 3)),
    Family("impedance", "both below / above", RATIOS, stiff_and_heavy),
    Family("poisson", "Poisson's ratio", POISSON, poisson),
    Family("poisson-pressed", "Poisson's ratio", POISSON, poisson_pressed),
    Family("speed", "speed / wave speed", SPEEDS, speed),
    Family("speed-ball", "speed / wave speed", SPEEDS, speed_of_ball),
    Family("friction", "coefficient", FRICTION, friction),
    Family("friction-3d", "coefficient", FRICTION, friction_3d),
    Family("friction-bodies", "coefficient", FRICTION, friction_of_bodies),
    Family("friction-long-step", "coefficient", FRICTION, friction_long_step),
    Family("friction-equilibrium", "coefficient", FRICTION, friction_equilibrium),
    Family("plate", "aspect of cells", ASPECTS, flat_cells),
    Family("column", "aspect of cells", ASPECTS, tall_cells),
    Family("layers", "aspect of cells", ASPECTS, flat_cells_of_a_square, (1.0, 100.0)),
    Family("slices", "aspect of cells", (2.0, 10.0, 100.0, 500.0), tall_cells_of_a_square, (10.0,)),
    Family("grazing", "normal / tangential speed", (1.0, 1e-2, 1e-4, 1e-8, 0.0), grazing),
    Family("mesh-ratio", "cells of master / slave", (1e-2, 0.1, 1.0, 10.0, 100.0), mesh_ratio),
    Family("touching", "gap", GAPS, touching),
    Family("touching-floor", "gap", GAPS, touching_floor),
    Family("units", "length", (1e-9, 1e-6, 1e6, 1e9), length),
    Family("weight", "strain by the weight", (1e-12, 1e-6, 1e-3, 0.1, 1.0), preload),
    Family("step-control", "tolerance", (1e-8, 1e-4, 1e-1), control),
    Family("bounces", "bounces", (100, 10000), bounces, (100,)),
    *(Family(*row) for row in (*corners.ROWS, *pushed.ROWS)),
]
