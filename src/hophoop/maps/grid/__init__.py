"""Grids of motions: axes, quantities, the kernel of a cell, resumable stores."""
