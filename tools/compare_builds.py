#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Whether two builds compute the same: runs scenes with both, compares all of history.csv.

    compare_builds.py record EXECUTABLE FOLDER [SCENE ...]    run scenes, keep histories in FOLDER
    compare_builds.py against FOLDER EXECUTABLE [SCENE ...]   run them again and compare

Without scenes all in parameters/. Columns agree if they differ by at most TOLERANCE times the
largest value of their kind: of all energies and works the largest energy, of momenta the largest
one or the impulse of contact. What may be zero but for round-off, penetration and angular momentum,
is measured by the way that the bodies could go with their energy and momentum. Effort is added up
and shown: it should not grow. Exit status 1 if anything differs.
"""

import argparse
import math
import pathlib
import shutil
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python"))

import signorini  # noqa: E402  pylint: disable=wrong-import-position
from signorini.tables import read_columns  # noqa: E402  pylint: disable=wrong-import-position

TOLERANCE = 1e-10
#: What counts effort, not motion.
COUNTS = (
    "active_set_iterations",
    "linear_iterations",
    "predictor_iterations",
    "impulse_iterations",
    "products_combined",
    "products_stiffness",
    "products_mass",
)
#: Differences of round-off, and times.
IGNORED = ("wall_time", "energy_residual", "energy_transfer")


def run(executable, scene, folder, overrides):
    """Run a scene; @return seconds."""
    shutil.rmtree(folder, ignore_errors=True)
    settings = {"Output/VTU": False, **dict(text.split("=", 1) for text in overrides)}
    start = time.time()
    try:
        signorini.start(scene, folder, settings, executable=executable).wait()
    except signorini.SignoriniError as error:
        sys.exit(f"{scene}: {error}")
    return time.time() - start


def group(column):
    """Columns that share a scale."""
    for word in ("energy", "work"):
        if word in column:
            return "energy"
    for word in ("angular_momentum", "momentum", "contact_force", "friction_force"):
        if column.startswith(word):
            return word
    return column


def scales(history):
    result = {}
    for column, values in history.items():
        result[group(column)] = max(result.get(group(column), 0.0), max(map(abs, values)))
    impulse = sum(
        force * step for force, step in zip(history["contact_force"], history["step_size"])
    )
    result["momentum"] = max(result["momentum"], impulse)
    speed = 2 * result["energy"] / (result["momentum"] or 1.0)
    way = speed * history["time"][-1]
    for column in history:
        if "penetration" in column or column in ("sliding", "slip"):
            result[column] = max(result[column], way)
    result["angular_momentum"] = max(result["angular_momentum"], result["momentum"] * way)
    return result


def difference(a, b):
    """Infinite if one of them is not a finite number: comparisons with NaN hide it."""
    return abs(a - b) if math.isfinite(a) and math.isfinite(b) else math.inf


def differences(before, after):
    """(part of the scale, column, row), the largest of each column that both have."""
    scale = scales(before)
    for column in before:
        if column in COUNTS + IGNORED or column not in after:
            continue
        size = scale[group(column)] or 1.0
        yield max(
            (difference(a, b) / size, column, row)
            for row, (a, b) in enumerate(zip(before[column], after[column]))
        )


def compare(name, before, after, tolerance):
    """A line about a scene. @return whether it is the same"""
    if len(before["step"]) != len(after["step"]):
        print(f"{name}: {len(before['step'])} rows before, {len(after['step'])} after  DIFFERENT")
        return False
    missing = sorted(set(before) - set(after))
    if missing:
        print(f"{name}: columns {', '.join(missing)} are missing  DIFFERENT")
        return False
    part, column, row = max(differences(before, after))
    counts = ", ".join(
        f"{count} {sum(before[count]):.0f} -> {sum(after[count]):.0f}"
        for count in COUNTS
        if count in before and count in after and sum(before[count])
    )
    same = part <= tolerance
    print(
        f"{name}: largest difference {part:.1e} ({column}, row {row});"
        f" {counts}{'' if same else '  DIFFERENT'}",
        flush=True,
    )
    return same


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=("record", "against"))
    parser.add_argument("first", help="record: the executable; against: the folder")
    parser.add_argument("second", help="record: the folder; against: the executable")
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", dest="overrides")
    parser.add_argument(
        "--no-run", action="store_true", help="against: compare what was run before"
    )
    parser.add_argument("--tolerance", type=float, default=TOLERANCE)
    arguments = parser.parse_args()
    scenes = arguments.scenes or sorted((ROOT / "parameters").rglob("*.prm"))
    executable, folder = arguments.first, pathlib.Path(arguments.second)
    if arguments.what == "against":
        executable, folder = arguments.second, pathlib.Path(arguments.first)
    same = True
    for scene in map(pathlib.Path, scenes):
        if arguments.what == "record":
            seconds = run(executable, scene, folder.resolve() / scene.stem, arguments.overrides)
            print(f"{scene.stem}: {seconds:.1f} s", flush=True)
            continue
        output = folder.resolve() / "again" / scene.stem
        if not arguments.no_run:
            run(executable, scene, output, arguments.overrides)
        before, after = (
            read_columns(where / "history.csv") for where in (folder / scene.stem, output)
        )
        same = compare(scene.stem, before, after, arguments.tolerance) and same
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
