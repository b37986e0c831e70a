r"""Time along a rolling arc from the top, on the level, by elliptic integrals.

Energy of rolling, with a = 1 + κ + ε² and q = sin²(θ/2):

    (a + 2ε − 4εq) R²θ̇² = (a + 2ε) v0² + 4εgR q

so with k = 4ε/(a + 2ε) and n = 4εgR/((a + 2ε) v0²)

    t(θ) = (2R/v0) ∫₀^{θ/2} √[(1 − k sin²φ)/(1 + n sin²φ)] dφ .

Substituting w = 1/sin²φ turns the integral into ½∫ (w − k)/(w √((w − 1)(w − k)(w + n))) dw from w1 =
1/sin²(θ/2) to ∞, which is Carlson's R_F(w1 − 1, w1 − k, w1 + n) − (k/3) R_J(w1 − 1, w1 − k, w1 + n, w1). For
the ideal hoop a + 2ε = 2(1 + γ).
"""

from __future__ import annotations

from mpmath import mp, mpf

from .cases import Case


def constants(case: Case) -> tuple[mpf, mpf, mpf]:
    """k, n and 2R/v0 of the module's formula."""
    eccentricity, radius, speed = mpf(case.eccentricity), mpf(case.radius), mpf(case.vx)
    top = 1 + mpf(case.inertia_ratio) + eccentricity**2 + 2 * eccentricity
    four = 4 * eccentricity
    return four / top, four * mpf(case.gravity) * radius / (top * speed**2), 2 * radius / abs(speed)


def rolling_time(case: Case, angle: mpf) -> mpf:
    """Time [s] of rolling from the top, passed with speed vx ≠ 0, through `angle` ≥ 0 [rad], β = 0."""
    k, n, factor = constants(case)
    turns = mp.nint(angle / (2 * mp.pi))
    rest = angle / 2 - mp.pi * turns

    def arc(phi: mpf) -> mpf:
        w = 1 / mp.sin(phi) ** 2
        return mp.elliprf(w - 1, w - k, w + n) - k / 3 * mp.elliprj(w - 1, w - k, w + n, w)

    return factor * (2 * turns * arc(mp.pi / 2) + (mp.sign(rest) * arc(abs(rest)) if rest else 0))


def rolling_rate(case: Case, angle: mpf) -> mpf:
    """Angular velocity [rad/s] at an angle, from the same energy."""
    k, n, factor = constants(case)
    q = mp.sin(angle / 2) ** 2
    return 2 / factor * mp.sqrt((1 + n * q) / (1 - k * q))
