"""The margins of a mode against Newton's and Euler's equations as one linear system."""

import math

import numpy as np
import pytest

from hophoop.kernel.physics.body import Mode
from hophoop.kernel.rigid.sampling import MARGINS, margins_of
from newton_euler import BODIES, STATES, accelerations, responses
from rigid.tools import body_of


def margins(body, mode, th, om):
    return margins_of(body, int(mode), th, 0.0, om, 0.25, 0.5)


@pytest.mark.parametrize("body", [*BODIES, BODIES[0]._replace(kap=1.75)])  # κ > 1: with mass on arms outside of the rim
@pytest.mark.parametrize(("th", "om"), STATES)
def test_each_mode_has_its_forces_and_their_limit(body, th, om):
    """In slip also p_σ, ÿ of the rim for a unit of N with its friction; without contact no forces."""
    tangential, plain = responses(body, th)
    free = accelerations(body, th, om, "free")[1]
    for mode, law, mu in ((Mode.ROLL, "roll", body.mu_s), (Mode.SKID, 1, body.mu_k), (Mode.SPIN, -1, body.mu_k)):
        friction, normal = accelerations(body, th, om, law)[3:]
        p_sigma = math.nan if law == "roll" else plain[1] - law * mu * tangential[1]
        expected = [normal, friction, mu * normal, free, 0.25, 0.5, p_sigma]
        np.testing.assert_allclose(margins(body, mode, th, om), expected, rtol=1e-11, atol=1e-12)
    for mode in (Mode.FLIGHT, Mode.SKIM):
        for mu in (0.5, math.inf):
            found = margins(body._replace(mu_s=mu, mu_k=mu), mode, th, om)
            np.testing.assert_allclose(found, [0.0, 0.0, 0.0, free, 0.25, 0.5, math.nan], rtol=1e-14, atol=1e-15)


def test_where_a_margin_is_not_described_or_has_no_limit():
    """Slip without a mass in the rim or a limit of friction has no forces; μ N of an N of zero is zero, whatever μ."""
    for body in (body_of(1.0), body_of(mu=math.inf)):
        for mode in (Mode.SKID, Mode.SPIN):
            found = dict(zip(MARGINS, margins(body, mode, 0.4, 0.5), strict=True))
            assert all(math.isnan(found[name]) for name in ("normal_force", "friction_force", "friction_limit", "p_sigma"))
            assert found["free_acceleration"] == pytest.approx(body.eps * 0.25 * math.cos(0.4) - 1.0, rel=1e-14)
    for mu in (0.5, math.inf):
        weightless = body_of(0.0, mu=mu, gravity=0.0)
        assert margins(weightless, Mode.ROLL, 0.4, 1.0)[::2][:2] == (0.0, 0.0)
    for om, limit in ((0.0, math.inf), (1.5, -math.inf)):
        normal, _, found, *_ = margins(body_of(mu=math.inf), Mode.ROLL, 0.0, om)
        assert (normal > 0.0, found) == (limit > 0.0, limit)
