# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""What a run has written: tables, fields, log."""

import functools
import pathlib

from . import prm
from .fields import Series
from .tables import read_frame


class Result:
    """The output directory of a run, also of one that goes on, or was made elsewhere."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).absolute()
        if not self.folder.is_dir():
            raise FileNotFoundError(f"{folder}: there is no such folder.")

    def __repr__(self):
        return f"Result({str(self.folder)!r})"

    def table(self, name):
        """A table, such as "bodies" or "pairs", as a pandas frame (doc/output.md)."""
        return read_frame(self.folder / f"{name}.csv")

    @property
    def tables(self):
        """The names of all tables."""
        return sorted(path.stem for path in self.folder.glob("*.csv"))

    @functools.cached_property
    def history(self):
        """One row per step, read once."""
        return self.table("history")

    @property
    def probes(self):
        """The tables of the probes by their names."""
        names = [name for name in self.tables if name.startswith("probe_")]
        return {name.removeprefix("probe_"): self.table(name) for name in names}

    @property
    def volume(self):
        """Fields of the bodies over time."""
        return Series(self.folder / "volume.pvd")

    @property
    def surface(self):
        """Fields of the contact surface over time."""
        return Series(self.folder / "surface.pvd")

    @property
    def parameters(self):
        """All keys of the scene with defaults, as a nested dictionary of texts."""
        return prm.parse(prm.read(self.folder / "parameters.prm"))

    @property
    def log(self):
        """The text of log.txt: progress, summary, timers."""
        return (self.folder / "log.txt").read_text(encoding="utf-8")

    @property
    def warnings(self):
        """What the program warned of, each once."""
        lines = [line.strip() for line in self.log.splitlines()]
        found = [line.removeprefix("warning: ") for line in lines if line.startswith("warning: ")]
        return list(dict.fromkeys(found))
