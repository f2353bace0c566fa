#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A ball from a mesh of tetrahedra that falls on a plane is pressed against it as the ball of
hexahedra with the same distance of nodes: the largest contact forces agree within 3 %, with nodes
of second order on the sphere and without. The mesh is about the origin and in another unit.
"""

import pathlib

import check_history
import tetrahedra

SCENE = """set Dimension = 3
subsection Time
  set Step size = 1e-2
  set End time  = 0.3
end
subsection Bodies
  set Names = ball
  subsection ball
{shape}
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0; 0; -2
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Shape = plane
  end
end
subsection Contact
  set Pairs = {pair} : floor
end
"""


class TetrahedralBall(check_history.SceneTest):
    def run_ball(self, name, pair, *keys, processes=1):
        """@return the history of a ball whose section has the given keys"""
        shape = "\n".join(f"    set {key}" for key in keys)
        return check_history.Run(SCENE.format(shape=shape, pair=pair), name, processes=processes)

    def test_force(self):
        folder = pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        cubes = self.run_ball("hexahedra", "ball", "Centre = 0, 0, 1", "Refinements = 3")
        expected = max(cubes["contact_force"])
        self.assertGreater(expected, 0)
        for curved in (True, False):
            with self.subTest(curved=curved):
                name = "curved" if curved else "straight"
                mesh = folder / f"{name}.msh"
                tetrahedra.write(mesh, 2, curved, 1000)
                run = self.run_ball(
                    name,
                    "ball[skin]",
                    "Shape = file",
                    f"File = {mesh}",
                    "Part = ball",
                    "Scale = 0.001",
                    "Translation = 0, 0, 1",
                    processes=2 if curved else 1,
                )
                force = max(run["contact_force"])
                self.assertLess(abs(force / expected - 1), 0.03, f"{force} for {expected}")
                self.assertIn("1280 tetrahedra are split into 5120 hexahedra", run.log)


if __name__ == "__main__":
    check_history.main()
