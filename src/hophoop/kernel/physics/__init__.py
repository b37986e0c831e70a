"""Formulas of the hoop, once each: scalars in, tuples out."""
