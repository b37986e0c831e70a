"""What an engine is asked to compute, in plain numbers, and the way between its coordinates and ours."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop.engines.scenarios import BENCHMARK, BenchScenario

Floats = NDArray[np.float64]
SPACING = 1.0 / 2048.0  # seconds: a record needs no more than one state in so long


class States(NamedTuple):
    """A motion at n times, as every adapter returns it.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Time, growing from 0 [s].
    x, y : ndarray, shape (n,)
        Place of the rim's centre along the plane, and the gap between rim and plane [m].
    angle : ndarray, shape (n,)
        θ, not wrapped, growing as the hoop rolls towards +x [rad].
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


class Body(NamedTuple):
    """Place, turn and velocities of the centre of gravity, x along the plane, y off it, turn counterclockwise.

    Attributes
    ----------
    x, y, turn : float
        Place [m] and turn [rad].
    vx, vy, spin : float
        Velocity [m/s] and rate of turn [rad/s].
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
        Of the scenario.
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
        Coulomb's friction, static and kinetic, and e [1].
    x, height, angle : float
        Start: place of the centre and gap [m], θ [rad].
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
        """Gravity along the plane and off it [m/s²]."""
        return self.gravity * math.sin(self.slope), -self.gravity * math.cos(self.slope)

    def steps(self, dt: float) -> int:
        """Steps of dt that reach the end.

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
        """Steps of dt between two states that are kept.

        Parameters
        ----------
        dt : float
            [s].

        Returns
        -------
        every : int
            1 unless the step is much finer than the record needs.
        """
        return max(1, int(SPACING / dt + 1e-9))

    def body(self) -> Body:
        """The start as place and velocities of G.

        With turn = −θ the centre of the rim lies at (0, −arm) in the body's own axes.

        Returns
        -------
        body : Body
            [m, rad, s].
        """
        sine, cosine = math.sin(self.angle), math.cos(self.angle)
        return Body(
            self.x + self.arm * sine,
            self.radius + self.height + self.arm * cosine,
            -self.angle,
            self.vx + self.arm * self.omega * cosine,
            self.vy - self.arm * self.omega * sine,
            -self.omega,
        )

    def states(self, t: ArrayLike, bodies: ArrayLike, unwrap: bool = False) -> States:
        """A record of the motion of G as states of the hoop.

        Parameters
        ----------
        t : array_like, shape (n,)
            [s].
        bodies : array_like, shape (n, 6)
            Rows as in `Body` [m, rad, s].
        unwrap : bool, default False
            Whether the turn comes back into one turn and must be unwrapped.

        Returns
        -------
        states : States
        """
        x, y, turn, vx, vy, spin = np.asarray(bodies, dtype=float).T
        angle = -(np.unwrap(turn) if unwrap else turn)
        if unwrap:  # the start says which turn it is
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
        """Step an engine to the end, and keep what is needed of its motion.

        Parameters
        ----------
        dt : float
            [s].
        step : callable
            Takes one step.
        read : callable
            Gives the six numbers of `Body`.
        unwrap : bool, default False
            As in `states`.

        Returns
        -------
        states : States
        """
        t, rows = self._marched(dt, step, read)
        return self.states(t, rows, unwrap)

    def march_rim(self, dt: float, step: Callable[[], Any], read: Callable[[], Any]) -> States:
        """As `march`, for an engine whose coordinates are the hoop's own.

        Parameters
        ----------
        dt : float
            [s].
        step : callable
            Takes one step.
        read : callable
            Gives x, y, θ, and their rates [m, rad, s].

        Returns
        -------
        states : States
        """
        t, rows = self._marched(dt, step, read)
        return States(np.array(t), *np.array(rows, dtype=float).T)

    def _marched(
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
        """The task as the JSON that external commands read.

        Returns
        -------
        task : dict
            Ready for `json.dumps`, with the start of G and the pull of gravity worked out.
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
    """The task of a motion of the benchmark.

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
