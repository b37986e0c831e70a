"""How fast a film is tracked: 1280 × 720, 240 frames, all of `hophoop.track` from opening the file to the table."""

import os
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

import hophoop as hh
from film_maker import Film, article_like, make
from hophoop.tracking import Hints

FILM = Film(size=(1280, 720), scale=330.0, origin=(120.0, 600.0), focal=1150.0, frames=240, marker_size=0.04, busy=True)
TARGET = 30.0  # frames a second

if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        path = make(Path(folder) / "film.mp4", article_like(), FILM)
        wall, work = [], []
        for _ in range(4):
            begin, busy = time.perf_counter(), time.process_time()
            track = hh.track(path, 0.3, Hints(exposure=FILM.shutter))
            wall.append(time.perf_counter() - begin)
            work.append(time.process_time() - busy)
    best, least = FILM.frames / min(wall[1:]), FILM.frames / min(work[1:])
    print(f"{track!r} on {os.cpu_count()} cores:")
    print(f"{best:.0f} frames/s (target {TARGET:.0f}); {least:.0f} a second of processor time")
    sys.exit(best < TARGET)
