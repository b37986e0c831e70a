"""While kernels are compiled, parts of Numba are replaced by quicker ones that say the same."""

import contextlib
import gc
import operator

import llvmlite.ir
import numba
import pytest
from numba import types
from numba.core import compiler, event, ir
from numba.core.cpu import CPUContext
from numba.core.registry import cpu_target
from numba.core.targetconfig import TargetConfig
from numba.core.types.functions import BaseFunction
from numba.core.typing import Context

from hophoop._jit import quicker

PLACES = [
    (event, "install_timer"),
    (event, "start_event"),
    (event, "end_event"),
    (BaseFunction, "get_call_type"),
    (CPUContext, "load_additional_registries"),
    (Context, "load_additional_registries"),
    (CPUContext, "get_abi_sizeof"),
    (TargetConfig, "values"),
    (ir.Inst, "_rec_list_vars"),
]


def test_all_is_as_before_once_it_has_failed():
    before = [getattr(owner, name) for owner, name in PLACES]
    with contextlib.suppress(ZeroDivisionError), quicker.compiling():
        assert not gc.isenabled()
        assert all(getattr(owner, name) is not was for (owner, name), was in zip(PLACES, before, strict=True))
        raise ZeroDivisionError
    assert gc.isenabled()
    assert [getattr(owner, name) for owner, name in PLACES] == before


def test_the_same_values_of_options():
    flags = compiler.Flags()
    flags.nrt, flags.error_model = True, "numpy"
    for options in (flags, compiler.Flags()):
        expected = options.values()
        with quicker.compiling():
            assert options.values() == expected
    with quicker.compiling():
        assert flags != compiler.Flags()
        assert flags == flags.copy()


def branching(a, b, *, kept=2.0):
    pair = (a, [b, kept], {"sum": a + b})
    for k in range(3):
        if a[k] > b:
            a[k : k + 1] = kept
    return pair[0].sum() if a is not None else pair


def test_the_same_variables_of_every_instruction():
    def listed():
        made = compiler.run_frontend(branching)
        return [
            (str(statement), [variable.name for variable in statement.list_vars()])
            for block in made.blocks.values()
            for statement in block.body
        ]

    expected = listed()
    assert sum(len(names) for _, names in expected) > 50
    with quicker.compiling():
        assert listed() == expected


def test_events_are_told_to_those_who_listen():
    with quicker.compiling(), event.install_recorder("numba:compile") as recorder:
        event.start_event("numba:run_pass")
        event.end_event("numba:run_pass")
        with event.trigger_event("numba:compile", {"told": 1}):
            pass
    assert [(one.status, one.data) for _, one in recorder.buffer] == [
        (event.EventStatus.START, {"told": 1}),
        (event.EventStatus.END, {"told": 1}),
    ]


def test_registries_are_loaded_once(monkeypatch):
    asked = []
    monkeypatch.setattr(CPUContext, "load_additional_registries", lambda self: asked.append(self))
    with quicker.compiling():
        for _ in range(3):
            cpu_target.target_context.refresh()
    assert asked == [cpu_target.target_context]
    cpu_target.target_context.refresh()
    assert len(asked) == 2


def test_builtins_are_asked_once_for_each_kind_of_arguments(monkeypatch):
    asked = []
    found = BaseFunction.get_call_type

    def counting(self, context, arguments, keywords):
        asked.append(arguments)
        return found(self, context, arguments, keywords)

    monkeypatch.setattr(BaseFunction, "get_call_type", counting)
    context = cpu_target.typing_context
    context.refresh()
    plus = context.resolve_value_type(operator.add)
    kinds = [(types.float64, types.float64), (types.int64, types.float64), (types.literal(2), types.int64)]
    expected = [context.resolve_function_type(plus, kind, {}) for kind in kinds]
    asked.clear()
    with quicker.compiling():
        for _ in range(3):
            assert [context.resolve_function_type(plus, kind, {}) for kind in kinds] == expected
        assert len(asked) == len(kinds)
        with pytest.raises(numba.errors.TypingError):
            context.resolve_function_type(plus, (types.float64, types.unicode_type), {})


def test_types_are_measured_once(monkeypatch):
    asked = []
    size = CPUContext.get_abi_sizeof

    def counting(self, ty):
        asked.append(ty)
        return size(self, ty)

    monkeypatch.setattr(CPUContext, "get_abi_sizeof", counting)
    pair = llvmlite.ir.LiteralStructType([llvmlite.ir.IntType(8), llvmlite.ir.DoubleType()])
    kinds = [llvmlite.ir.DoubleType(), llvmlite.ir.IntType(1), pair, llvmlite.ir.ArrayType(pair, 3), pair.as_pointer()]
    context = cpu_target.target_context
    with quicker.compiling():
        for _ in range(3):
            assert [context.get_abi_sizeof(kind) for kind in kinds] == [8, 1, 16, 48, 8]
    assert asked == kinds
