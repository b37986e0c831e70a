"""The task of an engine in plain numbers, and the conversion between its coordinates and those of the benchmark."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
SPACING = 1.0 / 2048.0  # s, minimum spacing of the states of a record


class States(NamedTuple):
    """A motion at n times, which every adapter returns; the columns of a record.

    t [s] increases from 0. x is the position of the rim's centre along the plane and y the gap between rim and plane [m].
    angle is θ from the plane's normal to the load, not wrapped, increasing while the hoop rolls towards +x [rad]. vx, vy
    [m/s] and omega [rad/s] are their rates.
    """

    t: Floats
    x: Floats
    y: Floats
    angle: Floats
    vx: Floats
    vy: Floats
    omega: Floats


class BodyState(NamedTuple):
    """Position [m], rotation [rad] and velocities [m/s, rad/s] of the centre of gravity G; the rotation is counterclockwise."""

    x: float
    y: float
    turn: float
    vx: float
    vy: float
    spin: float


@dataclass(frozen=True)
class Task:
    """One motion for an engine, in SI units and radians; data/README.md describes the fields.

    The plane is y = 0 with the normal +y, also on a slope: gravity is tilted instead.
    """

    name: str
    radius: float
    mass: float
    eccentricity: float
    inertia: float  # about G
    gravity: float
    slope: float
    mu: float
    restitution: float
    x: float
    height: float
    angle: float
    vx: float
    vy: float
    omega: float
    duration: float

    @property
    def arm(self) -> float:
        """Distance from the rim's centre C to G [m]."""
        return self.eccentricity * self.radius

    @property
    def pull(self) -> tuple[float, float]:
        """Gravity along the plane and away from it [m/s²]."""
        return self.gravity * math.sin(self.slope), -self.gravity * math.cos(self.slope)

    def steps(self, dt: float) -> int:
        """Number of steps of dt [s] to the end."""
        return math.ceil(self.duration / dt - 1e-9)

    def every(self, dt: float) -> int:
        """Number of steps of dt [s] per recorded state: 1 unless the step is much finer than the record."""
        return max(1, int(SPACING / dt + 1e-9))

    def body(self) -> BodyState:
        """Return the start of G. With turn = −θ the rim's centre is at (0, −arm) in the axes of the body."""
        sine, cosine = math.sin(self.angle), math.cos(self.angle)
        return BodyState(
            self.x + self.arm * sine,
            self.radius + self.height + self.arm * cosine,
            -self.angle,
            self.vx + self.arm * self.omega * cosine,
            self.vy - self.arm * self.omega * sine,
            -self.omega,
        )

    def states(self, t: ArrayLike, bodies: ArrayLike, unwrap: bool = False) -> States:
        """Convert rows of `BodyState` at times t [s] to states of the hoop; `unwrap` a rotation within one revolution."""
        x, y, turn, vx, vy, spin = np.asarray(bodies, dtype=float).T
        angle = -(np.unwrap(turn) if unwrap else turn)
        if unwrap:  # the start gives the revolution
            angle = angle + 2.0 * math.pi * round((self.angle - angle[0]) / (2.0 * math.pi))
        sine, cosine, omega = np.sin(angle), np.cos(angle), -spin
        return States(
            np.asarray(t, dtype=float),
            x - self.arm * sine,
            y - self.radius - self.arm * cosine,
            angle,
            vx - self.arm * omega * cosine,
            vy + self.arm * omega * sine,
            omega,
        )

    def march(self, dt: float, step: Callable[[], Any], read: Callable[[], Any], unwrap: bool = False) -> States:
        """Take steps of dt [s] to the end and record the numbers of `BodyState`, which `read` returns."""
        return self.states(*self._march(dt, step, read), unwrap)

    def march_rim(self, dt: float, step: Callable[[], Any], read: Callable[[], Any]) -> States:
        """Like `march`, for an engine with the coordinates of the hoop: `read` returns x, y, θ and their rates."""
        t, rows = self._march(dt, step, read)
        return States(np.array(t), *np.array(rows, dtype=float).T)

    def _march(self, dt: float, step: Callable[[], Any], read: Callable[[], Any]) -> tuple[list[float], list[Any]]:
        every = self.every(dt)
        t, rows = [0.0], [tuple(read())]
        for i in range(1, self.steps(dt) + 1):
            step()
            if i % every == 0:
                t.append(i * dt)
                rows.append(tuple(read()))
        return t, rows
