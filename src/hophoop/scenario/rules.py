"""Rules between the fields of a scenario: the sentence of each rule of `kernel.records.refusals`, and what fills its braces."""

from __future__ import annotations

from collections.abc import Mapping
from operator import attrgetter
from typing import Any, Final, NamedTuple

from pydantic_core import PydanticCustomError

from hophoop.kernel.physics import MOST_DEPTH, MOST_HEIGHT, MOST_SPEED
from hophoop.kernel.records import Refusal
from hophoop.scenario.base import refuse
from hophoop.scenario.texts import say
from hophoop.vocabulary.parameters import RANGES, RELATIVE_SLIP_SPEED, RELATIVE_STIFFNESS


class Rule(NamedTuple):
    """A sentence and what fills it.

    Attributes
    ----------
    sentence : str
        A key of `texts.TEXTS`.
    values : dict of str to str
        Paths of a scenario, by the names in the sentence.
    known : dict
        What is the same for all scenarios, likewise.
    number : str, default ''
        The name in the sentence of the number that `refusal` returns.
    """

    sentence: str
    values: Mapping[str, str]
    known: Mapping[str, Any] = {}
    number: str = ""


_INERTIA = {"words": RANGES["hoop.inertia_ratio"].words()}
_STIFFNESS = {"unit": "m g/R", "words": RELATIVE_STIFFNESS.words()}
_SLIP_SPEED = {"unit": "√(g R)", "words": RELATIVE_SLIP_SPEED.words()}

RULES: Final[dict[Refusal, Rule]] = {
    Refusal.HOOP_MASS: Rule("hoop_mass", {"mass": "hoop.mass"}, {"words": RANGES["hoop.mass"].words("kg")}),
    Refusal.PARTS_CENTER: Rule("parts_center", {"eccentricity": "hoop.eccentricity"}),
    Refusal.LOAD_INERTIA: Rule(
        "load_inertia", {"load_fraction": "hoop.load_fraction", "inertia_ratio": "hoop.inertia_ratio"}, _INERTIA
    ),
    Refusal.PARTS_INERTIA: Rule("parts_inertia", {"inertia_ratio": "hoop.inertia_ratio"}, _INERTIA),
    Refusal.MASSLESS_ECCENTRICITY: Rule("massless_eccentricity", {"eccentricity": "hoop.eccentricity"}),
    Refusal.KINETIC_ABOVE_STATIC: Rule(
        "kinetic_above_static", {"mu_kinetic": "plane.mu_kinetic", "mu_static": "plane.mu_static"}
    ),
    Refusal.VERTICAL: Rule("vertical", {"slope": "plane.slope"}),
    Refusal.SLOPE: Rule("slope", {"slope": "plane.slope"}, {"words": RANGES["plane.slope"].words("rad")}),
    Refusal.MASSLESS_SLOPE: Rule("massless_slope", {"slope": "plane.slope"}),
    Refusal.MASSLESS_RESISTANCE: Rule("massless_resistance", {"given": "plane.rolling_resistance"}),
    Refusal.RESISTANCE: Rule("resistance", {"given": "plane.rolling_resistance"}, number="most"),
    Refusal.MASSLESS_COMPLIANT: Rule("massless_compliant", {}),
    Refusal.COMPLIANT_FRICTION: Rule("compliant_friction", {}),
    Refusal.STIFFNESS: Rule(
        "relative_contact", {"value": "contact.stiffness"}, {"name": "stiffness", **_STIFFNESS}, "relative"
    ),
    Refusal.TANGENTIAL_STIFFNESS: Rule(
        "relative_contact", {"value": "contact.tangential_stiffness"}, {"name": "tangential_stiffness", **_STIFFNESS},
        "relative",
    ),
    Refusal.SLIP_SPEED: Rule(
        "relative_contact", {"value": "contact.slip_speed"}, {"name": "slip_speed", **_SLIP_SPEED}, "relative"
    ),
    Refusal.TOO_SOFT: Rule("too_soft", {"stiffness": "contact.stiffness"}, {"most": MOST_DEPTH}, "depth"),
    Refusal.TOO_FAST: Rule("too_fast", {}, {"most": MOST_SPEED}, "speed"),
    Refusal.TOO_HIGH: Rule("too_high", {"height": "start.height"}, {"most": MOST_HEIGHT}, "relative"),
}  # fmt: skip


def refused(code: int, scenario: Any, number: float = 0.0) -> PydanticCustomError:
    """Return the error for a broken rule.

    code: A `Refusal` other than NONE; number: What `refusal` returns in addition.
    """
    rule = RULES[Refusal(code)]
    values = {name: attrgetter(path)(scenario) for name, path in rule.values.items()}
    return refuse(say(rule.sentence, **values, **rule.known, **({rule.number: number} if rule.number else {})))
