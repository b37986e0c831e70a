"""Derivatives of a motion by differences of motions on either side, with steps halved until they agree; where it changes."""

import math

import numpy as np

import hophoop as hh
from hophoop.derivatives.parameters import value_of

FIELDS = ("t", "angle", "omega", "slip")
FIRST, LAST = 12, 26  # halvings of the parameter, or of its unit
AGREE = 1e-6  # of two steps in a row, relative
RIGHT = 1e-4  # of a derivative and the differences, relative: 100 times what they agree to
START = ("start.vx", "start.omega", "start.angle")
OTHERS = ("hoop.eccentricity", "plane.mu", "plane.mu_kinetic", "plane.slope", "plane.restitution", "start.height")


def parameters_of(scenario):
    """The parameters that the scenario is given by and that may change to at least one side."""
    start = ("start.speed", "start.angle") if scenario.start.speed is not None else START
    return [*start, *(path for path in OTHERS if path not in REFUSED or not REFUSED[path](scenario))]


REFUSED = {
    "hoop.eccentricity": lambda scenario: scenario.hoop.load_fraction is not None,
    "plane.mu": lambda scenario: scenario.plane.mu is None or math.isinf(scenario.plane.mu),
    "plane.mu_kinetic": lambda scenario: math.isinf(scenario.plane.mu_kinetic),
    "start.height": lambda scenario: scenario.start.height == 0.0,
}


def numbers_of(motion):
    """The compared numbers of all events, in SI units."""
    return np.array([[getattr(event, field) for field in FIELDS] for event in motion.events])


def kinds_of(motion):
    return [event.kind for event in motion.events]


def changed(motion, path, change):
    """The numbers of a motion with another value of a parameter; None if its events are others."""
    try:
        scenario = motion.scenario.with_values({path: value_of(motion.scenario, path) + change})
    except ValueError:
        return None
    other = hh.simulate(scenario)
    return numbers_of(other) if kinds_of(other) == kinds_of(motion) else None


def slopes(motion, path, side):
    """One-sided differences of the events, of second order, for smaller and smaller steps, and their rounding."""
    here = numbers_of(motion)
    size = abs(value_of(motion.scenario, path)) or 1.0
    step = side * math.ldexp(1.0, math.frexp(size)[1] - FIRST + 1)
    near = changed(motion, path, step)
    for _ in range(FIRST, LAST):
        step *= 0.5
        far, near = near, changed(motion, path, step)
        if near is not None and far is not None:
            yield (4.0 * near - far - 3.0 * here) / (2.0 * step), abs(8.0 * np.spacing(here) / step)


def by_differences(motion, path, side):
    """The derivatives of the events to one side; nan where no two steps in a row agree."""
    found = np.full((len(motion.events), len(FIELDS)), np.nan)
    before = found
    for after, rounding in slopes(motion, path, side):
        size = 1.0 + abs(after)
        settled = np.isnan(found) & (abs(after - before) <= AGREE * size) & (rounding < RIGHT * size)
        found[settled] = after[settled]
        before = after
        if not np.isnan(found).any():
            break
    return found


def counted_names(motion, fields=FIELDS):
    """The names of numbers of all events, such as ``"impact[1].omega"``."""
    kinds = kinds_of(motion)
    return [f"{kind}[{kinds[:k].count(kind)}].{field}" for k, kind in enumerate(kinds) for field in fields]


def compare_derivatives(scenario):
    """Return (what is wrong, how many derivatives have been compared)."""
    motion = hh.simulate(scenario)
    paths, names = parameters_of(scenario), counted_names(motion)
    found = motion.sensitivity(names, paths)
    wrong, count = [], 0
    for k, path in enumerate(paths):
        for side, rates in ((-1.0, found.smaller[:, k]), (1.0, found.larger[:, k])):
            if np.isnan(rates).all():
                continue
            true = by_differences(motion, path, side).ravel()
            both = np.isfinite(true) & np.isfinite(rates)
            off = both & (abs(rates - true) > RIGHT * (1.0 + abs(true)))
            wrong += [f"{names[i]} by {path} to {side:+.0f}: {rates[i]}, not {true[i]}" for i in np.flatnonzero(off)]
            count += int(both.sum())
    return wrong, count


def halved(low, high, is_low):
    """Neighbouring doubles between which something changes; the first of them is low."""
    assert is_low(low)
    assert not is_low(high)
    while math.nextafter(low, high) < high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return low, high
