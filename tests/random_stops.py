"""Every long command of the command line, stopped at random moments as a terminal, a system or `kill -9` does."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import hophoop as hh
from hophoop import maps
from hophoop.tracking.table import track_of
from map_tools import contents

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)
CELLS = 700  # of a map, along each of its axes
AXES = f"--axis plane.mu=0.05:1.95:{CELLS} --axis start.speed=0.05:5:{CELLS} --quiet"
KEPT = "Stopped; what is done is kept in {}, and --resume goes on."
FILMED = hh.Scenario(
    hoop=hh.Hoop.ideal(0.6, radius=0.3),
    plane=hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3),
    start=hh.Start.rolling(1.9, angle=0.1),
    duration=1.01,
)


RESULTS = (  # what is said without a stop
    "Of the article only", "The lab is", "Found in", "The page:", "The report:",
)  # fmt: skip


@dataclass(frozen=True)
class Command:
    """A command that takes some seconds.

    Attributes
    ----------
    words : str
        What it is called with; files are in the folder where it runs.
    seconds : float
        Within which it is stopped [s].
    resumed : str
        The map that goes on with --resume.
    served : bool
        It is a server, whose end by Ctrl-C is a success.
    again : bool
        After SIGKILL it runs again to its end, over what was left.
    """

    words: str
    seconds: float = 6.0
    resumed: str = ""
    served: bool = False
    again: bool = True


COMMANDS = {
    "run, compliant, into .csv and .nc": Command(
        "run --v0 3.1 --duration 50 --set contact.model=compliant --csv r.csv --save r.nc --quiet"
    ),
    "run, many samples into .csv": Command("run --v0 3.1 --samples 100000 --csv r.csv --quiet", 4.0),
    "run --digits 40": Command("run --v0 3.1 --digits 40 --json r.json"),
    "prove": Command("prove --v0 3.1 --digits 40 --out p.json"),
    "reproduce": Command("reproduce --out article", 20.0),
    "animate, .mp4": Command("animate --v0 3.1 --duration 2 --out a.mp4 --quiet"),
    "animate, .gif": Command("animate --v0 3.1 --duration 2 --out a.gif --quiet"),
    "animate --3d, .png": Command("animate --v0 3.1 --duration 1 --3d --out pictures --quiet"),
    "map, .zarr": Command(f"map {AXES} --out m.zarr", resumed="m.zarr"),
    "map, .nc": Command(f"map {AXES} --out m.nc", resumed="m.nc"),
    "map --workers 2": Command(f"map {AXES} --out m.zarr --workers 2", 8.0, "m.zarr"),
    "track": Command("track film.mp4 --radius 0.3 --out tracked --quiet"),
    "fit --sample": Command("fit track.json --sample 1000 --out fitted --save fit.json --quiet"),
    "lab": Command("lab --no-browser --port 0", served=True, again=False),
}


def prepare(folder: Path) -> None:
    """Files that commands read: a track and a film."""
    from film_maker import Film, make

    motion, rng = hh.simulate(FILMED), np.random.default_rng(1)
    t = np.arange(240) / 240
    state = motion.at(t)
    columns = {"x": state.x, "y": state.height + 0.3, "angle": state.angle}
    columns = {name: values + rng.normal(0, 1e-3, t.size) for name, values in columns.items()}
    columns |= {f"sigma_{name}": np.full(t.size, 1e-3) for name in columns}
    track_of(t, columns, radius=0.3, placed=True).save(folder / "track.json")
    make(folder / "film.mp4", motion, Film(frames=200))


class Stop:
    """One command in a folder of its own, stopped once."""

    def __init__(self, name: str, folder: Path, inputs: Path) -> None:
        self.command = COMMANDS[name]
        self.folder, self.temporary = folder / "here", folder / "temporary"
        self.streams = folder / "said"
        for one in (self.folder, self.temporary):
            one.mkdir(parents=True)
        self.given = [file.name for file in inputs.iterdir()]
        for file in inputs.iterdir():
            (self.folder / file.name).write_bytes(file.read_bytes())
        self.wrong: list[str] = []
        self.took = 0.0

    def begin(self, *more: str) -> subprocess.Popen[bytes]:
        """Start it, as the leader of a session."""
        with self.streams.open("wb") as said:
            return subprocess.Popen(
                [sys.executable, "-m", "hophoop", *self.command.words.split(), *more],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=said,
                cwd=self.folder,
                env=os.environ | {"TMPDIR": str(self.temporary), "HOPHOOP_KERNELS": "compiled", "MPLBACKEND": "agg"},
                start_new_session=True,
            )

    def stop(self, after: float, number: signal.Signals, group: bool) -> bool:
        """Stop it so many seconds after it listens; False where it had ended."""
        process = self.begin()
        while not _listens(process.pid) and process.poll() is None:
            time.sleep(0.001)
        try:
            process.wait(after)
            return False
        except subprocess.TimeoutExpired:
            pass
        began = time.monotonic()
        (os.killpg if group else os.kill)(process.pid, number)
        try:
            status = process.wait(60)
        except subprocess.TimeoutExpired:
            self.wrong.append("it went on for 60 s")
            os.killpg(process.pid, signal.SIGKILL)
            status = process.wait()
        self.took = time.monotonic() - began
        if status in (0, 1) and not self.command.served:
            return False  # it was about to end; a stop that was heard and lost has its own status
        self._look(status, number, process.pid)
        return True

    def _look(self, status: int, number: signal.Signals, session: int) -> None:
        killed = number == signal.SIGKILL
        expected = -9 if killed else 0 if self.command.served and status == 0 else 128 + number
        if status != expected:
            self.wrong.append(f"status {status}, not {expected}")
        # workers are told by a pipe that nobody is there; a picture or a cell may be at work
        deadline = time.monotonic() + (20.0 if killed else 1.0)
        while (left := _session(session)) and time.monotonic() < deadline:
            time.sleep(0.02)
        if left:
            self.wrong.append(f"still at work: {left}")
            for pid in left:
                os.kill(pid, signal.SIGKILL)
        said = self.streams.read_text(encoding="utf-8", errors="replace").splitlines()
        said = [line for line in said if not line.startswith(RESULTS) and not line.endswith(f"in {self.command.resumed or 0}")]
        if killed:  # Python has a process that takes away what one that was killed has left, and says so
            said = [line for line in said if "resource_tracker" not in line and "warnings.warn" not in line]
        place = f"{self.command.resumed}.part.zarr" if self.command.resumed.endswith(".nc") else self.command.resumed
        sentences = [["Stopped."], [KEPT.format(place)]]
        if said not in ([[]] if killed or (self.command.served and status == 0) else sentences):
            self.wrong.append(f"said {' / '.join(said)[-1500:]!r}")
        if not killed:
            hidden = [str(path.relative_to(self.folder)) for path in self.folder.rglob(".*")]
            hidden += [str(path.relative_to(self.temporary)) for path in self.temporary.rglob("*")]
            if hidden:
                self.wrong.append(f"left behind: {sorted(hidden)}")
        self._whole()

    def _whole(self) -> None:
        for path in sorted(self.folder.rglob("*")):
            inside = path.relative_to(self.folder).parts
            ours = path.is_file() and not any(part.startswith(".") or part.endswith(".zarr") for part in inside)
            if ours and path.name not in self.given and not whole(path):
                self.wrong.append(f"half-written: {path.relative_to(self.folder)}")

    def finish(self, map_whole: Path) -> None:
        """Run it again to its end over what is there."""
        out = self.folder / self.command.resumed
        begun = self.command.resumed and (out.exists() or out.with_name(f"{out.name}.part.zarr").exists())
        more = ["--resume"] if begun else []
        if self.command.words.startswith("animate --v0 3.1 --duration 1 --3d") and (self.folder / "pictures").exists():
            return  # it was complete, and a folder with pictures is not written over
        process = self.begin(*more)
        status = process.wait(600)
        if status not in (0, 1):
            self.wrong.append(f"run again: status {status}, {self.streams.read_text()[-300:]!r}")
        self._whole()
        if self.command.resumed and not _same(out, map_whole):
            self.wrong.append("resumed, it is another map")


def _same(one: Path, other: Path) -> bool:
    if one.suffix == other.suffix:
        return contents(one) == contents(other)
    with maps.open_map(one) as left, maps.open_map(other) as right:
        return bool(left.equals(right))


def whole(path: Path) -> bool:
    """Whether a file is complete, by what ends or seals its format."""
    content = path.read_bytes()
    if path.suffix == ".json":
        return json.loads(content) is not None
    if path.suffix == ".nc":
        return maps.open_map(path) is not None if path.name == "m.nc" else hh.load(path) is not None
    if path.suffix == ".mp4":
        import av

        with av.open(str(path)) as box:
            return sum(1 for _ in box.decode(video=0)) > 0
    if path.suffix == ".csv":
        rows = content.split(b"\n")
        return rows[-1] == b"" and rows[-2].count(b",") == rows[-3].count(b",") > 0
    ends = {".png": b"IEND\xaeB`\x82", ".gif": b";", ".svg": b"</svg>", ".html": b"</html>"}
    return bool(content.rstrip(b"\n").endswith(ends.get(path.suffix, b"")) and content)


def _listens(pid: int) -> bool:
    """Whether a process has a handler for SIGTERM."""
    try:
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    except OSError:
        return False
    caught = next((int(line.split()[1], 16) for line in lines if line.startswith("SigCgt")), 0)
    return bool(caught >> (signal.SIGTERM - 1) & 1)


def _session(leader: int) -> dict[int, str]:
    """Processes of a session that have not ended."""
    found = {}
    for folder in Path("/proc").iterdir():
        try:
            if folder.name.isdigit():
                name, _, rest = (folder / "stat").read_text().rpartition(")")
                state, _, _, session = rest.split()[:4]
                if int(session) == leader and state != "Z":
                    found[int(folder.name)] = name.partition("(")[2]
        except OSError:
            pass
    return found


def drawn(count: int, names: list[str], seed: int) -> Iterator[tuple[str, signal.Signals, bool, float]]:
    """So many stops: every command with every signal, to the process and to its group, in turn, at random moments."""
    draw = random.Random(seed)
    every = [(name, number, group) for name in names for number in SIGNALS for group in (False, True)]
    draw.shuffle(every)
    for k in range(count):
        name, number, group = every[k % len(every)]
        yield name, number, group, draw.uniform(0.0, COMMANDS[name].seconds)


def stopped_at_random(
    name: str, number: signal.Signals, group: bool, after: float, folder: Path, inputs: Path, map_whole: Path
) -> Stop:
    """Stop a command, and let it go on where it can; one that had ended before is stopped earlier."""
    k = 0
    while True:
        one = Stop(name, folder / str(k), inputs)
        if one.stop(after, number, group):
            break
        k, after = k + 1, after / 2
    if one.command.resumed or (number == signal.SIGKILL and one.command.again):
        one.finish(map_whole)
    return one


def whole_map(folder: Path) -> Path:
    """The map that all stopped ones must become."""
    values = {"plane.mu": np.linspace(0.05, 1.95, CELLS), "start.speed": np.linspace(0.05, 5.0, CELLS)}
    maps.sweep(None, values, ["sequence"], out=folder / "whole.zarr")
    return folder / "whole.zarr"
