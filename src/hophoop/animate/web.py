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
from hophoop.animate.frames import Clock, Timing, clock, event_marks, extent, trace
from hophoop.animate.look import FORCE_LENGTH, LANE, LONGEST, TAGS, Look3D, labels_of, nice
from hophoop.animate.sheet import shades_of
from hophoop.animate.themes import theme_of
from hophoop.results.poses import Floats, load_distance, poses_of
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import EVENTS, FLIGHT, MODE_WORDS, WORDS

TRACE_POINTS = 4000


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
    ImportError
        If Matplotlib, for the colour map of the ring, is missing.
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
    shown: Clock = clock(motions, timing)
    slopes = {motion.scenario.plane.slope for motion in motions}
    if len(slopes) > 1:
        raise InputError.of_field("plane.slope", sorted(slopes), "the same in all motions of one scene")
    theme = theme_of(look.theme)
    names = labels_of(motions, look.labels)
    ends = [min(float(t[-1]), motion.duration) for t, motion in zip(shown.times, motions, strict=True)]
    extents = [extent(motion, timing.start, last) for motion, last in zip(motions, ends, strict=True)]
    radius = max(motion.scenario.hoop.radius for motion in motions)
    top = max(size.speed for size in extents) or 1.0
    force = max(size.force for size in extents) or 1.0
    hoops = []
    for i, motion in enumerate(motions):
        hoops.append(_hoop(motion, shown.times[i], names[i], LANE * radius * (i - 0.5 * (len(motions) - 1)), force))
        hoops[-1]["traces"] = _traces(motion, timing.start, ends[i]) if look.traces else None
        hoops[-1]["tag"] = TAGS[i % len(TAGS)] if len(motions) > 1 else ""
    return {
        "fps": timing.frame_rate,
        "count": shown.count,
        "rate": shown.rate,
        "slope": slopes.pop(),
        "radius": radius,
        "along": (min(size.along[0] for size in extents), max(size.along[1] for size in extents)),
        "height": max(size.height for size in extents),
        "grid": nice(1.01 * radius),
        "topSpeed": top,
        "newton": np.full(shown.count, FORCE_LENGTH * radius / force) if look.forces else None,
        "flies": any(hoop["traces"] is not None and hoop["traces"]["airborne"].any() for hoop in hoops),
        "map": np.rint(255.0 * shades_of(np.linspace(0.0, 1.0, 64), 1.0)[:, :3]).astype(int),
        "theme": {
            "background": theme.background,
            "ground": theme.ground if look.theme != "print" else "#F1F1F1",
            "ink": theme.ink,
            "muted": theme.muted,
            "load": theme.load,
            "dark": theme.dark,
        },
        "colors": {
            "center": theme.visible(colors.GRAVITY_CENTER),
            "airborne": theme.visible(colors.GRAVITY_CENTER_AIRBORNE),
            "normal": theme.visible(colors.NORMAL_FORCE),
            "friction": theme.visible(colors.FRICTION_FORCE),
        },
        "flight": MODE_WORDS.index(FLIGHT),
        "modes": [[WORDS[word].participle, colors.mode_color(word)] for word in MODE_WORDS],
        "hoops": hoops,
    }


def _hoop(motion: Trajectory, times: Floats, label: str, lane: float, most: float) -> dict[str, Any]:
    bound = LONGEST * most
    poses = poses_of(motion, times)
    hoop = motion.scenario.hoop
    return {
        "label": label,
        "lane": lane,
        "radius": hoop.radius,
        "load": load_distance(hoop),
        "heavy": hoop.eccentricity * hoop.radius,
        "marks": [[one.t, one.along, one.kind, EVENTS[one.kind].noun] for one in event_marks(motion, times)],
        "mode": [MODE_WORDS.index(str(word)) for word in poses.words],
        "t": poses.t,
        "center": poses.center,
        "contact": poses.contact,
        "angle": poses.angle,
        "velocity": poses.velocity,
        "omega": np.nan_to_num(poses.omega, posinf=0.0, neginf=0.0),
        "normalForce": np.clip(np.nan_to_num(poses.sample.normal_force, posinf=0.0), -bound, bound),
        "frictionForce": np.clip(np.nan_to_num(poses.sample.friction_force, posinf=0.0, neginf=0.0), -bound, bound),
    }


def _traces(motion: Trajectory, start: float, end: float) -> dict[str, Any]:
    track = trace(motion, start, end)
    airborne = np.zeros(len(track.t), dtype=np.uint8)
    for a, b, flies in track.runs:
        airborne[a:b] = flies
    keep = np.unique(np.linspace(0, len(track.t) - 1, min(len(track.t), TRACE_POINTS)).astype(int))
    return {
        "t": track.t[keep],
        "load": track.load[keep],
        "heavy": track.gravity_center[keep],
        "airborne": airborne[keep],
    }


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
