"""The compiled kernels: which there are, their library, and its build."""
