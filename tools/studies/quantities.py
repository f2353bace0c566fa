# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Numbers that a study file derives from the columns of a history, such as
`last(momentum_x)/first(momentum_x)`, and the curve they lie on in theory."""

import csv
import math

from .distances import Curve
from .expressions import Expression
from .mistake import Mistake

#: What becomes of a column of history.csv: one number. An integral takes the value of each step for
#: constant in it, as contact forces are.
OF_COLUMNS = {
    "first": lambda column, steps: column[0],
    "last": lambda column, steps: column[-1],
    "largest": lambda column, steps: max(column),
    "integral": lambda column, steps: sum(value * step for value, step in zip(column, steps)),
}
#: The function that is given by the points of a file.
OF_CURVE = "curve"


class Quantity(Expression):
    """A number of a run: an expression in functions of columns, in quantities before it, and in
    curve(...), if there is one."""

    def __init__(self, name, text, where, before, curve=None):
        self.heading, self.before, self.curve, self.result = name, before, curve, None
        super().__init__(text, where, [quantity.heading for quantity in before])

    def __call__(self, result):
        """Of a run; nan if it failed."""
        if not result:
            return math.nan
        self.result = result
        return super().__call__(*(quantity(result) for quantity in self.before))

    def valid(self):
        functions = [f"{name}(COLUMN)" for name in OF_COLUMNS] + [f"{OF_CURVE}(...)"] * bool(
            self.curve
        )
        return f"Valid: {', '.join(functions)} with columns of history.csv. {super().valid()}"

    def check_call(self, node):
        if node.func.id in OF_COLUMNS:
            if len(node.args) != 1 or not hasattr(node.args[0], "id"):
                raise self.refuse(f"{node.func.id} wants the name of a column")
        elif node.func.id == OF_CURVE and self.curve and len(node.args) == 1:
            self.check(node.args[0])
        else:
            super().check_call(node)

    def evaluate(self, node, variables):
        function = getattr(getattr(node, "func", None), "id", None)
        if function in OF_COLUMNS:
            column = node.args[0].id
            if column not in self.result.history:
                raise Mistake(
                    f"{self.where} = {self.text}: {self.result.folder / 'history.csv'} has no"
                    f" column {column}. It has {', '.join(self.result.history)}."
                )
            return OF_COLUMNS[function](self.result[column], self.result["step_size"])
        if function == OF_CURVE:
            return self.curve(self.evaluate(node.args[0], variables))
        return super().evaluate(node, variables)


def read_quantities(texts, path, curve):
    """The quantities of a section by name."""
    found = []
    for name, text in texts.items():
        if not name.isidentifier():
            raise Mistake(
                f"{path}: [quantities] {name}: is no name. Take letters, digits and underscores."
            )
        found.append(Quantity(name, text, f"{path}: [quantities] {name}", list(found), curve))
    return {quantity.heading: quantity for quantity in found}


def read_curve(path, where):
    """The curve through the points of a file of two columns, linear between them, and constant
    beyond; and their names."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            names, *rows = csv.reader(file)
        abscissae, ordinates = zip(*[[float(value) for value in row] for row in rows])
    except (OSError, ValueError) as error:
        raise Mistake(
            f"{where} = {path}: cannot be read: {error}. Give a file with a line of two names and"
            " lines of two numbers, separated by commas."
        ) from None
    if sorted(set(abscissae)) != list(abscissae):
        raise Mistake(f"{where} = {path}: its first column must increase.")
    return names, Curve(abscissae, ordinates)
