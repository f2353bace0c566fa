# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Words about a run, each decided by one number, and the comparison with those from elsewhere."""

import dataclasses
import math
import typing

from .observe import OBSERVATIONS

#: A curve with less zigzag is called smooth, a pressure with less scatter, too (meshes alone
#: scatter by almost 0.01); a change of energy below the last one, in per cent, is called none.
SMOOTH, SMOOTH_PRESSURE, NONE = 0.01, 0.02, 1e-6
#: Numbers that differ less from those of the paper, relatively, agree.
CLOSE = 0.25


@dataclasses.dataclass
class Word:
    """A heading, the observation that decides, and the word for its value."""

    heading: str
    observation: str
    choose: typing.Callable

    def __call__(self, numbers):
        """The word, "-" where nothing was observed. numbers: values of observations by name."""
        value = numbers.get(self.observation, math.nan)
        return "-" if math.isnan(value) else self.choose(value)


def smooth(value, limit=SMOOTH):
    """The word for a zigzag or a scatter."""
    return "smooth" if value < limit else "oscillates"


WORDS = {
    "penetrates": Word("penetrates", "penetration_in_steps", lambda v: "yes" if v > 0 else "no"),
    "energy_grows": Word("energy grows", "energy_most", lambda v: "yes" if v > NONE else "no"),
    "own_energy_grows": Word(
        "own energy grows", "own_energy_most", lambda v: "yes" if v > NONE else "no"
    ),
    "loss": Word(
        "most of the loss", "loss_before_peak", lambda v: "on impact" if v > 50 else "on release"
    ),
    "force": Word("force", "force_zigzag", smooth),
    "pressure": Word("contact pressure", "pressure_scatter", lambda v: smooth(v, SMOOTH_PRESSURE)),
    "velocity_contact": Word("velocity in contact", "velocity_zigzag", smooth),
}
#: Two observations as one range.
RANGES = {
    "velocity_after": ("velocity after release", "velocity_after_least", "velocity_after_most"),
    "velocity_range": ("velocity from contact on", "velocity_least", "velocity_most"),
}


def heading(quantity):
    """What a quantity is called in a table."""
    if quantity in WORDS:
        return WORDS[quantity].heading
    return RANGES[quantity][0] if quantity in RANGES else OBSERVATIONS[quantity].heading


def say(quantity, numbers):
    """What was observed, as a text."""
    if quantity in WORDS:
        return WORDS[quantity](numbers)
    if quantity in RANGES:
        low, high = (numbers.get(name, math.nan) for name in RANGES[quantity][1:])
        return "-" if math.isnan(low) else f"{low:.3g} to {high:.3g}"
    value = numbers.get(quantity, math.nan)
    return "-" if math.isnan(value) else f"{value:.3g}"


def verdict(paper, here):
    """How a text observed here compares with that of the paper."""
    if here == "-":
        return "-"
    try:
        theirs, ours = ([float(end) for end in text.split(" to ")] for text in (paper, here))
    except ValueError:
        return "agrees" if paper == here else "differs"
    if len(theirs) == 2:
        width = theirs[1] - theirs[0]
        if max(abs(a - b) for a, b in zip(theirs, ours)) <= CLOSE * width:
            return "agrees"
        return f"ratio {(ours[1] - ours[0]) / width:.2g}"
    if abs(theirs[0]) == 0.0:
        return "agrees" if abs(ours[0]) <= NONE else "differs"
    ratio = ours[0] / theirs[0]
    if abs(ratio - 1) <= CLOSE:
        return "agrees"
    return f"ratio {ratio:.2g}" if ratio > 0 else "differs in sign" if ratio < 0 else "none here"
