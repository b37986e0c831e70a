"""What a motion is made of: hoop, plane, start and contact, frozen and validated, with files and links."""

from hophoop._support.errors import InputError
from hophoop.scenario.checking import sentence
from hophoop.scenario.describing import describe
from hophoop.scenario.models import Compliant, Hoop, Plane, Rigid
from hophoop.scenario.parts import Disk, PointMass, Ring, Rod
from hophoop.scenario.paths import ParameterInfo, parameter, paths
from hophoop.scenario.scenario import Scenario, cell_of, time_unit, to_body
from hophoop.scenario.start import Start, StartState

__all__ = [
    "Hoop",
    "Plane",
    "Start",
    "StartState",
    "Ring",
    "Disk",
    "PointMass",
    "Rod",
    "Rigid",
    "Compliant",
    "Scenario",
    "InputError",
    "ParameterInfo",
    "parameter",
    "paths",
    "describe",
    "sentence",
    "cell_of",
    "time_unit",
    "to_body",
]
