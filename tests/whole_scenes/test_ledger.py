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
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = disc : floor
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
            [f"Time/Scheme={scheme}", f"Solver/Tolerance={tolerance}"],
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


if __name__ == "__main__":
    check_history.main()
