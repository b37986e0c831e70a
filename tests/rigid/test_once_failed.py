"""Motions that once failed; tests/fuzz draws any hoop, plane and start."""

import json
import math

import pytest

import hophoop as hh
import invariants

MASSLESS = hh.Hoop(eccentricity=1.0, inertia_ratio=0.0)
ONCE = {
    "without end": (hh.Hoop.ideal(1 - 1e-5), hh.Plane(mu=1.0), hh.Start.rolling(1.0)),
    "a start too slow for the tables of panels": (
        hh.Hoop.ideal(0.5), hh.Plane(mu=0.0, slope=1.0), hh.Start.rolling(1e-9, angle=1.0),
    ),
    "a panel a billion seconds long": (hh.Hoop.ideal(0.0), hh.Plane(mu=0.0, slope=1.0), hh.Start.rolling(1e-9)),
    "slid on against its friction: slip that ends at once": (
        hh.Hoop.ideal(0.75), hh.Plane(mu=0.0), hh.Start(angle=1.0, vx=6.5e-80),
    ),
    "fell through the plane": (hh.Hoop(), hh.Plane(mu=0.0), hh.Start(vy=-8.6e-16, height=0.0)),
    "slid on as rounding says, and lost energy without friction": (
        hh.Hoop.ideal(0.5), hh.Plane(mu=0.0), hh.Start.rolling(1.0, angle=math.pi),
    ),
    "the same of a light load": (hh.Hoop.ideal(1e-5), hh.Plane(mu=0.0), hh.Start.rolling(0.125, angle=math.pi)),
    "slipped at F = 0 = μ N": (hh.Hoop.ideal(0.0), hh.Plane(mu=0.0), hh.Start.rolling(1.0)),
    "an impact at each panel of a flight at the plane": (
        hh.Hoop.ideal(0.0), hh.Plane(mu=0.0, gravity=0.0), hh.Start(omega=2.0),
    ),
    "a turn that led from slip into rolling, beside μ = 0": (
        hh.Hoop(eccentricity=0.0, inertia_ratio=1.0, radius=1e-6, mass=1e-12),
        hh.Plane(gravity=41889.74986649628, mu=5e-324, rolling_resistance=0.026536075109437098),
        hh.Start(vx=-1.2e-233, omega=1.0),
    ),
    "driven by friction from a rotation below all doubles": (
        hh.Hoop.ideal(0.0), hh.Plane(mu_static=0.0013, mu_kinetic=0.001, rolling_resistance=0.004),
        hh.Start(vy=-1e-197, omega=1e-222),
    ),
    "no mass in the rim, the load on the plane, and a speed: without end": (
        MASSLESS, hh.Plane(), hh.Start.rolling(-0.063, angle=math.pi),
    ),
    "completed with ω = inf": (MASSLESS, hh.Plane(gravity=0.0), hh.Start.rolling(11.37, angle=1.0)),
    "kept the θ̇ without bound before a strike that rebounds": (MASSLESS, hh.Plane(restitution=0.5), hh.Start(angle=3.0)),
}  # fmt: skip
# status and first letters of the sequence, where a motion is known to have others than most
KNOWN = {
    "no mass in the rim, the load on the plane, and a speed: without end": ("undetermined", ""),
    "kept the θ̇ without bound before a strike that rebounds": ("undetermined", ""),
    "driven by friction from a rotation below all doubles": ("at_rest", "R"),
    "a turn that led from slip into rolling, beside μ = 0": ("at_rest", "SR"),
    "completed with ω = inf": ("completed", "M"),
}


@pytest.mark.parametrize("name", ONCE)
def test_what_once_failed(name):
    """No exception, no endless loop, and the laws kept at every sampled time."""
    motion = hh.simulate(*ONCE[name], duration=3.0, contact=hh.Rigid(max_events=400))
    status, begin = KNOWN.get(name, (motion.status, ""))
    assert motion.status == status != "event_limit"
    assert motion.sequence.startswith(begin)
    json.dumps(motion.to_dict(), allow_nan=False)
    invariants.check(motion)
