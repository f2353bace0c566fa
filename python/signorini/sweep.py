# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Many runs of a scene with other values, and one frame of what came out."""

import concurrent.futures
import hashlib
import itertools
import pathlib
import re
import threading

from .errors import SignoriniError
from .run import run


def combinations(variations):
    """The settings of each run: of a dictionary of lists all combinations, of a list its
    entries."""
    if isinstance(variations, dict):
        return [dict(zip(variations, row)) for row in itertools.product(*variations.values())]
    return [dict(settings) for settings in variations]


def folder_names(all_settings):
    """Of each run by what it changes, so that a longer sweep finds the runs of a shorter one."""
    texts = ["_".join(f"{k.split('/')[-1]}={v}" for k, v in row.items()) for row in all_settings]
    names = [re.sub(r"[^A-Za-z0-9.=_+-]+", "-", text) for text in texts]
    return [
        (
            f"{name[:60]}-{hashlib.sha256(repr(row).encode()).hexdigest()[:10]}"
            if len(name) > 80 or names.count(name) > 1
            else name or "scene"
        )
        for name, row in zip(names, all_settings)
    ]


class Sweep:
    """Runs of a scene, each with settings of its own.

    scene: as for signorini.run(). variations: {"Time/Step size": [4e-3, 2e-3], ...}, of which all
    combinations are run, or a list of settings, [{"Time/Step size": 4e-3}, ...].
    folder: each run gets a folder in it, named by its settings.
    """

    def __init__(self, scene, variations, folder):
        self.scene = scene
        self.settings = combinations(variations)
        names = folder_names(self.settings)
        if len(set(names)) < len(names):
            raise ValueError("two runs of the sweep have the same settings. Remove one of them.")
        self.folders = [pathlib.Path(folder) / name for name in names]
        #: A Result, the SignoriniError of a run that failed, or None for one that is not done.
        self.outcomes = [None] * len(names)

    def run(self, jobs=1, *, processes=1, executable=None, on_end=None):
        """Do the runs, so many at a time, and return the sweep. Runs that were finished before, of
        the same scene, mesh files and program, are not done again. A failed run stops no other; its
        error is in outcomes. Ctrl-C ends all of them after their steps.

        on_end: called with the settings and the outcome of each run as it ends.
        """
        stop = threading.Event()

        def one(position):
            if stop.is_set():
                return

            try:
                outcome = run(
                    self.scene,
                    self.folders[position],
                    self.settings[position],
                    processes=processes,
                    executable=executable,
                    stop=stop,
                    reuse=True,
                )
            except SignoriniError as error:
                outcome = error
            self.outcomes[position] = outcome
            if on_end is not None:
                on_end(self.settings[position], outcome)

        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            futures = [pool.submit(one, position) for position in range(len(self.folders))]
            try:
                for future in futures:
                    future.result()
            except BaseException:
                stop.set()
                raise
        return self

    def frame(self, **measures):
        """One row per run, as a pandas frame: its settings, folder, failure ("" if there is none),
        and each measure, a function of the Result: frame(force=lambda r:
        r.history.contact_force.max()). Without measures: the last row of the history."""
        import pandas  # pylint: disable=import-outside-toplevel

        rows = []
        for settings, folder, outcome in zip(self.settings, self.folders, self.outcomes):
            failed = isinstance(outcome, SignoriniError)
            failure = str(outcome) if failed else "" if outcome else "was not run"
            row = {**settings, "folder": str(folder), "failure": failure}
            if not failure:
                values = {name: measure(outcome) for name, measure in measures.items()}
                row.update(values if measures else outcome.history.iloc[-1].to_dict())
            rows.append(row)
        return pandas.DataFrame(rows)

    def histories(self):
        """The histories of all runs below each other, as a pandas frame, with the settings of each
        run as further columns."""
        import pandas  # pylint: disable=import-outside-toplevel

        done = [pair for pair in zip(self.settings, self.outcomes) if hasattr(pair[1], "history")]
        return pandas.concat(
            [outcome.history.assign(**settings) for settings, outcome in done], ignore_index=True
        )
