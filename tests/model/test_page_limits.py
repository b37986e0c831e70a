"""What the page's own code refuses to read or to compute, in Node, beside what the server does: the same sentences."""

from __future__ import annotations

import json
import random
from typing import Any

from hophoop.lab.api import calls
from hophoop.lab.api.motion_map import MAP_QUANTITIES
from hophoop.scenario import InputError
from model.requests_drawn import plain
from model.test_page_model import answers, written
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


def axis(draw: random.Random) -> dict[str, Any]:
    path, scale = draw.choice(AXES)
    low, high = (round(draw.uniform(-0.3 * scale, scale), draw.choice([0, 2, 16])) for _ in range(2))
    return {"path": path, "from": low, "to": high, "cells": draw.choice([1, 7, 48, 216, 300, 4096])}


def request(seed: int) -> tuple[str, dict[str, Any]]:
    """A call with its body, as the page makes it; about half of them are meant to be allowed."""
    draw = random.Random(seed)
    name = draw.choice(["motion", "map", "map"])
    body: dict[str, Any] = {"query": draw.choice(COSTLY) if draw.random() < 0.6 else ""}
    if draw.random() < 0.3:
        pairs = 201 if draw.random() < 0.1 else draw.randint(0, 2)
        body["changes"] = [["duration", round(draw.uniform(0.1, 800), 1)] for _ in range(pairs)]
    if name == "map":
        body |= {"x": axis(draw), "y": axis(draw), "what": draw.choice([*MAP_QUANTITIES])}
    return name, json.loads(json.dumps(plain(body)))


def of_python(name: str, body: dict[str, Any]) -> dict[str, Any]:
    try:
        read = calls.read(name, body)
        read.scenario  # noqa: B018 - a path that the scenario has not is said now
        calls.bounded(read)
    except InputError as error:
        return {"error": written(str(error))}
    return {"value": None}


def test_what_is_too_much_is_refused_alike():
    asked = [request(seed) for seed in range(1500)]
    answered = answers("bounded", [{"name": name, "body": body} for name, body in asked])
    for (name, body), answer in zip(asked, answered, strict=True):
        assert answer == of_python(name, body), (name, body)
    # every kind of refusal was met, and many requests were allowed
    said = " ".join(answer.get("error", "") for answer in answered)
    for part in (
        "the library itself has no such limit", "million steps; at most 3 million", "A cell of this map", "revolutions in all",
        "changes has 201 pairs", "in two ways", "must differ", "must be at most 65536", "for a map",
    ):  # fmt: skip
        assert part in said, part
    assert sum("value" in answer for answer in answered) > 400
