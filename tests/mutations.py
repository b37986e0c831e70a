"""Does a test see it when the source is changed? `python tests/mutations.py [ROOM ...] [--markdown FILE]`.

The operators of Cosmic Ray (signs, factors, comparisons, numbers, conditions, loops) change one place of a room at a time, and
the tests of that room run. A change that no test sees is printed, and makes the exit status 1, unless
`mutations_explained.toml` says why nothing can see it. Kernels are interpreted (HOPHOOP_KERNELS=interpreted) where they are
changed.

Cosmic Ray's own runner starts Python for every change, which takes longer here than the tests: `mutation_runs.py` forks
where all is imported. What came is kept in tests/results, so that a run that was stopped goes on.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.metadata
import json
import math
import os
import platform
import random
import subprocess
import sys
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

from mutants import Mutant
from mutation_journal import Journal, digest, digest_of_tests, kept_mutants
from mutation_runs import SEEN, UNREACHED, Tests, run_all
from mutations_explained import EXPLAINED

ROOT = Path(__file__).parents[1]
UNBROKEN = "\N{NON-BREAKING HYPHEN}"  # so that a date stays on its line
SOURCE = ROOT / "src" / "hophoop"
RESULTS = ROOT / "tests" / "results"


class Room(NamedTuple):
    """What is changed, and the tests that should see it."""

    sources: tuple[str, ...]
    tests: tuple[str, ...]
    interpreted: bool = True
    sample: int = 0  # changes drawn at random; 0 for all
    seed: int = 2026  # of the draw: another one where tests were written for what the last one showed
    patience: float = 20.0  # s of tests for one change


ROOMS = {
    "physics": Room(("kernel/physics/*.py",), ("tests/physics",)),
    "rigid": Room(("kernel/rigid/*.py", "simulation/event_errors.py"), ("tests/rigid", "tests/physics"), patience=4.0),
    "derivatives": Room(
        tuple(
            f"derivatives/{name}.py"
            for name in (
                *(
                    "directions",
                    "rules",
                    "tangents",
                    "transform",
                    "events/conditions",
                    "events/ending",
                    "events/impact",
                    "events/massless",
                ),
                *("pieces/flight_and_rest", "pieces/panels", "pieces/pieces", "pieces/sampling"),
            )
        ),
        ("tests/derivatives",),
        sample=300,
    ),
    "scenario": Room(("scenario/*.py", "kernel/records/refusal.py"), ("tests/scenario",), False),
    "io": Room(
        ("io.py", "results/save.py", "_support/files.py", "_support/checksum.py"),
        ("tests/test_io.py", "tests/files/test_reading.py", "tests/files/test_written_whole.py"),
        False,
    ),
    "maps/store": Room(
        ("maps/grid/store.py",),
        ("tests/maps/test_maps_store.py", "tests/maps/test_maps_hostile.py", "tests/maps/test_maps_pieces.py"),
        False,
    ),
}


def paths_of(room: Room) -> list[Path]:
    """The modules of a room; a pattern that finds none is a mistake."""
    for pattern in room.sources:
        if not any(SOURCE.glob(pattern)):
            raise FileNotFoundError(f"{pattern} is no module of hophoop.")
    return sorted(path for pattern in room.sources for path in SOURCE.glob(pattern) if path.stem != "__init__")


def _prepare(room: Room) -> None:
    """Set up this process, and import what takes long to import once for all others."""
    os.environ["HOPHOOP_KERNELS"] = "interpreted" if room.interpreted else "compiled"
    os.environ["CI"] = "1"  # the same examples every time
    os.chdir(ROOT)
    sys.path[:0] = [str(ROOT / "src"), str(ROOT / "tests")]
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


def try_room(name: str, modules: list[str], tests: list[str], sample: int, only_reach: bool, results: Path) -> None:
    """Try the changes of a room, in this process and its children; write what came to a file."""
    room = ROOMS[name]._replace(tests=tuple(tests) or ROOMS[name].tests)
    _prepare(room)
    paths = [path for path in paths_of(room) if not modules or path.stem in modules]
    made = [mutant for path in paths for mutant in kept_mutants(path, RESULTS)]
    there = len(made)
    if 0 < sample < there:
        made = sorted(random.Random(room.seed).sample(made, sample), key=lambda one: (one.path, one.line))
    names = {path: ".".join(("hophoop", *path.relative_to(SOURCE).with_suffix("").parts)) for path in paths_of(room)}
    of_tests = digest_of_tests(room.tests)
    stem = f"mutations-{name.replace('/', '-')}"
    journal = Journal(RESULTS / f"{stem}.jsonl", of_tests)
    reach = RESULTS / f"{stem}-{digest(of_tests, *(path.read_bytes() for path in names))}.reach"
    missing = journal.missing(made)
    began, tried = time.monotonic(), 0

    def report(mutant: Mutant, status: str) -> None:
        nonlocal tried
        tried += 1
        journal.add(mutant, status)
        if tried % 50 == 0:
            print(f"... {tried} of {len(missing)} changes tried in {time.monotonic() - began:.0f} s", flush=True)

    if only_reach:
        missing = []
    if missing or only_reach:
        run_all(missing, names, Tests(room.tests, room.patience, reach, EXPLAINED, not room.interpreted), report)
    found = []
    entries = [(mutant, journal.entry(mutant)) for mutant in made] if not only_reach else []
    for mutant, entry in entries:
        assert entry is not None
        status = entry["status"]
        _tell(mutant, status)
        explained = status != SEEN and mutant.key in EXPLAINED
        found.append({"module": mutant.path.stem, "status": status, "explained": explained, "on": entry["on"]})
    results.write_text(json.dumps({"room": name, "there": there, "found": found}), encoding="utf-8")


def _tell(mutant: Mutant, status: str) -> None:
    """Print a change that no test sees and nothing explains, and an explanation of one that a test sees."""
    if status == SEEN:
        if mutant.key in EXPLAINED:
            print(f"seen, and needs no explanation: {_place(mutant)}", flush=True)
    elif mutant.key not in EXPLAINED:
        words = "no test comes here" if status == UNREACHED else "not seen"
        print(f"{words}: {_place(mutant)}", flush=True)


def _place(mutant: Mutant) -> str:
    """The line of a change and what names it in the table of explained ones, then the line as it is and with the change."""
    module, function, operator, ordinal = mutant.key
    where = f"{module}:{function}" if function else module
    return f"{mutant.path.name}:{mutant.line} {where} {operator} {ordinal}\n    {mutant.text}\n    {mutant.changed}"


def explain(names: Iterable[str]) -> None:
    """Print the lines of the explained changes of some rooms, by the reason."""
    made = {one.key: one for name in names for path in paths_of(ROOMS[name]) for one in kept_mutants(path, RESULTS)}
    before = ""
    for key, entry in EXPLAINED.items():
        if key in made:
            print(*([f"\n{entry.reason}"] if entry.reason != before else []), _place(made[key]), sep="\n")
            before = entry.reason


def file_of(name: str) -> Path:
    """Where the last run of a room keeps what came."""
    return RESULTS / f"mutations-{name.replace('/', '-')}.json"


def last_results() -> list[dict[str, Any]]:
    """What came of the last run of each room that has been tried here."""
    return [json.loads(file_of(name).read_text(encoding="utf-8")) for name in ROOMS if file_of(name).exists()]


def rows_of(text: str) -> dict[str, list[str]]:
    """The rows of each room in a table that was written before."""
    found: dict[str, list[str]] = {}
    rows: list[str] = []
    for line in text.splitlines():
        if line.startswith("| **"):
            rows = found.setdefault(line.split("**")[1], [])
        if line.startswith(("| **", "| &nbsp;")):
            rows.append(line)
    return found


def table(rooms: list[dict[str, Any]], before: str = "") -> str:
    """Markdown: for each module how many changes, seen, explained and not seen.

    Rooms that are not among these are those of a table that was written before.
    """
    versions = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in ("hophoop", "cosmic-ray"))
    lines = [
        f"{versions}, Python {platform.python_version()}. Of a part: the share of all, with 95 % confidence.",
        "",
        "| Room, module | changes tried | seen | not seen, explained | not seen | seen or explained | tried from |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]
    found = rows_of(before)
    for room in rooms:
        modules = sorted({one["module"] for one in room["found"]})
        found[room["room"]] = [_row(room, module) for module in [None, *modules]]
    for name in ROOMS:
        lines += found.get(name, [])
    return "\n".join(lines) + "\n"


def _row(room: dict[str, Any], module: str | None) -> str:
    found = [one for one in room["found"] if module in (None, one["module"])]
    seen = sum(one["status"] == SEEN for one in found)
    told = sum(one["explained"] for one in found)
    share = f"{100.0 * (seen + told) / len(found):.1f} %"
    since = min(one["on"] for one in found).replace("-", UNBROKEN)
    if module is not None:
        cells = [f"&nbsp;&nbsp;{module}", f"{len(found):,}", seen, told, len(found) - seen - told, share, since]
    else:
        tried, part = f"{len(found):,}", ""
        if len(found) < room["there"]:
            tried += f" of {room['there']:,}"
            part = " ({:.1f} to {:.1f} %)".format(*(100.0 * end for end in interval(seen + told, len(found))))
        cells = [
            f"**{room['room']}**",
            f"**{tried}**",
            f"**{seen:,}**",
            told,
            len(found) - seen - told,
            f"**{share}**{part}",
            since,
        ]
    return f"| {' | '.join(str(cell) for cell in cells)} |"


def interval(successes: int, tries: int) -> tuple[float, float]:
    """Wilson's interval of a share, with 95 % confidence."""
    z, share = 1.959964, successes / tries
    middle = (share + z * z / (2.0 * tries)) / (1.0 + z * z / tries)
    half = z * math.sqrt(share * (1.0 - share) / tries + z * z / (4.0 * tries * tries)) / (1.0 + z * z / tries)
    return middle - half, middle + half


def main() -> int:
    """Try the changes and print the scores."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rooms", nargs="*", metavar="ROOM", help=f"of {', '.join(ROOMS)}; all by default")
    parser.add_argument("--module", action="append", default=[], help="only this module of the room, such as contact")
    parser.add_argument("--sample", type=int, help="so many changes of each room, drawn at random (always the same); 0 for all")
    parser.add_argument(
        "--tests", action="append", default=[], help="only this file or folder; the rest is tried later without"
    )
    parser.add_argument("--anew", action="store_true", help="try again what was tried before")
    parser.add_argument("--markdown", type=Path, help="put the last run of every room here into the table of this file")
    parser.add_argument("--reach", action="store_true", help="only find out which test comes to which statement")
    parser.add_argument("--explained", action="store_true", help="print the changes that are explained, and try none")
    parser.add_argument("--results", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.results is not None:  # one room, in a process of its own
        try_room(options.rooms[0], options.module, options.tests, options.sample, options.reach, options.results)
        return 0
    for name in options.rooms:
        if name not in ROOMS:
            parser.error(f"{name} is not one of {', '.join(ROOMS)}.")
    if options.explained:
        explain(options.rooms or ROOMS)
        return 0
    rooms = []
    RESULTS.mkdir(parents=True, exist_ok=True)
    for name in options.rooms or ROOMS:
        file = file_of(name)
        if options.module or options.tests:  # the table is of whole rooms
            file = file.with_suffix(".part.json")
        if options.anew:
            file_of(name).with_suffix(".jsonl").unlink(missing_ok=True)
        sample = options.sample if options.sample is not None else 0 if options.module else ROOMS[name].sample
        words = [sys.executable, __file__, name, "--results", str(file), "--sample", str(sample)]
        words += [word for module in options.module for word in ("--module", module)]
        words += [word for path in options.tests for word in ("--tests", path)]
        words += ["--reach"] * options.reach
        subprocess.run(words, check=True)
        rooms.append(json.loads(file.read_text(encoding="utf-8")))
    if options.reach:
        return 0
    print(table(rooms), end="")
    if options.markdown is not None:
        before = options.markdown.read_text(encoding="utf-8") if options.markdown.exists() else ""
        options.markdown.write_text(table(last_results(), before), encoding="utf-8")
    bad = sum(one["status"] != SEEN and not one["explained"] for room in rooms for one in room["found"])
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
