"""How programs and people write a table: the heads of each program, the names of quantities in six languages, units."""

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

# --- quantities ------------------------------------------------------------------------------------

# Words of heads in lower case, without accents, for quantities that have no direction.
NAMES: dict[str, str] = {
    **_words("t|time|zeit|temps|tiempo|tempo|tijd|seconds elapsed|timestamp|时间|الزمن", "t"),
    **_words("frame|frames|frame number|frame idx|bild|bildnummer|image|imagen|fotograma", "frame"),
    **_words("angle|theta|θ|φ|phi|rotation|winkel|drehwinkel|angulo|angolo|hoek|rotation angle|角度|الزاوية", "angle"),
    **_words("θr|thetar|theta r|θ r", "polar"),
    **_words("omega|ω|w|winkelgeschwindigkeit|vitesse angulaire|velocidad angular|angular velocity|drehrate", "omega"),
    **_words("track|track id|object|object id|particle|id|instance|individual|bodypart|label|name", "object"),
    **{name.replace("_", " "): name for name in COLUMNS if name.startswith("sigma") or "column" in name or "row" in name},
}
ROTATION = r"gyro|gyr\b|giroscopio|rotation rate|drehrate|angular (velocity|speed|rate)|winkelgeschw|^[wω]$"
# Columns with a direction that are no positions.
NO_PLACE = r"veloc|speed|acc|acelera|geschwindigkeit|beschleunigung|vitesse|magn|gravi|force|kraft|quat|euler|attitude|field"
# Heads in languages whose decimal sign is a comma.
COMMA_WORDS = r"zeit|winkel|mitte|nabe|gewicht|bild|temps|moyeu|charge|tiempo|centro|buje|carga|angulo|tempo|tijd|hoek"
CENTRE = r"cent|mitte|hub|nabe|axis|axle|zentr|milieu|moyeu|buje|eje"
MARKER = r"mark|load|weight|last|gewicht|dot|charge|carga|poids|peso|marque|marca"

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
