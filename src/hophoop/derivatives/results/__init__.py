"""Derivatives of quantities of a motion, and what uncertain parameters make of them."""
