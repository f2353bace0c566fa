# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Random scenes with large motions among obstacles, judged by the laws of mechanics.

A box, a disc or a ball is thrown, with or without gravity, at a floor, slanted walls, balls, boxes
and waves, some of which move or turn; it goes as far as its own size, slides along them, past them
and into the corners between them. Contact follows the motion. Each scene must end with status 0 and
keep the laws of tools/stress/laws.py, and nodes must stay outside of the true obstacles. The same
seed and number give the same scene anywhere.

    ./dev stress motions [--count 500] [--seed 1] [--only NUMBER]
"""

import math
import random
import sys

from stress import random_runs
from stress.random_runs import decades, material
from stress.scene import Scene, point, vector

N_STEPS = 60


class RandomMotion:
    """A scene, and what it promises."""

    def __init__(self, number, seed, schemes):
        self.number = number
        self.source = source = random.Random(f"{seed}-{number}")
        self.scheme = source.choice(schemes)
        self.dimension = source.choice((2, 2, 3))
        self.size = decades(source, 1e-3, 1e3)
        self.n_cells = source.choice((4, 6, 8) if self.dimension == 2 else (2, 3))
        self.round = source.random() < 0.5
        self.density, self.wave_speed = decades(source, 1e-3, 1e4), decades(source, 0.1, 1e4)
        self.poisson = source.uniform(0, 0.45)
        self.speed = self.wave_speed * decades(source, 1e-3, 1e-2)
        # The body goes as far as its size, or two.
        self.step = source.uniform(1, 2) * self.size / self.speed / N_STEPS
        self.friction = decades(source, 1e-2, 3) if source.random() < 0.4 else 0.0
        self.processes = 2 if source.random() < 0.2 else 1
        self.shapes = []
        self.bodies = ["body"]
        self.scene = self.write()

    def direction(self):
        """A random unit vector."""
        components = [self.source.gauss(0, 1) for _ in range(self.dimension)]
        length = math.hypot(*components)
        return [component / length for component in components]

    def body(self, name, size, is_round, middle, flies):
        """The keys of a body; it is thrown in some direction."""
        half = size / 2
        keys = material(self.density, self.wave_speed, self.poisson)
        if flies:
            keys["Initial velocity"] = vector(*[self.speed * c for c in self.direction()])
        if is_round:
            keys |= {
                "Shape": "ball",
                "Centre": point(*middle),
                "Radius": half,
                "Refinements": 4 - self.dimension,
            }
        else:
            keys |= {
                "Shape": "box",
                "Lower corner": point(*[c - half for c in middle]),
                "Upper corner": point(*[c + half for c in middle]),
                "Repetitions": point(*[self.source.choice((-1, 0, 1)) + self.n_cells]
                                     * self.dimension),
            }
        if self.source.random() < 0.5:
            gravity = self.speed**2 / self.size * self.source.uniform(0, 3)
            keys["Body force"] = vector(*[gravity * c for c in self.direction()])
        return {f"Bodies/{name}/{key}": value for key, value in keys.items()}

    def other_bodies(self):
        """The keys of what the body may meet beside obstacles."""
        return {}

    def obstacle(self):
        """The keys of something beside the body, at a distance of up to half of its size."""
        away, half = self.direction(), self.size / 2
        reach = half if self.round else half * math.sqrt(self.dimension)
        distance = reach + self.size * self.source.uniform(0.01, 0.5)
        shapes = ["plane", "plane", "sphere", "box", "function"]
        if "function" in self.shapes:  # two waves cross at any angle, and below 0.1 there is no end
            shapes.pop()
        shape = self.source.choice(shapes)
        self.shapes.append(shape)
        keys = {"Shape": shape}
        if shape == "plane":
            keys |= {
                "Point": point(*[distance * c for c in away]),
                "Normal": point(*[-c for c in away]),
            }
        elif shape == "sphere":
            radius = self.size * decades(self.source, 0.3, 3)
            keys |= {
                "Centre": point(*[(distance + radius) * c for c in away]),
                "Radius": radius,
            }
        elif shape == "box":
            edge = self.size * decades(self.source, 0.5, 3)
            # Its nearest corner or face is as far away along one axis at least.
            axis = max(range(self.dimension), key=lambda c: abs(away[c]))
            middle = [edge * c for c in away]
            middle[axis] = math.copysign(distance + edge / 2, away[axis])
            keys |= {
                "Lower corner": point(*[c - edge / 2 for c in middle]),
                "Upper corner": point(*[c + edge / 2 for c in middle]),
            }
        else:
            height, wave = self.size * self.source.uniform(0.01, 0.1), self.source.uniform(1, 3)
            keys["Signed distance"] = (
                f"y + {distance + height!r} - {height!r}*cos({wave / self.size!r}*x)"
            )
        return keys | self.motion()

    def motion(self):
        """Of an obstacle, one in three: it comes closer or goes away, or turns."""
        if self.source.random() > 1 / 3:
            return {}
        slow = 0.3 * self.speed
        if self.source.random() < 0.5:
            return {"Velocity": vector(*[slow * c for c in self.direction()])}
        return {"Angular velocity": self.source.uniform(-0.3, 0.3) * self.speed / self.size}

    def write(self):
        """All sections."""
        names = [f"o{n}" for n in range(self.source.choice((1, 2, 3, 4)))]
        middle = [0.0] * self.dimension
        bodies = self.body("body", self.size, self.round, middle, True) | self.other_bodies()
        pairs = [f"body : {name}" for name in names]
        pairs += [f"{a} : {b}" for k, a in enumerate(self.bodies) for b in self.bodies[k + 1 :]]
        keys = {
            "Dimension": self.dimension,
            "Time/Scheme": self.scheme["name"],
            "Time/Step size": self.step,
            "Time/End time": N_STEPS * self.step,
            "Bodies/Names": ", ".join(self.bodies),
            **bodies,
            "Obstacles/Names": ", ".join(names),
            "Contact/Pairs": ", ".join(pairs),
            "Contact/Motion": "follow",
            "Output/VTU": "false",
        }
        for name in names:
            keys |= {f"Obstacles/{name}/{key}": value for key, value in self.obstacle().items()}
        if self.friction:
            keys |= {f"Contact/{pair}/Friction coefficient": self.friction for pair in pairs}
        return Scene(keys, self.size)

    def title(self):
        """In words."""
        return (
            f"{self.number}: {self.scheme['name']}, {self.dimension}d"
            f"{', round' if self.round else ''}, {', '.join(self.shapes + self.bodies[1:])}"
            f"{f', friction {self.friction:.2g}' if self.friction else ''},"
            f" size {self.size:.2g}, {self.processes} process(es)"
        )


def may_follow(scheme):
    """Of a scheme, as the table of schemes tells: what keeps nodes outside, and moves masses."""
    return scheme["moving_contact"] and scheme["inertia"] and not scheme["penetrates"]


if __name__ == "__main__":
    sys.exit(random_runs.main(__doc__, RandomMotion, may_follow))
