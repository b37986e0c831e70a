"""Attractors over a parameter: on what a hoop settles, from several starts each."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.errors import check_whole
from hophoop.gaits.computing import check, passages
from hophoop.gaits.maps import FASTEST, slowest_over_top
from hophoop.gaits.results import ENOUGH, Passages, dataset
from hophoop.results.units import Units
from hophoop.scenario import InputError, Scenario, Start
from hophoop.vocabulary.names import FATES, Fate

if TYPE_CHECKING:
    import xarray

Floats = NDArray[np.float64]
STARTS, PASSAGES = 5, 1_500
KEPT, JUDGED = 150, 650  # last passages whose θ̇ are kept, and those of a Lyapunov exponent
MOST_VALUES, MOST_STARTS, MOST_PASSAGES = 100_000, 1_000, 1_000_000
SAME_GAIT = 1e-6  # relative difference of mean speeds within which two gaits are one
SAME_CHAOS = 0.05  # the same of two irregular motions


class Attractor(NamedTuple):
    """On what some starts settle.

    Attributes
    ----------
    fate : Fate
    period, hops : int
        Passages of a gait's period, of the bottom if it lands no more, and hops in it; else 0 [1].
    sequence : str
        Phases of a gait's period, as in `Gait`; else empty.
    speed : float
        Mean velocity of the centre; nan without passages to take it from [m/s].
    lyapunov : float
        Exponent per passage of a motion that is no gait; nan otherwise [1].
    omega : ndarray, shape (n,)
        θ̇ at the passages after it has settled: a period of a gait, the last ones of a chaotic motion; else, or if it lands no
        more, empty [rad/s].
    starts : int
        How many of the starts settle on it.
    """

    fate: Fate
    period: int = 0
    hops: int = 0
    sequence: str = ""
    speed: float = math.nan
    lyapunov: float = math.nan
    omega: Floats = np.empty(0)
    starts: int = 1


MISSING = Attractor("", starts=0)  # type: ignore[arg-type]


@dataclass(frozen=True)
class Diagram:
    """Attractors over a parameter; made by `hophoop.gaits.diagram`.

    Attributes
    ----------
    scenario : Scenario
    path : str
        Of the parameter.
    values : ndarray, shape (n,)
        [SI].
    section : {'bottom', 'landing'}
    attractors : tuple of tuple of Attractor, length n
        Of each value, the one with the most starts first.
    complete : bool
        False if the computation was stopped: values or attractors may be missing.
    """

    scenario: Scenario
    path: str
    values: Floats
    section: str
    attractors: tuple[tuple[Attractor, ...], ...]
    complete: bool = True

    def to_xarray(self) -> xarray.Dataset:
        """Return the diagram as an xarray.Dataset over value, attractor and passage.

        Returns
        -------
        dataset : xarray.Dataset
            Every variable has units and long_name; what is missing is nan, 0 or empty.

        Raises
        ------
        ImportError
            If xarray is missing.
        """
        most = max(len(found) for found in self.attractors)
        kept = max(len(one.omega) for found in self.attractors for one in found)
        rows = [(*found, *[MISSING] * (most - len(found))) for found in self.attractors]
        axes = (self.path, "attractor")
        columns = [
            (name, [[getattr(one, name) for one in row] for row in rows], unit, meaning) for name, unit, meaning in _VARIABLES
        ]
        omega = [[np.pad(one.omega, (0, kept - len(one.omega)), constant_values=math.nan) for one in row] for row in rows]
        about = {"units": "rad/s", "long_name": "Angular velocity at the passages"}
        attributes = {
            "Conventions": "CF-1.11", "title": "Attractors of a loaded hoop", "section": self.section,
            "complete": int(self.complete), "scenario": self.scenario.to_query(),
        }  # fmt: skip
        found = dataset(columns, axes, attributes).assign_coords({self.path: self.values})
        return found.assign(omega=((*axes, "passage"), omega, about))

    def to_csv(self) -> str:
        """Return a table with one row per value and attractor.

        Returns
        -------
        text : str
            θ̇ at the passages is left out.
        """
        names = [name for name, *_ in _VARIABLES]
        rows = [(self.path, *names)]
        for value, several in zip(self.values.tolist(), self.attractors, strict=True):
            rows += [(repr(value), *(str(getattr(one, name)) for name in names)) for one in several]
        return "".join(",".join(row) + "\n" for row in rows)

    def __repr__(self) -> str:
        known = {str(one.fate) for found in self.attractors for one in found}
        several = sum(sum(FATES[one.fate].lasts for one in found) > 1 for found in self.attractors)
        return f"<Diagram: {len(self.values)} values of {self.path}, {', '.join(sorted(known))}; several at {several} values>"


# name, unit and meaning
_VARIABLES = (
    ("fate", "1", "What becomes of the motion"),
    ("sequence", "1", "Phases of a gait's period"),
    ("period", "1", "Passages of a gait's period"),
    ("hops", "1", "Hops in a gait's period"),
    ("starts", "1", "Starts that settle on it"),
    ("speed", "m/s", "Mean velocity of the centre along the plane"),
    ("lyapunov", "1", "Lyapunov exponent per passage"),
)


def diagram(
    scenario: Scenario,
    path: str,
    values: ArrayLike,
    starts: int | Sequence[float] = STARTS,
    *,
    passages: int = PASSAGES,
    section: str = "bottom",
    progress: Callable[[float], object] | None = None,
) -> Diagram:
    """Compute on what a hoop settles, for each value of a parameter and from several starts.

    Parameters
    ----------
    scenario : Scenario
        Its hoop and plane count, with rigid contact.
    path : str
        The parameter, such as 'plane.slope' or 'hoop.load_fraction'.
    values : array_like, shape (n,)
        Of the parameter, in the order in which they are computed [SI].
    starts : int or sequence of float, default 5
        How many θ̇ at the bottom, equally spaced from what just gets over the top to twice that; or these θ̇ [rad/s]. What was
        settled on at the value before and at the value after are more starts: coexisting attractors are followed both ways.
    passages : int, default 1500
        The most passages of each motion, from 650 to a million; it ends earlier when its fate is decided [1].
    section : {'bottom', 'landing'}, default 'bottom'
        As in `hophoop.passages`.
    progress : callable, optional
        Called with the computed fraction, 0 to 1.

    Returns
    -------
    diagram : Diagram
        Stopped by Ctrl-C, it holds the values that are done.

    Raises
    ------
    ValueError
        If an argument is not allowed.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> base = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=hh.Plane(gravity=1.0))
    >>> found = hh.gaits.diagram(base, "plane.slope", [math.radians(one) for one in (1.0, 1.02, 1.1, 1.18)])
    >>> [sorted((one.period, one.hops) for one in several if one.fate == "gait") for several in found.attractors]
    [[(1, 0), (1, 1)], [(1, 0), (1, 1)], [(1, 0), (2, 2)], [(2, 2)]]
    """
    check(scenario, section)
    places = np.array(values, float).reshape(-1)
    _check(places, starts, passages)
    cases = [scenario.replace(path, value) for value in places.tolist()]
    known: list[list[Attractor]] = [[] for _ in cases]
    ends: list[list[Start]] = [[] for _ in cases]
    order, done = [*range(len(cases)), *range(len(cases) - 2, -1, -1)], 0
    beside: list[Start] = []
    try:
        for k in order:
            begin = _starts(cases[k], starts) if done < len(cases) else []
            ends[k] += _settle(cases[k], [*begin, *beside], known[k], passages, section)
            beside = ends[k]
            done += 1
            if progress is not None:
                progress(done / len(order))
    except KeyboardInterrupt:
        if not done:
            raise
    whole = min(done, len(cases))
    attractors = tuple(tuple(sorted(some, key=lambda one: -one.starts)) for some in known[:whole])
    return Diagram(scenario, path, places[:whole], section, attractors, done == len(order))


def _check(places: Floats, starts: int | Sequence[float], count: int) -> None:
    if not 1 <= len(places) <= MOST_VALUES or not np.isfinite(places).all():
        raise InputError(f"values must be 1 to {MOST_VALUES} finite numbers.")
    number = starts if isinstance(starts, int) else len(starts)
    if isinstance(starts, bool) or not 1 <= number <= MOST_STARTS:
        raise InputError.of_field("starts", starts, f"1 to {MOST_STARTS} starts")
    check_whole("passages", count, JUDGED, MOST_PASSAGES)


def _starts(scenario: Scenario, starts: int | Sequence[float]) -> list[Start]:
    unit = Units.of_scenario(scenario).of("omega")
    if isinstance(starts, int):
        ahead = -1.0 if scenario.plane.slope < 0.0 else 1.0
        over = math.sqrt(2.0) * slowest_over_top(scenario)  # just over the top, on the level
        low = over or 0.1 * FASTEST["bottom"]
        rates = (ahead * unit * np.linspace(1.05 * low, 2.0 * low, starts)).tolist()
    else:
        rates = [float(rate) for rate in starts]
    return [Start.rolling(rate * scenario.hoop.radius, angle=math.pi) for rate in rates]


def _settle(scenario: Scenario, starts: list[Start], known: list[Attractor], count: int, section: str) -> list[Start]:
    """Add to the known attractors those on which the starts settle; return one start on each new one that lasts."""
    ends: list[Start] = []
    for start in starts:
        given = scenario.replace("start", start)
        found = passages(given, count, section=section, until_decided=True)
        if found.decided == Fate.GAIT and found.period == 0:  # it lands no more
            found = passages(given, count, until_decided=True)
        seen = _described(found, section)
        place = next((k for k, one in enumerate(known) if _same(one, seen)), None)
        if place is not None:
            known[place] = known[place]._replace(starts=known[place].starts + 1)
            continue
        if seen.fate == Fate.UNDECIDED and len(found) >= ENOUGH:
            last = replace(found, numbers=found.numbers[-JUDGED:], packed=found.packed[-JUDGED:])
            seen = seen._replace(fate=last.fate, lyapunov=last.lyapunov.value)
        known.append(seen)
        if len(found) and seen.fate in (Fate.GAIT, Fate.CHAOTIC, Fate.UNDECIDED):
            ends.append(_normal(found.start(-1)))
    return ends


def _normal(start: Start) -> Start:
    """Return a start near θ = 0 and x = 0, so that no digits are lost over many values."""
    angle = start.angle - 2.0 * math.pi * round((start.angle - math.pi) / (2.0 * math.pi))
    return start.model_copy(update={"x": 0.0, "angle": angle})


def _described(found: Passages, section: str) -> Attractor:
    """Return the attractor of a motion, without its Lyapunov exponent, and without θ̇ at another section."""
    fate, period, count = found.decided, found.period, len(found)
    if not period and not (fate == Fate.UNDECIDED and count > 2 * KEPT):
        return Attractor(fate)
    before = count - 1 - (period or (count - 1) // 2)
    speed = float(found.x[-1] - found.x[before]) / float(found.t[-1] - found.t[before])
    omega = found.omega[-(period or KEPT) :].copy() if found.section == section else np.empty(0)
    hops, sequence = found.hops[count - period :].sum(), "·".join(found.sequences[count - period :])
    return Attractor(fate, period, int(hops), sequence, speed, omega=omega)


def _same(one: Attractor, other: Attractor) -> bool:
    """Return True if two motions have settled on the same."""
    fate, its_fate = (Fate.CHAOTIC if each.fate == Fate.UNDECIDED else each.fate for each in (one, other))
    if (fate, one.period, one.hops) != (its_fate, other.period, other.hops):
        return False
    unknown = math.isnan(one.speed) and math.isnan(other.speed)
    return unknown or math.isclose(one.speed, other.speed, rel_tol=SAME_GAIT if fate == Fate.GAIT else SAME_CHAOS)
