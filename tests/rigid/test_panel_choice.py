"""The next panel: how wide it is, in how few tries, and where a turning point is near."""

import math

import pytest

from hophoop.kernel.panels.anchor import NONE, rolling_anchor
from hophoop.kernel.panels.panel import ARRIVE, LEAVE, LINEAR, leaving_panel, linear_panel
from hophoop.kernel.records.layout import PANELS, new_scratch
from hophoop.kernel.rigid import panel_choice
from newton_euler import accelerations
from rigid.tools import body_of, sines_of, state_of

RESOLVED = 2e-13
SIDES = pytest.mark.parametrize("side", [1.0, -1.0])
pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # where a kernel gives up a panel


def anchor_of(body, sigma, state):
    return rolling_anchor(body, state, *sines_of(state)) if sigma == 0 else NONE


def begin_of(body, sigma, state):
    s, c = sines_of(state)
    return panel_choice.panel_start(body, sigma, anchor_of(body, sigma, state), state, s, c)


def chosen(body, sigma, state, level=2):
    """(panel, totals, level of the next one, how many were tried)."""
    scratch = new_scratch()
    panel, totals, after = panel_choice.choose_panel(
        body, sigma, anchor_of(body, sigma, state), state, *sines_of(state), level, scratch
    )
    return panel, totals, after, scratch.counts[PANELS]


def test_how_much_narrower_the_next_panel_is():
    """By √2 a level, which gains 2⁸; never by more than four levels at once, and by three where nothing is known."""
    narrower = panel_choice.narrower_level
    for size, more in ((1.0, 3), (math.nan, 3), (0.99, 4), (2.0**25, 3), (2.0**-9, 4)):
        assert narrower(7, size) == 7 + more
    for power, more in ((0.5, 1), (7.5, 1), (8.5, 2), (23.5, 3), (24.5, 4), (36.5, 4)):
        assert narrower(7, RESOLVED * 2.0**power) == 7 + more


def start_before(th, ahead):
    """The state at θ of rolling that turns after the angle `ahead`, by D θ̇² + 2 ε cos θ."""
    u = (math.cos(th + ahead) - math.cos(th)) / (2.0 + math.cos(th))
    return state_of(th, math.copysign(math.sqrt(u), ahead))


@SIDES
@pytest.mark.parametrize("resist", [0.0, 1e-12])
def test_a_turning_point_of_rolling_is_found(side, resist):
    """By a panel that reaches beyond it, or by wider ones: at most 8 times as wide as the first."""
    body = body_of(0.5, 0.75, rolling_resistance=resist)
    for off, ahead, level, found in (
        (0.25, 0.3, 0, 0.3),
        (0.25, 0.3, 9, 0.3),
        (0.25, 0.3, 10, 0.0),
        (0.25, 0.75, 3, 0.75),
        (0.25, 0.05, 14, 0.05),
        (math.pi - 0.6, 0.4, 0, 0.4),  # shortly before the top, which most of the angles asked are beyond
        (0.0, 3.0, 2, 0.0),
    ):
        scratch, state = new_scratch(), start_before(math.pi + side * off, side * ahead)
        panel = linear_panel(begin_of(body, 0, state), level)
        totals = panel_choice.solve(body, panel, scratch.work)
        assert panel_choice.turning_point_ahead(body, panel, totals, scratch) == pytest.approx(found, rel=1e-10), (ahead, level)


@pytest.mark.parametrize(
    ("om", "level", "next_level", "tries"),
    [(1.0, 93, 96, 32), (0.01, 93, 96, 32), (1e-4, 108, 111, 37), (1e-6, 135, 138, 46), (0.0, 0, 2, 997)],
)
def test_slip_that_has_no_answer_ends_its_search(om, level, next_level, tries):
    """With κ p_σ < 0 no panel is narrow enough: as narrow as the tables go, or as θ̇² lets it be where that is below 10⁻⁶."""
    panel, totals, after, tried = chosen(body_of(0.5, 0.01, mu=1.0), 1, state_of(-1.0, om, 1.0), 0)
    assert panel.kappa_p_sigma < 0.0
    assert (totals.tail, after, tried) == (math.inf, next_level, tries)
    assert panel.level == level if om else panel.extent < 1e-300


@SIDES
@pytest.mark.parametrize("sigma", [0, 1, -1])
@pytest.mark.parametrize(("om", "most"), [(1e-3, 13), (9e-4, 4), (1e-12, 4), (1e-140, 4)])
def test_a_hoop_that_begins_slowly_has_a_narrow_panel(om, most, sigma, side):
    """Of the scale θ̇²/θ̈ where it gathers speed, and up to the turning point where it loses it; found in a few tries.

    How many depends on no rounding: below θ̇ = 1e-3 the scale gives the first width, and rounding hides nothing there.
    """
    body = body_of(0.5, 0.75, mu=0.125)
    scale = om**2 / (side * accelerations(body, side, 0.0, sigma or "roll")[2])
    panel, totals, _, tried = chosen(body, sigma, state_of(side, side * om, sigma * 1.0))
    assert (panel.kind, panel.direction) == (LINEAR, side)
    assert totals.tail <= RESOLVED
    assert tried <= most
    assert 0.1 * scale < panel.extent < 10.0 * scale
    panel, totals, level, tried = chosen(body, sigma, state_of(side, -side * om, sigma * 1.0))
    assert (panel.kind, panel.direction, level) == (ARRIVE, -side, 2)
    assert totals.tail <= RESOLVED
    assert panel.extent == pytest.approx(0.5 * scale, rel=1e-2 * om)
    assert tried <= 2


def test_a_panel_that_outlasts_the_motion_is_made_shorter():
    """Where it takes 64 times the time that is left, and 64 √(R/g); it then takes about 4 times what is left, at least."""

    def begun(body, om):
        return new_scratch(), state_of(2.0, om), begin_of(body, 0, state_of(2.0, om))

    def shortened(panel, left):
        totals = panel_choice.solve(body, panel, scratch.work)
        return panel_choice.narrow_to_time(body, anchor_of(body, 0, state), panel, totals, state, left, scratch)

    body = body_of(0.0, gravity=0.0)
    for om, left, most in ((1e-5, 1.0, 5.7), (1e-9, 30.0, 5.7), (-1e-150, 1e-2, 5.7)):
        scratch, state, begin = begun(body, om)
        panel = linear_panel(begin, 0)
        totals = panel_choice.solve(body, panel, scratch.work)
        for time, outlasts in ((64.1, True), (63.9, False)):
            assert panel_choice.exceeds_time_left(totals._replace(time=time * max(left, 1.0)), left) is outlasts
        assert not panel_choice.exceeds_time_left(totals, 0.0)
        short, totals = shortened(panel, left)
        assert (short.kind, short.direction, short.u) == (LINEAR, panel.direction, om**2)
        assert 4.0 * left <= totals.time < most * left
    for om, left, level in ((1e-300, 1e-8, 2000), (2.0, 30.0, 0)):  # the narrowest and the widest there is
        scratch, state, begin = begun(body, om)
        assert shortened(linear_panel(begin, 0), left)[0].level == level
    body = body_of(0.0, slope=1e-8)
    scratch, state, begin = begun(body, 0.0)
    short, totals = shortened(leaving_panel(begin, 0.4), 0.25)
    assert (short.kind, short.direction, totals.time) == (LEAVE, 1.0, pytest.approx(1.0, rel=1e-13))
