"""How programs and people write a table: the heads of each program, the words of each language, units."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from hophoop.tracking.table import COLUMNS


def _words(text: str, value: Any) -> dict[str, Any]:
    return dict.fromkeys(text.split("|"), value)


# --- programs --------------------------------------------------------------------------------------


class Dialect(NamedTuple):
    """How one program names its columns."""

    program: str
    known: str  # regular expression for its heads, divided by lines
    head: str  # regular expression for one head, with the groups name, point and run that it has
    names: str = ""  # of quantities that have another meaning elsewhere, as name=quantity


DIALECTS = (
    Dialect("Kinovea", r"/\d+/x$", r"(?P<point>.+)/\d+/(?P<name>[xy])"),
    Dialect("SLEAP", r"^frame_idx$", r"(?P<point>.+)\.(?P<name>[xy])"),
    Dialect("DeepLabCut", r"likelihood$", r"(?P<name>.+)", "coords=frame"),
    Dialect("TrackMate", r"^(track id|track_id)$", r"(?:position_)?(?P<name>.+)"),
    Dialect("Sensor Logger", r"^seconds_elapsed$", r"(?P<name>.+)", "time="),
    Dialect("Capstone", r"run #\d+$", r"(?P<name>.+?)\s(?P<run>\w+ #\d+)"),
    Dialect("Logger Pro, Vernier", r"^[^:()]+:\s*time", r"(?P<run>[^:()\[\]]*):\s*(?P<name>.+)"),
    Dialect("Video Analysis", r"^[^:()]+:", r"[^:()\[\]]*:\s*(?P<name>.+)"),
)

# --- words of heads, by language -------------------------------------------------------------------

# In lower case, without accents. Names of quantities are whole heads; words of points, gyroscopes and what is no position are
# parts of heads.
ENGLISH = {
    "t": "t|time|seconds elapsed|timestamp",
    "frame": "frame|frames|frame number|frame idx|image",
    "angle": "angle|theta|θ|φ|phi|rotation|rotation angle",
    "polar": "θr|thetar|theta r|θ r",
    "omega": "omega|ω|w|angular velocity|angular speed|angular rate|rotation rate|gyr",
    "object": "track|track id|object|object id|particle|id|instance|individual|bodypart|label|name",
    "centre": "cent|hub|axis|axle",
    "marker": "mark|load|weight|last|dot",
    "gyroscope": "gyro",
    "no position": "veloc|speed|acc|magn|gravi|force|quat|euler|attitude|field",
}
COMMA_LANGUAGES = {  # those with a decimal comma
    "German": {
        "t": "zeit", "frame": "bild|bildnummer", "angle": "winkel|drehwinkel",
        "omega": "winkelgeschwindigkeit|winkelgeschw|drehrate", "centre": "mitte|nabe|zentr", "marker": "gewicht",
        "no position": "geschwindigkeit|beschleunigung|kraft",
    },
    "French": {
        "t": "temps", "omega": "vitesse angulaire", "centre": "milieu|moyeu", "marker": "charge|poids|marque",
        "no position": "vitesse",
    },
    "Spanish": {
        "t": "tiempo", "frame": "imagen|fotograma", "angle": "angulo", "omega": "velocidad angular",
        "centre": r"centro|buje|eje\b", "marker": "carga|peso|marca", "gyroscope": "giroscopio", "no position": "acelera",
    },
    "Italian": {"t": "tempo", "angle": "angolo"},
    "Dutch": {"t": "tijd", "angle": "hoek"},
}  # fmt: skip
OTHERS = {"Chinese": {"t": "时间", "angle": "角度"}, "Arabic": {"t": "الزمن", "angle": "الزاوية"}}


def _said(kind: str) -> str:
    """Return the words of a kind in all languages, divided by lines."""
    languages = (ENGLISH, *COMMA_LANGUAGES.values(), *OTHERS.values())
    return "|".join(words[kind] for words in languages if kind in words)


NAMES: dict[str, str] = {
    **{word: name for name in ("t", "frame", "angle", "polar", "omega", "object") for word in _said(name).split("|")},
    **{name.replace("_", " "): name for name in COLUMNS if name.startswith("sigma") or "column" in name or "row" in name},
}
COMMA_WORDS = "|".join(words for language in COMMA_LANGUAGES.values() for words in language.values())
CENTRE, MARKER, NO_POSITION = _said("centre"), _said("marker"), _said("no position")
ROTATION = rf"{_said('gyroscope')}|\b(?:{_said('omega')})\b"

# --- units -----------------------------------------------------------------------------------------

DEGREE = float(np.pi / 180)
# In SI units and radians, by these; lengths and times may lack theirs.
UNITS: dict[str, dict[str, float]] = {
    "m": _words("|m|meter|meters|metre|metres|metro|metros", 1.0) | _words("mm|millimeter|millimeters|millimetre", 0.001)
    | _words("cm|centimeter|centimeters|centimetre|centimetres|zentimeter", 0.01) | _words("in|inch", 0.0254)
    | {"km": 1000.0, "ft": 0.3048, "um": 1e-6, "micron": 1e-6},
    "s": _words("|s|sec|secs|sek|second|seconds|sekunden|secondes|segundos", 1.0) | _words("ms|msec", 0.001)
    | {"us": 1e-6, "ns": 1e-9, "min": 60.0, "d": 86400.0},
    "rad": _words("rad|radian|radians|radianes", 1.0) | _words("deg|°|degree|degrees|grad|degre|degres|grados", DEGREE),
    "rad/s": _words("rad/s|rad/sec|1/s|s^-1", 1.0) | _words("deg/s|deg/sec|°/s|dps|degrees/s|grad/s", DEGREE)
    | {"rpm": float(np.pi / 30)},
}  # fmt: skip
SHOWN = {"m": "m, cm, mm, in and ft", "s": "s, ms, us, ns and min", "rad": "rad and deg", "rad/s": "rad/s, deg/s and rpm"}
PIXELS = ("px", "pixel", "pixels")
KNOWN_UNITS = {unit for units in UNITS.values() for unit in units if unit}.union(PIXELS)
KIND = {"frame": ""} | {name: unit if unit in UNITS else "" for name, (_, _, unit) in COLUMNS.items()}
