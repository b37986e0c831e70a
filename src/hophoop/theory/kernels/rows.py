"""The row of numbers that stands for a Body in a table of cases."""

from __future__ import annotations

import numpy as np

from hophoop.kernel.physics.body import Body

WIDTH = len(Body._fields)


def body_of(row):
    """The Body that a row of `Columns.body` stands for."""
    return Body(
        row[0], row[1], row[2], row[3], row[4], row[5], row[6], int(row[7]), row[8] > 0.0, row[9], row[10] > 0.0,
        row[11],
    )  # fmt: skip


def row_of(body):
    """A table of one row that stands for a Body."""
    rows = np.empty((1, WIDTH))
    row = rows[0]
    row[0] = body.eps
    row[1] = body.kap
    row[2] = body.mu_s
    row[3] = body.mu_k
    row[4] = body.gn
    row[5] = body.gt
    row[6] = body.rest
    row[7] = body.law
    row[8] = 1.0 if body.strike else 0.0
    row[9] = body.slope
    row[10] = 1.0 if body.ideal else 0.0
    row[11] = body.resist
    return rows
