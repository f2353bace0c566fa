#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs on meshes that are made for the contact force: the target is met at a part of the unknowns
of a uniform mesh, the estimate at the end is right but for a factor, contact after a flight does
not begin on coarse cells, waves make the mesh uniform, contact that travels changes it now and
then, and two processes make the same meshes.
"""

import re

import check_history
import test_adaptivity as mesh_runs

#: A slow impact, whose contact stays small.
SLOW_DISC = [
    "Mapping=curved",
    "Bodies/disc/Initial velocity=0; -0.06",
    "Time/Step size=8e-3",
    "Time/End time=0.48",
    "Output/VTU=false",
]


class ForceGoal(check_history.SceneTest):
    expect_account = mesh_runs.Adaptivity.expect_account
    expect_same_meshes = mesh_runs.Adaptivity.expect_same_meshes

    def run_disc(self, name, overrides, processes=1):
        scene = check_history.PARAMETERS / "disc_2d.prm"
        return check_history.Run(scene, name, overrides, processes)

    def estimated_error(self, run):
        """Of the contact force, as the summary says."""
        return 0.01 * float(re.search(r"error of force +about (\S+) %", run.log)[1])

    def test_goal_is_the_contact_force(self):
        """The target is met, at a part of the unknowns, and the estimate is right but for a factor.

        The reference is a uniform mesh. It has an error of its own of nearly one per cent.
        """
        fine = self.run_disc("fine", SLOW_DISC + ["Bodies/disc/Refinements=6"])
        for target, levels, dofs in (
            (0.05, (3, 7), 0.05),
            (0.01, (3, 7), 0.1),
            (1.0, (4, 4), 0.1),
        ):
            with self.subTest(target=target):
                aims = [
                    f"Bodies/disc/Refinements={levels[0]}",
                    "Adaptivity/Indicator=residual",
                    "Adaptivity/Goal=contact force",
                    f"Adaptivity/Target error={target}",
                    f"Adaptivity/Maximum level={levels[1]}",
                ]
                run = self.run_disc(f"target-{target}", SLOW_DISC + aims)
                self.expect_account(run, 1e-9)
                error = mesh_runs.distance(run["contact_force"], fine["contact_force"])
                self.assertLess(error, 1.5 * target)
                self.assertLess(error / 3.0, self.estimated_error(run))
                self.assertLess(self.estimated_error(run), 3.0 * error)
                self.assertLess(sum(run["dofs"]) / len(run), dofs * fine["dofs"][0])
        self.assertEqual(mesh_runs.n_meshes(run), 1)

    def test_contact_of_one_node(self):
        """A ball on coarse cells, where one node carries all of the contact, has a force that is
        wrong by a third. It is known by the gap beside this node, and told; and the contact is
        refined until the target is met."""
        scene = check_history.scene_file("steel_ball")
        fine, coarse, aimed = (
            check_history.Run(
                scene,
                name,
                [
                    f"Bodies/ball/Refinements={first}",
                    "Bodies/ball/Local refinements=0",
                    "Bodies/ball/Initial velocity=0; 0; -1e4",
                    "Time/Spectral radius=1",
                    "Time/Step size=8e-7",
                    "Time/End time=5e-5",
                    "Adaptivity/Indicator=residual",
                    "Adaptivity/Goal=contact force",
                    f"Adaptivity/Target error={target}",
                    f"Adaptivity/Maximum level={last}",
                    "Output/VTU=false",
                ],
            )
            for name, first, last, target in (
                ("ball-fine", 3, 6, 0.01),
                ("ball-coarse", 3, 3, 0.1),
                ("ball-aimed", 2, 6, 0.1),
            )
        )
        for run, least, most in ((coarse, 0.25, 0.5), (aimed, 0.0, 0.1)):
            error = mesh_runs.distance(run["contact_force"], fine["contact_force"])
            self.assertLess(least, error)
            self.assertLess(error, most)
            self.assertLess(error / 3.0, self.estimated_error(run))
            self.assertLess(self.estimated_error(run), 3.0 * error)
        self.assertIn("the target was 10 %", coarse.log)
        self.assertLess(max(aimed["cells"]), 0.5 * coarse["cells"][0])

    def test_contact_after_a_flight(self):
        """The first steps of contact are judged, too: what they spoil, later meshes do not mend."""
        flight = [
            "Mapping=curved",
            "Bodies/disc/Centre=0, 1.02",
            "Bodies/disc/Initial velocity=0; -1",
            "Time/Step size=1e-2",
            "Time/End time=0.4",
        ]
        aims = [
            "Bodies/disc/Refinements=2",
            "Adaptivity/Indicator=residual",
            "Adaptivity/Goal=contact force",
            "Adaptivity/Target error=0.01",
            "Adaptivity/Maximum level=6",
        ]
        fine = self.run_disc("flight-fine", [*flight, "Bodies/disc/Refinements=6"])
        run = self.run_disc("flight", flight + aims)
        self.assertLess(mesh_runs.distance(run["contact_force"], fine["contact_force"]), 0.015)
        self.assertLess(max(run["cells"]), 0.1 * fine["cells"][0])

    def test_a_flight_ends_unexpectedly(self):
        """A mesh is looked at now and then in flight. Contact that could not be foreseen from the
        motion of the body, here that of an obstacle, is judged at once, and its first step is made
        again on a finer mesh."""
        run = self.run_disc(
            "lifted",
            [
                "Mapping=curved",
                "Bodies/disc/Centre=0, 1.1",
                "Bodies/disc/Refinements=3",
                "Bodies/disc/Initial velocity=0; 0",
                "Obstacles/floor/Motion=0; 2*t",
                "Time/End time=0.1",
                "Adaptivity/Indicator=residual",
                "Adaptivity/Goal=contact force",
                "Adaptivity/Target error=0.01",
                "Adaptivity/Maximum level=6",
                "Output/VTU=false",
            ],
        )
        touch = next(i for i, force in enumerate(run["contact_force"]) if force > 0.0)
        self.assertGreater(touch, 3, "there is a flight")
        self.assertGreater(run["cells"][touch], run["cells"][touch - 1])
        self.assertGreater(run["rejected_steps"][touch], 0)
        self.assertLess(self.estimated_error(run), 0.015)

    def test_waves_make_uniform_meshes(self):
        """A fast impact: waves are everywhere; all of the disc becomes finer while it touches."""
        aims = [
            "Mapping=curved",
            "Bodies/disc/Refinements=3",
            "Adaptivity/Indicator=residual",
            "Adaptivity/Goal=contact force",
            "Adaptivity/Target error=0.0125",
            "Adaptivity/Maximum level=5",
            "Output/VTU=false",
        ]
        one, two = (self.run_disc(f"waves-{n}", aims, n) for n in (1, 2))
        uniform = 5 * 4**4
        cells = [n for n, force in zip(one["cells"], one["contact_force"]) if force > 0.0]
        self.assertGreater(sum(n >= uniform for n in cells), 0.5 * len(cells))
        self.assertLess(one["cells"][-1], 0.5 * uniform)
        self.expect_same_meshes(one, two, "momentum_y")

    def test_contact_that_travels(self):
        """A punch slides over a block, by half of its contact in each step: the mesh follows in
        leaps, and the force is that of a fine one."""
        scene = check_history.PARAMETERS / "studies" / "adaptive" / "punch_2d.prm"
        fast = [
            "Time/End time=0.2",
            "Obstacles/punch/Motion=if(t < 0.04, 0, 2*(t - 0.04)); -0.001*min(1, t/0.04)",
        ]
        fine = check_history.Run(scene, "punch-fine", [*fast, "Bodies/block/Refinements=5"])
        aims = [
            "Bodies/block/Refinements=2",
            "Adaptivity/Indicator=residual",
            "Adaptivity/Goal=contact force",
            "Adaptivity/Target error=0.05",
            "Adaptivity/Maximum level=6",
        ]
        one, two = (check_history.Run(scene, f"punch-{n}", [*fast, *aims], n) for n in (1, 2))
        self.assertLess(mesh_runs.distance(one["contact_force"], fine["contact_force"]), 0.05)
        self.assertLess(max(one["cells"]), 0.5 * fine["cells"][0])
        self.assertLess(mesh_runs.n_meshes(one), len(one) / 3)
        self.expect_ledger_closes(one, driven=True)
        self.expect_same_meshes(one, two, "momentum_y")

    def test_contact_that_rolls(self):
        """A roller that drives, for a third of its way: a part of the contact sticks, and the
        friction is less than what slipping would bear; a punch that does not turn slips."""
        scene = check_history.PARAMETERS / "studies" / "adaptive" / "roller_2d.prm"
        aims = [
            "Time/End time=0.3",
            "Bodies/block/Refinements=2",
            "Adaptivity/Indicator=residual",
            "Adaptivity/Goal=contact force",
            "Adaptivity/Target error=0.05",
            "Adaptivity/Maximum level=7",
        ]
        fine = check_history.Run(scene, "roller-fine", ["Time/End time=0.3"])
        run = check_history.Run(scene, "roller", aims)
        punch = check_history.Run(
            scene, "roller-held", ["Time/End time=0.3", "Obstacles/roller/Angular velocity=0"]
        )
        self.assertLess(mesh_runs.distance(run["contact_force"], fine["contact_force"]), 0.05)
        self.assertLess(max(run["cells"]), 0.5 * fine["cells"][0])
        self.assertGreater(run["stick_nodes"][-1], 2)
        self.assertGreater(run["slip_nodes"][-1], 2)
        self.assertEqual(punch["stick_nodes"][-1], 0)
        for turns, part in ((run, (0.7, 0.95)), (punch, (0.999, 1.0001))):
            borne = turns["friction_force"][-1] / (0.3 * turns["contact_force"][-1])
            self.assertGreater(borne, part[0])
            self.assertLess(borne, part[1])
        self.expect_ledger_closes(run, driven=True)

    def test_what_travels_in_space(self):
        """A sphere that slides and one that rolls, for some steps: what they have coarsened and
        refined breaks no law."""
        aims = [
            "Time/End time=0.2",
            "Bodies/block/Refinements=0",
            "Adaptivity/Indicator=residual",
            "Adaptivity/Goal=contact force",
            "Adaptivity/Target error=0.1",
            "Adaptivity/Maximum level=2",
        ]
        for name in ("punch_3d", "roller_3d"):
            with self.subTest(name=name):
                run = check_history.Run(check_history.scene_file(name), name, aims)
                self.assertGreater(mesh_runs.n_meshes(run), 2)
                self.assertGreater(min(run["contact_force"][2:]), 0.0)
                self.expect_ledger_closes(run, driven=True)
                self.expect_pressure(run)
                self.expect_no_penetration(run, 1.4)


if __name__ == "__main__":
    check_history.main()
