#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""An obstacle that comes to a body and leaves it again within one step is not overlooked: the step
is made again in parts. A round stamp dips into a slab for a moment at t = 0.52; steps that are much
longer than that moment find the force that short steps find, and the body rests before. The same
way given by its rate is the same way, however short it is. And a thin obstacle that a body would
fly through in one step stops it, or the run.
"""

import check_history

TIME = 0.52

SCENE = f"""
set Dimension = 2
subsection Time
  set End time = 1
end
subsection Bodies
  set Names = slab
  subsection slab
    set Shape           = box
    set Lower corner    = 0, -0.2
    set Upper corner    = 1, 0
    set Repetitions     = 20, 4
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
    set Density         = 1
    set Dirichlet       = 2: 0; 0
  end
end
subsection Obstacles
  set Names = stamp
  subsection stamp
    set Shape  = sphere
    set Centre = 0.55, 0.31
    set Radius = 0.3
    set Motion = 0; -0.03*exp(-((t-{TIME})/0.01)^2)
  end
end
subsection Contact
  set Pairs = slab[3] : stamp
end
"""

BULLET = """
set Dimension = 2
subsection Time
  set Step size = 0.05
  set End time  = 0.3
end
subsection Bodies
  set Names = bullet
  subsection bullet
    set Shape            = box
    set Lower corner     = -5, -0.05
    set Upper corner     = -4.9, 0.05
    set Repetitions      = 4, 4
    set Young's modulus  = 1e8
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = 100; 0
  end
end
subsection Obstacles
  set Names = plate
  subsection plate
    set Shape        = box
    set Lower corner = 0, -1
    set Upper corner = 0.05, 1
  end
end
subsection Contact
  set Pairs = bullet : plate
end
"""


class Visits(check_history.SceneTest):
    def test_rates_are_what_motions_are(self):
        way = f"exp(-((t-{TIME})/0.01)^2)"
        rate = f"-0.03*{way}*(-2*(t-{TIME})/0.01^2)"
        overrides = ["Time/Step size=2e-3"]
        motion = check_history.Run(SCENE, "motion", overrides)
        velocity = check_history.Run(
            SCENE.replace(f"Motion = 0; -0.03*{way}", f"Velocity = 0; {rate}"), "rate", overrides
        )
        self.assertGreater(max(motion["contact_force"]), 5)
        self.expect_same_history(motion, velocity, 1e-9)

    def test_thin_obstacles_are_not_flown_through(self):
        run = check_history.Run(BULLET, "bullet")
        self.assertGreater(sum(run["rejected_steps"]), 0)
        self.assertLess(max(run.table("bodies")["body_bullet_centroid_x"]), 0)

    def test_a_dip_is_not_stepped_over(self):
        exact = check_history.Run(SCENE, "short", ["Time/Step size=5e-4"])
        largest = max(exact["contact_force"])
        self.assertGreater(largest, 5)
        for control in ("goal", "embedded"):
            with self.subTest(control=control):
                steps = ["Time/Step size=2e-3", f"Time/Step size control={control}"]
                if control == "goal":
                    steps += ["Adaptivity/Indicator=none", "Adaptivity/Target error=0.05"]
                run = check_history.Run(SCENE, control, steps)
                self.assertGreater(max(run["step_size"]), 0.02)
                self.expect_close(max(run["contact_force"]), largest, 0.05, "largest force")
                for time, force in zip(run["time"], run["contact_force"]):
                    if time < TIME - 0.03:
                        self.assertEqual(force, 0.0, f"at {time}")


if __name__ == "__main__":
    check_history.main()
