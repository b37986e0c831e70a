"""The next panel: where it begins, how wide it is, and where a turning point is near."""

from __future__ import annotations

import math

import pytest
from mpmath import mp, mpf
from scipy.optimize import brentq

from hophoop.kernel.panels.anchor import SLIPPING
from hophoop.kernel.panels.panel import ARRIVE, LEAVE, LINEAR, PanelStart, leaving_panel, linear_panel
from hophoop.kernel.records.layout import PANELS, new_scratch
from hophoop.kernel.rigid import panel_choice
from newton_euler import accelerations
from rigid.tools import body_of, sines_of, state_of

RESOLVED = 2e-13
HALF = body_of(0.5, 0.75, mu=1.0)
pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # where a kernel gives up a panel


def width_of(level):
    return 0.9 * 0.5 ** (0.5 * level)


def begin_of(body, sigma, state, scratch=None):
    return panel_choice.panel_start(body, sigma, state, *sines_of(state), scratch or new_scratch())


def anchored(body, sigma, state):
    return panel_choice.set_anchor(body, sigma, state, *sines_of(state), new_scratch())


# where a panel begins


def test_slip_without_friction_keeps_what_it_conserves():
    """(κ + ε² sin² θ) θ̇² + 2 ε cos θ, whichever way the rim slides; less that of the hilltop, as a part of θ̇²."""
    body = body_of(0.5, 0.75, mu=0.0)
    state = anchored(body, 1, state_of(1.0, 2.0, 0.5))
    top = 2.0 * 0.5 * (1.0 - math.cos(1.0)) / (0.75 + 0.25 * math.sin(1.0) ** 2)
    assert state.anchor.kind == SLIPPING
    assert state.anchor.excess == pytest.approx(4.0 - top, rel=1e-14)
    again = anchored(body, -1, state._replace(om=3.0))
    assert again.anchor == state.anchor


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("psi", [1e-9, -1e-4, 0.03125])
def test_slip_beside_its_hilltop_has_all_digits_of_its_torque(sigma, psi):
    body, mu = body_of(0.5, 0.75, mu=0.25), sigma * mpf(0.25)
    with mp.workdps(40):
        th = -mp.atan(mu) - mp.asin(2 * mp.sin(mp.atan(mu))) + mpf(psi)
        q = mp.sin(th) / 2 + mu * (1 + mp.cos(th) / 2)
        firm = mpf(0.75) + mp.sin(th) / 2 * q
        low = float(th - float(th))
    state = anchored(body, sigma, state_of(float(th), 0.5, sigma * 1.0, th_low=low))
    begin = begin_of(body, sigma, state)
    assert state.anchor.kind == SLIPPING
    assert begin.arm == pytest.approx(float(q), rel=1e-12)
    assert begin.kappa_p_sigma == pytest.approx(float(firm), rel=1e-15)


# how wide it is


def test_how_much_narrower_the_next_panel_is():
    """By √2 a level, which gains 2⁸; never by more than four levels at once, and by three where nothing is known."""
    narrower = panel_choice.narrower_level
    for size, more in ((1.0, 3), (math.inf, 3), (math.nan, 3), (0.99, 4), (2.0**25, 3), (2.0**-9, 4)):
        assert narrower(7, size) == 7 + more
    for power, more in ((0.5, 1), (7.5, 1), (8.5, 2), (15.5, 2), (16.5, 3), (23.5, 3), (24.5, 4), (36.5, 4)):
        assert narrower(7, RESOLVED * 2.0**power) == 7 + more


def test_how_much_narrower_slip_is_that_begins_beside_p_sigma_of_zero():
    """By as much as κ p_σ, or that times θ̇², is below 10⁻¹²; only where p_σ grows."""
    body = body_of(0.5, 0.75, mu=0.5)
    begin = PanelStart(0.0, 0.0, -0.6, 0.8, 0.0, 0.0, 0.5, 1e-15, 4.0, 1.0)  # κ p_σ grows with θ by 0.035

    def levels(way=1.0, sigma=1, **values):
        return panel_choice.extra_levels_near_singularity(body, sigma, way, begin._replace(**values))

    assert levels() == math.ceil(2.0 * math.log2(1e3))
    assert levels(u=0.25) == math.ceil(2.0 * math.log2(4e3))
    assert levels(kappa_p_sigma=1e-14) == math.ceil(2.0 * math.log2(1e2))
    assert levels(kappa_p_sigma=1e-310) == math.ceil(2.0 * math.log2(1e288))
    assert levels(way=-1.0) == 0
    assert levels(kappa_p_sigma=0.0) == 0
    assert levels(kappa_p_sigma=-1e-15) == 0
    # on the other side of the hoop it is the other way round
    assert levels(way=-1.0, sigma=-1, sine=0.6, arm=-0.5) == levels()
    assert levels(sigma=-1, sine=0.6, arm=-0.5) == 0


def energy_of(body, th, om):
    """D θ̇² + 2 V in rolling."""
    height = math.cos(th) * body.gn * 0.5 - body.gt * (th + 0.5 * math.sin(th))
    return (1.0 + 0.75 + 0.25 + math.cos(th)) * om * om + 2.0 * height


def start_before(body, th, way, ahead):
    """The state at θ of rolling that turns after the angle `ahead`."""
    still = energy_of(body, th + way * ahead, 0.0)
    om = brentq(lambda one: energy_of(body, th, one) - still, 0.0, 10.0, xtol=1e-300, rtol=1e-15)
    return state_of(th, way * om)


def linear(body, sigma, state, level, scratch):
    """(panel, totals) of a width."""
    begin = begin_of(body, sigma, state, scratch)
    panel = linear_panel(sigma, level, math.copysign(1.0, state.om), begin)
    return panel, panel_choice.solve(body, panel, scratch.work)


def turning_point(body, sigma, state, level):
    scratch = new_scratch()
    panel, totals = linear(body, sigma, state, level, scratch)
    return panel_choice.turning_point_ahead(body, panel, totals, scratch)


@pytest.mark.parametrize("slope", [0.0, 0.125])
@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("resist", [0.0, 1e-12])
def test_a_turning_point_of_rolling_is_found(way, slope, resist):
    """By a panel that reaches beyond it, or by wider ones: at most 8 times as wide as the first."""
    body = body_of(0.5, 0.75, slope=slope, rolling_resistance=resist)
    for ahead, level in ((0.3, 0), (0.3, 3), (0.3, 9), (0.75, 1), (0.75, 3), (0.05, 2), (0.05, 14)):
        found = turning_point(body, 0, start_before(body, math.pi + 0.25 * way, way, ahead), level)
        assert found == pytest.approx(ahead, rel=1e-10)
    # too far for a panel so narrow; and where there is none
    assert turning_point(body, 0, start_before(body, math.pi + 0.25 * way, way, 0.3), 10) == 0.0
    for level in (0, 1, 2):
        assert turning_point(body, 0, state_of(math.pi, way * 2.0), level) == 0.0


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_whether_rolling_turns_not_far_beyond_a_panel(way):
    """Within 8 times its width."""
    body = HALF

    def turns(ahead, level, begin=0.25):
        panel, _ = linear(body, 0, start_before(body, math.pi + begin * way, way, ahead), level, new_scratch())
        return panel_choice.has_turning_point_within(body, panel, 8.0 * panel.extent)

    for ahead, level in ((0.3, 0), (0.6, 6), (0.3, 9), (1.7, 0), (1.0, 2)):
        assert turns(ahead, level)
    assert turns(0.4, 0, math.pi - 0.6)  # shortly before the top, which most of these angles are beyond
    for ahead, level in ((0.3, 10), (1.0, 10)):
        assert not turns(ahead, level)


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize(("th", "ahead"), [(0.25, 0.05), (1.5, 0.3), (2.5, 0.1), (3.0, 0.03), (3.1, 0.01)])
@pytest.mark.parametrize("off", [0.5, 0.95, 1.0, 1.25])
def test_a_panel_up_to_a_turning_point_begins_with_the_speed_there(way, th, ahead, off):
    """Whatever is known of the place, the panel finds the right one; angles are from the valley."""
    body = HALF
    state = start_before(body, math.pi + way * th, way, ahead)
    scratch = new_scratch()
    before, _ = linear(body, 0, state, 2, scratch)
    panel, totals = panel_choice.solve_arrival(body, before, ahead * off, scratch.work)
    assert panel.kind == ARRIVE
    assert panel.extent == pytest.approx(ahead, rel=1e-11)
    assert totals.u == pytest.approx(state.om**2, rel=4e-15)
    assert totals.tail <= RESOLVED


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("ahead", [1e-3, 0.25])
def test_a_panel_up_to_a_turning_point_is_not_moved_where_it_is_not_resolved(way, ahead):
    """A quarter of a swing about the valley never is."""
    body = HALF
    scratch = new_scratch()
    before, _ = linear(body, 0, start_before(body, math.pi, way, ahead), 2, scratch)
    panel, totals = panel_choice.solve_arrival(body, before, ahead, scratch.work)
    assert (panel.kind, panel.extent) == (ARRIVE, ahead)
    assert totals.tail > RESOLVED


def at_rest(body, th, sigma):
    """(θ̈, v̇_t) of slip that does not turn."""
    along, _, alpha, _, _ = accelerations(body, th, 0.0, sigma)
    return alpha, along - alpha


def test_how_wide_the_first_panel_of_slip_from_rest_is():
    """0.4 rad, unless the slip ends in too small a part of that: then 16 times the angle until then."""
    body = body_of(0.5, 0.75, mu=0.5, slope=0.125)

    def extent(th, vt, sigma=1):  # of the `body` at the time
        begin = begin_of(body, sigma, state_of(th, 0.0, vt))
        return panel_choice.first_extent(body, sigma, vt, begin)

    alpha, rate = at_rest(body, 1.0, 1)
    assert rate < -0.1 < 0.1 < alpha
    for vt in (1e-9, 1e-8):
        assert extent(1.0, vt) == pytest.approx(16.0 * 0.5 * alpha * (vt / rate) ** 2, rel=1e-13)
    left, back = at_rest(body, -1.0, -1)
    assert back > 0.1 > -0.1 > left
    assert extent(-1.0, -1e-9, -1) == pytest.approx(-16.0 * 0.5 * left * (1e-9 / back) ** 2, rel=1e-13)
    for share, wide in ((0.99, 16.0 * 0.4 * 0.99e-14), (1.01, 0.4)):
        vt = math.sqrt(share * 0.4e-14 / (0.5 * alpha)) * -rate
        assert extent(1.0, vt) == pytest.approx(wide, rel=1e-12)
    assert extent(1.0, 1.0) == 0.4
    assert extent(1.0, 1e-155) == 1e-300
    assert extent(1.0, 0.0) == 0.4
    begin = begin_of(body, 0, state_of(1.0, 0.0))
    assert panel_choice.first_extent(body, 0, 0.0, begin) == 0.4
    # slip that the slope drives does not end
    body = body_of(0.5, 0.75, mu=0.125, slope=0.75)
    assert at_rest(body, 1.0, 1)[1] > 0.05
    assert extent(1.0, 1e-9) == 0.4


# the panel


def chosen(body, sigma, state, level):
    """(panel, totals, level of the next one, how many were tried)."""
    scratch = new_scratch()
    panel, totals, after = panel_choice.choose_panel(body, sigma, state, *sines_of(state), level, scratch)
    return panel, totals, after, scratch.counts[PANELS]


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_first_panel_from_rest(side):
    """To the side to which the torque turns the hoop; beside the bottom it is halved until it is resolved."""
    body = HALF
    panel, totals, level, tried = chosen(body, 0, state_of(side * 1.0, 0.0), 7)
    assert (panel.kind, panel.direction, panel.extent, level, tried) == (LEAVE, side, 0.4, 2, 1)
    assert totals.tail <= RESOLVED
    for off in (0.1, 1e-3):
        panel, totals, level, tried = chosen(body, 0, state_of(side * (math.pi - off), 0.0), 7)
        assert (panel.kind, panel.direction, level) == (LEAVE, side, 2)
        assert panel.extent == 0.4 * 0.5 ** (tried - 1)
        assert 0.02 * off < panel.extent < off
        assert totals.tail <= RESOLVED


def test_slip_from_rest_that_has_no_answer_ends_its_search():
    """With κ p_σ < 0 no panel is narrow enough."""
    body = body_of(0.5, 0.01, mu=1.0)
    panel, totals, _, tried = chosen(body, 1, state_of(-1.0, 0.0, 1.0), 2)
    assert panel.kappa_p_sigma < 0.0
    assert totals.tail == math.inf
    assert panel.extent < 1e-300 < 4.0 * panel.extent
    assert tried == 1 + math.ceil(math.log2(0.4 / 1e-300))
    # a moving one is as narrow as the tables go, or as θ̇² lets it be where that is below 10⁻⁶
    for om, last in ((1.0, 96), (0.01, 96), (1e-4, 96 + 15), (1e-6, 96 + 42)):
        panel, totals, level, tried = chosen(body, 1, state_of(-1.0, om, 1.0), 0)
        assert (totals.tail, panel.level, level, tried) == (math.inf, last - 3, last, last // 3)


@pytest.mark.parametrize("om", [2.0, -3.0])
@pytest.mark.parametrize("sigma", [0, 1])
def test_the_next_panel_is_as_wide_as_is_resolved(om, sigma):
    """From the width of the last one, and the next is wider where this one is resolved by far."""
    body = body_of(0.5, 0.75, mu=0.25)
    state = state_of(2.0, om, sigma * 1.0)
    panel, totals, level, tried = chosen(body, sigma, state, 0)
    assert (panel.kind, panel.direction) == (LINEAR, math.copysign(1.0, om))
    assert totals.tail <= RESOLVED
    assert tried < 4
    widest = panel.level
    for begin in range(widest, widest + 8):
        panel, totals, level, tried = chosen(body, sigma, state, begin)
        assert (panel.level, tried) == (begin, 1)
        assert panel.extent == pytest.approx(width_of(begin), rel=1e-15)
        assert level == (begin - 1 if totals.tail < RESOLVED / 200.0 else begin)
    assert totals.tail < RESOLVED / 200.0
    still = body_of(0.0, gravity=0.0)
    assert chosen(still, 0, state_of(2.0, om), 0)[2:] == (0, 1)


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("sigma", [0, 1, -1])
@pytest.mark.parametrize(("om", "most"), [(1e-3, 13), (9e-4, 4), (1e-5, 4), (1e-12, 4), (1e-40, 4), (1e-140, 4)])
def test_a_hoop_that_begins_slowly_has_a_narrow_panel(om, most, sigma, way):
    """Of the scale θ̇²/θ̈ where it gathers speed, and up to the turning point where it loses it; found in a few tries.

    How many depends on no rounding: below θ̇ = 1e-3 the scale gives the first width, and rounding hides nothing there.
    """
    body = body_of(0.5, 0.75, mu=0.125)
    th = 1.0 * way
    alpha = 0.5 * math.sin(1.0) / (2.0 + math.cos(1.0)) if sigma == 0 else at_rest(body, th, sigma)[0] * way
    assert alpha > 0.1
    panel, totals, _, tried = chosen(body, sigma, state_of(th, way * om, sigma * 1.0), 2)
    scale = om**2 / alpha
    assert (panel.kind, panel.direction) == (LINEAR, way)
    assert totals.tail <= RESOLVED
    assert tried <= most
    assert 0.1 * scale < panel.extent < 10.0 * scale
    panel, totals, level, tried = chosen(body, sigma, state_of(th, -way * om, sigma * 1.0), 2)
    assert (panel.kind, panel.direction, level) == (ARRIVE, -way, 2)
    assert totals.tail <= RESOLVED
    assert panel.extent == pytest.approx(0.5 * scale, rel=1e-2 * om)
    assert tried <= 2


def test_a_panel_outlasts_the_motion():
    """Where it takes 64 times the time that is left, and 64 √(R/g); unless it is over."""
    _, totals = linear(HALF, 0, state_of(2.0, 1.0), 2, new_scratch())

    def outlasts(time, left):
        return panel_choice.exceeds_time_left(totals._replace(time=time), left)

    assert outlasts(64.1, 1.0)
    assert outlasts(64.1, 1e-9)
    assert outlasts(128.1, 2.0)
    for time, left in ((63.9, 1.0), (63.9, 1e-9), (127.9, 2.0), (1e9, 0.0), (1e9, -1.0)):
        assert not outlasts(time, left)


@pytest.mark.parametrize("sigma", [1, -1])
def test_slip_that_begins_beside_p_sigma_of_zero_has_a_narrow_panel(sigma):
    """Of the scale on which κ p_σ grows from what it is; narrower than the tables go."""
    body = body_of(mu=1.3)

    def firm(th):
        return begin_of(body, sigma, state_of(sigma * th, 2.0 * sigma, sigma)).kappa_p_sigma

    th = brentq(firm, -0.7, -0.1, xtol=1e-16)
    while not firm(th) > 0.0:
        th = math.nextafter(th, 0.0)
    assert firm(th) < 1e-15
    panel, totals, _, _ = chosen(body, sigma, state_of(sigma * th, 2.0 * sigma, sigma), 2)
    assert totals.tail <= RESOLVED
    assert panel.level > 96


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_panel_that_outlasts_the_motion_is_made_shorter(way):
    """It then takes about 4 times what is left, at least; without gravity θ̇ stays, and from rest a ring hardly rolls."""

    def shortened(body, state, panel, totals, left):
        return panel_choice.narrow_to_time(body, panel, totals, state, left, new_scratch())

    body = body_of(0.0, gravity=0.0)
    for om, left in ((1e-5, 1.0), (1e-9, 0.25), (1e-9, 30.0), (1e-150, 1e-2), (2.0, 30.0)):
        state = state_of(2.0, way * om)
        short, totals = shortened(body, state, *linear(body, 0, state, 0, new_scratch()), left)
        assert (short.kind, short.sigma, short.direction, short.ref, short.u) == (LINEAR, 0, way, 2.0, om**2)
        assert totals.tail <= RESOLVED
        assert totals.time == pytest.approx(short.extent / om, rel=1e-14)
        assert 4.0 * left <= totals.time < 4.0 * math.sqrt(2.0) * left if om < 1.0 else short.level == 0
    state = state_of(2.0, way * 1e-300)
    assert shortened(body, state, *linear(body, 0, state, 0, new_scratch()), 1e-8)[0].level == 2000  # the narrowest there is
    body, state = body_of(0.0, slope=way * 1e-8), state_of(0.0)
    panel = leaving_panel(0, way, 0.4, begin_of(body, 0, state))
    totals = panel_choice.solve(body, panel, new_scratch().work)
    assert totals.time == pytest.approx(math.sqrt(2.0 * 0.4 / (0.5 * 1e-8)), rel=1e-13)
    for left in (1.0, 0.25):
        short, after = shortened(body, state, panel, totals, left)
        assert (short.kind, short.direction, short.ref) == (LEAVE, way, 0.0)
        assert after.time == pytest.approx(4.0 * left, rel=1e-13)
