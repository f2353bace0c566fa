#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Siconos, a program of others, finds the forces of the program within 1e-8 of the largest one, for
problems of steps that it is given in the forms of FCLIB. It knows nothing of the solution.
"""

import sys

import check_history
import numpy
import problems

try:
    import scipy.sparse
    from siconos import numerics
except ImportError as error:
    print(f"skipped: {error}; on Debian: apt-get install python3-siconos")
    sys.exit(problems.SKIPPED)

AGREEMENT = 1e-8


def sparse(matrix):
    entries = (matrix.values, (matrix.rows, matrix.columns))
    result = scipy.sparse.csc_matrix(entries, matrix.shape)
    # Siconos would warn that it converts them itself.
    result.indices = result.indices.astype(numpy.int64)
    result.indptr = result.indptr.astype(numpy.int64)
    return result


def solve_global_form(problem):
    """r by the nonsmooth Gauss-Seidel method, for which Siconos makes the local form itself."""
    form = numerics.GlobalFrictionContactProblem()
    form.dimension, form.numberOfContacts = problem.dim, len(problem.mu)
    form.M, form.H = sparse(problem.M), sparse(problem.H)
    form.q, form.b, form.mu = problem.f, problem.w, problem.mu
    r, u, v = (numpy.zeros_like(vector) for vector in (problem.w, problem.w, problem.f))
    options = numerics.SolverOptions(numerics.SICONOS_GLOBAL_FRICTION_3D_NSGS_WR)
    options.dparam[numerics.SICONOS_DPARAM_TOL] = 1e-13
    options.iparam[numerics.SICONOS_IPARAM_MAX_ITER] = 200000
    return numerics.gfc3d_driver(form, r, u, v, options), r


def solve_local_form(problem):
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
            # Siconos has the global form in 3d only.
            for solve in (solve_local_form, solve_global_form)[: problem.dim - 1]:
                status, r = solve(problem)
                where = f"{name}, step {step}, {solve.__name__}"
                difference = abs(r - problem.r).max() / abs(problem.r).max()
                print(f"{where}: {len(problem.mu)} contacts, {difference:.1e}")
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

    def test_block_in_corner(self):
        self.expect_same_forces(problems.BLOCK_IN_CORNER, "corner", "Output/FCLIB every=4")

    def test_in_space(self):
        for name, pair in ("table", "table[5] : box[4]"), ("box", "box[4] : table[5]"):
            self.expect_same_forces(problems.box_on_table(pair), name, "Output/FCLIB every=1")


if __name__ == "__main__":
    check_history.main()
