"""Axes of a map: parameter and values; and the shape of its chunks."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Mapping, Sequence
from decimal import Context, Decimal, localcontext
from numbers import Real
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.errors import check_type
from hophoop.kernel.numerics.elementwise import exponential
from hophoop.scenario import InputError, Scenario, parameter
from hophoop.scenario.models import Rigid
from hophoop.scenario.paths import contradiction
from hophoop.vocabulary.parameters import PARAMETERS, RANGES

SECTIONS = ("duration", "hoop", "plane", "start", "contact")
MOST_VALUES = 100_000_000  # on one axis, since its values are in memory
LN_10 = float.fromhex("0x1.26bb1bbb55516p+1")
LOWEST_DECADE, HIGHEST_DECADE = -323, 308  # of doubles
TENS = np.array([float(f"1e{decade}") for decade in range(LOWEST_DECADE, HIGHEST_DECADE + 1)])
TWO_AXES = "{one} and {other} cannot both be axes: they say the same thing in two ways."


class Axis(NamedTuple):
    """One axis of a map.

    Attributes
    ----------
    path : str
        The parameter, such as ``"plane.mu"``.
    values : ndarray
        Its values, in the parameter's unit [SI], or words.
    unit : str
        Its unit.
    description : str
        Its meaning.
    """

    path: str
    values: NDArray[Any]
    unit: str
    description: str


def linear(first: float, last: float, count: int) -> NDArray[np.float64]:
    """Return equally spaced values.

    Parameters
    ----------
    first, last : float
        Ends, both included, in the parameter's unit [SI].
    count : int
        Number of values, from 1 to 100,000,000.

    Returns
    -------
    values : ndarray, shape (count,)
        In the parameter's unit [SI].

    Raises
    ------
    ValueError
        If count is not from 1 to 100,000,000, or an end is not finite.

    Examples
    --------
    >>> linear(0.5, 2.0, 4)
    array([0.5, 1. , 1.5, 2. ])
    """
    for end in (first, last):
        check_type("end of an axis", end, Real)
    if not math.isfinite(float(last) - float(first)):
        raise InputError(f"The ends {first!r} and {last!r} of an axis must be finite, and so must their difference.")
    return np.linspace(first, last, _count(count))


def logarithmic(first: float, last: float, count: int) -> NDArray[np.float64]:
    """Return values of equal ratios.

    Parameters
    ----------
    first, last : float
        Ends above 0, both included, in the parameter's unit [SI].
    count : int
        Number of values, from 1 to 100,000,000.

    Returns
    -------
    values : ndarray, shape (count,)
        In the parameter's unit [SI].

    Raises
    ------
    ValueError
        If count is not from 1 to 100,000,000, or an end is not above 0.

    Examples
    --------
    >>> logarithmic(0.01, 1.0, 3)
    array([0.01, 0.1 , 1.  ])
    """
    for end in (first, last):
        check_type("end of an axis", end, Real)
        if not end > 0.0:
            raise InputError.of_field("end of a logarithmic axis", end, "greater than 0")
        if end == math.inf:
            raise InputError.of_field("end of a logarithmic axis", end, "finite")
    return geometric(first, last, _count(count))


def geometric(first: float, last: float, count: int) -> NDArray[np.float64]:
    """Return values of equal ratios, the same bits on every machine; powers of ten among them are exact."""
    with localcontext(Context(prec=30)):
        low, high = (float(Decimal(float(end)).log10()) for end in (first, last))
    exponents = np.linspace(low, high, count)
    decades = np.floor(exponents + 0.5)
    values: NDArray[np.float64] = TENS[(decades - LOWEST_DECADE).astype(int)] * exponential((exponents - decades) * LN_10)
    values[0], values[-1] = first, last
    return values


def has_equal_ratios(values: NDArray[np.float64]) -> bool:
    """Return True if the values of an axis are spaced by ratio."""
    if values.size < 3 or values[0] <= 0.0:
        return False
    steps, ratios = np.diff(values), values[1:] / values[:-1]
    return bool(np.ptp(ratios) < 1e-6 * ratios.max() and np.ptp(steps) > 1e-6 * np.abs(steps).max())


def _count(count: int) -> int:
    if not 1 <= count <= MOST_VALUES or count != int(count):
        raise InputError.of_field("count", count, f"an integer from 1 to {MOST_VALUES:,}")
    return int(count)


def parse_axis(text: str) -> tuple[str, NDArray[Any]]:
    """Parse an axis of the command line, ``path=first:last:count``, perhaps with ``:log`` for equal ratios, or ``path=a,b,c``.

    Examples
    --------
    >>> parse_axis("plane.mu=0.5:1.5:3")
    ('plane.mu', array([0.5, 1. , 1.5]))
    >>> parse_axis("plane.impact_law=newton,stronge")[1].tolist()
    ['newton', 'stronge']
    """
    path, equals, rest = text.partition("=")
    path = path.strip()
    usage = f"axis {text!r} must read path=first:last:count, path=first:last:count:log or path=a,b,c."
    if not equals or not path or not rest:
        raise InputError(usage)
    parts = rest.split(":")
    if len(parts) == 1:
        words = [word.strip() for word in rest.split(",")]
        try:
            return path, np.array([float(word) for word in words])
        except ValueError:
            return path, np.array(words)
    spacing = {3: linear, 4: logarithmic}.get(len(parts))
    if spacing is None or parts[3:] not in ([], ["log"]):
        raise InputError(usage)
    try:
        first, last, count = float(parts[0]), float(parts[1]), int(parts[2])
    except ValueError:
        raise InputError(usage) from None
    return path, spacing(first, last, count)


def make_axes(base: Scenario, axes: Mapping[str, ArrayLike]) -> tuple[Axis, ...]:
    """Check the axes of a map, values by path in SI units, against the scenario that they vary."""
    if not axes:
        raise InputError(f"axes = {list(axes)!r} must name at least one parameter.", field="axes", value=list(axes))
    check_rigid(base)
    made = []
    for path, values in axes.items():
        info = parameter(path)
        array = axis_values(path, values)
        if array.ndim != 1 or array.size == 0:
            raise InputError(f"axis {path} must be a list of values, not of shape {array.shape}.")
        if np.unique(array).size != array.size:
            raise InputError(f"axis {path} must not hold a value twice.")
        made.append(Axis(path, array, info.unit, info.description))
    check_pairs(axes)
    check_ranges(base, {axis.path: axis.values for axis in made})
    # what is allowed between the least and the largest number follows
    tried = {axis.path: axis.values if axis.unit == "" else [axis.values.min(), axis.values.max()] for axis in made}
    for path in tried:
        _check_values(base, path, tried)
    return tuple(made)


def check_rigid(base: Scenario) -> None:
    """Refuse a map with compliant contact."""
    if not isinstance(base.contact, Rigid):
        raise InputError.of_field("contact.model", base.contact.model, "'rigid' in a map")


def axis_values(path: str, values: ArrayLike) -> NDArray[Any]:
    """Return the values of a parameter as numbers, or words where it is one [SI]."""
    array = np.asarray(values)
    if path == "contact.model" or (path.startswith("contact.") and path != "contact.max_events"):
        raise InputError(f"{path} cannot be an axis: maps are made with rigid contact.")
    if path in ("start.slip", "start.mode"):
        raise InputError(f"{path} cannot be an axis: it belongs to a start that goes on from a state of a motion.")
    if parameter(path).unit == "":
        return array.astype(str)
    try:
        return array.astype(float)
    except (TypeError, ValueError):
        raise InputError(f"axis {path} must hold numbers.") from None


def check_ranges(base: Scenario, arrays: Mapping[str, NDArray[Any]]) -> None:
    """Refuse a value that its parameter never has, with the sentence of a scenario that has it."""
    for path, array in arrays.items():
        values = np.unique(array)
        if path in RANGES:
            allowed = RANGES[path]
            held = ((allowed.least <= values) & (values <= allowed.most)) | np.isin(values, allowed.also)
            if path == "contact.max_events":
                held &= values == np.floor(values)
        elif path in PARAMETERS:
            held = np.isin(values, [word for word, _ in PARAMETERS[path].choices])
        else:  # a number of a part, which make_cells checks with its hoop
            continue
        if not held.all():
            wrong = values[~held][0]
            if path == "contact.max_events" and wrong == np.floor(wrong):
                wrong = int(wrong)  # as a scenario shows it
            scenario_at(base, {path: wrong})


def ordered(paths: Sequence[str]) -> list[str]:
    """Return paths in the order in which a map sets values: by section, within a section as given."""
    return sorted(paths, key=lambda path: SECTIONS.index(path.partition(".")[0]))


def scenario_at(base: Scenario, values: Mapping[str, Any]) -> Scenario:
    """Return the scenario of one cell.

    Parameters
    ----------
    base : Scenario
        The scenario that the map varies.
    values : mapping of str to float or str
        By path [SI].

    Returns
    -------
    scenario : Scenario

    Raises
    ------
    ValueError
        If the values do not go together.

    Examples
    --------
    >>> scenario_at(Scenario(), {"start.speed": 2.5, "plane.mu": 0.5}).to_query()
    'plane.mu=0.5&start.speed=2.5'
    """
    check_type("base", base, Scenario)
    check_type("values", values, Mapping)
    return base.with_values({path: values[path] for path in ordered(list(values))})


def _check_values(base: Scenario, path: str, tried: dict[str, Any]) -> None:
    """Refuse a value of an axis that no value of the other axes allows; cells of others that do not allow it are marked."""
    for value in tried[path]:
        try:
            scenario_at(base, {path: value})
        except InputError:
            cells = [dict(zip(tried, values, strict=True)) for values in itertools.product(*(tried | {path: [value]}).values())]
            if not any(_is_allowed(base, cell) for cell in cells):
                raise


def _is_allowed(base: Scenario, values: Mapping[str, Any]) -> bool:
    try:
        scenario_at(base, values)
    except InputError:
        return False
    return True


def check_pairs(paths: Collection[str]) -> None:
    """Refuse two paths that say the same thing in two ways."""
    pair = contradiction(paths)
    if pair is not None:
        raise InputError(TWO_AXES.format(one=pair[0], other=pair[1]))


def chunk_shape(shape: Sequence[int], cells: int) -> tuple[int, ...]:
    """Return the shape of the chunks of a grid, with at most `cells` cells each: rows and columns are read equally fast."""
    result = list(shape)
    while math.prod(result) > cells:
        longest = result.index(max(result))
        result[longest] = -(-result[longest] // 2)
    return tuple(result)
