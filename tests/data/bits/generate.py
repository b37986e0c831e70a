"""Write the files of this folder.

python tests/data/bits/generate.py scenarios   draw them anew: another C library may draw others, so the file is what counts
python tests/data/bits/generate.py hashes      compute every motion and write the hashes of its bits
"""

from __future__ import annotations

import json
import math
import sys
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bits_tools
import hophoop as hh
from hophoop.scenario import Plane, Rigid
from random_scenarios import draw, draw_beside_a_border

SEED = 20261125
MOST_EVENTS = 200
# How many of each kind. Those of the last kind are in doubt somewhere.
COUNTS = {"rigid": 630, "paradox": 50, "border": 50, "resisted": 150, "massless": 40, "compliant": 60, "doubt": 20}
DEFAULTS = Plane().to_dict()


def drawn(kind: str, index: int) -> dict[str, Any]:
    """The sections of a scenario of one kind; not every one is allowed."""
    if kind in ("border", "doubt"):
        return draw_beside_a_border(SEED, index)[1]
    random = np.random.default_rng([SEED, index, sorted(COUNTS).index(kind)])
    _, sections = draw(SEED + sorted(COUNTS).index(kind), index)
    hoop, plane = sections["hoop"], sections["plane"]
    if kind == "resisted":
        plane["rolling_resistance"] = float(10 ** random.uniform(-4, -1.3))
    elif kind == "paradox":
        sections["hoop"] = {"radius": hoop["radius"], "mass": hoop["mass"], "load_fraction": float(random.uniform(0.6, 0.999))}
        plane["mu_static"] = float(random.uniform(1.0, 8.0))
        plane["mu_kinetic"] = plane["mu_static"] * float(random.choice([0.7, 1.0]))
        plane["gravity"], plane["slope"] = 9.81, float(random.choice([0.0, 0.3]))
        speed = np.sqrt(9.81 * hoop["radius"])
        start = {"vx": float(random.uniform(-6, 6) * speed), "omega": float(random.uniform(-3, 3) * speed / hoop["radius"])}
        sections["start"] = {"angle": float(random.uniform(-1.5, 1.5)), **start}
    elif kind == "massless":
        sections["hoop"] = {"radius": hoop["radius"], "mass": hoop["mass"], "load_fraction": 1.0}
        plane["slope"] = 0.0
    elif kind == "compliant":
        plane["mu_static"] = min(plane["mu_static"], 3.0)
        plane["mu_kinetic"] = min(plane["mu_kinetic"], plane["mu_static"])
        plane["restitution"] = min(plane["restitution"], 0.9)
        if hoop.get("load_fraction", 0.0) > 0.99:
            hoop["load_fraction"] = 0.75
        sections["duration"] = min(sections["duration"], float(3.0 * np.sqrt(hoop["radius"] / 9.81)))
        sections["contact"] = {
            "model": "compliant",
            "law": str(random.choice(["kelvin-voigt", "hunt-crossley"])),
            "friction": str(random.choice(["tanh", "linear", "bristle"])),
            "rtol": float(random.choice([1e-6, 1e-8])),
            "max_events": MOST_EVENTS,
        }
    return sections


def scenarios(kind: str, wanted: int) -> list[dict[str, Any]]:
    """So many sections that make a scenario, without what is as by default."""
    found: list[dict[str, Any]] = []
    for index in count():
        if len(found) == wanted:
            return found
        sections = drawn(kind, index)
        try:
            scenario = bits_tools.scenario_of(sections, MOST_EVENTS)
        except ValueError:
            continue
        if kind != "compliant":
            rigid = scenario.model_copy(update={"contact": Rigid(max_events=MOST_EVENTS)})
            if (hh.simulate(rigid).doubt < math.inf) != (kind == "doubt"):
                continue
        whole = scenario.to_dict()
        plane = {name: value for name, value in whole["plane"].items() if DEFAULTS.get(name) != value}
        start = {name: value for name, value in whole["start"].items() if value != 0.0 or name == "speed"}
        kept = {"kind": kind, "duration": whole["duration"], "hoop": whole["hoop"], "plane": plane, "start": start}
        if kind == "compliant":
            kept["contact"] = sections["contact"]
        assert bits_tools.scenario_of(kept, MOST_EVENTS) == scenario
        found.append(kept)


def write_scenarios() -> None:
    """Draw them, of all kinds mixed, so that any part of them is a sample."""
    made = [one for kind, wanted in COUNTS.items() for one in scenarios(kind, wanted)]
    order = np.random.default_rng(SEED).permutation(len(made))
    lines = ",\n".join(json.dumps(made[place], ensure_ascii=False) for place in order)
    bits_tools.SCENARIOS.write_text(f'{{"max_events": {MOST_EVENTS}, "scenarios": [\n{lines}\n]}}\n', encoding="utf-8")
    print(f"{len(made)} scenarios, {bits_tools.SCENARIOS.stat().st_size} bytes")


def write_hashes() -> None:
    """Compute all motions here."""
    kept = bits_tools.kept_scenarios()
    told = bits_tools.hashes_of([bits_tools.bits_of(hh.simulate(each.scenario)) for each in kept], kept)
    bits_tools.HASHES.write_text(bits_tools.hashes_text(told), encoding="utf-8")
    print("events", told["events"])


if __name__ == "__main__":
    {"scenarios": write_scenarios, "hashes": write_hashes}[sys.argv[1]]()
