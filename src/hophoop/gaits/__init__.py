"""Gaits: what becomes of a hoop in the end, the return map of its revolutions and the map's derivatives."""

from hophoop.gaits.branch import Branch, Special
from hophoop.gaits.computing import Judgement, fates, passages
from hophoop.gaits.diagram import Attractor, Diagram, diagram
from hophoop.gaits.gait import Gait
from hophoop.gaits.points import SectionDerivative, derivative
from hophoop.gaits.results import Lyapunov, Passages
from hophoop.gaits.return_map import MapEnd, MapPiece, ReturnMap, return_map
from hophoop.gaits.search import find
from hophoop.vocabulary.names import Fate

__all__ = [
    "passages",
    "find",
    "Gait",
    "diagram",
    "Diagram",
    "Attractor",
    "Branch",
    "Special",
    "return_map",
    "ReturnMap",
    "MapPiece",
    "MapEnd",
    "fates",
    "derivative",
    "Passages",
    "SectionDerivative",
    "Lyapunov",
    "Judgement",
    "Fate",
]
