"""Boundaries between classes of motion in a plane of two parameters: one followed, all of a map as contours."""
