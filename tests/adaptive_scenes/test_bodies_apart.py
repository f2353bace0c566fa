#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A body that touches nothing changes nothing, on meshes that change, too: whatever it is made of,
the others have the same cells, forces and energies as without it. And a scene that is turned has
the same ones. What is left is what solvers leave: where contact has to be kept on a new mesh, they
work to 1e-8 of what they change.
"""

import math

import check_history

BODY = """  subsection %(name)s
    set Shape           = box
    set Lower corner    = %(lower)s
    set Upper corner    = %(upper)s
    set Repetitions     = %(cells)s
    set Refinements     = %(level)s
    set Rotation        = %(turn)r
    set Rotation centre = 0, 0
    set Young's modulus = %(modulus)r
    set Poisson's ratio = 0.3
    set Density         = 1
    set Initial velocity = %(velocity)s
  end
"""

SCENE = """
set Dimension = 2
subsection Time
  set Step size = 4e-3
  set End time  = 0.16
end
subsection Bodies
  set Names = %(names)s
%(bodies)send
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = %(normal)s
  end
end
subsection Contact
  set Pairs = slab : floor
end
subsection Adaptivity
  set Indicator     = residual
  set Maximum level = 5
end
"""


def slab_on_floor(degrees=0.0, far=None):
    """A slab with a corner ahead. @param far Young's modulus of a body far away"""
    angle = math.radians(degrees)
    c, s = math.cos(angle), math.sin(angle)
    slab = {
        "name": "slab",
        "lower": "-1, 0",
        "upper": "1, 0.5",
        "cells": "4, 1",
        "level": 2,
        "turn": degrees,
        "modulus": 300.0,
        "velocity": f"{0.1 * c + 0.5 * s!r}; {0.1 * s - 0.5 * c!r}",
    }
    other = {
        "name": "far",
        "lower": "-1, 10",
        "upper": "1, 12",
        "cells": "1, 1",
        "level": 1,
        "turn": degrees,
        "modulus": far,
        "velocity": "0; 0",
    }
    bodies = [slab] if far is None else [slab, other]
    return SCENE % {
        "names": ", ".join(body["name"] for body in bodies),
        "bodies": "".join(BODY % body for body in bodies),
        "normal": f"{-s!r}, {c!r}",
    }


class BodiesApart(check_history.SceneTest):
    def expect_same(self, run, other, more_cells=0):
        self.assertGreater(max(run["contact_force"]), 0.0)
        self.assertGreater(len(set(run["cells"])), 3, "the mesh changes")
        self.assertEqual(len(run), len(other))
        for row, (a, b) in enumerate(zip(run["cells"], other["cells"])):
            self.assertEqual(a + more_cells, b, f"cells in row {row}")
        for column in ("contact_force", "elastic_energy", "kinetic_energy"):
            scale = max(map(abs, run[column]))
            for row, (a, b) in enumerate(zip(run[column], other[column])):
                self.assertLess(abs(a - b), 1e-5 * scale, f"{column} in row {row}")

    def test_whatever_is_far_away(self):
        alone = check_history.Run(slab_on_floor(), "alone")
        for modulus in (0.003, 300.0, 3e5):
            both = check_history.Run(slab_on_floor(far=modulus), f"far-{modulus:g}")
            self.expect_same(alone, both, more_cells=4)

    def test_in_any_frame(self):
        straight = check_history.Run(slab_on_floor(), "straight")
        for degrees in (37.0, 90.0):
            turned = check_history.Run(slab_on_floor(degrees), f"turned-{degrees:g}")
            self.expect_same(straight, turned)


if __name__ == "__main__":
    check_history.main()
