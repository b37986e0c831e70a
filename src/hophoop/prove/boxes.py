"""Whole boxes of parameters proved to have one sequence, and a map proved cell by cell.

A parameter that is a ball means every number in it: a statement about the ball holds for all of them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from hophoop.kernel.physics.body import Mode
from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, arb, precision
from hophoop.prove.deadline import Deadline, Late
from hophoop.prove.enclosures.mean_value_form import parameter
from hophoop.prove.motion import REVOLUTION, Run
from hophoop.prove.physics.equations import FREE
from hophoop.scenario import InputError, Scenario
from hophoop.vocabulary.events import phase_starts
from hophoop.vocabulary.modes import ModeLetter, letter_of

BITS = 48  # a box is much wider than rounding
MOST_EVENTS = 40
LEAST_DEPTH, MOST_DEPTH = 0, 40

Ranges = Mapping[str, tuple[float, float]]


@dataclass(frozen=True)
class Box:
    """A box of parameters and what is proved of the first revolution of all motions in it.

    Attributes
    ----------
    ranges : dict of str to tuple of float
        Minimum and maximum of each parameter, by its path [SI units].
    sequence : str
        One letter per phase; as far as it is proved.
    ending : str
        revolutions, reversal or takeoff; empty where it is undecided.
    why : str
        What could not be shown; empty where all is.
    """

    ranges: dict[str, tuple[float, float]]
    sequence: str
    ending: str
    why: str

    @property
    def proved(self) -> bool:
        """True if all motions in the box are proved to have this sequence and ending."""
        return not self.why


@dataclass(frozen=True)
class ProvedMap:
    """A window of parameters, divided into boxes.

    Attributes
    ----------
    cells : tuple of Box
        Together the window; those that stay undecided are as small as was allowed.
    """

    cells: tuple[Box, ...]

    def area(self, cell: Box) -> float:
        """Area of a cell.

        Parameters
        ----------
        cell : Box

        Returns
        -------
        area : float
            Product of its sides [product of their SI units].
        """
        found = 1.0
        for low, high in cell.ranges.values():
            found *= high - low
        return found

    def share(self, sequence: str | None = None) -> float:
        """Share of the window that is proved, or proved to have one sequence.

        Parameters
        ----------
        sequence : str, optional
            Such as 'RKRSH'.

        Returns
        -------
        share : float
            From 0 to 1 [1].
        """
        whole = sum(map(self.area, self.cells))
        return sum(self.area(cell) for cell in self.cells if cell.proved and sequence in (None, cell.sequence)) / whole

    def sequences(self) -> list[str]:
        """All sequences of proved cells, the one with the largest share first.

        Returns
        -------
        sequences : list of str
        """
        return sorted({cell.sequence for cell in self.cells if cell.proved}, key=self.share, reverse=True)

    def to_dict(self) -> dict[str, Any]:
        """The boxes as JSON.

        Returns
        -------
        result : dict
            Shares of the window [1] and the boxes, with minima and maxima [SI units].
        """
        return {
            "share": self.share(),
            "sequences": {sequence: self.share(sequence) for sequence in self.sequences()},
            "cells": [
                {"ranges": {path: list(ends) for path, ends in cell.ranges.items()}, "proved": cell.proved}
                | ({"sequence": cell.sequence, "ending": cell.ending} if cell.proved else {"why": cell.why})
                for cell in self.cells
            ],
        }


def prove_box(scenario: Scenario, ranges: Ranges) -> Box:
    """Prove that all motions in a box of parameters have one sequence in their first revolution.

    Parameters
    ----------
    scenario : Scenario
        The other parameters.
    ranges : mapping of str to tuple of float
        Minimum and maximum of each parameter, by its path, such as ``{"plane.mu": (0.99, 1.01)}`` [SI units].

    Returns
    -------
    box : Box

    Raises
    ------
    ValueError
        If a parameter cannot be a range, or a range is empty.
    """
    _check(ranges)
    return _prove_box(scenario, ranges, Deadline())


def _prove_box(scenario: Scenario, ranges: Ranges, deadline: Deadline) -> Box:
    problem = Problem.of(scenario)
    with precision(BITS):
        run = _run(problem, {path: arb(low).union(arb(high)) for path, (low, high) in ranges.items()}, deadline)
        # where balls alone do not get through the first rolling, the box is too wide to first order as well
        if not run.proved and (len(run.facts) > 1 or run.mode != Mode.ROLL):
            count = len(ranges)
            free = {path: parameter(*ends, k, count) for k, (path, ends) in enumerate(ranges.items())}
            run = _run(problem, free, deadline)
    marks = [run.facts[place] for place in phase_starts([fact.kind for fact in run.facts])]
    letters = [letter_of(fact.after_mode) for fact in (marks[:-1] if run.proved else marks) if fact.after_mode < Mode.FLIGHT]
    if run.proved and run.ending == "takeoff":
        letters.append(ModeLetter.FLIGHT)
    ending = run.ending if run.proved else ""
    return Box(dict(ranges), "".join(letters), ending, run.why)


def _run(problem: Problem, free: Mapping[str, Ball], deadline: Deadline) -> Run:
    return Run(problem, free, until=REVOLUTION, timed=False, max_events=MOST_EVENTS, deadline=deadline).run()


def prove_map(
    scenario: Scenario,
    ranges: Ranges,
    depth: int = 8,
    seconds: float | None = None,
    progress: Callable[[int, float], None] | None = None,
) -> ProvedMap:
    """Divide a window of parameters into boxes that are proved to have one sequence each.

    Parameters
    ----------
    scenario : Scenario
        The other parameters.
    ranges : mapping of str to tuple of float
        As in `prove_box` [SI units].
    depth : int, default 8
        How often a box is halved at most [1].
    seconds : float, optional
        Boxes that are not proved after this time stay undecided [s].
    progress : callable, optional
        Called with the number of boxes done and the share of the window in them [1].

    Returns
    -------
    proved : ProvedMap

    Raises
    ------
    ValueError
        If a parameter cannot be a range, a range is empty, or depth is out of its range.
    """
    _check(ranges)
    if not isinstance(depth, int) or not LEAST_DEPTH <= depth <= MOST_DEPTH:
        raise InputError.of_field("depth", depth, f"a whole number from {LEAST_DEPTH} to {MOST_DEPTH}")
    deadline, cells, done = Deadline(seconds), [], 0.0
    level: list[dict[str, tuple[float, float]]] = [dict(ranges)]
    for k in range(depth + 1):  # level by level, so that what time there is goes to the large boxes first
        following = []
        for box in level:
            found = Box(box, "", "", str(Late())) if deadline.over() else _prove_box(scenario, box, deadline)
            if found.proved or deadline.late or k == depth:
                cells.append(found)
                done += 0.5**k
                if progress is not None:
                    progress(len(cells), done)
            else:
                following += _halves(box, ranges)
        level = following
    return ProvedMap(tuple(cells))


def _halves(box: dict[str, tuple[float, float]], whole: Ranges) -> list[dict[str, tuple[float, float]]]:
    """A box cut across its longest side, as part of the window's."""
    path = max(box, key=lambda one: (box[one][1] - box[one][0]) / (whole[one][1] - whole[one][0]))
    low, high = box[path]
    middle = 0.5 * (low + high)
    return [{**box, path: (low, middle)}, {**box, path: (middle, high)}]


def _check(ranges: Ranges) -> None:
    if not ranges:
        raise InputError("ranges = {} must name at least one parameter.", field="ranges", value={})
    for path, (low, high) in ranges.items():
        if path not in FREE:
            raise InputError(f"ranges holds {path}, which must be one of {', '.join(FREE)}.", field="ranges", value=path)
        if not low < high:
            raise InputError(f"{path} = {low:g} to {high:g} must be a range with its least value first.", field=path, value=low)
