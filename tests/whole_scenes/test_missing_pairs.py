# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Bodies and obstacles that are no pair pass through each other; the run says so once, with the
time, the names and the pair to add, whatever the number of processes. Where they stay apart,
where the pair is there, and where an obstacle has no value, nothing is said."""

import check_history

#: Two discs that meet after 0.1 units of time, and a wall behind the left one, which it reaches
#: then if it moves the other way.
MEETING = """
set Dimension = 2
subsection Time
  set Step size = 5e-3
  set End time  = {end}
end
subsection Bodies
  set Names = left, right
  subsection left
    set Shape            = ball
    set Centre           = 0, 0
    set Radius           = 1
    set Refinements      = 3
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = {speed}; 0
  end
  subsection right
    set Shape            = ball
    set Centre           = 3, 0.3
    set Radius           = 1
    set Refinements      = 2
    set Young's modulus  = 1e4
    set Poisson's ratio  = 0.3
    set Density          = 1
    set Initial velocity = -5; 0
  end
end
subsection Obstacles
  set Names = wall
  subsection wall
    set Point  = -1.5, 0
    set Normal = 1, 0
  end
end
subsection Contact
  set Pairs = {pairs}
end
"""


def scene(pairs, speed=5, end=0.3):
    return MEETING.format(speed=speed, pairs=pairs, end=end)


class MissingPairs(check_history.SceneTest):
    def warnings(self, run, *parts):
        return [
            line
            for line in run.log.splitlines()
            if "warning: " in line and all(part in line for part in parts)
        ]

    def test_bodies_that_pass_through_each_other(self):
        """They touch at 0.1 and are a good part of a cell deep soon after."""
        for processes in (1, 2):
            run = check_history.Run(
                scene("right : wall"), f"through_{processes}", processes=processes
            )
            found = self.warnings(run, "overlap")
            self.assertEqual(len(found), 1, run.log)
            self.assertIn("the bodies 'left' and 'right', which are no pair", found[0])
            self.assertIn("add `left : right` to `Contact/Pairs`", found[0])
            time = float(found[0].split("at time ")[1].split()[0])
            self.assertGreater(time, 0.1)
            self.assertLess(time, 0.2)

    def test_a_body_that_runs_through_an_obstacle(self):
        """The wall is the partner of the other disc only. The depth of 1 % of the size, 0.02, is
        reached at 0.104; every eighth step is looked at."""
        run = check_history.Run(scene("right : wall", speed=-5, end=0.13), "obstacle")
        found = self.warnings(run, "obstacle")
        self.assertEqual(len(found), 1, run.log)
        self.assertIn("the body 'left' is ", found[0])
        self.assertIn("deep in the obstacle 'wall', which is not its partner", found[0])
        self.assertIn("add `left : wall`", found[0])
        time = float(found[0].split("at time ")[1].split()[0])
        self.assertGreater(time, 0.1039)
        self.assertLess(time, 0.1301)

    def test_an_obstacle_that_is_not_known_where_the_body_is(self):
        """The right disc begins beyond x = 2, where the root ends, and comes in: a part of it is
        at such points all the time. Two processes do not have the same of them."""
        text = scene("left : wall", speed=0, end=0.05)
        text = text.replace("set Point  = -1.5, 0", "set Shape = function").replace(
            "set Normal = 1, 0", "set Signed distance = x + 1.5 + 0*sqrt(4 - x^2)"
        )
        for processes in (1, 2):
            run = check_history.Run(text, f"unknown_{processes}", processes=processes)
            self.assertEqual(len(run), 11)
            self.assertEqual(self.warnings(run, "Nothing keeps them apart"), [])

    def test_nothing_is_said_of_what_stays_apart_or_is_a_pair(self):
        apart = check_history.Run(scene("right : wall", speed=-5, end=0.09), "apart")
        paired = check_history.Run(scene("left : right, left : wall"), "paired")
        for run in (apart, paired):
            self.assertEqual(self.warnings(run, "Nothing keeps them apart"), [])


if __name__ == "__main__":
    check_history.main()
