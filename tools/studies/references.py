# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The reference runs of a study: one for all runs that differ only in scheme and step size."""

import re

from .mistake import Mistake
from .runs import Task

STEP = "Time/Step size"
#: Keys of the section Time that belong to the problem, and not to the scheme. (Those of [scene]
#: hold for the reference, too.)
PROBLEM = ("Time/End time", "Time/Mass", "Time/Mass redistribution")


def problem_of(task):
    """The settings of a run that its reference takes over, with those of [reference]."""
    common = {key: value for key, value in task.study.common.items() if key != STEP}
    kept = {
        key: value
        for key, value in task.settings.items()
        if not key.startswith("Time/") or key in PROBLEM
    }
    return {**common, **kept, **task.study.reference}


def step_size(task):
    """The step size of a run: from its settings, else from the scene."""
    found = re.search(
        r"^\s*set\s+Step size\s*=\s*([^#\s]+)",
        task.study.scene.read_text(encoding="utf-8"),
        re.MULTILINE,
    )
    text = task.settings.get(STEP, found and found.group(1))
    try:
        step = float(text)
    except (TypeError, ValueError):
        step = 0.0
    if step <= 0:
        raise Mistake(
            f"{task.study.path}: [reference] needs the step size of each run, and `{STEP} = {text}`"
            f" is none. Give `{STEP}` in [scene] or [together]."
        )
    return step


def check_steps(study, fine, text, steps):
    """The steps of runs are whole multiples of that of the reference."""
    off = [
        step
        for step in steps
        if round(step / fine) < 1 or abs(step / fine - round(step / fine)) > 1e-6
    ]
    if off and STEP in study.reference:
        raise Mistake(
            f"{study.path}: [reference] {STEP} = {text}: the step size {off[0]:g} of a run is no"
            f" whole multiple of it. Take {off[0]:g} divided by a whole number."
        )
    if off:
        raise Mistake(
            f"{study.path}: [reference] takes the smallest step size of the runs, {text}, and the"
            f" step size {off[0]:g} is no whole multiple of it. Give `{STEP}` in [reference], a"
            " number that divides all of them."
        )


def plan(study, tasks, folder):
    """(reference runs, for each task the number of its own); ([], []) without [reference]."""
    if not study.reference:
        return [], []
    groups = {}
    for number, task in enumerate(tasks):
        groups.setdefault(tuple(sorted(problem_of(task).items())), []).append(number)
    found, belongs = [], [0] * len(tasks)
    for problem, numbers in groups.items():
        settings = dict(problem)
        steps = {step_size(tasks[number]) for number in numbers}
        text = settings.setdefault(STEP, f"{min(steps):.12g}")
        reference = Task(
            study,
            f"reference {len(found) + 1}",
            settings,
            folder / "reference" / str(len(found) + 1),
        )
        check_steps(study, step_size(reference), text, sorted(steps))
        for number in numbers:
            belongs[number] = len(found)
        found.append(reference)
    return found, belongs
