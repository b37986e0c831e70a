"""The value of a formula in LaTeX, for those of the report: products without a sign, fractions, squares, sin and cos."""

import math
import re

TOKEN = re.compile(r"\\[a-zA-Z]+|[0-9.]+|[a-zA-Z]|[{}()+\-^_=]")
FUNCTIONS = {"\\sin": math.sin, "\\cos": math.cos}


class Reader:
    """Reads one side of a formula from left to right."""

    def __init__(self, latex: str, values: dict[str, float]) -> None:
        self.tokens = TOKEN.findall(latex.replace("\\,", ""))
        self.values = values
        self.at = 0

    @property
    def next(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, wanted: str = "") -> str:
        token = self.next
        assert token, "the formula ends too early"
        assert not wanted or token == wanted, f"{token} where {wanted} should be"
        self.at += 1
        return token

    def whole(self) -> float:
        value = self.total()
        assert not self.next, f"{self.next} is left"
        return value

    def total(self) -> float:
        value = self.product() if self.next != "-" else 0.0
        while self.next in ("+", "-"):
            sign = 1.0 if self.take() == "+" else -1.0
            value += sign * self.product()
        return value

    def product(self) -> float:
        value = self.power()
        while self.next and self.next not in "+-)}=":
            value *= self.power()
        return value

    def power(self) -> float:
        base = self.factor()
        if self.next == "^":
            self.take()
            return base ** float(self.take())
        return base

    def group(self) -> float:
        self.take("{")
        value = self.total()
        self.take("}")
        return value

    def factor(self) -> float:
        token = self.take()
        if token == "(":
            value = self.total()
            self.take(")")
            return value
        if token == "\\frac":
            return self.group() / self.group()
        if token in FUNCTIONS:
            return FUNCTIONS[token](self.power())
        if token in ("\\dot", "\\ddot"):
            token += self.take()
        if token[0].isdigit():
            return float(token)
        if self.next == "_":
            self.take()
            token += f"_{self.take()}"
        return self.values[token]


def sides(latex: str, values: dict[str, float]) -> tuple[float, float]:
    """Values of both sides of an equation; `values` holds those of its symbols, such as ``\\\\dot\\\\theta`` and ``v_0``."""
    left, right = latex.split("=", 1)
    return Reader(left, values).whole(), Reader(right, values).whole()
