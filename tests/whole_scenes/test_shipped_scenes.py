#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Every scene in parameters/ with every scheme keeps what theory promises in each step: the ledger
of energy closes, energy never grows but with the classical scheme, nothing penetrates, contact only
presses, and momentum changes by the forces alone. Expensive scenes are shortened. Scenes of two
bodies and those with friction have tests of their own.
"""

import check_history
import test_adaptivity
import test_damping
import test_friction
import test_two_bodies

DOWN_2D = (0.0, 1.0, 0.0)
DOWN_3D = (0.0, 0.0, 1.0)

#: Scene: overrides that make it short, size of the body, direction of the contact force on a plane,
#: load.
SCENES = {
    "bar_2d": ([], 10.0, DOWN_2D, (0.0, 0.0, 0.0)),
    "bar_3d": (["Time/End time=0.8"], 10.0, DOWN_3D, (0.0, 0.0, 0.0)),
    "box_on_sphere": (["Bodies/box/Refinements=2"], 1.0, None, (0.0, 0.0, -9.81)),
    "disc_2d": (["Bodies/disc/Refinements=4"], 2.0, DOWN_2D, (0.0, 0.0, 0.0)),
    "geometry_a": (["Bodies/ball/Refinements=2"], 2.0, DOWN_3D, (0.0, 0.0, 0.0)),
    "quick_start": (["Bodies/ball/Refinements=2"], 2.0, DOWN_3D, (0.0, 0.0, 0.0)),
}
#: Scenes that are driven from outside, by loads or Dirichlet conditions; free scenes of two bodies
#: have a test of their own.
DRIVEN = {
    "stack_of_boxes": (["Time/End time=0.08"], 1.2),
    "hammer_and_anvil": ([], 1.0),
    "manufactured_bar": ([], 1.0),
    "bouncing_bar": (["Time/End time=2"], 10.0),
}
#: Without inertia; tests/statics looks at them.
LOAD_STEPS = ("static_hertz",)
#: Whose contact follows the motion; tests/moving_contact looks at them.
MOVING = ("ball_in_a_bowl", "chute", "rolling_mill")
#: Whose numbers are judged by tests/studies/test_benchmark.py.
BENCHMARKS = (
    "impacting_bar",
    "cradle",
    "block_in_a_bowl",
    "groove",
    "rocking_block",
    "rod",
    "rings",
)
#: Whose contact travels over a mesh that follows it; tests/adaptive_scenes looks at them.
TRAVELLING = ("punch_2d", "punch_3d", "roller_2d", "roller_3d")


class ShippedScenes(check_history.SceneTest):
    def check_every_scheme(self, name, overrides, size, driven, further):
        """What holds in every scene, with each scheme; `further` checks (run, scheme)."""
        for scheme in check_history.SCHEMES:
            with self.subTest(scheme=scheme):
                run = check_history.Run(
                    check_history.scene_file(name),
                    f"shipped-{name}-{scheme}",
                    overrides + [f"Time/Scheme={scheme}"],
                )
                self.expect_contact(run)
                # What is accepted refers to the largest energy so far, and newmark on a coarse mesh
                # gains up to 60 times the initial one.
                self.expect_ledger_closes(run, driven=driven or scheme == "newmark")
                if scheme in check_history.DISSIPATIVE:
                    self.expect_no_gain_of_energy(run, driven=driven)
                self.expect_no_penetration(run, size)
                further(run, scheme)

    def check(self, name):
        overrides, size, direction, load = SCENES[name]

        def further(run, scheme):
            self.expect_pressure(run, direction)
            self.expect_balance_of_momentum(run, scheme, lambda start, end: load)

        self.check_every_scheme(name, overrides, size, False, further)

    def test_no_scene_is_forgotten(self):
        self.assertEqual(
            sorted(path.stem for path in check_history.PARAMETERS.rglob("*.prm")),
            sorted(
                [
                    *SCENES,
                    *DRIVEN,
                    *test_two_bodies.FREE_SCENES,
                    *test_friction.SCENES,
                    *test_adaptivity.SCENES,
                    *test_damping.SCENES,
                    *LOAD_STEPS,
                    *MOVING,
                    *BENCHMARKS,
                    *TRAVELLING,
                ]
            ),
        )

    def check_driven(self, name):
        overrides, size = DRIVEN[name]
        self.check_every_scheme(
            name, overrides, size, True, lambda run, scheme: self.expect_pressure(run)
        )


for scene in DRIVEN:
    setattr(ShippedScenes, f"test_{scene}", lambda self, name=scene: self.check_driven(name))
for scene in SCENES:
    setattr(ShippedScenes, f"test_{scene}", lambda self, name=scene: self.check(name))


if __name__ == "__main__":
    check_history.main()
