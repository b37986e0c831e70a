"""Formulas of the hoop, each stated once: scalars in, tuples out."""
