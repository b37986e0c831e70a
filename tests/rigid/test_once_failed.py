"""Motions that once failed, as links; tests/fuzz draws any hoop, plane and start."""

import json

import pytest

import hophoop as hh
import invariants

MASSLESS = "hoop.eccentricity=1&hoop.inertia_ratio=0"
BOTTOM = "start.angle=3.141592653589793"
HELD = "duration=2&hoop.load_fraction=0.1101725026406969&plane.mu=0.3155&plane.rolling_resistance=1"
ONCE = {
    "without end": "hoop.load_fraction=0.99999&start.speed=1",
    "a start too slow for the tables of panels":
        "hoop.load_fraction=0.5&plane.slope=1&plane.mu=0&start.angle=1&start.speed=1e-9",
    "a panel a billion seconds long": "hoop.load_fraction=0&plane.slope=1&plane.mu=0&start.speed=1e-9",
    "slid on against its friction: slip that ends at once": "plane.mu=0&start.angle=1&start.vx=6.5e-80",
    "fell through the plane": "plane.mu=0&start.vy=-8.6e-16",
    "slid on as rounding says, and lost energy without friction": f"hoop.load_fraction=0.5&plane.mu=0&{BOTTOM}&start.speed=1",
    "the same of a light load": f"hoop.load_fraction=1e-5&plane.mu=0&{BOTTOM}&start.speed=0.125",
    "slipped at F = 0 = μ N": "hoop.load_fraction=0&plane.mu=0&start.speed=1",
    "an impact at each panel of a flight at the plane": "hoop.load_fraction=0&plane.gravity=0&plane.mu=0&start.omega=2",
    "a turn that led from slip into rolling, beside μ = 0":
        "hoop.radius=1e-6&hoop.mass=1e-12&hoop.eccentricity=0&hoop.inertia_ratio=1&plane.gravity=41889.74986649628&plane.mu=5e-324"
        "&plane.rolling_resistance=0.026536075109437098&start.vx=-1.2e-233&start.omega=1",
    "driven by friction from a rotation below all doubles":
        "hoop.load_fraction=0&plane.mu_static=0.0013&plane.mu_kinetic=0.001&plane.rolling_resistance=0.004&start.vy=-1e-197"
        "&start.omega=1e-222",
    "no mass in the rim, the load on the plane, and a speed: without end": f"{MASSLESS}&{BOTTOM}&start.speed=-0.063",
    "completed with ω = inf": f"{MASSLESS}&plane.gravity=0&start.angle=1&start.speed=11.37",
    "kept the θ̇ without bound before a strike that rebounds": f"{MASSLESS}&plane.restitution=0.5&start.angle=3",
    "the sequence of turns with a resistance": "duration=6&plane.mu=0&plane.rolling_resistance=0.05&start.angle=2",
    "modes of events":
        "duration=1&hoop.eccentricity=0.15&hoop.inertia_ratio=0.0045&plane.mu=0.21&plane.rolling_resistance=1"
        "&start.angle=-213.57&start.vx=2.4&start.omega=1",
    "held slip":
        "duration=0.017484476528125212&hoop.radius=0.00019217056231712746&hoop.mass=1e12&hoop.eccentricity=0"
        "&hoop.inertia_ratio=5.79010011140085e-5&plane.gravity=8540.967397232022&plane.mu=1e6&plane.restitution=1"
        f"&plane.impact_law=newton&{BOTTOM}&start.vx=0.9999999999999999&start.omega=1",
    "jammed where slip begins at the singular angle, which is at its end":
        "duration=1000&hoop.radius=9.57061204309192&hoop.eccentricity=1&hoop.inertia_ratio=1e-12&plane.gravity=15.113836368357711"
        "&plane.restitution=1&plane.impact_law=newton&start.angle=1.3621702201520565&contact.max_events=150",
    "slid up the slope on which a couple holds it from turning, as the square of its speed is below all doubles":
        f"{HELD}&plane.slope=0.31688841823092484&start.angle=-0.7740592584851411&start.speed=4e-293",
    "the same of the mirrored slope":
        f"{HELD}&plane.slope=-0.31688841823092484&start.angle=0.7740592584851411&start.speed=4e-293",
    "made energy beside the hilltop: θ̇² loses digits on the way round and regains them there, and v_t has to follow":
        "hoop.load_fraction=0.9999999994242047&plane.mu=1e-200&start.angle=1e-40&start.vx=12&start.omega=0.00019809088823063016",
    "the same of one that turns back each time":
        "duration=8&hoop.load_fraction=0.9999999994242047&plane.mu=1e-200&start.angle=-1e-4&start.vx=12"
        "&start.omega=2.965794720740155",
    "the end at a limit": "duration=6&plane.mu=0.1&start.height=0.1&start.angle=2&contact.max_events=8",
    "the end of a compliant contact at a limit": "duration=2&contact.model=compliant&contact.max_events=7",
}  # fmt: skip
# status and first letters of the sequence, where a motion is known to have others than most
KNOWN = {
    "slid up the slope on which a couple holds it from turning, as the square of its speed is below all doubles": (
        "completed",
        "K",
    ),
    "the same of the mirrored slope": ("completed", "S"),
    "no mass in the rim, the load on the plane, and a speed: without end": ("undetermined", ""),
    "kept the θ̇ without bound before a strike that rebounds": ("undetermined", ""),
    "driven by friction from a rotation below all doubles": ("at_rest", "R"),
    "a turn that led from slip into rolling, beside μ = 0": ("at_rest", "SR"),
    "completed with ω = inf": ("completed", "M"),
    "the same of one that turns back each time": ("completed", "K"),
    "jammed where slip begins at the singular angle, which is at its end": ("event_limit", ""),
    "the end at a limit": ("event_limit", "H"),
    "the end of a compliant contact at a limit": ("event_limit", "R"),
}


@pytest.mark.parametrize("name", ONCE)
def test_what_once_failed(name):
    """No exception, no endless loop, and the laws kept at every sampled time."""
    given = {"duration": "3", "contact.max_events": "400"} | dict(part.split("=") for part in ONCE[name].split("&"))
    motion = hh.simulate(hh.Scenario.from_query("&".join(map("=".join, given.items()))))
    status, begin = KNOWN.get(name, (motion.status, ""))
    assert motion.status == status
    assert name in KNOWN or status != "event_limit"
    assert motion.sequence.startswith(begin)
    json.dumps(motion.to_dict(), allow_nan=False)
    invariants.check(motion)
