"""Reference data with all digits, and motions in many digits."""

from mpmath import mp, mpf

import hophoop as hh
from oracle_program import reference

HOOP = hh.Hoop.ideal(0.75)


def stored(name):
    """Reference data with all of their digits."""
    with mp.workdps(60):
        return reference(name, mpf)


def rolling(speed, mu=1.0, hoop=HOOP, angle=0.0, **rest):
    return precise(hoop, hh.Plane(mu=mu), hh.Start.rolling(speed, angle=angle), **rest)


def precise(hoop=HOOP, plane=None, start=None, duration=2.0, digits=30):
    return hh.simulate(hoop, plane or hh.Plane(), start or hh.Start(), duration=duration, digits=digits)
