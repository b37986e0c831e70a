"""Hoops on slopes, in units of R and g."""

import math

import hophoop as hh


def on_slope(degrees, gamma=0.75, omega=None, **plane):
    """A hoop on a slope; with `omega` it rolls through the bottom."""
    start = hh.Start() if omega is None else hh.Start.rolling(omega, angle=math.pi)
    plane = hh.Plane(slope=math.radians(degrees), gravity=1.0, **plane)
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=plane, start=start)
