"""Interactive scenes: an HTML page for any browser, without network."""

from __future__ import annotations

import base64
import html
import json
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from hophoop._support.files import replacing
from hophoop.animate.frames import Timing, clock, event_marks, extent, trace
from hophoop.animate.look import FORCE_LENGTH, TAGS, Look3D, labels_of, nice
from hophoop.animate.themes import theme_of
from hophoop.results.poses import Floats, load_distance, poses_of
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import EVENTS, FLIGHT, MODE_WORDS, WORDS

TRACE_POINTS = 4000
STATE = ("x", "height", "angle", "vx", "vy", "omega", "normal_force", "friction_force")


def scene(
    motions: Trajectory | Sequence[Trajectory],
    path: str | Path,
    timing: Timing = Timing(),
    look: Look3D = Look3D(),
) -> Path:
    """Write an interactive scene in 3D: a page for any browser, self-contained and without network.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
        Several run in lanes.
    path : str or Path
        Ends in .html.
    timing : Timing
        As in `film`.
    look : Look3D
        Theme, labels, traces and forces; the viewer chooses camera and size.

    Returns
    -------
    path : Path

    Raises
    ------
    ValueError
        If the settings do not fit the motions, or their slopes differ.
    """
    target = Path(path)
    if target.suffix.lower() != ".html":
        raise InputError.of_field("out", str(path), ".html", rule="must end in")
    several = (motions,) if isinstance(motions, Trajectory) else tuple(motions)
    data = scene_data(several, timing, look)
    with replacing(target) as part:
        part.write_bytes(page(data).encode("utf-8"))
    return target


def scene_data(
    motions: Sequence[Trajectory],
    timing: Timing,
    look: Look3D,
) -> dict[str, Any]:
    """Return the data of a scene, numbers and arrays.

    data: SI units; arrays have one row per frame.
    """
    shown = clock(motions, timing)
    slopes = {motion.scenario.plane.slope for motion in motions}
    if len(slopes) > 1:
        raise InputError.of_field("plane.slope", sorted(slopes), "the same in all motions of one scene")
    theme = theme_of(look.theme)
    names = labels_of(motions, look.labels)
    ends = [min(float(t[-1]), motion.duration) for t, motion in zip(shown.times, motions, strict=True)]
    extents = [extent(motion, timing.start, last) for motion, last in zip(motions, ends, strict=True)]
    radius = max(motion.scenario.hoop.radius for motion in motions)
    hoops: list[dict[str, Any]] = []
    for i, motion in enumerate(motions):
        hoop = motion.scenario.hoop
        times = shown.times[i]
        hoops.append({
            "label": names[i],
            "tag": TAGS[i % len(TAGS)] if len(motions) > 1 else "",
            "radius": hoop.radius,
            "eccentricity": hoop.eccentricity,
            "load": load_distance(hoop),
            "marks": [[one.t, one.along, one.kind, EVENTS[one.kind].noun] for one in event_marks(motion, times)],
            "frames": _columns(motion, times),
            "path": _path(motion, timing.start, ends[i]) if look.traces else None,
        })  # fmt: skip
    return {
        "fps": timing.frame_rate,
        "rate": shown.rate,
        "slope": slopes.pop(),
        "extent": {
            "left": min(size.along[0] for size in extents),
            "right": max(size.along[1] for size in extents),
            "speed": max(size.speed for size in extents) or 1.0,
        },
        "grid": nice(1.01 * radius),
        # length of the arrow of a force of 1 N [m]
        "newton": FORCE_LENGTH * radius / (max(size.force for size in extents) or 1.0) if look.forces else None,
        "flies": any(hoop["path"] is not None and MODE_WORDS.index(FLIGHT) in hoop["path"]["mode"] for hoop in hoops),
        "theme": {
            "paper": theme.background,
            "ground": theme.ground if look.theme != "print" else "#F1F1F1",
            "ink": theme.ink,
            "muted": theme.muted,
            "dark": theme.dark,
        },
        "colors": {
            "gravity_center": theme.visible(colors.GRAVITY_CENTER),
            "airborne": theme.visible(colors.GRAVITY_CENTER_AIRBORNE),
            "normal_force": theme.visible(colors.NORMAL_FORCE),
            "friction_force": theme.visible(colors.FRICTION_FORCE),
        },
        "modes": [[WORDS[word].participle, colors.mode_color(word)] for word in MODE_WORDS],
        "hoops": hoops,
    }


def _columns(motion: Trajectory, times: Floats) -> dict[str, Any]:
    """Return the states at times [s] in SI units; modes as indices into `MODE_WORDS`."""
    poses = poses_of(motion, times)
    columns: dict[str, Any] = {name: getattr(poses.sample, name) for name in STATE}
    columns["omega"] = np.nan_to_num(columns["omega"], posinf=0.0, neginf=0.0)
    codes = np.array([MODE_WORDS.index(str(word)) for word in poses.words])
    return {"t": poses.t, **columns, "mode": codes}


def _path(motion: Trajectory, start: float, end: float) -> dict[str, Any]:
    t = trace(motion, start, end).t
    keep = np.unique(np.linspace(0, len(t) - 1, min(len(t), TRACE_POINTS)).astype(int))
    columns = _columns(motion, t[keep])
    return {name: columns[name] for name in ("t", "x", "height", "angle", "mode")}


def page(data: dict[str, Any]) -> str:
    """Return the page of a scene: markup, program and data in one text.

    data: from `scene_data`.
    """
    static = files("hophoop.animate") / "static"
    title = html.escape("; ".join(hoop["label"] for hoop in data["hoops"]))
    text = (static / "scene.html").read_text(encoding="utf-8")
    program = (static / "scene.js").read_text(encoding="utf-8")
    # "</" would end the script
    packed = json.dumps(_pack(data), ensure_ascii=False).replace("</", "<\\/")
    for mark, content in (("TITLE", title), ("PROGRAM", program), ("DATA", packed)):
        text = text.replace(f"<!--{mark}-->", content).replace(f"/*{mark}*/", content)
    return text


def _pack(value: Any) -> Any:
    """Convert for JSON: arrays of floats as base64 of little-endian 32 bits, with their shape."""
    if isinstance(value, dict):
        return {key: _pack(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_pack(each) for each in value]
    if isinstance(value, np.ndarray):
        if value.dtype.kind == "f":
            raw = base64.b64encode(value.astype("<f4").tobytes()).decode("ascii")
            return {"f32": raw, "shape": list(value.shape)}
        return value.tolist()
    return value
