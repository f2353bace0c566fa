#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Obstacles that move may be all that presses a body: nothing else says how accurate forces have to
be. A box between two smooth plates bears modulus times strain times area, at any scale of lengths.
With friction it bears more, and a plate that then moves sideways shears it, until the forces of
floor and plate have its moment. All this takes the iterations of any other load.
"""

import check_history

MODULUS, WIDTH, HEIGHT = 10.0, 24.0, 10.0
#: Solver iterations of a step. Without a scale for errors it took 6000 and did not end.
MOST_ITERATIONS = 120


def box_between_plates(scheme, step_size, friction, plate, scale=1.0):
    """Two steps. plate: displacement of the upper one along x and z, for scale 1."""
    along, down = (f"{scale}*({component})" for component in plate)
    plates = ("box[4] : floor", "box[5] : press")
    return f"""
set Dimension = 3
subsection Time
  set Scheme    = {scheme}
  set Step size = {step_size}
  set End time  = {2 * step_size}
end
subsection Bodies
  set Names = box
  subsection box
    set Shape           = box
    set Lower corner    = 0, 0, 0
    set Upper corner    = {WIDTH * scale}, {WIDTH * scale}, {HEIGHT * scale}
    set Repetitions     = 6, 6, 3
    set Young's modulus = {MODULUS}
    set Poisson's ratio = 0.45
    set Density         = 1e-9
  end
end
subsection Obstacles
  set Names = floor, press
  subsection floor
    set Normal = 0, 0, 1
  end
  subsection press
    set Point  = 0, 0, {HEIGHT * scale}
    set Normal = 0, 0, -1
    set Motion = {along}; 0; {down}
  end
end
subsection Contact
  set Pairs = {", ".join(plates)}
""" + "".join(
        f"subsection {plate}\nset Friction coefficient = {friction}\nend\n" for plate in plates
    ) + "end\n"


class Presses(check_history.SceneTest):
    def press(self, name, *scene, **more):
        """Runs it, and expects what holds of all of them."""
        run = check_history.Run(box_between_plates(*scene, **more), name)
        self.assertEqual(len(run), 3)
        self.assertEqual(sum(run["rejected_steps"]) + sum(run["fallbacks"]), 0)
        self.assertLess(max(run["linear_iterations"]), MOST_ITERATIONS)
        self.assertLess(max(run["predictor_iterations"]), MOST_ITERATIONS)
        self.expect_no_penetration(run, HEIGHT * more.get("scale", 1.0))
        return run

    def test_a_smooth_box_bears_modulus_times_strain(self):
        for scale in (1e-3, 1.0, 1e3):
            with self.subTest(scale=scale):
                run = self.press(f"smooth_{scale}", "static", 1, 0, ("0", "-0.2*t"), scale=scale)
                for time, force in zip(run["time"], run["contact_force"]):
                    borne = 0.2 * time / HEIGHT * MODULUS * (WIDTH * scale) ** 2
                    self.expect_close(force, 2 * borne, 1e-8, f"both plates at {time}")

    def test_friction_bears_shear(self):
        """The plate goes down in the first step, and along x in the second."""
        run = self.press("rough", "static", 1, 0.5, ("max(0, t - 1)", "-0.4*min(t, 1)"))
        smooth = 2 * 0.4 / HEIGHT * MODULUS * WIDTH**2
        self.assertGreater(run["contact_force"][1], 1.1 * smooth)
        self.assertGreater(run["elastic_energy"][2], 1.2 * run["elastic_energy"][1])
        for component in run.vector("contact_force", 2):
            self.assertLess(abs(component), 1e-7 * run["contact_force"][2])

    def test_a_step_of_the_motion_knows_its_scale(self):
        """All is at rest when the plate starts: the energy so far is zero."""
        run = self.press("motion", "contact-stabilized", 1e-5, 0.5, ("0", "-1000*t"))
        self.expect_contact(run)
        self.expect_losses(run)


if __name__ == "__main__":
    check_history.main()
