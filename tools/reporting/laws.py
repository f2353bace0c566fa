# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The laws of mechanics, asked of the tables of a run.

A law is judged where the scheme proves it, with the limits of the program's guard (doc/output.md).
What another scheme does is an error of its discretisation, which is told, not judged. Nothing is
taken from what the program says about itself: balances are made of the columns.
"""

import numpy

from .verdict import BROKEN, KEPT, LOOK, NOT_JUDGED, Verdict, by_limit

#: Limits of the guard, relative, and how many tolerances of the solver they are at least.
ENERGY, PENETRATION, MOMENTUM, FORCE = 1e-6, 1e-6, 1e-5, 1e-5
TOLERANCES = 1e4
#: True depth in an obstacle, in sizes, that the program warns of.
DEEP = 0.01
#: Forces that are smaller parts of the largest one are round-off.
NO_FORCE = 1e-7
WORKS = ("contact", "predictor", "friction", "damping", "scheme", "external")
AXES = "xyz"


def judge_laws(run):
    """Verdicts in the order of the page."""
    return [
        law(run)
        for law in (finite, energy_balance, no_gain, momentum, penetration, complementarity, guard)
    ]


def limit(run, least):
    """Of a law, with the accuracy that was asked of the solver."""
    return max(least, TOLERANCES * run.number("Solver/Tolerance", 0.0))


def column(run, name):
    """Of the history, zeros if it is not there."""
    return run.history.get(name, numpy.zeros(len(run.history.get("time", [0.0]))))


def energy_scale(run):
    """The largest energy of the motion, or the largest work from outside, if that is more."""
    motion = column(run, "kinetic_energy_modified") + column(run, "elastic_energy")
    potential = column(run, "external_energy")
    brought = numpy.cumsum(column(run, "work_external")) - (potential - potential[0])
    return max(motion.max(), abs(brought).max())


def part(some, whole):
    """As a part of the whole, which is nothing where there is nothing at all."""
    return 0.0 if some == 0.0 else some / whole if whole > 0.0 else numpy.inf


def finite(run):
    """All values of all tables."""
    wrong = [
        f"{table}.csv: {name}"
        for table, columns in run.tables.items()
        for name, values in columns.items()
        if not numpy.isfinite(values).all()
    ]
    if wrong:
        return Verdict("numbers", BROKEN, f"Not finite: {', '.join(wrong[:5])}.")
    any_rows = any(len(values) for columns in run.tables.values() for values in columns.values())
    return Verdict("numbers", KEPT if any_rows else NOT_JUDGED, "All entries are finite.")


def needs(run, name, *columns):
    """A verdict for a run that does not have what a law needs, None for others."""
    if run.scheme is None:
        return Verdict(name, NOT_JUDGED, "The scheme of the run is not known here.")
    missing = [column for column in columns if column not in run.history]
    if missing or len(run.history.get("time", ())) < 2:
        return Verdict(name, NOT_JUDGED, f"history.csv lacks {', '.join(missing) or 'steps'}.")
    return None


def energy_balance(run):
    """What a step does not explain of the change of the energy: by the table, and in it."""
    name = "energy balance"
    lacking = needs(run, name, "total_energy_modified", "energy_residual")
    if lacking:
        return lacking
    if not run.scheme.inertia:
        return Verdict(name, NOT_JUDGED, "Load steps without inertia have no balance of energy.")
    works = [column(run, f"work_{work}") for work in WORKS] + [column(run, "energy_transfer")]
    change = numpy.diff(run.history["total_energy_modified"])
    unexplained = change - sum(works)[1:]
    worst = max(abs(run.history["energy_residual"]).max(), abs(unexplained).max(initial=0.0))
    scale = max(energy_scale(run), *(abs(work).max() for work in works))
    text = "The works of a step leave at most {} of the energy unexplained"
    verdict = by_limit(name, part(worst, scale), limit(run, ENERGY), text)
    if run.scheme.own_tolerance and verdict.state == BROKEN:
        verdict.state = LOOK
        verdict.text += " It is the error of an integration with a tolerance of its own."
    return verdict


def follows(run):
    """Whether contact follows the motion."""
    motion = run.setting("Contact/Motion", "automatic")
    return motion == "follow" or motion == "automatic" and run.scheme.moving_contact


def may_pass_ends(run):
    """Where contact is linearised nodes may come to an obstacle past its end and be inside."""
    sections = [f"Obstacles/{name}" for name in run.obstacles]
    return not follows(run) and any(
        run.setting(f"{section}/Shape") == "mesh" or run.setting(f"{section}/Extent")
        for section in sections
    )


def no_gain(run):
    """Contact, predictor and friction bring no energy, in no step."""
    name = "energy gained"
    lacking = needs(run, name, "work_contact")
    if lacking:
        return lacking
    if not run.scheme.inertia:
        return Verdict(name, NOT_JUDGED, "Load steps without inertia do not account for energy.")
    works = sum(column(run, f"work_{work}") for work in ("contact", "predictor", "friction"))
    scale = energy_scale(run)
    most, whole = part(works.max(), scale), part(works.sum(), scale)
    # A predictor in another mass than that of the step may bring energy.
    consistent = run.setting("Time/Predictor mass", "consistent") == "consistent"
    if run.scheme.energy != "none" and consistent and not may_pass_ends(run):
        text = "Contact, predictor and friction add at most {} of the energy in a step"
        verdict = by_limit(name, max(most, 0.0), limit(run, ENERGY), text)
        verdict.text += f" In the whole run they change it by {100 * whole:+.3g} %."
        return verdict
    state = LOOK if whole > 0.01 else NOT_JUDGED
    text = f"The scheme promises nothing here. Contact changed the energy by {100 * whole:+.3g} %"
    return Verdict(name, state, f"{text}, and by {100 * most:+.3g} % at most in one step.")


def force_from_outside(run, axis):
    """Of obstacles and supports on all bodies, in each row; None if a table is missing."""
    pairs, table = run.pairs(), run.tables.get("pairs", {})
    rigid = [k for k, (_, _, obstacle) in enumerate(pairs) if obstacle]
    steps = len(run.history["time"])
    if len(rigid) == len(pairs):
        force = column(run, f"contact_force_{axis}").copy()
    else:
        columns = [table.get(f"pair_{k}_force_{axis}") for k in rigid]
        if any(values is None or len(values) != steps for values in columns):
            return None
        force = sum(columns, numpy.zeros(steps))
    for name, values in run.tables.get("supports", {}).items():
        if name.startswith("support_") and name.endswith(f"_{axis}"):
            if len(values) != steps:
                return None
            force += values
    return force


def why_no_momentum(run):
    """What keeps the balance of momentum from being made of the tables, or nothing."""
    sections = [f"Bodies/{body}" for body in run.bodies]
    numbers = [
        entry
        for section in sections
        for key in ("Body force", "Damping")
        for entry in run.setting(f"{section}/{key}", "0").replace(",", ";").split(";")
    ]
    supported = any(run.setting(f"{section}/Dirichlet") for section in sections)
    if any(entry.strip() not in ("0", "0.", "0.0") for entry in numbers) or any(
        run.setting(f"{section}/Traction") for section in sections
    ):
        return "Loads and damping are in no table; `Output/Forces = true` writes this balance."
    if run.number("Output/History every", 1) != 1:
        return "Not every step has a row."
    if run.setting("Adaptivity/Indicator", "none") != "none":
        return "New meshes change the momentum by a little, too."
    if supported and "supports" not in run.tables:
        return "There are supports, but no supports.csv."
    return ""


def momentum(run):
    """The change of momentum is the impulse of what acts: of all bodies, and of each."""
    name = "momentum"
    lacking = needs(run, name, "momentum_x", "contact_force_x", "step_size")
    if lacking:
        return lacking
    if not run.scheme.one_force:
        return Verdict(name, NOT_JUDGED, "The scheme has no single contact force in a step.")
    if not column(run, "contact_force").any():
        return Verdict(name, NOT_JUDGED, "Nothing has touched.")
    found = [momentum_of_all(run, name)]
    if "forces" in run.tables:
        found.append(momentum_of_bodies(run, name))
    judged = [verdict for verdict in found if verdict.state != NOT_JUDGED] or found
    state = BROKEN if any(verdict.state == BROKEN for verdict in judged) else judged[0].state
    return Verdict(name, state, " ".join(verdict.text for verdict in judged))


def momentum_of_all(run, name):
    """By history.csv, pairs.csv and supports.csv."""
    reason = why_no_momentum(run)
    if reason:
        return Verdict(name, NOT_JUDGED, reason)
    steps, error = run.history["step_size"], 0.0
    scale = (steps * run.history["contact_force"]).sum()
    for axis in AXES:
        force, value = force_from_outside(run, axis), run.history[f"momentum_{axis}"]
        if force is None:
            return Verdict(name, NOT_JUDGED, "pairs.csv or supports.csv has other rows.")
        error = max(error, abs(numpy.diff(value) - (steps * force)[1:]).max())
        scale = max(scale, abs(value).max(), abs(steps * force).sum())
    text = "Forces leave at most {} of the momentum unexplained in a step"
    return by_limit(name, part(error, scale), limit(run, MOMENTUM), text)


def momentum_of_bodies(run, name):
    """By forces.csv: the nodal contact forces against the change of momentum of each body."""
    table, error, force = run.tables["forces"], 0.0, 0.0
    for column_name, values in table.items():
        if "_multiplier_" in column_name:
            other = table[column_name.replace("_multiplier_", "_momentum_")]
            error = max(error, abs(values - other).max())
            force = max(force, abs(values).max())
    scale = max(force, force_of_motion(run))
    text = "Contact force and change of momentum of a body differ by {} of the largest force"
    return by_limit(name, part(error, scale), limit(run, MOMENTUM), text)


def force_of_motion(run):
    """That takes the momentum of a body, or of all, in the longest step. The solver answers for a
    part of the motion: of forces that are smaller parts of this nothing is known."""
    momenta = [column(run, f"momentum_{axis}") for axis in AXES]
    for column_name, values in run.tables.get("bodies", {}).items():
        if "_momentum_" in column_name and "_angular_momentum_" not in column_name:
            momenta.append(values)
    longest = run.history["step_size"].max()
    return max(abs(values).max() for values in momenta) / longest if longest > 0.0 else 0.0


def penetration(run):
    """Gaps do not become negative."""
    name = "penetration"
    lacking = needs(run, name, "max_penetration")
    if lacking:
        return lacking
    size = run.size
    if not size:
        return Verdict(name, NOT_JUDGED, "Without fields the size of the bodies is not known.")
    depth = run.history["max_penetration"].max() / size
    true_depth = column(run, "geometric_penetration").max() / size
    beside = f" By the true geometry it is {true_depth:.2g}."
    clipped = follows(run) and any(not obstacle for _, _, obstacle in run.pairs())
    changing = run.setting("Adaptivity/Indicator", "none") != "none"
    if run.scheme.penetrates or may_pass_ends(run) or clipped or changing:
        state = LOOK if max(depth, true_depth) > DEEP else NOT_JUDGED
        text = f"The scheme, the mesh or the motion may penetrate: by {depth:.2g} of the size."
        return Verdict(name, state, text + beside)
    text = "Nodes penetrate by at most {} of the size"
    verdict = by_limit(name, depth, limit(run, PENETRATION), text)
    if verdict.state == KEPT and true_depth > DEEP:
        verdict.state = LOOK
    verdict.text += beside
    return verdict


def complementarity(run):
    """At every contact node that is observed: forces press, and only where the gap is closed."""
    name = "complementarity"
    probes = [table for table in run.probes.values() if {"gap", "normal_force"} <= set(table)]
    largest = max((abs(probe["normal_force"]).max() for probe in probes), default=0.0)
    if run.scheme is None or largest == 0.0:
        return Verdict(name, NOT_JUDGED, "No probe observes a contact node that carries a force.")
    pull = max(0.0, max(-probe["normal_force"].min() for probe in probes)) / largest
    verdict = by_limit(
        name, pull, limit(run, FORCE), "Observed nodes pull with at most {} of the largest force"
    )
    size = run.size
    # A scheme that penetrates has no such condition, and a node that a predictor stops may have
    # left at the end of the step.
    if run.scheme.penetrates or run.scheme.predictor or not size:
        return verdict
    gap = max(
        probe["gap"][probe["normal_force"] > NO_FORCE * largest].max(initial=0.0)
        for probe in probes
    )
    if gap / size > limit(run, PENETRATION):
        verdict.state = BROKEN
    verdict.text += f" Where a force acts gaps are at most {gap / size:.2g} of the size."
    return verdict


def guard(run):
    """What the program itself found while it ran."""
    name = "guard"
    if run.log.broken_laws:
        return Verdict(name, BROKEN, " ".join(run.log.broken_laws))
    if not run.log.program:
        return Verdict(name, NOT_JUDGED, "There is no log.txt.")
    action = run.setting("Output/Guard", "stop")
    text = f"The program watched the laws that the scheme proves in every step (`{action}`)"
    return Verdict(name, KEPT, f"{text} and found none broken.")
