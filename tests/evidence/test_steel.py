#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Steel in steps that are long for its waves: a block that slides is braked as a rigid one."""

import check_history

#: A block of steel, 20 mm by 10 mm, thrown along a floor on which it lies: in steps of 3 ms waves
#: pass 7000 cells, and 24 000 in steps of 10 ms.
STEEL = """
set Dimension = 2
subsection Time
  set Step size = {step}
  set End time  = 0.03
end
subsection Bodies
  set Names = block
  subsection block
    set Shape            = box
    set Upper corner     = 0.02, 0.01
    set Repetitions      = 8, 4
    set Young's modulus  = 2.1e11
    set Poisson's ratio  = 0.3
    set Density          = 7850
    set Body force       = 0; -9.81
    set Initial velocity = 0.1; 0
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = block : floor
  subsection block : floor
    set Friction coefficient = 0.3
  end
end
subsection Solver
  set Preconditioner = {preconditioner}
end
"""


class Steel(check_history.SceneTest):
    """See the beginning of the file."""

    def test_steel_in_long_steps(self):
        """v0 - mu g t. Newton's method loses its way in the first step, and round-off of where it
        went must not be left in what is accepted."""
        for preconditioner in ("multigrid", "symmetric-gauss-seidel"):
            for step in (0.003, 0.01):
                with self.subTest(preconditioner=preconditioner, step=step):
                    scene = STEEL.format(step=step, preconditioner=preconditioner)
                    run = check_history.Run(scene, "friction-steel")
                    mass = 7850 * 0.02 * 0.01
                    for time, momentum in zip(run["time"], run["momentum_x"]):
                        exact = 0.1 - 0.3 * 9.81 * time
                        self.expect_close(momentum / mass, exact, 1e-5, "speed")
                    self.assertLess(
                        max(map(abs, run["energy_residual"])), 1e-6 * run["kinetic_energy"][0]
                    )


if __name__ == "__main__":
    check_history.main()
