"""Taylor series of a motion in one mode, in mpmath: the arithmetic under :mod:`oracles.precise`.

A smooth piece of motion is a power series in the time τ since its beginning. The augmented system of
:mod:`oracles.mechanics` is solved order by order: with A(τ) z(τ) = b(τ) the coefficient z_k follows from
A_0⁻¹, so the same matrix serves every order, and the contact force comes out as a series of its own.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from mpmath import mp, mpf

from .cases import Case
from .mechanics import DIRECTION, FLIGHT, ROLL

Series = list[mpf]


def product(a: Series, b: Series, k: int, first: int = 0) -> mpf:
    """Coefficient k of a·b, leaving out the terms of `a` below `first`."""
    return mp.fdot((a[i], b[k - i]) for i in range(first, k + 1))


def multiply(a: Series, b: Series) -> Series:
    """Product of two series, cut at the shorter one."""
    return [product(a, b, k) for k in range(min(len(a), len(b)))]


def value(series: Series, tau: mpf) -> mpf:
    """Value at τ by Horner's rule."""
    total = mpf(0)
    for coefficient in reversed(series):
        total = total * tau + coefficient
    return total


def derivative(series: Series) -> Series:
    """Series of the derivative."""
    return [k * series[k] for k in range(1, len(series))]


def integral(series: Series) -> Series:
    """Series of the integral from 0."""
    return [mpf(0)] + [series[k] / (k + 1) for k in range(len(series))]


def leading(series: Series, scale: mpf, time: mpf, orders: int = 8) -> tuple[int, mpf]:
    """First order not zero to all but twelve of the working digits, and its coefficient; (-1, 0) if none."""
    small = scale * mpf(10) ** (12 - mp.dps)
    for k, coefficient in enumerate(series[:orders]):
        if abs(coefficient) * time**k > small:
            return k, coefficient
    return -1, mpf(0)


@dataclass
class Parameters:
    """The case's numbers as exact values of its doubles, and quantities fixed by them."""

    case: Case
    radius: mpf = field(init=False)
    arm: mpf = field(init=False)

    def __post_init__(self) -> None:
        case = self.case
        self.radius, self.mass, self.gravity = mpf(case.radius), mpf(case.mass), mpf(case.gravity)
        self.arm = mpf(case.eccentricity) * self.radius
        self.about_centre = self.arm**2 + mpf(case.inertia_ratio) * self.radius**2
        self.down, self.along = mp.cos(mpf(case.slope)), mp.sin(mpf(case.slope))
        self.mu_static, self.mu_kinetic = mpf(case.mu_static), mpf(case.mu_kinetic)
        self.restitution = mpf(case.restitution)
        self.time_scale = mp.sqrt(self.radius / self.gravity)
        self.speed_scale = mp.sqrt(self.radius * self.gravity)
        self.force_scale = self.mass * self.gravity

    def mass_matrix(self, angle: mpf) -> mp.matrix:
        """Mass matrix in (x, y, θ)."""
        s, c = self.arm * mp.sin(angle), self.arm * mp.cos(angle)
        return self.mass * mp.matrix([[1, 0, c], [0, 1, -s], [c, -s, self.about_centre]])

    def response(self, angle: mpf, tangential: mpf, normal: mpf) -> tuple[mpf, mpf, mpf]:
        """Change of (ẋ, ẏ, θ̇) under an impulse (tangential, normal) at the contact point."""
        impulse = mp.matrix([tangential, normal, -self.radius * tangential])
        change = mp.lu_solve(self.mass_matrix(angle), impulse)
        return change[0], change[1], change[2]

    def free_normal_acceleration(self, angle: mpf, omega: mpf) -> mpf:
        """Acceleration off the plane without contact force."""
        s, c = mp.sin(angle), mp.cos(angle)
        force = mp.matrix(
            [
                self.gravity * self.along + self.arm * s * omega**2,
                -self.gravity * self.down + self.arm * c * omega**2,
                self.gravity * self.arm * (self.down * s + self.along * c),
            ]
        )
        return mp.lu_solve(self.mass_matrix(angle), self.mass * force)[1]


@dataclass
class Piece:
    """Series of the state, the contact force and the friction work over one step in one mode."""

    mode: str
    start: mpf
    x: Series
    y: Series
    angle: Series
    vx: Series
    vy: Series
    omega: Series
    friction: Series  # F
    normal: Series  # N
    work: Series  # friction work done since the motion began
    span: mpf = field(default_factory=mpf)  # how far the series is good to the working digits

    def state(self, tau: mpf) -> tuple[mpf, ...]:
        """(x, y, θ, ẋ, ẏ, θ̇) at τ after the start of the piece."""
        return tuple(value(s, tau) for s in (self.x, self.y, self.angle, self.vx, self.vy, self.omega))


def expand(p: Parameters, mode: str, start: mpf, state: tuple[mpf, ...], work: mpf, order: int) -> Piece:
    """Taylor series of the motion that starts from `state` in `mode`."""
    x, y, angle, vx, vy, omega = ([value_] for value_ in state)
    sine, cosine, square = [mp.sin(angle[0])], [mp.cos(angle[0])], []
    ax: Series = []
    ay: Series = []
    alpha: Series = []
    friction: Series = []
    normal: Series = []
    m, arm, g = p.mass, p.arm, p.gravity
    s0, c0 = sine[0], cosine[0]
    rows = [
        [m, 0, m * arm * c0, -1, 0],
        [0, m, -m * arm * s0, 0, -1],
        [m * arm * c0, -m * arm * s0, m * p.about_centre, p.radius, 0],
    ]
    if mode == FLIGHT:
        rows += [[0, 0, 0, 1, 0], [0, 0, 0, 0, 1]]
    elif mode == ROLL:
        rows += [[1, 0, -p.radius, 0, 0], [0, 1, 0, 0, 0]]
    else:
        rows += [[0, 0, 0, 1, DIRECTION[mode] * p.mu_kinetic], [0, 1, 0, 0, 0]]
    inverse = mp.matrix(rows) ** -1
    entries = [[inverse[i, j] for j in range(3)] for i in range(5)]
    for k in range(order):
        square.append(product(omega, omega, k))
        if k > 0:
            sine.append(mp.fdot((j * angle[j], cosine[k - j]) for j in range(1, k + 1)) / k)
            cosine.append(-mp.fdot((j * angle[j], sine[k - j]) for j in range(1, k + 1)) / k)
        right = [
            arm * product(sine, square, k),
            arm * product(cosine, square, k),
            g * arm * (p.down * sine[k] + p.along * cosine[k]),
        ]
        if k == 0:
            right[0] += g * p.along
            right[1] -= g * p.down
        else:  # the parts of A_j z_{k-j}, j >= 1, go to the right-hand side
            right[0] -= arm * mp.fdot((cosine[j], alpha[k - j]) for j in range(1, k + 1))
            right[1] += arm * mp.fdot((sine[j], alpha[k - j]) for j in range(1, k + 1))
            right[2] -= arm * mp.fdot((cosine[j], ax[k - j]) for j in range(1, k + 1))
            right[2] += arm * mp.fdot((sine[j], ay[k - j]) for j in range(1, k + 1))
        solution = [m * mp.fdot(zip(row, right, strict=True)) for row in entries]
        for series, coefficient in zip((ax, ay, alpha, friction, normal), solution, strict=True):
            series.append(coefficient)
        for place, speed, rate in ((x, vx, ax), (y, vy, ay), (angle, omega, alpha)):
            place.append(speed[k] / (k + 1))
            speed.append(rate[k] / (k + 1))
    slip = [vx[k] - p.radius * omega[k] for k in range(order)]
    power = multiply([-f for f in friction], slip) if mode in DIRECTION else [mpf(0)]
    spent = integral(power)
    spent[0] = work
    piece = Piece(mode, start, x, y, angle, vx, vy, omega, friction, normal, spent)
    piece.span = usable_span(p, piece, order)
    return piece


def usable_span(p: Parameters, piece: Piece, order: int) -> mpf:
    """Step at which the last coefficients fall below the working digits."""
    tolerance = mpf(10) ** (-mp.dps + 4)
    scales = (
        (piece.x, p.radius),
        (piece.y, p.radius),
        (piece.angle, mpf(1)),
        (piece.vx, p.speed_scale),
        (piece.omega, p.speed_scale / p.radius),
        (piece.normal, p.force_scale),
        (piece.friction, p.force_scale),
        (piece.work, p.force_scale * p.radius),
    )
    span = 5 * p.time_scale
    for series, scale in scales:
        for k in range(order - 4, min(order, len(series))):
            if series[k] != 0:
                span = min(span, (tolerance * scale / abs(series[k])) ** (mpf(1) / k))
    return span
