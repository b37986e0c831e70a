"""The record of a Body in a table of cases."""

from __future__ import annotations

import numpy as np

from hophoop.kernel.physics.body import Body
from hophoop.kernel.records.layout import BODY


def body_of(row):
    """The Body of a record."""
    return Body(
        eps=row["eps"],
        kap=row["kap"],
        mu_s=row["mu_s"],
        mu_k=row["mu_k"],
        gn=row["gn"],
        gt=row["gt"],
        rest=row["rest"],
        law=row["law"],
        painleve_impact=row["painleve_impact"],
        slope=row["slope"],
        ideal=row["ideal"],
        resist=row["resist"],
    )


def table_of(body):
    """A table of one record."""
    rows = np.empty(1, BODY)
    row = rows[0]
    row["eps"] = body.eps
    row["kap"] = body.kap
    row["mu_s"] = body.mu_s
    row["mu_k"] = body.mu_k
    row["gn"] = body.gn
    row["gt"] = body.gt
    row["rest"] = body.rest
    row["law"] = body.law
    row["painleve_impact"] = body.painleve_impact
    row["slope"] = body.slope
    row["ideal"] = body.ideal
    row["resist"] = body.resist
    return rows
