"""The row of numbers that stands for a Body in a table of cases."""

from __future__ import annotations

from hophoop._jit import jit
from hophoop.physics.body import Body


@jit
def body_of(row):
    """The Body that a row of `Columns.body` stands for."""
    return Body(
        row[0], row[1], row[2], row[3], row[4], row[5], row[6], int(row[7]), row[8] > 0.0, row[9], row[10] > 0.0,
        row[11],
    )  # fmt: skip
