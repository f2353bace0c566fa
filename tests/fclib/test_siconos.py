#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Siconos, a program of others, finds the forces of the program within 1e-8 of the largest one, for
problems of steps that it is given in the local form of FCLIB. It knows nothing of the solution.
"""

import sys

import check_history
import numpy
import problems

try:
    from siconos import numerics
except ImportError as error:
    print(f"skipped: {error}; on Debian: apt-get install python3-siconos")
    sys.exit(problems.SKIPPED)

AGREEMENT = 1e-8


def solve(problem):
    """r by the nonsmooth Gauss-Seidel method."""
    local = numerics.FrictionContactProblem(problem.dim, problem.W, problem.q, problem.mu)
    r, u = numpy.zeros_like(problem.q), numpy.zeros_like(problem.q)
    if problem.dim == 2:
        driver, method = numerics.fc2d_driver, numerics.SICONOS_FRICTION_2D_NSGS
    else:
        driver, method = numerics.fc3d_driver, numerics.SICONOS_FRICTION_3D_NSGS
    options = numerics.SolverOptions(method)
    options.dparam[numerics.SICONOS_DPARAM_TOL] = 1e-13
    options.iparam[numerics.SICONOS_IPARAM_MAX_ITER] = 200000
    # In 2d Siconos 4.4 leaves it at zero, and divides by it.
    options.iparam[numerics.SICONOS_FRICTION_3D_IPARAM_ERROR_EVALUATION_FREQUENCY] = 1
    return driver(local, r, u, options), r


class Siconos(check_history.SceneTest):
    def expect_same_forces(self, scene, name, *overrides):
        _, stored = problems.run(scene, f"siconos-{name}", *overrides)
        self.assertGreater(len(stored), 3, name)
        for step, problem in stored.items():
            status, r = solve(problem)
            where = f"{name}, step {step}"
            difference = abs(r - problem.r).max() / abs(problem.r).max()
            print(f"{where}: {len(problem.mu)} contacts, status {status}, {difference:.1e}")
            self.assertEqual(status, 0, where)
            self.assertLessEqual(difference, AGREEMENT, where)

    def test_block_on_a_floor(self):
        self.expect_same_forces(
            check_history.scene_file("sliding_block"), "block", "Output/FCLIB every=5"
        )

    def test_bodies_on_each_other(self):
        self.expect_same_forces(
            check_history.scene_file("moving_base"),
            "bodies",
            "Output/FCLIB every=10",
            "Time/End time=0.3",
        )

    def test_in_space(self):
        self.expect_same_forces(problems.BOX_ON_TABLE, "space", "Output/FCLIB every=1")


if __name__ == "__main__":
    check_history.main()
