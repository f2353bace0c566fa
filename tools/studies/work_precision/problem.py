# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A problem of the study work-precision: a study file, the schemes that can run its scene, and what
its runs cost and how wrong they are."""

import signorini

from .. import instants
from ..case import Case, seconds
from ..definition import Variant
from . import errors

SCHEME = "Time/Scheme"
#: Groups of the runs of all schemes along [schemes], and of the run that is compared with the
#: reference only to tell how good that is.
PATH, CHECK = "path of all schemes", "check of the reference"
COSTS = {
    "dofs": "dofs (mean)",
    "steps": "steps",
    "seconds": "processor s",
    "products": "products",
    "work": "products x dofs, 1e6",
}


class Problem(Case):
    """A study file with the runs of all schemes along its path and those of its variants."""

    def __init__(self, executable, path, coarse, folder):
        super().__init__(path, coarse, folder)
        self.refused = {}
        rows = self.study.path_of_schemes[: 1 if coarse else None]
        self.study.variants = [
            Variant(f"{scheme} {number}", {SCHEME: scheme, **row}, PATH)
            for scheme in (self.accepted(executable) if rows else ())
            for number, row in enumerate(rows, 1)
        ] + self.study.variants

    def accepted(self, executable):
        """The schemes that move bodies with steps of given size and run this scene. What the
        program says against the others is kept."""
        for name, scheme in instants.schemes.items():
            if not (scheme["inertia"] and scheme["variable_step"]):
                continue
            keys = {**self.study.common, **self.study.path_of_schemes[0], SCHEME: name}
            sets = [part for item in keys.items() for part in ("--set", "=".join(item))]
            try:
                signorini.ask(self.study.scene, "--validate", *sets, executable=executable)
                yield name
            except signorini.SceneError as error:
                self.refused[name] = str(error)

    def read(self, done, reference):
        """Measure what was run."""
        self.results = {variant.name: result for variant, result in zip(self.study.variants, done)}
        self.reference_result = reference
        expected = errors.Expected(self.study, reference, next(filter(None, done)))
        self.quantities = list(expected.names())
        measured = [
            {**cost(result), **expected.errors(result)} if result else {} for result in done
        ]
        rows = list(zip(self.study.variants, measured))
        check = next((numbers for variant, numbers in rows if variant.group == CHECK), {})
        self.floor = {
            name: max(value, expected.resolution(name))
            for name, value in check.items()
            if name in self.quantities
        }
        self.rows = [row for row in rows if row[0].group != CHECK]

    def scheme(self, variant):
        """The name of the scheme of a run."""
        return variant.settings.get(SCHEME, self.study.common.get(SCHEME, ""))


def cost(result):
    """What a run took. A product with M + s A stands for one iteration of the linear solver with
    its start; times degrees of freedom, it is a cost that no machine changes."""
    dofs, products = result["dofs"][1:], result["products_combined"][1:]
    return {
        "dofs": sum(dofs) / len(dofs),
        "steps": len(dofs),
        "seconds": seconds(result),
        "products": sum(products),
        "work": sum(map(float.__mul__, dofs, products)) / 1e6,
    }
