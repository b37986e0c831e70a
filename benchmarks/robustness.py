"""Files damaged, disks filled, maps killed: how often, and what came. `python benchmarks/robustness.py [--markdown FILE]`.

What came must be the same motion or map, or one sentence; anything else is printed, and makes the exit status 1.
"""

from __future__ import annotations

import argparse
import itertools
import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

import hophoop as hh
from damage import REFUSED, SAME, tally
from hophoop import maps
from hophoop.results import save as export
from map_kills import finished, kill_at_random

MOTIONS = ("hop.nc", "hop.zarr", "hop.zarr.zip")
AXES = {"plane.mu": np.linspace(0.05, 1.95, 12), "start.speed": np.linspace(0.05, 5.0, 10)}


def alike(one: Any, other: Any) -> bool:
    """Whether two motions hold the same bits."""
    tables = all(one.tables[name].tobytes() == other.tables[name].tobytes() for name in ("events", "segments"))
    return tables and (one.scenario, one.status, one.version) == (other.scenario, other.status, other.version)


def damaged_files(folder: Path, motion: Any, count: int) -> Iterator[tuple[str, Counter[str]]]:
    """Every format, cut short and with bits turned."""
    for name in MOTIONS:
        motion.save(folder / name)
        came = tally(hh.load, lambda one: alike(one, motion), folder / name, folder / f"damaged-{name}", count)
        yield f"a saved motion, `.{name.partition('.')[2]}`, damaged", came
    for ending in ("zarr", "nc"):
        path = folder / f"map.{ending}"
        values = maps.sweep(None, AXES, ["sequence", "hop_height"], out=path, chunk_cells=20).load()
        came = tally(lambda file: maps.open_map(file).load(), values.identical, path, folder / f"damaged.{ending}", count)
        yield f"a map, `.{ending}`, damaged", came
    for ending in ("toml", "json"):
        path = folder / f"hop.{ending}"
        motion.scenario.save(path)
        read: Callable[[Any], bool] = lambda one: isinstance(one, hh.Scenario)  # noqa: E731
        came = tally(hh.Scenario.load, read, path, folder / f"damaged.{ending}", count)
        came["a scenario (there is no checksum in what people edit)"] = came.pop(SAME, 0)
        yield f"a scenario, `.{ending}`, damaged", came


def full_disks(folder: Path, motion: Any, count: int) -> Iterator[tuple[str, Counter[str]]]:
    """Every format written over an older file on a small disk of its own with less and less room."""
    disk = folder / "disk"
    disk.mkdir()
    longer = hh.simulate(motion.scenario.replace("duration", 4.0))
    writers: dict[str, Callable[[Any, Path], None]] = {name: lambda one, path: one.save(path) for name in MOTIONS}
    writers |= {"hop.csv": export.write_csv, "hop.json": export.write_json}
    for name, write in writers.items():
        came: Counter[str] = Counter()
        for k in range(count):
            if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4m", "tmpfs", str(disk)], check=False).returncode != 0:
                yield "a full disk", Counter({"not tried: no small disk could be mounted": 1})
                return
            try:
                write(motion, disk / name)
                before = _contents(disk)
                status = os.statvfs(disk)
                # so many pages stay free
                (disk / "filler").write_bytes(bytes(status.f_frsize * max(0, status.f_bavail - PAGES * k // count)))
                # in a process of its own: HDF5 keeps a file open that it could not write
                written = _forked(lambda write=write, name=name: write(longer, disk / name))
                (disk / "filler").unlink()
                if written == 0:
                    whole = name not in MOTIONS or _forked(lambda name=name: _expect(alike(hh.load(disk / name), longer))) == 0
                    came["written whole" if whole else "another motion"] += 1
                elif written == 2:
                    came[KEPT if _contents(disk) == before else "the old file is lost"] += 1
                else:
                    came["an error that is no sentence"] += 1
            finally:
                subprocess.run(["umount", str(disk)], check=True)
        yield f"`{name}` written where the disk is full", came


PAGES = 400  # of 4 kB that are free at most
KEPT = "one sentence, the old file as it was"


def _forked(work: Callable[[], None]) -> int:
    """0 where some work is done in a process of its own, 2 where it raised OSError."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            work()
            status = 0
        except OSError:
            status = 2
        except BaseException as error:
            print(repr(error), flush=True)
        finally:
            os._exit(status)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def _expect(truth: bool) -> None:
    if not truth:
        raise ValueError("not alike")


def _contents(folder: Path) -> dict[str, bytes]:
    return {str(file): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def killed_maps(folder: Path, count: int) -> Iterator[tuple[str, Counter[str]]]:
    """A map stopped at random moments and taken up again."""
    finished(folder / "whole.zarr")
    came = kill_at_random(folder / "whole.zarr", folder / "killed.zarr", count)
    total = came.pop("stopped")
    compared = came.pop("whole maps compared")
    words = Counter({f"{name}, taken up": number for name, number in came.items() if name.startswith("SIG")})
    words["maps complete in the end, equal byte for byte"] = compared
    yield f"a map stopped at {total} random moments", words


ALLOWED = {SAME, REFUSED, "written whole", KEPT}


def main() -> int:
    """Try everything and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=300, help="damaged files of each format")
    parser.add_argument("--disks", type=int, default=8, help="full disks for each format")
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--markdown", type=Path, help="write the table to this file")
    options = parser.parse_args()
    motion = hh.simulate(hh.Hoop(), hh.Plane(restitution=0.4), hh.Start.rolling(3.1), duration=2.0)
    bad = []
    lines = ["| What was tried | how often | what came |", "| --- | --- | --- |"]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        parts: list[Iterable[tuple[str, Counter[str]]]] = [
            damaged_files(folder, motion, options.count),
            full_disks(folder, motion, options.disks),
            killed_maps(folder, options.kills),
        ]
        for what, came in itertools.chain(*parts):
            tries = sum(number for key, number in came.items() if not key.startswith("maps complete"))
            lines.append(
                f"| {what} | {tries} | {', '.join(f'{key}: {number}' for key, number in sorted(came.items()) if number)} |"
            )
            bad += [
                key
                for key in came
                if key not in ALLOWED and not key.startswith(("SIG", "maps complete", "a scenario", "not tried"))
            ]
            print(lines[-1], flush=True)
            if options.markdown is not None:
                options.markdown.write_text("\n".join(lines) + "\n", encoding="utf-8")
    for key in bad:
        print(f"NOT ALLOWED: {key}")
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
