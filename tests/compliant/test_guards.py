"""Where a step leaves its regime: also where a margin is negative, or positive, for a moment."""

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.compliant import contact_step
from hophoop.kernel.compliant.contact_step import AHEAD, BACK, NONE, RELEASE
from hophoop.kernel.compliant.records import SIZE, STAGES, VT, Y, Z, new_work
from hophoop.simulation.compliant import to_compliance

WIDTH = 1.0 / 60.0
FRICTIONS = {"linear": 1.0, "tanh": 4.0}  # the slip speeds below which they roll


def first_exit(comp, regime, poly):
    """(margin, s) of the first margin that falls in a step."""
    work = new_work()
    work.poly[:] = poly
    return contact_step.first_exit(comp, regime, work)


def step(slip, friction="linear"):
    """(contact, polynomials of a step in which v_t is a quadratic), under constant load."""
    _, comp, _, _ = to_compliance(hh.Scenario(contact=hh.Compliant(friction=friction)))
    poly = np.zeros((SIZE, STAGES + 1))
    poly[Y, 0] = -1.0 / comp.k
    poly[VT, :3] = slip
    return comp, poly


@pytest.mark.parametrize("friction", FRICTIONS)
@pytest.mark.parametrize("middle", [0.04, 0.5, 0.54, 0.96])
@pytest.mark.parametrize("regime", [1, -1])
def test_slip_that_ends_for_a_moment(friction, middle, regime):
    """abs(v_t) − limit is 100 ((s − middle)² − width²)."""
    limit = FRICTIONS[friction] * step([0.0] * 3)[0].v_s
    for width, touch, kind, s in ((WIDTH, 0.0, AHEAD if regime > 0 else BACK, middle - WIDTH), (0.0, 1e-9, NONE, 1.0)):
        square = 100.0 * (middle * middle - width * width)
        comp, poly = step([regime * (limit + touch + square), -regime * 200.0 * middle, regime * 100.0], friction)
        assert first_exit(comp, regime, poly) == (kind, pytest.approx(s, abs=1e-12))


def test_the_first_of_two_margins_that_are_negative_at_once():
    """The load of a bristle vanishes for a moment, and just before the bristle lets go."""
    _, comp, _, _ = to_compliance(hh.Scenario(contact=hh.Compliant(law="hunt-crossley", friction="bristle")))
    middle, held, more = 0.04, WIDTH**2, 1e-4 * WIDTH
    poly = np.zeros((SIZE, STAGES + 1))
    poly[Y, :3] = np.array([middle**2 - WIDTH**2, -2.0 * middle, 1.0]) / -comp.k
    poly[Z, :2] = held / comp.k_t, more / comp.k_t
    roots = np.roots([1.0, -2.0 * middle - more, middle**2 - WIDTH**2 - held])
    which, s = first_exit(comp, 0, poly)
    assert (which, s) == (AHEAD, pytest.approx(roots.min(), rel=1e-9))
    poly[Z] = 0.0
    assert first_exit(comp, 0, poly) == (RELEASE, pytest.approx(middle - WIDTH, rel=1e-9))


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("width", [0.5 * WIDTH, 2.0 * WIDTH])
def test_creep_that_lasts_for_a_moment(side, width):
    """It begins at the limit, comes below it to v_t = 0 at s = width, and is at it again; slip at once ends where it began."""
    limit = side * step([0.0] * 3)[0].v_s
    for way, end in ((-1.0, 2.0 * width), (1.0, 0.0)):
        comp, poly = step([limit, way * 2.0 * limit / width, limit / width**2])
        found = first_exit(comp, 0, poly)
        assert found == (AHEAD if side > 0 else BACK, pytest.approx(end, rel=1e-12))


@pytest.mark.parametrize(("friction", "ratio"), [("linear", 1.0), ("bristle", 1.0), ("bristle", 0.5)])
def test_slip_ends_where_the_friction_is_coulombs(friction, ratio):
    """Also with a slip speed below the last digits of the slip that has come to it."""
    plane = hh.Plane(mu_static=1.0, mu_kinetic=ratio)
    contact = hh.Compliant(friction=friction, slip_speed=1e-11)
    motion = hh.simulate(hh.Scenario(plane=plane, start=hh.Start(vx=3.1), duration=1.0, contact=contact))
    stick = next(event for event in motion.events if event.kind == "stick")
    after = motion.at(stick.t)
    assert after.friction_force == pytest.approx(-ratio * after.normal_force, rel=1e-7)
