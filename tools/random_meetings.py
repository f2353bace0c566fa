# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Random scenes with large motions among obstacles and bodies, judged by the laws of mechanics.

Those of random_motions.py with up to two other bodies, which fly themselves or lie in wait: all
pairs of bodies meet, with contact that follows the motion, and each scene must keep the same laws.

    ./dev stress meetings [--count 500] [--seed 1] [--only NUMBER]
"""

import math
import sys

from random_motions import RandomMotion, may_follow
from stress import random_runs
from stress.random_runs import decades


class RandomMeeting(RandomMotion):
    """A scene, and what it promises."""

    def other_bodies(self):
        """Apart from each other."""

        def reach(size, is_round):
            return size / 2 * (1 if is_round else math.sqrt(self.dimension))

        known = [([0.0] * self.dimension, reach(self.size, self.round))]
        keys = {}
        for name in ["other", "third"][: self.source.choice((0, 1, 1, 2))]:
            size, is_round = self.size * decades(self.source, 0.5, 2), self.source.random() < 0.5
            away, own = self.direction(), reach(size, is_round)
            distance = known[0][1] + own + self.size * self.source.uniform(0.001, 0.3)
            middle = [distance * c for c in away]
            if all(math.dist(middle, place) > own + other for place, other in known):
                known.append((middle, own))
                keys |= self.body(name, size, is_round, middle, self.source.random() < 0.5)
                self.bodies.append(name)
        return keys


if __name__ == "__main__":
    sys.exit(random_runs.main(__doc__, RandomMeeting, may_follow))
