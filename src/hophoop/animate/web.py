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
from hophoop.animate.frames import Timing, common_slope, subject_of
from hophoop.animate.look import FORCE_LENGTH, Look3D, nice
from hophoop.animate.themes import THEMES
from hophoop.results.poses import Floats, load_distance, poses_of
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import EVENTS, MODE_WORDS, WORDS

TRACE_POINTS = 4000
PATH = ("t", "x", "height", "angle", "mode")
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
    subject, slope, theme = subject_of(motions, timing, look.labels), common_slope(motions), THEMES[look.theme]
    whole, radius = subject.whole, max(motion.scenario.hoop.radius for motion in motions)
    hoops = [
        {
            "label": subject.labels[i],
            "tag": subject.tag(i) if len(motions) > 1 else "",
            "radius": motion.scenario.hoop.radius,
            "eccentricity": motion.scenario.hoop.eccentricity,
            "load": load_distance(motion.scenario.hoop),
            "marks": [[one.t, one.along, one.kind, EVENTS[one.kind].noun] for one in subject.marks[i]],
            "frames": _columns(motion, subject.clock.times[i], ("t", *STATE, "mode")),
            "path": _columns(motion, _thinned(subject.traces[i].t), PATH) if look.traces else None,
        }
        for i, motion in enumerate(motions)
    ]
    return {
        "fps": timing.frame_rate,
        "rate": subject.clock.rate,
        "slope": slope,
        "extent": {"left": whole.along[0], "right": whole.along[1], "speed": whole.speed},
        "grid": nice(1.01 * radius),
        # length of the arrow of a force of 1 N [m]
        "newton": FORCE_LENGTH * radius / whole.force if look.forces else None,
        "flies": look.traces and any(bool(track.airborne.any()) for track in subject.traces),
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


def _columns(motion: Trajectory, times: Floats, names: Sequence[str]) -> dict[str, Any]:
    """Return quantities at times [s] in SI units; modes as indices into `MODE_WORDS`."""
    poses = poses_of(motion, times)
    columns = {name: getattr(poses.sample, name) for name in STATE}
    columns["omega"] = np.nan_to_num(columns["omega"], posinf=0.0, neginf=0.0)
    columns |= {"t": poses.t, "mode": np.array([MODE_WORDS.index(str(word)) for word in poses.words])}
    return {name: columns[name] for name in names}


def _thinned(t: Floats) -> Floats:
    thinned: Floats = t[np.unique(np.linspace(0, len(t) - 1, min(len(t), TRACE_POINTS)).astype(int))]
    return thinned


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
