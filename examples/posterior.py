"""Sample the parameters of a fit with lmfit's emcee: for uncertainties that are curved, one-sided or of several sequences.

    pip install emcee pandas
    python examples/posterior.py fitted/fit.json

Some minutes.
"""

from __future__ import annotations

import sys

import lmfit
import pandas as pd

import hophoop as hh


def sampler(found: hh.Fit) -> lmfit.Minimizer:
    """Minimizer of a fit's residuals, over as much as they are larger than the errors of the data."""
    return lmfit.Minimizer(
        lambda params: found.problem.residuals(params.valuesdict()) / found.inflation, found.params, nan_policy="omit"
    )


def posterior(found: hh.Fit, steps: int = 1000, burn: int = 250, walkers: int = 60) -> pd.DataFrame:
    """Draws of the free parameters, a column for each [SI units]; the first steps of each walker are left out."""
    chain = sampler(found).emcee(steps=steps, burn=burn, nwalkers=walkers, is_weighted=True, progress=False, seed=1)
    return chain.flatchain


if __name__ == "__main__":
    print(posterior(hh.load_fit(sys.argv[1])).quantile([0.16, 0.5, 0.84]).T.to_string())
