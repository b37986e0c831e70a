"""Gaits: what becomes of a hoop in the end, the return map of its revolutions and the map's derivatives."""

from hophoop.gaits.computing import Judgement, fates, passages
from hophoop.gaits.level import SlipDecay, slip_decay
from hophoop.gaits.results import Lyapunov, Passages
from hophoop.gaits.runaway import Growth, Runaway, growth, runaway
from hophoop.gaits.section import SectionDerivative, derivative
from hophoop.vocabulary.fates import Fate

__all__ = [
    "passages",
    "fates",
    "derivative",
    "Passages",
    "SectionDerivative",
    "Lyapunov",
    "Judgement",
    "Fate",
    "growth",
    "Growth",
    "runaway",
    "Runaway",
    "slip_decay",
    "SlipDecay",
]
