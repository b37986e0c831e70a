"""Every motion must keep its invariants, whatever the magnitudes, also in files, threads and other processes."""

from __future__ import annotations

import hashlib
import json
import os
import sys
import tempfile
import time
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

import hophoop as hh
from invariants import Finding, findings
from symmetries import mirror_finding, mirrored, scaled, units_finding

PATIENCE = 5.0  # s of the processor; the longest are decisions in more digits


class Outcome(NamedTuple):
    """How a scenario went."""

    word: str  # 'refused', or a status
    problems: tuple[str, ...]
    deviations: dict[str, tuple[float, bool]]  # by invariant: the largest one, and whether it is more than is allowed
    seconds: float  # of the processor, for the motion
    digest: str = ""


def digest(motion: hh.Trajectory) -> str:
    """Of all that the simulation wrote."""
    tables = motion.tables
    return hashlib.sha256(tables["events"].tobytes() + tables["segments"].tobytes() + motion.status.encode()).hexdigest()


def all_findings(motion: hh.Trajectory) -> list[Finding]:
    """Deviations from every invariant, and from both symmetries where they are promised; nothing after time that runs back."""
    found = findings(motion)
    if found[-1].invariant != "ledger":
        return found
    if (image := mirrored(motion.scenario)) is not None:
        found.append(mirror_finding(motion, hh.simulate(image)))
    if (other := scaled(motion.scenario)) is not None:
        found.append(units_finding(motion, hh.simulate(other[0]), other[1]))
    return found


def broken(found: list[Finding]) -> list[str]:
    """Each broken invariant as a line of words."""
    return [f"{f.invariant}: {f.words} at {f.t!r} s ({f.value:.1e}, allowed {f.allowed:.1e})" for f in found if f.broken]


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
    found: list[str] = []
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            scenario = hh.Scenario.from_dict(keys)
        except ValueError as error:
            plain = str(error).endswith((".", "?")) and "\n" not in str(error)
            return Outcome("refused", () if plain else ("no plain sentence",), {}, 0.0)
        try:
            motion = hh.simulate(scenario)
            seconds = time.process_time() - began
            invariants = all_findings(motion)
            found = broken(invariants)
            json.dumps(motion.to_dict(), allow_nan=False)
            if with_file:
                found += file_problems(motion)
            if elsewhere:
                found += thread_problems(motion) + fork_problems(motion)
        except Exception as error:
            raised = f"{type(error).__name__}: {error}"[:200]
            return Outcome("raised", (*found, raised), {}, time.process_time() - began)
    if seconds > patience:
        found.append(f"{seconds:.0f} s of the processor")
    deviations = {each.invariant: (each.value, each.broken) for each in invariants}
    return Outcome(motion.status, tuple(found), deviations, seconds, digest(motion))
