"""Where a margin on a panel comes to zero, and which end of a panel is first: by polynomials whose zeros are known."""

import math
from typing import NamedTuple

import numpy as np
import pytest
from numpy.polynomial import chebyshev

from hophoop.kernel.numerics.collocation import FAR_FROM_ZERO, NOT_FOUND, margin_downcrossing
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.anchor import rolling_anchor
from hophoop.kernel.panels.panel import COSINE, SLIP, U, linear_panel
from hophoop.kernel.records.layout import new_scratch
from hophoop.kernel.rigid import panel_choice, panel_events
from hophoop.kernel.rigid.panel_events import CLOSE, record_tangency, touches_zero
from hophoop.kernel.rigid.phase import Ending
from hophoop.kernel.rigid.transitions import mode_is_in_doubt
from newton_euler import accelerations
from rigid.tools import body_of, limits, sines_of, state_of

SCRATCH = new_scratch()
BOTH_WAYS = pytest.mark.parametrize("way", [1.0, -1.0])
ONE = np.full(16, 1.0)
SLOWLY = -1e-4 * (1.0 + NODES) ** 3
LATER = 1e-4 * (1.0 + NODES) * (0.5 - NODES)


def fall(values, begins=False, floor=0.0):
    """(ξ, whether a tangency may be near)."""
    return margin_downcrossing(np.array(values), begins, floor, SCRATCH)


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_a_margin_falls_through_zero_or_touches_it(size):
    for zero in (-0.9, -0.2, 0.0, 0.7):
        assert fall(size * (zero - NODES) * (2.0 + NODES))[0] == pytest.approx(zero, abs=1e-14)
        for more, near in ((0.0, True), (0.1, False), (-0.1, False)):
            assert fall(size * ((NODES - zero) ** 2 + more), begins=True)[1] == near, (zero, more)


@pytest.mark.parametrize(
    ("values", "begins", "floor", "found"),
    [
        (0.5 + NODES, True, 0.0, NOT_FOUND),  # it rises, or stays
        (ONE, False, 0.0, NOT_FOUND),
        # a function that the panel resolves does not go far below its nodes: no zero is looked for
        (1.3 * 2.0 * FAR_FROM_ZERO + (1.0 + NODES), False, 0.0, NOT_FOUND),
        # below zero at the begin of a panel it has fallen there, also where no node shows it
        (-0.5 + NODES, False, 0.0, -1.0),
        (0.0 * NODES, False, 0.0, -1.0),
        (NODES + 1.0 - 1e-13, False, 0.0, -1.0),
        # unless the phase begins there, where a margin of zero is none yet
        (NODES + 1.0, True, 0.0, NOT_FOUND),
        # zero but for rounding counts as zero
        (-0.9e-3 * ONE, False, 1e-3, NOT_FOUND),
        (-1.1e-3 * ONE, False, 1e-3, -1.0),
        (-0.5e-3 * (1.2 + NODES), False, 1e-3, -1.0),
        # a fall that begins within rounding is at the begin; it ended the next panel instead
        (SLOWLY + 3e-17, False, 3e-14, -1.0),
        (1e-12 * SLOWLY + 3e-17, False, 3e-14, NOT_FOUND),  # a touch
        (SLOWLY + 1e-6, False, 3e-14, pytest.approx(-1.0 + 0.01 ** (1.0 / 3.0), abs=1e-12)),
        # the sign of the rounding at the begin decides nothing, but the side to which it leaves
        *(
            (sign * values + rounding, False, 3e-14, found)
            for rounding in (-2e-14, 0.0, 1e-17)
            for sign, values, found in (
                (1.0, 1.0 + NODES, NOT_FOUND),
                (-1.0, 1.0 + NODES, -1.0),
                (1.0, LATER, pytest.approx(0.5, abs=1e-9)),
                (-1.0, LATER, -1.0),
            )
        ),
    ],
)
def test_a_margin_beside_the_begin_of_a_panel(values, begins, floor, found):
    assert fall(values, begins, floor)[0] == found


@pytest.mark.parametrize(("eps", "kap"), [(0.75, 0.4375), (0.0, 1.0), (1.0, 0.0)])
def test_the_rounding_of_slip_without_friction(eps, kap):
    """From rest at the top to the bottom the weight gives 2 ε of energy, all to ½ κ θ̇²: the rim then slips at (1 − ε) θ̇."""
    lowest = 2.0 * (1.0 - eps) * math.sqrt(eps / kap) if kap else 0.0
    for gravity, fallen in ((9.81, 2.0 * math.sqrt(eps) + lowest), (0.0, 0.0)):
        found = panel_events.tangency_rounding(body_of(eps, kap, mu=0.0, gravity=gravity), state_of(0.0, -3.0, -2.0))
        assert found == pytest.approx(1e-14 * (5.0 + fallen), rel=1e-14)


class Panel(NamedTuple):
    """What the search for events asks of a panel."""

    sigma: int = 1
    vt: float = 1.0
    u: float = 1.0
    direction: float = 1.0


def end_of_slip(slip, load, *, mu=0.5, sigma=1, begins=False, vanishing=0):
    """(ξ, ending, whether a doubt is recorded) for v_t and N/κ at the nodes."""
    body, scratch = body_of(0.5, 0.75, mu=mu), new_scratch()
    scratch.work[COSINE] = -1.0
    scratch.work[U] = (load - body.gn) / body.eps
    scratch.work[SLIP] = sigma * slip
    state = state_of(math.pi, 1.0, float(sigma), t=3.0)
    found = panel_events.end_of_slip(body, Panel(sigma), state, begins, vanishing, scratch)
    return *found, scratch.doubt.tolist() == [3.0]


STOP, LIFT = Ending.SLIP_END, Ending.LIFT_OFF


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("mu", [0.5, 0.0])
def test_slip_ends_or_the_rim_lifts_whichever_is_first(sigma, mu):
    """Lift-off where both are at once, whatever the rounding, which is doubtful; v_t or N that touches zero is, too."""
    soon, late, touching = 0.25 - NODES, 0.75 - NODES, (NODES - 0.1) ** 2
    for slip, load, xi, what, doubt in (
        (soon, ONE, 0.25, STOP, False),
        (ONE, soon, 0.25, LIFT, False),
        (soon, late, 0.25, STOP, False),
        (late, soon, 0.25, LIFT, False),
        (soon - 1e-14, soon, 0.25, LIFT, True),
        (soon + 1e-14, soon, 0.25, LIFT, True),
        (ONE, ONE, NOT_FOUND, LIFT, False),
        (ONE, touching + 1e-14, NOT_FOUND, LIFT, True),
        (touching + 1e-14, ONE, NOT_FOUND, LIFT, True),
    ):
        found = end_of_slip(slip, load, mu=mu, sigma=sigma)
        assert found == (pytest.approx(xi, abs=1e-13), what, doubt and mu > 0.0), (xi, what)
    assert not end_of_slip(touching, ONE, sigma=sigma, begins=True)[2]  # v_t of slip that begins is no decision


LOST = -(1.0 + NODES)  # slip that has ended before the first node
BEGUN = {"begins": True}
FROM_REST = {"begins": True, "vanishing": 1}
SMOOTH = {"mu": 0.0}
STEEP = 1e4 * (1.0 + NODES) - 1.0  # however much above zero at the nodes


@pytest.mark.parametrize(
    ("slip", "load", "given", "found"),
    [
        # where the panel's series begins a rounding above zero it ends there
        (LOST, ONE, BEGUN, -1.0),
        (LOST, ONE, {}, -1.0),
        (-LOST, ONE, BEGUN, NOT_FOUND),
        # begun at no speed: with friction the mode says the direction, without it rounding of θ may be wrong
        (LOST, ONE, FROM_REST, NOT_FOUND),
        (0.1 * LOST, ONE, FROM_REST | SMOOTH, -1.0),
        (-LOST * NODES, ONE, FROM_REST | SMOOTH, NOT_FOUND),
        # zeros of v_t at the begin are taken out, so that one beside them is found
        (LOST * (LOST + 1e-9), ONE, {"begins": True, "vanishing": 2}, NOT_FOUND),
        (-LOST * (LOST + 1e-9), ONE, FROM_REST, -1.0 + 1e-9),
        (LOST**2 * (LOST + 1e-3), ONE, {"begins": True, "vanishing": 2}, -1.0 + 1e-3),
        # below zero at the first node: over at once, as the square of v_t underflows if the panel is no narrower
        (-0.999 - NODES, ONE, BEGUN, -1.0),
        (0.25 - NODES, ONE, BEGUN, 0.25),
        ((NODES + 0.95) * (0.5 - NODES), ONE, BEGUN, -1.0),
        (ONE, STEEP, {}, -1.0),
        (STEEP, ONE, {}, -1.0),
        # slip without friction is zero within its rounding
        (-1e-15 * ONE, ONE, SMOOTH, NOT_FOUND),
        (-1e-13 * ONE, ONE, SMOOTH, -1.0),
        (-1e-15 * ONE, ONE, {}, -1.0),
    ],
)
def test_slip_beside_its_begin(slip, load, given, found):
    xi, ending, _ = end_of_slip(slip, load, **given)
    assert xi == pytest.approx(found, abs=1e-13)
    assert ending == (STOP if load is ONE and found < 1.0 else LIFT)


def rolled(body, th, om, level=0):
    """(panel, totals, scratch) of a solved panel of rolling."""
    state, scratch = state_of(th, om), new_scratch()
    begin = panel_choice.panel_start(body, 0, rolling_anchor(body, state, *sines_of(state)), state, *sines_of(state))
    panel = linear_panel(begin, level)
    return panel, panel_choice.solve(body, panel, scratch.work), scratch


@pytest.mark.parametrize("om", [0.0, 100.0])
def test_the_rounding_of_the_friction_that_rolling_needs(om):
    """Of a ring on a slope, which needs the same at every speed: lost in the forces of a fast one, where it lacks a little."""
    slope = 0.75
    for part, found in ((1e-14, NOT_FOUND if om else -1.0), (1e-10, -1.0), (-1e-14, NOT_FOUND)):
        body = body_of(0.0, mu=0.5 * math.tan(slope) * (1.0 - part), slope=slope)
        panel, _, scratch = rolled(body, 0.5, max(om, 1.0), 2)
        scratch.work[U] = om**2
        assert panel_events.end_of_rolling(body, panel._replace(u=om**2), state_of(0.5, 1.0), False, scratch)[0] == found


@BOTH_WAYS
def test_a_panel_ends_at_the_angle_or_the_time_that_is_the_limit(way):
    """Of a ring that rolls at the speed of 1 on a panel of 0.9 rad: whichever is first; at once the contact, angle, time."""

    def earliest(body, span, t_end, gone=0.0):
        panel, totals, scratch = rolled(body, way * 0.5, way)
        state = state_of(way * 0.5, way)
        given = limits(state._replace(th=state.th - way * gone), t_end, span)
        return panel_events.earliest_event(body, panel, totals, state, False, 0, given, scratch)

    on, angle, time = Ending.CONTINUES, Ending.ANGLE_LIMIT, Ending.TIME_LIMIT
    for span, t_end, xi, what in (
        (0.9, 9.0, 1.0, angle),
        (0.901, 0.901, 1.0, on),
        (1e-9, 9.0, 2e-9 / 0.9 - 1.0, angle),
        (math.nan, 0.0, -1.0, time),
        (0.225, 0.9, -0.5, angle),
        (0.9, 0.225, -0.5, time),
    ):
        assert earliest(body_of(0.0), span, t_end) == (pytest.approx(xi, abs=1e-14), what), (span, t_end)
    for span in (0.25, 0.1):
        assert earliest(body_of(0.0), span, 0.0, 0.25) == (-1.0, angle)
    assert earliest(body_of(0.0, mu=0.125, slope=0.75), 0.25, 0.0, 0.25) == (-1.0, Ending.CONE_BACKWARD)


# doubts: margins that vanish by the physics, and just beside


def in_doubt(body, angle=0.0, om=0.0, vt=0.0):
    return mode_is_in_doubt(body, state_of(angle, om, vt))


@pytest.mark.parametrize(("part", "doubtful"), [(-1.1, False), (-0.9, True), (0.9, True), (1.1, False)])
def test_how_near_to_zero_is_in_doubt(part, doubtful):
    """Beside g_n + ε θ̇² in slip; beside g_n + |g_t| + θ̇² the margin to the cone, N and f_n in rolling."""
    body = body_of(slope=0.25)
    om = math.sqrt(body.gn * (1.0 + part * CLOSE * 2.0) / body.eps)
    assert in_doubt(body, om=om, vt=1.0) is in_doubt(body, om=om, vt=-1.0) is doubtful
    slope = 0.75
    least = 0.5 * math.tan(slope)
    margin = 0.5 * math.sin(slope) / math.hypot(1.0, least)  # times what μ has too much, as a part of it
    scale = math.cos(slope) + math.sin(slope)
    assert in_doubt(body_of(0.0, 1.0, mu=least * (1.0 + part * CLOSE * scale / margin), slope=slope)) is doubtful
    body = body_of(0.5, 0.75)
    # N of rolling at θ = 1 is a linear function of θ̇²
    still, spun = accelerations(body, 1.0, 0.0, "roll")[4], accelerations(body, 1.0, 1.0, "roll")[4]
    zero = still / (still - spun)
    assert in_doubt(body, 1.0, om=math.sqrt((still - part * CLOSE * (1.0 + zero)) / (still - spun))) is doubtful
    # rolling beyond the cone, where N would pull, and ε θ̇² cos θ = g but for rounding
    free = 1.0 / (0.5 * math.cos(1.0))
    for side in (1.0, -1.0):
        assert in_doubt(body, side * 1.0, om=math.sqrt(free * (1.0 + part * CLOSE * (1.0 + free)))) is doubtful


def test_where_there_is_no_margin():
    """Where N holds the hoop f_n does not matter; nor without friction, without mass, and where nothing moves."""
    for side in (1.0, -1.0):
        steep = body_of(0.5, 0.75, mu=5.0, slope=-1.2 * side)
        assert not in_doubt(steep, side * 1.0, om=math.sqrt(steep.gn / (0.5 * math.cos(1.0))))
    assert not in_doubt(body_of(0.5, 0.75, mu=0.0), om=math.sqrt(2.0))
    assert not in_doubt(body_of(1.0), om=1.0)
    assert not in_doubt(body_of(0.5, 0.75, gravity=0.0))
    assert not in_doubt(body_of(0.0, 1.0, mu=math.inf, slope=0.75))


def grazes(function, scale=1.0):
    SCRATCH.values[:] = 1e3  # what was there before does not count
    return touches_zero(function(NODES), scale, SCRATCH)


@pytest.mark.parametrize("size", [1e-6, 1e6])
def test_a_smallest_value_of_zero_is_a_graze(size):
    for place in (-0.9, 0.0, 0.95):
        for part, touches in ((0.5, True), (20.0, False), (-20.0, False)):
            assert grazes(lambda xi, at=place, more=part: size * ((xi - at) ** 2 + more * CLOSE), size) == touches
        assert not grazes(lambda xi, at=place: size * (0.5 * CLOSE - (xi - at) ** 2), size)  # a largest value
    assert not grazes(np.exp)  # no smallest value inside


@pytest.mark.parametrize("which", [0, 1, 2, 3])
def test_each_of_four_smallest_values_is_looked_at(which):
    """1 + T₈, which is zero four times, lifted but for one of them."""
    zero = math.cos(math.pi * (7.0, 5.0, 3.0, 1.0)[which] / 8.0)

    def waves(xi):
        return 1.0 + chebyshev.chebval(xi, [0.0] * 8 + [1.0]) + 1e-3 * (xi - zero) ** 2

    assert grazes(waves)
    assert not grazes(lambda xi: waves(xi) + 1e-5)


@pytest.mark.parametrize(("part", "doubt"), [(0.9, [3.0]), (1.1, [math.nan])])
def test_either_margin_counts_relative_to_its_own_scale(part, doubt):
    far, near = (1.0 + NODES**2, 1e3), (NODES**2 + part * CLOSE * 7.0, 7.0)
    for margins in ((*far, *near), (*near, *far)):
        scratch = new_scratch()
        record_tangency(*margins, 3.0, scratch)
        assert scratch.doubt.tolist() == pytest.approx(doubt, nan_ok=True)


@pytest.mark.parametrize("sigma", [0, 1, -1])
def test_tangencies_are_relative_to_forces_and_speeds(sigma, monkeypatch):
    """In rolling to g_n + |g_t| + θ̇² at the panel's start, in slip to g_n + θ̇² for N and |v_t| + |θ̇| for v_t."""
    body, state, scratch, found = body_of(0.5, 0.75, slope=0.5), state_of(0.0, -0.5, 3.0, t=2.0), new_scratch(), []
    monkeypatch.setattr(panel_events, "record_tangency", lambda *given: found.append((given[1], given[3], given[4])))
    monkeypatch.setattr(panel_events, "margin_downcrossing", lambda *given: (NOT_FOUND, True))
    panel = Panel(sigma, 3.0, 0.25)
    if sigma == 0:
        panel_events.end_of_rolling(body, panel, state, False, scratch)
    else:
        panel_events.end_of_slip(body, panel, state, False, 0, scratch)
    weight = body.gn + 0.25
    assert found == [(weight + body.gt, weight + body.gt, 2.0) if sigma == 0 else (weight, 3.5, 2.0)]
