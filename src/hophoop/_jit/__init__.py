"""The decorators of the kernels: interpreted until compiled code is there, or worth its wait (see `policy`)."""

from hophoop._jit.policy import compiled, forced, inline_jit, jit, lean_jit, mode, precompile, unit_jit

__all__ = ["compiled", "forced", "inline_jit", "jit", "lean_jit", "mode", "precompile", "unit_jit"]
