# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The runs of studies, some at a time."""

import concurrent.futures
import dataclasses
import pathlib
import time

import signorini

from .definition import Study
from .observe import FURTHER_TABLES, Result

#: Next to the results of a run: the message with which it failed.
FAILURE = "failure.txt"


@dataclasses.dataclass
class Task:
    """One run to be done."""

    study: Study
    name: str
    settings: dict
    folder: pathlib.Path


def tasks(study, folder):
    """The runs of a study, each with a folder: named after its variant, else numbered."""
    fields = {} if study.pressure_time else {"Output/VTU": "false"}
    found = []
    for position, (variant, settings) in enumerate(study.runs()):
        alone = variant and not study.variations and len(study.sequence) == 1
        where = variant.folder if alone else str(position + 1)
        text = ", ".join(
            ([variant.name] if variant else [])
            + [f"{key} = {value}" for key, value in settings.items()]
        )
        everything = {**fields, **study.common, **settings, **(variant.settings if variant else {})}
        found.append(Task(study, text, everything, folder / where))
    return found


def clear(folder):
    """Take away what an earlier run left, so that nobody takes it for the result of this one."""
    remove(folder, "history.csv", *FURTHER_TABLES, "probe_*.csv", FAILURE)
    remove(folder, "*.pvd", "fields/*.vtu", "fields/*.pvtu")


def remove(folder, *patterns):
    """Delete files of a folder."""
    for pattern in patterns:
        for path in folder.glob(pattern):
            path.unlink()


def run(executable, task):
    """Do one run."""
    task.folder.mkdir(parents=True, exist_ok=True)
    clear(task.folder)
    try:
        signorini.start(
            task.study.scene,
            task.folder,
            task.settings,
            processes=task.study.processes,
            executable=executable,
        ).wait()
    except signorini.SignoriniError as error:
        return fail(task, str(error))
    remove(
        task.folder, "volume.pvd", "fields/volume_*"
    )  # large, and only the contact surface is drawn
    return read(task)


def fail(task, message):
    """The result of a failed run; the message stays in its folder."""
    (task.folder / FAILURE).write_text(message + "\n", encoding="utf-8")
    return Result(task.folder, message)


def read_all(all_tasks):
    """The results of runs that were done before."""
    return [read(task) for task in all_tasks]


def read(task):
    """The result of a run that was done before."""
    if (task.folder / FAILURE).exists():
        return Result(task.folder, (task.folder / FAILURE).read_text(encoding="utf-8").strip())
    result = Result(task.folder)
    try:
        if result.history:
            return result
    except (OSError, ValueError):
        pass
    return Result(task.folder, f"{task.folder / 'history.csv'}: no results. Run the study again.")


def run_all(executable, all_tasks, jobs=1):
    """The results, in the order of the tasks; says what happens."""
    count = len(all_tasks)

    def timed(numbered):
        position, task = numbered
        if jobs == 1:
            print(f"{position + 1} of {count}: {task.name}", flush=True)
        start = time.monotonic()
        result = run(executable, task)
        outcome = f"  failed: {result.failure}" if result.failure else ""
        if jobs > 1:
            print(
                f"{position + 1} of {count}: {task.study.title}, {task.name}:"
                f" {time.monotonic() - start:.0f} s",
                flush=True,
            )
        if outcome:
            print(outcome, flush=True)
        return result

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(timed, enumerate(all_tasks)))
