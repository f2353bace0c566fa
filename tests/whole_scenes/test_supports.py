# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Forces of supports: with loads and contact they explain every change of momentum to the accuracy
of the solver, in the sense in which each scheme applies forces; with conditions that move,
friction, steps of any size, hanging nodes and oblique obstacles."""

import check_history
from check_history import ACCURACY, Run

#: A block of mass 2 hangs on a ceiling that moves up, down and sideways, falls with it onto the
#: floor, and slides there. Its left side is guided along y where it meets the ceiling: both
#: conditions prescribe x at the corner.
HANGING_BLOCK = """
set Dimension = 2
subsection Time
  set Step size = 2e-3
  set End time  = 0.2
end
subsection Bodies
  set Names = block
  subsection block
    set Shape           = box
    set Lower corner    = 0, 0.01
    set Upper corner    = 2, 1.01
    set Repetitions     = 4, 2
    set Refinements     = 1
    set Young's modulus = 500
    set Poisson's ratio = 0.3
    set Density         = 1
    set Body force      = 0; -10
    set Dirichlet       = 3: 0.02*sin(20*t); 0.03*(cos(30*t)-1) | 0: 0.02*sin(20*t); -
  end
end
""" + check_history.on_floor("block[2]")
WEIGHT = (0.0, -20.0, 0.0)
CEILING, GUIDE = "support_block_3", "support_block_0"

#: Momentum changes by the forces of the step.
BY_FORCES = (
    "contact-stabilized",
    "contact-stabilized-projected",
    "contact-implicit",
    "laursen-chawla",
    "laursen-love",
    "hager-hueeber-wohlmuth",
    "moreau-jean",
    "backward-euler",
    "newmark",
)
FRICTION = "Contact/block[2] : floor/Friction coefficient=0.3"


def vectors(columns, quantity):
    """A vector in all rows."""
    return list(zip(*(columns[f"{quantity}_{axis}"] for axis in "xyz")))


def combine(*terms):
    """The sum of factors times vectors."""
    return [sum(factor * vector[c] for factor, vector in terms) for c in range(3)]


class Motion:
    """Momentum and forces of a run with supports, row by row."""

    def __init__(self, run, load):
        self.run = run
        self.momentum = vectors(run.history, "momentum")
        self.contact = vectors(run.history, "contact_force")
        supports = run.table("supports")
        names = {name[:-2] for name in supports if name.startswith("support_")}
        self.supports = {name: vectors(supports, name) for name in names}
        self.support = [
            combine(*((1.0, self.supports[name][row]) for name in names)) for row in range(len(run))
        ]
        self.load = load

    def scale(self):
        return max(abs(c) for vector in self.momentum for c in vector)

    def change(self, row):
        """Of the momentum in a step, over its length."""
        size = self.run["step_size"][row]
        return combine((1.0 / size, self.momentum[row]), (-1.0 / size, self.momentum[row - 1]))

    def force(self, row):
        return combine((1.0, self.load), (1.0, self.contact[row]), (1.0, self.support[row]))


class Supports(check_history.SceneTest):
    def expect_balance(self, motion, row, left, right):
        step = motion.run["step_size"][row]
        for axis, a, b in zip("xyz", left, right):
            self.assertLessEqual(
                abs(a - b) * step, ACCURACY * motion.scale(), f"{axis} in row {row}: {a}, {b}"
            )

    def force_of_step(self, motion, scheme, row):
        """The contact force of the classical scheme acts with the mean of both ends."""
        force = motion.force(row)
        if scheme == "newmark":
            before, now = motion.contact[row - 1], motion.contact[row]
            force = combine((1.0, force), (0.5, before), (-0.5, now))
        return force

    def expect_supports_at_work(self, motion):
        """Without contact, or with an idle guide, the balance would show less."""
        self.assertGreater(max(motion.run["active_nodes"]), 3)
        for name in (CEILING, GUIDE):
            self.assertGreater(max(abs(force[0]) for force in motion.supports[name]), 0.1, name)
        self.assertGreater(max(abs(force[1]) for force in motion.supports[CEILING]), 20.0)
        self.assertEqual(max(abs(force[1]) for force in motion.supports[GUIDE]), 0.0)

    def test_supports_explain_the_momentum(self):
        for scheme in BY_FORCES:
            overrides = [f"Time/Scheme={scheme}"]
            if scheme not in ("moreau-jean",):
                overrides.append(FRICTION)
            with self.subTest(scheme=scheme):
                motion = Motion(Run(HANGING_BLOCK, f"hanging-{scheme}", overrides), WEIGHT)
                self.expect_supports_at_work(motion)
                for row in range(1, len(motion.run)):
                    self.expect_balance(
                        motion, row, motion.change(row), self.force_of_step(motion, scheme, row)
                    )

    def test_supports_of_variable_steps_and_hanging_nodes(self):
        for name, overrides, processes in (
            ("doubling", ["Time/Step size control=doubling"], 1),
            (
                "hanging-nodes",
                ["Bodies/block/Local refinements=1", "Bodies/block/Refine where=x + y - 2"],
                2,
            ),
        ):
            with self.subTest(name=name):
                motion = Motion(Run(HANGING_BLOCK, name, [*overrides, FRICTION], processes), WEIGHT)
                self.expect_supports_at_work(motion)
                for row in range(1, len(motion.run)):
                    self.expect_balance(motion, row, motion.change(row), motion.force(row))

    def test_supports_of_schemes_with_accelerations(self):
        """Their accelerations follow from forces by a recursion, which two steps eliminate: with
        the forces Q of the balances, (1 - a_m) change_2 + a_m change_1 = (1 - g) Q_1 + g Q_2. Of
        the first step the acceleration at the start is not in the table."""
        rho = 0.8
        alpha_m, alpha_f = (2 * rho - 1) / (rho + 1), rho / (rho + 1)
        for scheme, a_m, gamma in (
            ("khenous-laborde-renard", 0.0, 0.5),
            ("hht-alpha", 0.0, 0.6),
            ("generalized-alpha", alpha_m, 0.5 - alpha_m + alpha_f),
            ("nonsmooth-generalized-alpha", alpha_m, 0.5 - alpha_m + alpha_f),
        ):
            with self.subTest(scheme=scheme):
                run = Run(HANGING_BLOCK, f"hanging-{scheme}", [f"Time/Scheme={scheme}"])
                motion = Motion(run, WEIGHT)
                self.expect_supports_at_work(motion)
                # Jumps of the velocity are no part of the recursion.
                smooth = scheme != "nonsmooth-generalized-alpha"
                checked = [
                    row
                    for row in range(2, len(run))
                    if smooth or run["contact_force"][row - 1] == run["contact_force"][row] == 0.0
                ]
                self.assertGreater(len(checked), 10)
                for row in checked:
                    left = combine((1.0 - a_m, motion.change(row)), (a_m, motion.change(row - 1)))
                    right = combine(
                        (1.0 - gamma, motion.force(row - 1)), (gamma, motion.force(row))
                    )
                    self.expect_balance(motion, row, left, right)

    def test_supports_of_the_reference(self):
        """Forces at the end of a step: by the trapezoidal rule they explain the momentum up to its
        error, which is of second order."""
        errors = []
        for halvings in (0, 1):
            size = 1e-3 / 2**halvings
            motion = Motion(
                Run(
                    HANGING_BLOCK,
                    f"hanging-reference-{halvings}",
                    [
                        "Time/Scheme=reference",
                        f"Time/Step size={size}",
                        "Time/End time=0.04",
                        "Bodies/block/Dirichlet=3: 0; 0 | 0: 0; -",
                        "Bodies/block/Refinements=0",
                    ],
                ),
                WEIGHT,
            )
            start, end = 2 * 2**halvings, len(motion.run) - 1
            impulse = combine(
                *((0.5 * size, motion.force(row)) for row in range(start, end)),
                *((0.5 * size, motion.force(row)) for row in range(start + 1, end + 1)),
            )
            change = combine((1.0, motion.momentum[end]), (-1.0, motion.momentum[start]))
            self.assertGreater(abs(change[1]), 1e-2)
            errors.append(abs(impulse[1] - change[1]))
        self.assertLess(errors[1], errors[0] / 2.5)
        self.assertLess(errors[1], 2e-3)

    def test_supports_at_rest(self):
        """From the first row on the ceiling carries the weight, on one and two processes."""
        fixed = ["Time/Start=equilibrium", "Bodies/block/Dirichlet=3: 0; 0 | 0: 0; -"]
        for processes in (1, 2):
            motion = Motion(Run(HANGING_BLOCK, "rest", fixed, processes), WEIGHT)
            for row in range(len(motion.run)):
                self.expect_close(motion.support[row][1], 20.0, 1e-10, f"weight, row {row}")

    def test_supports_at_a_slope(self):
        """A base that is guided along y rests on a slope, whose force has a part along x: the
        guides hold against it, at rest and when the block falls onto the slope."""
        slope = HANGING_BLOCK.replace("0, 0.01", "0, 0").replace("2, 1.01", "2, 1")
        slope = slope.replace("Normal = 0, 1", "Normal = 0.5, 1")
        for scheme in ("contact-stabilized", "newmark"):
            overrides = [f"Time/Scheme={scheme}", "Bodies/block/Dirichlet=2: 0; -"]
            rest = Run(slope, f"slope-{scheme}", [*overrides, "Time/Start=equilibrium"])
            motion = Motion(rest, WEIGHT)
            for row in range(len(rest)):
                self.expect_close(motion.support[row][0], -10.0, 1e-8, f"guides, row {row}")
                self.expect_close(motion.contact[row][0], 10.0, 1e-8, f"slope, row {row}")
            fall = [*overrides, "Bodies/block/Initial velocity=0; -2"]
            motion = Motion(Run(slope, f"fall-{scheme}", fall), WEIGHT)
            self.assertGreater(max(force[0] for force in motion.contact), 15.0)
            for row in range(1, len(motion.run)):
                self.expect_balance(
                    motion, row, motion.change(row), self.force_of_step(motion, scheme, row)
                )


if __name__ == "__main__":
    check_history.main()
