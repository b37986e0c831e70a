"""Changes of a module that a test should see, made by the operators of Cosmic Ray."""

from __future__ import annotations

import ast
import contextlib
import itertools
from collections import Counter
from collections.abc import Collection, Iterator
from pathlib import Path
from types import CodeType
from typing import Any, NamedTuple

SOURCE = Path(__file__).parents[1] / "src" / "hophoop"

# Each operator of Cosmic Ray that is used; all pairs of operators would only say the same more often.
OPERATORS = (
    *(f"ReplaceBinaryOperator_{pair}" for pair in ("Add_Sub", "Sub_Add", "Mul_Div", "Div_Mul", "FloorDiv_Mul", "Mod_Add")),
    *(f"ReplaceBinaryOperator_{pair}" for pair in ("Pow_Mul", "BitOr_BitAnd", "BitAnd_BitOr")),
    *(f"ReplaceComparisonOperator_{pair}" for pair in ("Lt_LtE", "Lt_GtE", "LtE_Lt", "LtE_Gt", "Gt_GtE", "Gt_LtE")),
    *(f"ReplaceComparisonOperator_{pair}" for pair in ("GtE_Gt", "GtE_Lt", "Eq_NotEq", "NotEq_Eq", "Is_IsNot", "IsNot_Is")),
    "ReplaceUnaryOperator_USub_UAdd",
    "ReplaceUnaryOperator_Delete_Not",
    "AddNot",
    "ReplaceTrueWithFalse",
    "ReplaceFalseWithTrue",
    "ReplaceAndWithOr",
    "ReplaceOrWithAnd",
    "ReplaceBreakWithContinue",
    "ReplaceContinueWithBreak",
    "ExceptionReplacer",
    "NumberReplacer",
    "ZeroIterationForLoop",
)


class Key(NamedTuple):
    """The name of a change where it is explained: it stays the same when the line moves, is formatted or has other names."""

    module: str  # its path below src/hophoop, without .py
    function: str
    operator: str  # of Cosmic Ray, such as "Lt_LtE"
    ordinal: int  # among the operator's changes of the function, from 1


class Mutant(NamedTuple):
    """One change of a module."""

    path: Path
    function: str  # the outermost function or method that it is in, "" outside of any
    line: int
    operator: str
    ordinal: int
    text: str  # the line as it stands
    changed: str  # the line as it is with the change
    source: str  # of the whole module, changed

    @property
    def key(self) -> Key:
        """What names it where it is explained."""
        return Key(module_of(self.path), self.function, self.operator, self.ordinal)


def module_of(path: Path) -> str:
    """The path of a module below src/hophoop, without .py."""
    return path.relative_to(SOURCE).with_suffix("").as_posix()


def mutants(path: Path, chosen: Collection[tuple[str, str]] | None = None) -> list[Mutant]:
    """All changes of a module that change what it does, in the order of its lines; or those of some functions and operators.

    `chosen` has their names as a mutant has them. There may be some more.
    """
    from cosmic_ray.ast import get_ast
    from cosmic_ray.mutating import mutate_code
    from cosmic_ray.plugins import get_operator

    text = path.read_text(encoding="utf-8")
    places = functions(text)
    found = []
    ordinals: Counter[tuple[str, str]] = Counter()
    before = ""
    # one statement of the module at a time: to parse it all for each change takes long
    for child in get_ast(text).children:
        chunk = child.get_code()
        after = text[len(before) + len(chunk) :]
        first = before.count("\n") + 1
        here = {places.get(line, "") for line in range(first, first + chunk.count("\n") + 1)}
        for name in OPERATORS:
            operator = name.rpartition("Operator_")[2]
            if chosen is not None and not any((function, operator) in chosen for function in here):
                continue
            for changed in _changes(chunk, get_operator(f"core/{name}")(), get_ast, mutate_code):
                found.append(_mutant(path, text, before + changed + after, places, operator, ordinals))
        before += chunk
    return sorted(found, key=lambda one: one.line)


def _changes(chunk: str, operator: Any, get_ast: Any, mutate_code: Any) -> Iterator[str]:
    """What an operator makes of some statements, where that means something else."""
    count = sum(len(list(operator.mutation_positions(node))) for node in _nodes(get_ast(chunk)))
    plain = _meaning(chunk) if count else ""
    for k in range(count):
        changed = mutate_code(chunk, operator, k)
        with contextlib.suppress(SyntaxError):
            if changed is not None and _meaning(changed) != plain:
                yield changed


def _mutant(
    path: Path, text: str, source: str, places: dict[int, str], operator: str, ordinals: Counter[tuple[str, str]]
) -> Mutant:
    # what stands on one line for us may stand on several for Python
    line = next(
        i for i, pair in enumerate(itertools.zip_longest(text.split("\n"), source.split("\n")), 1) if len(set(pair)) > 1
    )
    before, after = text.split("\n")[line - 1], source.split("\n")[line - 1]
    function = places.get(line, "")
    ordinals[function, operator] += 1
    ordinal = ordinals[function, operator]
    return Mutant(path, function, line, operator, ordinal, before.strip(), " ".join(after.split()), source)


def _nodes(node: Any) -> Iterator[Any]:
    yield node
    for child in getattr(node, "children", ()):
        yield from _nodes(child)


def _meaning(source: str) -> str:
    """The syntax tree without type hints, which nothing reads, and decorators, which only ask for a compiler."""
    tree = ast.parse(source)
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            node.returns = None
            for argument in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs):
                argument.annotation = None
        if (
            isinstance(node, ast.If)
            and isinstance(node.test, ast.Name | ast.UnaryOp)
            and "TYPE_CHECKING" in ast.unparse(node.test)
        ):
            node.test, node.body = ast.Constant(False), [ast.Pass()]
    return ast.dump(tree)


def functions(source: str) -> dict[int, str]:
    """For each line within a function's body, the qualified name of the outermost one."""
    places: dict[int, str] = {}

    def walk(node: ast.AST, prefix: str) -> None:
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.FunctionDef):
                # decorators and defaults are computed where the function is made
                for line in range(child.body[0].lineno, (child.end_lineno or 0) + 1):
                    places[line] = prefix + child.name
            elif isinstance(child, ast.ClassDef):
                walk(child, f"{prefix}{child.name}.")
            elif isinstance(child, ast.If | ast.Try | ast.With):
                walk(child, prefix)

    walk(ast.parse(source), "")
    return places


def codes(code: CodeType) -> dict[str, CodeType]:
    """Code objects of functions and methods by their qualified names."""
    found = {}
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            found[constant.co_qualname] = constant
            if "<locals>" not in constant.co_qualname:
                found |= codes(constant)
    return found
