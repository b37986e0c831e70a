"""The task of an engine in plain numbers, and the conversion between its coordinates and ours."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop.engines.scenarios import BENCHMARK, BenchScenario

Floats = NDArray[np.float64]
SPACING = 1.0 / 2048.0  # s, minimum spacing of states of a record


class States(NamedTuple):
    """A motion at n times, returned by every adapter.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Time, increasing from 0 [s].
    x, y : ndarray, shape (n,)
        Position of the rim's centre along the plane, and the gap between rim and plane [m].
    angle : ndarray, shape (n,)
        θ, not wrapped, increasing while the hoop rolls towards +x [rad].
    vx, vy : ndarray, shape (n,)
        Velocity of the rim's centre [m/s].
    omega : ndarray, shape (n,)
        θ̇ [rad/s].
    """

    t: Floats
    x: Floats
    y: Floats
    angle: Floats
    vx: Floats
    vy: Floats
    omega: Floats


class BodyState(NamedTuple):
    """Position, rotation and velocities of the centre of gravity, x along the plane, y away from it, rotation counterclockwise.

    Attributes
    ----------
    x, y, turn : float
        Position [m] and rotation [rad].
    vx, vy, spin : float
        Velocity [m/s] and angular velocity [rad/s].
    """

    x: float
    y: float
    turn: float
    vx: float
    vy: float
    spin: float


@dataclass(frozen=True)
class Task:
    """One motion for an engine, in SI units and radians.

    The plane is y = 0 with the normal +y, also on a slope: gravity is tilted instead.

    Attributes
    ----------
    name : str
        Name of the scenario.
    radius, mass : float
        R [m] and m [kg].
    eccentricity : float
        Distance of the centre of gravity G from the rim's centre C, over R [1].
    inertia : float
        Moment of inertia about G [kg m²].
    gravity : float
        g [m/s²].
    slope : float
        β, downhill along +x [rad].
    mu, restitution : float
        Coulomb friction, static and kinetic, and e [1].
    x, height, angle : float
        Start: position of the centre and gap [m], θ [rad].
    vx, vy, omega : float
        Start: velocity of the centre [m/s], θ̇ [rad/s].
    duration : float
        [s].
    """

    name: str
    radius: float
    mass: float
    eccentricity: float
    inertia: float
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
        """Distance from C to G [m]."""
        return self.eccentricity * self.radius

    @property
    def pull(self) -> tuple[float, float]:
        """Gravity along the plane and away from it [m/s²]."""
        return self.gravity * math.sin(self.slope), -self.gravity * math.cos(self.slope)

    def steps(self, dt: float) -> int:
        """Number of steps of dt to the end.

        Parameters
        ----------
        dt : float
            [s].

        Returns
        -------
        steps : int
        """
        return math.ceil(self.duration / dt - 1e-9)

    def every(self, dt: float) -> int:
        """Number of steps of dt per recorded state.

        Parameters
        ----------
        dt : float
            [s].

        Returns
        -------
        every : int
            1 unless the step is much finer than the record.
        """
        return max(1, int(SPACING / dt + 1e-9))

    def body(self) -> BodyState:
        """Return the start as position and velocities of G.

        With turn = −θ the centre of the rim is at (0, −arm) in the axes of the body.

        Returns
        -------
        body : BodyState
            [m, rad, s].
        """
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
        """Convert a record of the motion of G to states of the hoop.

        Parameters
        ----------
        t : array_like, shape (n,)
            [s].
        bodies : array_like, shape (n, 6)
            Rows as in `BodyState` [m, rad, s].
        unwrap : bool, default False
            Whether the rotation is wrapped into one revolution.

        Returns
        -------
        states : States
        """
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
        """Step an engine to the end and record its motion.

        Parameters
        ----------
        dt : float
            [s].
        step : callable
            Takes one step.
        read : callable
            Returns the six numbers of `BodyState`.
        unwrap : bool, default False
            As in `states`.

        Returns
        -------
        states : States
        """
        t, rows = self._march(dt, step, read)
        return self.states(t, rows, unwrap)

    def march_rim(self, dt: float, step: Callable[[], Any], read: Callable[[], Any]) -> States:
        """Like `march`, for an engine with the coordinates of the hoop.

        Parameters
        ----------
        dt : float
            [s].
        step : callable
            Takes one step.
        read : callable
            Returns x, y, θ, and their rates [m, rad, s].

        Returns
        -------
        states : States
        """
        t, rows = self._march(dt, step, read)
        return States(np.array(t), *np.array(rows, dtype=float).T)

    def _march(
        self, dt: float, step: Callable[[], Any], read: Callable[[], Any]
    ) -> tuple[list[float], list[tuple[float, ...]]]:
        every = self.every(dt)
        t, rows = [0.0], [tuple(read())]
        for i in range(1, self.steps(dt) + 1):
            step()
            if i % every == 0:
                t.append(i * dt)
                rows.append(tuple(read()))
        return t, rows

    def to_dict(self) -> dict[str, Any]:
        """Return the task as JSON for external commands.

        Returns
        -------
        task : dict
            For `json.dumps`, with the start of G and the components of gravity.
        """
        along, off = self.pull
        return {
            "benchmark": BENCHMARK,
            **asdict(self),
            "gravity_along": along,
            "gravity_off": off,
            "gravity_center": self.body()._asdict(),
        }


def task_of(bench: BenchScenario) -> Task:
    """Return the task of a motion of the benchmark.

    Parameters
    ----------
    bench : BenchScenario

    Returns
    -------
    task : Task
    """
    scenario = bench.scenario
    hoop, plane, start = scenario.hoop, scenario.plane, scenario.start.state(scenario.hoop)
    return Task(
        name=bench.name,
        radius=hoop.radius,
        mass=hoop.mass,
        eccentricity=hoop.eccentricity,
        inertia=hoop.inertia_ratio * hoop.mass * hoop.radius**2,
        gravity=plane.gravity,
        slope=plane.slope,
        mu=plane.mu_kinetic,
        restitution=plane.restitution,
        x=start.x,
        height=start.height,
        angle=start.angle,
        vx=start.vx,
        vy=start.vy,
        omega=start.omega,
        duration=scenario.duration,
    )
