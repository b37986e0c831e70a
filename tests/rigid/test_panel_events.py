"""Where a margin on a panel comes to zero: by polynomials whose zeros are known."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

import hophoop as hh
from contact_tools import sines_of
from hophoop.kernel.numerics.collocation import NOT_FOUND
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.panel import ARRIVE, COSINE, RATE, SLIP, U, linear_panel
from hophoop.kernel.records.layout import new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid import panel_choice, panel_events
from hophoop.kernel.rigid.flight_phase import flight_start
from hophoop.kernel.rigid.phase import Ending, limits_of
from newton_euler import accelerations

SCRATCH = new_scratch()


def fall(values, begins=False, floor=0.0):
    return panel_events.margin_downcrossing(np.array(values), begins, floor, SCRATCH)


@pytest.mark.parametrize("zero", [-0.9, -0.2, 0.0, 0.7])
@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_a_margin_that_falls_through_zero(zero, size):
    place, _ = fall(size * (zero - NODES) * (2.0 + NODES))
    assert place == pytest.approx(zero, abs=1e-14)


def test_a_margin_that_rises_or_stays_has_no_fall():
    assert fall(0.5 + NODES, begins=True)[0] == NOT_FOUND
    assert fall(1.5 + NODES) == (NOT_FOUND, False)
    assert fall(np.full(16, 1.0)) == (NOT_FOUND, False)
    # a function that the panel resolves does not go far below its nodes: no zero is looked for
    assert fall(1.3 * 2.0 * panel_events.FAR_FROM_ZERO + (1.0 + NODES)) == (NOT_FOUND, False)


def test_a_margin_below_zero_at_the_begin_of_a_panel_has_fallen_there():
    """Unless the phase begins there, where a margin of zero is none yet."""
    assert fall(-0.5 - 0.1 * NODES)[0] == -1.0
    assert fall(-0.5 + NODES)[0] == -1.0
    assert fall(np.zeros(16))[0] == -1.0
    assert fall(NODES + 1.0 - 1e-13)[0] == -1.0  # also where no node shows it
    assert fall(1.0 * (NODES + 1.0), begins=True)[0] == NOT_FOUND


@pytest.mark.parametrize("floor", [1e-16, 1e-3])
def test_a_margin_that_is_zero_but_for_rounding_counts_as_zero(floor):
    assert fall(np.full(16, -0.9 * floor), floor=floor)[0] == NOT_FOUND
    assert fall(np.full(16, -1.1 * floor), floor=floor)[0] == -1.0
    below = np.full(16, -0.1 * floor)
    below[-1] = -1.1 * floor
    assert fall(below, floor=floor)[0] == -1.0


@pytest.mark.parametrize("power", [2, 3, 4, 5])
def test_a_margin_that_begins_with_rounding_and_falls_has_fallen_at_its_begin(power):
    """Its fall was passed over where the first piece of it stayed within the rounding, and ended the next panel instead."""
    falls = -1e-4 * (1.0 + NODES) ** power
    assert fall(falls + 3e-17, floor=3e-14)[0] == -1.0
    assert fall(1e-12 * falls + 3e-17, floor=3e-14)[0] == NOT_FOUND  # a touch
    assert fall(falls + 1e-6, floor=3e-14)[0] == pytest.approx(-1.0 + 0.01 ** (1.0 / power), abs=1e-12)


@pytest.mark.parametrize("rounding", [-1e-17, 0.0, 1e-17, 2e-14, -2e-14])
def test_the_sign_of_a_margins_rounding_at_the_begin_decides_nothing(rounding):
    """Whichever side it leaves to is what counts: one that rises first falls later, or not at all."""
    rises = 1e-4 * (1.0 + NODES)
    for floor in (3e-14, 1e-12):
        assert fall(rounding + rises, floor=floor)[0] == NOT_FOUND
        assert fall(rounding - rises, floor=floor)[0] == -1.0
        assert fall(rounding + rises * (0.5 - NODES), floor=floor)[0] == pytest.approx(0.5, abs=1e-9)
        assert fall(rounding - rises * (0.5 - NODES), floor=floor)[0] == -1.0
        assert fall(np.full(16, rounding), floor=floor)[0] == NOT_FOUND


@pytest.mark.parametrize("place", [-0.6, 0.1, 0.9])
@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_a_parabola_that_touches_zero_is_near_it(place, size):
    assert fall(size * (NODES - place) ** 2, begins=True)[1]
    assert not fall(size * ((NODES - place) ** 2 + 0.1), begins=True)[1]
    assert not fall(size * ((NODES - place) ** 2 - 0.1), begins=True)[1]


def body_of(eccentricity, inertia_ratio, **plane):
    hoop = hh.Hoop(eccentricity=eccentricity, inertia_ratio=inertia_ratio)
    return hh.Scenario(hoop=hoop, plane=hh.Plane(mu=0.0, **plane)).to_body()


@pytest.mark.parametrize(("eps", "kap"), [(0.75, 0.4375), (0.9, 0.02), (0.3, 2.0), (0.0, 1.0)])
def test_the_rounding_of_slip_without_friction(eps, kap):
    """From rest at the top to the bottom the weight gives 2 ε of energy, all to ½ κ θ̇²: the rim then slips at (1 − ε) θ̇."""
    at_rest = start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    lowest = (1.0 - eps) * math.sqrt(2.0 * 2.0 * eps / kap)
    found = panel_events.tangency_rounding(body_of(eps, kap), at_rest)
    assert found == pytest.approx(1e-14 * (2.0 * math.sqrt(eps) + lowest), rel=1e-14, abs=0.0)
    moving = start_state(0.0, 0.0, 0.0, -2.0, 0.0, -3.0)
    assert panel_events.tangency_rounding(body_of(eps, kap), moving) == pytest.approx(found + 5e-14, rel=1e-14, abs=0.0)
    assert panel_events.tangency_rounding(body_of(eps, kap, gravity=0.0), moving) == pytest.approx(5e-14, rel=1e-14, abs=0.0)


def test_the_rounding_of_slip_without_mass_in_the_rim():
    moving = start_state(0.0, 0.0, 0.0, -2.0, 0.0, -3.0)
    found = panel_events.tangency_rounding(body_of(1.0, 0.0), moving)
    assert found == pytest.approx(1e-14 * (2.0 + 3.0 + 2.0), rel=1e-14, abs=0.0)


class Panel(NamedTuple):
    """What the end of slip asks of a panel and of its end."""

    sigma: int = 1
    u: float = 1.0
    vt: float = 1.0


def end_of_slip(slip, load, *, mu=0.5, sigma=1, begins=False, vanishing=0, vt=1.0):
    """(ξ, ending, whether tangencies are looked for, whether a doubt is recorded) for v_t and N/κ at the nodes."""
    hoop, plane = hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), hh.Plane(mu=mu)
    body = hh.Scenario(hoop=hoop, plane=plane).to_body()
    scratch = new_scratch()
    scratch.work[COSINE] = -1.0
    scratch.work[U] = (load - body.gn) / body.eps
    scratch.work[SLIP] = sigma * slip
    state = start_state(0.0, 0.0, math.pi, sigma * vt, 0.0, 1.0)._replace(t=3.0)
    panel = Panel(sigma)
    looked = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(panel_events, "record_tangency", lambda *given: looked.append(given))
        xi, ending = panel_events.end_of_slip(body, panel, state, begins, vanishing, scratch)
    noted = scratch.doubt.tolist() == [3.0]
    assert noted or np.isnan(scratch.doubt).all()
    return xi, ending, bool(looked), noted


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("mu", [0.5, 0.0])
def test_slip_ends_or_the_rim_lifts_whichever_is_first(sigma, mu):
    one = np.full(16, 1.0)
    stop, lift = Ending.SLIP_END, Ending.LIFT_OFF
    for first, second, what in ((0.25 - NODES, one, stop), (one, 0.25 - NODES, lift), (0.25 - NODES, 0.75 - NODES, stop)):
        found = end_of_slip(first, second, mu=mu, sigma=sigma)
        assert found[:2] == (pytest.approx(0.25, abs=1e-14), what)
        assert not found[3]
    assert end_of_slip(0.75 - NODES, 0.25 - NODES, mu=mu, sigma=sigma)[1] == lift
    for off in (-1e-14, -1e-15, 0.0, 1e-15, 1e-14):  # lift-off is first, whatever the rounding, and doubtful
        xi, what, _, noted = end_of_slip(0.25 - off - NODES, 0.25 - NODES, mu=mu, sigma=sigma)
        assert (xi, what, noted) == (pytest.approx(0.25, abs=1e-14), lift, mu > 0.0)
    assert end_of_slip(one, one, mu=mu, sigma=sigma)[0] == NOT_FOUND


def test_slip_that_has_ended_before_the_first_node():
    """From a speed that is lost in what the panel makes of it."""
    one, slip = np.full(16, 1.0), -(1.0 + NODES)
    # where the panel's series begins a rounding above zero it ends there
    at_once = pytest.approx(-1.0, rel=0.0, abs=1e-15)
    assert end_of_slip(slip, one, begins=True)[:2] == (at_once, Ending.SLIP_END)
    assert end_of_slip(slip, one)[:2] == (at_once, Ending.SLIP_END)
    assert end_of_slip(1.0 + NODES, one, begins=True)[0] == NOT_FOUND
    # begun at no speed: with friction the mode says the direction, without it rounding of θ may be wrong
    assert end_of_slip(slip, one, begins=True, vanishing=1)[0] == NOT_FOUND
    assert end_of_slip(slip, one, begins=True, vanishing=1, mu=0.0)[:2] == (-1.0, Ending.SLIP_END)
    assert end_of_slip((1.0 + NODES) * NODES, one, begins=True, vanishing=1, mu=0.0)[0] == NOT_FOUND


def test_slip_that_ends_at_the_first_node_or_beside_it():
    """An end before the first node is believed, unless the speed is lost in what the panel makes of it."""
    one, stop = np.full(16, 1.0), Ending.SLIP_END
    assert end_of_slip(-0.999 - NODES, one, begins=True)[:2] == (pytest.approx(-0.999, abs=1e-13), stop)
    assert end_of_slip(-0.999 - NODES, one, begins=True, vt=1e-150)[:2] == (-1.0, stop)
    assert end_of_slip(-0.96 - NODES, one, begins=True)[:2] == (pytest.approx(-0.96, abs=1e-13), stop)
    assert end_of_slip(0.25 - NODES, one, begins=True)[:2] == (pytest.approx(0.25, abs=1e-13), stop)
    # below zero at the first node: what comes later is not the end of that slip
    for rise, fall_again in ((-0.95, 0.5), (-0.98, -0.96)):
        assert end_of_slip((NODES - rise) * (fall_again - NODES), one, begins=True)[:2] == (-1.0, stop)


@pytest.mark.parametrize("vanishing", [1, 2])
@pytest.mark.parametrize("mu", [0.5, 0.0])
def test_slip_that_begins_with_no_speed_may_end_at_once(vanishing, mu):
    """Zeros of v_t at the begin are taken out, so that one beside them is found."""
    one, start = np.full(16, 1.0), (1.0 + NODES) ** vanishing
    for end in (1e-9, 1e-3, 1.25):
        xi, what, _, _ = end_of_slip(start * (end - (1.0 + NODES)), one, begins=True, vanishing=vanishing, mu=mu)
        assert (xi, what) == (pytest.approx(end - 1.0, abs=1e-14), Ending.SLIP_END)
    assert end_of_slip(0.3 * start, one, begins=True, vanishing=vanishing, mu=mu)[0] == NOT_FOUND


def test_slip_without_friction_that_begins_slowly_to_the_other_side():
    one = np.full(16, 1.0)
    assert end_of_slip(-0.1 * (1.0 + NODES), one, begins=True, vanishing=1, mu=0.0)[:2] == (-1.0, Ending.SLIP_END)


def test_slip_and_load_below_zero_at_the_begin_of_a_panel():
    """However much they are above it at its nodes."""
    one, steep = np.full(16, 1.0), 1e4 * (1.0 + NODES) - 1.0
    assert steep.min() > 1.0
    assert end_of_slip(one, steep)[:2] == (-1.0, Ending.LIFT_OFF)
    assert end_of_slip(steep, one)[:2] == (-1.0, Ending.SLIP_END)


def test_slip_without_friction_is_zero_within_its_rounding():
    one, little = np.full(16, 1.0), np.full(16, -1e-15)
    assert end_of_slip(little, one, mu=0.0)[0] == NOT_FOUND
    assert end_of_slip(100.0 * little, one, mu=0.0)[:2] == (-1.0, Ending.SLIP_END)
    assert end_of_slip(little, one)[:2] == (-1.0, Ending.SLIP_END)


@pytest.mark.parametrize("begins", [True, False])
def test_slip_or_load_that_touches_zero_is_doubtful(begins):
    """With friction; v_t of slip that begins is no decision."""
    one, touching = np.full(16, 1.0), (NODES - 0.1) ** 2 + 1e-4
    for slip, load, doubtful in (
        (one, one, False),
        (one, touching, True),
        (touching, one, not begins),
        (touching, touching, True),
    ):
        assert bool(end_of_slip(slip, load, begins=begins)[2]) == doubtful
        assert not end_of_slip(slip, load, begins=begins, mu=0.0)[2]


def needed(panel, xi, u, body, rho=0.0):
    """(F, N) that rolling needs at a place of a panel."""
    return accelerations(body, panel.ref + panel.direction * 0.5 * panel.extent * (1.0 + xi), math.sqrt(u), "roll", rho)[3:]


def rolled(body, th, om, level=2):
    """(panel, totals, scratch) of a solved panel of rolling."""
    scratch = new_scratch()
    state = start_state(0.0, 0.0, th, 0.0, 0.0, om)
    begin = panel_choice.panel_start(body, 0, state, *sines_of(state), scratch)
    panel = linear_panel(0, level, math.copysign(1.0, om), begin)
    return panel, panel_choice.solve(body, panel, scratch.work), scratch


def end_of_rolling(body, panel, scratch, begins=False):
    """(ξ, ending, whether tangencies are looked for)."""
    looked = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(panel_events, "record_tangency", lambda *given: looked.append(given))
        found = panel_events.end_of_rolling(body, panel, start_state(0.0, 0.0, panel.ref, 0.0, 0.0, 1.0), begins, scratch)
    return *found, bool(looked)


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("resist", [0.0, 0.0625])
@pytest.mark.parametrize(("th", "om"), [(0.25, 0.5), (4.0, 2.0), (0.25, 1.25)])
def test_rolling_ends_where_it_needs_all_friction(way, resist, th, om):
    """Newton's equations say how much that is; to the other side in the mirrored motion."""
    hoop, plane = hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), hh.Plane(mu=0.5, rolling_resistance=resist)
    body = hh.Scenario(hoop=hoop, plane=plane).to_body()
    panel, _, scratch = rolled(body, way * th, way * om)
    place = 0.375
    u = np.polynomial.Polynomial.fit(NODES, scratch.work[U], 15)(place)
    friction, normal = needed(panel, place, u, body, way * resist)
    need = np.array(
        [needed(panel, xi, value, body, way * resist) for xi, value in zip(NODES, scratch.work[U].copy(), strict=True)]
    )
    need = np.abs(need[:, 0] / need[:, 1])
    assert need[0] < abs(friction) / normal < need[-1]
    tight = body._replace(mu_s=abs(friction) / normal)
    xi, what, doubtful = end_of_rolling(tight, panel, scratch)
    assert xi == pytest.approx(place, abs=1e-12)
    assert what == (Ending.CONE_FORWARD if friction > 0.0 else Ending.CONE_BACKWARD)
    assert not doubtful
    found = end_of_rolling(body._replace(mu_s=2.0 * need[-1]), panel, scratch)
    assert (found[0], bool(found[2])) == (NOT_FOUND, False)
    # below what is needed from the begin of the panel on
    low = body._replace(mu_s=0.5 * need[0])
    assert end_of_rolling(low, panel, scratch)[:2] == (-1.0, what)
    assert end_of_rolling(low, panel, scratch, begins=True)[0] == NOT_FOUND


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_without_a_limit_of_friction_rolling_ends_ahead(way):
    """Both sides of the cone are N = 0 then; the mirrored motion comes to the mirrored side."""
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.9, inertia_ratio=0.2), plane=hh.Plane(mu=math.inf)).to_body()
    panel, _, scratch = rolled(body, way * 0.5, way * 0.75, level=0)
    xi, what, doubtful = end_of_rolling(body, panel, scratch)
    assert -1.0 < xi < 1.0
    assert what == (Ending.CONE_FORWARD if way > 0.0 else Ending.CONE_BACKWARD)
    assert not doubtful


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_rolling_that_needs_nearly_all_friction_is_doubtful(way, side):
    """Where F/N has its largest value inside the panel, to either side."""
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), plane=hh.Plane(mu=0.5)).to_body()
    th, om = way * (math.pi - side * 1.5), way * 1.0
    panel, _, scratch = rolled(body, th, om, level=0)
    need = [needed(panel, xi, u, body) for xi, u in zip(NODES, scratch.work[U].copy(), strict=True)]
    need = np.array([friction / normal for friction, normal in need])
    most = abs(need[np.argmax(np.abs(need))])
    for factor, near in ((1.001, True), (0.999, True), (1.5, False), (0.5, False)):
        assert bool(end_of_rolling(body._replace(mu_s=factor * most), panel, scratch)[2]) == near
    for mu in (0.0, math.inf):
        assert not end_of_rolling(body._replace(mu_s=mu), panel, scratch)[2]


@pytest.mark.parametrize("om", [0.0, 100.0])
def test_the_rounding_of_the_friction_that_rolling_needs(om):
    """Of a ring on a slope, which needs the same at every speed: lost in the forces of a fast one, where it lacks a little."""
    slope = 0.75
    needed = math.tan(slope) / 2.0
    for part, found in ((1e-14, NOT_FOUND if om else -1.0), (1e-10, -1.0), (-1e-14, NOT_FOUND)):
        body = hh.Scenario(hoop=hh.Hoop.ideal(0.0), plane=hh.Plane(mu=needed * (1.0 - part), slope=slope)).to_body()
        panel, _, scratch = rolled(body, 0.5, max(om, 1.0))
        scratch.work[U] = om**2
        assert end_of_rolling(body, panel._replace(u=om**2), scratch)[0] == found


def test_where_the_time_is_over():
    scratch = new_scratch()
    scratch.work[RATE] = 0.5  # the panel takes 1
    for left, xi in ((0.25, -0.5), (0.5, 0.0), (1.0, 1.0), (1.5, 1.0), (0.0, -1.0), (-0.5, -1.0), (-1.0, -1.0)):
        assert panel_events.end_of_time(left, scratch) == pytest.approx(xi, abs=1e-14)


def test_how_a_flight_opens():
    """f_n, and how many derivatives of the gap are zero: none above the plane, three where f_n is zero, too."""
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75)).to_body()
    fast, free = 2.0, math.sqrt(2.0)  # ε θ̇² = 2 g and g, with the load at the top

    def opening(y, v_n, om):
        return flight_start(body, start_state(0.0, y, 0.0, 0.0, v_n, om), False)

    assert opening(1.0, 0.0, fast) == (1.0, 0)
    assert opening(0.0, 1.0, fast) == (1.0, 1)
    assert opening(0.0, 0.0, fast) == (1.0, 2)
    assert opening(0.0, 0.0, free) == (0.0, 3)
    assert opening(0.0, 0.0, free * (1.0 + 1e-12))[1] == 2


FAR = 1e3


def earliest(body, panel, totals, state, scratch, *, t_end=FAR, span=math.nan, begin=None, begins=False):
    limits = limits_of(begin or state, t_end, span, 0, 0)
    return panel_events.earliest_event(body, panel, totals, state, begins, 0, limits, scratch)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_panel_ends_at_the_angle_or_the_time_that_is_the_limit(way):
    """Of a ring that rolls at the speed of 1 on a panel of 0.9 rad: whichever is first."""
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.0), plane=hh.Plane(mu=0.5)).to_body()
    state = start_state(0.0, 0.0, way * 0.5, 0.0, 0.0, way)
    panel, totals, scratch = rolled(body, way * 0.5, way, level=0)
    assert totals.time == pytest.approx(0.9, rel=1e-15)
    on, angle, time = Ending.CONTINUES, Ending.ANGLE_LIMIT, Ending.TIME_LIMIT
    for span, xi, what in ((0.225, -0.5, angle), (0.9, 1.0, angle), (0.901, 1.0, on), (1e-9, 2e-9 / 0.9 - 1.0, angle)):
        assert earliest(body, panel, totals, state, scratch, span=span) == (pytest.approx(xi, abs=1e-15), what)
    # of what is left where the motion began before; nothing is
    for span, moved in ((0.25, 0.25), (0.25, 0.4)):
        begin = state._replace(th=state.th - way * moved)
        assert earliest(body, panel, totals, state, scratch, span=span, begin=begin) == (-1.0, angle)
    for t_end, xi, what in ((0.225, -0.5, time), (totals.time, 1.0, time), (0.901, 1.0, on), (0.0, -1.0, time)):
        assert earliest(body, panel, totals, state, scratch, t_end=t_end) == (pytest.approx(xi, abs=1e-14), what)
    assert earliest(body, panel, totals, state, scratch, t_end=0.5, span=0.25)[1] == angle
    assert earliest(body, panel, totals, state, scratch, t_end=0.25, span=0.5)[1] == time
    # at once: the contact before the angle, the angle before the time
    begin = state._replace(th=state.th - way * 0.25)
    limits = {"t_end": 0.0, "span": 0.25, "begin": begin}
    assert earliest(body, panel, totals, state, scratch, **limits) == (-1.0, angle)
    steep = hh.Scenario(hoop=hh.Hoop.ideal(0.0), plane=hh.Plane(mu=0.125, slope=0.75)).to_body()
    panel, totals, scratch = rolled(steep, way * 0.5, way, level=0)
    assert earliest(steep, panel, totals, state, scratch, **limits) == (-1.0, Ending.CONE_BACKWARD)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_the_limits_of_a_panel_up_to_a_turning_point(way):
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), plane=hh.Plane(mu=5.0)).to_body()
    th = math.pi + way * 2.5
    state = start_state(0.0, 0.0, th, 0.0, 0.0, way * 1e-2)
    scratch = new_scratch()
    with np.errstate(all="ignore"):  # of panels that are given up
        panel, totals, _ = panel_choice.choose_panel(body, 0, state, *sines_of(state), 2, scratch)
    assert panel.kind == ARRIVE
    assert earliest(body, panel, totals, state, scratch) == (1.0, Ending.TURNING_POINT)
    for part in (0.25, 0.75):
        xi, what = earliest(body, panel, totals, state, scratch, span=part * panel.extent)
        assert (1.0 - part, what) == (pytest.approx((0.5 * (1.0 - xi)) ** 2, rel=1e-13), Ending.ANGLE_LIMIT)


def test_a_ring_that_slips_until_it_rolls():
    """At 2 μ g the slip is lost, on a level: no limit of it is passed."""
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.0), plane=hh.Plane(mu=0.5)).to_body()
    state, scratch = start_state(0.0, 0.0, 0.5, 0.125, 0.0, 2.0), new_scratch()
    panel, totals, _ = panel_choice.choose_panel(body, 1, state, *sines_of(state), 2, scratch)
    xi, what = earliest(body, panel, totals, state, scratch)
    turned = 2.0 * 0.125 + 0.5 * 0.5 * 0.125**2  # in 1/8
    assert (xi, what) == (pytest.approx(2.0 * turned / panel.extent - 1.0, abs=1e-13), Ending.SLIP_END)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_doubt_is_noted_with_the_time_of_the_panel(way):
    """Where the friction that rolling needs just comes to its limit, as far as doubles can tell."""
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), plane=hh.Plane(mu=0.5)).to_body()
    th, om = way * (math.pi - 1.5), way * 1.0
    panel, totals, scratch = rolled(body, th, om, level=0)
    state = start_state(0.0, 0.0, th, 0.0, 0.0, om)._replace(t=3.0)
    u = np.polynomial.Polynomial.fit(NODES, scratch.work[U], 15)

    def need(xi):
        friction, normal = needed(panel, xi, u(xi), body)
        return friction / normal

    grid = np.linspace(-0.99, 0.99, 41)
    coarse = grid[np.argmax([abs(need(xi)) for xi in grid])]
    most = -minimize_scalar(lambda xi: -abs(need(xi)), bounds=(coarse - 0.1, coarse + 0.1), options={"xatol": 1e-9}).fun
    for factor, doubt in ((1.0, True), (1.001, False), (1.5, False)):
        scratch.doubt[:] = math.nan
        earliest(body._replace(mu_s=factor * most), panel, totals, state, scratch)
        assert scratch.doubt.tolist() == [3.0] if doubt else np.isnan(scratch.doubt).all()


def test_without_a_limit_of_friction_a_force_that_touches_zero_is_no_doubt():
    """The rim then lifts off and comes back at once, or does not."""
    body = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.75), plane=hh.Plane(mu=math.inf)).to_body()
    panel, totals, scratch = rolled(body, -0.45, 1.0, level=0)
    state = start_state(0.0, 0.0, -0.45, 0.0, 0.0, 1.0)

    def lowest(u):
        normals = [needed(panel, xi, u, body)[1] for xi in NODES]
        series = np.polynomial.Polynomial.fit(NODES, normals, 15)
        return minimize_scalar(series, bounds=(-0.9, 0.9), options={"xatol": 1e-9}).fun

    scratch.work[U] = brentq(lowest, 0.5, 10.0, xtol=1e-15)
    assert not end_of_rolling(body, panel, scratch)[2]
    earliest(body, panel, totals, state, scratch)
    assert np.isnan(scratch.doubt).all()
