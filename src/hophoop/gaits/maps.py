"""The return map of a section, and its derivatives by differences of motions with the same phases."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, partial
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.computing import FOREVER, PANELS, check, passages
from hophoop.gaits.differences import Floats, Values, derivative_matrix
from hophoop.gaits.kernels.layout import COORDINATES, MODE, OMEGA, PIECE, SECTIONS, THETA, TURNS, Request
from hophoop.gaits.kernels.passages import follow_passages, new_buffers
from hophoop.gaits.results import Lyapunov, Passages
from hophoop.kernel.model import MODE_LETTERS, Body, Mode, inertia_at_height, slip_direction
from hophoop.kernel.native import compiled
from hophoop.kernel.numerics.arithmetic import TWO_PI
from hophoop.kernel.records import (
    CELL,
    Cell,
    Refusal,
    body_of,
    ideal_inertia,
    new_scratch,
    refusal,
    start_state,
    unpacked_sequence,
)
from hophoop.results.units import Units
from hophoop.scenario import InputError, Scenario, Start, cell_of
from hophoop.scenario.paths import parameter
from hophoop.vocabulary.parameters import PARAMETERS

NAMES: tuple[str, ...] = ("angle", "omega", "slip", "vy")
FASTEST = {"bottom": 10.0, "landing": 20.0}  # √(g/R): θ̇ up to which gaits are looked for
ON_SECTION = 1e-9  # rad: within it a start is on the section
NARROW = 2.0**-27  # distance at which another piece is next to a point
BESIDE = 2.0**-20  # of the neighbours of a Lyapunov exponent
SOLVED, NEARLY = 1e-13, 1e-11  # largest differences of a fixed point from its image, sought and accepted
STEPS = 25  # of Newton's method
SLOW = 0.1  # of a difference that is left by a step: then the derivative is computed again
BATCHES, TRANSIENT = 20, 0.1  # of the passages of a Lyapunov exponent, and the share that is left out
LOAD = "hoop.load_fraction"
COLUMNS_OF: dict[str, list[int]] = {
    LOAD: [Cell.ECCENTRICITY],
    "plane.mu": [Cell.MU_STATIC, Cell.MU_KINETIC],
}  # of a cell; of others their own
BORDER = "the motion is on the border of two classes: on both sides the derivatives differ"


def coordinates(section: str, mode: str) -> tuple[str, ...]:
    """Return the names of the coordinates that a passage leaves free, by section and letter of the mode."""
    return NAMES[_free(section, MODE_LETTERS.index(mode))]


def _free(section: str, code: float) -> slice:
    """Return which of the names are free, by section and code of the mode."""
    return slice(int(section == "bottom"), {Mode.ROLL: 2, Mode.FLIGHT: 4}.get(Mode(int(code)), 3))


def place_of(section: str, row: Floats) -> Floats:
    """Return the free coordinates of a passage, in units of R and √(R/g)."""
    place: Floats = row[COORDINATES[_free(section, row[MODE])]]
    return place


def slowest_over_top(scenario: Scenario) -> float:
    """Return a lower bound of a gait's θ̇ in rolling at the bottom: half of the energy that leads over the top [√(g/R)]."""
    body = scenario.to_body()
    return math.sqrt(2.0 * body.eps * body.gn / inertia_at_height(body, 0.0))


@dataclass(frozen=True)
class SectionDerivative:
    """Derivative of the state at a passage with respect to the state at an earlier one.

    Attributes
    ----------
    matrix : ndarray, shape (rows, columns)
        In SI units; nan where there is none.
    rows : tuple of str
        Coordinates of the later passage: 'omega' [rad/s] in rolling at the bottom, with 'slip' [m/s] in slip; at a landing
        'angle' [rad], 'omega', 'slip' and 'vy' [m/s], as far as its mode leaves them free.
    columns : tuple of str
        Those of the earlier one.
    """

    matrix: Floats
    rows: tuple[str, ...]
    columns: tuple[str, ...]

    @property
    def reason(self) -> str:
        """Why there is no derivative; empty if there is one."""
        return "" if np.isfinite(self.matrix).all() else BORDER

    @cached_property
    def multipliers(self) -> Floats | NDArray[np.complex128]:
        """Eigenvalues, the largest modulus first, complex only in pairs; for a whole period of a gait its multipliers.

        Raises
        ------
        ValueError
            If both passages have different coordinates.
        """
        if self.rows != self.columns:
            raise InputError(f"multipliers need equal coordinates at both passages, not {self.columns} and {self.rows}.")
        return eigenvalues(self.matrix)


class Image(NamedTuple):
    """What becomes of a point of a section after some passages; fewer if the motion passes it no more."""

    rows: Floats  # of the passages, as the kernel writes them
    words: NDArray[np.uint64]
    angle: float  # θ at the start

    def word(self, k: int) -> bytes:
        """Return what is the same on a piece of the map up to passage k, if there is one: phases, mode, branches of impacts."""
        return b"".join((self.words[k : k + 1].tobytes(), self.rows[k : k + 1, PIECE].tobytes()))

    @property
    def turns(self) -> int:
        """Revolutions from the start to the last passage."""
        last = self.rows[-1]
        return round(float(last[TURNS]) + (float(last[THETA]) - self.angle) / TWO_PI)

    @property
    def key(self) -> tuple[bytes, bytes, int]:
        """What is the same on a piece of the map over the whole period."""
        return self.words.tobytes(), self.rows[:, PIECE].tobytes(), self.turns

    @property
    def sequence(self) -> str:
        """Phases, as in `Gait.sequence`."""
        return "·".join(map(unpacked_sequence, self.words.tolist()))


class SectionMap:
    """The map from a passage of a section to a later one, in units of R and √(R/g).

    A point holds the coordinates that are free at the passage, θ̇ alone in rolling at the bottom, and then, if a path is given,
    the parameter.

    Parameters
    ----------
    scenario : Scenario
        Its hoop and plane count.
    period : int, default 1
        Passages of one application [1].
    section : {'bottom', 'landing'}, default 'bottom'
    mode : str, default 'R'
        Letter of the mode at the passage.
    path : str, optional
        Of the parameter.
    scale : float, default 1.0
        The parameter per number of a point [SI].
    """

    def __init__(
        self, scenario: Scenario, period: int = 1, section: str = "bottom", mode: str = "R", path: str = "", scale: float = 1.0
    ) -> None:
        self.scenario, self.period, self.section, self.mode = scenario, period, section, mode
        self.path, self.scale, self._code = path, scale, MODE_LETTERS.index(mode)
        self.names = coordinates(section, mode)
        units = Units.of_scenario(scenario)
        self.units = np.array([units.of(name) for name in self.names])
        self.unit = units.of("omega")
        self._scratch, self._buffers = new_scratch(), new_buffers(max(period, 3))
        self._cell = np.array(cell_of(scenario), dtype=float)
        self._columns = COLUMNS_OF.get(path) or ([CELL.index(PARAMETERS[path].column)] if path else [])
        self._known: tuple[float, Body | None] = (math.nan, None)  # the last value of the parameter, and its body

    def _body(self, value: float) -> Body | None:
        """Return hoop and plane at a value of the parameter, or None if it is not allowed; the last ones are kept."""
        if value != self._known[0]:
            self._known = value, self._new_body(value)
        return self._known[1]

    def _new_body(self, value: float) -> Body | None:
        """Return hoop and plane at a value of the parameter, or None if it is not allowed."""
        number, cell = value * self.scale, self._cell.copy()
        cell[self._columns] = number
        if self.path == LOAD:
            cell[Cell.INERTIA_RATIO] = ideal_inertia(number)
        span = PARAMETERS[self.path].range if self.path else None
        allowed = (span is None or span.holds(number)) and refusal(cell, ())[0] == Refusal.NONE
        return body_of(cell.tolist()) if allowed else None

    def follow(self, mode: int, point: Floats, most: int) -> Image:
        """Return what follows a point in a mode, up to so many passages."""
        place = point.tolist()
        body = self._body(place.pop() if self.path else 0.0)
        th, om, vt, vn, *_ = [math.pi] * int(self.section == "bottom") + place + [0.0, 0.0]
        buffers, found = self._buffers, 0
        if body is not None and vt * slip_direction(mode) >= -SOLVED:
            start = start_state(0.0, 0.0, th, vt, vn, om)
            request = Request(SECTIONS.index(self.section), most, FOREVER, PANELS, False)
            found = compiled(follow_passages)(body, start, mode, request, buffers, self._scratch)[1]
        return Image(buffers.numbers[:found].copy(), buffers.words[:found].copy(), th)

    def __call__(self, point: Floats) -> Image:
        """Return the image of a point."""
        return self.follow(self._code, point, self.period)

    def comes_back(self, image: Image) -> bool:
        """Return True if the motion passes the section often enough, and in the end in the mode of the map."""
        return len(image.rows) == self.period and image.rows[-1, MODE] == self._code

    def excess(self, row: Floats, point: Floats) -> Floats:
        """Return the coordinates of a passage, less those of a point."""
        return self._change(place_of(self.section, row), point[: len(self.names)])

    def _change(self, place: Floats, before: Floats) -> Floats:
        """Return the difference of coordinates, angles within half a revolution."""
        change: Floats = place - before
        if self.section == "landing":
            change[0] = math.remainder(change[0], TWO_PI)
        return change

    def residual(self, row: Floats, point: Floats) -> float:
        """Return the largest difference of a passage from a point, relative to 1 + θ̇; inf in another mode."""
        if row[MODE] != self._code:
            return math.inf
        return float(np.abs(self.excess(row, point)).max() / (1.0 + abs(row[OMEGA])))

    def apart(self, image: Image, point: Floats) -> float:
        """Return the least such difference after a part of the period."""
        parts = (part for part in range(1, self.period) if self.period % part == 0)
        return min((self.residual(image.rows[part - 1], point) for part in parts), default=math.inf)

    # --- derivatives -------------------------------------------------------------------------------

    def rates(self, image: Image, point: Floats, *, exact: bool = False, across: bool = False, sided: bool = True) -> Floats:
        """Return the derivative of the image's coordinates by the point: the product of those from passage to passage.

        Next to a border of pieces it is that of the piece that the motion is on, of the other piece with `across`, and nan
        unless `sided`.
        """
        mode, place, parameter = self._code, point, np.eye(len(point))[len(self.names) :]
        whole = np.eye(len(point))
        for k, row in enumerate(image.rows):
            after, word = place_of(self.section, row), image.word(k)
            if across:
                word = self._word_beside(mode, place, word)
            shifted = partial(self.along, mode, place, after, word)
            matrix = derivative_matrix(shifted, len(place), len(after), exact=exact, sided=sided)
            whole = np.vstack([matrix @ whole, parameter])
            mode, place = int(row[MODE]), np.append(after, point[len(self.names) :])
        return whole[: len(whole) - len(parameter)]

    def along(self, mode: int, point: Floats, after: Floats, word: bytes, direction: Floats) -> Values:
        """Return the change of the next passage from one with a distance along a direction, as far as it has the same word."""

        def at(distance: float) -> Floats | None:
            found = self.follow(mode, point + distance * direction, 1)
            return self._change(place_of(self.section, found.rows[0]), after) if found.word(0) == word else None

        return at

    def _word_beside(self, mode: int, point: Floats, word: bytes) -> bytes:
        """Return another word next to a point; the same one if there is none."""
        for shift in (*np.eye(len(point)), *-np.eye(len(point))):
            beside = self.follow(mode, point + NARROW * shift, 1).word(0)
            if beside not in (b"", word):
                return beside
        return word

    # --- fixed points ------------------------------------------------------------------------------

    def solve(
        self, point: Floats, normal: Floats | None = None, rates: Floats | None = None, *, patient: bool = False
    ) -> tuple[Floats, Image] | None:
        """Return the fixed point near one, by Newton's method with a derivative that is kept while it is good enough.

        With a parameter it is that on the plane through the point with a given normal.
        patient: go on where a step leads farther away.
        """
        place, last, fresh = point, math.inf, False
        plane = np.empty((0, len(point))) if normal is None else normal[None]
        for _ in range(STEPS):
            image = self(place)
            if not self.comes_back(image):
                return None
            excess = np.append(self.excess(image.rows[-1], place), plane @ (place - point))
            size = float(np.abs(excess).max())
            slow = size > SLOW * last
            if size < SOLVED or (fresh and last <= size < NEARLY):
                return place, image
            if fresh and size >= last and not patient:
                return None
            fresh = rates is None or slow
            if rates is None or slow:
                rates = self.rates(image, place)
            try:
                step = np.linalg.solve(np.vstack([rates - np.eye(*rates.shape), plane]), -excess)
            except np.linalg.LinAlgError:
                return None
            if not np.abs(step).max() < 1.0:  # also without a derivative, next to a border
                return (place, image) if size < NEARLY else None
            place, last = place + step, size
        return None

    # --- points, states and scenarios --------------------------------------------------------------

    def point(self, start: Start, value: float | None = None) -> Floats:
        """Return the point of a start on the section, and of a value of the parameter [SI]."""
        state = start.state(self.scenario.hoop)
        state = state._replace(angle=state.angle % TWO_PI)
        place = np.array([float(getattr(state, name)) for name in self.names]) / self.units
        return place if value is None else np.append(place, value / self.scale)

    def in_mode(self, point: Floats) -> Floats:
        """Return a point without slip against the mode, which ends where the slip is 0."""
        place = point.copy()
        for k, name in enumerate(self.names):
            if name == "slip" and place[k] * slip_direction(self._code) < 0.0:
                place[k] = 0.0
        return place

    def omega(self, point: Floats) -> float:
        """Return θ̇ at a point [rad/s]."""
        return float(point[self.names.index("omega")]) * self.unit

    def at(self, point: Floats) -> Scenario:
        """Return the scenario that starts at a point."""
        values = (self.in_mode(point)[: len(self.names)] * self.units).tolist()
        state = {"angle": math.pi, "slip": 0.0} | dict(zip(self.names, values, strict=True))
        start = Start(height=0.0, vx=self.scenario.hoop.radius * state["omega"] + state["slip"], mode=self.mode, **state)
        base = self.scenario.replace(self.path, float(point[-1]) * self.scale) if self.path else self.scenario
        return base.replace("start", start)


def eigenvalues(matrix: Floats) -> Floats | NDArray[np.complex128]:
    """Return the eigenvalues of a matrix, the largest modulus first; nan if it is not known."""
    if not np.isfinite(matrix).all():
        return np.full(len(matrix), math.nan)
    found = cast("Floats | NDArray[np.complex128]", np.linalg.eigvals(matrix))
    return found[np.argsort(-np.abs(found), kind="stable")]


# --- derivatives of motions --------------------------------------------------------------------------


def derivative(scenario: Scenario, passages_on: int = 1, *, section: str = "bottom") -> SectionDerivative:
    """Return the derivative of the return map at a scenario's start.

    Parameters
    ----------
    scenario : Scenario
        Its start is on the section: the load at the bottom (θ = π) in contact, or a state just after a landing.
    passages_on : int, default 1
        How many passages further [1].
    section : {'bottom', 'landing'}, default 'bottom'
        As in `hophoop.passages`.

    Returns
    -------
    derivative : SectionDerivative

    Raises
    ------
    ValueError
        If the start is not on the section, or the motion has no such passage.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> start = hh.Start.rolling(3.4081869457017134, angle=math.pi)
    >>> gait = hh.Scenario(plane=hh.Plane(slope=math.radians(1), gravity=1.0), start=start)
    >>> round(float(hh.gaits.derivative(gait).matrix[0, 0]), 9)
    0.610983568
    """
    check(scenario, section)
    start = scenario.start.state(scenario.hoop)
    off = math.remainder(start.angle - math.pi, TWO_PI)
    if section == "bottom" and (abs(off) > ON_SECTION or start.height != 0.0 or start.vy != 0.0):
        raise InputError("start.angle must be pi, with start.height = start.vy = 0: the section is the load at the bottom.")
    if section == "landing" and (start.height != 0.0 or start.vy < 0.0):
        raise InputError("start.height must be 0, with start.vy at least 0: the section is just after a landing.")
    found = passages(scenario, passages_on, section=section)
    if len(found) < passages_on:
        raise InputError(f"passages_on = {passages_on} must be at most {len(found)}: the motion passes its section no more.")
    image_of, point, image = map_of(found)
    units, rows = Units.of_scenario(scenario), coordinates(section, found.mode[-1])
    scale = np.array([units.of(name) for name in rows])[:, None] / image_of.units
    return SectionDerivative(image_of.rates(image, point, exact=True, sided=False) * scale, rows, image_of.names)


def map_of(found: Passages) -> tuple[SectionMap, Floats, Image]:
    """Return the map from the start of some passages to the last of them, the point of the start, and its image."""
    mode = found.scenario.start.mode or found.sequences[0][0]
    image_of = SectionMap(found.scenario, len(found), found.section, mode)
    point = image_of.point(found.scenario.start)
    return image_of, point, image_of(point)


def lyapunov_of(found: Passages) -> Lyapunov:
    """Return the mean rate at which near motions separate, by differences from passage to passage; nan without two."""
    section, growth, vector = found.section, [], np.empty(0)
    image_of = SectionMap(found.scenario, section=section)
    image = Image(found.numbers, found.packed, math.nan)
    for k in range(int(TRANSIENT * len(found)), len(found) - 1):
        point, after = (place_of(section, row) for row in found.numbers[k : k + 2])
        if len(vector) != len(point):
            vector = np.ones(len(point)) / math.sqrt(len(point))
        at = image_of.along(int(found.numbers[k, MODE]), point, after, image.word(k + 1), vector)
        ahead, back = at(BESIDE), at(-BESIDE)
        if ahead is None or back is None or not (size := float(np.linalg.norm(ahead - back))):
            vector = np.empty(0)  # next to a border, or along a direction that is forgotten
            continue
        growth.append(math.log(size / (2.0 * BESIDE)))
        vector = (ahead - back) / size
    if len(growth) < 2:
        return Lyapunov(math.nan, math.nan, len(growth))
    batches = [float(np.mean(batch)) for batch in np.array_split(growth, min(BATCHES, len(growth)))]
    return Lyapunov(float(np.mean(growth)), float(np.std(batches, ddof=1)) / math.sqrt(len(batches)), len(growth))


def value_of(scenario: Scenario, path: str) -> float:
    """Return a scenario's value of a parameter of hoop or plane [SI]; refuse other paths."""
    parameter(path)
    section, _, name = path.partition(".")
    if section not in ("hoop", "plane"):
        raise InputError.of_field("path", path, "a parameter of hoop or plane")
    value = getattr(getattr(scenario, section), "mu_static" if name == "mu" else name, None)
    if not isinstance(value, float):
        raise InputError.of_field("path", path, "a number of this hoop and plane")
    return value
