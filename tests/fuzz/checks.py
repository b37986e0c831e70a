"""What every motion must keep, whatever the magnitudes; each broken law as a line of words."""

from __future__ import annotations

import hashlib
import json
import math
import os
import sys
import tempfile
import time
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import hophoop as hh

PATIENCE = 5.0  # s of the processor; the longest are decisions in more digits
LEDGER, LEDGER_OF_LIGHT, LIGHT = 1e-9, 1e-8, 1e-6  # of the energy range, with rigid contact; with a ring below that κ
LEDGER_OF_STEPS, LEDGER_OF_STEP = 1e3, 0.1  # times rtol, with compliant contact: of a motion, and for each of its steps
ROUGH = 100.0  # friction beyond which a compliant contact, as with a light ring, is a thousand times less exact
TINY_FRICTION = 1e-12
ROUNDING = 1e-9  # of the forces at work
FINITE = ("x", "height", "angle", "vx", "vy", "omega", "slip", "kinetic", "potential", "friction_force", "normal_force")
STATE = ("t", "x", "height", "angle", "vx", "vy", "omega", "slip")
SIGNED = {"x", "angle", "speed", "vx", "omega", "slope"}


class Outcome(NamedTuple):
    """How a scenario went."""

    word: str  # 'refused', or a status
    problems: tuple[str, ...]
    ledger: float  # residual over range
    seconds: float  # of the processor, for the motion
    digest: str = ""


def mirrored(keys: dict[str, Any]) -> dict[str, Any]:
    """The scenario with left and right exchanged; 0 stays 0."""
    turned = {
        section: {name: 0.0 - value if name in SIGNED else value for name, value in keys[section].items()}
        for section in ("plane", "start")
    }
    return {**keys, **turned}


def digest(motion: hh.Trajectory) -> str:
    """Of all that the simulation wrote."""
    tables = motion.tables
    return hashlib.sha256(tables["events"].tobytes() + tables["segments"].tobytes() + motion.status.encode()).hexdigest()


def law_problems(motion: hh.Trajectory) -> list[str]:
    """Broken laws of a motion: finite numbers, ledger, gap, cone, friction against slip, order of the events."""
    scenario, ledger = motion.scenario, motion.ledger
    hoop, plane = scenario.hoop, scenario.plane
    rigid = scenario.contact.model == "rigid"
    found = []
    sample = motion.at(motion.times(25) if motion.duration > 0.0 else np.zeros(1))
    found += [f"{name} is not finite" for name in FINITE if not np.isfinite(getattr(sample, name)).all()]
    found += [f"{name} of an event is not finite" for name in STATE if not all(map(math.isfinite, _of(motion, name)))]
    allowed = LEDGER if hoop.inertia_ratio >= LIGHT or hoop.massless else LEDGER_OF_LIGHT
    if not rigid:
        steps = len(motion.tables["segments"])
        allowed = 1e-8 + (LEDGER_OF_STEPS + LEDGER_OF_STEP * steps) * (scenario.contact.rtol or 1e-9)
        if hoop.inertia_ratio < LIGHT or plane.mu_static > ROUGH:
            allowed *= LEDGER_OF_STEPS
    else:
        allowed += rounded_away(motion) / ledger.range if ledger.range else 0.0
    if not abs(ledger.residual) <= allowed * ledger.range:
        found.append(f"ledger off by {abs(ledger.residual) / ledger.range:.0e}")
    times = _of(motion, "t")
    if times != sorted(times) or times[-1] > motion.duration * (1 + 1e-12):
        found.append("events out of order")
    touching = np.isin(sample.mode, ["R", "S", "K"])
    normal, friction = sample.normal_force, sample.friction_force
    size = hoop.mass * (plane.gravity + hoop.radius * np.max(sample.omega**2)) + np.max(np.abs(normal))
    if rigid and not (sample.height >= 0.0).all():
        found.append("the rim is in the plane")
    if (normal < -ROUNDING * size).any() or (normal[~touching] != 0.0).any():
        found.append("the plane pulls, or pushes from afar")
    if rigid and math.isfinite(plane.mu_static):
        slack = ROUNDING * size * max(1.0, plane.mu_static)
        if (np.abs(friction) > plane.mu_static * np.maximum(normal, 0.0) * (1 + 1e-9) + slack).any():
            found.append("friction beyond its cone")
    sliding = np.isin(sample.mode, ["S", "K"])
    speed = np.abs(sample.slip) + hoop.radius * np.max(np.abs(sample.omega))
    push = max(size, np.max(np.abs(friction)))
    if rigid and (friction[sliding] * sample.slip[sliding] > ROUNDING * push * speed[sliding]).any():
        found.append("friction along the slip")
    return found


def rounded_away(motion: hh.Trajectory) -> float:
    """Energy that the last bits of the velocities are, added up over the panels of a rigid motion [J].

    Every panel ends in v_t and θ̇ as doubles. The rounding of either moves the mass, whose velocity is their sum, and where
    they are 10⁶ to 10⁹ times that sum, it is seen. Half of the last bit is counted of v_t, and a whole one of θ̇, which
    is the root of a sum that was rounded before.
    """
    segments, body = motion.tables["segments"], motion.scenario.to_body()
    slip, omega, theta = (segments[name] for name in ("slip", "omega", "theta"))
    slips = slip != 0.0  # rolling has no such difference
    along = slip + omega * (1.0 - body.eps + body.eps * (1.0 + np.cos(theta)))
    moved = np.abs(along) * (0.5 * np.spacing(np.abs(slip)) + np.spacing(np.abs(omega)))
    return float(np.sum(moved[slips])) * motion.units.energy


def _of(motion: hh.Trajectory, name: str) -> list[float]:
    return [getattr(event, name) for event in motion.events]


def mirror_problems(motion: hh.Trajectory, keys: dict[str, Any]) -> list[str]:
    """Whether left and right are alike: the same kinds of events at the same times, to the last bit.

    Left out are starts with the load at the bottom, where −π and π are one angle, and slip without friction beside static
    friction, where rounding decides whether it begins.
    """
    plane, angle = motion.scenario.plane, motion.scenario.start.angle
    if (math.cos(angle) < 0.0 and abs(math.sin(angle)) < 1e-6) or plane.mu_kinetic < TINY_FRICTION < plane.mu_static:
        return []
    other = hh.simulate(hh.Scenario.from_dict(mirrored(keys)))
    mine, theirs = motion.tables["events"], other.tables["events"]
    if other.status != motion.status or len(mine) != len(theirs) or (mine["kind"] != theirs["kind"]).any():
        return ["the mirrored motion has other events"]
    if (mine["t"] != theirs["t"]).any() or (mine["omega"] != -theirs["omega"]).any():
        return ["the mirrored motion has other numbers"]
    return []


def file_problems(motion: hh.Trajectory) -> list[str]:
    """Whether a saved motion is loaded with the same bits."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "motion.nc"
        motion.save(path)
        return [] if digest(hh.load(path)) == digest(motion) else ["a loaded motion has other bits"]


def warm_up() -> None:
    """Load or compile the kernels of both contacts, before a clock runs."""
    for contact in (hh.Rigid(), hh.Compliant()):
        hh.simulate(hh.Scenario(contact=contact, duration=0.1)).at(0.05)


def thread_problems(motion: hh.Trajectory) -> list[str]:
    """Whether eight threads at once give the same bits."""
    with ThreadPoolExecutor(8) as pool:
        others = list(pool.map(hh.simulate, [motion.scenario] * 8))
    return [] if {digest(other) for other in others} == {digest(motion)} else ["threads give other bits"]


def fork_problems(motion: hh.Trajectory) -> list[str]:
    """Whether a forked process gives the same bits; nothing where processes cannot be forked."""
    if not hasattr(os, "fork") or sys.platform == "darwin":
        return []
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:  # nothing of the parent may run on here, also where something is raised
        try:
            os.write(writing, digest(hh.simulate(motion.scenario)).encode())
        finally:
            os._exit(0)
    os.close(writing)
    with open(reading, encoding="ascii") as pipe:
        said = pipe.read()
    os.waitpid(child, 0)
    return [] if said == digest(motion) else ["a forked process gives other bits"]


def outcome(keys: dict[str, Any], with_file: bool = False, patience: float = PATIENCE, elsewhere: bool = False) -> Outcome:
    """Compute the motion of a scenario file's keys, and check it.

    Anything that is raised is a problem, but for a ValueError where the scenario is refused. `elsewhere`: also in threads
    and in a forked process.
    """
    began = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            scenario = hh.Scenario.from_dict(keys)
        except ValueError as error:
            plain = str(error).endswith((".", "?")) and "\n" not in str(error)
            return Outcome("refused", () if plain else ("no plain sentence",), 0.0, 0.0)
        try:
            motion = hh.simulate(scenario)
            seconds = time.process_time() - began
            json.dumps(motion.to_dict(), allow_nan=False)
            found = law_problems(motion)
            if scenario.contact.model == "rigid":
                found += mirror_problems(motion, keys)
            if with_file:
                found += file_problems(motion)
            if elsewhere:
                found += thread_problems(motion) + fork_problems(motion)
            off = abs(motion.ledger.residual) / motion.ledger.range if motion.ledger.range else 0.0
        except Exception as error:
            return Outcome("raised", (f"{type(error).__name__}: {error}"[:200],), math.inf, time.process_time() - began)
    if seconds > patience:
        found.append(f"{seconds:.0f} s of the processor")
    return Outcome(motion.status, tuple(found), off, seconds, digest(motion))
