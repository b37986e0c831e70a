"""LLVM code of kernels and of the library's entries, by Numba: each kernel once for its types of arguments, for any machine.

The code of a kernel is kept. It is made again if the kernel itself has changed, or the type of what a callee gives. Callers and
callees are joined later. So a change of one kernel compiles this one kernel.
"""

from __future__ import annotations

import hashlib
import inspect
import pickle
import re
from collections.abc import Callable, Iterable
from types import FunctionType
from typing import Any, NamedTuple

import llvmlite.binding as llvm
import numba
from llvmlite import ir
from numba import types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin

from hophoop.kernel.build.kept import keep, kept
from hophoop.kernel.entries import ENTRIES, Array, class_of, description, is_tuple, kernel_named, kinds_of
from hophoop.kernel.native.marks import mark_of, replaced, source_of
from hophoop.kernel.native.sources import TOOLS, called, hash_of, is_kernel, name_of, own_hash, used

COUNTING = re.compile(r"^ +call void @NRT_(?:incref|decref)\(.*\n", re.MULTILINE)
# Numba's pickled messages, which contain the places of its sources; a caller reads the status alone
MESSAGE = re.compile(r'^(@\.const\.pickledata\S* = internal constant \[\d+ x i8\]) c".*"', re.MULTILINE)
VERSIONS = f"{numba.__version__} {llvm.llvm_version_info} {hash_of({}, TOOLS[:1])}"
UNPREPARED = "Kernels are lowered after build.processes.begin: in Numba's optimized code references would be counted wrongly."


class Part(NamedTuple):
    """The code of a kernel for some types of arguments.

    Attributes
    ----------
    symbol : str
    result : numba type
    allocates : bool
        True if it or a callee creates arrays.
    calls : dict
        Symbol of each callee → its name, the types of its arguments, and what it gave when this part was compiled.
    code : bytes
        LLVM's bitcode of the function.
    simple : bytes
        The same for machines of 64 bits, with its variables in registers: smaller, so all later steps take half the time.
    """

    symbol: str
    result: Any
    allocates: bool
    calls: dict[str, tuple[str, tuple[Any, ...], str]]
    code: bytes
    simple: bytes

    def gives(self) -> str:
        """Return all of it that the code of its callers depends on."""
        return f"{_described(self.result)} {self.allocates}"


def copied(kernel: Any, replacement: Callable[[Any], Any]) -> FunctionType:
    """Return a copy of a kernel's function that calls replacements of its callees."""
    function = source_of(kernel)
    names = {name: replacement(value) if is_kernel(value) else value for name, value in used(kernel)}
    return FunctionType(function.__code__, names | {"__name__": function.__module__}, None, function.__defaults__)


def _described(kind: Any) -> str:
    fields = [_described(each) for each in kind.types] if isinstance(kind, types.BaseTuple) else ""
    return f"{kind} {getattr(kind, 'fields', '')} {fields}"


_parts: dict[str, Part] = {}


def part_of(kernel: Any, kinds: tuple[Any, ...]) -> Part:
    """Return the code of a kernel for these types of arguments."""
    described = " ".join(map(_described, kinds))
    symbol = f"{name_of(kernel)}.{hashlib.sha256(described.encode()).hexdigest()[:16]}"
    if symbol not in _parts:
        key = hashlib.sha256(f"{VERSIONS} {own_hash(kernel)}".encode()).hexdigest()[:16]
        _parts[symbol] = _kept(kernel, f"{symbol}.{key}") or _compiled(kernel, kinds, symbol, key)
        llvm.add_symbol(symbol, 1)  # Numba's own machine code, which nobody runs, may call it
    return _parts[symbol]


def _kept(kernel: Any, name: str) -> Part | None:
    """Return a kernel's part of an earlier build, unless a callee gives something else now."""
    content = kept(name)
    if content is None:
        return None
    try:
        part: Part = pickle.loads(content)
    except Exception:  # one with a type that has moved: pickle raises anything
        return None
    callees = {name_of(callee): callee for callee in called(kernel)}  # a generated tangent is no attribute of its module
    current = all(part_of(callees[name], kinds).gives() == expected for name, kinds, expected in part.calls.values())
    return part if current else None


def _compiled(kernel: Any, kinds: tuple[Any, ...], symbol: str, key: str) -> Part:
    """Compile a kernel, and keep its code."""
    if numba.config.OPT:
        raise RuntimeError(UNPREPARED)
    callees: dict[str, tuple[Any, tuple[Any, ...], Part]] = {}
    function = copied(kernel, lambda callee: _call_of(callee, callees))
    made = numba.njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)(function)  # noqa: TID251
    made.compile(kinds)
    about = made.overloads[kinds]
    text = MESSAGE.sub(r"\1 zeroinitializer", made.inspect_llvm(kinds).replace(about.fndesc.llvm_func_name, symbol))
    allocates = "@NRT_MemInfo_alloc_aligned" in text or any(part.allocates for _, _, part in callees.values())
    result = about.signature.return_type
    if not allocates and "array(" not in str(result):
        text = COUNTING.sub("", text)  # counting references to the caller's arrays would cost 20 % of the time
    module = llvm.parse_assembly(text)
    for value in (*module.functions, *module.global_variables):
        # Numba's own functions may have the same names in other parts; its runtime is the same everywhere
        if not value.is_declaration and not value.name.lower().startswith("nrt_"):
            value.linkage = "weak_odr" if value.name == symbol else "internal"
    if mark := mark_of(kernel):
        module.get_function(symbol).add_function_attribute(mark)
    calls = {each: (name_of(callee), given, part.gives()) for each, (callee, given, part) in callees.items()}
    code = module.as_bitcode()
    _simplify(module)
    part = Part(symbol, result, allocates, calls, code, module.as_bitcode())
    keep(f"{symbol}.{key}", pickle.dumps(part))
    return part


def _simplify(module: Any) -> None:
    """Move the variables of a module's functions into registers, and fold what is constant."""
    machine = llvm.Target.from_default_triple().create_target_machine()
    builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=1))
    passes = llvm.create_new_function_pass_manager()
    passes.add_sroa_pass()
    passes.add_instruction_combine_pass()
    passes.add_simplify_cfg_pass()
    for function in module.functions:
        if not function.is_declaration:
            passes.run(function, builder)


def _call_of(kernel: Any, callees: dict[str, tuple[Any, tuple[Any, ...], Part]]) -> Any:
    """Return what a caller calls in place of a kernel: Numba types it by the kernel, and writes a call of its symbol."""
    own = inspect.signature(source_of(kernel))

    def typed(typing_context: Any, *given: Any, **named: Any) -> Any:
        passed = own.bind(*given, **named).arguments
        kinds = tuple(
            # Numba would compile a function again for each constant argument
            types.unliteral(passed[name]) if name in passed else types.Omitted(parameter.default)
            for name, parameter in own.parameters.items()
        )
        part = part_of(kernel, kinds)
        callees[part.symbol] = kernel, kinds, part

        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            convention = context.call_conv
            kind = convention.get_function_type(part.result, kinds)
            function = builder.module.globals.get(part.symbol) or ir.Function(builder.module, kind, part.symbol)
            status, value = convention.call_function(builder, function, part.result, kinds, arguments)
            with builder.if_then(status.is_error, likely=False):
                convention.return_status_propagate(builder, status)
            return value

        return part.result(*kinds), generate

    first = inspect.Parameter("typing_context", inspect.Parameter.POSITIONAL_OR_KEYWORD)
    typed.__signature__ = own.replace(parameters=[first, *own.parameters.values()])  # type: ignore[attr-defined]
    typed.__name__ = kernel.__name__
    return intrinsic(typed)


@infer_global(replaced)
class _Replaced(AbstractTemplate):  # type: ignore[misc]
    """Numba's type of a call of `replaced`."""

    def generic(self, given: Any, named: Any) -> Any:
        """Return the signature of a call: the fields have the types that they had."""
        kind = given[0]
        kinds = [kind.types[kind.fields.index(name)] for name in named]
        parameters = [inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD) for name in ("values", *named)]
        return signature(kind, kind, *kinds).replace(pysig=inspect.Signature(parameters))


@lower_builtin(replaced, types.BaseTuple, types.VarArg(types.Any))  # type: ignore[untyped-decorator]
def _store(context: Any, builder: Any, call: Any, arguments: Any) -> Any:
    """Write a call of `replaced`."""
    result, *values = arguments
    for name, value in zip(list(call.pysig.parameters)[1:], values, strict=True):
        result = builder.insert_value(result, value, call.return_type.fields.index(name))
    return result


def exported(name: str, kernel: Any, kinds: tuple[Any, ...], simple: bool) -> bytes:
    """Return the bitcode of a kernel and its callees under a plain name, with pointers, doubles and 32-bit counts."""
    symbol = part_of(kernel, kinds).symbol
    given = [{types.int64: "i32", types.float64: "double"}.get(kind, "ptr") for kind in kinds]
    wide = "".join(f"  %w{i} = zext i32 %a{i} to i64\n" for i, kind in enumerate(given) if kind == "i32")
    passed = [f"i64 %w{i}" if kind == "i32" else f"{kind} %a{i}" for i, kind in enumerate(given)]
    declared = f"declare i32 @{symbol}({', '.join(['ptr', 'ptr', *(word.partition(' ')[0] for word in passed)])})\n"
    head = f"define i32 @{name}({', '.join(f'{kind} %a{i}' for i, kind in enumerate(given))}) {{\n"
    body = f"  %ret = alloca ptr\n  %exc = alloca ptr\n{wide}"
    call = f"  %status = call i32 @{symbol}({', '.join(['ptr %ret', 'ptr %exc', *passed])})\n  ret i32 %status\n}}\n"
    found, waiting = dict[str, bytes](), [symbol]
    while waiting:
        each = waiting.pop()
        part = _parts[each]
        found[each] = part.simple if simple else part.code
        waiting += part.calls.keys() - found.keys()
    return joined([llvm.parse_assembly(declared + head + body + call).as_bitcode(), *(found[each] for each in sorted(found))])


def joined(codes: Iterable[bytes]) -> bytes:
    """Return the bitcode of several modules as that of one."""
    modules = [llvm.parse_bitcode(code) for code in codes]
    while len(modules) > 1:  # by pairs: to join two takes as long as to read both
        for first, second in zip(modules[::2], modules[1::2], strict=False):
            first.link_in(second)
        modules = modules[::2]
    return modules[0].as_bitcode()  # type: ignore[no-any-return]


# --- entries: functions of one address, at which their arguments are stored (`kernel.native.calls`)

MEMORY = types.CPointer(types.float64), types.CPointer(types.int64), types.CPointer(types.voidptr)


def numba_type(kind: Any) -> Any:
    """Return Numba's type of an argument type."""
    if isinstance(kind, Array):
        return types.Array(numba.from_dtype(kind.dtype), kind.dimensions, "C")
    if is_tuple(kind):
        return types.BaseTuple.from_types([numba_type(each) for each in kinds_of(kind)], class_of(kind))
    return {float: types.float64, int: types.int64, bool: types.boolean}[kind]


class _Writer:
    """Writer of the source of an entry, which reads its arguments from memory and writes its results after them."""

    def __init__(self) -> None:
        self.names: dict[str, Any] = {"carray": numba.carray}
        self.place = 0

    def read(self, kind: Any) -> str:
        """Return the expression of an argument."""
        at = self.place
        if isinstance(kind, Array):
            self.place += 1 + kind.dimensions
            self.names[f"dtype{at}"] = kind.dtype
            shape = "".join(f"wholes[{at + 1 + i}], " for i in range(kind.dimensions))
            return f"carray(places[{at}], ({shape}), dtype{at})"
        if is_tuple(kind):
            items = ", ".join(self.read(each) for each in kinds_of(kind))
            self.names[f"class{at}_{self.place}"] = class_of(kind)
            return f"class{at}_{self.place}({items})"
        self.place += 1
        return {float: "reals[{}]", int: "wholes[{}]", bool: "wholes[{}] != 0"}[kind].format(at)

    def write(self, kind: Any, value: str, lines: list[str]) -> Any:
        """Append lines that write a result of Numba's type `kind`; return the description of its type."""
        if isinstance(kind, types.BaseTuple):
            items = [self.write(each, f"{value}[{i}]", lines) for i, each in enumerate(kind.types)]
            made = getattr(kind, "instance_class", None)
            return {"class": made and f"{made.__module__}.{made.__qualname__}", "items": items}
        at = self.place
        self.place += 1
        if isinstance(kind, types.Float):
            lines.append(f"    reals[{at}] = {value}\n")
            return "float"
        lines.append(f"    wholes[{at}] = {value}\n")
        return "bool" if isinstance(kind, types.Boolean) else "int"


def entry(name: str) -> tuple[dict[str, Any], bytes]:
    """Compile an entry; return its description and its bitcode."""
    kernel, kinds = kernel_named(name), ENTRIES[name]
    symbol = "hophoop_" + name.removeprefix("hophoop.").replace(".", "_")
    result = part_of(kernel, tuple(numba_type(kind) for kind in kinds)).result
    writer = _Writer()
    writer.names |= {"__name__": "hophoop.entries", "kernel": kernel}
    arguments = ", ".join(writer.read(kind) for kind in kinds)
    lines: list[str] = []
    gives = None if isinstance(result, types.NoneType) else writer.write(result, "result", lines)
    exec(f"def {symbol}(reals, wholes, places):\n    result = kernel({arguments})\n{''.join(lines)}", writer.names)
    told = {"symbol": symbol, "takes": [description(kind) for kind in kinds], "gives": gives}
    return told, exported(symbol, writer.names[symbol], MEMORY, simple=True)
