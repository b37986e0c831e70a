"""How slip dies away on the level: a little above the first slip each revolution loses the square of the excess.

Near the angle where rolling first needs all friction, the force that is missing grows from 0 to its maximum and back to 0: a
parabola of the time, f(τ) = B(a² − τ²)/2 between τ = −a and a, with a² proportional to the excess of v². The slip velocity
grows with C f and ends at τ = 2a: it is C B (τ + a)² (2a − τ)/6. Friction μN over it loses 9/8 μ N C B a⁴, the square of
the excess. On the level there are two such angles a revolution, which mirror each other.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from hophoop.kernel.model import Body, delassus, inertia_at_height, rolling_forces
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.numerics.collocation import ORDER, coefficients, value_slope_bend
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.records import new_scratch
from hophoop.results.units import Units
from hophoop.scenario import Hoop, InputError, Plane, Scenario
from hophoop.theory.kernels.critical import first_slip
from hophoop.theory.kernels.extrema import cone_margin_line

WINDOW = 0.02  # rad to either side of the first slip, where a polynomial of degree 15 is differentiated


class SlipDecay(NamedTuple):
    """Decay of the slip on the level.

    Attributes
    ----------
    omega : float
        θ̇ with the load at the bottom up to which the hoop rolls for ever [rad/s].
    rate : float
        A revolution that begins with the excess x of θ̇ above it ends with x − rate·x², for small x [s/rad].
    """

    omega: float
    rate: float

    def excess(self, first: float, revolutions: int) -> float:
        """Return the rest of an excess.

        Parameters
        ----------
        first : float
            Excess of θ̇ at the beginning [rad/s].
        revolutions : int

        Returns
        -------
        excess : float
            After many revolutions nearly 1/(rate·revolutions), whatever the first one was [rad/s].
        """
        return first / (1.0 + first * self.rate * revolutions)


def slip_decay(hoop: Hoop, plane: Plane = Plane()) -> SlipDecay:
    """Return how the slip of a hoop that rolls a little too fast dies away on the level.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
        Level, without rolling resistance, with one coefficient of friction.

    Returns
    -------
    decay : SlipDecay

    Raises
    ------
    ValueError
        If the plane is another one, or the hoop does not begin to slip at some speed.

    Examples
    --------
    >>> import hophoop as hh
    >>> decay = hh.theory.slip_decay(hh.Hoop.ideal(0.75), hh.Plane(gravity=1.0))
    >>> round(decay.omega, 9), round(decay.rate, 9)
    (2.996462703, 0.266172286)
    """
    if plane.slope != 0.0 or plane.gravity == 0.0:
        raise InputError("plane.slope must be 0 and plane.gravity above 0: slip dies away on the level.")
    if plane.rolling_resistance != 0.0 or plane.mu_static != plane.mu_kinetic:
        raise InputError("plane.rolling_resistance must be 0 and plane.mu one number: else no excess dies away by its square.")
    scenario = Scenario(hoop=hoop, plane=plane)
    body = scenario.to_body()
    if not (body.eps > 0.0 and body.kap > 0.0 and 0.0 < body.mu_s < math.inf):
        raise InputError("a hoop that slips at some speed needs hoop.load_fraction above 0 and below 1, and finite friction.")
    speed, angle, side = first_slip(body, new_scratch())
    if not 0.0 < speed < math.inf:
        raise InputError("this hoop begins to slip at no speed above 0: it slips from the smallest push on, or never.")
    squared = speed * speed
    s, c = sine_cosine(angle, 0.0)
    bottom = inertia_at_height(body, 0.0)
    energy_rate = 0.5 * inertia_at_height(body, 2.0)  # of v² at the top
    u = (inertia_at_height(body, 2.0) * squared + 2.0 * body.eps * body.gn * (1.0 - c)) / inertia_at_height(body, 1.0 + c)
    normal = rolling_forces(body, s, c, u, 0.0)[1]
    along, away, mixed = delassus(body, s, c)
    stiffness = away + side * body.mu_k * mixed
    if not stiffness > 0.0:
        raise InputError(f"plane.mu = {plane.mu_kinetic!r} must be less: the first slip of this hoop meets Painlevé's paradox.")
    freedom = (along * away - mixed * mixed) / stiffness
    missing = -math.sqrt(1.0 + body.mu_s * body.mu_s) * cone_margin_line(body, angle, side)[1]
    lost = 2.0 * 4.5 * body.mu_k * normal * freedom * missing / (u * _curvature(body, angle, side))  # by (excess of v²)²
    omega = math.sqrt((inertia_at_height(body, 2.0) * squared + 4.0 * body.eps * body.gn) / bottom)
    rate = lost * bottom * omega / (energy_rate * energy_rate)
    unit = Units.of_scenario(scenario).of("omega")
    return SlipDecay(omega * unit, float(rate / unit))


def _curvature(body: Body, angle: float, side: float) -> float:
    """Return the second derivative over θ of the v² at the top with which rolling needs all friction, near its minimum."""

    def squared_speed(th: float) -> float:
        steady, rate = cone_margin_line(body, th, side)
        return float(-steady / rate)

    series = np.empty(ORDER)
    coefficients(np.array([squared_speed(angle + WINDOW * node) for node in NODES.tolist()]), series)
    return float(value_slope_bend(series, 0.0)[2]) / (WINDOW * WINDOW)
