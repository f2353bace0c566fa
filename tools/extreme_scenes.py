#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Sweeps to where the method may end, judged by the laws of mechanics.

Each family (tools/stress/families.py) is one small scene of which one quantity goes to extremes,
with the default scheme and all that conserve energy. A run has finished, perhaps with warnings, or
was refused with a reason; anything else is wrong: a crash, no end, a value that is not finite, or a
law that was broken in silence. FOLDER/table.csv has all runs, FOLDER/table.md a line by value.

    ./dev stress extremes [FOLDER] [--only FAMILY] [--quick] [--time-limit SECONDS]
"""

import argparse
import collections
import pathlib
import shutil
import sys

from stress import families, running, scenes, table, verdict
from studies import tables

TIME_LIMIT = 120.0


def parse():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("executable")
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER")
    names = [family.name for family in families.FAMILIES]
    parser.add_argument(
        "--only", choices=names, action="append", metavar="FAMILY", help=", ".join(names)
    )
    parser.add_argument("--quick", action="store_true", help="two values per family, one scheme")
    parser.add_argument("--time-limit", type=float, default=TIME_LIMIT, help="of each run, seconds")
    parser.add_argument(
        "--draw-only", action="store_true", help="no runs: table.md from table.csv in FOLDER"
    )
    return parser.parse_args()


def schemes_for(scene, known):
    """The default scheme, which is the first one, and all that conserve energy, as far as they know
    friction."""
    friction = any("Friction" in key for key in scene.settings)
    kept = [s for n, s in enumerate(known) if n == 0 or s["energy"] == "conserves"]
    return [s for s in kept if s["friction"] or not friction]


def tasks(arguments, known):
    """(family, value, scene, scheme) of every run; a quick one takes the schemes in turn."""
    position = 0
    for family in families.FAMILIES:
        if arguments.only and family.name not in arguments.only:
            continue
        for value in family.quick_values() if arguments.quick else family.values:
            scene = family.build(value)
            schemes = schemes_for(scene, known)
            if arguments.quick:
                position += 1
                schemes = [schemes[position % len(schemes)]]
            for scheme in schemes:
                yield family, value, scenes.changed(scene, scenes.keys_of(scheme)), scheme


def run(arguments, task):
    """The line of the table."""
    family, value, scene, scheme = task
    folder = arguments.folder / family.name / table.label(value) / scheme["name"]
    shutil.rmtree(folder, ignore_errors=True)
    ending = running.run(arguments.executable, scene.text(), folder, arguments.time_limit)
    (folder / "messages.txt").write_text(ending.messages + "\n", encoding="utf-8")
    judged = verdict.judge(ending, folder / "output", scene, scheme)
    line = table.row(family, value, scheme, judged, ending.seconds)
    print(table.in_words(line), flush=True)
    return line


def main():
    """Run and report. @return 0 if nothing is wrong"""
    arguments = parse()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    csv, markdown = (arguments.folder / f"table.{ending}" for ending in ("csv", "md"))
    if not arguments.draw_only:
        lines = []
        for task in tasks(arguments, running.schemes(arguments.executable)):
            lines.append(run(arguments, task))
            table.write(lines, csv)  # so that something is left of a run that is interrupted
    lines = tables.read_rows(csv)
    markdown.write_text(table.markdown(lines, families.FAMILIES), encoding="utf-8")
    counts = collections.Counter(line["outcome"] for line in lines)
    print(f"{len(lines)} runs: " + ", ".join(f"{counts[o]} {o}" for o in reversed(table.LETTERS)))
    print(f"Table: {markdown}, all runs: {csv}")
    return 1 if counts[verdict.WRONG] else 0


if __name__ == "__main__":
    sys.exit(main())
