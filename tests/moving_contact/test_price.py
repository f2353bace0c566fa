#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Contact that follows the motion makes a step again until its normals are those of its motion.
What that costs is counted, as times depend on the machine: products with M, which read a third of
what one with A or M + s A reads, and iterations of the sweeps, which read as much as a product.
Repetitions begin where the last one stopped and need no more digits than the normals have wrong,
so that all of them together cost a part of the step only. A run with contact on something curved
that makes each of them to full accuracy takes two to four times what it takes with normals that
stay.

And where Newton's method for friction does not settle, a few problems with given bounds bring it to
where it does.
"""

import check_history

BODY_IN_BOWL = """
set Dimension = {dim}
subsection Time
  set Scheme    = {scheme}
  set Step size = {step}
  set End time  = {end}
end
subsection Bodies
  set Names = body
  subsection body
{shape}
    set Young's modulus  = {stiffness}
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = {velocity}
    set Body force       = {gravity}
  end
end
subsection Obstacles
  set Names = bowl
  subsection bowl
    set Shape         = sphere
    set Radius        = {radius}
    set Bodies inside = true
  end
end
subsection Contact
  set Pairs = body : bowl
end
"""


#: Of rubber, on its edge: which nodes stick and which slip comes back again and again.
RUBBER_ON_ITS_EDGE = check_history.box_on_floor(
    0.5,
    ("Step size = 2e-4", "End time = 6e-3"),
    (
        "Lower corner = -0.05, -0.05, 0",
        "Upper corner = 0.05, 0.05, 0.06",
        "Repetitions = 5, 5, 3",
        "Refinements = 1",
        "Rotation = 5, 3, 0",
        "Translation = 0, 0, 0.01",
        "Young's modulus = 5e6",
        "Poisson's ratio = 0.49",
        "Density = 1100",
        "Initial velocity = 0; 0; -2",
    ),
)

#: Of rubber, on a flat face, in a step so long that the face spreads as a whole: where it is hardly
#: pressed, nodes would stick and slip by turns.
RUBBER_ON_ITS_FACE = check_history.box_on_floor(
    0.3,
    ("Step size = 0.05", "End time = 0.1"),
    (
        "Lower corner = 0, 0, 0.01",
        "Upper corner = 1, 1, 1.01",
        "Repetitions = 4, 4, 4",
        "Refinements = 2",
        "Young's modulus = 1000",
        "Poisson's ratio = 0.49",
        "Density = 1",
        "Initial velocity = 0.5; 0; -1",
    ),
)

#: Of rubber, at rest under its weight: where it has spread, friction is at its bound.
MAT_AT_REST = check_history.box_on_floor(
    0.2,
    ("Start = equilibrium", "Step size = 5e-4", "End time = 2.5e-3"),
    (
        "Lower corner = -0.1, -0.04, 0",
        "Upper corner = 0.1, 0.04, 0.02",
        "Repetitions = 10, 4, 1",
        "Refinements = 1",
        "Young's modulus = 5e6",
        "Poisson's ratio = 0.49",
        "Density = 1100",
        "Body force = 0; 0; -9.81",
    ),
)


def block_in_bowl(step):
    """A block slides through the lowest point of a circle, with its corners on it."""
    return BODY_IN_BOWL.format(
        dim=2,
        scheme="contact-implicit",
        step=step,
        end=0.5,
        shape="""    set Shape            = box
    set Lower corner     = -0.2, -0.97979
    set Upper corner     = 0.2, -0.77979
    set Repetitions      = 2, 1
    set Refinements      = 4""",
        stiffness=1000,
        velocity="-0.5*y; 0.5*x",
        gravity="0; -9.81",
        radius=1,
    )


def ball_in_bowl(step):
    """A ball is thrown into a bowl."""
    return BODY_IN_BOWL.format(
        dim=3,
        scheme="contact-stabilized-projected",
        step=step,
        end=0.8,
        shape="""    set Shape            = ball
    set Centre           = 0.6, 0, -0.75
    set Radius           = 0.5
    set Refinements      = 2""",
        stiffness=2000,
        velocity="-1; 0.5; -1",
        gravity="0; 0; -9.81",
        radius=1.5,
    )


def price(run):
    """Of all steps: products, and iterations if they are sweeps and no products themselves."""
    total = {name: sum(values) for name, values in run.history.items()}
    products = total["products_combined"] + total["products_stiffness"]
    products += total["products_mass"] / 3
    sweeps = total["predictor_iterations"] / 3
    if "symmetric-gauss-seidel" in run.log:
        sweeps += total["linear_iterations"]
    return products, products + sweeps


class Price(check_history.unittest.TestCase):
    """See the beginning of the file."""

    def expect_ratios(self, scene, name, products, everything):
        """What a run takes with normals that follow, over what it takes with those that stay."""
        follow, stay = (
            check_history.Run(
                scene,
                f"{name}_{motion}",
                # What is counted are iterations.
                [f"Contact/Motion={motion}", "Solver/Condensation=never"],
            )
            for motion in ("follow", "linearised")
        )
        self.assertGreater(max(follow.history["contact_force"]), 0)
        self.assertEqual(sum(follow.history["rejected_steps"]), 0)
        # The program accepts 1e-12 of the size and round-off; elsewhere 1e-10 is promised.
        self.assertLess(max(follow.history["max_penetration"]), 1e-11)
        ratios = [a / b for a, b in zip(price(follow), price(stay))]
        self.assertLess(ratios[0], products)
        self.assertLess(ratios[1], everything)

    def test_box_on_a_sphere(self):
        """A predictor and an increment with an growing patch of contact: 1.28 and 1.24."""
        scene = check_history.scene_file("box_on_sphere")
        self.expect_ratios(scene, "box_on_sphere", 1.4, 1.35)

    def test_block_in_a_bowl(self):
        """Courant number 12: 1.25 and 1.09. At 117 the cycle of multigrid, whose iterations are
        products, begins anew in each repetition: 1.75."""
        self.expect_ratios(block_in_bowl(0.004), "block", 1.4, 1.2)
        self.expect_ratios(block_in_bowl(0.04), "block_long_steps", 1.9, 1.9)

    def test_ball_in_a_bowl(self):
        """Courant numbers 10 and 79: 1.38 and 1.24, 1.18 and 1.18. The scheme makes some steps
        twice by itself, because the predictor was stopped in vain at some nodes."""
        self.expect_ratios(ball_in_bowl(0.01), "ball", 1.5, 1.4)
        self.expect_ratios(ball_in_bowl(0.08), "ball_long_steps", 1.4, 1.4)

    def test_friction_that_does_not_settle(self):
        """436 linear systems and 7300 iterations, plus or minus 2 % with perturbed velocities; with
        all problems of given bounds, each to the last digit, 742 and 10 830."""
        run = check_history.Run(RUBBER_ON_ITS_EDGE, "rubber_on_its_edge")
        self.assertGreater(sum(run.history["fallbacks"]), 0)
        self.assertLess(sum(run.history["active_set_iterations"]), 600)
        self.assertLess(sum(run.history["linear_iterations"]), 9000)

    def test_single_nodes_that_slip_to_and_fro(self):
        """Their forces turn round at once: 25 sets. Where they stopped first, it took 45 and two
        detours by problems with given bounds."""
        run = check_history.Run(RUBBER_ON_ITS_FACE, "rubber_on_its_face")
        self.assertEqual(sum(run.history["fallbacks"]), 0)
        self.assertLess(sum(run.history["active_set_iterations"]), 32)

    def test_a_body_at_rest(self):
        """Nothing happens, and two sets find it. Where round-off chose who sticks and who slips,
        each step took some 300 sets and a fallback."""
        run = check_history.Run(MAT_AT_REST, "mat_at_rest")
        self.assertEqual(sum(run.history["fallbacks"][2:]), 0)
        self.assertLessEqual(max(run.history["active_set_iterations"][2:]), 4)


if __name__ == "__main__":
    check_history.main()
