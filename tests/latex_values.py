"""The value of a formula in LaTeX, for those of the report: products without a sign, fractions, squares, sin and cos."""

import math
import re

TOKEN = re.compile(r"(?:\\d+ot)?\\[a-z]+(?:_\w)?|[a-zA-Z](?:_\w)?|[\d.]+|\)/\(|[()+\-^]")


def value(latex, values):
    """The value of one side: as an expression of Python in which numbers stand for symbols."""
    text = latex.replace("\\,", "").replace("\\frac", "").replace("}{", ")/(").translate(str.maketrans("{}", "()"))
    text = re.sub(r"\\(sin|cos)(\\[a-z]+(?:_\w)?)", r"\\\1(\2)", text)
    expression = ""
    for token in TOKEN.findall(text):
        written = {"^": "**", "\\sin": "sin", "\\cos": "cos"}.get(token) or token
        written = f"({values[token]!r})" if token in values else written
        joined = re.search(r"[\d)]$", expression) and re.match(r"[\w(.]", written)
        expression += f"*{written}" if joined else written
    return float(eval(expression, {"sin": math.sin, "cos": math.cos}))


def sides(latex, values):
    """Values of both sides of an equation; `values` holds those of its symbols, such as ``\\\\dot\\\\theta`` and ``v_0``."""
    left, right = latex.split("=", 1)
    return value(left, values), value(right, values)
