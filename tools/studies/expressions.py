# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Arithmetic expressions in the time t, such as `0.025*max(-sin(2*pi*t), 0)**3`; nothing but arithmetic is evaluated."""

import ast
import math
import operator

from .mistake import Mistake

CONSTANTS = {"pi": math.pi}
#: Functions with one argument, and those with two or more.
FUNCTIONS = {"sin": math.sin, "cos": math.cos, "sqrt": math.sqrt, "abs": abs}
CHOICES = {"max": max, "min": min}
OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv, ast.Pow: operator.pow,
             ast.USub: operator.neg, ast.UAdd: operator.pos}
VALID = f"Valid: numbers, t, {', '.join([*CONSTANTS, *FUNCTIONS, *CHOICES])}, + - * / ** ^ and brackets."


class Expression:
    """A function of t. `where` begins the messages: file and key."""

    def __init__(self, text, where):
        self.text, self.where = text, where
        try:
            self.tree = ast.parse(text.strip().replace("^", "**"), mode="eval").body
        except (SyntaxError, ValueError, RecursionError) as error:
            raise Mistake(f"{where} = {text}: cannot be read: {getattr(error, 'msg', error)}. {VALID}") from None
        self.check(self.tree)

    def __call__(self, t):
        """The value at a time."""
        try:
            value = self.evaluate(self.tree, t)
        except (ArithmeticError, ValueError) as error:
            raise Mistake(f"{self.where} = {self.text}: has no value at t = {t:g}: {error}. Write it so that it has one during the whole run.") from None
        if isinstance(value, complex) or not math.isfinite(value):
            raise Mistake(f"{self.where} = {self.text}: has no real value at t = {t:g}. Write it so that it has one during the whole run.")
        return value

    def refuse(self, what):
        """The mistake of something that is not arithmetic."""
        return Mistake(f"{self.where} = {self.text}: {what}. {VALID}")

    def check(self, node):
        """Refuse all that evaluate() does not know."""
        if isinstance(node, ast.Constant) and type(node.value) in (int, float):
            return
        if isinstance(node, ast.Name):
            if node.id != "t" and node.id not in CONSTANTS:
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
            raise self.refuse(f"{name} wants {'one argument' if name in FUNCTIONS else 'two arguments or more'}, not {count}")
        for argument in node.args:
            self.check(argument)

    def evaluate(self, node, t):
        """The value of a part."""
        if isinstance(node, ast.Constant):
            return float(node.value)
        if isinstance(node, ast.Name):
            return t if node.id == "t" else CONSTANTS[node.id]
        if isinstance(node, ast.BinOp):
            return OPERATORS[type(node.op)](self.evaluate(node.left, t), self.evaluate(node.right, t))
        if isinstance(node, ast.UnaryOp):
            return OPERATORS[type(node.op)](self.evaluate(node.operand, t))
        return {**FUNCTIONS, **CHOICES}[node.func.id](*(self.evaluate(argument, t) for argument in node.args))
