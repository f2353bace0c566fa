#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Scenes with friction repeat what is known exactly: rigid blocks slide, stop and stick at the
right time and place, the zone of sticking under a tangential load is that of Cattaneo and Mindlin,
and a ball that slips through a whole impact loses mu times the normal impulse. In every step
friction takes energy, the ledger closes, and no probe exceeds Coulomb's bound.
"""

import math

import check_history

#: Coefficient of friction of each probe of a scene.
SCENES = {
    "sliding_block": {"middle": 0.3},
    "incline": {"middle": 0.367609937},
    "sinusoidal_push": {"middle": 0.8},
    "cattaneo_mindlin": {"middle": 0.3, "inside": 0.3, "edge": 0.3},
    "moving_base": {"above": 0.2, "below": 0.6},
    "rolling_ball": {"pole": 0.2},
    "oblique_impact": {"pole": 0.3},
    "oblique_impact_two_balls": {"pole": 0.1},
}
SLOPE = math.radians(20.0)


def change(column, first, last):
    return column[last] - column[first]


def row_of(run, time):
    return min(range(len(run)), key=lambda row: abs(run["time"][row] - time))


def impulse(run, axis):
    """Of the contact forces with friction on the slaves."""
    return sum(force * step for force, step in zip(run[f"contact_force_{axis}"], run["step_size"]))


def elliptic(x, half_width):
    return math.sqrt(max(0.0, 1.0 - (x / half_width) ** 2))


class Friction(check_history.SceneTest):
    def run_scene(self, name, label="", overrides=(), coefficients=None, processes=1):
        """coefficients: if the overrides change those of the scene."""
        run = check_history.Run(
            check_history.scene_file(name),
            f"friction-{name}{label}",
            overrides,
            processes,
        )
        self.expect_contact(run)
        motion = max(map(sum, zip(run["kinetic_energy"], run["elastic_energy"])))
        scale = check_history.ACCURACY * (
            motion + sum(map(abs, run["work_friction"]))
        )  # loads may bring more than ever moves
        for row in range(len(run)):
            self.assertLessEqual(
                abs(run["energy_residual"][row]), scale, f"energy residual in row {row}"
            )
            self.assertLessEqual(run["work_friction"][row], scale, f"work of friction in row {row}")
        self.assertTrue(any(run["stick_nodes"]) or any(run["slip_nodes"]), "there is no friction")
        for probe, coefficient in (coefficients or SCENES[name]).items():
            self.expect_bound_of_coulomb(run.probes[probe], coefficient)
        return run

    def expect_bound_of_coulomb(self, probe, coefficient):
        """The tangential force reaches the bound where the node slips, and never exceeds it."""
        largest = max(probe["normal_force"])
        for row, normal in enumerate(probe["normal_force"]):
            tangential = math.hypot(*(probe[f"tangential_force_{axis}"][row] for axis in "xyz"))
            self.assertLessEqual(
                tangential, coefficient * normal + 1e-10 * largest, f"friction in row {row}"
            )
            if probe["status"][row] == 1:
                self.assertGreaterEqual(
                    tangential, coefficient * normal - 1e-8 * largest, f"slip in row {row}"
                )

    def test_sliding_block_stops_where_it_should(self):
        """The missing distance is the rest of a parabola: mu g tau^2/18 if it stops a third of a
        step after an instant."""
        for scheme, stop in (
            ("contact-stabilized", "true"),
            ("contact-stabilized", "false"),
            ("contact-stabilized-projected", "true"),
        ):
            for step in (0.04, 0.02, 0.01):
                with self.subTest(scheme=scheme, stop=stop, step=step):
                    run = self.run_scene(
                        "sliding_block",
                        f"-{scheme}-{stop}-{step}",
                        [
                            f"Time/Scheme={scheme}",
                            f"Time/Stop sticking nodes={stop}",
                            f"Time/Step size={step}",
                        ],
                    )
                    way = run.probes["middle"]["slip_x"]
                    self.expect_close(1 / 6 - way[-1], 3 * step**2 / 18, 0.01, "missing distance")
                    last = max(
                        row for row in range(1, len(run)) if abs(change(way, row - 1, row)) > 1e-6
                    )
                    self.assertLess(abs(run["time"][last] - 1 / 3), step, "time of the stop")
                    swing = max(abs(momentum) for momentum in run["momentum_x"][last + 2 :]) / 20.0
                    self.assertLess(swing, 0.5 * step * 3, "velocity after the stop")
                    self.expect_close(
                        -sum(run["work_friction"]), 10.0, 2e-3, "energy taken by friction"
                    )

    def test_incline(self):
        run = self.run_scene("incline", "-stick")
        self.assertLess(max(map(abs, run["momentum_x"])), 1e-10)
        self.assertLess(max(map(abs, run.probes["middle"]["slip_x"])), 1e-13)
        for row in range(1, len(run)):
            self.expect_close(
                -run["contact_force_x"][row],
                20 * 10 * math.sin(SLOPE),
                1e-8,
                f"friction in row {row}",
            )
        coefficient = 0.99 * math.tan(SLOPE)
        run = self.run_scene(
            "incline",
            "-slip",
            [f"Contact/block[2] : plane/Friction coefficient={coefficient}"],
            {"middle": coefficient},
        )
        acceleration = 10 * (math.sin(SLOPE) - coefficient * math.cos(SLOPE))
        for row in range(1, len(run)):
            self.expect_close(
                run["momentum_x"][row],
                20 * acceleration * run["time"][row],
                1e-6,
                f"momentum in row {row}",
            )
        self.expect_close(
            run.probes["middle"]["slip_x"][-1], 0.5 * acceleration * 0.5**2, 1e-5, "way"
        )

    def test_sinusoidal_push(self):
        run = self.run_scene("sinusoidal_push")
        step = run["step_size"][1]
        sliding = [run["time"][row] for row in range(1, len(run)) if run["stick_nodes"][row] == 0]
        first, second = [t for t in sliding if t < 1.0], [t for t in sliding if t > 1.0]
        for value, exact in (
            (first[0], step),
            (first[-1], 0.338608),
            (second[0], 2.946347),
            (second[-1], 3.532835),
        ):
            self.assertLessEqual(
                abs(value - exact), step, f"all nodes slide at {value}, theory says {exact}"
            )
        way = run.probes["middle"]["slip_x"]
        rest, end = way[row_of(run, 1.5)], way[row_of(run, 4.5)]
        self.expect_close(rest, 0.0043486, 0.01, "first way")
        self.expect_close(end - rest, -0.0130457, 0.01, "second way")

    def cattaneo_mindlin(self, refinement):
        """Relative L2 errors of the tangential stress by load, with a probe at each node."""
        size, half = 0.125 / 2**refinement, 0.14
        count = round(half / size)
        probes = "".join(
            f"  subsection p{k + count}\n    set Point = {k * size}, 0\n  end\n"
            for k in range(-count, count + 1)
        )
        names = ", ".join(f"p{k}" for k in range(2 * count + 1))
        scene = check_history.scene_file("cattaneo_mindlin").read_text(encoding="utf-8")
        scene = (
            scene[: scene.index("subsection Probes")]
            + f"subsection Probes\n  set Names = {names}\n{probes}end\n"
        )
        run = check_history.Run(
            scene,
            f"friction-cattaneo-{refinement}",
            [f"Bodies/{body}/Local refinements={refinement}" for body in ("base", "dome")],
        )
        errors = []
        for row in (4, 6, 8, 10):
            normal, tangential = (abs(run[f"contact_force_{axis}"][row]) for axis in "yx")
            half_width = math.sqrt(4 * normal * 4 / math.pi * 2 * (1 - 0.3**2) / 1000)
            stick = half_width * math.sqrt(1 - tangential / (0.3 * normal))
            nodes = max(run["active_nodes"])
            self.assertLessEqual(
                abs(run["stick_nodes"][row] / nodes - stick / half_width),
                1.01 / nodes,
                f"zone of sticking in row {row}",
            )
            error = norm = 0.0
            for k in range(-count, count + 1):
                probe = run.probes[f"p{k + count}"]
                pressed = probe["normal_force"][row] > 0
                stress = (
                    abs(probe["tangential_force_x"][row])
                    * probe["pressure"][row]
                    / probe["normal_force"][row]
                    if pressed
                    else 0.0
                )
                exact = (
                    0.3
                    * 2
                    * normal
                    / (math.pi * half_width)
                    * (
                        elliptic(k * size, half_width)
                        - stick / half_width * elliptic(k * size, stick)
                    )
                )
                error, norm = error + (stress - exact) ** 2, norm + exact**2
            errors.append(math.sqrt(error / norm))
        return errors

    def test_cattaneo_mindlin(self):
        self.run_scene("cattaneo_mindlin")
        coarse, fine = self.cattaneo_mindlin(3), self.cattaneo_mindlin(4)
        self.assertLess(max(coarse), 0.12)
        self.assertLess(max(fine), 0.07)

    def test_block_on_block_on_moving_base(self):
        run = self.run_scene("moving_base")
        self.assertLess(max(run.probes["below"]["slip_path"]), 1e-12, "the lower block slips")
        step = run["step_size"][1]
        base = [0.1 * (1 - math.cos(2 * math.pi * t)) for t in run["time"]]
        way = [a + b for a, b in zip(base, run.probes["above"]["slip_x"])]
        speed = [change(way, row, row + 1) / step for row in range(len(run) - 1)]
        for start, end, exact in ((0.05, 0.25, 2.0), (0.4, 0.8, -2.0)):
            rows = row_of(run, start), row_of(run, end)
            self.expect_close(
                change(speed, *rows) / change(run["time"], *rows),
                exact,
                0.015,
                f"acceleration from {start} to {end}",
            )
        largest, total = max(map(abs, run["momentum_x"])), 0.0
        for row in range(1, len(run)):
            total += step * run["contact_force_x"][row]
            base_speed = 0.2 * math.pi * math.sin(2 * math.pi * run["time"][row])
            self.assertLess(
                abs(total - 2 * run["momentum_x"][row] + 56 * base_speed),
                0.01 * largest,
                f"impulse in row {row}",
            )

    def test_rolling_ball(self):
        run = self.run_scene("rolling_ball")
        self.assertEqual(max(run["slip_nodes"]), 0)
        start, end = row_of(run, 0.05), len(run) - 1
        mass = run["contact_force_z"][-1] / (10 * math.cos(SLOPE))
        inertia = 0.4 * (mass / (4 / 3 * math.pi)) ** (2 / 3)  # of the ball of the same volume
        weight = mass * 10 * math.sin(SLOPE) * change(run["time"], start, end)
        self.expect_close(
            change(run["momentum_x"], start, end) / weight, 1 / (1 + inertia), 0.01, "acceleration"
        )
        slipping = self.run_scene(
            "rolling_ball",
            "-slip",
            ["Contact/ball : plane/Friction coefficient=0.08"],
            {"pole": 0.08},
        )
        self.expect_close(
            change(slipping["momentum_x"], start, end) / weight,
            1 - 0.08 / math.tan(SLOPE),
            1e-6,
            "acceleration with slip",
        )

    def oblique_impact(self, angle):
        """On a coarse mesh: the run, and psi after the impact from the rigid part of the ball's
        motion; kappa = 1.4/1.7."""
        speed, sideways = 0.15, angle * 0.3 * 0.15 * 1.7 / 1.4
        run = self.run_scene(
            "oblique_impact",
            f"-{angle}",
            [
                "Bodies/ball/Refinements=2",
                "Bodies/ball/Local refinements=2",
                "Bodies/ball/Refine where=0.35 - sqrt(x^2 + y^2 + z^2)",
                "Bodies/base/Repetitions=6, 6, 3",
                "Bodies/base/Local refinements=1",
                "Bodies/base/Refine where=0.4 - sqrt(x^2 + y^2 + z^2)",
                "Time/Step size=0.04",
                "Time/End time=1",
                f"Bodies/ball/Initial velocity={sideways}; 0; -{speed}",
            ],
        )
        self.assertEqual(run["active_nodes"][-1], 0, "the ball has not left")
        mass = run["momentum_z"][0] / -speed
        spin = (
            run["angular_momentum_y"][-1] - run["momentum_x"][-1]
        ) / 0.4  # mass times angular velocity, radius 1
        return run, (run["momentum_x"][-1] - spin) / mass * 1.4 / 1.7 / (0.3 * speed)

    def test_oblique_impact(self):
        """Beyond 4.77 the ball slips all the time; at 2 theory has -0.84, and such a large contact
        gives some more."""
        run, _ = self.oblique_impact(6)
        self.assertEqual(max(run["stick_nodes"]), 0)
        self.expect_close(
            impulse(run, "x"), -0.3 * impulse(run, "z"), 1e-4, "impulse of friction"
        )  # nodes slip nearly along x
        run, after = self.oblique_impact(2)
        self.assertGreater(max(run["stick_nodes"]), 0)
        self.expect_close(after, -0.84, 0.2, "psi after the impact")

    def test_two_balls_exchange_equal_impulses(self):
        speed, sideways = 0.05, 2 * 0.1 * 0.05 * 1.7 / 1.4
        run = self.run_scene(
            "oblique_impact_two_balls",
            "-coarse",
            [
                f"Bodies/{body}/{key}"
                for body, sign in (("upper", 1), ("lower", -1))
                for key in (
                    "Refinements=2",
                    "Local refinements=1",
                    "Refine where=0.35 - sqrt(x^2 + y^2 + z^2)",
                    f"Initial velocity={sign * sideways}; 0; {-sign * speed}",
                )
            ]
            + ["Time/Step size=0.04", "Time/End time=0.9"],
        )
        scale = abs(impulse(run, "x"))
        self.assertGreater(scale, 0.0)
        for row in range(len(run)):
            for component in run.vector("momentum", row):
                self.assertLess(abs(component), 1e-9 * scale, f"momentum in row {row}")

    def test_two_balls_that_slip_all_the_time(self):
        """They lose mu times the normal impulse along the plane of contact, however large the
        contact is: normals tilted against it would add a sixth."""
        speed, sideways = 0.15, 6 * 0.1 * 0.15 * 1.7 / 1.4
        run = self.run_scene(
            "oblique_impact_two_balls",
            "-slip",
            [
                f"Bodies/{body}/{key}"
                for body, sign in (("upper", 1), ("lower", -1))
                for key in (
                    "Refinements=2",
                    "Local refinements=2",
                    "Refine where=0.35 - sqrt(x^2 + y^2 + z^2)",
                    f"Initial velocity={sign * sideways}; 0; {-sign * speed}",
                )
            ]
            + ["Time/Step size=0.02", "Time/End time=0.8"],
        )
        self.assertEqual(max(run["stick_nodes"]), 0)
        self.expect_close(impulse(run, "x"), -0.1 * impulse(run, "z"), 1e-3, "impulse of friction")

    def test_two_processes(self):
        for name in ("moving_base", "sliding_block"):
            one, two = (self.run_scene(name, f"-processes-{n}", processes=n) for n in (1, 2))
            rows = (
                row_of(one, 0.3) if name == "sliding_block" else len(one)
            )  # what is decided by round-off comes after the stop
            for column in (
                "momentum_x",
                "contact_force_x",
                "friction_force",
                "total_energy",
                "work_friction",
            ):
                scale = max(map(abs, one[column]))
                for row in range(rows):
                    self.assertLessEqual(
                        abs(one[column][row] - two[column][row]),
                        1e-7 * scale,
                        f"{name}: {column} in row {row}",
                    )


if __name__ == "__main__":
    check_history.main()
