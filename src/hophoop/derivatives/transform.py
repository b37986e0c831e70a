"""Derivatives of kernels in forward mode, by transformation of their source.

`tangent_of` writes a kernel's source again, with a statement for the tangent before each statement for a value. Values keep
their operations, and so their bits; the branch taken is that of the values. The build compiles the result like any kernel.
A traceback or a debugger shows the generated lines; `inspect.getsource` prints them.
"""

from __future__ import annotations

import ast
import inspect
import linecache
import math
from collections.abc import Callable, Iterable
from functools import cache
from typing import Any

from hophoop.derivatives.rules import RULES
from hophoop.kernel.native.marks import MARK, mark_of, source_of
from hophoop.kernel.native.sources import is_kernel

Pair = tuple[str, str | None]  # the text of a value and that of its tangent, None where it is zero

CONSTANT = (math.isinf, math.isnan, math.floor, int, float)  # functions without a tangent


@cache
def tangent_of(kernel: Callable[..., Any], *changing: str) -> Callable[..., Any]:
    """Return the kernel that computes another kernel's result and its tangent.

    Parameters
    ----------
    kernel : callable
        Function of floats and named tuples.
    *changing : str
        The arguments that change: `s`, or all fields of `body`.

    Returns
    -------
    tangent : callable
        Takes the kernel's arguments, then the tangents of those that change; returns (result, its tangent).
    """
    source = source_of(kernel)
    names = dict(source.__globals__)
    definition = ast.parse(inspect.getsource(source)).body[0]
    assert isinstance(definition, ast.FunctionDef)
    text = _Writer(names, definition, changing).text()
    file = f"<tangent of {source.__module__}.{source.__qualname__} by {', '.join(changing)}>"
    linecache.cache[file] = len(text), None, text.splitlines(keepends=True), file
    exec(compile(text, file, "exec"), names)
    made: Callable[..., Any] = names[_name_of(definition.name, changing)]
    setattr(made, MARK, mark_of(kernel))
    return made


def _tangent(name: str) -> str:
    """Return the name of the tangent of an argument or a local variable."""
    return f"d_{name}"


def _name_of(kernel: str, changing: Iterable[str]) -> str:
    return f"{_tangent(kernel)}_by_{'_'.join(changing)}"


def _names_in(node: ast.AST) -> set[str]:
    return {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}


class _Writer:
    """Writes the tangent of one kernel.

    Parameters
    ----------
    names : dict
        Global names of the kernel; those of generated kernels are added.
    definition : ast.FunctionDef
    changing : tuple of str
        As `tangent_of` takes them.
    """

    def __init__(self, names: dict[str, Any], definition: ast.FunctionDef, changing: tuple[str, ...]) -> None:
        self.names, self.definition, self.changing = names, definition, changing
        self.moving = self._moving()
        self.lines: list[str] = []
        self.indent = "    "
        self.count = 0

    def text(self) -> str:
        """Return the source of the tangent."""
        arguments = [argument.arg for argument in self.definition.args.args]
        for name in arguments:
            if name in self.moving and name not in self.changing:  # changes later
                self._write(f"{_tangent(name)} = 0.0")
        self._block(self.definition.body)
        given = ", ".join([*arguments, *map(_tangent, self.changing)])
        return "\n".join([f"def {_name_of(self.definition.name, self.changing)}({given}):", *self.lines, ""])

    def _moving(self) -> set[str]:
        """Return the local names that have a tangent somewhere."""
        moving = set(self.changing)
        while True:
            found = set(moving)
            for node in ast.walk(self.definition):
                if isinstance(node, ast.Assign) and _names_in(node.value) & moving:
                    found.update(*map(_names_in, node.targets))
                elif isinstance(node, ast.AugAssign) and _names_in(node.value) & moving:
                    found |= _names_in(node.target)
            if found == moving:
                return moving
            moving = found

    def _refusal(self, node: ast.AST) -> NotImplementedError:
        return NotImplementedError(
            f"{self.definition.name}: hophoop.derivatives.transform has no derivative of `{ast.unparse(node)}`; "
            "write it in terms that it has, or give its function a rule in hophoop.derivatives.rules."
        )

    # --- statements

    def _write(self, line: str) -> None:
        self.lines.append(self.indent + line)

    def _block(self, statements: list[ast.stmt]) -> None:
        for statement in statements:
            self._statement(statement)

    def _inner(self, head: str, statements: list[ast.stmt]) -> None:
        self._write(head)
        self.indent += "    "
        self._block(statements)
        self.indent = self.indent[4:]

    def _statement(self, node: ast.stmt) -> None:
        match node:
            case ast.Expr(value=ast.Constant()):
                pass  # the docstring
            case ast.Assign():
                for target in node.targets:
                    self._assign(target, node.value)
            case ast.AugAssign(target=ast.Name(id=name)):
                self._assign(node.target, ast.BinOp(ast.Name(name), node.op, node.value))
            case ast.Return(value=ast.expr() as result):
                value, tangent = self._pair(result)
                self._write(f"return {value}, {tangent or '0.0'}")
            case ast.If():
                self._inner(f"if {ast.unparse(node.test)}:", node.body)
                if node.orelse:
                    self._inner("else:", node.orelse)
            case ast.For():
                self._inner(f"for {ast.unparse(node.target)} in {ast.unparse(node.iter)}:", node.body)
            case ast.Break() | ast.Continue():
                self._write(ast.unparse(node))
            case _:
                raise self._refusal(node)

    def _assign(self, target: ast.expr, value: ast.expr) -> None:
        text, tangent = self._pair(value)
        named = target.elts if isinstance(target, ast.Tuple) else [target]
        if any(isinstance(each, ast.Name) and each.id in self.moving for each in named):
            tangents = ", ".join(_tangent(ast.unparse(each)) for each in named)
            self._write(f"{tangents} = {tangent or ', '.join(['0.0'] * len(named))}")
        self._write(f"{ast.unparse(target)} = {text}")

    # --- expressions; what is needed more than once is written into statements before

    def _keep(self, value: str) -> str:
        """Write a value into a new name; return the name."""
        self.count += 1
        name = f"v{self.count}_"
        self._write(f"{name} = {value}")
        return name

    def _pair(self, node: ast.expr) -> Pair:
        match node:
            case ast.Constant() | ast.Compare() | ast.BoolOp() | ast.UnaryOp(op=ast.Not()):
                return f"({ast.unparse(node)})", None
            case ast.Name(id=name):
                return name, _tangent(name) if name in self.moving else None
            case ast.Attribute(value=ast.Name(id=name)):
                return ast.unparse(node), f"{_tangent(name)}.{node.attr}" if name in self.moving else None
            case ast.Subscript():
                value, tangent = self._pair(node.value)
                place = ast.unparse(node.slice)
                return f"{value}[{place}]", tangent and f"{tangent}[{place}]"
            case ast.UnaryOp(op=ast.USub()):
                value, tangent = self._pair(node.operand)
                return f"(-{value})", tangent and f"(-{tangent})"
            case ast.BinOp():
                return self._binary(node)
            case ast.Tuple():
                pairs = [self._pair(each) for each in node.elts]
                tangents = ", ".join(tangent or "0.0" for _, tangent in pairs)
                return f"({', '.join(value for value, _ in pairs)},)", f"({tangents},)"
            case ast.IfExp():
                return self._choice(node)
            case ast.Call():
                return self._call(node)
        raise self._refusal(node)

    def _binary(self, node: ast.BinOp) -> Pair:
        a, da = self._pair(node.left)
        b, db = self._pair(node.right)
        match node.op:
            case ast.Add():
                return f"({a} + {b})", f"({da} + {db})" if da and db else da or db
            case ast.Sub():
                return f"({a} - {b})", f"({da} - {db})" if da and db else da or (db and f"(-{db})")
            case ast.Mult():
                terms = [f"{da} * {b}"] * bool(da) + [f"{a} * {db}"] * bool(db)
                return f"({a} * {b})", f"({' + '.join(terms)})" if terms else None
            case ast.Div() if db:
                quotient = self._keep(f"{a} / {b}")
                return quotient, f"(({da + ' - ' if da else '-'}{quotient} * {db}) / {b})"
            case ast.Div():
                return f"({a} / {b})", da and f"({da} / {b})"
        raise self._refusal(node)

    def _choice(self, node: ast.IfExp) -> Pair:
        """A conditional expression, as a branch."""
        self.count += 1
        name = f"v{self.count}_"
        if _names_in(node) & self.moving:
            self.moving.add(name)
        for head, value in ((f"if {ast.unparse(node.test)}:", node.body), ("else:", node.orelse)):
            self._inner(head, [ast.Assign([ast.Name(name)], value)])
        return self._pair(ast.Name(name))

    def _call(self, node: ast.Call) -> Pair:
        called = ast.unparse(node.func)
        values = [self._pair(argument) for argument in node.args]
        plain = f"{called}({', '.join(value for value, _ in values)})"
        function = eval(called, self.names)
        if function in CONSTANT:
            return plain, None
        own = inspect.signature(source_of(function)).parameters if is_kernel(function) else map(str, range(len(values)))
        tangents = {name: tangent for name, (_, tangent) in zip(own, values, strict=False) if tangent}
        if not tangents:
            return plain, None
        if function in RULES:
            made = RULES[function]
            given = [tangent or "0.0" for _, tangent in values]
        else:
            made = tangent_of(function, *tangents)
            given = list(tangents.values())
        self.names[made.__name__] = made
        both = self._keep(f"{made.__name__}({', '.join([*(value for value, _ in values), *given])})")
        return f"{both}[0]", f"{both}[1]"
