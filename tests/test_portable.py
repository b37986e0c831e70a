"""No source between a scenario and the results of its motion has an operation that rounds otherwise elsewhere.

Ruff knows the names of those functions (pyproject.toml); here are operators, built-in functions and methods.
"""

import ast
import re

from checkout import ROOT

PACKAGE = ROOT / "src" / "hophoop"
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


# Powers of whole numbers, and of 2.
EXACT = re.compile(r"2\.0 \*\* \(?-?\d+\)?|\d+ \*\* \d+")
BUILT_IN = {"pow", "complex", "sum"}
METHODS = {"dot", "std", "var", "argsort"}  # sorting orders equal keys by the processor's vectors


def finding(node):
    """What of a node depends on the machine, or nothing."""
    if isinstance(node, ast.BinOp | ast.AugAssign):
        exact = EXACT.fullmatch(ast.unparse(node))
        return "@" if isinstance(node.op, ast.MatMult) else "**" if isinstance(node.op, ast.Pow) and not exact else ""
    if isinstance(node, ast.Constant):
        return "complex" if isinstance(node.value, complex) else ""
    if not isinstance(node, ast.Call):
        return ""
    if isinstance(node.func, ast.Name):
        return node.func.id if node.func.id in BUILT_IN else ""
    name = getattr(node.func, "attr", "")
    fractions = any(isinstance(part, ast.Constant) and isinstance(part.value, float) for part in ast.walk(node))
    return name if name in METHODS or (name == "arange" and fractions) else ""  # start + i step may be fused


def findings(source):
    """Lines of a source and what they do that may depend on the machine."""
    return sorted({(node.lineno, what) for node in ast.walk(ast.parse(source)) if (what := finding(node))})


def test_nothing_depends_on_the_machine():
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
