#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the shipped scenes do not show: hanging nodes in contact, moving Dirichlet conditions,
changing tractions, curved obstacles and cells, several bodies, lumped mass. The identities of each
step do not care, and the result does not depend on the preconditioner.
"""

import math

import check_history

HANGING_NODES = """
set Dimension = 3
subsection Time
  set Step size = 1e-2
  set End time  = 0.4
end
subsection Bodies
  set Names = box
  subsection box
    set Shape             = box
    set Lower corner      = 0, 0, 0.02
    set Upper corner      = 1, 1, 1.02
    set Repetitions       = 2, 2, 2
    set Local refinements = 2
    set Refine where      = 0.7 - x - y - 0.5*z
    set Young's modulus   = 500
    set Poisson's ratio   = 0.3
    set Density           = 1
    set Initial velocity  = 0.3; 0.2*z; -2 + 0.2*x
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Shape  = plane
    set Normal = 0, 0, 1
  end
end
subsection Contact
  set Pairs = box : floor
end
subsection Probes
  set Names = corner
  subsection corner
    set Point = 0, 0, 0
  end
end
"""

#: Of the block in parameters/sliding_block.prm.
IMPACT = [
    "Time/Start=given",
    "Time/Step size=8e-4",
    "Time/End time=0.032",
    "Bodies/block/Young's modulus=2e5",
    "Bodies/block/Poisson's ratio=0.3",
    "Bodies/block/Body force=0; 0",
    "Contact/block[2] : floor/Friction coefficient=0",
]

MOVING_CONDITION = """
set Dimension = 2
subsection Time
  set Step size = 1e-2
  set End time  = 0.8
end
subsection Bodies
  set Names = block
  subsection block
    set Shape           = box
    set Lower corner    = 0, 0.05
    set Upper corner    = 2, 1.05
    set Repetitions     = 8, 4
    set Young's modulus = 500
    set Poisson's ratio = 0.3
    set Density         = 1
    set Dirichlet       = 3: 0.03*x*sin(7*t); -0.1*(1 - cos(9*t)) | 0: 0; -
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Shape  = plane
    set Normal = 0, 1
  end
end
subsection Contact
  set Pairs = block[2] : floor
end
subsection Probes
  set Names = middle
  subsection middle
    set Point = 1, 0
  end
end
"""

CHANGING_TRACTION = """
set Dimension = 3
subsection Time
  set Step size = 1e-2
  set End time  = 0.6
end
subsection Bodies
  set Names = plate
  subsection plate
    set Shape            = box
    set Lower corner     = -0.5, -1, 0.01
    set Upper corner     = 0.5, 1, 0.51
    set Repetitions      = 4, 8, 2
    set Young's modulus  = 500
    set Poisson's ratio  = 0.4
    set Density          = 2
    set Initial velocity = 0; 0; 0.1*y
    set Traction         = 5: 3*t; -; -20*sin(15*t)
    set Body force       = 0; 0; -4*t
  end
end
subsection Obstacles
  set Names = bumps
  subsection bumps
    set Shape           = function
    set Signed distance = z + 0.1*x^2 + 0.05*(1 - cos(4*y))
  end
end
subsection Contact
  set Pairs = plate[4] : bumps
end
subsection Probes
  set Names = middle
  subsection middle
    set Point = 0, 0, 0
  end
end
"""

SEVERAL_BODIES = """
set Dimension = 3
set Mapping   = curved
subsection Time
  set Step size = 5e-3
  set End time  = 0.3
  set Mass      = lumped
end
subsection Bodies
  set Names = ball, roller
  subsection ball
    set Shape            = ball
    set Centre           = 0, 0, 0.1
    set Radius           = 0.5
    set Refinements      = 1
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 3; 0; 1
  end
  subsection roller
    set Shape            = cylinder
    set Axis             = y
    set Centre           = 0, 0, 2
    set Radius           = 0.4
    set Length           = 1
    set Young's modulus  = 200
    set Poisson's ratio  = 0.2
    set Density          = 3
    set Refinements      = 1
    set Initial velocity = 0; 0.1; 2
  end
end
subsection Obstacles
  set Names = shell, pipe
  subsection shell
    set Shape         = sphere
    set Centre        = 0, 0, 0
    set Radius        = 0.8
    set Bodies inside = true
  end
  subsection pipe
    set Shape         = cylinder
    set Point         = 0, 0, 2
    set Axis          = 1, 0, 0
    set Radius        = 0.7
    set Bodies inside = true
  end
end
subsection Contact
  set Pairs = ball : shell, roller : pipe
end
subsection Probes
  set Names = east, top
  subsection east
    set Point = 0.5, 0, 0
  end
  subsection top
    set Point = 0, 0, 2.4
  end
end
"""

DISC = """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = 0.2
end
subsection Bodies
  set Names = disc
  subsection disc
    set Shape             = ball
    set Centre            = 0, 1
    set Radius            = 1
    set Refinements       = 3
    set Local refinements = 1
    set Refine where      = 0.5 - y
    set Young's modulus   = 500
    set Poisson's ratio   = 0.3
    set Density           = 1
    set Initial velocity  = 0.1; -2
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Shape  = plane
    set Point  = 0, -0.01
    set Normal = 0.1, 1
  end
end
subsection Contact
  set Pairs = disc : floor
end
"""


def no_load(_start, _end):
    return (0.0, 0.0, 0.0)


def mean_load_on_plate(start, end):
    """Traction times the area 2 of the upper side, and body force times the mass 2, averaged over
    the ends of a step."""
    return (
        2 * 1.5 * (start + end),
        0.0,
        -20.0 * (math.sin(15 * start) + math.sin(15 * end)) - 4.0 * (start + end),
    )


class SmallScenes(check_history.SceneTest):
    def check(self, name, text, size, direction=None, load=None, driven=False):
        """load: without it, momentum is not checked; driven: conditions or loads bring energy."""
        for scheme in check_history.SCHEMES:
            with self.subTest(scheme=scheme):
                run = check_history.Run(text, f"small-{name}-{scheme}", [f"Time/Scheme={scheme}"])
                self.expect_contact(run)
                self.expect_ledger_closes(run, driven)
                self.expect_no_penetration(run, size)
                self.expect_pressure(run, direction)
                if load is not None:
                    self.expect_balance_of_momentum(run, scheme, load)
                if scheme in check_history.DISSIPATIVE:
                    self.expect_no_gain_of_energy(run, driven)

    def test_hanging_nodes_in_contact(self):
        self.check("hanging-nodes", HANGING_NODES, 1.0, direction=(0.0, 0.0, 1.0), load=no_load)

    def test_moving_dirichlet_condition(self):
        self.check(
            "moving-condition", MOVING_CONDITION, 2.0, direction=(0.0, 1.0, 0.0), driven=True
        )

    def test_changing_traction_and_function_as_obstacle(self):
        self.check(
            "changing-traction", CHANGING_TRACTION, 2.0, load=mean_load_on_plate, driven=True
        )

    def test_several_bodies_with_curved_cells_and_lumped_mass(self):
        self.check("several-bodies", SEVERAL_BODIES, 1.0, load=no_load)

    def test_lumped_predictor(self):
        """With the lumped mass only in the predictor the identities hold, but nothing is promised
        about the sign."""
        run = check_history.Run(
            HANGING_NODES,
            "small-lumped-predictor",
            ["Time/Predictor mass=lumped", "Time/Scheme=contact-stabilized"],
        )
        self.expect_contact(run)
        self.expect_ledger_closes(run)
        self.expect_no_penetration(run, 1.0)
        self.expect_pressure(run, (0.0, 0.0, 1.0))
        self.expect_balance_of_momentum(run, "contact-stabilized", no_load)

    def test_lumped_predictor_is_the_projection_for_the_lumped_mass(self):
        """Without coupling by the mass the projection works node by node."""
        runs = [
            check_history.Run(
                DISC,
                f"small-projection-{mass}",
                ["Time/Mass=lumped", f"Time/Predictor mass={mass}"],
            )
            for mass in ("consistent", "lumped")
        ]
        self.expect_contact(runs[0])
        self.expect_no_gain_of_energy(runs[0])
        self.expect_same_history(*runs, 1e-8)

    def test_slow_motion_is_fast_motion_slowed_down(self):
        """Without gap and loads everything is proportional to the velocity, however small the way
        of a step is."""
        energies = []
        for speed in (1.0, 1e-6, 1e-10):
            run = check_history.Run(
                check_history.PARAMETERS / "sliding_block.prm",
                f"slow-{speed}",
                IMPACT + [f"Bodies/block/Initial velocity={0.3 * speed}; {-speed}"],
            )
            energies.append([energy / run["total_energy"][0] for energy in run["total_energy"]])
        self.assertLess(energies[0][-1], 0.999)
        for slow in energies[1:]:
            for now, then in zip(slow, energies[0]):
                self.assertAlmostEqual(now, then, delta=1e-8)

    def test_solver_changes_nothing(self):
        for name, text in (("disc", DISC), ("dirichlet", MOVING_CONDITION)):
            runs = [
                check_history.Run(
                    text,
                    f"small-{name}-{preconditioner}-{method}-{condensation}",
                    [
                        f"Solver/Preconditioner={preconditioner}",
                        f"Solver/Inequality={method}",
                        f"Solver/Condensation={condensation}",
                    ],
                )
                for preconditioner, method, condensation in (
                    ("jacobi", "active-set", "never"),
                    ("symmetric-gauss-seidel", "active-set", "never"),
                    ("incomplete-cholesky", "active-set", "automatic"),
                    ("ml", "active-set", "automatic"),
                    ("multigrid", "active-set", "automatic"),
                    ("multigrid", "truncated-newton-multigrid", "automatic"),
                    ("incomplete-cholesky", "truncated-newton-multigrid", "automatic"),
                    ("symmetric-gauss-seidel", "truncated-newton-multigrid", "automatic"),
                    ("automatic", "active-set", "always"),
                    ("automatic", "truncated-newton-multigrid", "always"),
                )
            ]
            self.expect_contact(runs[0])
            for other in runs[1:]:
                self.expect_same_history(runs[0], other, 1e-8)


if __name__ == "__main__":
    check_history.main()
