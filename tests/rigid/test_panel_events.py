"""Where a margin on a panel comes to zero, and which end of a panel is first: by polynomials whose zeros are known."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest
from numpy.polynomial import Polynomial, chebyshev
from scipy.optimize import minimize_scalar

from hophoop.kernel.numerics.collocation import NOT_FOUND
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.panel import COSINE, RATE, SLIP, U, linear_panel
from hophoop.kernel.records.layout import new_scratch
from hophoop.kernel.records.writing import record_doubt
from hophoop.kernel.rigid import panel_choice, panel_events
from hophoop.kernel.rigid.panel_events import CLOSE, record_tangency, touches_zero
from hophoop.kernel.rigid.phase import Ending
from hophoop.kernel.rigid.transitions import mode_is_in_doubt
from newton_euler import accelerations
from rigid.tools import body_of, limits, sines_of, state_of

SCRATCH = new_scratch()
ONE = np.full(16, 1.0)
BOTH_WAYS = pytest.mark.parametrize("way", [1.0, -1.0])


def fall(values, begins=False, floor=0.0):
    """(ξ, whether a tangency may be near)."""
    return panel_events.margin_downcrossing(np.array(values), begins, floor, SCRATCH)


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_a_margin_falls_through_zero_or_touches_it(size):
    for zero in (-0.9, -0.2, 0.0, 0.7):
        assert fall(size * (zero - NODES) * (2.0 + NODES))[0] == pytest.approx(zero, abs=1e-14)
        parabola = (NODES - zero) ** 2
        for more, near in ((0.0, True), (0.1, False), (-0.1, False)):
            assert fall(size * (parabola + more), begins=True)[1] == near, (zero, more)


@pytest.mark.parametrize(
    ("values", "begins", "found"),
    [
        (0.5 + NODES, True, NOT_FOUND),  # it rises, or stays
        (1.5 + NODES, False, NOT_FOUND),
        (ONE, False, NOT_FOUND),
        # a function that the panel resolves does not go far below its nodes: no zero is looked for
        (1.3 * 2.0 * panel_events.FAR_FROM_ZERO + (1.0 + NODES), False, NOT_FOUND),
        # below zero at the begin of a panel it has fallen there
        (-0.5 - 0.1 * NODES, False, -1.0),
        (-0.5 + NODES, False, -1.0),
        (0.0 * NODES, False, -1.0),
        (NODES + 1.0 - 1e-13, False, -1.0),  # also where no node shows it
        # unless the phase begins there, where a margin of zero is none yet
        (NODES + 1.0, True, NOT_FOUND),
    ],
)
def test_a_margin_that_does_not_fall_or_has_fallen(values, begins, found):
    assert fall(values, begins)[0] == found


@pytest.mark.parametrize("floor", [1e-16, 1e-3])
def test_a_margin_that_is_zero_but_for_rounding_counts_as_zero(floor):
    below = np.full(16, -0.1 * floor)
    below[-1] = -1.1 * floor
    for values, found in ((-0.9 * floor * ONE, NOT_FOUND), (-1.1 * floor * ONE, -1.0), (below, -1.0)):
        assert fall(values, floor=floor)[0] == found


@pytest.mark.parametrize("power", [2, 3, 4, 5])
def test_a_margin_that_begins_with_rounding_and_falls_has_fallen_at_its_begin(power):
    """Its fall was passed over where the first piece of it stayed within the rounding, and ended the next panel instead."""
    falls = -1e-4 * (1.0 + NODES) ** power
    assert fall(falls + 3e-17, floor=3e-14)[0] == -1.0
    assert fall(1e-12 * falls + 3e-17, floor=3e-14)[0] == NOT_FOUND  # a touch
    assert fall(falls + 1e-6, floor=3e-14)[0] == pytest.approx(-1.0 + 0.01 ** (1.0 / power), abs=1e-12)


def test_the_sign_of_a_margins_rounding_at_the_begin_decides_nothing():
    """Whichever side it leaves to is what counts: one that rises first falls later, or not at all."""
    rises = 1e-4 * (1.0 + NODES)
    later = rises * (0.5 - NODES)
    for rounding in (-1e-17, 0.0, 1e-17, 2e-14, -2e-14):
        for floor in (3e-14, 1e-12):
            for values, found in ((rises, NOT_FOUND), (-rises, -1.0), (later, 0.5), (-later, -1.0), (0.0 * NODES, NOT_FOUND)):
                assert fall(rounding + values, floor=floor)[0] == pytest.approx(found, abs=1e-9)


@pytest.mark.parametrize(("eps", "kap"), [(0.75, 0.4375), (0.9, 0.02), (0.0, 1.0), (1.0, 0.0)])
def test_the_rounding_of_slip_without_friction(eps, kap):
    """From rest at the top to the bottom the weight gives 2 ε of energy, all to ½ κ θ̇²: the rim then slips at (1 − ε) θ̇."""
    lowest = (1.0 - eps) * math.sqrt(2.0 * 2.0 * eps / kap) if kap else 0.0
    for om, vt in ((0.0, 0.0), (-3.0, -2.0)):
        for gravity, fallen in ((9.81, 2.0 * math.sqrt(eps) + lowest), (0.0, 0.0)):
            body = body_of(eps, kap, mu=0.0, gravity=gravity)
            found = panel_events.tangency_rounding(body, state_of(0.0, om, vt))
            assert found == pytest.approx(1e-14 * (abs(om) + abs(vt) + fallen), rel=1e-14, abs=0.0)


class Panel(NamedTuple):
    """What the search for events asks of a panel."""

    sigma: int = 1
    vt: float = 1.0
    u: float = 1.0
    direction: float = 1.0


def end_of_slip(slip, load, *, mu=0.5, sigma=1, begins=False, vanishing=0, vt=1.0):
    """(ξ, ending, whether tangencies are looked for, whether a doubt is recorded) for v_t and N/κ at the nodes."""
    body, scratch = body_of(0.5, 0.75, mu=mu), new_scratch()
    scratch.work[COSINE] = -1.0
    scratch.work[U] = (load - body.gn) / body.eps
    scratch.work[SLIP] = sigma * slip
    state = state_of(math.pi, 1.0, sigma * vt, t=3.0)
    looked = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(panel_events, "record_tangency", lambda *given: looked.append(given))
        xi, ending = panel_events.end_of_slip(body, Panel(sigma), state, begins, vanishing, scratch)
    noted = scratch.doubt.tolist() == [3.0]
    assert noted or np.isnan(scratch.doubt).all()
    return xi, ending, bool(looked), noted


STOP, LIFT = Ending.SLIP_END, Ending.LIFT_OFF


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("mu", [0.5, 0.0])
def test_slip_ends_or_the_rim_lifts_whichever_is_first(sigma, mu):
    soon, late = 0.25 - NODES, 0.75 - NODES
    for slip, load, what in ((soon, ONE, STOP), (ONE, soon, LIFT), (soon, late, STOP), (late, soon, LIFT)):
        xi, ending, _, noted = end_of_slip(slip, load, mu=mu, sigma=sigma)
        assert (xi, ending, noted) == (pytest.approx(0.25, abs=1e-14), what, False)
    for off in (-1e-14, -1e-15, 0.0, 1e-15, 1e-14):  # lift-off is first, whatever the rounding, and doubtful
        xi, what, _, noted = end_of_slip(soon - off, soon, mu=mu, sigma=sigma)
        assert (xi, what, noted) == (pytest.approx(0.25, abs=1e-14), LIFT, mu > 0.0)
    assert end_of_slip(ONE, ONE, mu=mu, sigma=sigma)[0] == NOT_FOUND


LOST = -(1.0 + NODES)  # slip that has ended before the first node
BEGUN = {"begins": True}
FROM_REST = {"begins": True, "vanishing": 1}
WITHOUT_FRICTION = {"mu": 0.0}
STEEP = 1e4 * (1.0 + NODES) - 1.0  # however much above zero at the nodes


@pytest.mark.parametrize(
    ("slip", "load", "given", "found"),
    [
        # where the panel's series begins a rounding above zero it ends there
        (LOST, ONE, BEGUN, (-1.0, STOP)),
        (LOST, ONE, {}, (-1.0, STOP)),
        (-LOST, ONE, BEGUN, None),
        # begun at no speed: with friction the mode says the direction, without it rounding of θ may be wrong
        (LOST, ONE, FROM_REST, None),
        (LOST, ONE, FROM_REST | WITHOUT_FRICTION, (-1.0, STOP)),
        (0.1 * LOST, ONE, FROM_REST | WITHOUT_FRICTION, (-1.0, STOP)),
        (-LOST * NODES, ONE, FROM_REST | WITHOUT_FRICTION, None),
        # an end before the first node is believed, unless the speed is lost in what the panel makes of it
        (-0.999 - NODES, ONE, BEGUN, (-0.999, STOP)),
        (-0.999 - NODES, ONE, BEGUN | {"vt": 1e-150}, (-1.0, STOP)),
        (-0.96 - NODES, ONE, BEGUN, (-0.96, STOP)),
        (0.25 - NODES, ONE, BEGUN, (0.25, STOP)),
        # below zero at the first node: what comes later is not the end of that slip
        ((NODES + 0.95) * (0.5 - NODES), ONE, BEGUN, (-1.0, STOP)),
        ((NODES + 0.98) * (-0.96 - NODES), ONE, BEGUN, (-1.0, STOP)),
        (ONE, STEEP, {}, (-1.0, LIFT)),
        (STEEP, ONE, {}, (-1.0, STOP)),
        # slip without friction is zero within its rounding
        (-1e-15 * ONE, ONE, WITHOUT_FRICTION, None),
        (-1e-13 * ONE, ONE, WITHOUT_FRICTION, (-1.0, STOP)),
        (-1e-15 * ONE, ONE, {}, (-1.0, STOP)),
    ],
)
def test_slip_beside_its_begin(slip, load, given, found):
    xi, ending, _, _ = end_of_slip(slip, load, **given)
    if found is None:
        assert xi == NOT_FOUND
    else:
        assert (xi, ending) == (pytest.approx(found[0], abs=1e-13), found[1])


@pytest.mark.parametrize("vanishing", [1, 2])
@pytest.mark.parametrize("mu", [0.5, 0.0])
def test_slip_that_begins_with_no_speed_may_end_at_once(vanishing, mu):
    """Zeros of v_t at the begin are taken out, so that one beside them is found."""
    start = (1.0 + NODES) ** vanishing
    for end in (1e-9, 1e-3, 1.25):
        xi, what, _, _ = end_of_slip(start * (end - (1.0 + NODES)), ONE, begins=True, vanishing=vanishing, mu=mu)
        assert (xi, what) == (pytest.approx(end - 1.0, abs=1e-14), STOP)
    assert end_of_slip(0.3 * start, ONE, begins=True, vanishing=vanishing, mu=mu)[0] == NOT_FOUND


@pytest.mark.parametrize("begins", [True, False])
def test_slip_or_load_that_touches_zero_is_doubtful(begins):
    """With friction; v_t of slip that begins is no decision."""
    touching = (NODES - 0.1) ** 2 + 1e-4
    for slip, load, doubtful in ((ONE, ONE, False), (ONE, touching, True), (touching, ONE, not begins)):
        assert end_of_slip(slip, load, begins=begins)[2] == doubtful
        assert not end_of_slip(slip, load, begins=begins, mu=0.0)[2]


# rolling


def needed(panel, xi, u, body, rho=0.0):
    """(F, N) that rolling needs at a place of a panel."""
    return accelerations(body, panel.ref + panel.direction * 0.5 * panel.extent * (1.0 + xi), math.sqrt(u), "roll", rho)[3:]


def rolled(body, th, om, level=2):
    """(panel, totals, scratch) of a solved panel of rolling."""
    state, scratch = state_of(th, om), new_scratch()
    begin = panel_choice.panel_start(body, 0, state, *sines_of(state), scratch)
    panel = linear_panel(0, level, math.copysign(1.0, om), begin)
    return panel, panel_choice.solve(body, panel, scratch.work), scratch


def end_of_rolling(body, panel, scratch, begins=False):
    """(ξ, ending)."""
    return panel_events.end_of_rolling(body, panel, state_of(panel.ref, 1.0), begins, scratch)


@BOTH_WAYS
@pytest.mark.parametrize("resist", [0.0, 0.0625])
@pytest.mark.parametrize(("th", "om"), [(0.25, 0.5), (4.0, 2.0), (0.25, 1.25)])
def test_rolling_ends_where_it_needs_all_friction(way, resist, th, om):
    """Newton's equations say how much that is; to the other side in the mirrored motion."""
    body = body_of(0.5, 0.75, rolling_resistance=resist)
    panel, _, scratch = rolled(body, way * th, way * om)
    u = Polynomial.fit(NODES, scratch.work[U], 15)

    def share(xi):
        friction, normal = needed(panel, xi, u(xi), body, way * resist)
        return friction / normal

    first, place, last = (abs(share(xi)) for xi in (NODES[0], 0.375, NODES[-1]))
    side = Ending.CONE_FORWARD if share(0.375) > 0.0 else Ending.CONE_BACKWARD
    for mu, begins, xi in (
        (place, False, pytest.approx(0.375, abs=1e-12)),
        (2.0 * last, False, NOT_FOUND),
        (0.5 * first, False, -1.0),  # below what is needed from the begin of the panel on
        (0.5 * first, True, NOT_FOUND),
    ):
        found = end_of_rolling(body._replace(mu_s=mu), panel, scratch, begins)
        assert found[0] == xi
        assert found[0] == NOT_FOUND or found[1] == side


@BOTH_WAYS
def test_without_a_limit_of_friction_rolling_ends_ahead(way):
    """Both sides of the cone are N = 0 then; the mirrored motion comes to the mirrored side."""
    body = body_of(0.9, 0.2, mu=math.inf)
    panel, _, scratch = rolled(body, way * 0.5, way * 0.75, level=0)
    xi, what = end_of_rolling(body, panel, scratch)
    assert -1.0 < xi < 1.0
    assert what == (Ending.CONE_FORWARD if way > 0.0 else Ending.CONE_BACKWARD)


@pytest.mark.parametrize("om", [0.0, 100.0])
def test_the_rounding_of_the_friction_that_rolling_needs(om):
    """Of a ring on a slope, which needs the same at every speed: lost in the forces of a fast one, where it lacks a little."""
    slope = 0.75
    for part, found in ((1e-14, NOT_FOUND if om else -1.0), (1e-10, -1.0), (-1e-14, NOT_FOUND)):
        body = body_of(0.0, mu=0.5 * math.tan(slope) * (1.0 - part), slope=slope)
        panel, _, scratch = rolled(body, 0.5, max(om, 1.0))
        scratch.work[U] = om**2
        assert end_of_rolling(body, panel._replace(u=om**2), scratch)[0] == found


# what ends a panel first


def earliest(body, panel, totals, state, scratch, *, t_end=1e3, span=math.nan, begin=None):
    given = limits(begin or state, t_end, span)
    return panel_events.earliest_event(body, panel, totals, state, False, 0, given, scratch)


def test_where_the_time_is_over():
    scratch = new_scratch()
    scratch.work[RATE] = 0.5  # the panel takes 1
    for left, xi in ((0.25, -0.5), (0.5, 0.0), (1.0, 1.0), (1.5, 1.0), (0.0, -1.0), (-0.5, -1.0), (-1.0, -1.0)):
        assert panel_events.end_of_time(left, scratch) == pytest.approx(xi, abs=1e-14)


@BOTH_WAYS
def test_a_panel_ends_at_the_angle_or_the_time_that_is_the_limit(way):
    """Of a ring that rolls at the speed of 1 on a panel of 0.9 rad: whichever is first; at once the contact, angle, time."""
    body, state = body_of(0.0), state_of(way * 0.5, way)
    rolling = rolled(body, way * 0.5, way, level=0)
    assert rolling[1].time == pytest.approx(0.9, rel=1e-15)
    on, angle, time = Ending.CONTINUES, Ending.ANGLE_LIMIT, Ending.TIME_LIMIT
    gone = {"begin": state._replace(th=state.th - way * 0.25)}
    for given, xi, what in (
        ({"span": 0.225}, -0.5, angle),
        ({"span": 0.9}, 1.0, angle),
        ({"span": 0.901}, 1.0, on),
        ({"span": 1e-9}, 2e-9 / 0.9 - 1.0, angle),
        ({"span": 0.25} | gone, -1.0, angle),
        ({"span": 0.1} | gone, -1.0, angle),
        ({"t_end": 0.225}, -0.5, time),
        ({"t_end": rolling[1].time}, 1.0, time),
        ({"t_end": 0.901}, 1.0, on),
        ({"t_end": 0.0}, -1.0, time),
        ({"t_end": 0.9, "span": 0.225}, -0.5, angle),
        ({"t_end": 0.225, "span": 0.9}, -0.5, time),
        ({"t_end": 0.0, "span": 0.25} | gone, -1.0, angle),
    ):
        found = earliest(body, *rolling[:2], state, rolling[2], **given)
        assert found == (pytest.approx(xi, abs=1e-14), what), given
    steep = body_of(0.0, mu=0.125, slope=0.75)
    panel, totals, scratch = rolled(steep, way * 0.5, way, level=0)
    assert earliest(steep, panel, totals, state, scratch, t_end=0.0, span=0.25, **gone) == (-1.0, Ending.CONE_BACKWARD)


# doubts: margins that vanish by the physics, and just beside


@BOTH_WAYS
def test_a_doubt_is_noted_with_the_time_of_the_panel(way):
    """Where the friction that rolling needs just comes to its limit, as far as doubles can tell."""
    body, state = body_of(0.5, 0.75), state_of(way * (math.pi - 1.5), way * 1.0, t=3.0)
    panel, totals, scratch = rolled(body, state.th, state.om, level=0)
    u = Polynomial.fit(NODES, scratch.work[U], 15)

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


def in_doubt(body, angle=0.0, om=0.0, vt=0.0):
    return mode_is_in_doubt(body, state_of(angle, om, vt))


PARTS = [(-1.1, False), (-0.9, True), (0.9, True), (1.1, False)]


@pytest.mark.parametrize(("part", "doubtful"), PARTS)
def test_how_near_to_zero_is_in_doubt(part, doubtful):
    """Beside g_n + ε θ̇² in slip; beside g_n + |g_t| + θ̇² the margin to the cone, N and f_n in rolling."""
    for slip in (1.0, -1.0):
        body = body_of(0.75, 0.4375, slope=0.25)
        free = (body.gn + part * CLOSE * 2.0 * body.gn) / body.eps
        assert in_doubt(body, om=math.sqrt(free), vt=slip) is doubtful
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
        om = math.sqrt(steep.gn / (0.5 * math.cos(1.0)))
        friction, normal = accelerations(steep, side * 1.0, om, "roll")[3:]
        assert 0.0 < abs(friction) < 5.0 * normal
        assert not in_doubt(steep, side * 1.0, om=om)
    assert not in_doubt(body_of(0.5, 0.75, mu=0.0), om=math.sqrt(2.0))
    assert not in_doubt(body_of(1.0), om=1.0)
    assert not in_doubt(body_of(0.5, 0.75, gravity=0.0))
    assert not in_doubt(body_of(0.0, 1.0, mu=math.inf, slope=0.75))


def grazes(function, scale=1.0):
    SCRATCH.values[:] = 1e3  # what was there before does not count
    return touches_zero(function(NODES), scale, SCRATCH)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_a_smallest_value_of_zero_is_a_graze(size):
    for place in (-0.9, -0.3, 0.0, 0.55, 0.95):
        for part, touches in ((0.5, True), (20.0, False), (-20.0, False)):
            assert grazes(lambda xi, at=place, more=part: size * ((xi - at) ** 2 + more * CLOSE), size) == touches
        assert not grazes(lambda xi, at=place: size * (0.5 * CLOSE - (xi - at) ** 2), size)  # a largest value
    assert not grazes(lambda xi: -1.0 * xi)  # no smallest value inside
    assert not grazes(np.exp)


@pytest.mark.parametrize("which", [0, 1, 2, 3])
def test_each_of_four_smallest_values_is_looked_at(which):
    """1 + T₈, which is zero four times, lifted but for one of them."""
    zeros = np.cos(np.pi * np.array([7.0, 5.0, 3.0, 1.0]) / 8.0)

    def waves(xi):
        wave = 1.0 + chebyshev.chebval(xi, [0.0] * 8 + [1.0])
        return wave + 1e-3 * (xi - zeros[which]) ** 2

    assert grazes(waves)
    assert not grazes(lambda xi: waves(xi) + 1e-5)


@pytest.mark.parametrize("which", [0, 1])
def test_either_margin_counts_relative_to_its_own_scale(which):
    """The first doubt stays."""
    for part, doubtful in ((0.9, True), (1.1, False)):
        scratch = new_scratch()
        margins, scales = [1.0 + NODES**2, 1.0 + NODES**2], [1e3, 1e3]
        scales[which] = 7.0
        margins[which] = NODES**2 + part * CLOSE * 7.0
        record_tangency(margins[0], scales[0], margins[1], scales[1], 3.0, scratch)
        assert scratch.doubt.tolist() == [3.0] if doubtful else np.isnan(scratch.doubt).all()
        record_doubt(scratch.doubt, 5.0)
        assert scratch.doubt.tolist() == [3.0 if doubtful else 5.0]


@pytest.mark.parametrize("sigma", [0, 1, -1])
def test_tangencies_are_relative_to_forces_and_speeds(sigma, monkeypatch):
    """In rolling to g_n + |g_t| + θ̇² at the panel's start, in slip to g_n + θ̇² for N and |v_t| + |θ̇| for v_t."""
    body, state, scratch, found = body_of(0.5, 0.75, slope=0.5), state_of(0.0, -0.5, 3.0), new_scratch(), []
    monkeypatch.setattr(panel_events, "record_tangency", lambda *given: found.append((given[1], given[3])))
    monkeypatch.setattr(panel_events, "margin_downcrossing", lambda *given: (NOT_FOUND, True))
    panel = Panel(sigma, 3.0, 0.25)
    if sigma == 0:
        panel_events.end_of_rolling(body, panel, state, False, scratch)
    else:
        panel_events.end_of_slip(body, panel, state, False, 0, scratch)
    weight = body.gn + 0.25
    assert found == [(weight + body.gt, weight + body.gt) if sigma == 0 else (weight, 3.5)]
