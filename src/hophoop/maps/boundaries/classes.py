"""The class of a motion as a function on a plane of two parameters, and the curves between classes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.numerics.elementwise import exponential, logarithm
from hophoop.maps.grid.axes import has_words, make_axes
from hophoop.maps.grid.evaluate import points
from hophoop.maps.grid.quantities import NOT_ALLOWED, choose_quantities, make_span
from hophoop.scenario import InputError, Scenario

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

# Where several events coincide, rounding puts slivers of other classes between two: below this width, relative to the window,
# they are ignored.
SLIVER = 1e-10


class Window(NamedTuple):
    """A rectangle in the plane of two parameters, with positions from 0 to 1 along both.

    Attributes
    ----------
    x, y : str
        Paths of the parameters.
    x_range, y_range : tuple of float
        Ends of the rectangle, in the parameters' units [SI].
    logarithmic : tuple of bool
        Whether equal steps are equal ratios, along x and y.
    """

    x: str
    y: str
    x_range: tuple[float, float]
    y_range: tuple[float, float]
    logarithmic: tuple[bool, bool] = (False, False)

    def values(self, places: Floats) -> Floats:
        """Return the parameters' values at positions of the window, both along the last axis."""
        low, high = np.transpose([self.x_range, self.y_range])
        values: Floats = low + (high - low) * places
        for k in np.flatnonzero(self.logarithmic):
            values[..., k] = low[k] * exponential(places[..., k] * logarithm(high[k] / low[k]))
        return values

    def places(self, values: Floats) -> Floats:
        """Return the positions of values in the window."""
        low, high = np.transpose([self.x_range, self.y_range])
        places: Floats = (values - low) / (high - low)
        for k in np.flatnonzero(self.logarithmic):
            places[..., k] = logarithm(values[..., k] / low[k]) / logarithm(high[k] / low[k])
        return places


def make_window(
    base: Scenario,
    ranges: dict[str, tuple[float, float]],
    logarithmic: Sequence[str] = (),
) -> Window:
    """Check a window and return it."""
    if len(ranges) != 2:
        raise InputError(f"ranges = {list(ranges)!r} must name two parameters.", field="ranges", value=list(ranges))
    for path, (low, high) in ranges.items():
        if not low < high:
            raise InputError(f"range of {path} = {(low, high)!r} must be two increasing numbers.")
    for path in logarithmic:
        if path not in ranges:
            raise InputError.of_field("logarithmic", path, f"one of {', '.join(ranges)}")
        if not ranges[path][0] > 0.0:
            raise InputError(f"range of {path} = {ranges[path]!r} must be greater than 0 in a logarithmic window.")
    if any(map(has_words, make_axes(base, ranges).values())):
        raise InputError("ranges must be of numbers, not of words.")
    x_range, y_range = ((float(low), float(high)) for low, high in ranges.values())
    x, y = ranges
    return Window(x, y, x_range, y_range, (x in logarithmic, y in logarithmic))


class Border(NamedTuple):
    """A curve between two classes.

    Attributes
    ----------
    window : Window
        The plane of the two parameters.
    x, y : ndarray, shape (n,)
        Points of the curve, each on the boundary to rounding, in the parameters' units [SI].
    classes : tuple of str
        The classes to the right and left of the curve, in its direction, with x to the right and y up.
    ends : tuple of str
        Its ends, first and last: ``edge`` of the window, ``junction`` with another class,
        ``closed`` (back at its start) or ``limit`` (maximum number of points).
    """

    window: Window
    x: Floats
    y: Floats
    classes: tuple[str, str]
    ends: tuple[str, str]


class Classifier:
    """Codes of the classes at positions of a window; the table of classes grows as they occur.

    A class is the text of one coded quantity, or of several, joined by a blank.
    """

    def __init__(self, base: Scenario, window: Window, quantities: Sequence[str], span: str) -> None:
        for quantity in choose_quantities(quantities):
            if not quantity.is_code:
                raise InputError.of_field("quantity", quantity.name, "one with classes, such as sequence")
        self.base, self.window, self.quantities, self.span = base, window, quantities, make_span(span)
        self.names: list[str] = []

    def __call__(self, places: Floats) -> Integers:
        """Return the codes at positions, each from 0 to 1, along the last axis."""
        return self.at(self.window.values(places))

    def at(self, values: Floats) -> Integers:
        """Return the codes at values of the two parameters along the last axis."""
        x, y = values.reshape(-1, 2).T
        found = points(self.base, {self.window.x: x, self.window.y: y}, self.quantities, self.span.name)
        rows = zip(*(column.tolist() for column in found.values()), strict=True)
        labels = [" ".join(word or NOT_ALLOWED for word in row) for row in rows]
        self.names += [label for label in dict.fromkeys(labels) if label not in self.names]
        codes = {label: code for code, label in enumerate(self.names)}
        return np.array([codes[label] for label in labels]).reshape(values.shape[:-1])


def first_changes(
    classify: Callable[[Floats], Integers], near: Floats, far: Floats, codes: Any, sliver: Any, between: Callable[..., Floats]
) -> tuple[Floats, Integers]:
    """Return where the classes of near points first change on the way to far ones, as far as sampled, and those beyond.

    codes: of the near points; between: points between two, by which each line is divided again and again, to neighbouring
    doubles.
    """
    end, rows = far, np.arange(len(near))
    while True:
        inner = between(near, far)
        if ((inner == near) | (inner == far)).all():
            return far, classify(far + np.clip(end - far, -sliver, sliver))
        changed = classify(inner) != codes
        k = np.where(changed.any(axis=0), changed.argmax(axis=0), len(inner))
        places = np.concatenate([[near], inner, [far]])
        near, far = places[k, rows], places[k + 1, rows]
