#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs on meshes that change: the account of the energy closes with the column energy_transfer, the
contact force is that of a fine uniform mesh at a part of its unknowns, a mesh that need not change
is kept, changes of the mesh give no blow, a front in a bar is followed, and any number of processes
makes the same meshes.
"""

import math

import check_history

BALL = ["Mapping=curved", "Bodies/ball/Refinements=2"]
#: A round body on a mesh that changes has curved cells by default.
DISTANCE = [
    "Bodies/ball/Refinements=2",
    "Adaptivity/Indicator=distance",
    "Adaptivity/Maximum level=3",
    "Adaptivity/Distance=0.06",
]
#: Scenes that are shipped.
SCENES = ("adaptive_bar", "adaptive_ball")
WATCHED = BALL + [
    "Adaptivity/Indicator=residual",
    "Adaptivity/Maximum level=3",
    "Adaptivity/Distance=0.06",
    "Adaptivity/Maximum cells=1500",
]
RESIDUAL = BALL + [
    "Adaptivity/Indicator=residual",
    "Adaptivity/Maximum level=3",
    "Adaptivity/Repetitions=1",
    "Adaptivity/Maximum cells=1500",
]
#: Without loads and contact.
DAMPED_FLIGHT = """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = 0.1
end
subsection Bodies
  set Names = box
  subsection box
    set Shape            = box
    set Lower corner     = 0, 0
    set Upper corner     = 2, 1
    set Refinements      = 1
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 1; 0
  end
end
subsection Adaptivity
  set Indicator     = residual
  set Maximum level = 4
  set Hysteresis    = 0
end
"""


def distance(force, reference):
    """Relative, L2 in time."""
    return math.sqrt(
        sum((a - b) ** 2 for a, b in zip(force, reference)) / sum(b**2 for b in reference)
    )


def roughness(force):
    """Mean of the second differences over the mean."""
    second = [abs(force[k + 1] - 2.0 * force[k] + force[k - 1]) for k in range(1, len(force) - 1)]
    return sum(second) / len(second) / (sum(force) / len(force))


def kicks(run):
    """Mean second difference of the contact force where the mesh changed, over that elsewhere."""
    changed, other = [], []
    force, cells = run["contact_force"], run["cells"]
    for k in range(1, len(force) - 1):
        if min(force[k - 1 : k + 2]) > 0.0:
            (other if cells[k - 1] == cells[k] == cells[k + 1] else changed).append(
                abs(force[k + 1] - 2.0 * force[k] + force[k - 1])
            )
    return sum(changed) / len(changed) / (sum(other) / len(other))


def n_meshes(run):
    return sum(a != b for a, b in zip(run["cells"], run["cells"][1:])) + 1


class Adaptivity(check_history.SceneTest):
    def run_ball(self, name, overrides, processes=1):
        return check_history.Run(
            check_history.PARAMETERS / "geometry_a.prm", f"adaptivity-{name}", overrides, processes
        )

    def expect_account(self, run, tolerance):
        """The ledger closes; a new mesh brings no energy but for the quadrature of curved cells."""
        self.expect_ledger_closes(run)
        energy = run["total_energy"][0]
        for row in range(1, len(run)):
            self.assertLessEqual(
                run["energy_transfer"][row],
                tolerance * energy,
                f"energy of the transfer in row {row}",
            )
            change = run["total_energy"][row] - run["total_energy"][row - 1]
            booked = sum(
                run[column][row]
                for column in (
                    "work_contact",
                    "work_predictor",
                    "work_scheme",
                    "energy_transfer",
                    "energy_residual",
                )
            )
            self.assertLessEqual(
                abs(change - booked), 1e-12 * energy, f"change of the energy in row {row}"
            )

    def test_contact_force_of_a_finer_mesh(self):
        """Cells as in refinement 3 where contact is or will be soon."""
        fine = self.run_ball("uniform-3", ["Mapping=curved", "Bodies/ball/Refinements=3"])
        coarse = self.run_ball("uniform-2", BALL)
        # Curved cells of a quarter of the radius are integrated to 1e-10; residual changes more of
        # them in the middle of contact.
        for name, overrides, error, transfer in (
            ("distance", DISTANCE, 0.03, 1e-11),
            ("residual", RESIDUAL, 0.03, 1e-9),
            ("watched", WATCHED, 0.03, 1e-9),
        ):
            with self.subTest(indicator=name):
                run = self.run_ball(name, overrides)
                self.expect_account(run, transfer)
                self.assertGreater(n_meshes(run), 1)
                self.assertLess(max(run["dofs"]), 0.6 * fine["dofs"][0])
                self.assertLess(distance(run["contact_force"], fine["contact_force"]), error)
                if (
                    name != "residual"
                ):  # which refines late, when nodes have touched on coarse cells
                    self.assertLess(
                        roughness(run["contact_force"]), 1.3 * roughness(fine["contact_force"])
                    )
        self.assertGreater(distance(coarse["contact_force"], fine["contact_force"]), 0.05)

    def test_shipped_ball(self):
        run = check_history.Run(
            check_history.PARAMETERS / "adaptive_ball.prm",
            "adaptive_ball",
            [
                "Bodies/ball/Refinements=2",
                "Adaptivity/Maximum level=4",
                "Adaptivity/Maximum cells=3000",
            ],
        )
        self.expect_contact(run)
        self.expect_account(run, 1e-9)
        self.expect_no_penetration(run, 2.0)
        self.assertGreater(n_meshes(run), 4)

    def test_no_kick(self):
        """Where the mesh changes, the contact force is as smooth as elsewhere."""
        run = self.run_ball(
            "kicks", DISTANCE + ["Adaptivity/Maximum level=4", "Adaptivity/Distance=0"]
        )
        self.assertGreater(n_meshes(run), 5)
        self.assertLess(kicks(run), 1.2)

    def test_bar_against_uniform_meshes(self):
        """Displacement error against the exact solution: fine cells at the front only are worth
        twice as many, and half of the steps do."""
        coarse, fine = (
            check_history.Run(
                check_history.PARAMETERS / "bar_2d.prm",
                f"adaptivity-bar-{level}",
                [
                    "Time/Scheme=generalized-alpha",
                    f"Bodies/bar/Refinements={level}",
                    f"Time/Step size={3e-3 / 2**level}",
                ],
            )
            for level in (1, 2)
        )
        run = check_history.Run(
            check_history.PARAMETERS / "adaptive_bar.prm",
            "adaptive_bar",
            [
                "Adaptivity/Maximum level=2",
                "Time/Step size=7.5e-4",
                "Time/Minimum step size=7.5e-4",
            ],
        )
        self.expect_ledger_closes(run)
        error, worst, best = (
            history["relative_displacement_error"][-1] for history in (run, coarse, fine)
        )
        self.assertTrue(best < error < worst)
        way = math.log(worst / error) / math.log(worst / best)
        needed = coarse["dofs"][0] * (fine["dofs"][0] / coarse["dofs"][0]) ** way
        mean = sum(run["dofs"][1:]) / (len(run) - 1)
        print(
            f"bar: error {100 * error:.3f} %, {mean:.0f} unknowns instead of {needed:.0f},"
            f" {len(run) - 1} steps instead of {len(fine) - 1}"
        )
        self.assertGreater(needed / mean, 2.0)
        self.assertLess(len(run), 0.5 * len(fine))

    def test_flight_keeps_the_mesh(self):
        """A body that flies undeformed, far from obstacles, has nothing to refine."""
        for name, indicator in (
            ("residual", RESIDUAL),
            ("kelly", [entry.replace("residual", "kelly") for entry in RESIDUAL]),
        ):
            run = self.run_ball(
                f"flight-{name}", indicator + ["Bodies/ball/Centre=0, 0, 9", "Time/End time=0.1"]
            )
            self.assertEqual(n_meshes(run), 1)
            self.assertNotIn("mesh              changed", run.log)
            self.assertEqual(max(map(abs, run["energy_transfer"])), 0.0)

    def test_block_with_friction(self):
        """Slip and status go along; the block comes as far as on a fixed mesh, without a gain."""
        kept = check_history.Run(
            check_history.PARAMETERS / "sliding_block.prm",
            "adaptivity-block-kept",
            ["Time/End time=0.3"],
        )
        run = check_history.Run(
            check_history.PARAMETERS / "sliding_block.prm",
            "adaptivity-block",
            [
                "Time/End time=0.3",
                "Adaptivity/Indicator=residual",
                "Adaptivity/Maximum level=3",
                "Adaptivity/Maximum cells=1200",
            ],
        )
        motion = max(map(sum, zip(run["kinetic_energy"], run["elastic_energy"])))
        way = run["max_slip"]
        works = [0.0] + [after * (after - before) for before, after in zip(way, way[1:])]
        for row in range(1, len(run)):
            # Besides what the solver promises: round-off in the forces of so stiff a body. It grows
            # with the way and does work along each step, on meshes that stay, too.
            round_off = 1e-9 * works[row] / max(works)
            self.assertLessEqual(
                abs(run["energy_residual"][row]),
                (1e-10 + round_off) * motion,
                f"energy residual in row {row}",
            )
            self.assertLessEqual(run["work_friction"][row], 1e-10 * motion)
        self.assertGreater(n_meshes(run), 1)
        self.expect_close(run["max_slip"][-1], kept["max_slip"][-1], 1e-3, "way")

    def test_steps_and_meshes_that_adapt(self):
        for control, tolerance in (("doubling", 0.05), ("force", 0.2)):
            with self.subTest(control=control):
                run = self.run_ball(
                    f"steps-{control}",
                    DISTANCE
                    + [f"Time/Step size control={control}", f"Time/Step tolerance={tolerance}"],
                )
                self.assertGreater(n_meshes(run), 1)
                self.assertAlmostEqual(run["time"][-1], 0.5, 12)
                self.expect_account(run, 1e-11)

    def expect_same_meshes(self, one, two, momentum):
        self.assertEqual(one["cells"], two["cells"])
        self.assertEqual(one["dofs"], two["dofs"])
        for column in ("contact_force", "total_energy", "kinetic_energy", momentum):
            scale = max(map(abs, one[column]))
            for row in range(len(one)):
                self.assertLessEqual(
                    abs(one[column][row] - two[column][row]), 1e-8 * scale, f"{column} in row {row}"
                )

    def test_two_processes(self):
        for name, overrides in (("distance", DISTANCE), ("residual", RESIDUAL)):
            self.expect_same_meshes(
                *(
                    self.run_ball(f"processes-{name}-{n}", overrides + ["Time/End time=0.2"], n)
                    for n in (1, 2)
                ),
                "momentum_z",
            )

    def test_coarsening_across_processes(self):
        """Cells are coarsened in every step, on several levels beside each other."""
        overrides = [
            "Bodies/disc/Refinements=2",
            "Mapping=curved",
            "Time/End time=0.15",
            "Adaptivity/Indicator=residual",
            "Adaptivity/Maximum level=5",
            "Adaptivity/Maximum cells=300",
            "Adaptivity/Hysteresis=0",
            "Adaptivity/Coarsen fraction=0.3",
            "Adaptivity/Coarsen ratio=0.5",
        ]
        self.expect_same_meshes(
            *(
                check_history.Run(
                    check_history.PARAMETERS / "disc_2d.prm",
                    f"adaptivity-coarsening-{n}",
                    overrides,
                    n,
                )
                for n in (1, 2)
            ),
            "momentum_y",
        )

    def test_damping_is_no_error(self):
        """A box in uniform translation that its damping brakes: nothing to be resolved."""
        for damping in ("0, 0", "10, 0.01"):
            run = check_history.Run(
                DAMPED_FLIGHT, "damped_flight", [f"Bodies/box/Damping={damping}"]
            )
            self.assertEqual(set(run["cells"]), {4.0})
        self.assertLess(run["total_energy"][-1], 0.5 * run["total_energy"][0])


if __name__ == "__main__":
    check_history.main()
