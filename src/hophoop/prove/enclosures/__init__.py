"""Roots, maxima and first-order dependence on parameters, all enclosed in balls."""
