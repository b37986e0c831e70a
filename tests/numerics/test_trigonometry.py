"""Sines and 1 − cosines of one angle, against mpmath."""

import math

import mpmath
import pytest

from hophoop.kernel.numerics.circular import sine_and_versine
from hophoop.kernel.physics.body import scales_from

ANGLES = [1e-300, 1e-9, 0.3, 0.9, 1.5, math.pi / 2, 2.0, 3.1, math.pi, 4.7, 6.28, 2 * math.pi, 2 * math.pi + 1e-7, 1e6, 1e16]


@pytest.mark.parametrize("angle", [*ANGLES, *(-angle for angle in ANGLES)])
def test_sine_and_versine_keep_their_digits(angle):
    with mpmath.workdps(60):
        exact = mpmath.mpf(angle)
        sine, versine = mpmath.sin(exact), 2 * mpmath.sin(exact / 2) ** 2
    found = sine_and_versine(angle)
    assert found[0] == pytest.approx(float(sine), rel=2.3e-16, abs=0.0)
    assert found[1] == pytest.approx(float(versine), rel=9e-16, abs=0.0)


def test_units_follow_from_length_time_and_mass():
    scales = scales_from(2.0, 4.0, 8.0)
    assert (scales.length, scales.time, scales.mass, scales.speed, scales.rate) == (2.0, 4.0, 8.0, 0.5, 0.25)
    assert (scales.acceleration, scales.force, scales.impulse, scales.energy) == (0.125, 1.0, 4.0, 2.0)
