#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Pictures of one run: plot.py DIR reads tables and fields in DIR, writes DIR/pictures/*.png."""

import argparse
import pathlib
import sys

try:
    from plotting import bodies, curves, style
except ImportError as error:
    sys.exit(
        f"plot.py: {error}. On Debian: apt-get install python3-matplotlib python3-meshio, "
        "and run it with /usr/bin/python3 (./dev plot DIR does both)."
    )

from plotting.problem import Problem
from plotting.tables import read_table


def write(figure, path):
    """Save a figure and free it."""
    try:
        figure.savefig(path)
    except OSError as error:
        sys.exit(f"plot.py: cannot write {path}: {error.strerror}")
    style.close(figure)
    print(f"  {path}")


def plot_history(directory, pictures, problems):
    """The figures that need history.csv only. Returns the table, or None."""
    try:
        history = read_table(directory / "history.csv")
    except Problem as problem:
        problems.append(problem)
        return None
    for name, draw in (
        ("energy", curves.energy),
        ("contact_force", curves.contact_force),
        ("momentum", curves.momentum),
    ):
        try:
            write(draw(history), pictures / f"{name}.png")
        except Problem as problem:
            problems.append(problem)
    return history


def plot_probes(directory, pictures, problems):
    """One figure for each probe."""
    for path in sorted(directory.glob("probe_*.csv")):
        try:
            name = path.stem.removeprefix("probe_")
            write(curves.probe(read_table(path), name), pictures / f"{path.stem}.png")
        except Problem as problem:
            problems.append(problem)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "directory", type=pathlib.Path, metavar="DIR", help="output directory of a run"
    )
    directory = parser.parse_args().directory
    if not directory.is_dir():
        sys.exit(f"plot.py: {directory} is not a directory. Give the 'Output directory' of a run.")

    pictures = directory / "pictures"
    try:
        pictures.mkdir(exist_ok=True)
    except OSError as error:
        sys.exit(f"plot.py: cannot write to {pictures}: {error.strerror}")

    style.use()
    print("Writing")
    problems = []
    history = plot_history(directory, pictures, problems)
    plot_probes(directory, pictures, problems)
    try:
        write(bodies.bodies(directory, history), pictures / "bodies.png")
    except Problem as problem:
        problems.append(problem)

    for problem in problems:
        print(f"plot.py: left out: {problem}", file=sys.stderr)
    # A run without fields or probes is in order; one without a history has nothing to show.
    return 0 if history else 1


if __name__ == "__main__":
    sys.exit(main())
