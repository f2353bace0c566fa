# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What can be observed of a run: one number from its history, or from its first probe."""

import dataclasses
import functools
import math
import pathlib
import typing

import signorini
from signorini.tables import read_columns

from . import distances

#: Relative energies below this, in per cent, are round-off.
ROUND_OFF = 1e-8
#: Beside the history, with rows for the same steps.
FURTHER_TABLES = ("supports.csv", "pairs.csv", "bodies.csv")
#: Forces below this part of the largest one are round-off.
NO_FORCE = 1e-9


class Result:
    """A run: its tables, or the message with which it failed. A failed one is false."""

    def __init__(self, folder, failure=""):
        self.folder, self.failure = pathlib.Path(folder), failure
        self.reference = None  # another Result, to which this one is compared
        self.exact_force = None  # the contact force as a function of time

    def __bool__(self):
        return not self.failure

    @functools.cached_property
    def history(self):
        return read_columns(self.folder / "history.csv")

    @functools.cached_property
    def columns(self):
        """All columns of the tables that have the rows of the history."""
        tables = [
            read_columns(path)
            for name in FURTHER_TABLES
            for path in [self.folder / name]
            if path.exists()
        ]
        return {name: column for table in [*tables, self.history] for name, column in table.items()}

    @functools.cached_property
    def probes(self):
        """All probes of contact by name."""
        probes = {path.stem: read_columns(path) for path in sorted(self.folder.glob("probe_*.csv"))}
        return {name: columns for name, columns in probes.items() if "gap" in columns}

    @property
    def probe(self):
        """The first probe of contact by name, or {}."""
        return next(iter(self.probes.values()), {})

    @functools.cached_property
    def keys_of_time(self):
        """The keys of the section Time, with defaults."""
        return signorini.Result(self.folder).parameters["Time"]

    def __getitem__(self, column):
        return self.history[column]


def during_contact(result):
    """The force from the first to the last step with contact."""
    force = result["contact_force"]
    rows = between(force)
    return force[rows[0] : rows[1] + 1] if rows else [0.0]


def between(force):
    """First and last row with a force that is not round-off, or None."""
    rows = [row for row, value in enumerate(force) if value > NO_FORCE * max(force)]
    return (rows[0], rows[-1]) if rows else None


def roughness(values):
    """Mean absolute second difference over the mean: 0 for a smooth curve, above 1 for zigzag."""
    mean = sum(values) / len(values)
    second = [abs(a - 2 * b + c) for a, b, c in zip(values, values[1:], values[2:])]
    return sum(second) / len(second) / mean if second and mean > 0 else 0.0


def zigzag(values):
    """The part of all changes that the next step takes back: 0 for humps that many steps resolve, 1
    for a zigzag."""
    changes = [b - a for a, b in zip(values, values[1:])]
    back = sum(min(abs(a), abs(b)) for a, b in zip(changes, changes[1:]) if a * b < 0)
    everything = sum(map(abs, changes))
    return back / everything if everything > 0 else 0.0


def energy_change(result, choose, column="total_energy"):
    """In per cent of the initial energy, or of the largest one for a run that starts at rest."""
    energy = result[column]
    motion = max(map(sum, zip(result["kinetic_energy_modified"], result["elastic_energy"])))
    scale = abs(energy[0]) if abs(energy[0]) > 1e-3 * motion else motion
    change = 100 * (choose(energy) - energy[0]) / (scale or 1.0)
    return change if abs(change) > ROUND_OFF else 0.0


def energy_drift(result, column="total_energy"):
    """The largest deviation from the initial energy, in per cent."""
    return max(abs(energy_change(result, choose, column)) for choose in (min, max))


def passes(result, change):
    """The first time at which the energy is changed by so many per cent or more, None if never."""
    if not result:
        return None
    start = result["total_energy"][0]
    return next(
        (
            time
            for time, energy in zip(result["time"], result["total_energy"])
            if 100 * (energy - start) >= change * abs(start)
        ),
        None,
    )


def loss_before_peak(result):
    """How much of the final change of energy happened before the largest force, in per cent."""
    energy, force = result["total_energy"], result["contact_force"]
    whole = energy[-1] - energy[0]
    if abs(whole) <= ROUND_OFF * abs(energy[0]):
        return math.nan
    return 100 * (energy[force.index(max(force))] - energy[0]) / whole


def touching(result):
    """First and last row of the probe with pressure, or None."""
    return between(result.probe.get("pressure", ()))


def velocities(result, when):
    """Relative normal velocities of the probe, positive when it moves away: in "contact" after the
    step that closed it, "after" contact, or "both"; [] without contact."""
    rows = touching(result)
    if not rows:
        return []
    first, last = rows
    part = {
        "contact": slice(first + 1, last + 1),
        "after": slice(last + 1, None),
        "both": slice(first, None),
    }[when]
    return [-velocity for velocity in result.probe["normal_velocity"][part]]


def extreme(values, choose):
    """Of values that may be missing."""
    return choose(values) if values else math.nan


def approach(result):
    """Speed with which the probe closes its gap at the start."""
    return result.probe["normal_velocity"][0] if result.probe else math.nan


def velocity_in_contact(result):
    """Largest relative normal speed during contact, in units of the speed of approach."""
    speed = approach(result)
    return (
        extreme([abs(velocity) / speed for velocity in velocities(result, "contact")], max)
        if speed
        else math.nan
    )


def velocity_zigzag(result):
    """Amplitude of the zigzag of the velocity in contact, in units of the speed of approach."""
    values, speed = velocities(result, "contact"), approach(result)
    seconds = [abs(a - 2 * b + c) / 4 for a, b, c in zip(values, values[1:], values[2:])]
    return sum(seconds) / len(seconds) / speed if seconds and speed else math.nan


def penetration_in_steps(result):
    """Penetration in units of what the probe moves in one step on approach."""
    way = approach(result) * result["step_size"][-1]
    depth = max(result["max_penetration"]) / way if way > 0 else math.nan
    return 0.0 if depth < 1e-6 else depth


@dataclasses.dataclass
class Observation:
    """A heading, and the number that stands below it."""

    heading: str
    measure: typing.Callable

    def __call__(self, result):
        """nan where the run failed or has not what is needed."""
        try:
            return self.measure(result) if result else math.nan
        except (KeyError, OSError):
            return math.nan


OWN = "total_energy_modified"
OBSERVATIONS = {
    name: Observation(*rest)
    for name, rest in {
        "energy_change": ("energy at the end, %", lambda r: energy_change(r, lambda e: e[-1])),
        "energy_least": ("least energy, %", lambda r: energy_change(r, min)),
        "energy_most": ("largest energy, %", lambda r: energy_change(r, max)),
        "energy_drift": ("energy drift, %", energy_drift),
        "own_energy_change": (
            "own energy at the end, %",
            lambda r: energy_change(r, lambda e: e[-1], OWN),
        ),
        "own_energy_least": ("least own energy, %", lambda r: energy_change(r, min, OWN)),
        "own_energy_most": ("largest own energy, %", lambda r: energy_change(r, max, OWN)),
        "own_energy_drift": ("own energy drift, %", lambda r: energy_drift(r, OWN)),
        "loss_before_peak": ("of it before the largest force, %", loss_before_peak),
        "force_largest": ("largest force", lambda r: max(r["contact_force"])),
        "force_roughness": ("roughness of the force", lambda r: roughness(during_contact(r))),
        "force_zigzag": ("zigzag of the force", lambda r: zigzag([0.0, *during_contact(r), 0.0])),
        "impulse": (
            "impulse",
            lambda r: sum(f * s for f, s in zip(r["contact_force"], r["step_size"])),
        ),
        "penetration": (
            "penetration",
            lambda r: 0.0 if penetration_in_steps(r) == 0.0 else max(r["max_penetration"]),
        ),
        "penetration_in_steps": ("penetration, steps", penetration_in_steps),
        "velocity_in_contact": ("speed in contact / approach", velocity_in_contact),
        "velocity_zigzag": ("zigzag of the velocity / approach", velocity_zigzag),
        "velocity_after_least": (
            "least velocity after release",
            lambda r: extreme(velocities(r, "after"), min),
        ),
        "velocity_after_most": (
            "largest velocity after release",
            lambda r: extreme(velocities(r, "after"), max),
        ),
        "velocity_least": (
            "least velocity from contact on",
            lambda r: extreme(velocities(r, "both"), min),
        ),
        "velocity_most": (
            "largest velocity from contact on",
            lambda r: extreme(velocities(r, "both"), max),
        ),
        "displacement_error": ("e_u, %", lambda r: 100 * r["relative_displacement_error"][-1]),
        "velocity_error": ("e_v, %", lambda r: 100 * r["relative_velocity_error"][-1]),
        "force_error": ("e_r, %", distances.force_error),
        "force_distance": ("distance of the force, %", distances.force_distance),
        "displacement_distance": (
            "distance of the displacement, %",
            distances.displacement_distance,
        ),
        "velocity_distance": ("distance of the velocity, %", distances.velocity_distance),
        "linear_iterations": (
            "iterations per step",
            lambda r: sum(r["linear_iterations"]) / max(1, len(r["step"]) - 1),
        ),
        "seconds": ("seconds", lambda r: r["wall_time"][-1]),
    }.items()
}
#: Errors, and distances from a reference, get a rate.
DISTANCES = ("force_distance", "displacement_distance", "velocity_distance")
ERRORS = ("displacement_error", "velocity_error", "force_error", *DISTANCES)
