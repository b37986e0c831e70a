"""Numerical methods that are independent of the hoop."""
