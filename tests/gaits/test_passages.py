"""Passages of a section and the derivative of the return map, compared with single motions and 30 digits."""

import math

import numpy as np
import pytest

import hophoop as hh
from random_scenarios import draw, scenario_of
from slopes import on_slope


@pytest.mark.parametrize("degrees", [0.0, 10.0, -10.0, 0.5])
@pytest.mark.parametrize("omega", [1.9, -1.9, 0.3])
def test_rolling_to_and_fro_passes_the_bottom_as_fast(degrees, omega):
    """Rolling loses nothing, whichever revolution θ is counted from."""
    found = hh.passages(on_slope(degrees, 0.889, omega), 12)
    assert found.sequences == ("R",) * 12
    assert found.omega == pytest.approx([omega * (-1) ** (k + 1) for k in range(12)], abs=1e-12)
    assert found.angle == pytest.approx([math.pi] * 12, abs=1e-12)


def test_sections_share_multipliers():
    """At the landing the state has three numbers, of which only one direction does not vanish at once."""
    found = hh.passages(on_slope(3.0, 0.5, 2.7), 300, section="landing")
    derivative = hh.gaits.derivative(found.scenario.replace("start", found.start(290)), section="landing")
    assert derivative.rows == derivative.columns == ("angle", "omega", "slip")
    assert derivative.multipliers[0].real == pytest.approx(-0.768024, abs=1e-6)
    assert abs(derivative.multipliers[1:]).max() < 1e-10


def test_random_motions():
    """Each row is a state of the motion that `simulate` gives, at the time and with the losses of the row."""
    compared = hopped = 0
    for index in range(60):
        scenario = scenario_of(draw(37, index), 2000)
        if scenario.plane.gravity == 0.0 or scenario.hoop.inertia_ratio < 1e-6:  # nearly massless: θ̇ is unbounded at the bottom
            continue
        motion = hh.simulate(scenario)
        if not motion.ok or motion.doubt < math.inf:
            continue
        for section in ("bottom", "landing"):
            found = hh.passages(scenario, 12, section=section)
            for k in np.flatnonzero(found.t < 0.5 * motion.duration):
                state = motion.at(found.t[k])
                close = 1e-6 * (1.0 + abs(state.omega) + abs(state.angle))
                assert found.angle[k] == pytest.approx(state.angle, abs=close)
                assert found.x[k] == pytest.approx(state.x, rel=1e-6, abs=1e-6)
                weight = scenario.hoop.mass * scenario.plane.gravity * scenario.hoop.radius
                lost = sum(found.loss("friction")[: k + 1])
                assert lost == pytest.approx(state.friction, rel=1e-5, abs=1e-6 * weight)
                if section == "bottom":
                    assert found.omega[k] == pytest.approx(state.omega, abs=close)
                    assert math.cos(found.angle[k]) == pytest.approx(-1.0, abs=1e-12)
                    assert found.mode[k] in "RSK"
                compared += 1
                hopped += int(found.hops[k])
    assert compared > 60
    assert hopped > 20


def test_sequence_and_hops_of_a_long_motion():
    """Words are the phases of `simulate` between the passages, and every hop counts."""
    scenario = on_slope(4.0, 0.75, 3.4).replace("duration", 80.0)
    found, motion = hh.passages(scenario, 15), hh.simulate(scenario)
    for k in range(1, len(found)):
        a, b = found.t[k - 1], found.t[k]
        inside = [e for e in motion.events if a < e.t < b and e.kind not in ("turn", "apex")]
        assert found.sequences[k] == found.mode[k - 1] + "".join(e.to_mode for e in inside)
        assert found.hops[k] == sum(e.kind == "takeoff" for e in inside)
    assert found.distance.sum() == pytest.approx(found.x[-1], rel=1e-14)
    table = found.to_xarray()
    assert all({"units", "long_name"} <= set(variable.attrs) for variable in table.variables.values() if variable.dims)


def test_a_start_from_a_passage():
    """A motion goes on from a passage as the passages do."""
    found = hh.passages(on_slope(3.0, 0.5, 2.7), 6)
    again = hh.passages(found.scenario.replace("start", found.start(2)), 3)
    np.testing.assert_allclose(again.omega, found.omega[3:], rtol=1e-13)
    assert again.sequences == found.sequences[3:]


def test_lyapunov():
    """The logarithm of the multiplier on a gait; in chaos as in the literature of this hoop, within its error."""
    gait = hh.passages(on_slope(1.0, 0.75, 3.4), 200).lyapunov
    assert gait.value == pytest.approx(math.log(0.610983567588), abs=1e-6)
    assert math.isnan(hh.passages(on_slope(0.0, 0.75, 0.0), 5).lyapunov.value)
    chaos = hh.passages(on_slope(4.0, 0.75, 3.41), 1500)
    assert chaos.fate == "chaotic"
    assert abs(chaos.lyapunov.value - 0.575) < min(5.0 * chaos.lyapunov.error, 0.05)


@pytest.mark.parametrize(
    ("change", "given", "sentence"),
    [
        ({}, {"count": 0}, r"^count = 0 must be an integer from 1 to 10000000\.$"),
        ({}, {"section": "top"}, r"^section = 'top' must be one of bottom, landing\.$"),
        ({"contact.model": "compliant"}, {}, r"^contact\.model = 'compliant' must be 'rigid'"),
        ({"plane.gravity": 0.0}, {}, r"^plane\.gravity = 0\.0 must be above 0"),
    ],
)
def test_refusals(change, given, sentence):
    with pytest.raises(ValueError, match=sentence):
        hh.passages(on_slope(1.0, 0.75, 3.4).with_values(change), **given)


def test_a_derivative_needs_the_section():
    with pytest.raises(ValueError, match=r"^start\.angle must be pi"):
        hh.gaits.derivative(hh.Scenario())
    with pytest.raises(ValueError, match=r"passes its section no more"):
        hh.gaits.derivative(on_slope(1.0, 0.75, 3.4).with_values({"plane.slope": 0.0, "start.speed": 0.0}))


def test_a_corner_in_slip_has_no_derivative():
    """More slip and less slip lead to different rates, so the column of the slip is nan, with the reason."""
    plane = hh.Plane(slope=math.radians(20), mu=0.02, gravity=1.0)
    base = hh.Scenario(hoop=hh.Hoop.ideal(0.5), plane=plane, start=hh.Start.rolling(4.0, angle=math.pi))

    def image(slip):
        start = hh.Start(angle=math.pi, vx=4.0 + slip, omega=4.0, slip=slip)
        found = hh.passages(base.replace("start", start), 1)
        return np.array([found.omega[0], found.slip[0]])

    known = hh.gaits.derivative(base)
    assert np.isnan(known.matrix[:, known.columns.index("slip")]).all()
    assert "border of two classes" in known.reason
    ahead, back = image(1e-6) - image(0.0), image(0.0) - image(-1e-6)
    assert abs(ahead - back).min() > 3e-13
