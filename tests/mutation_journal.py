"""What came of each change, kept from run to run, and the changes themselves, which take long to make."""

from __future__ import annotations

import datetime
import hashlib
import json
import pickle
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from mutants import Mutant, mutants
from mutation_runs import SEEN


def digest(*parts: str | bytes) -> str:
    """A short name for some text."""
    found = hashlib.sha256()
    for part in parts:
        found.update(part.encode() if isinstance(part, str) else part)
        found.update(b"\0")
    return found.hexdigest()[:20]


def digest_of_tests(tests: Sequence[str]) -> str:
    """A name for what stands in the tests of a room."""
    files = sorted(file for test in tests for file in ([Path(test)] if Path(test).is_file() else Path(test).rglob("*.py")))
    return digest(*(part for file in files for part in (file.name, file.read_bytes())))


def kept_mutants(path: Path, folder: Path) -> list[Mutant]:
    """The changes of a module, made anew only if it or what makes them has changed."""
    makers = (Path(__file__).with_name("mutants.py"), path)
    file = folder / f"{path.stem}-{digest(str(path), *(one.read_bytes() for one in makers))}.mutants"
    if not file.exists():
        folder.mkdir(parents=True, exist_ok=True)
        file.write_bytes(pickle.dumps([tuple(one) for one in mutants(path)]))
    return [Mutant(*one) for one in pickle.loads(file.read_bytes())]


class Journal:
    """A file with a line for each change that was tried.

    What a test saw is known as long as its module is the same; what none saw is tried again when the tests have changed.
    """

    def __init__(self, file: Path, tests: str) -> None:
        self.file = file
        self.tests = tests
        self.known: dict[str, dict[str, Any]] = {}
        for line in self.file.read_text(encoding="utf-8").splitlines() if file.exists() else ():
            entry = json.loads(line)
            self.known[entry["change"]] = entry

    def entry(self, mutant: Mutant) -> dict[str, Any] | None:
        """What came of a change, if that still holds."""
        found = self.known.get(_name(mutant))
        return found if found is not None and (found["status"] == SEEN or found["tests"] == self.tests) else None

    def missing(self, made: Iterable[Mutant]) -> list[Mutant]:
        """The changes that are still to be tried."""
        return [one for one in made if self.entry(one) is None]

    def add(self, mutant: Mutant, status: str) -> None:
        """Write down what came."""
        entry = {"change": _name(mutant), "status": status, "tests": self.tests, "on": datetime.date.today().isoformat()}
        self.known[entry["change"]] = entry
        with self.file.open("a", encoding="utf-8") as stream:
            stream.write(json.dumps(entry) + "\n")


def _name(mutant: Mutant) -> str:
    return digest(mutant.path.stem, mutant.source)
