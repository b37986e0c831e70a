"""The kernels as one WebAssembly module, for browsers and for whatever else runs it: entries, layout, build."""
