# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Random scenes, judged by the laws of mechanics.

Boxes and discs or balls hit a plane or each other: sizes from 1e-3 to 1e3, densities from 1e-3 to
1e4, wave speeds from 0.1 to 1e4, Courant numbers from 0.1 to 300, friction up to 10, every scheme
that takes steps, one and two bodies, a mesh that changes or not, one and two processes. Each must
end with status 0 and keep the laws of tools/stress/laws.py: explain its energy to 1e-9 and its
momentum, gain no energy and not penetrate if its scheme promises so. The same seed and number give
the same scene anywhere.

    ./dev stress random [--count 1000] [--seed 1] [--only NUMBER]
"""

import random
import sys

from stress import random_runs, scenes
from stress.random_runs import decades, material
from stress.scene import Scene, point, vector

N_STEPS = 25


class RandomScene:
    """A scene, and what it promises."""

    def __init__(self, number, seed, schemes):
        self.number = number
        self.source = source = random.Random(f"{seed}-{number}")
        self.scheme = source.choice(schemes)
        self.dimension = source.choice((2, 2, 3))
        self.size = decades(source, 1e-3, 1e3)
        self.courant = decades(source, 0.1, 300)
        self.n_cells = source.choice((4, 6, 8) if self.dimension == 2 else (2, 3))
        self.round = source.random() < 0.4
        self.two_bodies = source.random() < 0.4
        self.friction = 0.0
        if self.scheme["friction"] and source.random() < 0.5:
            self.friction = decades(source, 1e-2, 10)
        self.changing = self.scheme["changing_mesh"] and source.random() < 0.3
        self.processes = 2 if source.random() < 0.2 else 1
        self.density, self.wave_speed = decades(source, 1e-3, 1e4), decades(source, 0.1, 1e4)
        self.poisson = source.uniform(0, 0.45)
        self.step = self.courant * self.size / self.n_cells / self.wave_speed
        # A step moves a body by at most a fraction of itself, and a hit strains it a little.
        fastest = min(1e-2 * self.wave_speed, 2e-3 * self.size / self.step)
        self.speed = fastest * decades(source, 1e-3, 1)
        self.scene = self.write()

    def direction(self, normal, tangential=0.0):
        """Components with the normal direction last."""
        return [tangential] + [0.0] * (self.dimension - 2) + [normal]

    def body(self, name, offset, speed):
        """The keys of a body that rests on the height offset."""
        size = self.size
        if self.round:
            keys = {
                "Shape": "ball",
                "Centre": point(*self.direction(offset + size)),
                "Radius": size,
                "Refinements": 2 if self.dimension == 2 else 1,
            }
        else:
            upper = [size] * (self.dimension - 1) + [offset + size]
            keys = {
                "Shape": "box",
                "Lower corner": point(*self.direction(offset)),
                "Upper corner": point(*upper),
                "Repetitions": point(*[self.n_cells] * self.dimension),
            }
        sideways = self.source.uniform(-0.5, 0.5) * speed if self.friction > 0 else 0.0
        keys |= {
            **material(self.density, self.wave_speed, self.poisson),
            "Initial velocity": vector(*self.direction(speed, sideways)),
        }
        return {f"Bodies/{name}/{key}": value for key, value in keys.items()}

    def write(self):
        """All sections."""
        gap = self.source.uniform(0, 5) * self.speed * self.step
        height = 2 * self.size if self.round else self.size
        keys = {
            "Dimension": self.dimension,
            "Time/Step size": self.step,
            "Time/End time": N_STEPS * self.step,
            "Bodies/Names": "upper",
            **self.body("upper", gap, -self.speed),
        }
        if self.two_bodies:
            keys |= self.body("lower", -height, 0.0)
            keys |= {"Bodies/Names": "upper, lower", "Contact/Pairs": scenes.BODIES}
        else:
            keys |= scenes.floor(self.dimension)
        if self.changing:
            keys |= {
                "Adaptivity/Indicator": "residual",
                "Adaptivity/Maximum level": 3,
                "Adaptivity/Maximum cells": 400,
                "Adaptivity/Steps between remeshings": 4,
            }
        if self.friction:
            keys[f"Contact/{keys['Contact/Pairs']}/Friction coefficient"] = self.friction
        return Scene({**keys, **scenes.keys_of(self.scheme), "Output/VTU": "false"}, self.size)

    def title(self):
        """In words."""
        return (
            f"{self.number}: {self.scheme['name']}, {self.dimension}d"
            f"{', round' if self.round else ''}{', two bodies' if self.two_bodies else ''}"
            f"{f', friction {self.friction:.2g}' if self.friction else ''}"
            f"{', changing mesh' if self.changing else ''}, Courant number {self.courant:.2g},"
            f" size {self.size:.2g}, {self.processes} process(es)"
        )


def takes_steps(scheme):
    """A scheme with a tolerance of its own keeps its energy up to that; without inertia, nothing
    can be thrown."""
    return scheme["variable_step"] and scheme["inertia"]


if __name__ == "__main__":
    sys.exit(random_runs.main(__doc__, RandomScene, takes_steps))
