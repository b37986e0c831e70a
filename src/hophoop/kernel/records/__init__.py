"""Inputs and results of the kernels: cells, state, events, segments, scratch arrays."""
