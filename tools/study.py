#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Runs variations of a scene and compares them: study.py EXECUTABLE STUDY.ini [FOLDER]

A study is a file with a section [study] (scene, relative to the file; observe, the columns of the table, all if not given; processes), a section
[variations] with keys of the scene and their values, separated by semicolons, of which all combinations are run, and perhaps a
section [together] with keys that change together, value by value. Results of each run go to FOLDER/<number> (default:
output/<name of the study>), the table to FOLDER/table.csv and FOLDER/table.md. With [together] the table shows, behind each error, the
rate log2(error before / error).
"""

import configparser
import csv
import itertools
import math
import os
import pathlib
import subprocess
import sys


def read_history(path):
    """The columns of history.csv by name."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def roughness(values):
    """Mean absolute second difference over the mean: 0 for a smooth curve, above 1 for zigzag."""
    mean = sum(values) / len(values)
    second = [abs(a - 2 * b + c) for a, b, c in zip(values, values[1:], values[2:])]
    return sum(second) / len(second) / mean if second and mean > 0 else 0.


def during_contact(history):
    force = history["contact_force"]
    touching = [i for i, value in enumerate(force) if value > 0]
    return force[touching[0]:touching[-1] + 1] if touching else [0.]


def relative_energy(history, choose):
    energy = history["total_energy"]
    scale = abs(energy[0]) or 1.
    return 100 * (choose(energy) - energy[0]) / scale


#: What can be observed: heading, and the number from the columns of history.csv.
OBSERVATIONS = {
    "energy_change": ("energy at the end, %", lambda h: relative_energy(h, lambda e: e[-1])),
    "energy_least": ("least energy, %", lambda h: relative_energy(h, min)),
    "energy_most": ("largest energy, %", lambda h: relative_energy(h, max)),
    "force_largest": ("largest force", lambda h: max(h["contact_force"])),
    "force_roughness": ("roughness of the force", lambda h: roughness(during_contact(h))),
    "impulse": ("impulse", lambda h: sum(f * s for f, s in zip(h["contact_force"], h["step_size"]))),
    "penetration": ("penetration", lambda h: max(h["max_penetration"])),
    "displacement_error": ("e_u, %", lambda h: 100 * h["relative_displacement_error"][-1]),
    "velocity_error": ("e_v, %", lambda h: 100 * h["relative_velocity_error"][-1]),
    "linear_iterations": ("iterations per step", lambda h: sum(h["linear_iterations"]) / max(1, len(h["step"]) - 1)),
    "seconds": ("seconds", lambda h: h["wall_time"][-1]),
}
#: Errors get a rate.
ERRORS = ("displacement_error", "velocity_error")


def fail(message):
    sys.exit(f"study.py: {message}")


class Study:
    """What a study file says."""

    def __init__(self, path):
        parser = configparser.ConfigParser(delimiters=("=",), inline_comment_prefixes=None, interpolation=None)
        parser.optionxform = str  # keys of scenes have capitals
        try:
            with open(path, encoding="utf-8") as file:
                parser.read_file(file)
        except (OSError, configparser.Error) as error:
            fail(f"{path}: cannot be read: {error}")
        for section in parser.sections():
            if section not in ("study", "variations", "together"):
                fail(f"{path}: unknown section [{section}]. Valid: [study], [variations], [together].")
        if not parser.has_option("study", "scene"):
            fail(f"{path}: [study] needs `scene = ...`, the scene to vary.")
        self.name = path.stem
        self.scene = (path.parent / parser["study"]["scene"]).resolve()
        if not self.scene.is_file():
            fail(f"{path}: scene = {parser['study']['scene']}: there is no file {self.scene}.")
        self.processes = parser.getint("study", "processes", fallback=1)
        self.observe = [name.strip() for name in parser.get("study", "observe", fallback="").split(",") if name.strip()]
        for name in self.observe:
            if name not in OBSERVATIONS:
                fail(f"{path}: observe = {name} is not known. Valid: {', '.join(OBSERVATIONS)}.")

        def values(section):
            return {key: [value.strip() for value in text.split(";")] for key, text in
                    (parser.items(section) if parser.has_section(section) else ())}

        self.variations, together = values("variations"), values("together")
        if len({len(column) for column in together.values()}) > 1:
            fail(f"{path}: the keys in [together] need the same number of values.")
        self.sequence = [dict(zip(together, row)) for row in zip(*together.values())] or [{}]
        if not self.variations and not together:
            fail(f"{path}: nothing varies. Give [variations] or [together].")

    def runs(self):
        """Settings of each run; those of [together] are neighbours."""
        for combination in itertools.product(*self.variations.values()):
            for row in self.sequence:
                yield {**dict(zip(self.variations, combination)), **row}


def run(executable, study, settings, folder):
    """The history of one run, or the message with which it failed."""
    command = [] if study.processes == 1 else ["mpirun", "--oversubscribe", "-np", str(study.processes)]
    command += [executable, str(study.scene), "--quiet"]
    for key, value in {"Output directory": folder, "Output/VTU": "false", **settings}.items():
        command += ["--set", f"{key}={value}"]
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    result = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    if result.returncode != 0:
        return None, result.stderr.strip().splitlines()[0] if result.stderr.strip() else f"exit status {result.returncode}"
    return read_history(folder / "history.csv"), ""


def number(value):
    return f"{value:.4g}"


def table(study, results):
    """Rows of texts, the first one with the headings."""
    known = next((history for history in results if history), None)
    names = [name for name in study.observe or OBSERVATIONS
             if name not in ERRORS or (known and "relative_displacement_error" in known)]
    rates = len(study.sequence) > 1
    heading = [key.split("/")[-1] for key in [*study.variations, *study.sequence[0]]]
    for name in names:
        heading += [OBSERVATIONS[name][0]] + (["rate"] if rates and name in ERRORS else [])
    rows = [heading]
    before = None
    for position, (settings, history) in enumerate(zip(study.runs(), results)):
        row = list(settings.values())
        for name in names:
            value = OBSERVATIONS[name][1](history) if history else math.nan
            row.append(number(value))
            if rates and name in ERRORS:
                old = OBSERVATIONS[name][1](before) if before and position % len(study.sequence) else math.nan
                row.append(f"{math.log2(old / value):.2f}" if old > 0 and value > 0 else "")
        before = history
        rows.append(row)
    return rows


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    study = Study(pathlib.Path(sys.argv[2]))
    folder = pathlib.Path(sys.argv[3] if len(sys.argv) == 4 else f"output/{study.name}").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    all_settings = list(study.runs())
    results, failures = [], []
    for position, settings in enumerate(all_settings):
        print(f"{position + 1} of {len(all_settings)}: {', '.join(f'{key} = {value}' for key, value in settings.items())}", flush=True)
        history, failure = run(sys.argv[1], study, settings, folder / f"{position + 1}")
        results.append(history)
        if failure:
            failures.append(failure)
            print("  " + failure)
    rows = table(study, results)
    with open(folder / "table.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(rows)
    markdown = "\n".join("| " + " | ".join(row) + " |" for row in [rows[0], ["---"] * len(rows[0]), *rows[1:]])
    (folder / "table.md").write_text(markdown + "\n", encoding="utf-8")
    print(f"\n{markdown}\n\n{folder / 'table.md'}")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
