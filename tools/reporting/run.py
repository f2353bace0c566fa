# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The folder of a run, read once."""

import functools
import pathlib
import re

import numpy
from plotting import fields, obstacles
from plotting.problem import Problem
from plotting.tables import read_table

from .log import Log, parse_log
from .schemes import SCHEMES


class Run:
    """Tables, log and scene. Whatever is missing or broken is empty, and named in problems."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.problems = []
        self.tables = {path.stem: self._table(path) for path in sorted(self.folder.glob("*.csv"))}
        self.tables = {name: table for name, table in self.tables.items() if table}
        if "history" not in self.tables and not (self.folder / "history.csv").exists():
            self.problems.append("there is no history.csv: no energy and no contact force")
        self.scene = self._text("scene.prm")
        self.parameters = self._text("parameters.prm")
        self.settings = obstacles.read_sections(self.parameters or self.scene)
        text = self._text("log.txt")
        self.log = parse_log(text) if text else Log()

    def _table(self, path):
        try:
            return read_table(path)
        except Problem as problem:
            self.problems.append(str(problem))
            return None

    def _text(self, name):
        try:
            return (self.folder / name).read_text(encoding="utf-8", errors="replace")
        except OSError:
            self.problems.append(f"there is no {name}")
            return ""

    @property
    def history(self):
        """Columns of history.csv, {} without it."""
        return self.tables.get("history", {})

    @property
    def probes(self):
        """Tables of the probes by name."""
        return {
            name.removeprefix("probe_"): table
            for name, table in self.tables.items()
            if name.startswith("probe_")
        }

    def setting(self, path, default=""):
        """The value of a key such as Time/Scheme."""
        *sections, key = path.split("/")
        return self.settings.get(tuple(sections), {}).get(key, default)

    def number(self, path, default):
        """The same as a number; what is none is the default."""
        try:
            return float(self.setting(path, default))
        except ValueError:
            return default

    @property
    def scheme(self):
        """The promises of the scheme, None if the folder does not tell its name."""
        return SCHEMES.get(self.setting("Time/Scheme"))

    @property
    def dimension(self):
        """2 or 3; 3 if the scene is not there."""
        return int(self.number("Dimension", 3))

    @property
    def bodies(self):
        """Names."""
        return names(self.setting("Bodies/Names"))

    @property
    def obstacles(self):
        """Names."""
        return names(self.setting("Obstacles/Names"))

    def pairs(self):
        """(slave, master, whether the master is an obstacle) in the order of pairs.csv."""
        found = []
        for pair in names(self.setting("Contact/Pairs")):
            slave, _, master = (side.split("[")[0].strip() for side in pair.partition(":"))
            found.append((slave, master, master in self.obstacles))
        return found

    @functools.cached_property
    def size(self):
        """The largest extent of the smallest body, None if there is nothing to measure."""
        try:
            first = fields.read_fields(fields.read_series(self.folder / "volume.pvd")[0][1])
        except Problem:
            return smallest(map(self._given_size, self.bodies))
        body = first.at_cells("body")
        body = numpy.zeros(len(first.cells)) if body is None else numpy.round(body)
        return smallest(
            numpy.ptp(first.points[first.cells[body == number]].reshape(-1, 3), axis=0).max()
            for number in numpy.unique(body)
        )

    def _given_size(self, body):
        """Of shapes whose keys tell it."""
        section = f"Bodies/{body}"
        if self.setting(f"{section}/Shape") == "ball":
            return 2.0 * self.number(f"{section}/Radius", 1.0)
        if self.setting(f"{section}/Shape") == "box":
            corners = [
                [float(entry) for entry in self.setting(f"{section}/{key}", default).split(",")]
                for key, default in (("Lower corner", "0, 0, 0"), ("Upper corner", "1, 1, 1"))
            ]
            return max(high - low for low, high in zip(*corners))
        return None


def names(text):
    """Entries of a list; commas in brackets belong to an entry."""
    return [entry.strip() for entry in re.split(r",(?![^\[]*\])", text) if entry.strip()]


def smallest(values):
    """The least of those that are known, None without one."""
    return min((value for value in values if value), default=None)
