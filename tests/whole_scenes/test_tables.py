# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The tables beside the history, against laws that hold to the accuracy of the solver: pairs add up
to the history, and their moments turn the slave; bodies add up to the history; points of a body in
pure bending have the stress of the beam; a point of a round surface is followed however small the
cells get; rows of a history of every seventh step explain the change of energy as all rows do; and
the copy of a scene repeats the run."""

import itertools
import math
import os
import pathlib
import re
import subprocess

import check_history
from check_history import ACCURACY, Run, read_table
from test_supports import FRICTION, HANGING_BLOCK, combine, vectors

#: A beam of length 4 and height 1, clamped on the left and bent by the stress y on the right: with
#: Poisson's ratio 0 the stress is y everywhere, and the curvature 1/E = 0.01.
BENT_BEAM = """
set Dimension = 2
subsection Time
  set Start     = equilibrium
  set Step size = 1e-2
  set End time  = 0.03
end
subsection Bodies
  set Names = beam
  subsection beam
    set Shape           = box
    set Lower corner    = 0, -0.5
    set Upper corner    = 4, 0.5
    set Repetitions     = 4, 1
    set Young's modulus = 100
    set Poisson's ratio = 0
    set Density         = 1
    set Dirichlet       = 0: 0; 0
    set Traction        = 1: y; 0
  end
end
subsection Probes
  set Names = inside, corner
  subsection inside
    set Body  = beam
    set Point = 1.3, 0.2
  end
  subsection corner
    set Body  = beam
    set Point = 4, 0.5
  end
end
"""


#: A disc of radius 1 above a floor: a polygon of 16 edges. The probe lies on the circle, beyond the
#: middle of an edge, which is cos 11.25 degrees from the centre.
FALLING_DISC = """
set Dimension = 2
set Mapping   = linear
subsection Time
  set Step size = 1e-2
  set End time  = 0.1
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape            = ball
    set Centre           = 0, 0
    set Radius           = 1
    set Refinements      = 2
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0; -1
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Point  = 0, -1.2
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = disc : floor
end
subsection Adaptivity
  set Indicator     = distance
  set Distance      = 0.18
  set Maximum level = 5
end
subsection Probes
  set Names = below
  subsection below
    set Body  = disc
    set Point = 0.195090, -0.980785
  end
end
"""


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class Tables(check_history.SceneTest):
    def test_two_processes(self):
        """All tables, with contact and moving supports."""
        one, two = (
            Run(HANGING_BLOCK, f"hanging-{processes}", [FRICTION], processes)
            for processes in (1, 2)
        )
        for name in ("supports", "pairs", "bodies"):
            columns, others = one.table(name), two.table(name)
            self.assertEqual(list(columns), list(others))
            scale = max(abs(value) for column in columns.values() for value in column)
            for column in columns:
                for a, b in zip(columns[column], others[column]):
                    self.assertLessEqual(abs(a - b), 1e-7 * scale, column)

    def test_pairs_and_bodies_add_up(self):
        """Three boxes: the force of a pair is what slave and master feel, and the sums over pairs
        and bodies are columns of the history."""
        run = Run(
            check_history.scene_file("stack_of_boxes"),
            "stack",
            ["Time/End time=0.06"]
            + [f"Bodies/{body}/Refinements=0" for body in ("lower", "middle", "upper")],
        )
        pairs, bodies = run.table("pairs"), run.table("bodies")
        self.assertGreater(min(max(pairs[f"pair_{k}_active_nodes"]) for k in range(3)), 3)
        forces = [vectors(pairs, f"pair_{k}_force") for k in range(3)]
        momenta = {
            name: vectors(bodies, f"body_{name}_momentum") for name in ("lower", "middle", "upper")
        }
        # Masses 0.4, 0.256 and 0.144 with the weights 4, 2.56, 1.44.
        felt = {"lower": (4.0, 0, 1), "middle": (2.56, 1, 2), "upper": (1.44, 2, None)}
        largest = max(max(map(abs, momentum)) for momentum in momenta["lower"])
        for row in range(1, len(run)):
            size = run["step_size"][row]
            for name, (weight, slave, master) in felt.items():
                force = combine((weight, (0.0, 0.0, -1.0)), (1.0, forces[slave][row]))
                if master is not None:
                    force = combine((1.0, force), (-1.0, forces[master][row]))
                for c in range(3):
                    change = momenta[name][row][c] - momenta[name][row - 1][c]
                    self.assertLessEqual(abs(change - size * force[c]), ACCURACY * largest, name)
        scale = max(run["contact_force"])
        for row in range(len(run)):
            total = sum(pairs[f"pair_{k}_normal_force"][row] for k in range(3))
            self.assertLessEqual(abs(total - run["contact_force"][row]), 1e-12 * scale)
            nodes = sum(pairs[f"pair_{k}_active_nodes"][row] for k in range(3))
            self.assertEqual(nodes, run["active_nodes"][row])
            deepest = max(pairs[f"pair_{k}_max_penetration"][row] for k in range(3))
            self.assertEqual(deepest, run["max_penetration"][row])
            for column in ("kinetic_energy", "elastic_energy"):
                energy = sum(bodies[f"body_{name}_{column}"][row] for name in momenta)
                self.assertLessEqual(abs(energy - run[column][row]), 1e-12 * max(run[column]))

    def test_moments_turn_the_slave(self):
        """Two balls collide off their centres: the angular momentum of the slave about the origin,
        that about its centroid and that of its centroid, changes by the moment."""
        run = Run(
            check_history.scene_file("two_balls_off_centre"),
            "off-centre",
            ["Time/End time=0.2"]
            + [f"Bodies/{body}/Refinements=2" for body in ("upper", "lower")]
            + ["Contact/upper : lower/Friction coefficient=0.3"],
        )
        pairs, bodies = run.table("pairs"), run.table("bodies")
        moments = vectors(pairs, "pair_0_moment")
        spin = vectors(bodies, "body_upper_angular_momentum")
        momentum = vectors(bodies, "body_upper_momentum")
        centre = vectors(bodies, "body_upper_centroid")[0]
        angular = [combine((1.0, s), (1.0, cross(centre, p))) for s, p in zip(spin, momentum)]
        largest = max(abs(c) for vector in angular for c in vector)
        self.assertGreater(max(abs(moment[1]) for moment in moments), 0.1)
        for row in range(1, len(run)):
            size = run["step_size"][row]
            for c in range(3):
                change = angular[row][c] - angular[row - 1][c]
                self.assertLessEqual(
                    abs(change - size * moments[row][c]), ACCURACY * largest, f"row {row}"
                )
        # The centroid moves with the mean velocity.
        centroid, velocity = (vectors(bodies, f"body_upper_{q}") for q in ("centroid", "velocity"))
        moved = sum(run["step_size"][row] * velocity[row][2] for row in range(1, len(run)))
        self.assertLess(abs(centroid[-1][2] - centroid[0][2] - moved), 5e-3)

    def test_history_of_some_steps(self):
        """Every seventh row of 100, the first and the last: works of the steps between are in the
        next row."""
        everything = Run(HANGING_BLOCK, "every-1", [FRICTION])
        some = Run(HANGING_BLOCK, "every-7", [FRICTION, "Output/History every=7"])
        self.assertEqual(some["step"], [*map(float, range(0, 99, 7)), 100.0])
        self.assertEqual(some.table("supports")["step"], some["step"])
        scale = some.energy_scales(True)[-1]
        works = [name for name in some.history if name.startswith("work_")]
        for name in works + ["energy_residual", "linear_iterations", "products_combined"]:
            difference = sum(some[name]) - sum(everything[name])
            self.assertLessEqual(abs(difference), 1e-12 * max(scale, sum(everything[name])), name)
        for row, (before, now) in enumerate(itertools.pairwise(some["total_energy"])):
            explained = sum(some[name][row + 1] for name in works)
            self.assertLessEqual(abs(now - before - explained), 7 * ACCURACY * scale)

    def test_points_of_a_bent_beam(self):
        """The stress within a cell is that of the element with its modes; on an adaptive mesh and
        two processes the same."""
        adaptive = ["Adaptivity/Indicator=residual", "Adaptivity/Maximum level=2"]
        for overrides, processes in (([], 1), ([], 2), (adaptive, 2)):
            with self.subTest(overrides=overrides, processes=processes):
                run = Run(BENT_BEAM, "beam", overrides, processes)
                for name, x, y in (("inside", 1.3, 0.2), ("corner", 4.0, 0.5)):
                    probe = run.probes[name]
                    for row in range(len(run)):
                        self.assertAlmostEqual(probe["stress_xx"][row], y, delta=1e-8)
                        self.assertAlmostEqual(probe["von_mises"][row], y, delta=1e-8)
                        self.assertAlmostEqual(probe["velocity_y"][row], 0.0, delta=1e-8)
                        # Between nodes the displacement is interpolated.
                        bend = -0.005 * (x * x + (0.7 * 0.3 if name == "inside" else 0.0))
                        if not overrides:
                            self.assertAlmostEqual(probe["displacement_y"][row], bend, delta=1e-8)
                            self.assertAlmostEqual(
                                probe["position_x"][row], x + 0.01 * x * y, delta=1e-8
                            )

    def test_a_point_outside_is_refused(self):
        with self.assertRaises(AssertionError) as failure:
            Run(BENT_BEAM, "outside", ["Probes/inside/Point=1.3, 0.7"])
        message = str(failure.exception)
        for part in ("exit status 2", "Probes/inside/Point", "(1.3 0.7)", "`beam`", "(4 0.5)"):
            self.assertIn(part, message)

    def test_a_point_of_a_circle_stays_while_cells_are_refined(self):
        """The facets are those of the first mesh, and so is the distance that is accepted."""
        run = Run(FALLING_DISC, "circle")
        self.assertGreater(run["cells"][-1], run["cells"][0])
        probe = run.probes["below"]
        for row in range(len(run)):
            x, y = (
                probe[f"position_{axis}"][row] - probe[f"displacement_{axis}"][row] for axis in "xy"
            )
            self.assertAlmostEqual(math.hypot(x, y), math.cos(math.pi / 16), delta=1e-3)

    def test_the_message_names_the_body_as_it_is(self):
        """The coarse mesh of the disc has its corners at angles of 45 degrees, where x and y are
        0.707."""
        with self.assertRaises(AssertionError) as failure:
            Run(FALLING_DISC, "beside", ["Probes/below/Point=0, -1.3"])
        self.assertIn("lies between (-1 -1) and (1 1)", str(failure.exception))

    def test_the_copy_repeats_the_run(self):
        """With what the command line said, and with a mesh that the scene finds by its own folder,
        from another folder."""
        run = Run(
            check_history.scene_file("hammer_and_anvil"),
            "copied",
            ["Time/End time=0.02", "Bodies/hammer/Refinements=0", "Bodies/anvil/Refinements=0"],
        )
        copy = run.folder / "output" / "scene.prm"
        elsewhere = run.folder.parent / "elsewhere"
        elsewhere.mkdir(parents=True, exist_ok=True)
        result = subprocess.run(
            [
                pathlib.Path(check_history.settings["executable"]).resolve(),
                copy.resolve(),
                "--quiet",
                "--set",
                f"Output directory={(run.folder / 'again').resolve()}",
            ],
            cwd=elsewhere,
            env=dict(os.environ, OMP_NUM_THREADS="1"),
            capture_output=True,
            text=True,
            timeout=check_history.TIMEOUT,
            check=False,
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        again = read_table(run.folder / "again" / "history.csv")
        self.assertEqual(run["total_energy"], again["total_energy"])
        self.assertEqual(run["dofs"], again["dofs"])
        text = copy.read_text(encoding="utf-8")
        self.assertIn("boundary ids: hammer 1 face", re.sub(r"\s+", " ", text).lower())


if __name__ == "__main__":
    check_history.main()
