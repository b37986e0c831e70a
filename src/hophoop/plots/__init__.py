"""Figures of a motion: one function each, which takes ``ax=None`` and returns the Axes; none calls show.

Matplotlib is in the extra ``plots`` and loaded when a figure is drawn.
"""

from hophoop.plots import colors

__all__ = ["colors"]
