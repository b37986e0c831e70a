r"""Rolling with rolling resistance to as many digits as wanted: Taylor series in time, in mpmath, in units of R, m and g.

While the hoop turns one way, with ρ = f sign θ̇ (β the slope, N and F the forces of the plane):

    F + sin β = θ̈ (1 + ε cos θ) − ε θ̇² sin θ,    N − cos β = −ε (θ̈ sin θ + θ̇² cos θ),
    κ θ̈ = (ε sin θ − ρ) N − (1 + ε cos θ) F

so that θ̈ follows from θ and θ̇², and the series of θ coefficient by coefficient.
"""

from __future__ import annotations

from typing import NamedTuple

from mpmath import mp, mpf

from .series import Series, product, value

ORDER = 28


class Rolling(NamedTuple):
    """A hoop on its plane."""

    eps: mpf
    kap: mpf
    resistance: mpf
    slope: mpf = mpf(0)


def series(hoop: Rolling, theta: mpf, omega: mpf, way: int) -> tuple[Series, Series]:
    """Coefficients of θ and θ̇ in the time from a state, turning `way`."""
    eps, rho = hoop.eps, way * hoop.resistance
    uphill, level = mp.sin(hoop.slope), mp.cos(hoop.slope)
    th, om, alpha = [theta], [omega], []
    s, c, u, arm, lever, drive, weight, inertia = [], [], [], [], [], [], [], []
    for k in range(ORDER):
        if k:
            s.append(mp.fdot((j * th[j], c[k - j]) for j in range(1, k + 1)) / k)
            c.append(-mp.fdot((j * th[j], s[k - j]) for j in range(1, k + 1)) / k)
        else:
            s.append(mp.sin(theta))
            c.append(mp.cos(theta))
        first = mpf(1) if k == 0 else mpf(0)
        u.append(product(om, om, k))
        arm.append(eps * s[k] - rho * first)  # of N
        lever.append(first + eps * c[k])  # of F
        weight.append(level * first - eps * product(c, u, k))  # N but for what θ̈ adds
        drive.append(uphill * first + eps * product(s, u, k))  # −F but for what θ̈ adds
        inertia.append(hoop.kap * first + eps * product(arm, s, k) + product(lever, lever, k))
        torque = product(arm, weight, k) + product(lever, drive, k)
        alpha.append((torque - mp.fdot((inertia[i], alpha[k - i]) for i in range(1, k + 1))) / inertia[0])
        th.append(om[k] / (k + 1))
        om.append(alpha[k] / (k + 1))
    return th, om


def _step(coefficients: Series) -> mpf:
    """So long that the last terms do not show."""
    size = max(abs(coefficients[-1]), abs(coefficients[-2]), mpf(10) ** -60)
    return mpf("0.7") * (mpf(10) ** (-mp.dps) / size) ** (mpf(1) / (len(coefficients) - 1))


def time_to(hoop: Rolling, theta: mpf, omega: mpf, end: mpf, way: int = 1) -> tuple[mpf, mpf]:
    """When it gets to an angle without turning, and how fast it turns there."""
    t, theta, omega, end = mpf(0), mpf(theta), mpf(omega), mpf(end)
    while True:
        th, om = series(hoop, theta, omega, way)
        tau = _step(th)
        if way * (value(th, tau) - end) > 0:
            return _root(th, om, end, tau, t)
        t, theta, omega = t + tau, value(th, tau), value(om, tau)
        if way * omega < 0:
            raise ValueError("It turns back before it is there.")


def _root(th: Series, om: Series, end: mpf, tau: mpf, t: mpf) -> tuple[mpf, mpf]:
    low, high = mpf(0), tau
    for _ in range(20):
        middle = (low + high) / 2
        low, high = (middle, high) if (value(th, middle) - end) * om[0] < 0 or middle == 0 else (low, middle)
    at = (low + high) / 2
    for _ in range(8):
        at -= (value(th, at) - end) / value(om, at)
    return t + at, value(om, at)


def time_to_stop(hoop: Rolling, theta: mpf, omega: mpf, way: int = 1) -> tuple[mpf, mpf]:
    """When it stops turning, and at which angle."""
    t, theta, omega = mpf(0), mpf(theta), mpf(omega)
    while True:
        th, om = series(hoop, theta, omega, way)
        tau = _step(om)
        if way * value(om, tau) <= 0:
            rate = [k * om[k] for k in range(1, len(om))]
            low, high = mpf(0), tau
            for _ in range(20):
                middle = (low + high) / 2
                low, high = (middle, high) if way * value(om, middle) > 0 else (low, middle)
            at = (low + high) / 2
            for _ in range(8):
                at -= value(om, at) / value(rate, at)
            return t + at, value(th, at)
        t, theta, omega = t + tau, value(th, tau), value(om, tau)
