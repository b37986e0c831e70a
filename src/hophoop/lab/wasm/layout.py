"""Arguments and results of the modules' entries: names of rows and columns, in the order of memory."""

from __future__ import annotations

import math
from typing import Any

from hophoop.gaits.kernels import layout as fates
from hophoop.kernel.compliant import WIDTH
from hophoop.kernel.model import EVENT_NAMES, MODE_LETTERS, PASSING, FrictionLaw, ImpactLaw, NormalLaw, Status
from hophoop.kernel.records import CELL, CONTACT, EVENT, LETTERS_PER_INTEGER, MORE, SEGMENT
from hophoop.maps.grid.kernel import ENDINGS, INTEGERS, NUMBERS, WORDS
from hophoop.maps.grid.quantities import QUANTITIES, choose_quantities, flags_of, make_span
from hophoop.vocabulary.names import FATE_CODES, identifier

# Data of a motion besides its events: SI units, and counts.
HEADS = (
    "status", "events", "segments", "duration", "doubt", "panels",
    "kinetic", "potential", "spring", "damping", "friction", "impact_normal", "impact_tangential", "residual",
    "rolling_resistance",
)  # fmt: skip

# An event, in SI units; `from_mode`, `collision` and `stable` are −1 if they do not apply.
EVENT_COLUMNS = (
    "t", "kind", "from_mode", "to_mode", "x", "height", "angle", "vx", "vy", "omega", "slip",
    "before_vx", "before_vy", "before_omega", "before_slip", "impulse_normal", "impulse_tangential",
    "friction", "impact_normal", "impact_tangential", "gain", "collision", "stable",
    "rolling_resistance",
)  # fmt: skip

# A state, in SI units; `mode` is an index into `MODE_LETTERS`.
SAMPLE_COLUMNS = (
    "mode", "x", "height", "angle", "vx", "vy", "omega", "slip", "friction_force", "normal_force",
    "friction", "impact_normal", "impact_tangential", "spring", "damping", "kinetic", "potential", "utilization",
    "rolling_resistance",
)  # fmt: skip

# Derived parameters of a compliant contact, in SI units.
CHOSEN = ("stiffness", "slip_speed")

# What becomes of a motion in the end; from the separate module.
FATE_COLUMNS = (*fates.CODES, *fates.NUMBERS)

# Thresholds of theory; nan if one does not exist. Angles are from the outward normal, in rad.
THRESHOLDS = (
    "first_slip_speed", "first_hop_speed", "immediate_hop_speed", "needed_friction", "needed_friction_angle",
    "painleve_friction", "painleve_angle", "jam_angle", "jam_angle_2", "jam_angle_3", "jam_angle_4",
    "stable_angle", "massless_loss_angle", "massless_loss_by_friction",
)  # fmt: skip

# Shapes of a hoop's parts, and the numbers of one part.
SHAPES = ("ring", "disk", "point_mass", "radial_rod", "tangential_rod")
PART = ("shape", "mass", "first", "second", "at")


def layout() -> dict[str, Any]:
    """Return what a program needs to call the modules.

    Returns
    -------
    layout : dict
        Ready for JSON: names in order, sizes of records in bytes.
    """
    return {
        "cell": CELL,
        "heads": HEADS,
        "events": EVENT_COLUMNS,
        "samples": SAMPLE_COLUMNS,
        "fate": FATE_COLUMNS,
        "fates": [identifier(name) for name in FATE_CODES],
        "compliant": CONTACT,
        "laws": [law.name.lower().replace("_", "-") for law in NormalLaw],
        "friction_laws": [law.name.lower() for law in FrictionLaw],
        "chosen": CHOSEN,
        "thresholds": THRESHOLDS,
        "numbers": NUMBERS,
        "words": WORDS,
        "keys": INTEGERS,
        "letters_a_key": LETTERS_PER_INTEGER,
        "more": MORE,
        "endings": ENDINGS,
        "spans": {name: _span(name) for name in ("first_revolution", "takeoff", "reversal", "duration")},
        "wanted": {name: flags_of(choose_quantities([name])) for name in QUANTITIES},
        "codes": {name: quantity.words for name, quantity in QUANTITIES.items() if quantity.words},
        "shapes": SHAPES,
        "part": PART,
        "impact_laws": [law.name.lower() for law in ImpactLaw],
        "kinds": EVENT_NAMES,
        "passing": [EVENT_NAMES[kind] for kind in PASSING],
        "letters": "".join(MODE_LETTERS),
        "statuses": [status.name.lower() for status in Status],
        "event_bytes": EVENT.itemsize,
        "segment_bytes": SEGMENT.itemsize,
        "compliant_segment_bytes": 8 * WIDTH,
    }


def _span(name: str) -> dict[str, Any]:
    span = make_span(name)
    return {"angle": None if math.isnan(span.angle) else span.angle, "stop": span.stop, "timed": int(span.timed)}
