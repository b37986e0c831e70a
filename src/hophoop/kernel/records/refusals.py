"""Rules between the numbers of a cell: which scenarios are refused, and by which rule.

Scenarios, maps and the page check with these functions; `scenario.checking` has the sentence of each rule.
"""

from __future__ import annotations

import math
from enum import IntEnum

from hophoop.kernel.physics.body import (
    INERTIA_RANGE,
    MASS_RANGE,
    MOST_DEPTH,
    MOST_HEIGHT,
    MOST_SPEED,
    SLOPE_RANGE,
    STIFFNESS_RANGE,
)
from hophoop.kernel.physics.body import SLIP_SPEED_RANGE as SLIP_RANGE
from hophoop.kernel.physics.compliant import STIFFNESS as USUAL_STIFFNESS
from hophoop.kernel.physics.compliant import sinking
from hophoop.kernel.physics.contact import most_resistance
from hophoop.kernel.records.cells import Cell, Contact, second_of


class Refusal(IntEnum):
    """Rules in the order in which they are checked: first of a hoop and a plane alone, then of what must go together."""

    NONE = 0
    HOOP_MASS = 1
    PARTS_CENTER = 2
    LOAD_INERTIA = 3
    PARTS_INERTIA = 4
    MASSLESS_ECCENTRICITY = 5
    KINETIC_ABOVE_STATIC = 6
    VERTICAL = 7
    SLOPE = 8
    MASSLESS_SLOPE = 9
    MASSLESS_RESISTANCE = 10
    RESISTANCE = 11
    MASSLESS_COMPLIANT = 12
    COMPLIANT_FRICTION = 13
    STIFFNESS = 14
    TANGENTIAL_STIFFNESS = 15
    SLIP_SPEED = 16
    TOO_SOFT = 17
    TOO_FAST = 18
    TOO_HIGH = 19


(
    NONE, HOOP_MASS, PARTS_CENTER, LOAD_INERTIA, PARTS_INERTIA, MASSLESS_ECCENTRICITY, KINETIC_ABOVE_STATIC, VERTICAL, STEEP,
    MASSLESS_SLOPE, MASSLESS_RESISTANCE, RESISTANCE, MASSLESS_COMPLIANT, COMPLIANT_FRICTION, STIFFNESS,
    TANGENTIAL_STIFFNESS, SLIP_SPEED, TOO_SOFT, TOO_FAST, TOO_HIGH,
) = (int(rule) for rule in Refusal)  # fmt: skip


def within(allowed, value):
    """Return True for a number in a range, both ends included."""
    return allowed[0] <= value <= allowed[1]


def hoop_refusal(mass, eps, kap, ideal):
    """Return the rule that a hoop breaks, 0 for none."""
    if not within(MASS_RANGE, mass):
        return HOOP_MASS
    if not eps <= 1.0:
        return PARTS_CENTER
    if kap != 0.0:
        return NONE if within(INERTIA_RANGE, kap) else LOAD_INERTIA if ideal else PARTS_INERTIA
    return NONE if eps == 1.0 else MASSLESS_ECCENTRICITY


def plane_refusal(mu_s, mu_k, slope):
    """Return the rule that a plane breaks, 0 for none."""
    if mu_k > mu_s:
        return KINETIC_ABOVE_STATIC
    if not abs(slope) < 0.5 * math.pi:
        return VERTICAL
    return NONE if within(SLOPE_RANGE, slope) else STEEP


def refusal(cell, contact):
    """Return the first rule that a scenario breaks, 0 for none, and a number that its sentence needs.

    `cell` is a column of `cells.Cell`, `contact` a row of `cells.Contact`, or empty for a rigid contact.
    """
    code = hoop_refusal(cell[Cell.MASS], cell[Cell.ECCENTRICITY], cell[Cell.INERTIA_RATIO], cell[Cell.IDEAL] != 0.0)
    if code == NONE:
        code = plane_refusal(cell[Cell.MU_STATIC], cell[Cell.MU_KINETIC], cell[Cell.SLOPE])
    if code != NONE:
        return code, 0.0
    massless = cell[Cell.INERTIA_RATIO] == 0.0
    if massless and cell[Cell.SLOPE] != 0.0:
        return MASSLESS_SLOPE, 0.0
    resist = cell[Cell.ROLLING_RESISTANCE]
    if resist != 0.0:
        if massless:
            return MASSLESS_RESISTANCE, 0.0
        most = most_resistance(cell[Cell.ECCENTRICITY], cell[Cell.INERTIA_RATIO])
        if not resist < most:
            return RESISTANCE, most
    code, number = start_refusal(cell)
    if code != NONE or len(contact) == 0:
        return code, number
    if massless:
        return MASSLESS_COMPLIANT, 0.0
    if cell[Cell.MU_STATIC] == math.inf:
        return COMPLIANT_FRICTION, 0.0
    return contact_refusal(cell, contact)


def start_refusal(cell):
    """Return the rule that a start breaks because it is too fast or too high for its hoop, as `refusal` does."""
    radius = cell[Cell.RADIUS]
    unit = math.sqrt(radius * (cell[Cell.GRAVITY] if cell[Cell.GRAVITY] > 0.0 else 1.0))
    rim = radius * cell[Cell.OMEGA]
    speed = max(abs(cell[Cell.SLIP] + rim), abs(rim), abs(cell[Cell.VY])) / unit
    if speed > MOST_SPEED:
        return TOO_FAST, speed
    height = cell[Cell.HEIGHT] / radius
    return (TOO_HIGH, height) if height > MOST_HEIGHT else (NONE, 0.0)


def contact_refusal(cell, contact):
    """Return the rule that a spring breaks because it is too soft or too stiff for its hoop or start, as `refusal` does."""
    radius, mass = cell[Cell.RADIUS], cell[Cell.MASS]
    second = second_of(cell)
    # in the order of operations of `compliant.motion.compliance_of`; nan selects the default
    k = contact[Contact.STIFFNESS] * (second * second) / mass
    if not (math.isnan(k) or within(STIFFNESS_RANGE, k)):
        return STIFFNESS, k
    tangential = contact[Contact.TANGENTIAL_STIFFNESS] * (second * second) / mass
    if not (math.isnan(tangential) or within(STIFFNESS_RANGE, tangential)):
        return TANGENTIAL_STIFFNESS, tangential
    slip_speed = contact[Contact.SLIP_SPEED] * second / radius
    if not (math.isnan(slip_speed) or within(SLIP_RANGE, slip_speed)):
        return SLIP_SPEED, slip_speed
    unit, omega = radius / second, cell[Cell.OMEGA] * second
    speed = abs(cell[Cell.SLIP] / unit + omega) + abs(cell[Cell.VY] / unit) + abs(omega)
    depth = sinking(USUAL_STIFFNESS if math.isnan(k) else k, cell[Cell.GRAVITY] > 0.0, cell[Cell.HEIGHT] / radius, speed)
    return (TOO_SOFT, depth) if depth > MOST_DEPTH else (NONE, 0.0)


def mark_refused(cells):
    """Mark the cells of motions with rigid contact that break a rule."""
    for k in range(cells.shape[1]):
        if refusal(cells[:, k], cells[:0, k])[0] != NONE:
            cells[Cell.ALLOWED, k] = 0.0
