"""The kernels as WebAssembly modules, for browsers and other hosts: entries, layout, build."""
