"""Pictures a second of films: drawn alone, and drawn and encoded, in 2D and 3D. `python benchmarks/films.py [--json]`.

The target is 60 pictures a second of finished film in 2D at 1280 × 720 on two cores. A film takes two processes,
the painter and the encoder; beside the time on the clock stands what each of them took of a core, since the clock
also counts what else the machine does.
"""

import argparse
import json
import os
import tempfile
import time
from pathlib import Path

import hophoop as hh
from hophoop.animate.export import write
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look
from hophoop.animate.mpl import Film2D
from hophoop.animate.scene3d import Film3D, Look3D

PANELS = ("velocity", "energy", "utilization", "phase")


class Drawn:
    """A film of which only the first pictures are made."""

    def __init__(self, pictures, count):
        self._pictures, self.count = pictures, min(count, pictures.count)
        self.size, self.fps, self.draw = pictures.size, pictures.fps, pictures.draw


def measured(pictures, kind, folder):
    """Seconds on the clock and of the cores for a film, or for its pictures alone."""
    wall, before = time.perf_counter(), os.times()
    if kind is None:
        for k in range(pictures.count):
            pictures.draw(k)
    else:
        write(pictures, Path(folder) / f"film.{kind}")
    wall, after = time.perf_counter() - wall, os.times()
    painter = after.user - before.user + after.system - before.system
    encoder = after.children_user - before.children_user + after.children_system - before.children_system
    return {
        "pictures": pictures.count,
        "per_second": pictures.count / wall,
        "painter_ms": 1e3 * painter / pictures.count,
        "encoder_ms": 1e3 * encoder / pictures.count,
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true", help="print the numbers as JSON")
    parser.add_argument("--pictures", type=int, default=240, help="pictures a film in 2D; a quarter in 3D")
    options = parser.parse_args()
    motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=6.0)
    size = (1280, 720)
    plain = Film2D([motion], Timing(fps=60), Look(size=size))
    panels = Film2D([motion], Timing(fps=60), Look(size=size, panels=PANELS))
    solid = Film3D([motion], Timing(fps=30), Look3D(size=size))
    rows = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, pictures, kind, count in (
            ("2D, drawn", plain, None, options.pictures),
            ("2D, mp4", plain, "mp4", options.pictures),
            ("2D, webm", plain, "webm", options.pictures),
            ("2D with panels, mp4", panels, "mp4", options.pictures),
            ("3D, drawn", solid, None, options.pictures // 4),
            ("3D, mp4", solid, "mp4", options.pictures // 4),
        ):
            pictures.draw(0)  # fonts and buffers are made once
            rows[name] = measured(Drawn(pictures, count), kind, folder)
    solid.close()
    if options.json:
        print(json.dumps({"size": size, "cores": os.cpu_count(), "films": rows}, indent=2))
        return
    print(f"{size[0]} × {size[1]}, {os.cpu_count()} cores")
    print(f"{'film':24}{'pictures/s':>12}{'painter, ms':>14}{'encoder, ms':>14}")
    for name, row in rows.items():
        print(f"{name:24}{row['per_second']:12.1f}{row['painter_ms']:14.2f}{row['encoder_ms']:14.2f}")


if __name__ == "__main__":
    main()
