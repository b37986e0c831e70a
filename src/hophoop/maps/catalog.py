"""Catalogue of all sequences of the first revolution, each with an example, its share of the window and its width."""

from __future__ import annotations

import json
from functools import cache
from importlib.resources import files
from typing import Any, NamedTuple

from hophoop.scenario import InputError, Scenario

DATA = "catalogue.json"


class Entry(NamedTuple):
    """One class of motion over the first revolution.

    Attributes
    ----------
    sequence : str
        One letter per phase, from rolling with the load at the top; H last where it takes off.
    ending : str
        End of the span: revolutions (a full turn), reversal or takeoff.
    load_fraction : float
        γ of the ideal hoop [1].
    area : float
        Share of the window of friction and speed that it fills [1].
    width : float
        Twice the distance from the example to the nearest end of the class, along friction and along speed, relative to the
        window's sides [1].
    mu, speed : float
        Friction [1] and speed at the start [m/s] of an example, as far inside the class as found.
    fingerprint : str
        Fingerprint of the example's motion (see `Trajectory.fingerprint`) over the 6 s of `scenario`.
    """

    sequence: str
    ending: str
    load_fraction: float
    area: float
    width: float
    mu: float
    speed: float
    fingerprint: str

    def scenario(self) -> Scenario:
        """Return the scenario of the example.

        Returns
        -------
        scenario : Scenario
        """
        values = {"hoop.load_fraction": self.load_fraction, "plane.mu": self.mu, "start.speed": self.speed}
        return Scenario().with_values(values)


def catalogue(load_fraction: float = 0.75, width: float = 0.0) -> list[Entry]:
    """Return the classes of the first revolution of an ideal hoop, largest area first.

    Parameters
    ----------
    load_fraction : float, default 0.75
        γ, one of `catalogued`: 0.75 and about 50 others from 0.02 to 0.999 [1].
    width : float, default 0
        Minimum width of the classes. A number of classes is meaningful for a width only: narrower ones may always exist [1].

    Returns
    -------
    entries : list of Entry

    Raises
    ------
    ValueError
        If there is no catalogue for this γ.

    Examples
    --------
    >>> catalogue()[0].sequence
    'R'
    >>> len(catalogue(width=0.01)) < len(catalogue())
    True
    """
    hoops = _data()["hoops"]
    key = repr(float(load_fraction))
    if key not in hoops:
        raise InputError.of_field("load_fraction", load_fraction, f"one of {', '.join(hoops)}")
    entries = [Entry(load_fraction=float(load_fraction), **entry) for entry in hoops[key]["entries"]]
    return [entry for entry in entries if entry.width >= width]


def catalogued() -> list[float]:
    """Return the hoops of the catalogue.

    Returns
    -------
    load_fractions : list of float
        Values of γ [1].
    """
    return sorted(map(float, _data()["hoops"]))


@cache
def _data() -> dict[str, Any]:
    text = files("hophoop.maps").joinpath(DATA).read_text(encoding="utf-8")
    data: dict[str, Any] = json.loads(text)
    return data
