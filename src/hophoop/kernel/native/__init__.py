"""Compiled kernels at run time: the marks of kernels, and calls of the library or of the interpreted source."""

from hophoop.kernel.native.library import compiled, forced, mode
from hophoop.kernel.native.marks import inline, interpreted_as, noinline, replaced

__all__ = ["compiled", "forced", "inline", "interpreted_as", "mode", "noinline", "replaced"]
