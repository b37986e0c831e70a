"""The sample film: a hoop that is rendered, not filmed, so that its truth is known; with its track.

Usage: python examples/sample_film.py [FOLDER]   (default: examples/film; needs the extra 'track')
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests"))

import hophoop as hh  # noqa: E402
from film_maker import Film, make  # noqa: E402
from hophoop.tracking import Hints  # noqa: E402

HOOP = hh.Hoop.ideal(0.6, radius=0.3, mass=1.0)
PLANE = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)
START, DURATION, SHUTTER = hh.Start.rolling(1.9, angle=0.1), 1.3, 1 / 2000
# as by a phone on a tripod, square to the plane of motion, at 240 frames a second
FILM = Film(
    size=(960, 400), scale=290.0, origin=(130.0, 350.0), frames=264, shutter=SHUTTER, focal=1100.0,
    row_delay=8e-6, noise=2.5, busy=True, crf=24,
)  # fmt: skip
HINTS = Hints(exposure=SHUTTER, row_delay=FILM.row_delay, slope=0.0)


def main(folder: Path) -> None:
    """Write film, track and truth."""
    folder.mkdir(parents=True, exist_ok=True)
    motion = hh.simulate(HOOP, PLANE, START, duration=DURATION)
    motion.scenario.save(folder / "truth.toml")
    make(folder / "hoop.mp4", motion, FILM)
    track = hh.track(folder / "hoop.mp4", radius=HOOP.radius, hints=HINTS)
    track.save(folder / "track.json")
    print(motion.sequence, track.notes, (folder / "hoop.mp4").stat().st_size)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "examples" / "film")
