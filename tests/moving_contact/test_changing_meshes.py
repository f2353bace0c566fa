#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Contact that follows the motion on meshes that change: the fine cells travel with the contact, a
change of the mesh gives no energy and no blow, nodes end steps outside of the true obstacle, and
the result is that of a mesh that is fine everywhere, on any number of processes.
"""

import math

import check_history
import following_scenes as following
import test_corners as corners
import test_moving_obstacles as punches

HILL = """
set Dimension = 2
subsection Time
  set Step size = 0.005
  set End time  = 0.5
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape            = ball
    set Centre           = -0.3, 2.483
    set Radius           = 0.5
    set Refinements      = {refinements}
    set Young's modulus  = 1000
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0.5; 0
    set Body force       = 0; -1
  end
end
subsection Obstacles
  set Names = hill
  subsection hill
    set Shape  = sphere
    set Radius = 2
  end
end
subsection Contact
  set Pairs  = disc : hill
  set Motion = follow
end
subsection Probes
  set Names = centre
  subsection centre
    set Body  = disc
    set Point = -0.3, 2.483
  end
end
"""

#: On a plane, in a groove and in a bowl.
LYING = """
set Dimension = 2
subsection Time
  set Step size = 0.005
  set End time  = 0.4
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape            = ball
    set Centre           = 0, 0.501
    set Radius           = 0.5
    set Refinements      = 3
    set Young's modulus  = 1000
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0.2*y; -0.2*x
    set Body force       = 0; -1
  end
end
subsection Obstacles
  set Names = ground
  subsection ground
    {ground}
  end
end
subsection Contact
  set Pairs  = disc : ground
  set Motion = {motion}
  subsection disc : ground
    set Friction coefficient = 0.3
  end
end
"""

ADAPTIVITY = """
subsection Adaptivity
  set Indicator     = {indicator}
  set Maximum level = {level}
  set Maximum cells = 800
  set Distance      = 0.01
end
"""


def changing(scene, level, indicator="residual"):
    """The scene on a mesh that changes."""
    return scene + ADAPTIVITY.format(indicator=indicator, level=level)


class ChangingMeshes(check_history.SceneTest):
    """See the beginning of the file."""

    def expect_laws(self, history):
        """Nothing gives energy, on meshes that do change."""
        self.expect_losses(history)
        self.assertGreater(len(set(history["cells"])), 1)

    def test_disc_slides_over_a_hill_as_on_a_fine_mesh(self):
        """Two impacts on the way. Momentum and place are those on cells that are fine everywhere,
        to what the first impact depends on the cells inside of the disc, with a quarter of them."""
        fine = check_history.Run(HILL.format(refinements=5), "fine")
        run = check_history.Run(changing(HILL.format(refinements=3), 5), "hill")
        history = run.history
        self.expect_laws(history)
        self.assertLess(max(history["geometric_penetration"]), 1e-11)
        self.assertLess(max(history["cells"]), fine["cells"][0] / 4)
        self.assertAlmostEqual(
            history["momentum_x"][-1] / fine["momentum_x"][-1], 1, delta=2e-3
        )
        for axis in "xy":
            here, there = (r.probes["centre"][f"displacement_{axis}"][-1] for r in (run, fine))
            self.assertAlmostEqual(here, there, delta=1e-3)

    def test_ball_in_a_bowl(self):
        """In space, with friction, as far as the first steps in contact."""
        history = check_history.Run(
            check_history.scene_file("ball_in_a_bowl"),
            "ball",
            ["Time/End time=0.15", "Adaptivity/Maximum level=3"],
        ).history
        self.expect_laws(history)
        self.assertGreater(max(history["contact_force"]), 0.1)
        self.assertLess(max(history["geometric_penetration"]), 1e-11)

    def test_processes_agree(self):
        """The cells are the same on one process and on two, and so is the motion."""
        scene = changing(HILL.format(refinements=3), 5)
        one, two = (
            check_history.Run(scene, f"hill_{n}", ["Time/End time=0.3"], n) for n in (1, 2)
        )
        self.assertEqual(one["cells"], two["cells"])
        self.expect_contact(one)
        self.expect_same_history(two, one, 1e-8)

    def test_changes_of_the_mesh_neither_lift_nor_turn_what_lies(self):
        """Below a disc that bounces and rolls cells become coarser while nodes side by side are
        closed. What the coarser mesh cannot do alike is not a motion of the disc: a lift of 0.01
        would be as much energy as it has."""
        bowl = "set Shape = sphere\n    set Centre = 0, 2\n    set Radius = 2"
        bowl += "\n    set Bodies inside = true"
        for ground, motion, indicator in (
            ("set Normal = 0, 1", "linearised", "residual"),
            ("set Normal = 0, 1", "follow", "residual"),
            (bowl, "follow", "residual"),
            (bowl, "follow", "kelly"),
            (bowl, "follow", "distance"),
        ):
            with self.subTest(ground=ground, motion=motion, indicator=indicator):
                scene = LYING.format(ground=ground, motion=motion)
                history = check_history.Run(changing(scene, 5, indicator), "lying").history
                self.expect_laws(history)

    def test_disc_in_a_groove(self):
        """Each side has its own friction; nodes that both hold hand on forces and statuses."""
        sine, cosine = math.sin(0.5), math.cos(0.5)
        scene = corners.GROOVE.format(sine=sine, cosine=cosine, height=1 / sine + 0.01)
        scene = scene.replace(
            "set Motion = follow",
            "set Motion = follow\n  subsection disc : left\n    set Friction coefficient = 0.3\n"
            "  end\n  subsection disc : right\n    set Friction coefficient = 0.1\n  end",
        )
        history = check_history.Run(
            changing(scene, 5), "groove", ["Time/Start=given", "Time/End time=0.6"]
        ).history
        self.expect_laws(history)
        self.assertLess(min(history["work_friction"]), 0)
        self.assertLess(max(history["geometric_penetration"]), 1e-11)

    def test_block_in_the_corner_of_a_room(self):
        """Nodes at two and three obstacles, in space."""
        scene = corners.ROOM.format(scheme="contact-stabilized-projected")
        history = check_history.Run(changing(scene, 1), "room", ["Time/End time=0.25"]).history
        self.expect_laws(history)
        self.assertLess(max(history["geometric_penetration"]), 1e-11)

    def test_work_of_a_punch(self):
        """What the moving punch does is what it brings, also where nodes come and go below it."""
        scene = punches.PUNCH.format(
            scheme="contact-stabilized-projected",
            motion=punches.PUNCH_MOTION,
            friction=0.3,
        )
        run = check_history.Run(changing(scene, 2), "punch", ["Time/End time=1"])
        history = run.history
        energy = max(history["total_energy"])
        self.expect_laws(history)
        self.assertLess(min(history["work_friction"]), 0)
        work, external = punches.work_of_punch(history), sum(history["work_external"])
        self.assertAlmostEqual(work, external, delta=1e-10 * energy)

    def test_bodies_are_refined_where_they_are_near(self):
        """Two discs that fly towards each other are as they were while they are far away; then the
        cells around the spot become fine on both sides. A quarter of their surfaces would be twice
        as many cells."""
        discs = [
            following.disc("upper", "0, 1.15", "set Initial velocity = 0; -1"),
            following.disc("lower", "0, -1.15", "set Initial velocity = 0; 1"),
        ]
        scene = following.scene(discs, ["upper : lower"], 0.3) + ADAPTIVITY.format(
            indicator="distance", level=6
        ).replace("800", "4000")
        history = check_history.Run(scene, "near", ["Adaptivity/Distance=0.1"]).history
        cells = history["cells"]
        self.assertEqual(cells[5], cells[0])
        self.assertGreater(max(history["contact_force"]), 0)
        self.assertGreater(max(cells), 1.2 * cells[0])
        self.assertLess(max(cells), 1.6 * cells[0])

    def test_depth_that_a_finer_mesh_shows_is_admitted(self):
        """Cells are refined below a disc that lies: new nodes on its round surface are inside of
        the ground. They are not pushed out, and get no deeper as long as they are held."""
        scene = LYING.format(ground="set Normal = 0, 1", motion="follow")
        overrides = [
            "Adaptivity/Steps between remeshings=20",
            "Adaptivity/Distance=0",
            "Bodies/disc/Refinements=2",
            "Contact/disc : ground/Friction coefficient=0",
            "Time/End time=1",
        ]
        history = check_history.Run(changing(scene, 5), "depth", overrides).history
        energy = max(history["kinetic_energy"])
        self.assertGreater(max(history["max_penetration"]), 1e-5)
        for column in ("work_contact", "work_predictor"):
            self.assertLess(max(history[column]), 1e-10 * energy, column)
        depths, cells = history["max_penetration"], history["cells"]
        for step in range(1, len(cells)):
            if cells[step] == cells[step - 1]:
                self.assertLess(depths[step], depths[step - 1] + 1e-11)


if __name__ == "__main__":
    check_history.main()
