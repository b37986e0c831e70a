"""The decorators of the kernels: interpreted until compiled code is there, or worth its wait (see `policy`)."""

from hophoop._jit.policy import (
    apart_jit,
    aside_jit,
    compiled,
    forced,
    inline_jit,
    interpreted,
    interpreted_as,
    jit,
    lean_jit,
    mode,
    outer_jit,
    precompile,
    unit_jit,
)

__all__ = [
    "apart_jit",
    "aside_jit",
    "compiled",
    "forced",
    "inline_jit",
    "interpreted",
    "interpreted_as",
    "jit",
    "lean_jit",
    "mode",
    "outer_jit",
    "precompile",
    "unit_jit",
]
