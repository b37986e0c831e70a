"""Build of the compiled kernels: a library per kind of machine, by Numba (code), LLVM (optimization) and zig (linker)."""
