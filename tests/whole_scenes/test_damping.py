# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Damping of bodies, against the logarithmic decrement of an oscillator, and of the scheme, against
the theory of Hertz for a steel ball whose smallest cells are much faster than a step."""

import math

import check_history

#: The first mode of a bar that is held at one end: with nu = 0 a sine, which the mesh contains, of
#: angular frequency pi c/(2 L), c = 30 and L = 10.
BAR = (
    """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = 0.3
end
subsection Bodies
  set Names = bar
"""
    + check_history.bar("bar", "Dirichlet=0: 0; 0", "Initial velocity=sin(pi*x/20); 0")
    + """end
"""
)
#: Shipped scenes that are tested here.
SCENES = ("steel_ball",)
OMEGA = math.pi * 30 / 20
#: A steel ball of radius 10 mm and 1 m/s on a rigid plane: largest force, duration of contact.
HERTZ_FORCE, HERTZ_DURATION = 2309.0, 52.3e-6


def damped(mass, stiffness, scheme):
    """(decrement, settings of a run over three periods of the damped vibration)"""
    ratio = 0.5 * (mass / OMEGA + stiffness * OMEGA)
    period = 2 * math.pi / (OMEGA * math.sqrt(1 - ratio**2))
    overrides = [
        f"Bodies/bar/Damping={mass}, {stiffness}",
        f"Time/Step size={period / 200!r}",
        f"Time/End time={3 * period!r}",
        f"Time/Scheme={scheme}",
    ]
    return 2 * math.pi * ratio / math.sqrt(1 - ratio**2), overrides


class Damping(check_history.SceneTest):
    def test_a_vibration_has_its_logarithmic_decrement(self):
        """Amplitudes shrink by exp(-decrement) per period, energies by its square; the column of
        the ledger explains all of it."""
        for mass, stiffness in ((0.3, 0.0), (0.0, 0.01), (0.2, 0.02)):
            for scheme in ("contact-stabilized-projected", "laursen-chawla"):
                with self.subTest(mass=mass, stiffness=stiffness, scheme=scheme):
                    decrement, overrides = damped(mass, stiffness, scheme)
                    run = check_history.Run(BAR, "vibration", overrides)
                    energy = run["total_energy"]
                    self.expect_close(
                        0.5 * math.log(energy[0] / energy[-1]) / 3, decrement, 1e-3, "decrement"
                    )
                    self.assertLess(max(run["work_damping"]), 1e-15 * energy[0])
                    self.expect_close(
                        sum(run["work_damping"]), energy[-1] - energy[0], 1e-9, "work of damping"
                    )
                    self.expect_ledger_closes(run)

    def test_a_scheme_without_damping_refuses_it(self):
        for scheme in ("generalized-alpha", "khenous-laborde-renard", "reference"):
            with self.subTest(scheme=scheme), self.assertRaises(AssertionError) as failure:
                check_history.Run(BAR, "refused", damped(0.1, 0.0, scheme)[1])
            for part in ("exit status 2", "Bodies/bar/Damping", scheme, "contact-stabilized"):
                self.assertIn(part, str(failure.exception))

    def steel_ball(self, name, *overrides):
        """The run and the speed of the pole, relative to the ball's, after its last contact."""
        run = check_history.Run(check_history.scene_file("steel_ball"), name, overrides)
        last = max(row for row, force in enumerate(run["contact_force"]) if force > 0)
        pole = run.probes["pole"]["normal_velocity"][last + 1 :]
        self.assertGreater(len(pole), 15, "the run goes on after the contact")
        return run, run["time"][last], max(map(abs, pole))

    def test_a_steel_ball_rebounds_as_hertz_says(self):
        """With all defaults: force and duration within 3 and 5 percent, the last force when contact
        ends, and a pole that does not ring (without damping: 25 m/s and more). Nothing is gained,
        and what damping took is a column."""
        for scheme in ((), ("Time/Scheme=contact-stabilized",)):
            with self.subTest(scheme=scheme):
                run, end, speed = self.steel_ball("steel", *scheme)
                self.expect_close(max(run["contact_force"]), HERTZ_FORCE, 0.03, "largest force")
                self.expect_close(end, HERTZ_DURATION, 0.05 + 1 / 65, "end of contact")
                self.assertLess(speed, 5000.0, "pole after release, in mm/s")
                self.expect_ledger_closes(run)
                self.expect_no_gain_of_energy(run)
                self.assertLess(sum(run["work_scheme"]), -0.005 * run["total_energy"][0])
                self.assertIn("spectral radius", run.log)
                self.assertNotIn("to and fro", run.log)

    def test_without_damping_it_rings_but_no_force_acts_across_a_gap(self):
        run, end, speed = self.steel_ball("ringing", "Time/Spectral radius=1")
        self.assertGreater(speed, 10000.0, "else the test of damping shows nothing")
        self.expect_close(end, HERTZ_DURATION, 0.05 + 1 / 65, "end of contact")
        self.assertEqual(max(map(abs, run["work_scheme"])), 0.0)
        self.assertIn("times as fast to and fro from step to step", run.log)

    def test_damping_follows_the_mesh(self):
        """Steps of 0.02 have the Courant number 16 of the first mesh, 32 where the disc is refined
        once to touch the floor, and 130 where it is three times: only these are damped. What the
        mesh might become counts for nothing."""
        overrides = [
            "Bodies/disc/Refinements=3",
            "Bodies/disc/Centre=0, 1.3",
            "Bodies/disc/Initial velocity=0; -1",
            "Time/Step size=2e-2",
            "Time/End time=0.8",
            "Adaptivity/Indicator=distance",
            "Adaptivity/Distance=0.02",
            "Output/VTU=false",
        ]
        scene = check_history.PARAMETERS / "disc_2d.prm"
        for maximum in (4, 6):
            with self.subTest(maximum=maximum):
                level = [f"Adaptivity/Maximum level={maximum}"]
                run = check_history.Run(scene, f"follows-{maximum}", overrides + level)
                rows = list(zip(run["cells"], run["work_scheme"]))[1:]
                coarse = [work for cells, work in rows if cells == run["cells"][0]]
                finer = [work for cells, work in rows if cells > run["cells"][0]]
                self.assertGreater(len(coarse), 3, "the flight")
                self.assertGreater(len(finer), 3, "the contact")
                self.assertEqual(max(map(abs, coarse)), 0.0)
                if maximum == 4:
                    self.assertEqual(max(map(abs, finer)), 0.0)
                else:
                    self.assertLess(min(finer), -1e-6 * run["total_energy"][0])
                self.expect_ledger_closes(run)
        # A disc that begins so near that its first mesh is a fine one: the log says what it damps.
        near = [*overrides, "Bodies/disc/Centre=0, 1.01", "Adaptivity/Maximum level=6"]
        run = check_history.Run(scene, "follows-from-the-start", near)
        self.assertGreater(run["cells"][0], 5 * 4**3)
        self.assertIn("spectral radius", run.log)


if __name__ == "__main__":
    check_history.main()
