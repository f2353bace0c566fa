# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Errors against a known contact force, and distances from a reference run: relative, L2 in time,
in per cent."""

import bisect
import math

from . import instants


def relative(pairs):
    """sqrt(sum (value - expected)^2 / sum expected^2) in per cent; equal steps need no weight."""
    pairs = list(pairs)
    size = sum(expected**2 for _, expected in pairs)
    return (
        100 * math.sqrt(sum((value - expected) ** 2 for value, expected in pairs) / size)
        if size > 0
        else math.nan
    )


def instants_of_force(result):
    """The instant to which the force of each step belongs."""
    share = instants.before_end(result.keys_of_time)
    return [time - share * step for time, step in zip(result["time"][1:], result["step_size"][1:])]


class Curve:
    """A column of a reference run over time, linear between its instants."""

    def __init__(self, times, values):
        self.times, self.values = times, values

    def __call__(self, time):
        """The value at a time, or beyond the ends that of the end."""
        n = min(max(bisect.bisect_left(self.times, time), 1), len(self.times) - 1)
        start, end = self.times[n - 1], self.times[n]
        part = min(max((time - start) / (end - start), 0.0), 1.0)
        return (1 - part) * self.values[n - 1] + part * self.values[n]


def force_error(result):
    """Of the contact force, from the known one."""
    if not result.exact_force:
        return math.nan
    return relative(
        (force, result.exact_force(time))
        for force, time in zip(result["contact_force"][1:], instants_of_force(result))
    )


def force_distance(result):
    """Of the contact force, from that of the reference at the same instants."""
    if not result.reference:
        return math.nan
    exact = result.reference
    share = instants.before_end(exact.keys_of_time) * exact["step_size"][-1]
    curve = Curve([time - share for time in exact["time"]], exact["contact_force"])
    return relative(
        (force, curve(time))
        for force, time in zip(result["contact_force"][1:], instants_of_force(result))
    )


def displacement_distance(result):
    """Of the normal displacements of all probes, from those of the reference."""
    if not result.reference:
        return math.nan
    return relative(
        pair
        for probe, exact in both(result)
        for pair in zip(
            probe["normal_displacement"],
            map(Curve(exact["time"], exact["normal_displacement"]), probe["time"]),
        )
    )


def velocity_distance(result):
    """Of the normal velocities of all probes, from those of the reference: differences of its
    displacements, over the same step for a scheme that reports means over the step, else over the
    neighbouring instants of the reference."""
    if not result.reference:
        return math.nan
    pairs, fine = [], result.reference["step_size"][-1]
    mean = instants.velocity_is_mean(result.keys_of_time)
    for probe, exact in both(result):
        curve, last = Curve(exact["time"], exact["normal_displacement"]), exact["time"][-1]
        for time, old, velocity in zip(
            probe["time"][1:], probe["time"], probe["normal_velocity"][1:]
        ):
            start, end = (old, time) if mean else (time - fine, min(time + fine, last))
            pairs.append((velocity, (curve(end) - curve(start)) / (end - start)))
    return relative(pairs)


def both(result):
    """The probes of the run and of its reference, side by side."""
    return [(probe, result.reference.probes[name]) for name, probe in result.probes.items()]
