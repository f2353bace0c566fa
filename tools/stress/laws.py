# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The laws of mechanics, asked of the tables of a run.

Each law yields what breaks it, in words. A run has columns (of all tables with the rows of the
history, by name), probes (columns of each probe of contact), scene, scheme (its entry in the table
of schemes) and accuracy (of the energy of a step, relative).
"""

import itertools
import math

#: Largest part of the energy of a step without an explanation.
ACCURACY = 1e-9
#: Largest part of the momentum of a step without an explanation: errors of forces add up in it.
MOMENTUM_ACCURACY = 1e-8
#: Largest depth, in sizes, where nothing may penetrate.
DEPTH = 1e-9
#: Forces that are smaller parts of the largest one are round-off.
NO_FORCE = 1e-7
#: By how much friction may differ from its law where a projection ends the step: its impulses
#: change normal forces after friction was found with them.
PROJECTED = 1e-3
AXES = "xyz"
#: What changes the energy besides the scheme.
CAUSES = ("work_external", "work_friction", "work_damping", "energy_transfer")


def energy_scale(columns):
    """The largest energy of the motion; one where nothing ever moves."""
    motion = map(sum, zip(columns["kinetic_energy_modified"], columns["elastic_energy"]))
    return max(motion) or 1.0


def part(some, whole):
    """As a part of the whole, which is nothing where there is nothing at all."""
    return 0.0 if some <= 0.0 else some / whole if whole > 0.0 else math.inf


def residual(columns):
    """The largest change of the energy that no column explains, over the largest energy."""
    return max(map(abs, columns["energy_residual"])) / energy_scale(columns)


def finite(run):
    """All values of all tables are numbers."""
    for name, values in all_columns(run):
        if not all(map(math.isfinite, values)):
            yield f"{name} is not finite"


def all_columns(run):
    """(name, values) of everything that was written."""
    yield from run.columns.items()
    for probe, columns in run.probes.items():
        for name, values in columns.items():
            yield f"{probe}: {name}", values


def ledger(run):
    """Every change of the energy has a cause."""
    found = residual(run.columns)
    if not found <= run.accuracy:
        yield f"{found:.2g} of the energy has no explanation"


def no_gain(run):
    """What a scheme adds to the energy beside loads, supports, friction, damping and changes of the
    mesh is not positive if it dissipates, and nothing if it conserves."""
    columns, scale = run.columns, energy_scale(run.columns)
    energy, causes = columns["total_energy_modified"], [columns[name] for name in CAUSES]
    own = [
        (energy[n] - energy[n - 1] - sum(cause[n] for cause in causes)) / scale
        for n in range(1, len(energy))
    ]
    gain, loss = max(own, default=0.0), -min(own, default=0.0)
    if run.scheme["energy"] != "none" and not gain <= run.accuracy:
        yield f"a scheme that never gains gains {gain:.2g} of the energy"
    if run.scheme["energy"] == "conserves" and not loss <= run.accuracy:
        yield f"a scheme that conserves loses {loss:.2g} of the energy"


def no_penetration(run):
    """Nothing penetrates, if the scheme promises so."""
    depth = max(run.columns["max_penetration"]) / run.scene.size
    if not run.scheme["penetrates"] and not depth <= DEPTH:
        yield f"penetration of {depth:.2g} of the size"
    if follows(run) and not run.scheme["penetrates"]:
        true_depth = max(run.columns["geometric_penetration"]) / run.scene.size
        if not true_depth <= DEPTH:
            yield f"true penetration of {true_depth:.2g} of the size"


def follows(run):
    """Whether contact follows the motion: the scene says so, or nothing forbids it."""
    motion = run.scene.settings.get("Contact/Motion", "automatic")
    can = (
        run.scheme.get("moving_contact")
        and run.scheme.get("massless_nodes") != "needed"
        and run.scene.settings.get("Time/Mass") != "redistributed"
    )
    return motion == "follow" or motion == "automatic" and can


def friction_takes(run):
    """Friction takes energy; schemes without a promise about it may get some from there."""
    work = max(run.columns["work_friction"]) / energy_scale(run.columns)
    if run.scheme["energy"] != "none" and not work <= run.accuracy:
        yield f"friction brings {work:.2g} of the energy"


def momentum(run):
    """The change of the momentum of each body is the impulse of what acts on it. This is the
    balance of those schemes that also promise something about the energy."""
    columns, steps = run.columns, run.columns["step_size"]
    if run.scheme["energy"] == "none" or not has_forces(run):
        return
    masses = {body: m for body in run.scene.bodies() if (m := mass(columns, body)) > 0}
    scale = math.sqrt(2 * sum(masses.values())) * math.sqrt(energy_scale(columns))
    for body, axis in itertools.product(masses, range(run.scene.settings["Dimension"])):
        force = forces(run, body, AXES[axis])
        weight = masses[body] * run.scene.acceleration(body)[axis]
        value = columns[f"body_{body}_momentum_{AXES[axis]}"]
        error = part(
            max(
                abs(value[n] - value[n - 1] - steps[n] * (force[n] + weight))
                for n in range(1, len(value))
            ),
            scale,
        )
        if not error <= MOMENTUM_ACCURACY:
            yield f"{error:.2g} of the momentum of '{body}' along {AXES[axis]} has no cause"


def has_forces(run):
    """Whether every step has a row in every table that the balance of momentum needs, and its mesh
    from the step before; a new one changes the momentum by a little."""
    disturbing = ("Output/Bodies", "Output/Pairs", "Output/History every", "Adaptivity/Indicator")
    return len(run.columns["step"]) > 1 and not any(k in run.scene.settings for k in disturbing)


def mass(columns, body):
    """Momentum over velocity, where the latter is largest; 0 of a body that never moves."""
    ratios = [
        (abs(velocity), momentum / velocity)
        for axis in AXES
        for velocity, momentum in zip(
            columns[f"body_{body}_velocity_{axis}"], columns[f"body_{body}_momentum_{axis}"]
        )
        if velocity != 0.0
    ]
    return max(ratios, default=(0.0, 0.0))[1]


def forces(run, body, axis):
    """The sum of the forces of contact and supports on a body, in each row."""
    total = [0.0] * len(run.columns["step"])
    signed = [
        (f"pair_{k}_force_{axis}", sign)
        for k, (_, slave, master) in enumerate(run.scene.pairs())
        for side, sign in ((slave, 1), (master, -1))
        if side == body
    ]
    supports = [name for name in run.columns if name.startswith(f"support_{body}_")]
    signed += [(name, 1) for name in supports if name.endswith(axis)]
    for name, sign in signed:
        total = [a + sign * b for a, b in zip(total, run.columns[name])]
    return total


def largest_force(run):
    """Of one node."""
    return max((max(map(abs, p["normal_force"])) for p in run.probes.values()), default=0.0)


def no_adhesion(run):
    """Contact pushes, at every node that is observed."""
    pull = -min((min(p["normal_force"]) for p in run.probes.values()), default=0.0)
    pull = part(pull, largest_force(run))
    if not pull <= NO_FORCE:
        yield f"a node pulls with {pull:.2g} of the largest force"


def no_distant_force(run):
    """Where a force acts the gap is closed at the end of the step, unless the scheme penetrates. A
    predictor has a condition of its own: a node that it stops may have left at the end."""
    if run.scheme["penetrates"] or run.scheme["predictor"]:
        return
    least = NO_FORCE * largest_force(run)
    gap = max(
        (
            gap
            for p in run.probes.values()
            for gap, force in list(zip(p["gap"], p["normal_force"]))[1:]
            if force > least
        ),
        default=0.0,
    )
    if not gap <= DEPTH * run.scene.size:
        yield f"a force over a gap of {gap / run.scene.size:.2g} of the size"


def coulomb(run):
    """Friction stays within the coefficient times the normal force, at every observed node."""
    name = run.scene.pairs()[0][0]
    coefficient = run.scene.number(f"Contact/{name}/Friction coefficient")
    excess = max(
        (
            math.hypot(*tangential) - coefficient * normal
            for p in run.probes.values()
            if "tangential_force_x" in p
            for normal, *tangential in zip(
                p["normal_force"], *(p[f"tangential_force_{axis}"] for axis in AXES)
            )
        ),
        default=0.0,
    )
    excess = part(excess, largest_force(run))
    if not excess <= (PROJECTED if run.scheme["predictor"] else NO_FORCE) * max(1.0, coefficient):
        yield f"friction beyond its law by {excess:.2g} of the largest force"


#: The laws by the names of their columns.
LAWS = {
    "ledger": ledger,
    "energy": no_gain,
    "momentum": momentum,
    "depth": no_penetration,
    "adhesion": no_adhesion,
    "gap": no_distant_force,
    "coulomb": coulomb,
    "friction": friction_takes,
}


def broken(run):
    """What was broken, by the name of the law; values that are not finite break all of them."""
    missing = list(finite(run))
    if missing:
        return {"finite": missing}
    return {name: found for name, law in LAWS.items() if (found := list(law(run)))}
