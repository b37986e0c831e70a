"""Phases that are over at once are proved, and soon."""

from __future__ import annotations

import pytest

import hophoop as hh
from hophoop.prove import prove

pytest.importorskip("flint")

# hops of 7·10⁻⁸ s, just above the speed from which there is one, and of 1.8·10⁻⁸ s, with a centripetal force just above g
SHORT_HOPS = {
    "threshold": hh.Scenario(start=hh.Start.rolling(2.9081602262491906), duration=1.7),
    "start": hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.5),
        plane=hh.Plane(mu=0.3, gravity=8.0),
        start=hh.Start(vx=2.0, omega=4.000000000000001),
        duration=5.0,
    ),
}


@pytest.mark.parametrize("name", sorted(SHORT_HOPS))
def test_a_very_short_hop_is_proved(name):
    found = prove(SHORT_HOPS[name])
    assert found.proved, found.why
    assert "H" in found.sequence


@pytest.mark.parametrize("above", [1e-6, 1e-8, 1e-10, 1e-12])
def test_a_very_short_slip_is_proved(above):
    """Just above the speed from which the hoop slips in its first turn, v_t stays small."""
    found = prove(hh.Scenario(start=hh.Start.rolling(2.0431739123746087 * (1 + above)), duration=1.2), 10)
    assert (found.verdict, found.sequence) == ("proved", "RKRSR"), found.why
