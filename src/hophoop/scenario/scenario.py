"""A scenario: hoop, plane, start, duration and contact, with its files and links."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from operator import attrgetter
from pathlib import Path
from typing import Any

from pydantic import Field, model_validator

from hophoop._support.errors import InputError
from hophoop.kernel.model import MODE_LETTERS, Body, FrictionLaw, Mode, NormalLaw
from hophoop.kernel.records import CONTACT, body_of, refusal, second_of
from hophoop.scenario.checking import Frozen, field_of, refuse, refused
from hophoop.scenario.formats import query_text, read_file, read_query, read_standard_input, read_text, toml_text
from hophoop.scenario.models import Compliant, Contact, Hoop, Plane, Rigid
from hophoop.scenario.paths import parameter, paths, with_replaced
from hophoop.scenario.start import Start
from hophoop.vocabulary.names import LAW_CODES
from hophoop.vocabulary.parameters import TABLE, section_of

ROUNDED = 1e-9  # of the velocities and √(g R): within it the slip velocity of a start agrees with the others


class Scenario(Frozen):
    """Everything that defines a motion: validated, frozen, and serialized to files and links.

    Without arguments it is the reference case: three quarters of the mass in the load, R = 1 m, m = 1 kg,
    μ = 1, plastic landings, rolling at 3.1 m/s with the load at the top, for 6 s.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
    start : Start
    duration : float, default 6
        Above 0 [s].
    contact : Rigid or Compliant, default Rigid()

    Raises
    ------
    ValueError
        If duration is not positive, the mode of the start cannot hold, or the parts do not go together: the massless hoop
        needs a level plane without rolling resistance and rigid contact, compliant contact a finite friction, and rolling
        resistance is below a limit that the hoop sets.

    Examples
    --------
    >>> scenario = Scenario(start=Start.rolling(2.8)).replace("plane.mu", 0.5)
    >>> scenario.to_query()
    'plane.mu=0.5&start.speed=2.8'
    >>> Scenario.from_query("plane.mu=0.5&start.speed=2.8") == scenario
    True
    """

    duration: float = field_of("duration")
    hoop: Hoop = Field(default_factory=Hoop, description="The hoop")
    plane: Plane = Field(default_factory=Plane, description="The plane")
    start: Start = Field(default_factory=lambda: Start.rolling(3.1), description="The start")
    contact: Contact = Field(default_factory=Rigid, description="The contact model")

    @model_validator(mode="after")
    def _fitting(self) -> Scenario:
        cell = cell_of(self)
        code, number = refusal(cell, contact_of(self.contact))
        if code:
            raise refused(code, self, number)
        start = self.start
        if start.slip is not None:
            rim = self.hoop.radius * (start.omega or 0.0)
            if not slip_agrees(start.slip, start.vx, rim, self.hoop.radius / time_unit(self.hoop, self.plane)):
                needed = f"start.vx - hoop.radius start.omega = {start.vx - rim!r}"
                raise refuse(f"start.slip = {start.slip!r} must be {needed} within rounding.")
        if isinstance(self.contact, Rigid) and start.mode is not None and (why := why_not_in_mode(cell)):
            raise refuse(f"start.mode = {start.mode!r} cannot hold: {why}.")
        return self

    @classmethod
    def load(cls, path: str | Path) -> Scenario:
        """Read a scenario file.

        Parameters
        ----------
        path : str or Path
            A TOML or JSON file (by its ending, else by its first character), or '-' for standard input.

        Returns
        -------
        scenario : Scenario

        Raises
        ------
        ValueError
            If the text is not TOML or JSON, longer than a million bytes, or not a scenario.
        OSError
            If the file cannot be read.
        """
        if str(path) == "-":
            return cls.loads(read_standard_input(), name="standard input")
        file = Path(path)
        known = {".toml": "toml", ".json": "json"}
        return cls.loads(read_file(file), known.get(file.suffix.lower()), name=str(file))

    @classmethod
    def loads(cls, text: str, format: str | None = None, name: str = "the text") -> Scenario:
        """Read a scenario from a text.

        Parameters
        ----------
        text : str
            TOML or JSON.
        format : {'toml', 'json'}, optional
            Which of them; by default a text that starts with a brace is JSON.
        name : str, default 'the text'
            What an error calls it.

        Returns
        -------
        scenario : Scenario

        Raises
        ------
        ValueError
            If the text is not TOML or JSON, or not a scenario.
        """
        return cls.from_dict(read_text(text, format, name))

    def save(self, path: str | Path) -> None:
        """Write a scenario file that `load` reads back as an equal scenario.

        Parameters
        ----------
        path : str or Path
            Ends in .toml or .json.

        Raises
        ------
        ValueError
            If it ends otherwise.
        OSError
            If the file cannot be written.
        """
        file = Path(path)
        if file.suffix.lower() == ".toml":
            text = self.to_toml()
        elif file.suffix.lower() == ".json":
            text = json.dumps(self.to_dict(), indent=2, ensure_ascii=False) + "\n"
        else:
            raise InputError(f"{file} must end in .toml or .json.")
        from hophoop._support.files import replacing

        with replacing(file) as fresh:
            fresh.write_text(text, encoding="utf-8")

    def to_toml(self) -> str:
        """The scenario as a TOML text, with units as comments.

        Returns
        -------
        text : str
            What `loads` reads back as an equal scenario.
        """
        return toml_text(self.to_dict(), {path: parameter(path).unit for path in paths()})

    def to_query(self) -> str:
        """The scenario as the query of a link; equal scenarios have equal queries.

        Returns
        -------
        query : str
            URL-safe, with readable keys such as ``plane.mu=0.5&start.speed=3.1``; what is as in `Scenario()`
            is left out, so that the reference case is empty.
        """
        usual = Scenario().to_dict()
        brief: dict[str, Any] = {}
        for name, value in self.to_dict().items():
            if value == usual[name]:
                continue
            if isinstance(value, dict):
                bare = type(getattr(self, name))().to_dict()
                # A section left out altogether would be read as the usual one.
                value = {key: item for key, item in value.items() if key == "model" or bare.get(key) != item} or value
            brief[name] = value
        return query_text(brief)

    @classmethod
    def from_query(cls, query: str) -> Scenario:
        """Read the query of a link.

        Parameters
        ----------
        query : str
            As `to_query` writes it, with or without a leading question mark.

        Returns
        -------
        scenario : Scenario

        Raises
        ------
        ValueError
            If a key is unknown or given twice, or a value not allowed.
        """
        return cls.from_dict(read_query(query))

    def replace(self, path: str, value: Any) -> Scenario:
        """Return the same scenario with one parameter replaced.

        Parameters
        ----------
        path : str
            Such as ``"plane.mu"``, ``"start.speed"``, ``"hoop.parts.0.mass"`` or, for a whole section,
            ``"hoop"``. Naming a parameter in another way than it was given changes the way:
            ``"start.speed"`` makes any start a rolling one, ``"start.omega"`` turns a rolling start into the
            equal free one first.
        value : float, int, str or model
            The new value, in SI units.

        Returns
        -------
        scenario : Scenario

        Raises
        ------
        ValueError
            If there is no such parameter, or the value is not allowed.
        """
        return self.with_values({path: value})

    def with_values(self, values: Mapping[str, Any]) -> Scenario:
        """Return the same scenario with several parameters replaced and validated together.

        Parameters
        ----------
        values : mapping of str to float, int, str or model
            New values by path, in SI units; paths as in `replace`. Their order does not count.

        Returns
        -------
        scenario : Scenario

        Raises
        ------
        ValueError
            If there is no such parameter, two paths say the same thing in two ways, such as ``"start.speed"`` and
            ``"start.vx"``, or the values are not allowed.

        Examples
        --------
        >>> Scenario().with_values({"plane.mu": 0.3, "start.speed": 2.0}).to_query()
        'plane.mu=0.3&start.speed=2'
        """
        return type(self).from_dict(with_replaced(self, values))

    def _changing(self, name: str, value: str) -> str:
        return f"with_values({{{name!r}: {value}}})"

    def to_body(self) -> Body:
        """Hoop and plane as the kernels take them, see `to_body`.

        Returns
        -------
        body : Body
            In units of R, m and √(R/g).
        """
        return to_body(self.hoop, self.plane)


def to_body(hoop: Hoop, plane: Plane) -> Body:
    """Hoop and plane as the kernels take them.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane

    Returns
    -------
    body : Body
        In units of R, m and √(R/g); see `time_unit` for g = 0.
    """
    body: Body = body_of(_body_rows(hoop, plane))
    return body


def _body_rows(hoop: Hoop, plane: Plane) -> tuple[float, ...]:
    """Return the rows of hoop and plane, which come first in a cell."""
    law, impact = LAW_CODES[plane.impact_law], plane.painleve == "impact"
    return (*_HOOP_NUMBERS(hoop), *_PLANE_NUMBERS(plane), law, impact, hoop.load_fraction is not None)


def cell_of(scenario: Scenario) -> tuple[float, ...]:
    """A scenario as a cell of the kernels.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    cell : tuple of float, length len(CELL)
        In the order of `kernel.records.cells.CELL` [SI].
    """
    start = scenario.start.state(scenario.hoop)
    mode = scenario.start.mode
    return (
        *_body_rows(scenario.hoop, scenario.plane),
        start.x, start.height, start.angle, start.vy, start.omega, start.slip, -1 if mode is None else MODE_LETTERS.index(mode),
        scenario.duration, scenario.contact.max_events, True,
    )  # fmt: skip


def slip_agrees(slip: float, vx: Any, rim: Any, unit: Any) -> Any:
    """Return whether a slip velocity is vx − rim within rounding, which at a turn is that of the unit √(g R) [all m/s]."""
    return abs(slip - (vx - rim)) <= ROUNDED * (abs(slip) + abs(vx) + abs(rim) + unit)


def why_not_in_mode(cell: Any) -> str:
    """Return why the state in contact of a cell cannot have its mode, beyond rounding; empty if it can.

    cell: In the order of `kernel.records.cells.CELL` [SI].
    """
    from hophoop.kernel.model import UNDECIDED, free_acceleration, next_mode
    from hophoop.kernel.numerics.circular import sine_cosine
    from hophoop.kernel.records import mode_of, start_of
    from hophoop.kernel.steps import margins_of

    body = body_of(cell)
    state, mode = start_of(cell, second_of(cell)), mode_of(cell)
    turns_back = body.resist > 0.0 and state.om == 0.0  # the couple jumps
    if body.kap == 0.0 or state.y > 0.0 or state.vn != 0.0 or turns_back:
        return ""
    u = state.om * state.om
    rounding = ROUNDED * (body.gn + abs(body.gt) + u)
    s, c = sine_cosine(state.th, state.th_low)
    opening = free_acceleration(body, s, c, u)[1]
    if mode == Mode.FLIGHT:
        return "without contact the rim would enter the plane" if opening < -rounding else ""
    found = next_mode(body, state.th, state.th_low, state.om, state.vt)
    if Mode.SKIM < found <= UNDECIDED:  # a paradox or no answer at all, which the motion says
        return ""
    if mode != Mode.ROLL:
        return "the plane would have to pull" if opening > rounding else ""
    normal, friction, limit, *_ = margins_of(body, mode, state.th, state.th_low, state.om, state.vt, state.y)
    if normal < -rounding:
        return "the plane would have to pull"
    return "rolling needs more friction than there is" if abs(friction) > limit + rounding else ""


def contact_of(contact: Rigid | Compliant) -> tuple[float, ...]:
    """A contact as the kernels take it.

    numbers: In the order of `kernel.records.cells.CONTACT` [SI], nan where it has none; empty for a rigid contact.
    """
    if isinstance(contact, Rigid):
        return ()
    law, friction = NormalLaw[contact.law.upper().replace("-", "_")], FrictionLaw[contact.friction.upper()]
    given = (getattr(contact, name) for name in CONTACT[2:])
    return int(law), int(friction), *(math.nan if value is None else value for value in given)


def _numbers(section: str) -> attrgetter[tuple[float, ...]]:
    """Return what reads the numbers of a section that are columns of a cell, in the order of the table of parameters."""
    return attrgetter(*(row.path.partition(".")[2] for row in TABLE if row.column and section_of(row) == section))


_HOOP_NUMBERS, _PLANE_NUMBERS = _numbers("hoop"), _numbers("plane")


def time_unit(hoop: Hoop, plane: Plane) -> float:
    """Unit of time of the kernels.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane

    Returns
    -------
    unit : float
        √(R/g), or √(R / (1 m/s²)) without gravity [s].
    """
    return math.sqrt(hoop.radius / (plane.gravity if plane.gravity > 0.0 else 1.0))
