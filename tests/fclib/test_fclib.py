#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The files for FCLIB hold the problems that the program has solved: in each of them the stored
solution satisfies the stored balance of momentum, complementarity and the law of Coulomb, and the
local form says the same as the global one. In these units the forces are those of the tables.
Problems that FCLIB has no words for are refused.
"""

import itertools
import subprocess

import check_history
import numpy
import problems

#: Of what the largest entries are.
ACCURACY = 1e-10


def largest(*vectors):
    return max(numpy.abs(vector).max() for vector in vectors)


class StoredProblems(check_history.SceneTest):
    def expect_solved(self, problem, where):
        """The conditions of FCLIB, as equations."""
        contact = problem.H.times(problem.r)
        self.expect_zero(
            problem.M.times(problem.v) - contact - problem.f,
            largest(problem.f, contact),
            f"{where}: momentum",
        )
        velocity, impulse = largest(problem.v), largest(problem.r)
        self.expect_zero(
            problem.H.transposed_times(problem.v) + problem.w - problem.u,
            velocity,
            f"{where}: relative motion",
        )
        u, r = problem.by_contact(problem.u), problem.by_contact(problem.r)
        self.assertGreaterEqual(u[:, 0].min(), -ACCURACY * velocity, f"{where}: penetration")
        self.assertGreaterEqual(r[:, 0].min(), 0.0, f"{where}: tension")
        self.expect_zero(u[:, 0] * r[:, 0], velocity * impulse, f"{where}: complementarity")

        slip, bound = numpy.linalg.norm(u[:, 1:], axis=1), problem.mu * r[:, 0]
        excess = numpy.linalg.norm(r[:, 1:], axis=1) - bound
        self.assertLessEqual(excess.max(), ACCURACY * impulse, f"{where}: bound of friction")
        against = slip[:, None] * r[:, 1:] + bound[:, None] * u[:, 1:]
        self.expect_zero(against, velocity * impulse, f"{where}: direction of friction")

    def expect_same_local_form(self, problem, where):
        self.assertTrue(problem.has_local_form, where)
        self.expect_zero(problem.W - problem.W.T, largest(problem.W), f"{where}: symmetry of W")
        self.expect_zero(
            problem.W @ problem.r + problem.q - problem.u,
            largest(problem.v),
            f"{where}: local form",
        )

    def expect_zero(self, difference, scale, what):
        self.assertLessEqual(numpy.abs(difference).max(), ACCURACY * scale, what)

    def expect_all_solved(self, scene, name, *overrides):
        """@return the run, its problems, and how many contacts they have that slip and stick"""
        run, stored = problems.run(scene, name, *overrides)
        slipping = sticking = 0
        for step, problem in stored.items():
            self.expect_solved(problem, f"{name}, step {step}")
            self.expect_same_local_form(problem, f"{name}, step {step}")
            u, r = problem.by_contact(problem.u), problem.by_contact(problem.r)
            pressed = (r[:, 0] > 0.0) & (problem.mu > 0.0)
            slips = numpy.linalg.norm(u[:, 1:], axis=1) > 1e-6 * largest(problem.v)
            slipping += (pressed & slips).sum()
            sticking += (pressed & ~slips).sum()
        return run, stored, slipping, sticking

    def expect_forces_of_history(self, run, stored):
        """The sum of the normal forces of the nodes is a column of the history."""
        for step, problem in stored.items():
            force = problem.by_contact(problem.r)[:, 0].sum()
            self.expect_close(
                force * problem.attributes["force_per_reaction"],
                run["contact_force"][step],
                1e-12,
                f"contact force of step {step}",
            )
            self.assertEqual(problem.attributes["step"], step)
            self.expect_close(
                problem.attributes["start_time"] + problem.attributes["step_size"],
                run["time"][step],
                1e-12,
                "time",
            )

    def test_block_that_stops(self):
        run, stored, slipping, sticking = self.expect_all_solved(
            check_history.scene_file("sliding_block"), "block", "Output/FCLIB every=5"
        )
        self.assertEqual(list(stored), list(range(5, 51, 5)))
        self.expect_forces_of_history(run, stored)
        self.assertGreater(slipping, 20)
        self.assertGreater(sticking, 20)

    def test_other_schemes(self):
        for scheme in ("newmark", "backward-euler", "contact-implicit", "laursen-chawla"):
            run, stored, slipping, _ = self.expect_all_solved(
                check_history.scene_file("sliding_block"),
                scheme,
                "Output/FCLIB every=2",
                f"Time/Scheme={scheme}",
                "Time/End time=0.06",
            )
            self.expect_forces_of_history(run, stored)
            self.assertGreater(slipping, 0, scheme)

    def test_bodies_on_each_other(self):
        """Mortar coupling; a contact surface that is a partner of another one; a moved base."""
        _, stored, slipping, sticking = self.expect_all_solved(
            check_history.scene_file("moving_base"),
            "bodies",
            "Output/FCLIB every=10",
            "Time/End time=0.3",
        )
        self.assertEqual(len(stored), 6)
        self.assertGreater(slipping, 10)
        self.assertGreater(sticking, 10)

    def test_in_space(self):
        for name, pair in ("table", "table[5] : box[4]"), ("box", "box[4] : table[5]"):
            _, stored, slipping, sticking = self.expect_all_solved(
                problems.box_on_table(pair), name, "Output/FCLIB every=1"
            )
            self.assertGreater(len(stored), 5, name)
            self.assertGreater(slipping, 20, name)
            self.assertGreater(sticking, 3, name)

    def test_hanging_nodes(self):
        """Local refinement of the table: hanging nodes are no unknowns."""
        _, stored, slipping, _ = self.expect_all_solved(
            problems.box_on_table("box[4] : table[5]"),
            "hanging",
            "Output/FCLIB every=3",
            "Bodies/table/Local refinements=1",
            "Bodies/table/Refine where=-x",
        )
        self.assertEqual(len(stored), 5)
        self.assertGreater(slipping, 10)

    def test_corner(self):
        """Two contacts of one node; without a wall in reach it has one."""
        _, stored, slipping, _ = self.expect_all_solved(
            problems.BLOCK_IN_CORNER, "corner", "Output/FCLIB every=1"
        )
        numbers = {len(problem.mu) for problem in stored.values()}
        self.assertGreater(len(numbers), 1)
        self.assertGreater(slipping, 10)

    def test_obstacles_that_move(self):
        """Normals of the motion of the step, and slip relative to rollers."""
        _, stored, slipping, sticking = self.expect_all_solved(
            check_history.scene_file("rolling_mill"),
            "rollers",
            "Output/FCLIB every=20",
            "Time/Scheme=contact-stabilized",
            "Time/End time=2",
        )
        self.assertGreater(len(stored), 3)
        self.assertGreater(slipping + sticking, 10)

    def test_without_friction(self):
        """All contact nodes have bounds of their own, and no tangential force."""
        run, stored, _, _ = self.expect_all_solved(
            check_history.scene_file("disc_2d"), "frictionless", "Output/FCLIB every=10"
        )
        self.assertGreater(len(stored), 1)
        self.assertTrue(all(largest(problem.mu) == 0.0 for problem in stored.values()))
        steps = set(range(10, len(run), 10))
        self.assertEqual(
            set(stored), {step for step in steps if run["contact_force"][step] > 0.0}
        )


class Refused(check_history.SceneTest):
    """Each with one sentence that names the key."""

    BLOCK = "Contact/block[2] : floor/"

    def message(self, *overrides, processes=1):
        scene = check_history.scene_file("sliding_block")
        folder = f"Output directory={check_history.settings['folder']}/refused"
        done = subprocess.run(
            check_history.command(
                scene, (folder, "Output/FCLIB every=1", *overrides), processes, ("--validate",)
            ),
            env=check_history.environment(),
            capture_output=True,
            text=True,
            timeout=check_history.TIMEOUT,
            check=False,
        )
        self.assertEqual(done.returncode, 2, f"{overrides}: {done.stdout}{done.stderr}")
        return done.stderr

    def test_what_fclib_cannot_say(self):
        for overrides, why in (
            ([f"{self.BLOCK}Friction bound=1e3"], "no bound as that of the pair"),
            (["Time/Scheme=contact-stabilized-projected"], "those of its predictor"),
            (
                ["Time/Scheme=static", "Bodies/block/Initial velocity=0; 0"],
                "solves none",
            ),
            (["Time/Step size control=embedded"], "take steps of one size"),
        ):
            message = self.message(*overrides)
            self.assertIn("FCLIB every", message)
            self.assertIn(why, message)

    def test_several_processes(self):
        self.assertIn("needs a run on one process", self.message(processes=2))


if __name__ == "__main__":
    check_history.main()
