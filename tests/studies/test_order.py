#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Orders in time. Contact that comes and goes smoothly: all schemes but backward Euler are of
second order in the displacement, and the contact force converges faster than linearly at the
instant to which it belongs, and only there. The manufactured solution of
parameters/verification/manufactured_bar.prm has active contact half of the time, with approach and
release at zero speed; the mesh's own error is hundreds of times smaller. And the integration with
error control has no error in time: what remains depends on the mesh, not on the tolerance, energy
is conserved, and a scheme for the same problem converges to it.
"""

import functools
import math
import sys

import check_history

sys.path.insert(0, str(check_history.SOURCE / "tools"))
from studies import distances, instants, observe  # noqa: E402

REDISTRIBUTED = {
    "khenous-laborde-renard 1/4": [
        "Time/Scheme=khenous-laborde-renard",
        "Time/Newmark beta=0.25",
        "Time/Newmark gamma=0.5",
    ],
    "khenous-laborde-renard 1/2": [
        "Time/Scheme=khenous-laborde-renard",
        "Time/Newmark beta=0.5",
        "Time/Newmark gamma=0.5",
    ],
    "contact-implicit redistributed": ["Time/Scheme=contact-implicit", "Time/Mass=redistributed"],
}
#: Conditions of velocities: errors scatter.
SCATTERING = ("laursen-chawla", "moreau-jean")
FIRST_ORDER = ("backward-euler",)
SMOOTH = [
    scheme
    for scheme in (*check_history.SCHEMES, *check_history.FURTHER_SCHEMES)
    if scheme not in SCATTERING + FIRST_ORDER
] + list(REDISTRIBUTED)
#: Where the order of the force is clear, and where in the step it does not belong.
FORCES = {
    "contact-stabilized": instants.END,
    "contact-stabilized-projected": instants.END,
    "generalized-alpha": instants.END,
    "contact-implicit redistributed": instants.END,
    "khenous-laborde-renard 1/4": instants.MIDDLE,
    "khenous-laborde-renard 1/2": instants.MIDDLE,
}
STEPS = (0.025, 0.00625)
BAR = check_history.scene_file("manufactured_bar")


def setUpModule():
    instants.use(check_history.settings["executable"])


def exact_force(time):
    """The pressure of the manufactured solution times the width."""
    return 0.025 * max(-math.sin(2 * math.pi * (time + 0.05)), 0.0) ** 3


def order(errors, steps=STEPS):
    """Between the first and the last step size."""
    return math.log(errors[0] / errors[-1]) / math.log(steps[0] / steps[-1])


@functools.cache
def smooth_contact(variant):
    """The runs of the manufactured solution with all step sizes."""
    overrides = REDISTRIBUTED.get(variant, [f"Time/Scheme={variant}"])
    return [
        check_history.Run(
            BAR, f"{variant.replace('/', '-')} {step}", overrides + [f"Time/Step size={step}"]
        )
        for step in STEPS
    ]


def result_of(run):
    """The run as studies see it."""
    return observe.Result(run.folder / "output")


def force_error(run, before_end):
    """Relative, with forces that belong to t_n - before_end tau."""
    return distances.relative(
        (force, exact_force(time - before_end * step))
        for force, time, step in zip(
            run["contact_force"][1:], run["time"][1:], run["step_size"][1:]
        )
    )


class Order(check_history.SceneTest):
    def errors(self, variant):
        runs = smooth_contact(variant)
        for run in runs:
            self.expect_contact(run)
        return [run["relative_displacement_error"][-1] for run in runs], [
            run["relative_velocity_error"][-1] for run in runs
        ]

    def test_order_two(self):
        for variant in SMOOTH:
            with self.subTest(variant=variant):
                displacement, velocity = self.errors(variant)
                self.assertGreater(order(displacement), 1.9, f"{displacement}")
                self.assertLess(order(displacement), 2.15, f"{displacement}")
                self.assertGreater(
                    order(velocity), 1.2 if variant == "newmark" else 1.5, f"{velocity}"
                )

    def test_backward_euler_has_order_one(self):
        for errors in self.errors("backward-euler"):
            self.expect_close(order(errors), 1.0, 0.1, f"{errors}")

    def test_conditions_of_velocities_scatter_around_order_two(self):
        for scheme in SCATTERING:
            with self.subTest(scheme=scheme):
                displacement, _ = self.errors(scheme)
                self.assertGreater(order(displacement), 1.7, f"{displacement}")

    def test_the_force_belongs_to_an_instant(self):
        """At its instant the force converges with an order that only the kinks at closing and
        opening limit; elsewhere it is a step fraction late."""
        for variant, wrong in FORCES.items():
            with self.subTest(variant=variant):
                runs = smooth_contact(variant)
                right = instants.before_end(result_of(runs[0]).keys_of_time)
                errors = [[force_error(run, share) for run in runs] for share in (right, wrong)]
                self.assertGreater(order(errors[0]), 1.45, f"{errors}")
                self.assertLess(order(errors[1]), 1.25, f"{errors}")
                self.assertLess(2 * errors[0][-1], errors[1][-1], f"{errors}")
                result = result_of(runs[-1])
                result.exact_force = exact_force
                self.assertEqual(distances.force_error(result), errors[0][-1])


class Reference(check_history.SceneTest):
    def smooth(self, cells, tolerance):
        """One closing and opening of the manufactured solution."""
        return check_history.Run(
            BAR,
            f"reference {cells} {tolerance}",
            [
                "Time/Scheme=reference",
                f"Time/Reference tolerance={tolerance}",
                f"Bodies/bar/Repetitions={cells}, 1",
                "Time/Step size=0.0125",
                "Time/End time=1",
            ],
        )

    def test_only_the_error_of_the_mesh_remains_and_schemes_converge_to_it(self):
        precise, loose, fine = self.smooth(25, 1e-9), self.smooth(25, 1e-6), self.smooth(50, 1e-6)
        mesh = precise["relative_displacement_error"][-1]
        self.expect_contact(precise)
        self.expect_close(
            loose["relative_displacement_error"][-1], mesh, 1e-3, "error with a loose tolerance"
        )
        self.assertLess(4 * fine["relative_displacement_error"][-1], mesh)
        steps, results = (0.025, 0.0125), []
        for step in steps:
            run = check_history.Run(
                BAR,
                f"against the reference {step}",
                REDISTRIBUTED["khenous-laborde-renard 1/4"]
                + ["Bodies/bar/Repetitions=25, 1", f"Time/Step size={step}", "Time/End time=1"],
            )
            results.append(result_of(run))
            results[-1].reference = result_of(precise)
        for distance, least in (
            (distances.displacement_distance, 1.9),
            (distances.force_distance, 1.5),
            (distances.velocity_distance, 1.4),
        ):
            errors = [distance(result) for result in results]
            self.assertGreater(order(errors, steps), least, f"{distance.__name__}: {errors}")
            self.assertLess(order(errors, steps), 2.2, f"{distance.__name__}: {errors}")

    def test_energy_of_an_impact_is_conserved_to_the_tolerance(self):
        drifts = []
        for tolerance in (1e-6, 1e-8):
            run = check_history.Run(
                check_history.PARAMETERS / "bar_2d.prm",
                f"impact {tolerance}",
                [
                    "Time/Scheme=reference",
                    f"Time/Reference tolerance={tolerance}",
                    "Bodies/bar/Repetitions=1, 25",
                    "Time/Step size=0.012",
                    "Time/End time=1.3",
                ],
            )
            self.expect_contact(run)
            energy = run["total_energy_modified"]
            drifts.append(max(abs(value / energy[0] - 1) for value in energy))
        self.assertLess(drifts[1], 1e-5)
        self.assertLess(5 * drifts[1], drifts[0], f"{drifts}")


if __name__ == "__main__":
    check_history.main()
