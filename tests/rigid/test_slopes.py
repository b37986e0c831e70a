r"""Slopes: the jumping cylinder, bodies made of parts, jumps without slip.

Rolling down a slope β from θ0 the energy integral, derived here from D = 1 + κ + ε² + 2 ε cos θ, is
½ D R² θ̇² = ½ D0 R² θ̇0² + g [ε R (cos(θ0 + β) − cos(θ + β)) + R (θ − θ0) sin β].
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh

G = 9.81


def cylinder(radius=0.05):
    """A light foam cylinder with a brass rod along it, near its rim: the kind that jumps."""
    return hh.Hoop.from_parts(radius=radius, parts=[hh.Disk(0.02, radius), hh.Disk(0.06, 0.06 * radius, at=0.8 * radius)])


def spin(hoop, angle, start, omega, slope):
    """θ̇ of rolling by the energy integral above [rad/s]."""
    eps, kap = hoop.eccentricity, hoop.inertia_ratio

    def inertia(at):
        return 1 + kap + eps**2 + 2 * eps * math.cos(at)

    gain = eps * (math.cos(start + slope) - math.cos(angle + slope)) + (angle - start) * math.sin(slope)
    return math.sqrt((inertia(start) * omega**2 + 2 * G / hoop.radius * gain) / inertia(angle))


@pytest.mark.parametrize("degrees", [15, 30, 45])
def test_jumping_cylinder(degrees):
    """Released with the rod on top it rolls, slips, and jumps within the first turns, further up on steeper slopes."""
    hoop, slope = cylinder(), math.radians(degrees)
    plane = hh.Plane(mu=2.0, slope=slope)
    motion = hh.simulate(hoop, plane, hh.Start(angle=-slope + 0.02), duration=2.0)
    (jump, *_) = motion.find("takeoff")
    assert jump.angle < 4 * math.pi
    # rolling up to the first slip is the energy integral
    slip = motion.find("slip_start")[0]
    assert slip.omega == pytest.approx(spin(hoop, slip.angle, -slope + 0.02, 0.0, slope), rel=1e-11)
    # at take-off nothing presses: f_n = 0
    lift = -G * math.cos(slope) + hoop.eccentricity * hoop.radius * jump.omega**2 * math.cos(jump.angle)
    assert lift == pytest.approx(0.0, abs=1e-9 * G)
    assert abs(motion.ledger.residual) <= 1e-11 * motion.ledger.range


def test_a_jump_without_slip_needs_both_forces_to_vanish():
    r"""μ = ∞ leaves only N = 0 to end rolling; where f_n < 0 there, no flight can follow: the 'quasi-jump'.

    On the level F is not zero where N is, so the free motion would enter the plane and the run says `undetermined`. On a slope
    there are starts for which f_n ≥ 0 at N = 0: those jump without slip.
    """
    level = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=math.inf), hh.Start.rolling(3.1), duration=2.0)
    assert level.status == "undetermined"
    end = level.events[-1]
    assert -G + 0.75 * end.omega**2 * math.cos(end.angle) < 0.0
    assert not level.find("takeoff")
    hops = 0
    for degrees in (15, 30, 45):
        for omega in np.linspace(0.5, 8.0, 16):
            plane = hh.Plane(mu=math.inf, slope=math.radians(degrees))
            motion = hh.simulate(hh.Hoop.ideal(0.6), plane, hh.Start.rolling(float(omega), angle=-3.0), duration=4.0)
            for jump in motion.find("takeoff"):
                if jump.from_mode == "R":
                    lift = -G * math.cos(plane.slope) + 0.6 * jump.omega**2 * math.cos(jump.angle)
                    assert lift >= -1e-9 * G
                    hops += 1
    assert hops > 0


def test_disk_rolls_or_slips_as_in_the_textbook():
    """A disk on a slope rolls for tan β ≤ 3 μ with g sin β·2/3, and slips above with g (sin β − μ cos β)."""
    disk = hh.Hoop.from_parts(radius=0.1, parts=[hh.Disk(1.0, 0.1)])
    for slope, mu in ((0.3, 0.2), (0.3, 0.05), (-0.5, 0.1)):
        motion = hh.simulate(disk, hh.Plane(mu=mu, slope=slope), hh.Start(), duration=1.0)
        rolls = abs(math.tan(slope)) <= 3 * mu
        way = math.copysign(1.0, slope)
        pull = G * (2 / 3 * math.sin(slope) if rolls else math.sin(slope) - way * mu * math.cos(slope))
        assert motion.sequence == ("R" if rolls else "K" if slope > 0 else "S")
        assert motion.at(1.0).vx == pytest.approx(pull, rel=1e-12)
        assert motion.at(1.0).x == pytest.approx(0.5 * pull, rel=1e-12)
