"""Find what may round otherwise on another machine: functions of the C library, BLAS, NumPy's fast loops.

IEEE 754 defines + − × ÷ √, comparisons and conversions to the bit. It does not define the sine of a C library, nor the order in
which BLAS sums. What is allowed is listed; everything else is found.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator
from typing import NamedTuple

# Exact, or rounded correctly by every implementation.
MATH = {
    "sqrt", "floor", "ceil", "trunc", "fabs", "copysign", "ldexp", "frexp", "modf", "fmod", "nextafter", "ulp", "fsum",
    "isnan", "isinf", "isfinite", "isclose", "inf", "nan", "pi", "tau", "e", "isqrt", "gcd", "lcm", "comb",
    "factorial", "prod",
    "degrees", "radians",
}  # fmt: skip
# The same, and what only makes, shapes, picks or orders arrays. Sums are allowed: NumPy adds pairwise in an order that depends
# on the shape alone. Forbidden: sin, exp, hypot and the like, which have variants for processors; interp, einsum and dot, which
# may fuse products with sums.
NUMPY = {
    # kinds and constants
    "ndarray", "float64", "float32", "int64", "int32", "int16", "int8", "uint64", "uint32", "uint16", "uint8",
    "bool_", "void",
    "str_", "object_", "integer", "floating", "number", "generic", "dtype", "finfo", "iinfo", "inf", "nan", "pi", "newaxis",
    "errstate", "__version__", "typing",
    # made and shaped
    "array", "asarray", "ascontiguousarray", "empty", "empty_like", "zeros", "zeros_like", "ones", "ones_like",
    "full", "full_like",
    "eye", "diag", "linspace", "arange", "meshgrid", "indices", "frombuffer", "fromiter", "copy", "save", "load",
    "atleast_1d", "atleast_2d", "broadcast_to", "broadcast_arrays", "broadcast_shapes", "concatenate", "stack",
    "hstack", "vstack",
    "column_stack", "append", "insert", "delete", "repeat", "tile", "split", "reshape", "ravel", "moveaxis", "swapaxes",
    "transpose", "expand_dims", "squeeze", "flip", "roll", "ndim", "size", "shape", "ndindex", "ndenumerate",
    "unravel_index",
    "ravel_multi_index",
    # picked, compared and ordered
    "where", "select", "choose", "take", "put", "nonzero", "flatnonzero", "argwhere", "any", "all", "isin", "unique",
    "searchsorted",
    "sort", "argsort", "lexsort", "argmin", "argmax", "nanargmin", "nanargmax", "min", "max", "minimum", "maximum",
    "nanmin",
    "nanmax", "fmin", "fmax", "clip", "equal", "not_equal", "less", "less_equal", "greater", "greater_equal", "logical_and",
    "logical_or", "logical_not", "isnan", "isinf", "isfinite", "isclose", "allclose", "array_equal", "count_nonzero",
    # exact or rounded correctly
    "abs", "absolute", "fabs", "sign", "signbit", "copysign", "floor", "ceil", "trunc", "rint", "sqrt", "square",
    "nextafter",
    "spacing", "ldexp", "frexp", "fmod", "nan_to_num", "add", "subtract", "multiply", "divide", "true_divide",
    "negative", "outer",
    "diff", "sum", "nansum", "mean", "prod", "cumsum", "cumprod", "bitwise_and", "bitwise_or",
}  # fmt: skip
METHODS = {"dot", "std", "var"}  # of arrays: BLAS, or a product and a sum in one
MODULES = {"cmath", "random", "statistics", "scipy", "numpy.linalg", "numpy.polynomial", "numpy.random", "numpy.fft"}


class Finding(NamedTuple):
    """One place of a source."""

    line: int
    what: str


def findings(source: str) -> list[Finding]:
    """All places of a source that may depend on the machine, in the order of lines."""
    tree = ast.parse(source)
    names = dict(_imported(tree))
    found = [Finding(getattr(node, "lineno", 0), what) for node in ast.walk(tree) for what in _of(node, names)]
    return sorted(set(found))


def _imported(tree: ast.AST) -> Iterator[tuple[str, str]]:
    """Names of modules in a source."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for each in node.names:
                yield each.asname or each.name.partition(".")[0], each.name if each.asname else each.name.partition(".")[0]


def _of(node: ast.AST, names: dict[str, str]) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (each.name for each in node.names if _outside(each.name))
    elif isinstance(node, ast.ImportFrom) and node.level == 0:
        module = node.module or ""
        if _outside(module):
            yield module
        elif module in ("math", "numpy"):
            allowed = MATH if module == "math" else NUMPY
            yield from (f"{module}.{each.name}" for each in node.names if each.name not in allowed)
    elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        module = names.get(node.value.id, "")
        if module == "math" and node.attr not in MATH:
            yield f"math.{node.attr}"
        elif module == "numpy" and node.attr not in NUMPY:
            yield f"numpy.{node.attr}"
    elif isinstance(node, ast.BinOp | ast.AugAssign):
        yield from _of_operator(node)
    elif isinstance(node, ast.Constant) and isinstance(node.value, complex):
        yield "complex"
    elif isinstance(node, ast.Call):
        yield from _of_call(node, names)


def _outside(module: str) -> bool:
    return any(module == each or module.startswith(f"{each}.") for each in MODULES)


def _of_operator(node: ast.BinOp | ast.AugAssign) -> Iterator[str]:
    if isinstance(node.op, ast.MatMult):
        yield "@"
    elif isinstance(node.op, ast.Pow):
        parts = (node.left, node.right) if isinstance(node, ast.BinOp) else (node.target, node.value)
        if not _is_exact_power(*parts):
            yield "**"


def _is_exact_power(base: ast.AST, exponent: ast.AST) -> bool:
    """Of whole numbers, or a power of two with a whole exponent, all of them written out."""
    if isinstance(exponent, ast.UnaryOp) and isinstance(exponent.op, ast.USub):
        return _is_exact_power(base, exponent.operand) and isinstance(getattr(base, "value", 0), float)
    if not _is_whole(exponent) or not isinstance(base, ast.Constant):
        return False
    return _is_whole(base) or (isinstance(base.value, float) and math.frexp(base.value)[0] == 0.5)


def _is_whole(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, int)


def _of_call(node: ast.Call, names: dict[str, str]) -> Iterator[str]:
    function = node.func
    if isinstance(function, ast.Name):
        if function.id in ("pow", "complex"):
            yield function.id
        elif function.id == "sum" and not _counts(node):
            yield "sum"  # from Python 3.12 on it adds floats with another error
    elif isinstance(function, ast.Attribute):
        module = names.get(function.value.id, "") if isinstance(function.value, ast.Name) else ""
        if function.attr in METHODS and not module:
            yield f".{function.attr}"
        stable = any(each.arg == "kind" and getattr(each.value, "value", "") == "stable" for each in node.keywords)
        if function.attr == "argsort" and not stable:
            yield "argsort"  # equal ones come in an order of the processor's vectors
        fractions = any(isinstance(part, ast.Constant) and part.value != int(part.value) for part in _numbers(node))
        if module == "numpy" and function.attr == "arange" and fractions:
            yield "arange"  # start + i step, which a compiler may fuse


def _numbers(node: ast.Call) -> list[ast.Constant]:
    return [part for part in ast.walk(node) if isinstance(part, ast.Constant) and isinstance(part.value, float)]


def _counts(node: ast.Call) -> bool:
    """Whether a sum is of whole numbers for certain: of ones, lengths or comparisons."""
    if not node.args or not isinstance(node.args[0], ast.GeneratorExp | ast.ListComp):
        return False
    element = node.args[0].elt
    if isinstance(element, ast.Call) and isinstance(element.func, ast.Name):
        return element.func.id in ("len", "int", "bool", "isinstance")
    return (
        _is_whole(element)
        or isinstance(element, ast.Compare)
        or (isinstance(element, ast.UnaryOp) and isinstance(element.op, ast.Not))
    )
