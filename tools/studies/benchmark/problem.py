# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A case of the benchmark: a study file whose [together] lists meshes, each with cells half the
size of the one before, and what is known of the quantities that it observes."""

import dataclasses
import math
import re

from .. import runs
from ..case import Case, finished, reference, timed
from ..expressions import Expression
from ..mistake import Mistake
from ..tables import read_rows
from ..work_precision.errors import COUNTED

#: What a reference is.
EXACT, CERTIFIED = "exact", "certified"
#: Settings that name a scheme.
SCHEME = "Time/Scheme"


@dataclasses.dataclass
class Reference:
    """What is known of a quantity: its value, and how far the truth may be from it."""

    value: float
    uncertainty: float
    kind: str


class Problem(Case):
    """A case. certified: rows of the table of certified values; coarse: its first mesh only."""

    def __init__(self, path, coarse, folder, certified):
        super().__init__(path, False, folder)
        if coarse:
            self.study.sequence = self.study.sequence[:1]
        self.name = self.study.name
        self.expected = {
            name: Expression(text, f"{path}: [expected] {name}", ("h",))
            for name, text in self.study.expected.items()
        }
        rows = {row["quantity"]: row for row in certified if row["case"] == self.name}
        self.references = {}
        for name in self.study.observe:
            if name in self.study.exact:
                self.references[name] = Reference(self.study.exact[name](0.0), 0.0, EXACT)
            elif name in rows:
                value, uncertainty = (float(rows[name][key]) for key in ("value", "uncertainty"))
                self.references[name] = Reference(value, uncertainty, CERTIFIED)
            if name not in self.expected:
                raise Mistake(f"{path}: [expected] does not say how wrong {name} may be.")

    @property
    def to_certify(self):
        """The quantities of which nothing is known but by refinement."""
        return [name for name in self.study.observe if name not in self.study.exact]

    def tolerance(self, name, level):
        """How far a run may be from the reference: its uncertainty, and the expected error of the
        discretisation on a mesh, the first one being number 0."""
        return self.references[name].uncertainty + self.expected[name](0.5**level)

    def results(self, executable, draw_only):
        """(settings, number of the mesh, result) of each run; read if nothing is to run."""
        found = []
        for number, (task, (variant, row)) in enumerate(zip(self.tasks, self.study.runs())):
            result = finished(task) if draw_only else timed(executable, task)
            settings = {**(variant.settings if variant else {}), **row}
            found.append((settings, number % len(self.study.sequence), result))
        return found

    def series(self, executable, draw_only):
        """By scheme, the results on the meshes of [certify]. Those of an earlier study are kept if
        scene and keys are the same."""
        found = {}
        for scheme in re.split(r",\s*", self.study.certify_with):
            found[scheme] = []
            for number, row in enumerate(self.study.certify, 1):
                keys = {"Output/VTU": "false", **self.study.common, **row, SCHEME: scheme}
                folder = self.folder / f"certify-{scheme}-{number}"
                task = runs.Task(self.study, f"{scheme}, mesh {number}", keys, folder)
                found[scheme].append(reference(executable, task, draw_only))
        return found

    def resolution(self, name, result):
        """Times at which something begins or ends are known to a step."""
        counted = COUNTED.search(getattr(self.study.observations[name], "text", ""))
        return result["step_size"][-1] if counted else 0.0

    def value(self, name, result):
        """Of a quantity in a run."""
        return self.study.observations[name](result) if result else math.nan


def read_certified(path):
    """The table of certified values."""
    return read_rows(path) if path.is_file() else []
