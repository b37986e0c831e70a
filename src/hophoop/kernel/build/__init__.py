"""The build of the compiled kernels: a library of a machine's kind, from Numba's code, LLVM's optimisation and zig's linker."""
