"""The kernel's names, in one place; its functions over balls, by a copier that lets no tolerance through."""

from __future__ import annotations

import dis
import math
from collections.abc import Callable
from functools import cache
from types import FunctionType, SimpleNamespace
from typing import Any

from hophoop.kernel.model import STATUS_NAMES as STATUS_NAMES
from hophoop.kernel.model import Event as Event
from hophoop.kernel.model import ImpactLaw as ImpactLaw
from hophoop.kernel.model import Mode as Mode
from hophoop.kernel.model import Status as Status
from hophoop.kernel.model import (
    acceleration_in_contact,
    contact_arms,
    flight_displacement,
    flight_rates,
    free_acceleration,
    kinetic_energy,
    potential_energy,
    resistance_arm,
    rolling_acceleration,
    rolling_forces,
    rolling_u,
    slip_displacement,
    slip_motion,
    slip_rates,
    slip_torque_arm,
    stick_rates,
    torque_at_rest,
)
from hophoop.kernel.model import slip_direction as slip_direction
from hophoop.kernel.native.marks import source_of
from hophoop.kernel.records import STOP_AT_TAKEOFF as STOP_AT_TAKEOFF
from hophoop.kernel.records import STOP_AT_TURN as STOP_AT_TURN
from hophoop.kernel.records import PendingEvent as PendingEvent
from hophoop.kernel.records import State as State
from hophoop.kernel.steps import Ending as Ending
from hophoop.kernel.steps import Limits as Limits
from hophoop.kernel.steps import begin, collide, contact_step, flight_start, land, vanishing_slip_derivatives
from hophoop.kernel.steps import end_motion as end_motion
from hophoop.kernel.steps import limits_of as limits_of
from hophoop.precise import kernels
from hophoop.prove.numbers import Ball, arb, flint, raw, root, sign

# The kernels that are called; a body has their copies under their names.
FORMULAS: tuple[Callable[..., Any], ...] = (
    acceleration_in_contact, begin, collide, contact_arms, contact_step, flight_displacement, flight_rates, flight_start,
    free_acceleration, kinetic_energy, land, potential_energy, resistance_arm, rolling_acceleration, rolling_forces, rolling_u,
    slip_displacement, slip_motion, slip_rates, slip_torque_arm, stick_rates, torque_at_rest, vanishing_slip_derivatives,
)  # fmt: skip
# What is a tolerance in doubles: balls compare exactly. Any other float that is not a small multiple of 1/4 is refused.
TOLERANCES = ("TIE", "ZERO", "GAIN_FLOOR", "ROUNDING", "SMALLEST_SQUARE", "RISING", "CLOSE")
LITERALS = {1e-9, 1e-13}  # of `impact`, and of `flight_start`
COARSEST, MOST = 0.25, 4.0


@cache
def global_names(function: FunctionType) -> tuple[str, ...]:
    """The globals that a function reads."""
    return tuple({one.argval for one in dis.get_instructions(function) if one.opname == "LOAD_GLOBAL"})


class Formulas(kernels.Kernels):
    """Copies of `FORMULAS` over balls, under their names; every name that is given is one that a kernel reads.

    Parameters
    ----------
    names : dict
        The values in place of the kernel's own.
    Raises
    ------
    LookupError
        If a kernel has a tolerance that is not named, or a name or a literal is used by none.
    """

    def __init__(self, names: dict[str, Any]) -> None:
        super().__init__(Ball, names)
        self._unused: set[str | float] = {*names, *LITERALS}
        for formula in FORMULAS:
            setattr(self, formula.__name__, self(formula))
        if self._unused:
            raise LookupError(f"No kernel reads {', '.join(sorted(map(str, self._unused)))}.")

    def __call__(self, kernel: Callable[..., Any]) -> Callable[..., Any]:
        """Return the copy of a kernel."""
        function = source_of(kernel)
        if function not in self._copies:
            for name in global_names(function):
                value = function.__globals__.get(name)
                if name not in self._names and isinstance(value, float):
                    self._accept(value, f"{function.__name__} reads {name}")
                self._unused.discard(name)
        return super().__call__(kernel)

    def _constants(self, values: tuple[Any, ...]) -> tuple[Any, ...]:
        for value in values:
            if value in LITERALS:
                self._unused.discard(value)
            elif isinstance(value, float):
                self._accept(value, "a kernel reads")
        return super()._constants(tuple(0.0 if value in LITERALS else value for value in values))

    @staticmethod
    def _accept(value: float, who: str) -> None:
        if not (math.isfinite(value) and abs(value) <= MOST and value % COARSEST == 0):
            raise LookupError(f"{who} = {value!r}, which may be a tolerance: name it.")


def names_of_balls() -> dict[str, Any]:
    """What kernels read under these names to compute with balls."""

    def cosine_and_sine(x: Any) -> tuple[Any, Any]:
        s, c = raw(x).sin_cos()
        return (Ball(c), Ball(s)) if isinstance(s, flint.arb) else (c, s)

    def sine_and_versine(x: Any) -> tuple[Any, Any]:
        return x.sin(), 1 - x.cos()

    def change(s: Any, c: Any, angle: Any) -> tuple[Any, Any]:
        _, _, versine = remainders(angle)
        _, sine = cosine_and_sine(angle)
        return c * sine - s * versine, -s * sine - c * versine

    def remainders(phi: Any) -> tuple[Ball, Ball, Ball]:
        """As hypergeometric series where else most would cancel."""
        x, half = raw(phi), (raw(phi) / 2).sin()
        if not (isinstance(x, flint.arb) and abs(x) < 1):
            return x - x.sin(), x.cos() - 1 + x * x / 2, 2 * half * half
        z = -x * x / 4
        cubic, quartic = z.hypgeom([1], [2, arb(2.5)]), z.hypgeom([1], [arb(2.5), 3])
        return Ball(x**3 / 6 * cubic), Ball(x**4 / 24 * quartic), Ball(2 * half * half)

    context = SimpleNamespace(
        inf=Ball(math.inf), nan=math.nan,
        isinf=lambda x: not raw(x).is_finite() and raw(x).is_exact(), isnan=lambda x: raw(x).is_nan(), sqrt=root,
        sin=lambda x: Ball(raw(x).sin()), cos=lambda x: Ball(raw(x).cos()), cos_sin=cosine_and_sine,
    )  # fmt: skip
    return kernels.numbers_of(context) | {
        "sine_cosine_change": change, "sine_and_versine": sine_and_versine, "series_remainders": remainders,
        "load_height": lambda s, c: 1 + c, "sign_beyond": sign, "LARGE_ROTATION": Ball(math.inf),
        **dict.fromkeys(TOLERANCES, Ball(0)),
    }  # fmt: skip
