"""Numbers of the figures of compliant contact: the article's motions on a spring."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop.kernel.numerics.elementwise import arccosine, sine_and_cosine
from hophoop.kernel.physics.compliant import KELVIN_VOIGT, Compliance, FrictionLaw, normal_force
from hophoop.kernel.physics.contact import contact_arms
from hophoop.kernel.physics.impact import impulse_ratio, slip_rates
from hophoop.results.records import EventRecord
from hophoop.scenario import Compliant, Hoop, InputError, Plane, Scenario, Start
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory

Floats = NDArray[np.float64]

# The article's runs: speed at the top [m/s], friction, and a duration with their first cycles [s].
RUNS: dict[str, tuple[float, float, float]] = {
    "v₀ = 0.1 m/s": (0.1, 1.0, 4.0),
    "v₀ = 2 m/s": (2.0, 1.0, 3.0),
    "v₀ = 2.8 m/s": (2.8, 1.0, 3.0),
    "v₀ = 3.1 m/s, to the landing": (3.1, 1.0, 1.8),
    "v₀ = 3.1 m/s, beyond it": (3.1, 1.0, 2.0),
    "v₀ = 0.1 m/s, μ = 0.3": (0.1, 0.3, 6.0),
}
STIFFNESSES: Floats = 10.0 ** np.arange(3.0, 10.5, 0.5)
"""Stiffness over m g / R."""


def with_contact(scenario: Scenario, stiffness: float, slip_speed: float | None = None, **others: Any) -> Scenario:
    """Return a scenario with compliant contact, stiffness and slip speed in natural units.

    Further arguments are those of `hophoop.Compliant`.

    Parameters
    ----------
    scenario : Scenario
        With gravity.
    stiffness : float
        Over m g / R [1].
    slip_speed : float, optional
        Over √(g R) [1].

    Returns
    -------
    scenario : Scenario
    """
    hoop, gravity = scenario.hoop, scenario.plane.gravity
    if slip_speed is not None:
        others["slip_speed"] = slip_speed * math.sqrt(gravity * hoop.radius)
    contact = Compliant(stiffness=stiffness * hoop.mass * gravity / hoop.radius, **others)
    return scenario.model_copy(update={"contact": contact.to_dict()})


def article_run(name: str) -> Scenario:
    """Return one of `RUNS` with rigid contact.

    Parameters
    ----------
    name : str

    Returns
    -------
    scenario : Scenario
    """
    speed, mu, duration = RUNS[name]
    return Scenario(plane=Plane(mu=mu), start=Start.rolling(speed), duration=duration)


def angle_error(scenario: Scenario, compliant: Scenario, times: int = 400) -> float:
    """Return the maximum difference of θ between a rigid and a compliant motion.

    Parameters
    ----------
    scenario, compliant : Scenario
        Of equal duration.
    times : int, default 400
        Number of equally spaced times of the comparison.

    Returns
    -------
    error : float
        [rad].
    """
    rigid, soft = simulate(scenario), simulate(compliant)
    t = np.linspace(0.0, min(rigid.duration, soft.duration), times)
    return float(np.max(np.abs(soft.at(t).angle - rigid.at(t).angle)))


def convergence(stiffnesses: ArrayLike = STIFFNESSES, **contact: Any) -> dict[str, Floats]:
    """Return the errors of the article's motions on a compliant plane.

    Further arguments are those of `with_contact`.

    Parameters
    ----------
    stiffnesses : array_like
        Over m g / R [1].

    Returns
    -------
    errors : dict of ndarray
        For each run the maximum difference of θ [rad].
    """
    ladder = np.asarray(stiffnesses, dtype=float)
    result = {}
    for name in RUNS:
        rigid = article_run(name)
        result[name] = np.array([angle_error(rigid, with_contact(rigid, k, **contact)) for k in ladder])
    return result


def order(stiffnesses: ArrayLike, errors: ArrayLike) -> float:
    """Fit the order of convergence, minus the slope of the logarithms.

    Parameters
    ----------
    stiffnesses, errors : array_like, shape (n,)
        In any units [1].

    Returns
    -------
    order : float
        error ~ stiffness^−order [1].
    """
    return float(-np.polyfit(np.log(np.asarray(stiffnesses)), np.log(np.asarray(errors)), 1)[0])


# --- landings ------------------------------------------------------------------------------------


class Landing(NamedTuple):
    """Losses and velocities of a landing.

    Attributes
    ----------
    normal, tangential : float
        Energy lost in the normal direction and along the plane [J].
    slip, rise : float
        Slip velocity and velocity of separation after it [m/s].
    """

    normal: float
    tangential: float
    slip: float
    rise: float


def landing(motion: Trajectory, within: float = 0.02) -> Landing:
    """Return the first landing of a motion.

    Parameters
    ----------
    motion : Trajectory
        Rigid or compliant.
    within : float, default 0.02
        Maximum duration of a compliant landing; it ends earlier with a lift-off [s].

    Returns
    -------
    landing : Landing

    Raises
    ------
    ValueError
        If there is no landing.
    """
    events = motion.events
    index = next((i for i, event in enumerate(events) if event.kind == "impact"), -1)
    if index < 0:
        raise InputError("the motion has no landing.")
    touch = events[index]
    if motion.scenario.contact.model == "rigid":
        ahead = events[index - 1]
        return Landing(
            touch.impact_normal - ahead.impact_normal,
            touch.impact_tangential - ahead.impact_tangential,
            touch.slip,
            touch.vy,
        )
    leaves = [event.t for event in motion.find("takeoff") if event.t > touch.t]
    end = min([touch.t + within, motion.duration, *leaves[:1]])
    before, after = motion.at(touch.t), motion.at(end, side="left")
    return Landing(
        after.damping - before.damping + after.spring,  # the energy of the spring is lost after the lift-off
        after.friction - before.friction,
        after.slip,
        after.vy,
    )


def impact_restitution(hoop: Hoop, plane: Plane, touch: EventRecord, number: float, law: str) -> float:
    """Return the energetic restitution of one landing on an infinitely stiff contact.

    The hoop does not move while the impulse grows, and the ratio of impulses is Coulomb's. So the landing follows Routh's
    line of impulses, and the normal law determines its end.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
    touch : EventRecord
        The impact, of the rigid motion.
    number : float
        c / √(k m), or d √(g R) in Hunt and Crossley's law [1].
    law : {'kelvin-voigt', 'hunt-crossley'}

    Returns
    -------
    restitution : float
        √(work of restitution / work of compression), as in Stronge's law [1].
    """
    speed = math.sqrt(plane.gravity * hoop.radius)
    kelvin = law == "kelvin-voigt"
    # in this limit only the product of time and √k matters: k = 1
    comp = Compliance(
        KELVIN_VOIGT if kelvin else 1 - KELVIN_VOIGT, int(FrictionLaw.LINEAR), 1.0,
        number if kelvin else 0.0, 0.0 if kelvin else number, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0,
    )  # fmt: skip
    body = Scenario(hoop=hoop, plane=plane).to_body()
    s, c = sine_and_cosine(touch.angle)
    arm, lever = contact_arms(body, s, c)
    y, vt, vn = 0.0, touch.before.slip / speed, touch.before.vy / speed
    compression = restitution = 0.0
    step = 0.002 / (1.0 + (number if kelvin else 0.0))
    while True:
        r, stuck = impulse_ratio(body, arm, lever, vt)
        _, drag, gain = slip_rates(body, arm, lever, r)
        length = step
        for _ in range(60):  # the midpoint rule, repeated if the slip or the contact ends in a step
            force = normal_force(comp, y, vn)[0]
            middle = vn + 0.5 * length * gain * force
            force = normal_force(comp, y + 0.5 * length * vn, middle)[0]
            rise, slid, after = y + length * middle, vt + length * drag * force, vn + length * gain * force
            share = 1.0
            if not stuck and slid * vt < -1e-14 * abs(vt):
                share = vt / (vt - slid)
            last = normal_force(comp, rise, after)[0]
            if compression > 0.0 and last < -1e-13 and after > 0.0:
                start = normal_force(comp, y, vn)[0]
                share = min(share, start / (start - last))
            if share == 1.0:
                break
            length *= share
        work = force * middle * length
        if middle < 0.0:
            compression -= work
        else:
            restitution += work
        y, vn, vt = rise, after, 0.0 if stuck or abs(slid) < 1e-10 else slid
        if vn > 0.0 and normal_force(comp, y, vn)[0] <= 1e-12:
            break
    return math.sqrt(restitution / compression)


def matched_number(hoop: Hoop, plane: Plane, touch: EventRecord, restitution: float, law: str) -> float:
    """Return the damping of a stiff contact for a given restitution of one landing.

    Parameters
    ----------
    hoop, plane, touch, law
        As in `impact_restitution`.
    restitution : float
        Between 0 and 1 [1].

    Returns
    -------
    number : float
        c / √(k m) or d √(g R) [1].
    """
    low, high = 0.0, 1.0
    while impact_restitution(hoop, plane, touch, high, law) > restitution:
        low, high = high, 2.0 * high
    for _ in range(24):
        middle = 0.5 * (low + high)
        if impact_restitution(hoop, plane, touch, middle, law) > restitution:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def landing_scenario(restitution: float = 0.0, impact_law: str = "stronge", duration: float = 2.0) -> Scenario:
    """Return the article's hop at 3.1 m/s.

    Parameters
    ----------
    restitution : float, default 0
        [1].
    impact_law : {'stronge', 'newton', 'poisson'}
    duration : float, default 2
        [s].

    Returns
    -------
    scenario : Scenario
    """
    plane = Plane(restitution=restitution, impact_law=impact_law)
    return Scenario(plane=plane, start=Start.rolling(3.1), duration=duration)


def touch_scenario(restitution: float = 0.0, impact_law: str = "stronge", duration: float = 0.05) -> Scenario:
    """Return only the landing of that hop: a start at the plane with the velocities of the rigid hoop at touch.

    Parameters
    ----------
    restitution, impact_law
        As in `landing_scenario` [1].
    duration : float, default 0.05
        [s].

    Returns
    -------
    scenario : Scenario
    """
    whole = landing_scenario(restitution, impact_law)
    touch = simulate(whole).find("impact")[0]
    start = Start(angle=touch.angle, vx=touch.before.vx, vy=touch.before.vy, omega=touch.before.omega)
    return whole.model_copy(update={"start": start.to_dict(), "duration": duration})


def matched_landings(
    restitutions: Sequence[float] = (0.2, 0.5, 0.8),
    stiffnesses: ArrayLike = STIFFNESSES,
    law: str = "kelvin-voigt",
) -> dict[float, tuple[float, Floats]]:
    """Compute the convergence of the landing at 3.1 m/s, with damping matched to the rigid plane's restitution.

    The motions are compared until shortly before the second landing of the rigid hoop, whose angle gives another restitution.

    Parameters
    ----------
    restitutions : sequence of float
        e of Stronge's law [1].
    stiffnesses : array_like
        Over m g / R [1].
    law : {'kelvin-voigt', 'hunt-crossley'}

    Returns
    -------
    errors : dict of (number, ndarray)
        For each e the matched c/√(k m) or d √(g R), and the maximum difference of θ for each stiffness [rad].
    """
    result = {}
    for e in restitutions:
        rigid = landing_scenario(restitution=e)
        touch, again = simulate(rigid).find("impact")[:2]
        rigid = rigid.model_copy(update={"duration": touch.t + 0.9 * (again.t - touch.t)})
        hoop, plane = rigid.hoop, rigid.plane
        number = matched_number(hoop, plane, touch, e, law)
        speed = math.sqrt(plane.gravity * hoop.radius)
        errors = []
        for k in np.asarray(stiffnesses, dtype=float):
            stiffness = k * hoop.mass * plane.gravity / hoop.radius
            damping = number * math.sqrt(stiffness * hoop.mass) if law == "kelvin-voigt" else number / speed
            errors.append(angle_error(rigid, with_contact(rigid, k, damping=damping, law=law)))
        result[e] = (number, np.array(errors))
    return result


# --- Painlevé ------------------------------------------------------------------------------------


def painleve_scenario(omega: float = 0.0, duration: float = 0.4, painleve: str = "flight") -> Scenario:
    """Return the reference hoop sliding ahead at 1 m/s on its rim at θ = −41.4°, where cos θ = γ, with μ = 1.

    Its slip is in Painlevé's region: no contact force is consistent (`omega` = 0), or several motions are possible (`omega`
    = 5, indeterminate).

    Parameters
    ----------
    omega : float, default 0
        [rad/s].
    duration : float, default 0.4
        [s].
    painleve : {'flight', 'impact'}

    Returns
    -------
    scenario : Scenario
    """
    start = Start(angle=-arccosine(0.75), vx=1.0 + omega, omega=omega)
    return Scenario(plane=Plane(painleve=painleve), start=start, duration=duration)


def painleve_errors(omega: float, painleve: str, stiffnesses: ArrayLike = STIFFNESSES, **contact: Any) -> Floats:
    """Return the errors of compliant motions in Painlevé's region relative to the rigid one.

    Parameters
    ----------
    omega : float
        As in `painleve_scenario` [rad/s].
    painleve : {'flight', 'impact'}
    stiffnesses : array_like
        Over m g / R [1].

    Returns
    -------
    errors : ndarray
        Maximum difference of θ [rad].
    """
    rigid = painleve_scenario(omega, painleve=painleve)
    ladder = np.asarray(stiffnesses, dtype=float)
    return np.array([angle_error(rigid, with_contact(rigid, k, **contact)) for k in ladder])
