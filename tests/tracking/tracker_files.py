"""Tracker's text of point masses, written from what the source of its exporter says; shares no code with the reader."""

import numpy as np


def java(value):
    """A number with Java's pattern 0.000000E0."""
    mantissa, exponent = f"{value:.6E}".split("E")
    return f"{mantissa}E{int(exponent)}"


def text_export(t, points, columns, delimiter="\t", comma=False):
    """Tracker's text of point masses: one under another in time, one beside the other by name, a delimiter behind each cell.

    `points` are arrays of columns by name, nan where a cell stays empty.
    """
    lines = ["#multi:"] if len(points) > 1 else []
    lines.append(delimiter + "".join(name + delimiter * len(columns) for name in points))
    lines.append("t" + delimiter + "".join(column + delimiter for _ in points for column in columns))
    for k, moment in enumerate(t):
        cells = [java(moment)]
        for values in points.values():
            cells += ["" if np.isnan(one[k]) else java(one[k]) for one in values]
        lines.append("".join(cell.replace(".", "," if comma else ".") + delimiter for cell in cells))
    return "\n".join(lines) + "\n"
