"""What the page's own code refuses to read or to compute, in Node, beside what the server does: the same sentences."""

from __future__ import annotations

import json
import random
from typing import Any

from hophoop.lab import calls
from hophoop.lab.motion_map import MAP_QUANTITIES
from hophoop.scenario import InputError
from model.requests_drawn import ODD, plain
from model.test_page_model import answers
from web_tools import needs_node

pytestmark = needs_node

# Long, fast, small, steep, stiff and heavy motions, about as often within the limits as beyond them.
COSTLY = [
    "", "duration=600&start.speed=40", "start.speed=1e5&duration=10", "hoop.radius=1e-4&start.speed=3.1",
    "plane.slope=1&plane.gravity=1e4&duration=50", "start.omega=3e5&start.vx=1", "duration=700", "start.vy=2e5&duration=8",
    "contact.model=compliant&duration=1", "contact.model=compliant&contact.stiffness=1e9&duration=60",
    "contact.model=compliant&duration=600&plane.gravity=50", "plane.gravity=0&start.speed=2", "start.height=5&start.vx=-3",
    "plane.mu_static=0.6&plane.mu_kinetic=0.5", "hoop.eccentricity=0.4&hoop.inertia_ratio=0.7", "contact.max_events=100000",
]  # fmt: skip
AXES = [
    ("start.speed", 5.0), ("plane.mu", 1.5), ("duration", 900.0), ("plane.slope", 2.0), ("hoop.radius", 3.0), ("start.vx", 9e4),
    ("plane.mu_static", 2.0), ("start.omega", 1e6), ("plane.gravity", 100.0), ("hoop.load_fraction", 1.2), ("start.angle", 7.0),
    ("start.speed", 1e6), ("contact.max_events", 50.0), ("contact.rtol", 1.0), ("start.height", 4.0),
]  # fmt: skip


def number(draw: random.Random, odd: float, scale: float = 10.0) -> Any:
    return draw.choice(ODD) if draw.random() < odd else round(draw.uniform(-scale, scale), draw.choice([0, 2, 16]))


def numbers(draw: random.Random, odd: float, count: int) -> Any:
    """A window: mostly rising, of the right length."""
    if draw.random() < odd:
        return draw.choice(ODD)
    found = [number(draw, 0.3 * odd) for _ in range(count + (draw.choice([-1, 1]) if draw.random() < odd else 0))]
    if draw.random() < 0.7 and all(isinstance(one, int | float) for one in found):
        found = [abs(one) + (3 * k if k % 2 else 0) for k, one in enumerate(found)]
    return [1e300 if draw.random() < 0.1 * odd else one for one in found]


def axis(draw: random.Random, odd: float) -> Any:
    if draw.random() < 0.5 * odd:
        return draw.choice(ODD)
    path, scale = draw.choice(AXES)
    if draw.random() < odd:
        path = draw.choice(
            ["plane.impact_law", "hoop.parts.0.shape", "hoop.parts.0.mass", "hoop.parts.0.x", "foo", "plane", 3, ""]
        )
    keys = {"path": path, "from": number(draw, 0.5 * odd, 0.3 * scale), "to": number(draw, 0.5 * odd, scale)}
    if draw.random() < 0.8:
        keys["cells"] = draw.choice([1, 7, 48, 216, 300, 4096, 0, 4097, 2.5] if draw.random() < odd else [1, 7, 48, 216])
    if draw.random() < odd:
        keys.pop(draw.choice(list(keys)))
    if draw.random() < 0.3 * odd:
        keys[draw.choice(["cell", "step", "low"])] = 1
    return keys


def request(seed: int) -> tuple[str, dict[str, Any]]:
    """A call with its body; about half of them are meant to be allowed."""
    draw = random.Random(seed)
    odd = draw.choice([0.0, 0.0, 0.3])
    name = draw.choice(["film", "samples", "regions", "map", "map"])
    body: dict[str, Any] = {"query": draw.choice(COSTLY) if draw.random() < 0.6 else ""}
    if draw.random() < 0.3:
        pairs = 201 if draw.random() < odd else draw.randint(0, 2)
        body["changes"] = [["duration", round(draw.uniform(0.1, 800), 1)] for _ in range(pairs)]
    if name == "samples":
        body["window"] = numbers(draw, odd, 2)
    elif name == "regions" and draw.random() < 0.9:
        body["window"] = numbers(draw, odd, 4)
    elif name == "map":
        body |= {"x": axis(draw, odd), "y": axis(draw, odd)}
        if draw.random() < 0.8:
            body["what"] = draw.choice([*MAP_QUANTITIES, "hops", 3, None] if odd else [*MAP_QUANTITIES])
    if draw.random() < 0.2 * odd:
        body.pop(draw.choice(list(body)))
    if draw.random() < 0.1 * odd:
        body[draw.choice(["windows", "z", "samples"])] = 1
    return name, json.loads(json.dumps(plain(body)))


def of_python(name: str, body: dict[str, Any]) -> dict[str, Any]:
    try:
        read = calls.read(name, body)
        read.scenario  # noqa: B018 - a path that the scenario has not is said now
        calls.bounded(read)
    except InputError as error:
        return {"error": str(error)}
    return {"value": plain(read.body.options())}


def test_what_is_too_much_or_no_window_axis_or_quantity_is_refused_alike():
    asked = [request(seed) for seed in range(1500)]
    answered = answers("bounded", [{"name": name, "body": body} for name, body in asked])
    for (name, body), answer in zip(asked, answered, strict=True):
        assert answer == of_python(name, body), (name, body)
    # every kind of refusal was met, and most requests were allowed
    said = " ".join(answer.get("error", "") for answer in answered)
    for part in (
        "the library itself has no such limit", "steps of integration", "A cell of this map", "revolutions in all",
        "changes has 201 pairs", "two times", "four numbers", "is missing", "in two ways", "that of a word", "takeoff_angle",
        "must differ", "not a known key", "must be at most 65536", "for a map", "is not a parameter", "must be a whole number",
    ):  # fmt: skip
        assert part in said, part
    assert sum("value" in answer for answer in answered) > 400
