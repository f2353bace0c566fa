#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Static problems are solved as static ones, by `Start = equilibrium` and by the scheme `static`:
slender beams bend as Timoshenko says, a cylinder on a plane has the contact of Hertz, a block under
a push sticks up to Coulomb's limit, and what nothing holds is named with its motion.
"""

import math
import re

import check_history

MODULUS = 1000.0
#: Products of a whole solution. One step of a dynamic scheme at Courant number 3000 took 412.
MOST_PRODUCTS = 40

BEAM = """
set Dimension = 2
subsection Time
  set Start     = equilibrium
  set Step size = 1e-3
  set End time  = 1e-3
end
subsection Bodies
  set Names = beam
  subsection beam
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = LENGTH, 1
    set Repetitions     = CELLS, 4
    set Young's modulus = 1000
    set Poisson's ratio = 0
    set Density         = 1
    set Dirichlet       = 0: 0; 0
  end
end
subsection Probes
  set Names = tip
  subsection tip
    set Body  = beam
    set Point = LENGTH, 0.5
  end
end
"""

BLOCK = """
set Dimension = 2
subsection Time
  set Scheme    = static
  set Step size = 1
  set End time  = 4
end
subsection Bodies
  set Names = block
  subsection block
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = 1, 0.5
    set Repetitions     = 8, 4
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
    set Density         = 1
    set Traction        = 3: 0.5*t; -10
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = block[2] : floor
  subsection block[2] : floor
    set Friction coefficient = 0.27
  end
end
"""

TOWER = """
set Dimension = 2
subsection Time
  set Scheme    = static
  set Step size = 1
  set End time  = 3
end
subsection Bodies
  set Names = lower, upper
  subsection lower
    set Shape           = box
    set Lower corner    = 0, 0
    set Upper corner    = 1, 0.5
    set Repetitions     = 8, 4
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; -1
  end
  subsection upper
    set Shape           = box
    set Lower corner    = 0.2, 0.5
    set Upper corner    = 0.8, 1
    set Repetitions     = 7, 5
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; -1
    set Traction        = 3: 0.3*t; -3*t
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = lower[2] : floor, upper[2] : lower[3]
  subsection lower[2] : floor
    set Friction coefficient = 0.3
  end
  subsection upper[2] : lower[3]
    set Friction coefficient = 0.3
  end
end
"""


def layer(name, inset, bottom, top, cells, load=""):
    """The section of a box in 3d."""
    return f"""  subsection {name}
    set Shape           = box
    set Lower corner    = {inset}, {inset}, {bottom}
    set Upper corner    = {1.28398 - inset}, {1.28398 - inset}, {top}
    set Repetitions     = {cells}, 3, 2
    set Young's modulus = 40441.2
    set Poisson's ratio = 0.3
    set Density         = 1
    {load}
  end
"""


#: Three boxes on each other in 3d, wide to narrow.
STACK = (
    """
set Dimension = 3
subsection Time
  set Scheme    = static
  set Step size = 1
  set End time  = 3
end
subsection Bodies
  set Names = low, middle, top
"""
    + layer("low", 0, 0, 0.48786, 3)
    + layer("middle", 0.1284, 0.48786, 0.91019, 4)
    + layer("top", 0.2568, 0.91019, 1.44146, 5, "set Traction = 5: 0.5*t; 0; -37*min(t, 1)")
    + """end
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 0, 1
  end
end
subsection Contact
  set Pairs = low[4] : floor, middle[4] : low[5], top[4] : middle[5]
"""
    + "".join(
        f"subsection {pair}\nset Friction coefficient = 0.1676\nend\n"
        for pair in ("low[4] : floor", "middle[4] : low[5]", "top[4] : middle[5]")
    )
    + "end\n"
)


def run_beam(name, length, load, overrides=()):
    """Four cells high."""
    text = BEAM.replace("LENGTH", str(length)).replace("CELLS", str(4 * length))
    return check_history.Run(text, name, [f"Bodies/beam/{load}", *overrides])


class Statics(check_history.SceneTest):
    def expect_failure(self, text, name, words, overrides=()):
        """Exit status 1, and a message with these words."""
        with self.assertRaises(AssertionError) as failure:
            check_history.Run(text, name, overrides)
        message = str(failure.exception)
        self.assertIn("exit status 1", message)
        for word in words:
            self.assertIn(word, message)

    def expect_tip(self, length, load, bending, shear):
        """The tip of a cantilever goes down as Timoshenko says: I = 1/12, kappa = 5/6.

        The mesh is 1/4 as fine as the beam is thick: its error is 5e-5 at L = 30, where the clamped
        end, which Timoshenko does not see, is as large.
        """
        run = run_beam(f"beam-{length}-{load[0]}", length, load)
        exact = bending / (MODULUS / 12) + shear / (5 / 6 * MODULUS / 2)
        self.expect_close(-run.probes["tip"]["displacement_y"][0], exact, 2e-4, "tip")
        products = int(re.search(r"found with (\d+) products", run.log).group(1))
        self.assertLess(products, MOST_PRODUCTS)

    def test_cantilevers(self):
        for length in (30, 100):
            force, weight = 1e-4, 1e-5
            with self.subTest(length=length):
                self.expect_tip(
                    length,
                    f"Traction=1: 0; {-force}",
                    force * length**3 / 3,
                    force * length,
                )
                self.expect_tip(
                    length,
                    f"Body force=0; {-weight}",
                    weight * length**4 / 8,
                    weight * length**2 / 2,
                )

    def test_products_do_not_grow_with_the_mesh(self):
        for refinements in (0, 1, 2):
            run = run_beam(
                f"mesh-{refinements}",
                30,
                "Body force=0; -1e-5",
                [f"Bodies/beam/Refinements={refinements}"],
            )
            products = int(re.search(r"found with (\d+) products", run.log).group(1))
            self.assertLess(products, MOST_PRODUCTS, f"{refinements} refinements")

    def test_hertz(self):
        run = check_history.Run(check_history.scene_file("static_hertz"), "hertz")
        cell = 1 / 128
        for row in range(1, len(run)):
            load = 0.6 * run["time"][row]
            width = math.sqrt(4 * load * 4 / (math.pi * MODULUS / (1 - 0.3**2)))
            pressure = run.probes["middle"]["pressure"][row]
            self.expect_close(run["contact_force"][row], load, 1e-9, "force")
            # A dome ten times as large as its contact is no half-space.
            self.expect_close(pressure, 2 * load / (math.pi * width), 0.01, "pressure")
            outermost = (run["active_nodes"][row] - 1) / 2 * cell
            self.assertLess(abs(outermost - width), 1.05 * cell)
            self.assertEqual(run["kinetic_energy"][row], 0.0)
            self.assertLess(run["products_stiffness"][row], 150)
        self.expect_ledger_closes(run, driven=True)
        # The pressure follows the load, and the work of the load is elastic energy, but for the
        # way of nodes to the plane, half a load step too early.
        self.assertLess(abs(sum(run["work_contact"])), 0.01 * run["elastic_energy"][-1])

    def test_block_sticks_up_to_the_limit_of_friction(self):
        run = check_history.Run(BLOCK, "stick", ["Time/End time=5"])
        self.expect_ledger_closes(run, driven=True)
        for row in range(1, len(run)):
            force = run.vector("contact_force", row)
            self.assertAlmostEqual(force[0], -0.5 * run["time"][row], delta=1e-9)
            self.assertAlmostEqual(force[1], 10.0, delta=1e-9)
            self.assertGreater(run["stick_nodes"][row], 0)
            self.assertLessEqual(run["work_friction"][row], 0.0)
        # 0.5 t = 0.27 * 10 at t = 5.4
        self.expect_failure(
            BLOCK, "slip", ["at time 6", "'block' moves along x.", "friction"], ["Time/End time=8"]
        )

    def test_block_that_tips(self):
        """About its corner (1, 0), whose distance from the middle is (1/2, -1/4): the middle
        moves along (1, 2)."""
        tipping = [
            "Bodies/block/Traction=1: t - 1; 0",
            "Bodies/block/Body force=0; -0.7",
            "Contact/block[2] : floor/Friction coefficient=20",
        ]
        self.expect_failure(
            BLOCK, "tip", ["at time 3", "along (0.447, 0.894) and turns about z"], tipping
        )

    def test_free_motions_without_load_are_left_alone(self):
        """Contact holds the block; sideways nothing holds it, and nothing pushes."""
        run = check_history.Run(
            BLOCK,
            "sideways",
            [
                "Bodies/block/Traction=3: 0; -10",
                "Contact/block[2] : floor/Friction coefficient=0",
                "Obstacles/floor/Point=0, -0.3",
            ],
        )
        # Plane strain, uniform: sigma^2/(2 E) (1 - nu^2) over the area.
        self.expect_close(run["elastic_energy"][-1], 100 / 2000 * 0.91 / 2, 1e-8, "elastic energy")
        self.assertAlmostEqual(run["contact_force"][-1], 10.0, delta=1e-8)

    def test_bodies_without_supports_are_named(self):
        pull = ["Bodies/block/Traction=3: 0; 1"]
        self.expect_failure(BLOCK, "pulled", ["at time 1", "'block' moves along y"], pull)
        self.expect_failure(
            TOWER,
            "group",
            ["at time 1", "'lower' moves along x; 'upper' moves along x"],
            ["Contact/lower[2] : floor/Friction coefficient=0"],
        )

    def test_tower(self):
        """Two blocks on a floor: weights and loads arrive at it, on one and two processes."""
        runs = [check_history.Run(TOWER, f"tower-{n}", processes=n) for n in (1, 2)]
        for run in runs:
            self.expect_ledger_closes(run, driven=True)
            for row in range(1, len(run)):
                time = run["time"][row]
                # The lower pair bears both weights, the upper one that of the upper block.
                self.assertAlmostEqual(
                    run["contact_force"][row], 0.5 + 0.3 + 0.3 + 2 * 1.8 * time, delta=1e-8
                )
                self.assertAlmostEqual(
                    run.vector("contact_force", row)[0], -2 * 0.18 * time, delta=1e-8
                )
                self.assertLess(run["products_stiffness"][row], 300)
        for column in ("elastic_energy", "contact_force", "work_friction"):
            for one, two in zip(runs[0][column], runs[1][column]):
                self.assertAlmostEqual(one, two, delta=1e-9)

    def test_equilibrium_at_the_start_names_what_moves(self):
        run = check_history.Run(
            BLOCK,
            "start",
            [
                "Time/Scheme=contact-stabilized",
                "Time/Start=equilibrium",
                "Time/Step size=1e-3",
                "Time/End time=2e-3",
                "Bodies/block/Traction=3: 1; -10",
                "Contact/block[2] : floor/Friction coefficient=0",
            ],
        )
        self.assertIn("'block' moves along x: begins to move", run.log)

    def test_loads_that_are_held(self):
        """Nearly incompressible blocks bulge under their weight and slip. Under the same load
        nothing moves any more, and that costs three products, although all nodes that slipped are
        at the limit of friction; then a push grows, goes back and turns round."""
        push = "if(t<2.5, 0, 0.02*sin(t - 2))"
        for ratio in (0.49, 0.499):
            for friction in (0.1, 0.5):
                with self.subTest(ratio=ratio, friction=friction):
                    overrides = ["Time/End time=9", f"Bodies/upper/Traction=3: {push}; 0"]
                    for body in ("lower", "upper"):
                        overrides.append(f"Bodies/{body}/Poisson's ratio={ratio}")
                    for pair in ("lower[2] : floor", "upper[2] : lower[3]"):
                        overrides.append(f"Contact/{pair}/Friction coefficient={friction}")
                    run = check_history.Run(TOWER, f"held-{ratio}-{friction}", overrides)
                    self.expect_ledger_closes(run, driven=True)
                    self.assertGreater(run["slip_nodes"][1], 0)
                    self.assertLessEqual(run["products_stiffness"][2], 3)
                    for row in range(1, len(run)):
                        time = run["time"][row]
                        expected = 0.02 * math.sin(time - 2) * 0.6 if time > 2.5 else 0
                        force = run.vector("contact_force", row)
                        self.assertAlmostEqual(force[0], -expected * 2, delta=1e-8)
                        self.assertAlmostEqual(force[1], 0.5 + 2 * 0.3, delta=1e-8)
                        self.assertLessEqual(run["work_friction"][row], 1e-12)

    def test_nodes_that_all_slip_hold_what_their_directions_hold(self):
        """A first load presses the boxes wider: most nodes slip, each in its own direction. A push
        of 8 % of the limit turns these directions a little. At 3.3 t = 0.1676 * 37 they slide."""
        run = check_history.Run(STACK, "stack")
        self.expect_ledger_closes(run, driven=True)
        self.assertGreater(run["slip_nodes"][1], run["stick_nodes"][1])
        for row in range(1, len(run)):
            force = [f / (1.28398 - 2 * 0.2568) ** 2 for f in run.vector("contact_force", row)]
            self.assertAlmostEqual(force[0], -3 * 0.5 * run["time"][row], delta=1e-7)
            self.assertAlmostEqual(force[2], 3 * 37, delta=1e-7)
        self.expect_failure(
            STACK,
            "stack-slides",
            ["at time 2", "moves along"],
            ["Time/End time=4", "Bodies/top/Traction=5: 3.3*t; 0; -37*min(t,1)"],
        )

    def test_mesh_follows_the_load(self):
        """On a mesh that changes, each step is an equilibrium again."""
        run = check_history.Run(
            check_history.scene_file("static_hertz"),
            "adaptive",
            [
                "Bodies/dome/Local refinements=1",
                "Adaptivity/Indicator=residual",
                "Adaptivity/Maximum level=4",
                "Adaptivity/Maximum cells=2000",
            ],
        )
        self.assertGreater(max(run["cells"]), run["cells"][0])
        self.expect_ledger_closes(run, driven=True)
        for row in range(1, len(run)):
            self.expect_close(run["contact_force"][row], 0.6 * run["time"][row], 1e-8, "force")


if __name__ == "__main__":
    check_history.main()
