"""Grids of motions: axes, quantities, the kernel of a cell, stores that are resumed."""
