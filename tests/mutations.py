"""Signs and factors of the formulas, changed one by one: does a test see it? `python tests/mutations.py [MODULE ...]`.

Each change of one operator (+ and −, · and /, a minus sign left out) of a module in `physics/` is tried on the tests in
`tests/physics`, interpreted (NUMBA_DISABLE_JIT=1). A change that no test sees is printed, and makes the exit status 1,
unless `EXPLAINED` says why nothing can see it. `--all` runs over all modules, `--jobs` sets how many run at a time.
"""

from __future__ import annotations

import argparse
import ast
import contextlib
import importlib.abc
import importlib.util
import io
import os
import signal
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[1]
FORMULAS = ROOT / "src" / "hophoop" / "physics"
SECONDS = 20  # that the tests may take with one change; one that never ends has been seen

SWAPPED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
}
SIGNS = {ast.Add: "+", ast.Sub: "−", ast.Mult: "·", ast.Div: "/"}

# Why a change cannot be seen: by module, function, the line as it stands and what is changed in it.
TOLERANCE = "a tolerance, of which the order counts"
SEARCH = "where a search begins, which finds the same from either"
SAME_SIGN = "a quotient has the sign of the product"
EXPLAINED: dict[tuple[str, str, str, str], str] = {
    ("impact", "singular_slip", "stop = -vt / rate if vt * rate < 0.0 else math.inf", "· → / before rate"): SAME_SIGN,
    (
        "impact",
        "singular_angle",
        "if slope != 0.0 and abs(distance) <= 1e-10 * abs(slope):",
        "· → / before abs(slope)",
    ): TOLERANCE,
    ("compliant", "hunt_crossley_number", "low = 0.5 * pole", "· → / before pole"): SEARCH,
    ("compliant", "static_excess", "high = mu_static - mu_kinetic", "− → + before mu_kinetic"): SEARCH,
    **{
        (
            "impact",
            "singular_angle",
            "near = abs(distance) <= 1e-5 * abs(slope) and opening <= 1e-5 * (body.gn + body.eps * u)",
            f"· → / before {what}",
        ): TOLERANCE
        for what in ("abs(slope)", "body.gn + body.eps * u", "u")
    },
}


class Mutation(NamedTuple):
    """One changed operator."""

    module: str
    function: str
    line: int
    text: str  # the line as it stands
    change: str
    source: str  # of the whole module, changed

    @property
    def key(self) -> tuple[str, str, str, str]:
        """What names it in `EXPLAINED`: stays the same when lines move."""
        return self.module, self.function, self.text, self.change


def _sites(tree: ast.AST) -> Iterator[tuple[str, ast.AST]]:
    """Operators within functions, with the function's name; type hints hold none that count."""
    for function in ast.iter_child_nodes(tree):
        if isinstance(function, ast.FunctionDef):
            for statement in function.body:
                for node in ast.walk(statement):
                    known = isinstance(node, ast.BinOp | ast.AugAssign) and type(node.op) in SWAPPED
                    minus = isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub)
                    if known or (minus and not isinstance(node.operand, ast.Constant)):
                        yield function.name, node


def mutations(path: Path) -> list[Mutation]:
    """All changes of a module."""
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    count = len(list(_sites(ast.parse(text))))
    found = []
    for k in range(count):
        tree = ast.parse(text)
        function, node = list(_sites(tree))[k]
        if isinstance(node, ast.BinOp | ast.AugAssign):
            new = SWAPPED[type(node.op)]
            right = node.right if isinstance(node, ast.BinOp) else node.value
            change = f"{SIGNS[type(node.op)]} → {SIGNS[new]} before {ast.unparse(right)}"
            node.op = new()
        else:
            assert isinstance(node, ast.UnaryOp)
            change = f"no − before {ast.unparse(node.operand)}"
            node.op = ast.UAdd()
        line = node.lineno  # type: ignore[attr-defined]
        found.append(Mutation(path.stem, function, line, lines[line - 1].strip(), change, ast.unparse(tree)))
    return found


class _Changed(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Imports one module with another source."""

    def __init__(self, name: str, source: str) -> None:
        self.name = name
        self.source = source

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        return importlib.util.spec_from_loader(name, self) if name == self.name else None

    def exec_module(self, module: Any) -> None:
        module.__file__ = str(FORMULAS / f"{self.name.rpartition('.')[2]}.py")
        exec(compile(self.source, module.__file__, "exec"), module.__dict__)


def _tests(module: str) -> list[str]:
    """The tests of formulas, those of the module first."""
    files = sorted((ROOT / "tests" / "physics").glob("test_*.py"))
    return [str(path) for path in sorted(files, key=lambda path: path.stem != f"test_{module}")]


def _seen(mutation: Mutation) -> int:
    """In a process of its own: the exit status of the tests with the change; 0 where none sees it."""
    import pytest

    signal.alarm(SECONDS)
    sys.meta_path.insert(0, _Changed(f"hophoop.physics.{mutation.module}", mutation.source))
    words = ["-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:randomly", *_tests(mutation.module)]
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        return int(pytest.main(words))


def survivors(wanted: list[Mutation], jobs: int) -> list[Mutation]:
    """The changes that no test sees."""
    waiting = list(reversed(wanted))
    running: dict[int, Mutation] = {}
    unseen = []
    while waiting or running:
        while waiting and len(running) < jobs:
            mutation = waiting.pop()
            child = os.fork()
            if child == 0:
                status = 1
                with contextlib.suppress(BaseException):
                    status = _seen(mutation)
                os._exit(min(status, 9))
            running[child] = mutation
        child, status = os.wait()
        mutation = running.pop(child)
        if status == 0:
            unseen.append(mutation)
    return sorted(unseen, key=lambda one: (one.module, one.line))


def main() -> int:
    """Try the changes and print the score of each module."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("modules", nargs="*", help="such as contact; all by default")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="how many at a time")
    options = parser.parse_args()
    os.environ["NUMBA_DISABLE_JIT"] = "1"
    os.environ["CI"] = "1"  # the same examples every time
    os.chdir(ROOT)
    sys.path[:0] = [str(ROOT / "src"), str(ROOT / "tests")]
    # what takes long to import, once for all processes; hophoop itself is imported in each
    for name in ("pytest", "numpy", "scipy.integrate", "scipy.optimize", "mpmath", "sympy", "hypothesis", "pydantic"):
        importlib.import_module(name)
    paths = sorted(path for path in FORMULAS.glob("*.py") if path.stem != "__init__")
    total = seen = told = 0
    for path in paths:
        if options.modules and path.stem not in options.modules:
            continue
        began = time.monotonic()
        tried = mutations(path)
        if not tried:
            continue
        unseen = survivors(tried, options.jobs)
        explained = [one for one in unseen if one.key in EXPLAINED]
        total, seen, told = total + len(tried), seen + len(tried) - len(unseen), told + len(explained)
        print(
            f"{path.stem:12} {len(tried):4} changes, {len(tried) - len(unseen):4} seen, {len(explained):3} explained, "
            f"{len(unseen) - len(explained):3} not seen ({time.monotonic() - began:.0f} s)",
            flush=True,
        )
        for one in unseen:
            if one.key not in EXPLAINED:
                print(f"    {path.name}:{one.line} in {one.function}: {one.change}\n        {one.text}", flush=True)
    if total:
        print(f"{seen} of {total} changes are seen ({100.0 * seen / total:.1f} %), {told} more are explained.")
    return 0 if seen + told == total else 1


if __name__ == "__main__":
    raise SystemExit(main())
