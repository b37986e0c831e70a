"""No source between a scenario and the results of its motion has an operation that rounds otherwise elsewhere.

Ruff knows the names of those functions (pyproject.toml); here are operators, built-in functions and methods.
"""

from __future__ import annotations

import ast
import math
from pathlib import Path

PACKAGE = Path(__file__).parents[1] / "src" / "hophoop"
# From the numbers of a scenario to all that reads, maps or writes its motion.
COVERED = (
    "kernel/numerics", "kernel/physics", "kernel/panels", "kernel/records", "kernel/rigid", "kernel/compliant",
    "scenario", "precise", "derivatives", "theory", "maps", "lab/wasm", "results/records.py", "results/units.py",
    "results/poses.py", "results/save.py", "simulation", "_support/fingerprint.py",
)  # fmt: skip
# File or folder → what it does that is the same everywhere there.
ALLOWED = {
    "kernel/numerics/circular.py": {"**"},  # powers of −1 and of 2
    "kernel/compliant/radau.py": {"complex"},  # whose products and quotients are written out
    "maps/grid": {"sum"},  # whole numbers
    "precise": {"**", "sum"},  # integers, fractions and numbers of mpmath
    "simulation/precise_until.py": {"**"},  # of ten, in mpmath
}


def is_whole(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, int)


def is_exact_power(base: ast.AST, exponent: ast.AST) -> bool:
    """Of whole numbers, or a power of two with a whole exponent, all of them written out."""
    if isinstance(exponent, ast.UnaryOp) and isinstance(exponent.op, ast.USub):
        return is_exact_power(base, exponent.operand) and isinstance(getattr(base, "value", 0), float)
    if not is_whole(exponent) or not isinstance(base, ast.Constant):
        return False
    return is_whole(base) or (isinstance(base.value, float) and math.frexp(base.value)[0] == 0.5)


def counts(call: ast.Call) -> bool:
    """Whether a sum is of whole numbers for certain: of ones, lengths or comparisons."""
    element = getattr(call.args[0], "elt", None) if call.args else None
    name = getattr(getattr(element, "func", None), "id", "")
    return name in ("len", "int", "bool", "isinstance") or isinstance(element, ast.Compare) or is_whole(element)


def finding(node: ast.AST) -> str:
    """What of a node depends on the machine, or nothing."""
    if isinstance(node, ast.BinOp | ast.AugAssign):
        parts = (node.left, node.right) if isinstance(node, ast.BinOp) else (node.target, node.value)
        if isinstance(node.op, ast.MatMult):
            return "@"
        return "**" if isinstance(node.op, ast.Pow) and not is_exact_power(*parts) else ""
    if isinstance(node, ast.Constant):
        return "complex" if isinstance(node.value, complex) else ""
    if not isinstance(node, ast.Call):
        return ""
    name = getattr(node.func, "id", getattr(node.func, "attr", ""))
    if isinstance(node.func, ast.Name):
        return name if name in ("pow", "complex") or (name == "sum" and not counts(node)) else ""
    numbers = [part.value for part in ast.walk(node) if isinstance(part, ast.Constant) and isinstance(part.value, float)]
    stable = any(each.arg == "kind" and getattr(each.value, "value", "") == "stable" for each in node.keywords)
    # equal keys come in an order of the processor's vectors; start + i step may be fused
    loose = (name == "argsort" and not stable) or (name == "arange" and any(value % 1.0 for value in numbers))
    return name if name in ("dot", "std", "var") or loose else ""


def findings(source: str) -> list[tuple[int, str]]:
    """Lines of a source and what they do that may depend on the machine."""
    return sorted({(node.lineno, what) for node in ast.walk(ast.parse(source)) if (what := finding(node))})


WRONG = {
    "y = np.argsort(keys)": "argsort", "y = keys.argsort()": "argsort", "y = np.arange(0.0, 1.0, 0.1)": "arange",
    "y = a.dot(b)": "dot", "y = a @ b": "@", "y @= b": "@", "y = x**2": "**", "y = 0.5**k": "**", "y = 10.0**-3": "**",
    "y = 2.0**0.5": "**", "x **= 3": "**", "y = pow(x, 3)": "pow", "y = sum(losses)": "sum",
    "y = sum(x * x for x in row)": "sum", "y = complex(a, b)": "complex", "y = 0.0j": "complex",
}  # fmt: skip
RIGHT = """
y = math.sqrt(x) + np.sum(a) + a.sum() + row.dot + np.argsort(keys, kind='stable') + np.arange(26.0, 0.0, -1.0)
y = 2**53 + 2.0**-30 + 0.25**3 + sum(1 for x in row) + sum(len(x) for x in row) + sum(x > 0.0 for x in row)
"""


def test_nothing_depends_on_the_machine() -> None:
    found, used = [], set()
    for name in COVERED:
        path = PACKAGE / name
        assert path.exists(), name
        for file in [path] if path.is_file() else sorted(path.rglob("*.py")):
            place = file.relative_to(PACKAGE).as_posix()
            for line, what in findings(file.read_text(encoding="utf-8")):
                allowed = {(where, what) for where, kinds in ALLOWED.items() if place.startswith(where) and what in kinds}
                used |= allowed
                if not allowed:
                    found.append(f"{place}:{line}: {what}")
    assert found == []
    assert used == {(place, what) for place, kinds in ALLOWED.items() for what in kinds}  # each is still needed


def test_what_depends_on_the_machine_is_found() -> None:
    assert {source: [what for _, what in findings(source)] for source in WRONG} == {one: [what] for one, what in WRONG.items()}
    assert findings(RIGHT) == []
    assert findings("\n\ny = x**2\n") == [(3, "**")]
