#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Every scheme whose law of energy is proved for fixed normals keeps it where contact follows the
motion, because normals are fixed within a step: none gains energy, and those that conserve lose
none. All of them let a stiff block slide in a bowl as a mass point, feel nothing of what they fly
past, and get from a moving punch exactly the work that it does.
"""

import math

import check_history
import test_moving_contact as bowls
import test_moving_obstacles as punches

CONSERVING = ("laursen-chawla", "laursen-love", "hager-hueeber-wohlmuth")
DISSIPATING = ("backward-euler", "contact-implicit")
#: Contact nodes without mass: by themselves, or with the scheme that allows it.
MASSLESS = {"hager-hueeber-wohlmuth": "", "contact-implicit": "\n  set Mass = redistributed"}
#: Nodes may end a step inside by what they move in it.
PENETRATING = ("laursen-chawla", "hager-hueeber-wohlmuth")


def with_mass(scene, scheme):
    """The same scene with what the scheme makes of the mass."""
    return scene.replace(f"= {scheme}\n", f"= {scheme}{MASSLESS.get(scheme, '')}\n")


class Schemes(check_history.SceneTest):
    """See the beginning of the file."""

    def expect_law(self, scheme, history, accuracy):
        """No contact work > 0, none at all where the scheme conserves; a ledger without a rest."""
        self.expect_losses(history, accuracy)
        if scheme in CONSERVING:
            energy = max(history["total_energy_modified"])
            self.assertGreater(min(history["work_contact"]), -accuracy * energy)

    def test_block_slides_in_a_bowl_as_a_mass_point(self):
        """Angle V t/R, and force m V^2/R in the mean of the steps. backward-euler damps the turn of
        the block, too, in proportion to the step size."""
        speed, end = 0.3, 1.0
        for scheme in CONSERVING + DISSIPATING:
            with self.subTest(scheme=scheme):
                scene = with_mass(bowls.in_bowl(scheme, 0.005, end, speed), scheme)
                scene = scene.replace("block : bowl", "block[2] : bowl")
                scene = scene.replace("= 2, 1", "= 4, 4")
                if scheme == "backward-euler":
                    scene = scene.replace("  set Spectral radius = 1\n", "")
                history = check_history.Run(scene, f"bowl_{scheme}").history
                self.expect_law(scheme, history, bowls.ACCURACY)
                angle = math.atan2(history["momentum_y"][-1], history["momentum_x"][-1])
                self.assertAlmostEqual(angle / (speed * end), 1, delta=3e-3)
                second_half = history["contact_force"][100:]
                force = sum(second_half) / len(second_half)
                expected = bowls.MASS * speed**2 * bowls.ARM
                self.assertAlmostEqual(force / expected, 1, delta=3e-3)
                depth = speed * 0.005 if scheme in PENETRATING else 1e-10 * bowls.HALF
                self.assertLess(max(history["max_penetration"]), depth)

    def test_disc_flies_past_a_circle(self):
        """The force is exactly 0, and the energy what it was."""
        for scheme in CONSERVING + DISSIPATING:
            with self.subTest(scheme=scheme):
                scene = bowls.FLIGHT.format(motion="follow").replace(
                    "subsection Time\n", f"subsection Time\n  set Scheme = {scheme}\n"
                )
                history = check_history.Run(with_mass(scene, scheme), "flight").history
                self.assertEqual(max(history["contact_force"]), 0)
                energies = history["total_energy_modified"]
                self.assertAlmostEqual(energies[-1] / energies[0], 1, delta=1e-10)

    def test_work_of_a_punch_is_the_energy_that_it_brings(self):
        """Force times motion of the punch is the external work, and the law of the scheme holds for
        the rest, with friction, too."""
        for scheme in CONSERVING + ("backward-euler",):
            with self.subTest(scheme=scheme):
                scene = punches.PUNCH.format(
                    scheme=scheme, motion=punches.PUNCH_MOTION, friction=0.3
                )
                scene = scene.replace("block : punch", "block[3] : punch")
                history = check_history.Run(scene, "punch", ["Time/End time=1.5"]).history
                energy = max(history["total_energy"])
                self.assertAlmostEqual(
                    punches.work_of_punch(history) / energy,
                    sum(history["work_external"]) / energy,
                    delta=1e-11,
                )
                self.expect_law(scheme, history, check_history.ACCURACY)
                self.assertLess(min(history["work_friction"]), 0)

    def test_impulses_follow_an_oblique_wedge(self):
        """A wedge hands a part of its work on to the support of the block; laursen-love gives back
        what the nodes lost relative to the wedge, and no more."""
        for impulses in ("per node", "common"):
            with self.subTest(impulses=impulses):
                scene = punches.wedge("laursen-love", 0.5)
                history = check_history.Run(scene, "wedge", [f"Time/Impulses={impulses}"]).history
                self.assertGreater(max(history["contact_force"]), 0)
                self.expect_law("laursen-love", history, check_history.ACCURACY)


if __name__ == "__main__":
    check_history.main()
