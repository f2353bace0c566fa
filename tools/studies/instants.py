# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""To which instant of a step the contact force and the velocity that a scheme reports belong: the one place where that is said.

The contact force of a step acts against all others, and it belongs to the instant at which those are taken. For elastic forces with equal weights at both
ends, that is the middle of the step; for equilibrium at the end, the end. Measured on parameters/manufactured_bar.prm, where the force is known: at its
own instant the error of the force has order 1.3 to 1.8 (the kinks at closing and opening limit it), elsewhere order 1.
"""

from .mistake import Mistake

MIDDLE, END = 0.5, 0.


def middle(_):
    """The force is a mean over the step."""
    return MIDDLE


def end(_):
    """The force is in equilibrium with the others at the end of the step."""
    return END


#: How far before the end of the step the force belongs, as a part of the step; a function of the keys of the section Time.
FORCE = {
    # One force r against the elastic forces A (u + d/2) of the middle.
    "laursen-chawla": middle,
    "laursen-love": middle,
    "contact-implicit": middle,
    "contact-stabilized": middle,
    "contact-stabilized-projected": middle,
    "hager-hueeber-wohlmuth": middle,
    # An impulse over the step, divided by the step.
    "moreau-jean": middle,
    "nonsmooth-generalized-alpha": middle,
    # Forces of both ends act, each with its own elastic forces. (It cannot be measured: the force does not converge.)
    "newmark": end,
    # Equilibrium at the end of the step.
    "khenous-laborde-renard": end,
    "reference": end,
    "backward-euler": end,
    # The new force acts against elastic forces at t_n - alpha_f tau, and there its error is least: generalized-alpha with spectral radius 0.8
    # (alpha_f = 0.44) has order 1.6 there, 1.1 at the end. For HHT with alpha = -0.1 the two hardly differ.
    "hht-alpha": lambda keys: -float(keys["HHT alpha"]),
    "generalized-alpha": lambda keys: float(keys["Spectral radius"]) / (1 + float(keys["Spectral radius"])),
}
#: Schemes whose contact nodes have no mass and report d/tau, the mean velocity over the step. All others report the velocity at its end.
MEAN_VELOCITY = ("khenous-laborde-renard", "reference")


def before_end(keys):
    """How far before the end of the step the contact force belongs, as a part of the step. keys: of the section Time."""
    if keys["Scheme"] not in FORCE:
        raise Mistake(f"the instant to which the contact force of Time/Scheme = {keys['Scheme']} belongs is not known, and errors of the force need it. "
                      "Add the scheme to FORCE in tools/studies/instants.py.")
    return FORCE[keys["Scheme"]](keys)


def velocity_is_mean(keys):
    """Whether velocities of contact nodes are means over the step."""
    return keys["Scheme"] in MEAN_VELOCITY
