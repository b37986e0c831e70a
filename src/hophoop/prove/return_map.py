"""The return map of a revolution: boxes of θ̇ on which it is shown to be smooth, with its values and its slope.

The section is the load at the bottom, rolling ahead; the next passage comes in rolling after one revolution without a turning
point, through any slip and any hops.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import groupby
from typing import Any

from hophoop.kernel.physics.body import Event, Mode
from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, Undecided, arb, intersection, precision, rational
from hophoop.prove.deadline import Deadline, Late
from hophoop.prove.enclosures.mean_value_form import Varied, over, parameter
from hophoop.prove.motion import PASSAGE, Run
from hophoop.scenario import InputError, Rigid, Scenario, Start
from hophoop.vocabulary.events import phase_starts
from hophoop.vocabulary.modes import letter_of

BITS = 64
MOST_EVENTS = 60
MOST_DEPTH = 14  # an interval is halved so often at most
FASTEST = 1e9  # rad/s
MORE, LEAST_PAD = 0.1, 1e-7  # by which a bracket is wider than what it holds: relative to that, and at least
ENDS = {Event.STICK: "stop", Event.SLIP_REVERSAL: "stop", Event.TAKEOFF: "lift", Event.IMPACT: "land", Event.END: "span"}


@dataclass(frozen=True)
class Piece:
    """A box of θ̇ on which the return map is smooth.

    Attributes
    ----------
    low, high : float
        Its ends [rad/s].
    word : str
        One letter per phase from passage to passage.
    image : Ball
        Holds θ̇ at the next passage of all starts in it [rad/s].
    slope : Ball
        Holds the derivative of the map on it [1].
    phases : list
        [mode, what ends it, least, largest] of each phase, for a certificate: of θ [rad], of the time of a flight in √(R/g).
    """

    low: float
    high: float
    word: str
    image: Ball
    slope: Ball
    phases: list[list[Any]]


class ReturnMap:
    """Enclosures of θ̇ at the next passage over θ̇ at this one, both in rad/s.

    Parameters
    ----------
    scenario : Scenario
        Its start and duration do not count.
    seconds : float, optional
        What is not shown by then stays undecided [s].

    Raises
    ------
    ValueError
        If the contact is compliant, there is no gravity, or seconds is out of its range.
    """

    def __init__(self, scenario: Scenario, seconds: float | None = None) -> None:
        if not isinstance(scenario.contact, Rigid):
            raise InputError("A proof needs rigid contact; this scenario has a compliant one.")
        if not scenario.plane.gravity:
            raise InputError.of_field("plane.gravity", 0.0, "above 0: without it there is no gait")
        if seconds is not None and not seconds > 0:
            raise InputError.of_field("seconds", seconds, "above 0")
        self.scenario = _rolling(scenario)
        self.problem, self.deadline = Problem.of(self.scenario), Deadline(seconds)

    def point(self, omega: float, bits: int = BITS) -> tuple[str, Ball]:
        """Return the word and the value from one start, which is the number that the double is."""
        with precision(bits):
            run = self._run(rational(Fraction(omega)) * rational(self.problem.radius))
            return _word(run), run.state.om / run.model.time

    def piece(self, low: float, high: float) -> Piece:
        """Return what is shown of a box; its values by the mean value theorem from its middle.

        Raises
        ------
        Undecided
            If the map is not shown to be smooth on it.
        """
        with precision(BITS):
            omega = parameter(low, high, 0, 1)
            run = self._run(omega * rational(self.problem.radius))
            found = run.state.om / run.model.time
            assert isinstance(found, Varied)
            slope = found.by[0] / omega.by[0]
            middle = float(omega.over.mid())
            word, value = self.point(middle)
            if word != _word(run):
                raise Undecided("the events of a box are not those of its middle")
            image = intersection(over(found), value + slope * (omega.over - arb(middle)))
            return Piece(low, high, word, image, slope, _phases(run))

    def pieces(self, low: float, high: float, sharp: bool = False) -> Iterator[Piece]:
        """Boxes that cover an interval, from its low end on; `sharp` if the slope is to be less than 1 in size.

        Raises
        ------
        Undecided, Late
            If one of them cannot be shown.
        """
        left = [(low, high, 0)]
        while left:
            a, b, depth = left.pop()
            try:
                found: Piece | None = self.piece(a, b)
            except Undecided as undecided:
                found, why = None, f"{undecided}, for θ̇ = {a:.9g} to {b:.9g} rad/s"
            if found is None and depth == MOST_DEPTH:
                raise Undecided(why)
            if found is None or (sharp and depth < MOST_DEPTH and found.slope.abs_lower() < 1 <= found.slope.abs_upper()):
                middle = 0.5 * (a + b)
                left += [(middle, b, depth + 1), (a, middle, depth + 1)]
            else:
                yield found

    def _run(self, speed: Ball) -> Run:
        self.deadline.ask()
        run = Run(
            self.problem, {"start.speed": speed}, until=PASSAGE, timed=False, max_events=MOST_EVENTS, deadline=self.deadline
        ).run()
        if self.deadline.late:
            raise Late
        if not run.proved:
            raise Undecided(run.why)
        if run.ending != "revolutions":
            turns = run.ending == "reversal"
            raise Undecided("the hoop turns back before the next passage" if turns else "there is no next passage")
        if run.mode != Mode.ROLL:
            raise Undecided("the hoop slips at the next passage")
        return run


def _word(run: Run) -> str:
    marks = [run.facts[place] for place in phase_starts([fact.kind for fact in run.facts])]
    letters = [letter_of(fact.after_mode) for fact in marks[:-1] if fact.after_mode <= Mode.FLIGHT]
    return "".join(letter for letter, _ in groupby(letters))


def _phases(run: Run) -> list[list[Any]]:
    found, begin = [], run.facts[0]
    for fact in run.facts[1:]:
        what = ENDS.get(fact.kind) or {"S": "ahead", "K": "back"}.get(letter_of(fact.after_mode), "")
        place = fact.state.th
        if what == "land":
            place = (place - begin.state.th) / begin.state.om
        low, high = float(over(place).lower()), float(over(place).upper())
        pad = MORE * (high - low) + LEAST_PAD
        found.append([letter_of(begin.after_mode), what, low - pad, high + pad])
        begin = fact
    return found


def check_interval(name: str, low: float, high: float) -> None:
    """Refuse an interval of θ̇ that is empty or not ahead."""
    if not 0.0 < low < high <= FASTEST:
        said = f"{name} = {low:g} to {high:g} rad/s must be a range of θ̇ above 0, with its least value first."
        raise InputError(said, field=name, value=(low, high))


def _rolling(scenario: Scenario) -> Scenario:
    """The same with some rolling start, whose speed and angle are replaced."""
    return scenario.model_copy(update={"start": Start.rolling(1.0)})
