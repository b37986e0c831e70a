"""The return map of a section, and its derivatives by differences of motions with the same phases."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.differences import Floats, Values, derivative_matrix
from hophoop.gaits.kernels.layout import COORDINATES, MODE, PIECE, SECTIONS, THETA, TURNS, Request
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
BESIDE = 2.0**-20  # of the neighbours of a Lyapunov exponent
SOLVED = 1e-13  # largest difference of a fixed point from its image
BATCHES, TRANSIENT = 20, 0.1  # of the passages of a Lyapunov exponent, and the share that is left out
LOAD = "hoop.load_fraction"
COLUMNS_OF: dict[str, list[int]] = {
    LOAD: [Cell.ECCENTRICITY],
    "plane.mu": [Cell.MU_STATIC, Cell.MU_KINETIC],
}  # of a cell; of others their own


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


@dataclass(eq=False)
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

    scenario: Scenario
    period: int = 1
    section: str = "bottom"
    mode: str = "R"
    path: str = ""
    scale: float = 1.0

    def __post_init__(self) -> None:
        self.code, self.names = MODE_LETTERS.index(self.mode), coordinates(self.section, self.mode)
        units = Units.of_scenario(self.scenario)
        self.units = np.array([units.of(name) for name in self.names])
        self.unit = units.of("omega")
        self._scratch, self._buffers = new_scratch(), new_buffers(max(self.period, 3))
        self._cell = np.array(cell_of(self.scenario), dtype=float)
        self._columns = COLUMNS_OF.get(self.path) or ([CELL.index(PARAMETERS[self.path].column)] if self.path else [])
        self._section, self._fixed = SECTIONS.index(self.section), [math.pi] if self.section == "bottom" else []
        self._bodies: dict[float, Body | None] = {}

    def _body(self, value: float) -> Body | None:
        """Return hoop and plane at a value of the parameter, or None if it is not allowed; the last ones are kept."""
        if value not in self._bodies:
            number, cell = value * self.scale, self._cell.copy()
            cell[self._columns] = number
            if self.path == LOAD:
                cell[Cell.INERTIA_RATIO] = ideal_inertia(number)
            span = PARAMETERS[self.path].range if self.path else None
            allowed = (span is None or span.holds(number)) and refusal(cell, ())[0] == Refusal.NONE
            self._bodies = {value: body_of(cell.tolist()) if allowed else None}
        return self._bodies[value]

    def follow(self, mode: int, point: Floats, most: int) -> Image:
        """Return what follows a point in a mode, up to so many passages."""
        place: list[float] = point.tolist()
        body = self._body(place.pop() if self.path else 0.0)
        th, om, vt, vn, *_ = [*self._fixed, *place, 0.0, 0.0]
        buffers, found = self._buffers, 0
        if body is not None and vt * slip_direction(mode) >= -SOLVED:
            start, request = start_state(0.0, 0.0, th, vt, vn, om), Request(self._section, most, False)
            found = compiled(follow_passages)(body, start, mode, request, buffers, self._scratch)[1]
        return Image(buffers.numbers[:found].copy(), buffers.words[:found].copy(), th)

    def __call__(self, point: Floats) -> Image:
        """Return the image of a point."""
        return self.follow(self.code, point, self.period)

    def comes_back(self, image: Image) -> bool:
        """Return True if the motion passes the section often enough, and in the end in the mode of the map."""
        return len(image.rows) == self.period and image.rows[-1, MODE] == self.code

    def change(self, place: Floats, before: Floats) -> Floats:
        """Return the difference of coordinates, angles within half a revolution."""
        change: Floats = place - before
        if self.section == "landing":
            change[0] = math.remainder(change[0], TWO_PI)
        return change

    # --- derivatives -------------------------------------------------------------------------------

    def rates(self, image: Image, point: Floats, *, exact: bool = False, sided: bool = True) -> Floats:
        """Return the derivative of the image's coordinates by the point: the product of those from passage to passage.

        Next to a border of pieces it is that of the piece that the motion is on, and nan unless `sided`.
        """
        mode, place, parameter = self.code, point, np.eye(len(point))[len(self.names) :]
        whole = np.eye(len(point))
        for k, row in enumerate(image.rows):
            after = place_of(self.section, row)
            shifted = partial(self.along, mode, place, after, image.word(k))
            matrix = derivative_matrix(shifted, len(place), len(after), exact=exact, sided=sided)
            whole = np.vstack([matrix @ whole, parameter])
            mode, place = int(row[MODE]), np.append(after, point[len(self.names) :])
        return whole[: len(whole) - len(parameter)]

    def along(self, mode: int, point: Floats, after: Floats, word: bytes, direction: Floats) -> Values:
        """Return the change of the next passage from one with a distance along a direction, as far as it has the same word."""

        def at(distance: float) -> Floats | None:
            found = self.follow(mode, point + distance * direction, 1)
            return self.change(place_of(self.section, found.rows[0]), after) if found.word(0) == word else None

        return at

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
            if name == "slip" and place[k] * slip_direction(self.code) < 0.0:
                place[k] = 0.0
        return place

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
