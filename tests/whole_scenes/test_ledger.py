# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The energy ledger can fail. Each scheme's identity follows from the balance of its steps; works
are computed from the terms that they name, never from what is missing. So the residual is as small
as the error of the solver lets it be: where steps are solved roughly, it shows, with every scheme;
where they are solved well, it is round-off."""

import check_history

#: Impact of a disc under a load that changes, which all parts of an identity see.
SCENE = """
set Dimension = 2
subsection Time
  set Step size = 1e-2
  set End time  = 0.5
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape            = ball
    set Centre           = 0, 1.05
    set Radius           = 1
    set Refinements      = 2
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 0.1; -2
    set Body force       = 3*sin(9*t); -5*t*x
  end
end
""" + check_history.on_floor("disc")

FAR = """
set Dimension = 2
subsection Time
  set Step size = 0.05
  set End time  = 10
end
subsection Bodies
  set Names = box
  subsection box
    set Shape                = box
    set Lower corner         = 0, 0
    set Upper corner         = 1, 1
    set Refinements          = 3
    set Young's modulus      = 1
    set Poisson's ratio      = 0.3
    set Density              = 1
    set Initial displacement = 100; -100
    set Initial velocity     = 0; -1e-5
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Point  = 0, -100.00001
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = box : floor
end
"""

#: A coarse ball before its floor, with steps in which the force of contact comes and goes.
COARSE = """
set Dimension = 3
subsection Time
  set Scheme    = nonsmooth-generalized-alpha
  set Step size = 0.0015482336258696924
  set End time  = 0.0387
end
subsection Bodies
  set Names = ball
  subsection ball
    set Shape            = ball
    set Centre           = 0, 0, 0.051216633787638785
    set Radius           = 0.05121600907206289
    set Refinements      = 1
    set Young's modulus  = 12444.726144400522
    set Poisson's ratio  = 0.44979933693129126
    set Density          = 0.23469364104547805
    set Initial velocity = 0; 0; -1.1124715482974164e-4
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 0, 1
  end
end
subsection Contact
  set Pairs = ball : floor
end
"""

#: Where steps are a fixed point of several solutions, these must be good enough to find it.
ROUGH = {"nonsmooth-generalized-alpha": 1e-8}


class Ledger(check_history.SceneTest):
    def residual(self, scheme, tolerance):
        """The largest one, relative to the largest energy of the run; the energy of the motion with
        the mass of the scheme."""
        run = check_history.Run(
            SCENE,
            f"{scheme}-{tolerance}",
            [
                f"Time/Scheme={scheme}",
                f"Solver/Tolerance={tolerance}",
                "Solver/Condensation=never",  # a direct factor is as accurate as it can be
            ],
        )
        self.expect_contact(run)
        scale = max(
            kinetic + elastic
            for kinetic, elastic in zip(run["kinetic_energy_modified"], run["elastic_energy"])
        )
        return max(abs(residual) for residual in run["energy_residual"]) / scale

    def test_a_rough_solution_shows_with_every_scheme(self):
        for scheme in check_history.ALL_SCHEMES:
            with self.subTest(scheme=scheme):
                rough = ROUGH.get(scheme, 1e-2)
                self.assertGreater(self.residual(scheme, rough), rough / 100)
                self.assertLess(self.residual(scheme, 2e-11), check_history.ACCURACY)

    def test_a_body_far_from_where_it_began_keeps_its_digits(self):
        """A hundred lengths away, at 1e-5 of the wave speed, round-off of the displacement is 1e-14
        lengths, and a strain of 1e-5 has nine digits. Products of the displacement itself would
        leave none: their round-off is 1e-16 of the energy of a strain of 100."""
        run = check_history.Run(FAR, "far")
        self.expect_contact(run)
        scale = max(run["total_energy"])
        self.assertLess(max(abs(residual) for residual in run["energy_residual"]) / scale, 1e-7)
        self.assertLess(max(run["total_energy"]), 1.0000001 * run["total_energy"][0])

    def test_an_iteration_that_goes_astray_leaves_nothing_behind(self):
        """The fixed point of the jumps is found by extrapolation, which tried jumps of 1e25 times
        the speed where two iterates were nearly alike. Neither is such a jump a solution because
        the next one is as large, nor may its round-off stay in the first guess of later steps. How
        alike the iterates are is a matter of round-off: six of the first eight runs went astray."""
        for tolerance in ("1e-12", "1e-11", "2e-11", "5e-11"):
            for preconditioner in ("jacobi", "incomplete-cholesky", "symmetric-gauss-seidel"):
                with self.subTest(tolerance=tolerance, preconditioner=preconditioner):
                    run = check_history.Run(
                        COARSE,
                        f"coarse-{tolerance}-{preconditioner}",
                        [
                            f"Solver/Tolerance={tolerance}",
                            f"Solver/Preconditioner={preconditioner}",
                        ],
                    )
                    self.expect_contact(run)
                    # It closes with the tolerance; ACCURACY belongs to 2e-11.
                    accuracy = check_history.ACCURACY * max(1, float(tolerance) / 2e-11)
                    self.expect_ledger_closes(run, accuracy=accuracy)
                    self.assertLess(max(run["total_energy"]), 1.001 * run["total_energy"][0])


if __name__ == "__main__":
    check_history.main()
