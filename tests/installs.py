"""The wheel in clean environments: `python tests/installs.py --bounds --markdown FILE`; `--help` tells the other options.

With every Python given (by default those from 3.11 to 3.14 that are found) the wheel is installed without extras into an
environment of its own, and run in poor surroundings. With `--bounds` the fast tests run with the lowest versions that
pyproject.toml allows, and with the newest ones; with `--bounds only`, `lowest` or `newest` nothing else. Rows of a table that
is there are kept, but for those that are tried again, so that it can be made in parts.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).parents[1]
VERSIONS = ("3.11", "3.12", "3.13", "3.14")
NOTHING = "anything"  # what was tried with a Python that is not there
# what asks for each extra, on the command line or in Python
EXTRAS = {
    "plots": ["run", "--plot", "hop.png"],
    "maps": ["run", "--save", "hop.nc"],
    "films": ["animate", "--out", "hop.mp4"],
    "lab": ["lab"],
    "cluster": "from hophoop.maps.grid.distributed import compute_on_cluster as c; c(None, [], None, 1, print)",
}
# what other tests need than those that run here
TOOLS = (
    "hophoop",
    "ruff",
    "mypy",
    "import-linter",
    "cosmic-ray",
    "httpx",
    "schemathesis",
    "playwright",
    "mujoco",
    "pymunk",
    "box2d",
)


def sh(*words: str | Path, **options: object) -> subprocess.CompletedProcess[str]:
    """Run a program to its end; what it says is kept."""
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)  # type: ignore[call-overload,no-any-return]


def found_pythons() -> dict[str, str]:
    """The interpreters of this machine, by version."""
    pythons = {}
    for version in VERSIONS:
        places = [
            shutil.which(f"python{version}"),
            *map(str, sorted(Path.home().glob(f".pyenv/versions/{version}.*/bin/python"))),
        ]
        for place in filter(None, places):
            if sh(place, "-c", "import sys; print('%d.%d' % sys.version_info[:2])").stdout.strip() == version:
                pythons[version] = place
                break
    return pythons


class Clean:
    """An environment with the wheel and nothing else."""

    def __init__(self, python: str, folder: Path, wheel: Path, *more: str) -> None:
        self.folder = folder
        made = sh(python, "-m", "venv", folder)
        assert made.returncode == 0, made.stderr
        self.bin = folder / "bin"
        done = sh(self.bin / "pip", "install", "-q", wheel, *more)
        assert done.returncode == 0, done.stderr[-2000:]

    def run(self, *words: str, **changed: str | None) -> subprocess.CompletedProcess[str]:
        """`hophoop` with some variables of the environment changed, in an empty folder that everyone may write to."""
        before = changed.pop("before", None)
        whole = {"PATH": os.environ["PATH"], "HOME": str(self.folder / "home"), **changed}
        work = Path(tempfile.mkdtemp(dir=self.folder))
        work.chmod(0o777)
        environment = {name: value for name, value in whole.items() if value is not None}
        return sh(*(before or "").split(), self.bin / "hophoop", *words, env=environment, cwd=work)

    def read_only(self) -> subprocess.CompletedProcess[str]:
        """A motion where nothing in the environment, and no home, can be written to; root has to give up its right to."""
        before = "setpriv --bounding-set=-dac_override,-fowner" if os.getuid() == 0 else None
        home = self.folder / "home"
        home.mkdir(exist_ok=True)
        python = [*(before or "").split(), str(self.bin / "python"), "-c", "open(__import__('numpy').__file__, 'a')"]
        sh("chmod", "-R", "a-w", self.folder / "lib", home)
        try:
            tried = sh(*python)
            assert "PermissionError" in tried.stderr, "The environment could be written to."
            return self.run("run", "--json", before=before)
        finally:
            sh("chmod", "-R", "u+w", self.folder / "lib", home)


def check_extras(clean: Clean) -> str:
    """Each missing extra says its name."""
    for extra, asked in EXTRAS.items():
        done = sh(clean.bin / "python", "-c", asked) if isinstance(asked, str) else clean.run(*asked)
        said = done.stderr.strip().splitlines()[-1]
        assert f"hophoop[{extra}]" in said, (extra, done.stderr[-500:])
    return f"{len(EXTRAS)} of {len(EXTRAS)} say their name"


def _same(done: subprocess.CompletedProcess[str], whole: str) -> None:
    assert (done.returncode, done.stderr) == (0, ""), done.stderr[-500:]
    assert done.stdout == whole


def check_surroundings(clean: Clean) -> dict[str, str]:
    """What comes in poor surroundings, by what they are; the same output as elsewhere."""
    whole = clean.run("run", "--json").stdout
    assert '"schema": "hophoop/1"' in whole
    came = {"runs, with no extra": "yes", "each missing extra": check_extras(clean)}
    trials: dict[str, Callable[[], subprocess.CompletedProcess[str]]] = {
        "no HOME": lambda: clean.run("run", "--json", HOME=None),
        "LANG=C": lambda: clean.run("run", "--json", LANG="C", LC_ALL="C"),
        "NO_COLOR, 40 columns": lambda: clean.run("run", "--json", NO_COLOR="1", COLUMNS="40"),
    }
    if hasattr(os, "getuid") and (os.getuid() != 0 or shutil.which("setpriv")):
        trials["site-packages and HOME read-only"] = clean.read_only
    for name, trial in trials.items():
        _same(trial(), whole)
        came[name] = "the same output"
    environment = {"PATH": os.environ["PATH"], "HOPHOOP_KERNELS": "compiled"}
    both = [
        subprocess.Popen(
            [clean.bin / "hophoop", "run", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
        )
        for _ in range(2)
    ]
    for process in both:
        said, errors = process.communicate()
        assert process.returncode == 0, errors
        assert said == whole
    came["two first runs at once, compiled"] = "the same output"
    return came


def bounds(lowest: bool) -> list[str]:
    """Requirements for the tests: each at its lowest version, or as pyproject.toml has them."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    named = [*project["dependencies"]]
    for extra in ("plots", "maps", "test"):
        named += project["optional-dependencies"][extra]
    named = [name for name in named if not name.startswith(TOOLS)]
    return [re.sub(">=", "==", name) if lowest else name for name in named]


def check_bounds(python: str, folder: Path, source: Path, wheel: Path, lowest: bool) -> str:
    """How the fast tests of core, files and maps end with these versions."""
    clean = Clean(python, folder, wheel, *bounds(lowest))
    tests = [
        source / "tests" / name
        for name in ("physics", "scenario", "test_io.py", "files", "cli/test_cli_run.py", "maps/test_maps_hostile.py")
    ]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    words = ("-m", "pytest", "-q", "-p", "no:cacheprovider")  # without what is marked slow or long, as always
    done = sh(clean.bin / "python", *words, *tests, env=environment, cwd=source)
    last = done.stdout.strip().splitlines()[-1] if done.stdout.strip() else f"ended with {done.returncode}"
    print(done.stdout[-30000:], done.stderr[-2000:])
    return re.sub(r" in [\d.]+s.*", "", last)


def main() -> int:
    """Try what was asked for, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--python", action="append", help="an interpreter; may be repeated")
    parser.add_argument(
        "--bounds",
        nargs="?",
        const="too",
        choices=["too", "only", "lowest", "newest"],
        help="run the fast tests with the lowest and the newest versions; all but 'too': nothing else",
    )
    parser.add_argument("--markdown", type=Path, help="write the table to this file")
    options = parser.parse_args()
    pythons = found_pythons()
    if options.python:
        pythons = {
            sh(one, "-c", "import sys; print('%d.%d' % sys.version_info[:2])").stdout.strip(): one for one in options.python
        }
    rows = Rows(options.markdown)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        # the wheel and its tests stay together, whatever is changed meanwhile
        source = shutil.copytree(ROOT, folder / "source", ignore=shutil.ignore_patterns(".git", "node_modules", "__pycache__"))
        built = sh(sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "-w", folder, source)
        assert built.returncode == 0, built.stderr[-2000:]
        wheel = next(folder.glob("*.whl"))
        for version in VERSIONS if options.bounds in (None, "too") else ():
            if version not in pythons:
                if not options.python:
                    rows.missing(version)
                continue
            for what, came in check_surroundings(Clean(pythons[version], folder / version, wheel)).items():
                rows.add(version, what, came)
        if options.bounds:
            version, python = next(iter(pythons.items()))
            for lowest in {"lowest": (True,), "newest": (False,)}.get(options.bounds, (True, False)):
                came = check_bounds(python, folder / f"bounds-{lowest}", source, wheel, lowest)
                rows.add(version, f"{'lowest' if lowest else 'newest'} allowed versions, fast tests", came)
    text = rows.text()
    print(text, end="")
    return 0 if "failed" not in text and "ended with" not in text else 1


class Rows:
    """A table that is written after each row."""

    def __init__(self, file: Path | None) -> None:
        self.file = file
        lines = file.read_text(encoding="utf-8").splitlines()[2:] if file is not None and file.exists() else []
        self.rows = {tuple(cells[1:3]): cells[3] for cells in ([cell.strip() for cell in line.split("|")] for line in lines)}

    def add(self, version: str, what: str, came: str) -> None:
        """A row, in place of one of the same, and of one that says that there was no such Python."""
        self.rows.pop((f"Python {version}", NOTHING), None)
        self.rows[f"Python {version}", what] = came
        if self.file is not None:
            self.file.write_text(self.text(), encoding="utf-8")

    def missing(self, version: str) -> None:
        """Say that there is no such Python, unless it was tried before."""
        if not any(where == f"Python {version}" for where, _ in self.rows):
            self.add(version, NOTHING, "not found on the machine: not tried")

    def text(self) -> str:
        """Markdown, by versions."""
        rows = sorted(self.rows.items(), key=lambda row: row[0][0])
        lines = [f"| {where} | {what} | {came} |" for (where, what), came in rows]
        return "\n".join(["| Where | What was tried | What came |", "| --- | --- | --- |", *lines]) + "\n"


if __name__ == "__main__":
    raise SystemExit(main())
