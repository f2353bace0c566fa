#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Two processes compute the same motion as one: the histories agree to 1e-8, because each step is
solved to an accuracy far below that and does not depend on how the mesh is distributed.
"""

import check_history

SCENES = {
    "quick_start": ["Bodies/ball/Refinements=2"],
    "disc_2d": ["Bodies/disc/Refinements=4"],
    "box_on_sphere": ["Bodies/box/Refinements=2"],
    "bar_2d": [],
    "two_bars": [],
    "striking_bar": [],
    "short_and_long_bar": [],
    "two_balls_head_on": ["Bodies/upper/Refinements=2", "Bodies/lower/Refinements=2"],
    "two_balls_off_centre": ["Bodies/upper/Refinements=2", "Bodies/lower/Refinements=2"],
    "geometry_b_flat": [
        "Bodies/upper/Refinements=3",
        "Bodies/lower/Refinements=3",
        "Time/End time=0.02",
    ],
    "geometry_b_curved": [
        "Bodies/upper/Refinements=3",
        "Bodies/lower/Refinements=3",
        "Time/End time=0.02",
    ],
    "geometry_b_tilted": [
        "Bodies/upper/Refinements=3",
        "Bodies/lower/Refinements=3",
        "Time/End time=0.02",
    ],
    "stack_of_boxes": ["Time/End time=0.08"],
    "hammer_and_anvil": [],
}

#: A block slides over a longer one, and a block that is thrown obliquely on a floor sticks and
#: slips.
FRICTION = {
    "friction_2d": (
        """
set Dimension = 2
subsection Time
  set Step size = 4e-3
  set End time  = 0.24
end
subsection Bodies
  set Names = upper, lower
  subsection upper
    set Shape            = box
    set Lower corner     = 0.45, 0.004
    set Upper corner     = 1.65, 1
    set Repetitions      = 5, 4
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 2
    set Initial velocity = 1; -2
  end
  subsection lower
    set Shape            = box
    set Lower corner     = -0.2, -1
    set Upper corner     = 1.2, 0
    set Repetitions      = 7, 5
    set Young's modulus  = 500
    set Poisson's ratio  = 0.3
    set Density          = 2
  end
end
subsection Contact
  set Motion = linearised
  set Pairs  = upper[2] : lower[3]
  subsection upper[2] : lower[3]
    set Friction coefficient = 0.3
  end
end
subsection Probes
  set Names = middle
  subsection middle
    set Point = 0.93, 0.004
  end
end
"""
    ),
    "friction_3d": (
        """
set Dimension = 3
subsection Time
  set Step size = 6e-3
  set End time  = 0.24
end
subsection Bodies
  set Names = block
  subsection block
    set Shape             = box
    set Lower corner      = 0, 0, 0.004
    set Upper corner      = 1.4, 1, 1
    set Repetitions       = 3, 2, 2
    set Local refinements = 1
    set Refine where      = 0.7 - x - 0.4*y
    set Young's modulus   = 500
    set Poisson's ratio   = 0.3
    set Density           = 2
    set Initial velocity  = 0.4; 0.25; -2
  end
end
subsection Obstacles
  set Names = floor
  subsection floor
    set Shape  = plane
    set Point  = 0, 0, 0
    set Normal = 0, 0, 1
  end
end
subsection Contact
  set Pairs = block[4] : floor
  subsection block[4] : floor
    set Friction coefficient = 0.3
  end
end
subsection Probes
  set Names = corner
  subsection corner
    set Point = 1.4, 1, 0.004
  end
end
"""
    ),
}

#: Its forces hold a reaction of the projection, too: nodes without one must not count as touching.
PROJECTED = {
    name: ("contact-stabilized-projected",)
    for name in ("quick_start", "disc_2d", "geometry_b_curved")
}


class Processes(check_history.SceneTest):
    def check(self, name):
        for scheme in check_history.DISSIPATIVE + PROJECTED.get(name, ()):
            with self.subTest(scheme=scheme):
                one, two = (
                    check_history.Run(
                        check_history.PARAMETERS / f"{name}.prm",
                        f"processes-{name}-{scheme}-{n}",
                        SCENES[name] + [f"Time/Scheme={scheme}"],
                        processes=n,
                    )
                    for n in (1, 2)
                )
                self.expect_contact(one)
                self.expect_same_history(one, two, 1e-8)

    def check_friction(self, name):
        for scheme in check_history.DISSIPATIVE + (
            "contact-stabilized-projected",
            "laursen-chawla",
        ):
            with self.subTest(scheme=scheme):
                one, two = (
                    check_history.Run(
                        FRICTION[name],
                        f"processes-{name}-{scheme}-{n}",
                        [f"Time/Scheme={scheme}"],
                        processes=n,
                    )
                    for n in (1, 2)
                )
                self.expect_contact(one)
                self.assertGreater(max(one["stick_nodes"]), 0)
                self.assertGreater(max(one["slip_nodes"]), 0)
                self.expect_same_history(one, two, 1e-8)


for scene in SCENES:
    setattr(Processes, f"test_{scene}", lambda self, name=scene: self.check(name))
for scene in FRICTION:
    setattr(Processes, f"test_{scene}", lambda self, name=scene: self.check_friction(name))


if __name__ == "__main__":
    check_history.main()
