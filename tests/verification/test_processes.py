#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Two processes compute the same motion as one: the histories agree to 1e-8, because each step is solved to an accuracy far below
that and does not depend on how the mesh is distributed.
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
    "geometry_b_flat": ["Bodies/upper/Refinements=3", "Bodies/lower/Refinements=3", "Time/End time=0.02"],
    "geometry_b_curved": ["Bodies/upper/Refinements=3", "Bodies/lower/Refinements=3", "Time/End time=0.02"],
    "geometry_b_tilted": ["Bodies/upper/Refinements=3", "Bodies/lower/Refinements=3", "Time/End time=0.02"],
    "stack_of_boxes": ["Time/End time=0.08"],
    "hammer_and_anvil": [],
}


#: Its forces hold a reaction of the projection, too: nodes without one must not count as touching.
PROJECTED = {name: ("contact-stabilized-projected",) for name in ("quick_start", "disc_2d", "geometry_b_curved")}


class Processes(check_history.SceneTest):
    def check(self, name):
        for scheme in check_history.DISSIPATIVE + PROJECTED.get(name, ()):
            with self.subTest(scheme=scheme):
                one, two = (check_history.Run(check_history.PARAMETERS / f"{name}.prm", f"processes-{name}-{scheme}-{n}",
                                              SCENES[name] + [f"Time/Scheme={scheme}"], processes=n) for n in (1, 2))
                self.expect_contact(one)
                self.expect_same_history(one, two, 1e-8)


for scene in SCENES:
    setattr(Processes, f"test_{scene}", lambda self, name=scene: self.check(name))


if __name__ == "__main__":
    check_history.main()
