# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A formula of named numbers, as in a dictionary: "speed/sqrt(abs(torque))".

+ - * / **, brackets, numbers, the names, and abs sqrt exp log sin cos tan min max.
"""

import ast
import math
import operator

from . import Refused

OPERATIONS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
              ast.Div: operator.truediv, ast.Pow: operator.pow, ast.USub: operator.neg,
              ast.UAdd: operator.pos}
FUNCTIONS = {"abs": abs, "sqrt": math.sqrt, "exp": math.exp, "log": math.log,
             "sin": math.sin, "cos": math.cos, "tan": math.tan, "min": min, "max": max}


class Formula:
    def __init__(self, text, names):
        self.text, self.names = str(text), names
        try:
            self._tree = ast.parse(self.text, mode="eval").body
        except SyntaxError:
            self._refuse("is none")
        self._check(self._tree)

    def _refuse(self, what):
        raise Refused(f"formula '{self.text}' {what}; there are the names "
                      f"{', '.join(self.names)}, + - * / **, and {', '.join(FUNCTIONS)}")

    def _check(self, node):
        if isinstance(node, ast.Name):
            if node.id not in self.names:
                self._refuse(f"has '{node.id}', which is not known")
            return
        if isinstance(node, ast.Constant) and type(node.value) in (int, float):
            return
        if isinstance(node, ast.Call):
            if not isinstance(node.func, ast.Name) or node.func.id not in FUNCTIONS \
                    or node.keywords or not node.args:
                self._refuse("has a function that is not known")
            inner = node.args
        elif isinstance(node, ast.BinOp) and type(node.op) in OPERATIONS:
            inner = [node.left, node.right]
        elif isinstance(node, ast.UnaryOp) and type(node.op) in OPERATIONS:
            inner = [node.operand]
        else:
            self._refuse(f"has '{ast.unparse(node)}', which cannot be used")
        for part in inner:
            self._check(part)

    def __call__(self, values):
        """values: numbers by their names; nan where it has no value."""
        try:
            return float(self._value(self._tree, values))
        except (ArithmeticError, ValueError, TypeError):
            return math.nan

    def _value(self, node, values):
        if isinstance(node, ast.Name):
            return values[node.id]
        if isinstance(node, ast.Constant):
            return node.value
        if isinstance(node, ast.Call):
            return FUNCTIONS[node.func.id](*(self._value(a, values) for a in node.args))
        if isinstance(node, ast.UnaryOp):
            return OPERATIONS[type(node.op)](self._value(node.operand, values))
        return OPERATIONS[type(node.op)](self._value(node.left, values),
                                         self._value(node.right, values))
