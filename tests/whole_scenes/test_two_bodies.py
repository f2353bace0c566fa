#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Two bodies that hit each other: momentum is conserved because the forces on both are equal and
opposite, the scenes of bars repeat the exact solutions of one-dimensional wave theory, two equal
bars lose exactly what one bar loses at a wall, and it does not matter beyond the discretisation
error which body is the slave.
"""

import check_history

#: Scene without outside forces: overrides that make it short, size of the bodies, what to do with
#: the energy.
FREE_SCENES = {
    "two_bars": ([], 10.0),
    "striking_bar": ([], 10.0),
    "short_and_long_bar": ([], 10.0),
    "two_balls_head_on": (
        ["Bodies/upper/Refinements=2", "Bodies/lower/Refinements=2", "Time/End time=0.4"],
        2.0,
    ),
    "two_balls_off_centre": (
        ["Bodies/upper/Refinements=2", "Bodies/lower/Refinements=2", "Time/End time=0.4"],
        2.0,
    ),
    "geometry_b_flat": (
        ["Bodies/upper/Refinements=3", "Bodies/lower/Refinements=3", "Time/End time=0.012"],
        1.4,
    ),
    "geometry_b_curved": (
        ["Bodies/upper/Refinements=3", "Bodies/lower/Refinements=3", "Time/End time=0.02"],
        1.4,
    ),
    "geometry_b_tilted": (
        ["Bodies/upper/Refinements=3", "Bodies/lower/Refinements=3", "Time/End time=0.02"],
        1.4,
    ),
}


def half_of_two_bars(scheme):
    """The right one of two_bars.prm at a rigid wall in place of the other."""
    return f"""
set Dimension = 2
subsection Time
  set Scheme    = {scheme}
  set Step size = 3e-3
  set End time  = 1
end
subsection Bodies
  set Names = right
{check_history.bar("right", "Initial velocity=-10; 0")}end
subsection Obstacles
  set Names = wall
  subsection wall
    set Normal = 1, 0
  end
end
subsection Contact
  set Pairs = right[0] : wall
end
"""


class TwoBodies(check_history.SceneTest):
    def run_scene(self, name, scheme, overrides=(), label=""):
        return check_history.Run(
            check_history.PARAMETERS / f"{name}.prm",
            f"{name}-{scheme}{label}",
            [f"Time/Scheme={scheme}", *overrides],
        )

    def expect_constant_momentum(self, run):
        """In every step, relative to the momentum that the bodies exchange."""
        scale = run.impulse()
        for row in range(1, len(run)):
            for old, new in zip(run.vector("momentum", row - 1), run.vector("momentum", row)):
                self.assertLessEqual(abs(new - old), 1e-11 * scale, f"momentum in row {row}")

    def check(self, name):
        overrides, size = FREE_SCENES[name]
        for scheme in check_history.SCHEMES:
            with self.subTest(scheme=scheme):
                run = self.run_scene(name, scheme, overrides)
                self.expect_contact(run)
                self.expect_ledger_closes(run)
                if scheme in check_history.DISSIPATIVE:
                    self.expect_no_gain_of_energy(run)
                self.expect_no_penetration(run, size)
                self.expect_pressure(run)
                self.expect_constant_momentum(run)

    def test_equal_bars_exchange_their_velocities(self):
        run = self.run_scene("two_bars", "contact-stabilized")
        pressure = [
            force / 0.1
            for time, force in zip(run["time"], run["contact_force"])
            if 0.1 < time < 0.6
        ]
        for value in pressure:
            self.expect_close(value, 300.0, 0.005, "contact pressure")
        last = max(time for time, nodes in zip(run["time"], run["active_nodes"]) if nodes > 0)
        self.expect_close(last, 2 / 3, 0.01, "end of contact")
        self.expect_close(run.impulse(), 2 * 10 * 1.0, 0.01, "impulse")  # mass 1, from 10 to -10
        self.expect_close(
            run["kinetic_energy"][-1],
            run["kinetic_energy"][0],
            0.02,
            "kinetic energy: hardly any vibration",
        )

    def test_equal_bars_lose_what_one_bar_loses_at_a_wall(self):
        for scheme in check_history.SCHEMES:
            with self.subTest(scheme=scheme):
                two = self.run_scene("two_bars", scheme, label="-two")
                one = check_history.Run(half_of_two_bars(scheme), f"one-bar-{scheme}")
                scale = one["total_energy"][0]
                for row, (a, b) in enumerate(zip(two["total_energy"], one["total_energy"])):
                    self.assertLessEqual(
                        abs(a - 2 * b), 2e-8 * scale, f"energy in row {row}: {a} and twice {b}"
                    )
                force = max(one["contact_force"])
                for row, (a, b) in enumerate(zip(two["contact_force"], one["contact_force"])):
                    self.assertLessEqual(
                        abs(a - b), 1e-8 * force, f"contact force in row {row}: {a} and {b}"
                    )
                if scheme != "newmark":
                    self.assertLess(one.energy_change(), -1e-3, "the loss that is compared")

    def test_further_schemes_keep_momentum_and_account_for_energy(self):
        for scheme in check_history.FURTHER_SCHEMES:
            with self.subTest(scheme=scheme):
                run = self.run_scene("striking_bar", scheme, label="-further")
                self.expect_contact(run)
                self.expect_ledger_closes(run)
                self.expect_constant_momentum(run)
                if scheme.startswith("laursen"):
                    self.assertLess(abs(run.energy_change()), 1e-9)
                if scheme == "contact-stabilized-projected":
                    self.expect_no_gain_of_energy(run)
                    self.expect_no_penetration(run, 10.0)

    def test_impulses_per_node_conserve_energy_and_momentum(self):
        """On one and two processes, many coupled contact nodes; the equations of the nodes are
        solved in every step."""
        runs = [
            check_history.Run(
                check_history.PARAMETERS / "geometry_b_curved.prm",
                f"node-impulses-{processes}",
                [
                    *FREE_SCENES["geometry_b_curved"][0],
                    "Time/Scheme=laursen-love",
                ],
                processes,
            )
            for processes in (1, 2)
        ]
        for run in runs:
            self.expect_contact(run)
            self.expect_ledger_closes(run)
            self.assertLess(
                max(abs(energy / run["total_energy"][0] - 1) for energy in run["total_energy"]),
                1e-9,
            )
            self.expect_no_penetration(run, 1.4)
            self.expect_pressure(run)
            self.expect_constant_momentum(run)
            self.assertIn("impulses          of single nodes", run.log)
            self.assertNotIn("the common factor", run.log)
        self.expect_same_history(*runs, 1e-8)

    def test_bar_at_rest_takes_over_all_motion(self):
        run = self.run_scene("striking_bar", "contact-stabilized")
        middle = [force for time, force in zip(run["time"], run["contact_force"]) if 4 < time < 16]
        self.expect_close(sum(middle) / len(middle), 0.4, 0.02, "contact force")
        self.expect_close(run.impulse(), 40 * 0.2, 0.03, "impulse")
        last = max(time for time, nodes in zip(run["time"], run["active_nodes"]) if nodes > 0)
        self.expect_close(last, 20.0, 0.05, "end of contact")

    def test_short_bar_stops_dead(self):
        run = self.run_scene("short_and_long_bar", "contact-stabilized")
        middle = [
            force for time, force in zip(run["time"], run["contact_force"]) if 0.05 < time < 0.28
        ]
        self.expect_close(sum(middle) / len(middle), 15.0, 0.01, "contact force")
        self.expect_close(run.impulse(), 0.5 * 10, 0.01, "impulse")
        late = sum(
            force * step
            for time, force, step in zip(run["time"], run["contact_force"], run["step_size"])
            if time > 0.4
        )
        self.assertLess(
            late, 0.01 * run.impulse(), "force while the pulse runs through the long bar"
        )

    def test_head_on_impact_keeps_angular_momentum_and_oblique_one_does_not(self):
        """Theory: forces on facing points are a moment unless the gap is parallel to the normal."""
        drift = {}
        for name in ("two_balls_head_on", "two_balls_off_centre"):
            run = self.run_scene(name, "contact-stabilized", FREE_SCENES[name][0], "-drift")
            drift[name] = max(run["angular_momentum_drift"]) / run.impulse()
        self.assertLess(drift["two_balls_head_on"], 1e-3)
        self.assertGreater(drift["two_balls_off_centre"], 1e-6)
        self.assertLess(drift["two_balls_off_centre"], 0.05)

    def test_geometry_b_flat_is_a_trap(self):
        run = self.run_scene("geometry_b_flat", "contact-implicit")
        self.assertLess(abs(run.energy_change()), 1e-5)
        self.assertLess(
            self.run_scene("geometry_b_flat", "contact-stabilized").energy_change(), -1e-2
        )

    def test_geometry_b_curved(self):
        changes = {}
        humps = {}
        for scheme in check_history.SCHEMES:
            run = self.run_scene("geometry_b_curved", scheme, label="-full")
            changes[scheme] = 100 * run.energy_change()
            force = run["contact_force"]
            humps[scheme] = sum(a < b > c for a, b, c in zip(force, force[1:], force[2:]))
            if scheme == "newmark":
                self.assertGreater(changes[scheme], 0.5)
                self.assertLess(changes[scheme], 9.0)
            else:
                self.assertLess(changes[scheme], -0.1)
                self.assertGreater(changes[scheme], -0.8)
        self.assertEqual(humps["contact-stabilized"], 1)
        self.assertGreater(humps["newmark"], 2)

    def test_swapping_slave_and_master_changes_little(self):
        """The force curves differ by less than the discretisation errors of both, estimated by the
        next finer mesh, and ever less."""
        curves = {}
        for refinement in (2, 3, 4):
            for pair in ("upper[4] : lower[5]", "lower[5] : upper[4]"):
                overrides = [
                    f"Bodies/upper/Refinements={refinement}",
                    f"Bodies/lower/Refinements={refinement}",
                    "Time/End time=0.012",
                    f"Contact/Pairs={pair}",
                ]
                run = self.run_scene(
                    "geometry_b_curved", "contact-stabilized", overrides, f"-{refinement}-{pair[0]}"
                )
                curves[refinement, pair[0]] = run["contact_force"]

        def distance(first, second):
            return sum(abs(a - b) for a, b in zip(first, second)) / sum(first)

        swap = {r: distance(curves[r, "u"], curves[r, "l"]) for r in (2, 3, 4)}
        error = {
            r: sum(distance(curves[r, slave], curves[r + 1, slave]) for slave in "ul")
            for r in (2, 3)
        }
        for refinement in (2, 3):
            self.assertLess(swap[refinement], error[refinement], f"{swap}, {error}")
        self.assertLess(swap[4], swap[3], f"{swap}")
        self.assertLess(swap[3], swap[2], f"{swap}")


for scene in FREE_SCENES:
    setattr(TwoBodies, f"test_invariants_{scene}", lambda self, name=scene: self.check(name))


if __name__ == "__main__":
    check_history.main()
