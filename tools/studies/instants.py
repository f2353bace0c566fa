# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""To which instant of a step the contact force and the velocity that a scheme reports belong.

The contact force of a step acts against all others, and it belongs to the instant at which those
are taken. For elastic forces with equal weights at both ends, that is the middle of the step; for
equilibrium at the end, the end. Measured on parameters/verification/manufactured_bar.prm, where the
force is known: at its own instant the error of the force has order 1.3 to 1.8 (the kinks at closing
and opening limit it), elsewhere order 1. What holds for which scheme is in the program's own table,
`signorini --print-schemes=json`.
"""

import json

import signorini

from .expressions import Expression
from .mistake import Mistake

MIDDLE, END = 0.5, 0.0

schemes = {}


def use(executable):
    """Read the table of schemes of a program."""
    try:
        table = json.loads(signorini.ask("--print-schemes=json", executable=executable))
        schemes.update((scheme["name"], scheme) for scheme in table)
    except (ValueError, signorini.SignoriniError) as error:
        raise Mistake(
            f"{executable}: its table of schemes cannot be read: {error}. Build the program with"
            " ./dev build."
        ) from None


def scheme_of(keys):
    """What the table says about the scheme of a run."""
    if keys["Scheme"] not in schemes:
        raise Mistake(
            "the program does not know the scheme of these results, Time/Scheme ="
            f" {keys['Scheme']}. Run the study again."
        )
    return schemes[keys["Scheme"]]


def before_end(keys):
    """How far before the end of the step the contact force belongs, as a part of the step. keys: of
    the section Time."""
    scheme = scheme_of(keys)
    text = keys[scheme["parameter"]] if scheme["parameter"] else "0"
    value = scheme["automatic"] if text == "automatic" else float(text)
    return Expression(scheme["force_before_end"], f"{scheme['name']}: force_before_end", ("p",))(
        value
    )


def velocity_is_mean(keys):
    """Whether velocities of contact nodes are means over the step."""
    return scheme_of(keys)["mean_velocity"]
