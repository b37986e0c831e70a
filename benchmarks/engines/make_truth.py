"""Make the truth of the benchmark hophoop-bench/1: two solutions in many digits, and the digits that they share.

    python benchmarks/engines/make_truth.py            # all anew
    python benchmarks/engines/make_truth.py NAME …     # some motions anew
    python benchmarks/engines/make_truth.py --measures # the solutions as they are, measured anew
    python benchmarks/engines/make_truth.py --check    # the file against the second solution, which is computed anew

The first solution is hophoop.precise's (Taylor series in whole numbers, two working precisions), asked anew for the state
at every time of the grid. It has the formulas, the rule of modes and the impact of the kernel, so that it tests the kernel's
solver only. The second is the tests' oracle (Taylor series in mpmath of the equations rederived from the Lagrangian), which
shares no line with either and tests the formulas. The kernel in doubles is compared with the first. About ten minutes on one
core; `prove_truth.py` then proves a bound of the errors.
"""

from __future__ import annotations

import hashlib
import json
import sys
from dataclasses import asdict
from decimal import Decimal, localcontext
from itertools import takewhile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))

from adapters.hophoop import run, scenario_of  # noqa: E402
from measures import measure  # noqa: E402
from mpmath import mp, mpf  # noqa: E402
from task import Task  # noqa: E402
from truth import BENCHMARK, DATA, task_of  # noqa: E402

import hophoop as hh  # noqa: E402
from oracles import precise as oracle  # noqa: E402
from oracles.cases import Case  # noqa: E402

GRID = 32  # states per second
DIGITS = 30
STATE = ("x", "height", "angle", "vx", "vy", "omega")
NAMES = ("x", "y", "angle", "vx", "vy", "omega")
NO_ENERGY = ("residual", "rolling_resistance")  # no motion of the benchmark has rolling resistance
PASSING = ("turn", "apex", "end", "bounce_limit", "start")


def case_of(task: Task) -> Case:
    """The oracle's case of a task."""
    scenario = scenario_of(task)
    plane = scenario.plane
    return Case(
        task.name, radius=task.radius, mass=task.mass, eccentricity=task.eccentricity,
        inertia_ratio=scenario.hoop.inertia_ratio, gravity=task.gravity, slope=task.slope,
        mu_static=task.mu, mu_kinetic=task.mu, restitution=task.restitution, impact_law=plane.impact_law,
        painleve=plane.painleve, x=task.x, height=task.height, angle=task.angle, vx=task.vx, vy=task.vy,
        omega=task.omega, rolling=scenario.start.speed is not None, duration=task.duration,
        rest_below=1e-17 if task.restitution else 0.0, max_events=3000,
    )  # fmt: skip


def shared(ours: list[Decimal], theirs: list[Any]) -> int:
    """Digits that two lists of numbers have in common, each beside itself or beside 1 in SI units."""
    with mp.workdps(60):
        worst = max(abs(mpf(str(a)) - b) / max(abs(b), 1) for a, b in zip(ours, theirs, strict=True))
        return DIGITS if worst == 0 else max(0, min(DIGITS, int(mp.floor(-mp.log10(worst)))))


def text(value: Decimal) -> str:
    """A decimal string of at most so many digits."""
    with localcontext() as context:
        context.prec = DIGITS
        return format(+value, "f") if value == 0 or abs(value) > Decimal("1e-6") else str(+value)


def truth_of(known: dict[str, Any]) -> dict[str, Any]:
    """The entry of a motion with its task solved anew."""
    task = task_of(known["task"])
    scenario = scenario_of(task)
    precise = hh.simulate(scenario, digits=DIGITS)
    solution = oracle.solve(case_of(task), 44)
    kernel = hh.simulate(scenario)
    times = [k / GRID for k in range(int(scenario.duration * GRID) + 1)]
    rows, digits = [], []
    with mp.workdps(60):
        for t in times:
            if t == 0.0:
                event = precise.events[0]
                if precise.events[-1].t != 0 and len([e for e in precise.events if e.t == 0]) > 1:
                    event = [e for e in precise.events if e.t == 0][-1]
            else:
                event = hh.simulate(scenario.replace("duration", t), digits=DIGITS).events[-1]
            ours = [getattr(event, name) for name in STATE]
            sample = solution.at(mpf(t))
            rows.append(ours)
            digits.append(shared(ours, [sample[name] for name in STATE]))
            mine = kernel.at(t)
            off = max(abs(float(a) - getattr(mine, name)) for a, name in zip(ours, STATE, strict=True))
            if off > 1e-10:
                raise SystemExit(f"{task.name}: the kernel is off by {off:.2e} at t = {t}")
    theirs = [event for event in solution.events if event["kind"] not in PASSING]
    ours_events = [event for event in precise.events if event.kind not in PASSING]
    if not task.restitution and len(theirs) != len(ours_events):
        raise SystemExit(f"{task.name}: {len(ours_events)} events here, {len(theirs)} in the oracle")
    matched = dict(zip(map(id, ours_events), theirs, strict=False))
    events = []
    # endless bounces: the first of them, and what follows when they are over
    over = next((k for k, event in enumerate(precise.events) if event.kind == "bounce_limit"), len(precise.events))
    for event in [*precise.events[: min(over, 40)], *precise.events[over:]]:
        other = matched.get(id(event))
        numbers = [event.t, *(getattr(event, name) for name in STATE)]
        entry: dict[str, Any] = {"t": text(event.t), "kind": event.kind, "from": event.from_mode, "to": event.to_mode}
        entry |= {name: text(number) for name, number in zip(NAMES, numbers[1:], strict=True)}
        entry["digits"] = min(event.digits_right, DIGITS)
        if other is not None:
            if other["kind"] != event.kind:
                raise SystemExit(f"{task.name}: {event.kind} here, {other['kind']} in the oracle")
            entry["digits"] = min(entry["digits"], shared(numbers, [other["t"], *(other[name] for name in STATE)]))
        events.append(entry)
    print(
        task.name,
        precise.sequence[:20],
        "digits:",
        min(digits),
        "states,",
        min(e["digits"] for e in events),
        "events",
        flush=True,
    )
    columns = zip(*rows, strict=True)
    return {
        **{name: known[name] for name in ("title", "why", "scored", "task")},
        "impact_law": scenario.plane.impact_law,
        "sequence": precise.sequence if not task.restitution else "H" + precise.sequence.lstrip("H"),
        "radius": None,
        "events": events,
        "states": {
            "t": [format(Decimal(t), "f") for t in times],
            **{name: [text(value) for value in column] for name, column in zip(NAMES, columns, strict=True)},
            "digits": digits,
        },
        "energy": {name: text(value) for name, value in precise.energy.items() if name not in NO_ENERGY},
    }


def measures_of(entry: dict[str, Any]) -> dict[str, Any]:
    """Measures of the exact motion with its exact events, and the time from the start without loss of energy [s]."""
    task = task_of(entry["task"])
    found = asdict(measure(task, run(task, 0.0)))
    events = entry["events"]
    lift = next((event for event in events if event["kind"] == "takeoff"), None)
    land = next((event for event in events if event["kind"] == "impact" and event["from"] == "H"), None)
    top = next((event for event in events if event["kind"] == "apex"), None)
    exact = {
        "takeoff_time": float(lift["t"]) if lift else None,
        "takeoff_angle": float(lift["angle"]) if lift else None,
        "hop_height": float(top["y"]) if lift and top else None,
        "landing_time": float(land["t"]) if land else None,
        "landing_angle": float(land["angle"]) if land else None,
    }
    for name, value in exact.items():
        other = found[name]
        same = value == other if value is None or other is None else abs(value - other) < 1e-3
        if entry["scored"] and not same:
            raise SystemExit(f"{task.name}: {name} = {other!r} by the rule, {value!r} by the events")
    losing = [event for event in events if event["to"] in ("S", "K") or event["kind"] == "impact"]
    found |= exact | {"penetration": 0.0}
    found["lossless_until"] = float(losing[0]["t"]) if losing else task.duration
    return found


def digits_of_oracle(entry: dict[str, Any]) -> tuple[int, int]:
    """Digits that all states, and all events before endless bounces are over, share with the oracle, which solves them anew."""
    task = task_of(entry["task"])
    solution = oracle.solve(case_of(task), 44)
    states, digits = entry["states"], []
    with mp.workdps(60):
        for k, t in enumerate(states["t"]):
            sample = solution.at(mpf(t))
            digits.append(shared([Decimal(states[name][k]) for name in NAMES], [sample[name] for name in STATE]))
        ours = list(takewhile(lambda event: event["kind"] != "bounce_limit", entry["events"]))
        ours = [event for event in ours if event["kind"] not in PASSING]
        theirs = [event for event in solution.events if event["kind"] not in PASSING]
        if [event["kind"] for event in ours] != [event["kind"] for event in theirs[: len(ours)]]:
            raise SystemExit(f"{task.name}: the oracle has other events")
        numbers = [
            ([Decimal(one[name]) for name in ("t", *NAMES)], [two[name] for name in ("t", *STATE)])
            for one, two in zip(ours, theirs, strict=False)
        ]
    return min(digits), min((shared(*pair) for pair in numbers), default=DIGITS)


def main() -> None:
    """Write the truth and its checksum, or check it."""
    scenarios = json.loads(DATA.read_text(encoding="utf-8"))["scenarios"]
    if "--check" in sys.argv:
        for name, entry in scenarios.items():
            print(
                "{}: the oracle shares {} digits of every state and {} of every event".format(name, *digits_of_oracle(entry)),
                flush=True,
            )
        return
    for name in sys.argv[1:] or list(scenarios):
        if name in scenarios:
            scenarios[name] = truth_of(scenarios[name])
    for entry in scenarios.values():
        entry["measures"] = measures_of(entry)
    write(scenarios)


def write(scenarios: dict[str, Any]) -> None:
    """The file and its checksum."""
    document = {
        "$schema": "hophoop-bench-1.schema.json",
        "benchmark": BENCHMARK,
        "license": "CC0-1.0",
        "made_by": f"hophoop {hh.__version__}",
        "numbers": (
            "Decimal strings in SI units and radians, solved for the doubles nearest to the numbers of each task. "
            "'digits' counts what two independent solutions have in common; 'radius' is for a proved bound."
        ),
        "scenarios": scenarios,
    }
    content = (json.dumps(document, indent=1, ensure_ascii=False) + "\n").encode()
    DATA.write_bytes(content)
    digest = hashlib.sha256(content).hexdigest()
    DATA.with_suffix(".sha256").write_text(f"{digest}  {DATA.name}\n")


if __name__ == "__main__":
    main()
