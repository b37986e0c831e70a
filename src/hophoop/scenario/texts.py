"""Sentences that refuse a scenario, filled by Python and by the page.

Braces are filled as by `str.format`: ``{value!r}``, ``{least:g}``.
"""

from __future__ import annotations

from typing import Any, Final

TEXTS: Final[dict[str, str]] = {
    # keys
    "unknown_key": "{path} is not a known key; {hint}",
    "did_you_mean": "did you mean {close}?",
    "known_are": "known are {known}.",
    "missing": "{path} is missing.",
    "together": "{section}.{other} cannot be given together with {section}.{way}.",
    # one value: the field, how it was given, what is allowed
    "finding": "{path} = {shown} {allowed}.",
    "number": "must be a number",
    "friction": "must be at least 0 (inf is allowed)",
    "whole": "must be a whole number",
    "finite_number": "must be a finite number",
    "greater_than_equal": "must be at least {limit:g}",
    "less_than_equal": "must be at most {limit:g}",
    "range": "must be {words}",
    "literal_error": "must be {expected}",
    "table": "must be a table of keys",
    "list": "must be a list",
    "word": "must be a word",
    "other_problem": "{first} (and {count} more problem).",
    "other_problems": "{first} (and {count} more problems).",
    "whole_scenario": "the scenario",
    # the hoop
    "no_parts": "hoop.parts must not be empty.",
    "half_a_hoop": "hoop.{missing} is missing: hoop.{given} does not define a hoop without it.",
    "massless_eccentricity": (
        "hoop.inertia_ratio = 0 needs hoop.eccentricity = 1 (all mass in a point on the rim), not {eccentricity!r}."
    ),
    "hoop_mass": "hoop.parts give hoop.mass = {mass!r}, which must be {words}.",
    "parts_center": "hoop.parts give hoop.eccentricity = {eccentricity!r}, which must be at most 1.",
    "parts_inertia": "hoop.parts give hoop.inertia_ratio = {inertia_ratio!r}, which must be {words}.",
    "load_inertia": (
        "hoop.load_fraction = {load_fraction!r} gives hoop.inertia_ratio = {inertia_ratio!r}, which must be {words}."
    ),
    "ring_radii": "ring.inner_radius = {inner!r} must not exceed ring.outer_radius = {outer!r}.",
    "beyond_the_rim": (
        "hoop.parts.{index} ({shape}) reaches {reach!r} m from the centre, beyond the rim: hoop.radius = {radius!r}."
    ),
    # plane and start
    "kinetic_above_static": "plane.mu_kinetic = {mu_kinetic!r} must not exceed plane.mu_static = {mu_static!r}.",
    "vertical": "plane.slope = {slope!r} must lie between -pi/2 and pi/2 (radians).",
    "slope": "plane.slope = {slope!r} must be {words}.",
    "no_omega": "start.omega = None must be a number.",
    # what must go together
    "massless_slope": "plane.slope = {slope!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0).",
    "massless_resistance": ("plane.rolling_resistance = {given!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0)."),
    "resistance": (
        "plane.rolling_resistance = {given!r} must be below {most:.6g} for this hoop, whose inertia about the contact "
        "it would cancel at some angle."
    ),
    "massless_compliant": ("contact.model = 'compliant' must be 'rigid' for the massless hoop (hoop.inertia_ratio = 0)."),
    "compliant_friction": "plane.mu_static = inf must be finite with contact.model = 'compliant'.",
    "relative_contact": "contact.{name} = {value!r} is {relative:.3g} {unit} of this hoop and must be {words} of it.",
    "too_soft": (
        "contact.stiffness = {stiffness!r} lets the rim sink some {depth:.0e} radii into the plane, at the speed "
        "of the start, and must be high enough for at most {most:g}."
    ),
    "too_fast": "start has a speed of {speed:.3g} √(g R), with R of the hoop, and must have at most {most:g} √(g R).",
    "too_high": "start.height = {height!r} is {relative:.3g} radii of this hoop and must be at most {most:g} radii.",
    # paths
    "no_parameter": "{path} is not a parameter of a scenario; known are {known}.",
    "no_section_parts": "{path} is not a parameter of a scenario: {section} has no parts.",
    "two_ways": "{one} = {one_value!r} and {other} = {other_value!r} cannot be given together.",
    "not_there": "{path} is not there to be replaced: the scenario has no {step!r}.",
    # links
    "unreadable_query": "The query cannot be read: {reason}.",
    "value_above": "{path} cannot be given together with a value for {above}.",
    "given_twice": "{path} is given twice.",
    "parts_out_of_order": "hoop.parts.{name} is out of order: parts are numbered from 0 without a gap.",
}
"""By a stable name."""


def say(name: str, /, **values: Any) -> str:
    """Return a sentence with its values.

    name: A key of `TEXTS`; **values: Values of its braces.

    Examples
    --------
    >>> say("given_twice", path="plane.mu")
    'plane.mu is given twice.'
    """
    return TEXTS[name].format(**values)
