# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""How a run ended: finished, warned, refused or wrong."""

import dataclasses
import re

from studies import observe

from . import laws

FINISHED, WARNED, REFUSED, WRONG = "finished", "warned", "refused", "wrong"
#: Exit statuses of the program with a reason: a run that failed, a scene with a mistake.
STATUS_OF_REFUSAL = (1, 2)
#: The kinds of warnings by words in them.
KINDS = {
    "deep in": "deep",
    "degrees turned": "turned",
    "to and fro": "alternates",
    "displaced along each other": "slid",
    "no pair": "overlap",
    "not its partner": "overlap",
    "without an explanation": "ledger",
    "impulses of single nodes": "impulses",
    "carried": "few nodes",
    "contact brought": "contact brings energy",
    "damping of the scheme": "damping",
    "lasted": "few steps",
    "some twenty": "few steps",
    "contact took": "loss",
    "strain": "strained",
    "misses their true gaps": "missed gaps",
    "stay at the smallest size": "tolerance",
    "cells in its thickness": "thin",
    "suddenly": "sudden",
    "no node can come": "no contact",
}
#: Laws that the program may break if it says so by a warning of this kind.
EXCUSES = {"energy": "contact brings energy", "depth": "deep", "gap": "deep"}


@dataclasses.dataclass
class Verdict:
    """One line of the table."""

    outcome: str
    why: str  # reason of a refusal, kinds of warnings, or what is wrong
    laws: dict = dataclasses.field(default_factory=dict)  # what broke each law
    numbers: dict = dataclasses.field(default_factory=dict)  # of the table


class Judged(observe.Result):
    """A run as the laws see it."""

    def __init__(self, folder, scene, scheme, accuracy=laws.ACCURACY):
        super().__init__(folder)
        self.scene, self.scheme, self.accuracy = scene, scheme, accuracy


def kind(warning):
    """In two words."""
    return next((short for words, short in KINDS.items() if words in warning), warning)


def numbers(columns):
    """What the table says about a run besides the outcome."""
    iterations = columns["active_set_iterations"][1:]
    contact = columns["contact_force"]
    closed = [nodes > 0 for nodes in columns["active_nodes"]]
    return {
        "residual": laws.residual(columns),
        "energy": (columns["total_energy_modified"][-1] - columns["total_energy_modified"][0])
        / laws.energy_scale(columns),
        "depth": max(columns["max_penetration"]),
        "steps": int(columns["step"][-1]),
        "contacts": sum(b and not a for a, b in zip([False, *closed], closed)),
        "force": max(contact),
        "mean iterations": sum(iterations) / max(1, columns["step"][-1]),
        "most iterations": max(iterations, default=0),
        "most linear iterations": max(columns["linear_iterations"][1:], default=0),
        "fallbacks": sum(columns["fallbacks"]),
        "rejected": sum(columns["rejected_steps"]),
    }


def judge(ending, folder, scene, scheme):
    """The verdict about a run whose results are in the folder. What was written before a refusal
    obeys the laws, too."""
    run = Judged(folder, scene, scheme)
    written = (run.folder / "history.csv").exists() and run.columns
    refused = ending.status in STATUS_OF_REFUSAL and ending.reason()
    if ending.status != 0 and not refused:
        return Verdict(WRONG, broken_end(ending))
    if not written:
        return (
            Verdict(REFUSED, without_path(ending.reason()))
            if refused
            else Verdict(WRONG, "no table")
        )
    warnings = list(dict.fromkeys(map(kind, ending.warnings())))
    broken = laws.broken(run)
    silent = {law: text for law, text in broken.items() if EXCUSES.get(law) not in warnings}
    verdict = Verdict(FINISHED, "", broken)
    if "finite" not in broken:
        verdict.numbers = numbers(run.columns)
    if silent:
        verdict.outcome, verdict.why = WRONG, "; ".join(sum(silent.values(), []))
    elif refused:
        verdict.outcome, verdict.why = REFUSED, without_path(ending.reason())
    elif warnings:
        verdict.outcome, verdict.why = WARNED, ", ".join(warnings)
    return verdict


def without_path(reason):
    """The reason without the place of the scene, which begins it."""
    return re.sub(r"^(the run failed: )?\S*scene\.prm(, line \d+)?: ", "", reason)


def broken_end(ending):
    """In words, of an end that is no answer."""
    if ending.status is None:
        return ending.messages
    how = f"signal {-ending.status}" if ending.status < 0 else f"exit status {ending.status}"
    return f"{how}: {ending.reason() or ending.messages[-200:] or 'no message'}"
