"""Compare engines on the same motions; a failed run is a row with its reason."""

from __future__ import annotations

import os
import platform
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import date
from typing import Any, NamedTuple

from hophoop._version import __version__
from hophoop.engines.conventions import check_rates
from hophoop.engines.limits import Limit, limit_of
from hophoop.engines.measures import Measures
from hophoop.engines.recording import Recording
from hophoop.engines.registry import Engine, engine
from hophoop.engines.scenarios import BENCHMARK, BenchScenario
from hophoop.engines.scores import Scores, score
from hophoop.engines.task import SPACING, States
from hophoop.engines.truth import Truth, truths
from hophoop.engines.worker import Worker, run_here
from hophoop.kernel.native import forced
from hophoop.scenario import InputError

COMMON_STEP, FINE_STEP = 0.001, 0.0001
LADDER = (0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002, 0.0001, 0.00005, 0.00002, 0.00001)
LADDER_SCENARIO = "hop"
PATIENCE = 8.0  # s; longer runs, as estimated from the one before, are left out
LIMIT = 120.0  # s per run
FITTED = {"hop_height": "m", "takeoff_angle": "rad"}

Progress = Callable[[str, int, int], None]


class Job(NamedTuple):
    """One run: an engine with a set of settings on a motion with a time step [s]."""

    engine: Engine
    setting: str
    bench: BenchScenario
    dt: float
    ladder: bool = False


@dataclass(frozen=True)
class Row:
    """Result of one run.

    Attributes
    ----------
    engine, setting, scenario : str
    dt : float
        [s].
    failure : str
        Reason for missing scores; empty otherwise.
    scores : Scores or None
    measures : Measures or None
    states : States or None
        The record.
    relative_wall : float or None
        Wall time over that of hophoop on the same motion in the same comparison [1].
    """

    engine: str
    setting: str
    scenario: str
    dt: float
    failure: str = ""
    scores: Scores | None = None
    measures: Measures | None = None
    states: States | None = None
    relative_wall: float | None = None


@dataclass(frozen=True)
class Comparison:
    """All rows of one comparison.

    Attributes
    ----------
    engines : dict of str to Engine
    rows : tuple of Row
    reference_seconds : dict of str to float
        Wall time of hophoop on each motion, sampled at 2048 Hz [s].
    made : str
        Date.
    """

    engines: Mapping[str, Engine]
    rows: tuple[Row, ...]
    reference_seconds: Mapping[str, float]
    made: str = field(default_factory=lambda: date.today().isoformat())

    def row(self, engine: str, setting: str, scenario: str, dt: float) -> Row | None:
        """Return one row.

        Parameters
        ----------
        engine, setting, scenario : str
        dt : float
            [s].

        Returns
        -------
        row : Row or None
        """
        same = (r for r in self.rows if (r.engine, r.setting, r.scenario, r.dt) == (engine, setting, scenario, dt))
        return next(same, None)

    def ladder(self, engine: str, setting: str, scenario: str = LADDER_SCENARIO) -> list[Row]:
        """Return the rows of an engine with scores, from coarse to fine time steps.

        Parameters
        ----------
        engine, setting, scenario : str

        Returns
        -------
        rows : list of Row
        """
        found = [r for r in self.rows if (r.engine, r.setting, r.scenario) == (engine, setting, scenario) and r.scores]
        return sorted(found, key=lambda row: -row.dt)

    def limit(self, engine: str, setting: str, quantity: str) -> Limit | None:
        """Return the limit of a measure of the hop as the time step goes to 0.

        Parameters
        ----------
        engine, setting : str
        quantity : str
            A field of `Measures`.

        Returns
        -------
        limit : Limit or None
            In the unit of the measure; None for fewer than four time steps.
        """
        rows = self.ladder(engine, setting)
        values = [getattr(row.measures, quantity) for row in rows]
        return limit_of([row.dt for row in rows], [float("nan") if value is None else value for value in values])

    def to_dict(self) -> dict[str, Any]:
        """Convert to a dictionary for JSON, without the records.

        Returns
        -------
        comparison : dict
            SI units and radians, angles of scores in degrees.
        """
        return {
            "benchmark": BENCHMARK,
            "made": self.made,
            "hophoop": __version__,
            "machine": {
                "python": platform.python_version(),
                "system": platform.system(),
                "processor": platform.machine(),
                "cores": os.cpu_count(),
            },
            "declaration": "The rows hophoop and compliant are by the authors of this benchmark.",
            "reference_seconds": dict(self.reference_seconds),
            "engines": {
                name: {
                    "title": one.title, "package": one.package, "version": one.version, "step": one.step,
                    "model": one.model, "contact": one.contact, "settings": {k: dict(v) for k, v in one.settings.items()},
                    "ours": one.ours,
                }
                for name, one in self.engines.items()
            },
            "rows": [_row_dict(row) for row in self.rows],
            "limits": list(self._limits()),
        }  # fmt: skip

    def _limits(self) -> Iterator[dict[str, Any]]:
        truth = truths()[LADDER_SCENARIO].measures
        for name, one in self.engines.items():
            for setting in one.settings:
                for quantity, unit in FITTED.items():
                    found = self.limit(name, setting, quantity)
                    if found is not None:
                        error = found.limit - getattr(truth, quantity)
                        yield {
                            "engine": name, "setting": setting, "scenario": LADDER_SCENARIO, "quantity": quantity,
                            "unit": unit, "limit": found.limit, "error": error, "order": found.order, "scatter": found.scatter,
                        }  # fmt: skip


def _row_dict(row: Row) -> dict[str, Any]:
    head: dict[str, Any] = {"engine": row.engine, "setting": row.setting, "scenario": row.scenario, "dt": row.dt}
    if row.failure:
        return head | {"failure": row.failure}
    assert row.scores is not None
    assert row.measures is not None
    return head | {
        "scores": row.scores.to_dict(),
        "measures": row.measures.to_dict(),
        "relative_wall": row.relative_wall,
    }


def jobs_of(
    chosen: Sequence[Engine], scenarios: Sequence[BenchScenario], steps: Sequence[float] | None, ladder: bool
) -> list[Job]:
    """Return the runs: each set of settings on each motion, and the ladder of time steps on the hop.

    Without given steps, the manual's settings run with the manual's step and with 1 ms, the others with 1 ms and 0.1 ms.

    Parameters
    ----------
    chosen : sequence of Engine
    scenarios : sequence of BenchScenario
    steps : sequence of float or None
        Time steps [s].
    ladder : bool
        Whether to run the hop over the whole ladder.

    Returns
    -------
    jobs : list of Job
    """
    jobs = []
    for one in chosen:
        for place, setting in enumerate(one.settings):
            for bench in scenarios:
                usual = (one.step, COMMON_STEP) if place == 0 else (COMMON_STEP, FINE_STEP)
                own = list(dict.fromkeys(steps or usual))
                jobs += [Job(one, setting, bench, dt) for dt in own]
                if ladder and bench.name == LADDER_SCENARIO and steps is None and one.name != "hophoop":
                    jobs += [Job(one, setting, bench, dt, True) for dt in LADDER if dt not in own]
    return jobs


def compare(
    chosen: Sequence[Engine],
    scenarios: Sequence[BenchScenario],
    steps: Sequence[float] | None = None,
    ladder: bool = True,
    progress: Progress | None = None,
) -> Comparison:
    """Run engines on motions of the benchmark and score them.

    Parameters
    ----------
    chosen : sequence of Engine
    scenarios : sequence of BenchScenario
    steps : sequence of float, optional
        Time steps instead of the usual ones [s].
    ladder : bool, default True
        Whether to run the hop with ten time steps, to fit the limits.
    progress : callable, optional
        Called with the present run, the number of runs done and of all.

    Returns
    -------
    comparison : Comparison
    """
    known = truths()
    seconds = {bench.name: reference_seconds(known[bench.name]) for bench in scenarios}
    jobs = jobs_of(chosen, scenarios, steps, ladder)
    rows: list[Row] = []
    names: dict[str, Engine] = {one.name: one for one in chosen}
    worker: Worker | None = None
    pace: dict[tuple[str, str], float] = {}  # engine and setting → wall time per step of the run before
    for count, job in enumerate(jobs):
        if progress is not None:
            progress(f"{job.engine.title} · {job.setting} · {job.bench.name} · {job.dt:g} s", count, len(jobs))
        if worker is None or worker.engine.name != job.engine.name:
            if worker is not None:
                worker.close()
            worker = Worker(job.engine)
        key, truth = (job.engine.name, job.setting), known[job.bench.name]
        expected = pace.get(key, 0.0) * truth.task.steps(job.dt)
        hop = job.bench.name == LADDER_SCENARIO and not job.ladder  # the one motion that every row should have
        if expected > (LIMIT if hop else PATIENCE):
            if not job.ladder:
                head = (job.engine.name, job.setting, job.bench.name, job.dt)
                rows.append(Row(*head, failure=f"left out: it would take some {expected:.0f} s."))
            continue
        row, version = _run(worker, job, truth, seconds[job.bench.name])
        rows.append(row)
        if row.scores is not None and row.scores.wall_seconds is not None and not _adaptive(job.engine):
            pace[key] = row.scores.wall_seconds / truth.task.steps(job.dt)
        elif row.failure.startswith("it took more"):
            pace[key] = LIMIT / truth.task.steps(job.dt)
        if version and not job.engine.version:
            names[job.engine.name] = _with_version(names[job.engine.name], version)
    if worker is not None:
        worker.close()
    if progress is not None:
        progress("done", len(jobs), len(jobs))
    return Comparison(names, tuple(rows), seconds)


def _run(worker: Worker, job: Job, truth: Truth, ours: float) -> tuple[Row, str]:
    head = (job.engine.name, job.setting, job.bench.name, job.dt)
    try:
        record = worker.run(truth.task, job.dt, job.engine.settings[job.setting], LIMIT)
        found, measures = score(record, truth)
    except (RuntimeError, InputError) as error:
        return Row(*head, failure=str(error)), ""
    wall = None if record.wall_seconds is None else record.wall_seconds / ours
    return Row(*head, "", found, measures, record.states, wall), record.notes.get("version", "")


def _adaptive(one: Engine) -> bool:
    return one.ours  # dt is not a step there


def _with_version(one: Engine, version: str) -> Engine:
    return replace(one, version=version)


def reference_seconds(truth: Truth) -> float:
    """Measure the wall time of hophoop on a motion, sampled as densely as a record: the fastest of five, compiled.

    Parameters
    ----------
    truth : Truth

    Returns
    -------
    seconds : float
        [s].
    """
    ours = engine("hophoop")
    with forced("compiled"):
        walls = [run_here(ours, truth.task, SPACING, {}).wall_seconds or 0.0 for _ in range(6)]
    return min(walls[1:])


def score_file(recording: Recording, scenario: str | None = None) -> tuple[str, Scores, Measures]:
    """Score a record without any engine.

    Parameters
    ----------
    recording : Recording
    scenario : str, optional
        Name of the motion, if the file has no line ``# scenario: name``.

    Returns
    -------
    scenario : str
    scores : Scores
    measures : Measures

    Raises
    ------
    ValueError
        If the motion is not named or unknown, the record is invalid, or its columns and their rates disagree.
    """
    name = scenario or recording.notes.get("scenario", "")
    if name not in truths():
        raise InputError.of_field("scenario", name, ", ".join(truths()), rule="is not one of")
    found, measures = score(recording, truths()[name])
    check_rates(recording.states)
    return name, found, measures
