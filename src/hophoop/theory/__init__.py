"""Closed forms and thresholds of the loaded hoop, vectorised over their arguments.

A call takes one hoop and one plane; its numbers may be arrays, which broadcast. All are in SI units and radians. The formulas
are those of `hophoop.kernel.physics`; none is restated here.
"""

from hophoop.theory.critical import (
    CriticalSpeeds,
    critical_speeds,
    first_hop_speed,
    first_slip_speed,
    hop_angle,
    immediate_hop_speed,
    slip_angle,
)
from hophoop.theory.decay import SlipDecay, slip_decay
from hophoop.theory.massless import ContactLoss, massless_loss
from hophoop.theory.painleve import (
    JamState,
    PainleveMinimum,
    jam_states,
    least_jam_speed,
    painleve_minimum,
    painleve_region,
    painleve_threshold,
)
from hophoop.theory.phase_plane import RollingRange, lift_off_speed, mode_of, rolling_range
from hophoop.theory.rest import Equilibrium, RestRange, equilibria, rest_ranges
from hophoop.theory.rolling import (
    Energies,
    Forces,
    NeededFriction,
    friction_utilization,
    max_rolling_speed,
    needed_friction,
    rocking_period,
    rolling_energies,
    rolling_forces,
    rolling_period,
    rolling_speed,
    rolling_time,
)
from hophoop.theory.summary import Quantity, summary

__all__ = [
    "summary",
    "rolling_speed",
    "max_rolling_speed",
    "rolling_forces",
    "friction_utilization",
    "rolling_energies",
    "needed_friction",
    "rolling_time",
    "rolling_period",
    "rocking_period",
    "critical_speeds",
    "first_slip_speed",
    "first_hop_speed",
    "immediate_hop_speed",
    "slip_angle",
    "hop_angle",
    "slip_decay",
    "mode_of",
    "rolling_range",
    "lift_off_speed",
    "painleve_threshold",
    "painleve_minimum",
    "painleve_region",
    "jam_states",
    "least_jam_speed",
    "equilibria",
    "rest_ranges",
    "massless_loss",
    "Quantity",
    "Forces",
    "Energies",
    "NeededFriction",
    "CriticalSpeeds",
    "SlipDecay",
    "RollingRange",
    "PainleveMinimum",
    "JamState",
    "Equilibrium",
    "RestRange",
    "ContactLoss",
]
