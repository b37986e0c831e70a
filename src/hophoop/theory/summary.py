"""Thresholds and closed forms of one hoop on its plane as text, for the command line and the lab."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from hophoop._support.errors import check_type
from hophoop._version import __version__
from hophoop.scenario import Hoop, InputError, Plane, Scenario
from hophoop.theory.critical import first_hop_speed, first_slip_speed, hop_angle, immediate_hop_speed, slip_angle
from hophoop.theory.massless import massless_loss
from hophoop.theory.painleve import jam_states, painleve_minimum
from hophoop.theory.rest import equilibria, rest_ranges
from hophoop.theory.rolling import max_rolling_speed, needed_friction, rolling_period


class Quantity(NamedTuple):
    """One quantity of theory.

    Attributes
    ----------
    key : str
        Its name in JSON.
    words : str
        Its name for people.
    unit : str
        "1" for a pure number.
    value : float or None
        In SI units, None where there is none [SI].
    note : str
        A remark.
    """

    key: str
    words: str
    unit: str
    value: float | None
    note: str = ""


def summary(scenario: Scenario) -> tuple[Quantity, ...]:
    """Return thresholds and closed forms of a hoop on its plane.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    quantities : tuple of Quantity
        One that the hoop or the plane does not have gives the reason.

    Examples
    --------
    >>> found = {quantity.key: quantity for quantity in summary(Scenario())}
    >>> round(found["first_slip_speed"].value, 6), found["first_slip_speed"].unit
    (2.043174, 'm/s')
    """
    check_type("scenario", scenario, Scenario)
    return tuple(_quantities(scenario))


def summary_dict(scenario: Scenario) -> dict[str, Any]:
    """Return the quantities of `summary`, ready for JSON.

    document: `theory` by key in SI units: "inf" for one without a bound, None for one without a value; `notes` by key.
    """

    def plain(value: float | None) -> float | str | None:
        if value is None or math.isnan(value):
            return None
        return value if math.isfinite(value) else "inf" if value > 0.0 else "-inf"

    rows = summary(scenario)
    return {
        "schema": "hophoop-theory/1",
        "version": __version__,
        "scenario": scenario.to_dict(),
        "theory": {row.key: plain(row.value) for row in rows},
        "notes": {row.key: row.note for row in rows if row.note},
    }


def _quantities(scenario: Scenario) -> Iterator[Quantity]:
    hoop, plane = scenario.hoop, scenario.plane
    yield Quantity("eccentricity", "eccentricity ε", "1", hoop.eccentricity)
    yield Quantity("inertia_ratio", "moment of inertia κ", "1", hoop.inertia_ratio)
    yield _row("first_slip_speed", "slips in the first turn from v₀ =", "m/s", first_slip_speed, hoop, plane)
    yield _row("first_hop_speed", "hops in the first turn from v₀ =", "m/s", first_hop_speed, hoop, plane)
    yield _row("immediate_hop_speed", "hops at once from v₀ =", "m/s", immediate_hop_speed, hoop, plane)
    yield from _painleve(hoop, plane)
    yield from _jams(hoop, plane)
    yield from _start(scenario)
    yield from _rest(hoop, plane)
    if hoop.massless and plane.slope == 0.0:
        speed = scenario.start.speed or 0.0
        yield _row(
            "massless_loss_angle", "the massless hoop loses its contact force at θ =", "rad",
            lambda: massless_loss(speed, hoop.radius, plane).angle,
        )  # fmt: skip


def _painleve(hoop: Hoop, plane: Plane) -> Iterator[Quantity]:
    if hoop.massless:
        return
    if plane.rolling_resistance > 0.0:
        note = "not known with rolling resistance"
        yield Quantity("painleve_friction", "Painlevé's paradox from μ", "1", None, note)
        yield Quantity("painleve_angle", "    there at θ", "rad", None, note)
        return
    mu, angle = painleve_minimum(hoop)
    yield _row("painleve_friction", "Painlevé's paradox from μ =", "1", float, mu)
    yield _row("painleve_angle", "    there at θ =", "rad", float, angle)


def _jams(hoop: Hoop, plane: Plane) -> Iterator[Quantity]:
    if plane.gravity <= 0.0 or hoop.massless or plane.rolling_resistance > 0.0:
        return
    for k, state in enumerate(jam_states(hoop, plane)):
        note = f"in slip {state.mode}, at θ̇ = {state.omega:.6g} rad/s"
        yield Quantity("jam_angle" if k == 0 else f"jam_angle_{k + 1}", "dynamic jam at θ =", "rad", float(state.angle), note)


def _start(scenario: Scenario) -> Iterator[Quantity]:
    hoop, plane, start = scenario.hoop, scenario.plane, scenario.start
    if start.speed is None or start.angle != 0.0:
        note = "for a rolling start with the load at the top: --v0, --angle 0"
        yield Quantity("start_speed", "rolling from v₀", "m/s", None, note)
        return
    speed = start.speed
    yield Quantity("start_speed", "rolling from v₀ =", "m/s", speed)
    yield _row("needed_friction", "    needs μ =", "1", lambda: needed_friction(hoop, speed, plane).mu)
    yield _row("needed_friction_angle", "    there at θ =", "rad", lambda: needed_friction(hoop, speed, plane).angle)
    yield _row("slip_angle", "    slips first at θ =", "rad", slip_angle, hoop, speed, plane)
    yield _row("hop_angle", "    hops first at θ =", "rad", hop_angle, hoop, speed, plane)
    yield _row("max_rolling_speed", "    largest θ̇ if it rolled", "rad/s", max_rolling_speed, hoop, speed, plane)
    yield _row("rolling_period", "    a whole turn if it rolled", "s", rolling_period, hoop, speed, plane)


def _rest(hoop: Hoop, plane: Plane) -> Iterator[Quantity]:
    if plane.rolling_resistance > 0.0:
        for k, found in enumerate(rest_ranges(hoop, plane) if plane.gravity > 0.0 else ()):
            note = "" if found.holds else "more than friction holds"
            more = "" if k == 0 else f"_{k + 1}"
            yield Quantity(f"rest_from{more}", "rolling resistance holds it from θ =", "rad", found.low, note)
            yield Quantity(f"rest_to{more}", "    to θ =", "rad", found.high, note)
        return
    for rest in equilibria(hoop, plane):
        kind = "stable" if rest.stable else "unstable"
        note = "" if rest.holds else "more than friction holds"
        yield Quantity(f"{kind}_angle", f"{kind} equilibrium at θ =", "rad", rest.angle, note)
        if rest.stable:
            yield Quantity("rocking_period", "    small rocking", "s", rest.period)


def _row(key: str, words: str, unit: str, quantity: Callable[..., Any], *arguments: Any) -> Quantity:
    """Return the value of a function, or why it has none."""
    try:
        value = float(quantity(*arguments))
    except InputError as error:
        return Quantity(key, words, unit, None, str(error))
    note = ""
    if math.isnan(value):
        note = "not within the first turn" if key in ("slip_angle", "hop_angle") else "turns back or leaves the plane"
        return Quantity(key, words, unit, None, note)
    if math.isinf(value):
        note = "never" if key.endswith("speed") else ""
    return Quantity(key, words, unit, value, note)
