"""Boundaries between classes of motion in a plane of two parameters, to rounding."""
