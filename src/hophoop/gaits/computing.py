"""Passages and fates of scenarios, computed by the kernel."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.errors import check_type, check_whole
from hophoop.gaits.kernels.cells import judge_cells
from hophoop.gaits.kernels.layout import CODES, NUMBERS, SECTIONS, Request
from hophoop.gaits.kernels.passages import follow_passages, lands_no_more, new_buffers
from hophoop.gaits.results import Passages
from hophoop.kernel.model import Status
from hophoop.kernel.native import compiled
from hophoop.kernel.records import mode_of, new_scratch, second_of, start_of
from hophoop.scenario import InputError, Scenario, cell_of
from hophoop.vocabulary.names import FATE_CODES, Fate

MOST = 10_000_000  # passages
PATIENCE = 2_000  # passages of the bottom of a motion that lands no more


class Judgement(NamedTuple):
    """Fates of motions, one entry each.

    Attributes
    ----------
    fates : tuple of Fate
        'chaotic' only at the bottom in rolling, where a neighbour is followed over 600 more passages.
    periods : ndarray of int, shape (n,)
        Of gaits, in passages, of the bottom if they land no more; else 0 [1].
    hops : ndarray of int, shape (n,)
        Of gaits in a period [1].
    revolutions : ndarray of int, shape (n,)
        Of gaits in a period, to either side: gear n has n, and one hop [1].
    passages : ndarray of int, shape (n,)
        Passages until the fate was decided [1].
    """

    fates: tuple[Fate, ...]
    periods: NDArray[np.int64]
    hops: NDArray[np.int64]
    revolutions: NDArray[np.int64]
    passages: NDArray[np.int64]


def passages(scenario: Scenario, count: int = 1000, *, section: str = "bottom", until_decided: bool = False) -> Passages:
    """Compute the passages of a section, revolution by revolution, and what becomes of the motion.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact; its duration does not count.
    count : int, default 1000
        The most passages, from 1 to 10 million [1].
    section : {'bottom', 'landing'}, default 'bottom'
        The load at the bottom (θ = π in any revolution) with the rim in contact, in either direction; or each landing, for
        steep slopes and light loads, where the bottom is passed in flight. A motion that lands no more is judged at the
        bottom.
    until_decided : bool, default False
        Stop as soon as the fate is decided.

    Returns
    -------
    passages : Passages
        Fewer than `count` if the motion ends, or passes its section no more. Of a start faster than about 100 √(gR) doubles
        follow only the first bounces, as `Trajectory.errors` shows.

    Raises
    ------
    ValueError
        If count or section is not allowed, the contact is compliant, or there is no gravity.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> slope = hh.Scenario(plane=hh.Plane(slope=math.radians(3)), hoop=hh.Hoop.ideal(0.5))
    >>> found = hh.passages(slope, 300)
    >>> found.fate, found.period, found.sequences[-1]
    ('gait', 1, 'RSHKR')
    """
    check(scenario, section)
    check_whole("count", count, 1, MOST)
    buffers = new_buffers(max(count, 3))
    cell = cell_of(scenario)
    begin = start_of(cell, second_of(cell))
    request = Request(SECTIONS.index(section), count, until_decided)
    body, mode, scratch = scenario.to_body(), mode_of(cell), new_scratch()
    status, found, fate, period = compiled(follow_passages)(body, begin, mode, request, buffers, scratch)
    if lands_no_more(request.section, status, fate):
        bottom = Request(SECTIONS.index("bottom"), PATIENCE, True)
        fate = compiled(follow_passages)(body, begin, mode, bottom, new_buffers(PATIENCE), scratch)[2]
    name = "going" if status < 0 else Status(status).name.lower()
    return Passages(scenario, section, buffers.numbers[:found], buffers.words[:found], name, FATE_CODES[fate], period)


def fates(scenarios: Sequence[Scenario], count: int = 2000, *, section: str = "bottom") -> Judgement:
    """Judge what becomes of many motions, each only as far as it is decided.

    Parameters
    ----------
    scenarios : sequence of Scenario
        With rigid contact.
    count : int, default 2000
        The most passages of each, from 1 to 10 million [1].
    section : {'bottom', 'landing'}, default 'bottom'
        As in `passages`.

    Returns
    -------
    judgement : Judgement

    Raises
    ------
    ValueError
        As `passages`, or if there are no scenarios.

    Examples
    --------
    >>> import hophoop as hh
    >>> fates([hh.Scenario(start=hh.Start.rolling(v)) for v in (0.5, 1.0, 3.1)]).fates
    ('rolls ahead', 'rolls ahead', 'slips ever less')
    """
    check_whole("count", count, 1, MOST)
    check_type("scenarios", scenarios, Sequence)
    if not scenarios:
        raise InputError.of_field("scenarios", scenarios, "at least one scenario")
    for scenario in scenarios:
        check(scenario, section)
    cells = np.array([cell_of(scenario) for scenario in scenarios], float).T
    codes, _ = judged(cells, Request(SECTIONS.index(section), count, True))
    decided, periods, hops, followed, _, turns = codes.T  # as CODES
    return Judgement(tuple(FATE_CODES[code] for code in decided), periods, hops, turns, followed)


def judged(cells: NDArray[np.float64], request: Request) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Judge the cells of the kernel, shape (len(CELL), n) in SI units.

    Returns codes, shape (n, len(CODES)), −1 in cells that are not allowed, and numbers, shape (n, len(NUMBERS)) [SI].
    """
    count = cells.shape[1]
    codes, numbers = np.zeros((count, len(CODES)), np.int64), np.empty((count, len(NUMBERS)))
    compiled(judge_cells)(np.ascontiguousarray(cells), request, codes, numbers)
    return codes, numbers


def check(scenario: Scenario, section: str) -> None:
    """Refuse a scenario or section that has no passages."""
    check_type("scenario", scenario, Scenario)
    if section not in SECTIONS:
        raise InputError.of_field("section", section, f"one of {', '.join(SECTIONS)}")
    if scenario.contact.model != "rigid":
        raise InputError("contact.model = 'compliant' must be 'rigid': passages of a section need exact events.")
    if scenario.plane.gravity == 0.0:
        raise InputError("plane.gravity = 0.0 must be above 0: without gravity no motion comes back to a section.")
