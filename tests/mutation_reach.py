"""Which tests come to which statement, and how long each of them takes, found by one run of them all."""

from __future__ import annotations

import ast
import contextlib
import json
import os
import signal
import sys
import time
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple


class Reach(NamedTuple):
    """Tests by their place in the order in which pytest has them."""

    took: list[float]  # s of the processor; inf for a test that was given up
    lines: dict[tuple[str, int], frozenset[int]]  # tests that come to a line of a file

    def tests(self, path: Path, line: int) -> set[int]:
        """Those that come to the statement on that line, and were not given up."""
        found = {k for at in statement_lines(path, line) for k in self.lines.get((str(path), at), ())}
        return {k for k in found if self.took[k] < float("inf")}

    def known(self) -> list[int]:
        """All that were not given up."""
        return [k for k, took in enumerate(self.took) if took < float("inf")]

    def touching(self, path: Path) -> set[int]:
        """Those that come to any statement of a module."""
        return {k for (file, _), found in self.lines.items() if file == str(path) for k in found}


def statement_lines(path: Path, line: int) -> range:
    """The lines of the statement there; of one that holds others, those before the others."""
    holding = [
        node
        for node in ast.walk(_tree(path))
        if isinstance(node, ast.stmt) and node.lineno <= line <= (node.end_lineno or node.lineno)
    ]
    if not holding:
        return range(line, line + 1)
    node = min(holding, key=lambda one: (one.end_lineno or one.lineno) - one.lineno)
    body = getattr(node, "body", None)
    end = body[0].lineno - 1 if body else node.end_lineno or node.lineno
    # a line such as `except`, which is no statement, stands for itself
    return range(node.lineno, end + 1) if line <= end else range(line, line + 1)


_trees: dict[Path, ast.Module] = {}


def _tree(path: Path) -> ast.Module:
    if path not in _trees:
        _trees[path] = ast.parse(path.read_text(encoding="utf-8"))
    return _trees[path]


def noted(session: Any, files: set[str], longest: float, kept: Path) -> Reach:
    """Run all tests in a process of its own, or read from a file what an earlier run found.

    A test that needs more than `longest` s of the processor is given up.
    """
    if not kept.exists():
        kept.write_text(_noted(session, files, longest), encoding="utf-8")
    took, lines = json.loads(kept.read_text(encoding="utf-8"))
    return Reach(took, {(file, line): frozenset(tests) for file, line, tests in lines})


def _noted(session: Any, files: set[str], longest: float) -> str:
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        status = 1
        with contextlib.suppress(BaseException), silence():
            text = json.dumps(_note(session, files, longest))
            status = int(session.testsfailed > 0)
            with os.fdopen(writing, "w") as stream:
                stream.write(text)
        os._exit(status)
    os.close(writing)
    with os.fdopen(reading) as stream:
        text = stream.read()
    _, status = os.waitpid(child, 0)
    if status != 0:
        raise SystemExit("A test fails without a change, or cannot run.")
    return text


def _note(session: Any, files: set[str], longest: float) -> tuple[list[float], list[tuple[str, int, list[int]]]]:
    import coverage
    import pytest

    items = session.items
    watch = coverage.Coverage(data_file=None, include=sorted(files), config_file=False, messages=False)
    now = [""]
    fixtures: dict[Any, str] = {}

    def enter(name: str) -> None:
        now.append(name)
        watch.switch_context(name)

    def leave() -> None:
        now.pop()
        watch.switch_context(now[-1])

    class Fixtures:
        """What a fixture calls counts for every test that has it."""

        @pytest.hookimpl(wrapper=True)
        def pytest_fixture_setup(self, fixturedef: Any, request: Any) -> Any:
            enter(fixtures.setdefault(fixturedef, f"fixture {len(fixtures)}"))
            try:
                return (yield)
            finally:
                leave()

    session.config.pluginmanager.register(Fixtures())
    signal.signal(signal.SIGPROF, lambda number, frame: pytest.skip("takes too long here"))
    took = []
    watch.start()
    for k, item in enumerate(items):
        enter(str(k))
        began = time.process_time()
        signal.setitimer(signal.ITIMER_PROF, longest)
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=items[k + 1] if k + 1 < len(items) else None)
        given_up = signal.setitimer(signal.ITIMER_PROF, 0.0)[0] == 0.0
        took.append(float("inf") if given_up else time.process_time() - began)
        leave()
    watch.stop()
    return took, list(_by_line(watch.get_data(), files, items, fixtures))


def _by_line(data: Any, files: set[str], items: Any, fixtures: dict[Any, str]) -> Iterator[tuple[str, int, list[int]]]:
    having = defaultdict(set)
    for k, item in enumerate(items):
        info = getattr(item, "_fixtureinfo", None)
        for definitions in info.name2fixturedefs.values() if info else ():
            for definition in definitions:
                if definition in fixtures:
                    having[fixtures[definition]].add(k)
    for file in sorted(files):
        for line, names in data.contexts_by_lineno(file).items():
            found: set[int] = set()
            for name in names:
                found |= {int(name)} if name.isdigit() else having[name]
            if found:
                yield file, line, sorted(found)


@contextlib.contextmanager
def silence() -> Iterator[None]:
    """What is written to the terminal is thrown away, and nothing is read from it: a change that reads would wait for ever."""
    sys.stdout.flush()
    with open(os.devnull, "r+") as nothing:
        for number in (0, 1, 2):
            os.dup2(nothing.fileno(), number)
        yield
