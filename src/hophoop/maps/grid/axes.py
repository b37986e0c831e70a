"""Axes of a map: parameter and values; and the shape of its chunks."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from decimal import Context, Decimal, localcontext
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.errors import check_type
from hophoop.kernel.numerics.elementwise import exponential
from hophoop.scenario import InputError, Scenario, parameter
from hophoop.scenario.models import Rigid
from hophoop.scenario.paths import contradiction
from hophoop.vocabulary.parameters import PARAMETERS, RANGES

Axes = dict[str, NDArray[Any]]  # values by path: numbers in the parameter's unit [SI], or words

MOST_VALUES = 100_000_000  # on one axis, since its values are in memory
LN_10 = float.fromhex("0x1.26bb1bbb55516p+1")
LOWEST_DECADE = -323  # of doubles
TENS = np.array([float(f"1e{decade}") for decade in range(LOWEST_DECADE, 309)])
TWO_AXES = "{one} and {other} cannot both be axes: they say the same thing in two ways."


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
        If count is not from 1 to 100,000,000, or an end is not above 0 and finite.

    Examples
    --------
    >>> logarithmic(0.01, 1.0, 3)
    array([0.01, 0.1 , 1.  ])
    """
    for end in (first, last):
        check_type("end of an axis", end, Real)
        if not 0.0 < end < math.inf:
            raise InputError.of_field("end of a logarithmic axis", end, "greater than 0 and finite")
    # the same bits on every machine, and powers of ten exact
    with localcontext(Context(prec=30)):
        low, high = (float(Decimal(float(end)).log10()) for end in (first, last))
    exponents = np.linspace(low, high, _count(count))
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
    path, _, rest = text.partition("=")
    path, usage = path.strip(), "path=first:last:count, path=first:last:count:log or path=a,b,c"
    wrong = InputError(f"axis {text!r} must read {usage}.")
    if not path or not rest:
        raise wrong
    if ":" not in rest:
        words = np.array([word.strip() for word in rest.split(",")])
        try:
            return path, words.astype(float)
        except ValueError:
            return path, words
    try:
        first, last, count = rest.removesuffix(":log").split(":")
        spaced = float(first), float(last), int(count)
    except ValueError:
        raise wrong from None
    return path, (logarithmic if rest.endswith(":log") else linear)(*spaced)


def make_axes(base: Scenario, axes: Mapping[str, ArrayLike]) -> Axes:
    """Check the axes of a map, values by path in SI units, against the scenario that they vary."""
    if not axes:
        raise InputError(f"axes = {list(axes)!r} must name at least one parameter.", field="axes", value=list(axes))
    made = checked_values(base, axes)
    for path, values in made.items():
        if values.ndim != 1 or values.size == 0:
            raise InputError(f"axis {path} must be a list of values, not of shape {values.shape}.")
        if np.unique(values).size != values.size:
            raise InputError(f"axis {path} must not hold a value twice.")
    # what is allowed between the least and the largest number follows
    tried = {path: values if has_words(values) else [values.min(), values.max()] for path, values in made.items()}
    for path in tried:
        _check_values(base, path, tried)
    return made


def has_words(values: NDArray[Any]) -> bool:
    """Return True if the values of an axis are words."""
    return values.dtype.kind == "U"


def checked_values(base: Scenario, values: Mapping[str, ArrayLike]) -> Axes:
    """Return the values of parameters by path as numbers or words, each in the range of its parameter [SI]."""
    check_type("base", base, Scenario)
    if not isinstance(base.contact, Rigid):
        raise InputError.of_field("contact.model", base.contact.model, "'rigid' in a map")
    arrays = {path: _array_of(path, given) for path, given in values.items()}
    if pair := contradiction(values):
        raise InputError(TWO_AXES.format(one=pair[0], other=pair[1]))
    for path, array in arrays.items():
        _check_range(base, path, array)
    return arrays


def _array_of(path: str, values: ArrayLike) -> NDArray[Any]:
    """Return the values of a parameter as numbers, or words where it is one [SI]."""
    if path.startswith("contact.") and path != "contact.max_events":
        raise InputError(f"{path} cannot be an axis: maps are made with rigid contact.")
    if path in ("start.slip", "start.mode"):
        raise InputError(f"{path} cannot be an axis: it belongs to a start that goes on from a state of a motion.")
    if parameter(path).unit == "":
        return np.asarray(values).astype(str)
    try:
        return np.asarray(values).astype(float)
    except (TypeError, ValueError):
        raise InputError(f"axis {path} must hold numbers.") from None


def _check_range(base: Scenario, path: str, values: NDArray[Any]) -> None:
    """Refuse a value that its parameter never has, with the sentence of a scenario that has it."""
    if path in RANGES:
        allowed = RANGES[path]
        held = ((allowed.least <= values) & (values <= allowed.most)) | np.isin(values, allowed.also)
        if path == "contact.max_events":
            held &= values == np.floor(values)
    elif path in PARAMETERS:
        held = np.isin(values, [word for word, _ in PARAMETERS[path].choices])
    else:  # a number of a part, which make_cells checks with its hoop
        return
    if not held.all():
        wrong = values[~held][0]
        counts = path == "contact.max_events" and wrong.is_integer()
        scenario_at(base, {path: int(wrong) if counts else wrong})  # as a scenario shows it


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
    return base.with_values(values)


def _check_values(base: Scenario, path: str, tried: dict[str, Any]) -> None:
    """Refuse a value of an axis that no value of the other axes allows; cells of others that do not allow it are marked."""
    for value in tried[path]:
        refusal = _refusal(base, {path: value})
        cells = itertools.product(*(tried | {path: [value]}).values())
        if refusal and all(_refusal(base, dict(zip(tried, cell, strict=True))) for cell in cells):
            raise refusal


def _refusal(base: Scenario, values: Mapping[str, Any]) -> InputError | None:
    """Return the error of a scenario with these values, if it has one."""
    try:
        scenario_at(base, values)
    except InputError as error:
        return error
    return None


def chunk_shape(shape: Sequence[int], cells: int) -> tuple[int, ...]:
    """Return the shape of the chunks of a grid, with at most `cells` cells each: rows and columns are read equally fast."""
    result = list(shape)
    while math.prod(result) > cells:
        longest = result.index(max(result))
        result[longest] = -(-result[longest] // 2)
    return tuple(result)
