"""Does a test see it when the source is changed? `python tests/mutations.py [ROOM ...] [--markdown FILE]`.

The operators of Cosmic Ray (signs, factors, comparisons, numbers, conditions, loops) change one place of a room at a time, and
the tests of that room run. A change that no test sees is printed, and makes the exit status 1, unless
`mutations_explained.py` says why nothing can see it. Kernels are interpreted (NUMBA_DISABLE_JIT=1), but for maps.

Cosmic Ray's own runner starts Python for every change, which takes longer here than the tests: `mutation_runs.py` forks
where all is imported.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import random
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

from mutants import Mutant, mutants
from mutation_runs import SEEN, UNREACHED, run_anew, run_within
from mutations_explained import EXPLAINED

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src" / "hophoop"


class Room(NamedTuple):
    """What is changed, and the tests that should see it."""

    sources: tuple[str, ...]
    tests: tuple[str, ...]
    interpreted: bool = True


ROOMS = {
    "physics": Room(("physics/*.py",), ("tests/physics",)),
    "rigid": Room(("rigid/*.py",), ("tests/rigid", "tests/physics")),
    "derivatives": Room(
        tuple(
            f"derivatives/{name}.py"
            for name in (
                *("conditions", "directions", "ending", "impact", "massless", "moving", "panels", "pieces", "replay"),
                "sampling",
            )
        ),
        ("tests/derivatives",),
    ),
    "scenario": Room(("scenario/*.py",), ("tests/scenario",)),
    "io": Room(("io.py", "export.py", "_files.py", "_checksum.py"), ("tests/test_io.py", "tests/files")),
    "maps/store": Room(("maps/store.py",), ("tests/maps/test_maps_store.py", "tests/maps/test_maps_hostile.py"), False),
}


def paths_of(room: Room) -> list[Path]:
    """The modules of a room; a pattern that finds none is a mistake."""
    for pattern in room.sources:
        if not any(SOURCE.glob(pattern)):
            raise FileNotFoundError(f"{pattern} is no module of hophoop.")
    return sorted(path for pattern in room.sources for path in SOURCE.glob(pattern) if path.stem != "__init__")


def try_room(name: str, modules: list[str], sample: int | None, results: Path) -> None:
    """Try the changes of a room, in this process and its children; write what came to a file."""
    room = ROOMS[name]
    os.environ["NUMBA_DISABLE_JIT" if room.interpreted else "HOPHOOP_KERNELS"] = "1" if room.interpreted else "compiled"
    os.environ["CI"] = "1"  # the same examples every time
    os.chdir(ROOT)
    sys.path[:0] = [str(ROOT / "src"), str(ROOT / "tests")]
    # what takes long to import, once for all processes
    for heavy in (
        "pytest",
        "numpy",
        "scipy.integrate",
        "scipy.optimize",
        "mpmath",
        "sympy",
        "hypothesis",
        "pydantic",
        "xarray",
    ):
        importlib.import_module(heavy)
    paths = [path for path in paths_of(room) if not modules or path.stem in modules]
    made = [mutant for path in paths for mutant in mutants(path)]
    there = len(made)
    if sample is not None and sample < there:
        made = sorted(random.Random(2026).sample(made, sample), key=lambda one: (one.path, one.line))
    names = {path: ".".join(("hophoop", *path.relative_to(SOURCE).with_suffix("").parts)) for path in paths}
    tests = list(room.tests)
    found: list[dict[str, Any]] = []
    began = time.monotonic()

    def report(mutant: Mutant, status: str) -> None:
        explained = status != SEEN and mutant.key in EXPLAINED
        if status == SEEN and mutant.key in EXPLAINED:
            print(f"{mutant.path.name}:{mutant.line} is seen, and needs no explanation: {mutant.changed}", flush=True)
        found.append({"module": mutant.path.stem, "status": status, "explained": explained})
        if status != SEEN and not explained:
            words = "no test comes here" if status == UNREACHED else "not seen"
            print(f"{mutant.path.name}:{mutant.line} in {mutant.function or 'the module'}: {words}", flush=True)
            print(f"    {mutant.text}\n    {mutant.changed}", flush=True)
        if len(found) % 50 == 0:
            print(f"... {len(found)} of {len(made)} changes tried in {time.monotonic() - began:.0f} s", flush=True)

    run_within([one for one in made if one.function], tests, report)
    run_anew([one for one in made if not one.function], names, tests, report)
    text = {"room": name, "there": there, "seconds": time.monotonic() - began, "found": found}
    results.write_text(json.dumps(text), encoding="utf-8")


def table(rooms: list[dict[str, Any]]) -> str:
    """Markdown: for each module how many changes, seen, explained and not seen."""
    lines = [
        "| Room, module | changes tried | seen | not seen, explained | not seen | seen or explained |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for room in rooms:
        modules = sorted({one["module"] for one in room["found"]})
        for module in [None, *modules]:
            lines.append(_row(room, module))
    return "\n".join(lines) + "\n"


def _row(room: dict[str, Any], module: str | None) -> str:
    found = [one for one in room["found"] if module in (None, one["module"])]
    seen = sum(one["status"] == SEEN for one in found)
    told = sum(one["explained"] for one in found)
    share = f"{100.0 * (seen + told) / len(found):.1f} %"
    if module is not None:
        cells = [f"&emsp;{module}", f"{len(found):,}", seen, told, len(found) - seen - told, share]
    else:
        tried = f"{len(found):,}" + (f" of {room['there']:,}" if len(found) < room["there"] else "")
        cells = [f"**{room['room']}**", f"**{tried}**", f"**{seen:,}**", told, len(found) - seen - told, f"**{share}**"]
    return f"| {' | '.join(str(cell) for cell in cells)} |"


def main() -> int:
    """Try the changes and print the scores."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rooms", nargs="*", metavar="ROOM", help=f"of {', '.join(ROOMS)}; all by default")
    parser.add_argument("--module", action="append", default=[], help="only this module of the room, such as contact")
    parser.add_argument("--sample", type=int, help="so many changes of each room, drawn at random (always the same)")
    parser.add_argument("--markdown", type=Path, help="write the table to this file")
    parser.add_argument("--results", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.results is not None:  # one room, in a process of its own
        try_room(options.rooms[0], options.module, options.sample, options.results)
        return 0
    rooms = []
    for name in options.rooms or ROOMS:
        if name not in ROOMS:
            parser.error(f"{name} is not one of {', '.join(ROOMS)}.")
        file = ROOT / "tests" / "results" / f"mutations-{name.replace('/', '-')}.json"
        file.parent.mkdir(parents=True, exist_ok=True)
        words = [sys.executable, __file__, name, "--results", str(file)]
        words += [word for module in options.module for word in ("--module", module)]
        words += ["--sample", str(options.sample)] if options.sample is not None else []
        subprocess.run(words, check=True)
        rooms.append(json.loads(file.read_text(encoding="utf-8")))
    text = table(rooms)
    print(text, end="")
    if options.markdown is not None:
        options.markdown.write_text(text, encoding="utf-8")
    bad = sum(one["status"] != SEEN and not one["explained"] for room in rooms for one in room["found"])
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
