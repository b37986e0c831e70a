"""Where doubles do not decide: margins that vanish by the physics, and just beside."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest
from numpy.polynomial import chebyshev

import hophoop as hh
from hophoop.kernel.numerics.collocation import NOT_FOUND
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.records.layout import new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.writing import record_doubt
from hophoop.kernel.rigid import panel_events
from hophoop.kernel.rigid.panel_events import (
    CLOSE,
    end_of_rolling,
    end_of_slip,
    margin_downcrossing,
    record_tangency,
    touches_zero,
)
from hophoop.kernel.rigid.transitions import mode_is_in_doubt
from newton_euler import accelerations

SCRATCH = new_scratch()


def body_of(eps=0.0, kap=1.0, mu=0.5, slope=0.0, **plane):
    return hh.Scenario(hoop=hh.Hoop(eccentricity=eps, inertia_ratio=kap), plane=hh.Plane(mu=mu, slope=slope, **plane)).to_body()


def in_doubt(body, angle=0.0, vt=0.0, om=0.0):
    return mode_is_in_doubt(body, start_state(0.0, 0.0, angle, vt, 0.0, om))


@pytest.mark.parametrize("kap", [1.0, 0.5])
def test_a_ring_that_just_rolls_on_a_slope(kap):
    """It needs tan β κ/(1 + κ) of friction."""
    slope = 0.75
    needed = math.tan(slope) * kap / (1.0 + kap)
    assert in_doubt(body_of(kap=kap, mu=needed, slope=slope))
    assert in_doubt(body_of(kap=kap, mu=needed * (1.0 + 5e-12), slope=slope))
    for mu in (needed * (1.0 + 1e-10), needed * (1.0 - 1e-10)):
        assert not in_doubt(body_of(kap=kap, mu=mu, slope=slope))
    assert not in_doubt(body_of(kap=kap, mu=math.inf, slope=slope))


def test_on_a_slope_of_45_degrees():
    """Where g_n − g_t would be no size at all."""
    slope = math.pi / 4.0
    assert in_doubt(body_of(mu=0.5 * math.tan(slope) * (1.0 + 5e-12), slope=slope))


@pytest.mark.parametrize("slip", [1.0, -1.0])
def test_slip_that_just_lifts(slip):
    """With the load at the top the rim is free where ε θ̇² = g."""
    body = body_of(0.5, 0.75)
    free = math.sqrt(1.0 / body.eps)
    assert in_doubt(body, vt=slip, om=free)
    assert not in_doubt(body, vt=slip, om=free * (1.0 + 1e-10))
    assert not in_doubt(body, vt=slip, om=free * (1.0 - 1e-10))


def test_rolling_that_just_lifts():
    body = body_of(0.5, 0.75)
    free = math.sqrt(1.0 / body.eps)
    assert in_doubt(body, om=free)
    assert not in_doubt(body, om=free * (1.0 + 1e-10))
    assert not in_doubt(body, om=free * (1.0 - 1e-10))


@pytest.mark.parametrize(("part", "doubtful"), [(-1.1, False), (-0.9, True), (0.9, True), (1.1, False)])
def test_how_near_to_zero_is_in_doubt(part, doubtful):
    """Beside g_n + ε θ̇² in slip; beside g_n + |g_t| + θ̇² the margin to the cone, N and f_n in rolling."""
    for slip in (1.0, -1.0):
        body = body_of(0.75, 0.4375, slope=0.25)
        free = (body.gn + part * CLOSE * 2.0 * body.gn) / body.eps
        assert in_doubt(body, vt=slip, om=math.sqrt(free)) is doubtful
    slope = 0.75
    needed = 0.5 * math.tan(slope)
    margin = 0.5 * math.sin(slope) / math.hypot(1.0, needed)  # times what μ has too much, as a part of it
    scale = math.cos(slope) + math.sin(slope)
    assert in_doubt(body_of(mu=needed * (1.0 + part * CLOSE * scale / margin), slope=slope)) is doubtful
    body = body_of(0.5, 0.75)
    # N of rolling at θ = 1 is a linear function of θ̇²
    still, spun = accelerations(body, 1.0, 0.0, "roll")[4], accelerations(body, 1.0, 1.0, "roll")[4]
    zero = still / (still - spun)
    assert in_doubt(body, 1.0, om=math.sqrt((still - part * CLOSE * (1.0 + zero)) / (still - spun))) is doubtful


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_rolling_beyond_the_cone_that_just_lifts(side):
    """Where N would pull, and ε θ̇² cos θ = g but for rounding; where N holds the hoop it does not matter."""
    body = body_of(0.5, 0.75)
    free = 1.0 / (0.5 * math.cos(1.0))
    for part, doubtful in ((-1.1, False), (-0.9, True), (0.9, True), (1.1, False)):
        om = math.sqrt(free * (1.0 + part * CLOSE * (1.0 + free)))
        assert in_doubt(body, side * 1.0, om=om) is doubtful
    steep = body_of(0.5, 0.75, mu=5.0, slope=-1.2 * side)
    om = math.sqrt(steep.gn / (0.5 * math.cos(1.0)))
    friction, normal = accelerations(steep, side * 1.0, om, "roll")[3:]
    assert 0.0 < abs(friction) < 5.0 * normal
    assert not in_doubt(steep, side * 1.0, om=om)


def test_without_friction_and_without_mass_there_is_no_margin():
    assert not in_doubt(body_of(0.5, 0.75, mu=0.0), om=math.sqrt(2.0))
    massless = hh.Scenario(hoop=hh.Hoop.ideal(1.0)).to_body()
    assert not in_doubt(massless, angle=0.0, om=1.0)
    assert not in_doubt(body_of(0.5, 0.75, gravity=0.0))  # nothing moves, nothing is decided


def test_the_first_doubt_stays():
    record_doubt(SCRATCH.doubt, 1.0)
    record_doubt(SCRATCH.doubt, 3.0)
    assert SCRATCH.doubt.tolist() == [1.0]
    SCRATCH.doubt[:] = math.nan


def grazes(function, scale=1.0):
    SCRATCH.values[:] = 1e3  # what was there before does not count
    return touches_zero(function(NODES), scale, SCRATCH)


@pytest.mark.parametrize("place", [-0.9, -0.3, 0.0, 0.55, 0.95])
@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_a_smallest_value_of_zero_is_a_graze(place, size):
    assert grazes(lambda xi: size * ((xi - place) ** 2 + 0.5 * CLOSE), size)
    assert not grazes(lambda xi: size * ((xi - place) ** 2 + 20.0 * CLOSE), size)
    assert not grazes(lambda xi: size * ((xi - place) ** 2 - 20.0 * CLOSE), size)
    assert not grazes(lambda xi: size * (0.5 * CLOSE - (xi - place) ** 2), size)  # a largest value


@pytest.mark.parametrize("which", [0, 1, 2, 3])
def test_each_of_four_smallest_values_is_looked_at(which):
    """1 + T₈, which is zero four times, lifted but for one of them."""
    zeros = np.cos(np.pi * np.array([7.0, 5.0, 3.0, 1.0]) / 8.0)

    def waves(xi):
        wave = 1.0 + chebyshev.chebval(xi, [0.0] * 8 + [1.0])
        return wave + 1e-3 * (xi - zeros[which]) ** 2

    assert grazes(waves)
    assert not grazes(lambda xi: waves(xi) + 1e-5)


def test_a_graze_of_the_fastest_wave_on_a_panel():
    assert grazes(lambda xi: 1.0 + chebyshev.chebval(xi, [0.0] * (len(NODES) - 1) + [1.0]))


def test_what_falls_all_the_way_has_no_smallest_value_inside():
    assert not grazes(lambda xi: -1.0 * xi)
    assert not grazes(np.exp)


@pytest.mark.parametrize("place", np.linspace(-0.99, 0.99, 23))
def test_the_nodes_show_where_to_look_for_a_graze(place):
    """A parabola that touches zero between them is nearly zero at one, beside its range."""
    assert margin_downcrossing((NODES - place) ** 2 + 1e-12, False, 0.0, SCRATCH) == (NOT_FOUND, True)


@pytest.mark.parametrize("which", [0, 1])
def test_either_margin_counts_relative_to_its_own_scale(which):
    for part, doubtful in ((0.9, True), (1.1, False)):
        scratch = new_scratch()
        margins, scales = [1.0 + NODES**2, 1.0 + NODES**2], [1e3, 1e3]
        scales[which] = 7.0
        margins[which] = NODES**2 + part * CLOSE * 7.0
        record_tangency(margins[0], scales[0], margins[1], scales[1], 3.0, scratch)
        assert scratch.doubt.tolist() == [3.0] if doubtful else np.isnan(scratch.doubt).all()


class Sides(NamedTuple):
    """What the search for events asks of a panel."""

    sigma: int
    vt: float
    u: float
    direction: float = 1.0


@pytest.mark.parametrize("sigma", [0, 1, -1])
def test_tangencies_are_relative_to_forces_and_speeds(sigma, monkeypatch):
    """In rolling to g_n + |g_t| + θ̇² at the panel's start, in slip to g_n + θ̇² for N and |v_t| + |θ̇| for v_t."""
    body = body_of(0.5, 0.75, slope=0.5)
    state = start_state(0.0, 0.0, 0.0, 3.0, 0.0, -0.5)
    scratch, found = new_scratch(), []
    monkeypatch.setattr(panel_events, "record_tangency", lambda *given: found.append((given[1], given[3])))
    monkeypatch.setattr(panel_events, "margin_downcrossing", lambda *given: (NOT_FOUND, True))
    panel = Sides(sigma, 3.0, 0.25)
    if sigma == 0:
        end_of_rolling(body, panel, state, False, scratch)
    else:
        end_of_slip(body, panel, state, False, 0, scratch)
    weight = body.gn + 0.25
    assert found == [(weight + body.gt, weight + body.gt) if sigma == 0 else (weight, 3.5)]
