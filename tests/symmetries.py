"""Symmetries of the model that its arithmetic preserves: left and right, and units scaled by powers of 2."""

import math

import numpy as np

from hophoop.scenario import InputError, Scenario
from hophoop.vocabulary.quantities import LOSSES
from invariants import EPSILON, IMPULSES, TINY, Finding, worst

_SIGNED = {"x", "angle", "speed", "vx", "omega", "slope"}
_SWAPPED = str.maketrans("SK", "KS")
# Lengths are scaled by 4ᵃ, times by 2ᵇ, masses by 2ᶜ; speeds and gravity follow. The first scaling inside the parameters'
# ranges is used.
_POWERS = ((1, 1, 1), (-1, -1, -1), (2, 3, -5), (0, 1, 3), (0, -1, 3), (1, 0, 0), (-1, 0, 0), (-3, -4, 2))


def mirrored(scenario):
    """Scenario with left and right exchanged, if rounding preserves the symmetry.

    None in three cases: compliant contact; a start with the load at the bottom, where −π and π are the same angle; and
    nearly zero kinetic friction with static friction, where rounding decides whether slip starts.
    """
    plane, angle = scenario.plane, scenario.start.angle
    bottom = math.cos(angle) < 0.0 and abs(math.sin(angle)) < 1e-6
    if scenario.contact.model != "rigid" or bottom or (plane.mu_kinetic < 1e-12 and plane.mu_static > 0.0):
        return None
    keys = scenario.to_dict()
    for section in ("plane", "start"):  # keep 0, not −0
        keys[section] = {name: 0.0 - value if name in _SIGNED else value for name, value in keys[section].items()}
    return Scenario.from_dict(keys)


def mirror_finding(motion, image):
    """Compare a motion with that of the mirrored scenario, to the last bit.

    Two cases allow rounding in angle and position: a massless hoop, whose angle is computed within one revolution that is not
    symmetric in its last bits; and events from extended precision.
    """
    odd = ("x", "angle", "vx", "omega", "slip", "impulse_tangential")
    factors = dict.fromkeys(("t", "height", "vy", "impulse_normal", *LOSSES), 1.0) | dict.fromkeys(odd, -1.0)
    allowed = 4.0 * EPSILON if motion.scenario.hoop.massless or math.isfinite(motion.doubt) else 0.0
    return _alike("mirror", motion, image, factors, _SWAPPED, allowed)


def scaled(scenario):
    """Scenario in units scaled by powers of 2, and the factors of lengths, times and masses.

    None if the ranges allow no scaling, or a number is almost subnormal.
    """
    keys = scenario.to_dict()
    if _smallest(keys) < TINY:
        return None
    for powers in _POWERS:
        length, time, mass = 4.0 ** powers[0], 2.0 ** powers[1], 2.0 ** powers[2]
        if scenario.plane.gravity == 0.0:  # the unit of time follows from 1 m/s²
            time = math.sqrt(length)
        try:
            return Scenario.from_dict(_in_other_units(keys, length, time, mass)), (length, time, mass)
        except InputError:
            continue
    return None


def units_finding(motion, other, factors):
    """Compare a motion with that of the scaled scenario, to the last bit; factors of lengths, times and masses."""
    length, time, mass = factors
    speed = length / time
    units = {"t": time, "x": length, "height": length, "angle": 1.0, "omega": 1.0 / time}
    units |= dict.fromkeys(("vx", "vy", "slip"), speed) | dict.fromkeys(IMPULSES, mass * speed)
    return _alike("units", motion, other, units | dict.fromkeys(LOSSES, mass * speed**2), {}, 0.0)


def _smallest(value):
    """Return the smallest nonzero magnitude of the numbers of a scenario."""
    if isinstance(value, dict | list):
        return min(map(_smallest, value.values() if isinstance(value, dict) else value), default=math.inf)
    return abs(value) if isinstance(value, float) and value != 0.0 else math.inf


def _in_other_units(keys, length, time, mass):
    damper = mass / time if keys["contact"].get("law") == "kelvin-voigt" else time / length
    units = {"duration": time, "mass": mass, "gravity": length / time**2, "omega": 1.0 / time, "damping": damper}
    units |= dict.fromkeys(("radius", "inner_radius", "outer_radius", "at", "length", "x", "height"), length)
    units |= dict.fromkeys(("speed", "vx", "vy", "slip_speed"), length / time)
    units |= dict.fromkeys(("stiffness", "tangential_stiffness"), mass / time**2)

    def other(name, value):
        if isinstance(value, dict):
            return {key: other(key, each) for key, each in value.items()}
        if isinstance(value, list):
            return [other(name, each) for each in value]
        return value * units[name] if name in units and value is not None else value

    return other("", keys)


def _alike(invariant, motion, other, factors, letters, allowed):
    mine = [(event.kind, event.to_mode.translate(letters)) for event in motion.events]
    if (mine, motion.status) != ([(event.kind, event.to_mode) for event in other.events], other.status):
        return Finding(invariant, 1.0, 0.0, motion.duration)
    found = []
    for name, factor in factors.items():
        expected, got = (np.array([getattr(event, name) for event in each.events]) for each in (motion, other))
        off = np.abs(expected * factor - got)
        off[(expected * factor == got) | (np.abs(got) < TINY)] = 0.0  # tiny numbers have fewer digits
        loose = allowed if name in ("angle", "x", "height") else 0.0
        found.append(worst(invariant, [event.t for event in motion.events], off, np.max(np.abs(got)), loose))
    return max(found, key=lambda each: each.value - each.allowed)
