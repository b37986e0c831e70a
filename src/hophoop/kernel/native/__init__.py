"""The compiled kernels at run time: the marks of kernels, and the library that calls them, or the interpreter."""

from hophoop.kernel.native.entry import compiled, forced, mode
from hophoop.kernel.native.marks import apart, inline, interpreted_as

__all__ = ["apart", "compiled", "forced", "inline", "interpreted_as", "mode"]
