# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What the study of adaptive runs measures: errors of curves over time, whatever the steps, sizes,
and what a uniform mesh would need for the same error."""

import math
import re

import numpy

from . import instants
from .case import seconds, text
from .observe import during_contact, roughness

#: Curves are compared at so many equidistant times: many more than any run here has steps in
#: contact.
SAMPLES = 20001
#: Sections of the timer table in log.txt, and what they are called here.
SECTIONS = {
    "first step on a mesh": "steps",
    "later steps on a mesh": "steps",
    "mesh: indicator and marking": "indicator",
    "mesh: all of a change": "changes",
    "diagnostics and tables": "diagnostics",
}


def force_curve(result, times, force="contact_force"):
    """A force of the history, linear between the instants to which the forces of the steps
    belong."""
    share = instants.before_end(result.keys_of_time)
    ends, sizes = numpy.array(result["time"]), numpy.array(result["step_size"])
    return numpy.interp(times, ends - share * sizes, result[force])


def pressure_curve(result, times):
    """The contact pressure of the first probe; it belongs to the same instants as the force."""
    share = instants.before_end(result.keys_of_time)
    rows = dict(zip(result["time"], result["step_size"]))
    ends = numpy.array(result.probe["time"])
    sizes = numpy.array([rows.get(time, 0.0) for time in result.probe["time"]])
    return numpy.interp(times, ends - share * sizes, result.probe["pressure"])


def energy_curve(column):
    """An energy as a function of time, linear between the ends of steps."""
    return lambda result, times: numpy.interp(times, result["time"], result[column])


def distance(values, exact):
    """Relative, L2 in time, in per cent."""
    size = numpy.linalg.norm(exact)
    return 100 * float(numpy.linalg.norm(values - exact) / size) if size > 0 else math.nan


def energy_norm(result, reference, times):
    """Of the velocity from the known motion where the scene has one, else of the elastic energy
    from that of the reference."""
    if "relative_displacement_error" in result.history:
        return 100 * result["relative_velocity_error"][-1]
    curve = energy_curve("elastic_energy")
    return distance(curve(result, times), curve(reference, times))


def exact_force(result, reference, times):
    """The known force of the study, else that of the reference."""
    return (
        numpy.array([result.exact_force(time) for time in times])
        if result.exact_force
        else force_curve(reference, times)
    )


def pressure_error(result, reference, times):
    """Unknown without a reference run."""
    return (
        distance(pressure_curve(result, times), pressure_curve(reference, times))
        if reference
        else math.nan
    )


def estimated(result, what):
    """What a mesh that is made for a force or a stress says of it at the end, in per cent; infinite
    if that is more than the whole."""
    log = (result.folder / "log.txt").read_text(encoding="utf-8")
    if re.search(rf"error of {what} +more than 100 %", log):
        return math.inf
    found = re.search(rf"error of {what} +about (\S+) %", log)
    return float(found[1]) if found else math.nan


def said(estimate):
    """An estimate as the run says it."""
    return "> 100" if math.isinf(estimate) else text(estimate)


def measure(result, reference):
    """All numbers of a run by name; nan if it failed. reference: None if the solution is known."""
    if not result:
        return {name: math.nan for name in HEADINGS}
    times = numpy.linspace(0.0, result["time"][-1], SAMPLES)
    dofs = result["dofs"][1:]
    known = "relative_displacement_error" in result.history
    return {
        "dofs": sum(dofs) / len(dofs),
        "largest_dofs": max(dofs),
        "steps": len(dofs),
        "seconds": seconds(result),
        "wall_time": result["wall_time"][-1],
        "force": distance(force_curve(result, times), exact_force(result, reference, times)),
        "estimate": estimated(result, "force"),
        "stress_estimate": estimated(result, "stress"),
        "pressure": pressure_error(result, reference, times),
        "energy": energy_norm(result, reference, times),
        "displacement": 100 * result["relative_displacement_error"][-1] if known else math.nan,
        "roughness": roughness(during_contact(result)),
        "changes": changes(result),
    }


HEADINGS = {
    "dofs": "dofs (mean)",
    "largest_dofs": "dofs (largest)",
    "steps": "steps",
    "seconds": "processor s",
    "wall_time": "wall s",
    "force": "force, %",
    "estimate": "estimate of force, %",
    "stress_estimate": "estimate of pressure, %",
    "pressure": "pressure, %",
    "energy": "energy norm, %",
    "displacement": "displacement, %",
    "roughness": "roughness of the force",
    "changes": "changes of the mesh",
}
ERRORS = ("force", "pressure", "energy", "displacement")


def changes(result):
    """How often the number of cells changed: at least so often the mesh did."""
    return sum(a != b for a, b in zip(result["cells"], result["cells"][1:]))


def needed(error, uniform, cost, name):
    """The cost (dofs or seconds) for which uniform meshes have this error: from the curve through
    them, linear in logarithms; nan beyond its ends, where nothing is known."""
    points = sorted((numbers[name], numbers[cost]) for numbers in uniform if numbers[name] > 0)
    if len(points) < 2 or not points[0][0] <= error <= points[-1][0]:
        return math.nan
    errors, costs = numpy.log(points).T
    return math.exp(numpy.interp(math.log(error), errors, costs))


def gain(numbers, uniform, cost, name):
    """How many times cheaper than a uniform mesh of the same error."""
    return needed(numbers[name], uniform, cost, name) / numbers[cost]


def where_the_time_went(result):
    """Parts of the run time, in per cent, from the timer table of log.txt: steps, indicator,
    changes of the mesh, diagnostics, the rest."""
    text = (result.folder / "log.txt").read_text(encoding="utf-8")
    total = re.search(r"Total wallclock time elapsed\s*\|\s*([\d.e+-]+)s", text)
    parts = dict.fromkeys((*SECTIONS.values(), "rest"), 0.0)
    for name, used in re.findall(r"^\| (.+?)\s*\|\s*\d+ \|\s*([\d.e+-]+)s", text, re.MULTILINE):
        if name in SECTIONS:
            parts[SECTIONS[name]] += 100 * float(used) / float(total.group(1))
    parts["rest"] = 100 - sum(parts.values())
    return parts
