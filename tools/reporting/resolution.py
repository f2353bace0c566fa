# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""How the run ended, and whether mesh and steps carry its contact."""

import numpy

from .verdict import BROKEN, KEPT, LOOK, NOT_JUDGED, Verdict

#: Of include/signorini/diagnostics/resolution.h: below these, size and duration are chance.
FEW_NODES = {2: 4, 3: 9}
FEW_STEPS = 8
#: Steps of a contact whose force and impulse can be trusted.
ENOUGH_STEPS = 20


def judge_resolution(run):
    """Verdicts in the order of the page."""
    return [end(run), nodes_in_contact(run), steps_in_contact(run)]


def end(run):
    """Whether the run came to its end."""
    if not run.history:
        return Verdict("end of the run", NOT_JUDGED, "There is no history.csv with rows.")
    time, wanted = run.history["time"][-1], run.number("Time/End time", numpy.nan)
    text = f"The last row is of the time {time:.6g}"
    if run.log.early_end:
        level = LOOK if run.log.interrupted else BROKEN
        return Verdict("end of the run", level, f"It ended early, {run.log.early_end}")
    if not run.log.program:
        return Verdict("end of the run", NOT_JUDGED, f"{text}; there is no log.txt.")
    if not run.log.complete:
        text += f" of {wanted:.6g}; log.txt has no summary: the run was killed, or goes on."
        return Verdict("end of the run", LOOK, text)
    return Verdict("end of the run", KEPT, f"Finished at the time {time:.6g}.")


def active(run):
    """The nodes that carry a force, and the force, in each row; None without the columns."""
    if not {"active_nodes", "contact_force"} <= set(run.history):
        return None
    return run.history["active_nodes"], run.history["contact_force"]


def nodes_in_contact(run):
    """At the largest force."""
    name, columns = "nodes in contact", active(run)
    if columns is None or columns[0].max() == 0:
        return Verdict(name, NOT_JUDGED, "Nothing has touched.")
    nodes, force = columns
    carried, few = int(nodes[numpy.argmax(force)]), FEW_NODES[run.dimension]
    text = f"{carried} {'node carries' if carried == 1 else 'nodes carry'} the largest force"
    # As the program judges: a flat face that touches as a whole may have few nodes.
    if carried < few and not 2 * carried >= contact_nodes(run):
        text += (
            f"; below {few} force and duration may be wrong by 30 %: refine the mesh where the "
            "bodies touch."
        )
        return Verdict(name, LOOK, text)
    return Verdict(name, KEPT, text + ".")


def contact_nodes(run):
    """All that there were at the start, by the log; infinite without."""
    found = [value for name, value in run.log.facts if name == "contact nodes"]
    return int(found[0]) if found and found[0].isdigit() else numpy.inf


def steps_in_contact(run):
    """Of the longest contact."""
    name, columns = "steps in contact", active(run)
    if columns is None or columns[0].max() == 0:
        return Verdict(name, NOT_JUDGED, "Nothing has touched.")
    if run.scheme is not None and not run.scheme.inertia:
        return Verdict(name, NOT_JUDGED, "Load steps are no steps in time.")
    closed = numpy.concatenate(([0], columns[0] > 0, [0])).astype(int)
    begins, ends = (numpy.flatnonzero(numpy.diff(closed) == sign) for sign in (1, -1))
    longest = int((ends - begins).max())
    every = int(run.number("Output/History every", 1)) or 1
    steps = int(min(longest * every, run.history["step"].max()))
    text = f"The longest contact has {steps} step{'s' if steps > 1 else ''}"
    if steps < FEW_STEPS and ends[-1] < len(columns[0]):
        return Verdict(name, LOOK, text + ". Force and impulse need some twenty: smaller steps.")
    if steps < ENOUGH_STEPS and ends[-1] < len(columns[0]):
        text += "; force and impulse are better with twenty"
    return Verdict(name, KEPT, text + ".")
