"""The compiled kernels, their library, and its build."""
