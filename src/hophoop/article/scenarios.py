"""The article's five motions, by name."""

from __future__ import annotations

from hophoop.scenario import Hoop, Plane, Scenario, Start

# Name → v0 (m/s), μ, duration (s). The article has no durations; here each motion shows all that the article reports of it,
# and at least one revolution.
RUNS = {
    "slow": (0.1, 1.0, 6.0),
    "faster": (2.0, 1.0, 3.4),
    "slipping": (2.8, 1.0, 4.0),
    "hop": (3.1, 1.0, 3.0),
    "low_friction": (0.1, 0.3, 15.0),
}

GAMMA, GRAVITY = 0.75, 9.81


def scenarios() -> dict[str, Scenario]:
    """Return the article's five motions: R = 1 m, m = 1 kg, γ = 3/4.

    Returns
    -------
    scenarios : dict of str to Scenario
        'slow' (0.1 m/s), 'faster' (2 m/s), 'slipping' (2.8 m/s), 'hop' (3.1 m/s) and 'low_friction' (0.1 m/s
        on μ = 0.3), in the article's order.

    References
    ----------
    :cite:t:`Sonnerlind2023`.

    Examples
    --------
    >>> import hophoop as hh
    >>> [hh.simulate(scenario).sequence[:6] for scenario in scenarios().values()]
    ['R', 'R', 'RKRSRK', 'RKRSHR', 'RSRKRS']
    """
    return {
        name: Scenario(
            hoop=Hoop.ideal(GAMMA),
            plane=Plane(mu=mu, gravity=GRAVITY),
            start=Start.rolling(speed),
            duration=duration,
        )
        for name, (speed, mu, duration) in RUNS.items()
    }


def title(name: str) -> str:
    """Title of a motion in figures: its speed, and its friction if that is not 1."""
    speed, mu, _ = RUNS[name]
    return f"$v_0$ = {speed:g} m/s" + (f", $\\mu$ = {mu:g}" if mu != 1.0 else "")
