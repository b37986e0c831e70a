"""The comparison as tables of text, for the terminal, the page and the documentation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from hophoop.engines.comparing import COMMON_STEP, FINE_STEP, LADDER_SCENARIO, Comparison, Row
from hophoop.engines.registry import Engine
from hophoop.engines.scenarios import bench_scenarios
from hophoop.engines.scores import Scores


@dataclass(frozen=True)
class Column:
    """One column: its head, the field of `Scores`, and the format of its numbers."""

    head: str
    field: str
    scale: float = 1.0
    digits: int = 3
    signed: bool = True


COLUMNS = (
    Column("take-off (°)", "takeoff_angle"),
    Column("take-off (ms)", "takeoff_time", 1e3),
    Column("hop (mm)", "hop_height", 1e3),
    Column("landing (°)", "landing_angle"),
    Column("drift (mJ)", "energy_drift", 1e3, signed=False),
    Column("loss in slip (mJ)", "slip_loss", 1e3),
    Column("in impact (mJ)", "impact_loss", 1e3),
    Column("in all (mJ)", "total_loss", 1e3),
    Column("depth (mm)", "penetration", 1e3, signed=False),
    Column("θ at most (°)", "angle_error", signed=False),
    Column("place at most (mm)", "place_error", 1e3, signed=False),
    Column("chatter", "chatter", signed=False),
    Column("steps", "steps", signed=False),
)


def number(value: Any, column: Column) -> str:
    """Format a number of a column with two significant digits.

    Parameters
    ----------
    value : float, int or None
    column : Column

    Returns
    -------
    text : str
    """
    if value is None:
        return "–"
    if isinstance(value, int):
        return str(value)
    if math.isnan(value):
        return "none"
    scaled = value * column.scale
    if abs(scaled) < 5e-4:
        return "0"
    text = f"{scaled:+.2g}" if column.signed else f"{scaled:.2g}"
    if "e" in text or abs(scaled) >= 100:
        text = f"{scaled:+,.0f}" if column.signed else f"{scaled:,.0f}"
    return text.replace("-", "−")


def relative(row: Row) -> str:
    """Wall time in units of ours."""
    if row.relative_wall is None:
        return "–"
    return f"{row.relative_wall:.2g}" if row.relative_wall < 100 else f"{row.relative_wall:,.0f}"


def heads() -> list[str]:
    """Heads of the full table."""
    return [
        "engine", "settings", "step (ms)", "sequence", *(column.head for column in COLUMNS), "wall (s)", "wall ÷ ours",
    ]  # fmt: skip


def cells(comparison: Comparison, row: Row) -> list[str]:
    """Return one row of the full table.

    Parameters
    ----------
    comparison : Comparison
    row : Row

    Returns
    -------
    cells : list of str
    """
    one = comparison.engines[row.engine]
    start = [one.title, row.setting, f"{1e3 * row.dt:.4g}"]
    if row.failure:
        return [*start, row.failure, *[""] * (len(COLUMNS) + 2)]
    assert row.scores is not None
    assert row.measures is not None
    sequence = f"{row.measures.sequence} ✓" if row.scores.sequence_right else row.measures.sequence
    wall = row.scores.wall_seconds
    return [
        *start,
        sequence,
        *(number(getattr(row.scores, column.field), column) for column in COLUMNS),
        "–" if wall is None else f"{wall:.2g}",
        relative(row),
    ]


def scenario_rows(comparison: Comparison, scenario: str) -> list[Row]:
    """Return the rows of one motion, without those of the ladder only.

    Parameters
    ----------
    comparison : Comparison
    scenario : str

    Returns
    -------
    rows : list of Row
    """
    found = [row for row in comparison.rows if row.scenario == scenario]
    if scenario != LADDER_SCENARIO:
        return found
    common = {COMMON_STEP, FINE_STEP}
    usual = {name: {one.step, *common} for name, one in comparison.engines.items()}
    kept = [row for row in found if row.dt in usual[row.engine]]
    return kept or found


def summary(comparison: Comparison) -> tuple[list[str], list[list[str]]]:
    """Return the short table: correct sequences, the hop, its limit and order, and its cost.

    Parameters
    ----------
    comparison : Comparison

    Returns
    -------
    heads : list of str
    rows : list of list of str
    """
    scored = [name for name, bench in bench_scenarios().items() if bench.scored]
    head = [
        "engine", "version", "settings", "step (ms)", "right", "take-off (°)", "hop (mm)", "θ (°)", "limit (mm)", "order",
        "÷ ours",
    ]  # fmt: skip
    lines = []
    for name, one in comparison.engines.items():
        for setting in one.settings:
            for dt in _steps(comparison, name, setting):
                rows = [row for row in comparison.rows if (row.engine, row.setting, row.dt) == (name, setting, dt)]
                right = {row.scenario: row for row in rows if row.scenario in scored}
                hop = right.get(LADDER_SCENARIO)
                lines.append(_summary_line(comparison, one, setting, dt, right, hop))
    return head, lines


def _steps(comparison: Comparison, name: str, setting: str) -> list[float]:
    counts: dict[float, int] = {}
    for row in comparison.rows:
        if (row.engine, row.setting) == (name, setting):
            counts[row.dt] = counts.get(row.dt, 0) + 1
    most = max(counts.values(), default=0)
    return sorted((dt for dt, count in counts.items() if count == most), reverse=True)


def _summary_line(
    comparison: Comparison, one: Engine, setting: str, dt: float, right: dict[str, Row], hop: Row | None
) -> list[str]:
    start = [one.title, one.version or "–", setting, f"{1e3 * dt:.3g}"]
    done = [row for row in right.values() if row.scores is not None]
    if not done:
        why = next((row.failure for row in right.values()), "not run")
        return [*start, why, *[""] * 6]
    good = sum(row.scores.sequence_right for row in done if row.scores)
    ran = f"{good}/{len(right)}" if len(done) == len(right) else f"{good}/{len(done)} run"
    scores: Scores | None = hop.scores if hop is not None else None
    limit = comparison.limit(one.name, setting, "hop_height")
    truth = 1e3 * _true_hop()
    hop_cells = ["–"] * 3
    if scores is not None:
        hop_cells = [
            number(scores.takeoff_angle, COLUMNS[0]),
            number(scores.hop_height, COLUMNS[2]),
            number(scores.angle_error, COLUMNS[9]),
        ]
    shown = "–" if limit is None else number(limit.limit - truth / 1e3, COLUMNS[2])
    order = "–" if limit is None else "none" if limit.order is None else f"{limit.order:.1f}"
    if limit is not None and limit.order is None and limit.scatter > 1e-4:
        shown += f" ± {float(f'{1e3 * limit.scatter:.1g}'):g}"
    if one.ours or one.name == "scipy":
        order = "–"
    return [*start, ran, *hop_cells, shown, order, relative(hop) if hop is not None else "–"]


def _true_hop() -> float:
    from hophoop.engines.truth import truths

    height = truths()[LADDER_SCENARIO].measures.hop_height
    assert height is not None
    return height


def compact(head: Sequence[str], rows: Sequence[Sequence[str]]) -> tuple[list[str], list[list[str]]]:
    """Return the short table for a narrow page: engine and version once, settings and step in one column.

    Parameters
    ----------
    head : sequence of str
        Heads of `summary`.
    rows : sequence of sequence of str

    Returns
    -------
    head : list of str
    rows : list of list of str
    """
    lines, before = [], ""
    for title, version, setting, step, *rest in rows:
        name = title if version == "–" or "(ours)" in title else f"{title} {version}"
        name = name.replace("Box2D 2.3 2.3", "Box2D 2.3")
        lines.append([name if title != before else "", f"{setting}, {step}\u00a0ms", *rest])
        before = title
    return [head[0], "settings, step", *head[4:]], lines


def markdown(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Format a table as Markdown.

    Parameters
    ----------
    head : sequence of str
    rows : sequence of sequence of str

    Returns
    -------
    text : str
    """
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def settings_words(one: Engine) -> str:
    """Describe all settings of an engine.

    Parameters
    ----------
    one : Engine

    Returns
    -------
    text : str
    """
    parts = []
    for name, values in one.settings.items():
        listed = ", ".join(f"{key} = {value}" for key, value in values.items()) or "as the engine has them"
        parts.append(f"{name}: {listed}")
    return "; ".join(parts)
