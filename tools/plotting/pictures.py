# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""All pictures of a run, into its folder."""

from . import bodies, curves, style
from .problem import Problem
from .tables import read_table


def draw_pictures(directory):
    """Draw what there is into directory/pictures.

    Returns the paths of the pictures, what was left out and why (a list of Problem), and the
    history or None. A folder or file that cannot be written is a Problem that is raised.
    """
    folder = directory / "pictures"
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        raise Problem(f"cannot write to {folder}: {error.strerror}") from None
    style.use()
    written, problems = [], []

    def attempt(draw, name):
        try:
            figure = draw()
        except Problem as problem:
            problems.append(problem)
            return
        written.append(write(figure, folder / f"{name}.png"))

    history = read_history(directory, problems)
    if history:
        attempt(lambda: curves.energy(history), "energy")
        attempt(lambda: curves.contact_force(history), "contact_force")
        attempt(lambda: curves.momentum(history), "momentum")
    for path in sorted(directory.glob("probe_*.csv")):
        name = path.stem.removeprefix("probe_")
        attempt(lambda path=path, name=name: curves.probe(read_table(path), name), path.stem)
    attempt(lambda: bodies.bodies(directory, history), "bodies")
    return written, problems, history


def read_history(directory, problems):
    """The history, or None and one more problem."""
    try:
        return read_table(directory / "history.csv")
    except Problem as problem:
        problems.append(problem)
        return None


def write(figure, path):
    """Save a figure and free it. Returns the path."""
    try:
        figure.savefig(path)
    except OSError as error:
        raise Problem(f"cannot write {path}: {error.strerror}") from None
    finally:
        style.close(figure)
    return path
