"""How programs and people write a table: the heads of each program, the words of each language, units."""

from __future__ import annotations

import numpy as np

from hophoop.tracking.table import COLUMNS

# --- programs --------------------------------------------------------------------------------------

HEADS = (  # parts of the heads of programs; a group is a run
    r"(?P<point>.+)/\d+/(?P<name>[xy])",  # Kinovea
    r"(?P<point>.+)\.(?P<name>[xy])",  # SLEAP
    r"position_(?P<name>.+)",  # TrackMate
    r"(?P<name>.+?)\s(?P<group>\w+ #\d+)",  # Capstone
    r"(?P<group>[^:()\[\]]*):\s*(?P<name>.+)",  # Logger Pro, Vernier
)

# --- words of heads, by language -------------------------------------------------------------------

# In lower case, without accents. Names of quantities are whole heads; words of points, gyroscopes and what is no position are
# parts of heads.
ENGLISH = {
    "t": "t|time|ms|millis|seconds elapsed|timestamp",
    "frame": "frame|frames|frame number|frame idx|image|picture|coords|slice n",
    "angle": "angle|theta|θ|φ|phi|rotation|rotation angle",
    "polar": "θr|thetar|theta r|θ r",
    "omega": "omega|ω|w|angular velocity|angular speed|angular rate|rotation rate|gyr",
    "object": "track|track id|track n|object|object id|particle|id|instance|individual|bodypart|label|name",
    "centre": "cent|hub|axis|axle",
    "marker": "mark|load|weight|last|dot|sticker|tape",
    "gyroscope": "gyro",
    "no position": "veloc|speed|acc|magn|gravi|force|quat|euler|attitude|field",
}
COMMA_LANGUAGES = {  # those with a decimal comma
    "German": {
        "t": "zeit", "frame": "bild|bildnummer", "angle": "winkel|drehwinkel",
        "omega": "winkelgeschwindigkeit|winkelgeschw|drehrate", "centre": "mitte|nabe|zentr", "marker": "gewicht|klebe",
        "no position": "geschwindigkeit|beschleunigung|kraft",
    },
    "French": {
        "t": "temps", "omega": "vitesse angulaire", "centre": "milieu|moyeu", "marker": "charge|poids|marque|gommette",
        "no position": "vitesse",
    },
    "Spanish": {
        "t": "tiempo", "frame": "imagen|fotograma", "angle": "angulo", "omega": "velocidad angular",
        "centre": r"centro|buje|eje\b", "marker": "carga|peso|marca|pegatina", "gyroscope": "giroscopio",
        "no position": "acelera",
    },
    "Italian": {"t": "tempo", "angle": "angolo"},
    "Dutch": {"t": "tijd", "angle": "hoek"},
}  # fmt: skip
OTHERS = {"Chinese": {"t": "时间", "angle": "角度"}, "Arabic": {"t": "الزمن", "angle": "الزاوية"}}


def _said(kind: str) -> str:
    """Return the words of a kind in all languages, divided by lines."""
    languages = (ENGLISH, *COMMA_LANGUAGES.values(), *OTHERS.values())
    return "|".join(words[kind] for words in languages if kind in words)


NAMES = {name: _said(name) for name in ("t", "frame", "angle", "polar", "omega", "object")} | {
    name: name.replace("_", " ") for name in COLUMNS if name.startswith("sigma") or "column" in name or "row" in name
}
COMMA_WORDS = "|".join(words for language in COMMA_LANGUAGES.values() for words in language.values())
CENTRE, MARKER, NO_POSITION = _said("centre"), _said("marker"), _said("no position") + "|^[gwω]$"
ROTATION = rf"{_said('gyroscope')}|^g$|\b(?:{_said('omega')})\b"

# --- units -----------------------------------------------------------------------------------------

DEGREE = float(np.pi / 180)
# In SI units and radians, by these; lengths and times may lack theirs.
UNITS: dict[str, dict[str, float]] = {
    kind: {word: size for words, size in sizes.items() for word in words.split("|")}
    for kind, sizes in {
        "m": {
            "|m|meter|meters|metre|metres|metro|metros": 1.0, "mm|millimeter|millimeters|millimetre": 0.001,
            "cm|centimeter|centimeters|centimetre|centimetres|zentimeter": 0.01, "in|inch": 0.0254,
            "km": 1000.0, "ft": 0.3048, "um|micron": 1e-6,
        },
        "s": {
            "|s|sec|secs|sek|second|seconds|sekunden|secondes|segundos": 1.0, "ms|msec": 0.001, "us": 1e-6, "ns": 1e-9,
            "min": 60.0, "d": 86400.0,
        },
        "rad": {
            "rad|radian|radians|radianes": 1.0, "deg|°|degree|degrees|grad|degre|degres|grados": DEGREE,
            "rev|revs|revolution|revolutions|turn|turns|umdrehung|umdrehungen": float(2.0 * np.pi),
        },
        "rad/s": {"rad/s|rad/sec|1/s|s^-1": 1.0, "deg/s|deg/sec|°/s|dps|degrees/s|grad/s": DEGREE, "rpm": float(np.pi / 30)},
    }.items()
}  # fmt: skip
SHOWN = {"m": "m, cm, mm, in and ft", "s": "s, ms, us, ns and min", "rad": "rad, deg and rev", "rad/s": "rad/s, deg/s and rpm"}
PIXELS = ("px", "pixel", "pixels")
KNOWN_UNITS = {unit for units in UNITS.values() for unit in units if unit}.union(PIXELS)
OTHER_UNITS = KNOWN_UNITS - UNITS["m"].keys() - {*PIXELS}  # than those of lengths
KIND = {"frame": ""} | {name: unit if unit in UNITS else "" for name, (_, _, unit) in COLUMNS.items()}
