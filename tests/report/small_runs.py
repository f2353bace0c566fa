# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Short runs of shipped scenes for the tests of reports, and folders that are changed by hand."""

import csv
import pathlib
import shutil
import signal
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(SOURCE / "tools")]

#: The scene of each run, and what is changed in it.
RUNS = {
    "disc": ("disc_2d", ["Bodies/disc/Refinements=3", "Time/End time=0.3"]),
    "ball": (
        "quick_start",
        [
            "Bodies/ball/Refinements=1",
            "Time/End time=0.4",
            "Time/Step size=0.01",
            "Output/VTU every=1",
        ],
    ),
    "implicit": (
        "disc_2d",
        ["Bodies/disc/Refinements=2", "Time/End time=0.1", "Time/Scheme=contact-implicit"],
    ),
    "newmark": (
        "disc_2d",
        ["Bodies/disc/Refinements=2", "Time/End time=0.3", "Time/Scheme=newmark"],
    ),
    "static": ("verification/static_hertz", ["Time/End time=2"]),
    "adaptive": (
        "adaptive_ball",
        [
            "Bodies/ball/Refinements=1",
            "Adaptivity/Maximum level=3",
            "Adaptivity/Maximum cells=400",
            "Adaptivity/Distance=0.01",
            "Output/VTU every=2",
            "Time/End time=0.04",
        ],
    ),
    "roller": ("moving_contact/rolling_mill", ["Time/End time=0.6"]),
    "two_bodies": ("two_bars", ["Time/End time=0.3"]),
}


class Runs:
    """Runs of one executable below one folder."""

    def __init__(self, executable, folder):
        self.executable, self.folder = executable, pathlib.Path(folder)

    def run(self, name, *further, processes=1, fields=True):
        """The folder of a new run."""
        scene, overrides = RUNS[name]
        folder = self.folder / (name if processes == 1 else f"{name}_{processes}")
        shutil.rmtree(folder, ignore_errors=True)
        fields = f"Output/VTU={'true' if fields else 'false'}"
        command = self.command(scene, folder, *overrides, *further, fields)
        if processes > 1:
            command = ["mpirun", "--oversubscribe", "-np", str(processes), *command]
        subprocess.run([*command, "--quiet"], check=True, capture_output=True, timeout=300)
        return folder

    def interrupted(self, name, further_steps):
        """The folder of a run that SIGINT stopped, the command to go on with for some steps, and
        the time at which it ends then. The run is too long to end before the signal comes."""
        scene, overrides = RUNS[name]
        folder = self.folder / f"{name}_interrupted"
        shutil.rmtree(folder, ignore_errors=True)
        command = self.command(scene, folder, *overrides, "Time/End time=1000")
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
            while line := run.stdout.readline():
                if line.startswith(b"step "):
                    run.send_signal(signal.SIGINT)
                    break
            run.communicate(timeout=300)
        with open(folder / "history.csv", encoding="utf-8") as file:
            last = list(csv.DictReader(file))[-1]
        end = float(last["time"]) + further_steps * float(last["step_size"])
        go_on = self.command(scene, folder, *overrides, f"Time/End time={end!r}")
        return folder, [*go_on, "--resume"], end

    def command(self, scene, folder, *overrides):
        """A run of a shipped scene with changed keys."""
        words = [self.executable, SOURCE / "parameters" / f"{scene}.prm"]
        for override in (*overrides, f"Output directory={folder}"):
            words += ["--set", override]
        return [str(word) for word in words]

    def copy(self, folder, name):
        """A copy of a folder, to be spoilt."""
        target = self.folder / name
        shutil.rmtree(target, ignore_errors=True)
        shutil.copytree(folder, target)
        return target


def change_column(path, column, change):
    """Give the column of a table new values: change(row number, value)."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    place = rows[0].index(column)
    for number, row in enumerate(rows[1:]):
        row[place] = repr(change(number, float(row[place])))
    with open(path, "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(rows)
