"""Run engines on the motions of the benchmark and score them.

    python benchmarks/engines/run.py --out DIR                        # all that are installed: an hour or two
    python benchmarks/engines/run.py pymunk drake --scenario hop --dt 0.001

Each run is a process of its own, so that a crash, a hang or a conflict between libraries costs one row. DIR gets scores.json,
and the records of the hop at 1 ms, which table.py draws.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import MISSING, asdict, dataclass, fields, replace
from datetime import date
from importlib.metadata import PackageNotFoundError
from importlib.metadata import version as version_of
from pathlib import Path
from typing import Any, NamedTuple

from record import Record, read_record, record_text
from scores import Scores, score
from table import COMMON_STEP, HOP, limits, record_name, row_line
from task import SPACING
from truth import BENCHMARK, Truth, job, truths

HERE = Path(__file__).parent
FINE_STEP = 0.0001
LADDER = (0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002, 0.0001, 0.00005, 0.00002, 0.00001)
PATIENCE = 8.0  # s; longer runs, as estimated from the one before, are left out
LIMIT = 120.0  # s per run


@dataclass(frozen=True)
class Engine:
    """An engine of engines.toml: the manual's settings are 'default', ours 'tuned'."""

    name: str
    title: str
    package: str
    rate: float
    model: str
    contact: str
    tuned: dict[str, Any] | None = None
    ours: bool = False

    @property
    def script(self) -> Path:
        """Its adapter in JavaScript, if it has one."""
        return HERE / "adapters" / f"{self.name}.mjs"

    @property
    def settings(self) -> dict[str, dict[str, Any]]:
        """Settings by name."""
        return {"default": {}} | ({} if self.tuned is None else {"tuned": self.tuned})

    @property
    def step(self) -> float:
        """The manual's time step [s]."""
        return 1.0 / self.rate

    @property
    def version(self) -> str:
        """Version of the installed package; empty if it is not installed."""
        try:
            if not self.script.exists():
                return version_of(self.package)
            text = (HERE / "node_modules" / self.package / "package.json").read_text(encoding="utf-8")
            return str(json.loads(text)["version"]) if shutil.which("node") else ""
        except (PackageNotFoundError, OSError):
            return ""

    @property
    def command(self) -> list[str]:
        """The command that reads a job and writes a record."""
        if self.script.exists():
            return ["node", str(self.script)]
        return [sys.executable, str(HERE / "adapter.py"), self.name]

    def describe(self) -> dict[str, Any]:
        """What scores.json has of it."""
        known = asdict(self) | {"version": self.version, "step": self.step, "settings": self.settings}
        return {name: known[name] for name in ("title", "package", "version", "step", "model", "contact", "settings", "ours")}


class Run(NamedTuple):
    """An engine with settings on a motion with a time step [s]; `extra` runs are there for the limit of the hop only."""

    engine: Engine
    setting: str
    scenario: str
    dt: float
    extra: bool = False

    def head(self) -> dict[str, Any]:
        """Start of its row in scores.json."""
        return {"engine": self.engine.name, "setting": self.setting, "scenario": self.scenario, "dt": self.dt}


class Failure(Exception):
    """Reason for a run without scores."""


def engines() -> dict[str, Engine]:
    """Return all engines, installed or not."""
    text = (HERE / "engines.toml").read_text(encoding="utf-8")
    entries = tomllib.loads(text)
    needed = [one.name for one in fields(Engine) if one.default is MISSING and one.name != "name"]
    for name, entry in entries.items():
        if missing := [key for key in needed if key not in entry]:
            raise SystemExit(f"engines.toml: [{name}] needs {', '.join(missing)}.")
    return {name: Engine(name=name, **entry) for name, entry in entries.items()}


def record_of(command: Sequence[str], given: dict[str, Any], limit: float = LIMIT) -> Record:
    """Run a command on a job, with at most so much time [s]; its record, or a `Failure`."""
    surroundings = os.environ | {"HOPHOOP_KERNELS": "compiled"}  # interpreted kernels must not be timed
    try:
        done = subprocess.run(
            command, input=json.dumps(given), capture_output=True, encoding="utf-8", timeout=limit, env=surroundings
        )
    except subprocess.TimeoutExpired:
        raise Failure(f"it took more than {limit:g} s.") from None
    if done.returncode < 0:
        raise Failure("its process crashed.")
    if done.returncode:
        lines = [line for line in done.stderr.splitlines() if line.strip()] or ["it ended without a word."]
        named = [line for line in lines if re.match(r"[\w.]*(Error|Exception)\b.*: ", line)]
        raise Failure(re.sub(r"^[\w.]*(Error|Exception)\b.*?: ", "", (named or lines)[-1].strip())[:400])
    try:
        return read_record(done.stdout, "what it wrote")
    except ValueError as error:
        raise Failure(str(error)) from None


def reference_seconds(truth: Truth) -> float:
    """Wall time of hophoop on a motion, sampled as densely as a record: the fastest of six, compiled [s]."""
    given = job(truth.task, SPACING, {}) | {"runs": 6}
    return record_of(engines()["hophoop"].command, given).wall_seconds or 0.0


def runs_of(chosen: Sequence[Engine], scenarios: Sequence[str], steps: Sequence[float] = ()) -> Iterator[Run]:
    """Give the runs: each set of settings on each motion, and the hop over ten time steps, for the limits.

    Without given steps [s], the manual's settings run with the manual's step and with 1 ms, ours with 1 ms and 0.1 ms.
    """
    for one in chosen:
        for setting in one.settings:
            usual = (one.step, COMMON_STEP) if setting == "default" else (COMMON_STEP, FINE_STEP)
            own = list(dict.fromkeys(steps or usual))
            for name in scenarios:
                yield from (Run(one, setting, name, dt) for dt in own)
                if name == HOP and not steps and one.name != "hophoop":
                    yield from (Run(one, setting, name, dt, extra=True) for dt in LADDER if dt not in own)


def rows_of(runs: Sequence[Run], reference: dict[str, float], out: Path | None = None) -> Iterator[dict[str, Any]]:
    """Run all; give the rows of scores.json, in which a failure takes the place of scores."""
    pace: dict[tuple[str, str], float] = {}  # engine and setting → wall time per step of the run before
    for run in runs:
        truth = truths()[run.scenario]
        steps, key = truth.task.steps(run.dt), (run.engine.name, run.setting)
        expected = pace.get(key, 0.0) * steps
        wanted = run.scenario == HOP and not run.extra  # the one motion that every row should have
        if expected > (LIMIT if wanted else PATIENCE):
            if not run.extra:
                yield run.head() | {"failure": f"left out: it would take some {expected:.0f} s."}
            continue
        try:
            record = record_of(run.engine.command, job(truth.task, run.dt, run.engine.settings[run.setting]))
            scores, measures = score(record, truth)
        except (Failure, ValueError) as error:
            if str(error).startswith("it took more"):
                pace[key] = LIMIT / steps
            yield run.head() | {"failure": str(error)}
            continue
        if scores.wall_seconds and not run.engine.ours:  # dt is not a step there
            pace[key] = scores.wall_seconds / steps
        if out is not None and wanted and run.dt == COMMON_STEP:
            notes = record.notes | {"engine": run.engine.title, "scenario": run.scenario}
            (out / record_name(run.head())).write_text(record_text(replace(record, notes=notes)), encoding="utf-8")
        yield run.head() | {
            "scores": scores.to_dict(),
            "measures": asdict(measures),
            "relative_wall": _relative(scores, reference[run.scenario]),
        }


def _relative(scores: Scores, ours: float) -> float | None:
    return scores.wall_seconds / ours if scores.wall_seconds and ours else None


def document_of(chosen: Sequence[Engine], reference: dict[str, float], rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Return all that scores.json has: SI units and radians, angles of scores in degrees."""
    return {
        "benchmark": BENCHMARK,
        "made": date.today().isoformat(),
        "hophoop": version_of("hophoop"),
        "machine": {
            "python": platform.python_version(),
            "system": platform.system(),
            "processor": platform.machine(),
            "cores": os.cpu_count(),
        },
        "declaration": "The rows hophoop and compliant are by the authors of this benchmark.",
        "reference_seconds": reference,
        "engines": {one.name: one.describe() for one in chosen},
        "rows": rows,
        "limits": limits(rows),
    }


def json_text(document: dict[str, Any]) -> str:
    """Format JSON with one line per row, so that two of them can be compared by lines."""
    parts = []
    for key, value in document.items():
        if isinstance(value, list):
            lines = ",\n".join("  " + json.dumps(item, ensure_ascii=False, allow_nan=False) for item in value)
            parts.append(f" {json.dumps(key)}: [\n{lines}\n ]")
        else:
            parts.append(f" {json.dumps(key)}: {json.dumps(value, ensure_ascii=False, allow_nan=False)}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def installed(names: Sequence[str]) -> list[Engine]:
    """Return the installed ones of these engines, of all for none, and say how to install the others."""
    known = engines()
    chosen = [known[name] for name in names or known]
    for one in chosen:
        if not one.version:
            how = "npm install --prefix" if one.script.exists() else "pip install -r"
            print(f"{one.title} is not installed: {how} {HERE}{'' if one.script.exists() else '/requirements.txt'}")
    return [one for one in chosen if one.version]


def main(arguments: Sequence[str] | None = None) -> None:
    """Run what the arguments ask for; print a line per run."""
    parser = argparse.ArgumentParser(description="Run engines on the motions of the benchmark and score them.")
    parser.add_argument("engine", nargs="*", help=f"{', '.join(engines())}; by default all that are installed")
    parser.add_argument("--scenario", action="append", choices=list(truths()), help="a motion; may be repeated; by default all")
    parser.add_argument("--dt", action="append", type=float, default=[], help="time step instead of the usual ones [s]")
    parser.add_argument("--out", type=Path, metavar="DIR", help="folder for scores.json and the records of the hop")
    given = parser.parse_args(arguments)
    for name in given.engine:
        if name not in engines():
            parser.error(f"engine = {name!r} is not one of {', '.join(engines())}")
    if not all(0.0 < dt <= 0.1 for dt in given.dt):
        parser.error("--dt must be above 0 and at most 0.1 s")
    chosen = installed(given.engine)
    if not chosen:
        parser.exit(1)
    if given.out is not None:
        given.out.mkdir(parents=True, exist_ok=True)
    scenarios = given.scenario or list(truths())
    reference = {name: reference_seconds(truths()[name]) for name in scenarios}
    rows = []
    for row in rows_of(list(runs_of(chosen, scenarios, given.dt)), reference, given.out):
        rows.append(row)
        print(row_line(row), flush=True)
    if given.out is not None:
        (given.out / "scores.json").write_text(json_text(document_of(chosen, reference, rows)), encoding="utf-8")
        print(f"Written: {given.out / 'scores.json'}")


if __name__ == "__main__":
    main()
