# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Arithmetic expressions in some variables, such as `0.025*max(-sin(2*pi*t), 0)**3`; nothing but
arithmetic is evaluated."""

import ast
import math
import operator

from .mistake import Mistake

CONSTANTS = {"pi": math.pi}
#: Functions with one argument, and those with two or more.
FUNCTIONS = {"sin": math.sin, "cos": math.cos, "sqrt": math.sqrt, "abs": abs}
CHOICES = {"max": max, "min": min}
OPERATORS = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
}


class Expression:
    """A function of the variables named, t if none. `where` begins the messages: file and key."""

    def __init__(self, text, where, variables=("t",)):
        self.text, self.where, self.variables = text, where, tuple(variables)
        try:
            self.tree = ast.parse(text.strip().replace("^", "**"), mode="eval").body
        except (SyntaxError, ValueError, RecursionError) as error:
            raise Mistake(
                f"{where} = {text}: cannot be read: {getattr(error, 'msg', error)}. {self.valid()}"
            ) from None
        self.check(self.tree)

    def __call__(self, *values):
        """The value for values of the variables, in their order."""
        variables = dict(zip(self.variables, values))
        at = ", ".join(f"{name} = {value:g}" for name, value in variables.items()) or "all"
        try:
            value = self.evaluate(self.tree, variables)
        except (ArithmeticError, ValueError) as error:
            raise Mistake(
                f"{self.where} = {self.text}: has no value at {at}: {error}. Write it so that it"
                " always has one."
            ) from None
        if isinstance(value, complex) or not math.isfinite(value):
            raise Mistake(
                f"{self.where} = {self.text}: has no real value at {at}. Write it so that it always"
                " has one."
            )
        return value

    def valid(self):
        """What may be written."""
        return (
            f"Valid: numbers, {', '.join([*self.variables, *CONSTANTS, *FUNCTIONS, *CHOICES])}, + -"
            " * / ** ^ and brackets."
        )

    def refuse(self, what):
        """The mistake of something that is not arithmetic."""
        return Mistake(f"{self.where} = {self.text}: {what}. {self.valid()}")

    def check(self, node):
        """Refuse all that evaluate() does not know."""
        if isinstance(node, ast.Constant) and type(node.value) in (int, float):
            return
        if isinstance(node, ast.Name):
            if node.id not in self.variables and node.id not in CONSTANTS:
                raise self.refuse(f"{node.id} is not known")
        elif isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
            self.check(node.left)
            self.check(node.right)
        elif isinstance(node, ast.UnaryOp) and type(node.op) in OPERATORS:
            self.check(node.operand)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
            self.check_call(node)
        else:
            raise self.refuse(f"`{ast.unparse(node)}` is not arithmetic")

    def check_call(self, node):
        """A known function with the right number of arguments."""
        name, count = node.func.id, len(node.args)
        if name not in FUNCTIONS and name not in CHOICES:
            raise self.refuse(f"the function {name} is not known")
        if count != 1 and name in FUNCTIONS or count < 2 and name in CHOICES:
            raise self.refuse(
                f"{name} wants {'one argument' if name in FUNCTIONS else 'two arguments or more'},"
                f" not {count}"
            )
        for argument in node.args:
            self.check(argument)

    def evaluate(self, node, variables):
        """The value of a part."""
        if isinstance(node, ast.Constant):
            return float(node.value)
        if isinstance(node, ast.Name):
            return {**CONSTANTS, **variables}[node.id]
        if isinstance(node, ast.BinOp):
            return OPERATORS[type(node.op)](
                self.evaluate(node.left, variables), self.evaluate(node.right, variables)
            )
        if isinstance(node, ast.UnaryOp):
            return OPERATORS[type(node.op)](self.evaluate(node.operand, variables))
        return {**FUNCTIONS, **CHOICES}[node.func.id](
            *(self.evaluate(argument, variables) for argument in node.args)
        )
