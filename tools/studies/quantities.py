# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Numbers that a study file derives from the columns of the tables of a run, such as
`last(momentum_x)/first(momentum_x)`, and the curve they lie on in theory."""

import ast
import csv
import math

from signorini.tables import read_columns

from .distances import Curve
from .expressions import Expression
from .mistake import Mistake
from .observe import NO_FORCE


class Never(Exception):
    """A quantity has no value in a run, because nothing happened."""


def spans(column, times):
    """(value, start, end) of each row: a row stands for the time since the one before it."""
    return list(zip(column[1:], times, times[1:]))


def active(column, times):
    """The spans in which a column differs from zero by more than round-off."""
    smallest = NO_FORCE * max(map(abs, column))
    return [span for span in spans(column, times) if abs(span[0]) > smallest]


#: What becomes of a column and its times: one number. Each value counts for constant in the step
#: that leads to it, as contact forces are; what is zero all the time neither begins nor ends.
OF_COLUMNS = {
    "first": lambda column, times: column[0],
    "last": lambda column, times: column[-1],
    "largest": lambda column, times: max(column),
    "smallest": lambda column, times: min(column),
    "total": lambda column, times: sum(column),
    "integral": lambda column, times: sum(
        value * (end - start) for value, start, end in spans(column, times)
    ),
    "zero": lambda column, times: next(
        (
            start + (end - start) * before / (before - after)
            for before, after, start, end in zip(column, column[1:], times, times[1:])
            if before > 0 >= after or before < 0 <= after
        ),
        math.nan,
    ),
    "begin": lambda column, times: min(
        (span[1] for span in active(column, times)), default=math.nan
    ),
    "end": lambda column, times: max((span[2] for span in active(column, times)), default=math.nan),
    "duration": lambda column, times: sum(end - start for _, start, end in active(column, times)),
}
#: The function that is given by the points of a file.
OF_CURVE = "curve"


class Quantity(Expression):
    """A number of a run: an expression in functions of columns, in quantities before it, and in
    curve(...), if there is one. It is nan where it needs the time of what never happened."""

    def __init__(self, name, text, where, before, curve=None):
        self.heading, self.before, self.curve, self.result = name, before, curve, None
        super().__init__(text, where, [quantity.heading for quantity in before])

    def __call__(self, result):
        """Of a run; nan if it failed."""
        if not result:
            return math.nan
        self.result = result
        try:
            return super().__call__(*(quantity(result) for quantity in self.before))
        except Never:
            return math.nan

    def valid(self):
        functions = [f"{name}(COLUMN)" for name in OF_COLUMNS] + [f"{OF_CURVE}(...)"] * bool(
            self.curve
        )
        return (
            f"Valid: {', '.join(functions)} with columns of history.csv, "
            f"supports.csv, pairs.csv and bodies.csv, or PROBE.COLUMN. {super().valid()}"
        )

    def check_call(self, node):
        if node.func.id in OF_COLUMNS:
            if len(node.args) != 1 or not isinstance(node.args[0], (ast.Name, ast.Attribute)):
                raise self.refuse(f"{node.func.id} wants the name of a column")
        elif node.func.id == OF_CURVE and self.curve and len(node.args) == 1:
            self.check(node.args[0])
        else:
            super().check_call(node)

    def column(self, probe, name):
        """A column of a probe, or of the other tables if it has no name; and its times."""
        path = self.result.folder / f"probe_{probe}.csv"
        if probe and not path.is_file():
            raise Mistake(f"{self.where} = {self.text}: there is no {path}.")
        columns = read_columns(path) if probe else self.result.columns
        if name not in columns:
            raise Mistake(
                f"{self.where} = {self.text}: no table in {self.result.folder} has a column"
                f" {name}. There are {', '.join(columns)}."
            )
        return columns[name], columns["time"]

    def evaluate(self, node, variables):
        function = getattr(getattr(node, "func", None), "id", None)
        if function in OF_COLUMNS:
            probe, _, column = ast.unparse(node.args[0]).rpartition(".")
            return happened(OF_COLUMNS[function](*self.column(probe, column)))
        if function == OF_CURVE:
            return self.curve(self.evaluate(node.args[0], variables))
        value = super().evaluate(node, variables)
        return happened(value) if hasattr(node, "id") else value


def happened(value):
    """The value, unless it is nan."""
    if math.isnan(value):
        raise Never
    return value


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
