"""Tests run with one change of the source after the other, each in a process of its own that is forked when all is imported.

A first run without a change notes which test calls which function. A module of tests may have a function `before_changes`,
which computes once what it compares with, and calls nothing that is changed. A change within a function is then made by giving
the function other code, and only the tests that call it are run, the quickest first. A change outside of functions is made
as the module is imported, with all tests.
"""

from __future__ import annotations

import contextlib
import gc
import importlib.abc
import importlib.util
import json
import os
import resource
import signal
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from types import FunctionType
from typing import Any

from mutants import Mutant, codes

# s of the processor, which others may share, that tests may take with one change, beside ten times what they took without: what
# never ends has been seen. What waits without computing is given more of the clock's.
SECONDS = 4.0
WAITS = 30.0  # times more
MEMORY = 8 * 2**30  # bytes; what eats more has been seen
WORDS = ("-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:randomly", "-s", "-W", "ignore")

SEEN, UNSEEN, UNREACHED = "seen", "unseen", "unreached"
Report = Callable[[Mutant, str], None]


class Found(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Imports one module with another source."""

    def __init__(self, name: str, mutant: Mutant) -> None:
        self.name = name
        self.mutant = mutant

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        """The module of that name, if it is the changed one."""
        return importlib.util.spec_from_loader(name, self) if name == self.name else None

    def exec_module(self, module: Any) -> None:
        """Run the changed source."""
        module.__file__ = str(self.mutant.path)
        exec(compile(self.mutant.source, module.__file__, "exec"), module.__dict__)


def run_anew(made: Sequence[Mutant], names: dict[Path, str], tests: Sequence[str], report: Report) -> None:
    """Changes outside of functions: Python starts with the changed module, and all tests run."""
    for mutant in made:
        # the tests of the module itself first: they mostly see it, and start quickly
        own = [str(file) for test in tests for file in Path(test).glob(f"test_{mutant.path.stem}.py")]
        status = 0
        for some in [own, list(tests)] if own else [list(tests)]:

            def seen(mutant: Mutant = mutant, some: list[str] = some) -> int:
                import pytest

                _limit(4.0 * SECONDS)
                sys.meta_path.insert(0, Found(names[mutant.path], mutant))
                return int(pytest.main([*WORDS, *some]))

            status = status or _forked(seen)
        report(mutant, UNSEEN if status == 0 else SEEN)


def _limit(seconds: float) -> None:
    signal.setitimer(signal.ITIMER_PROF, seconds)
    signal.setitimer(signal.ITIMER_REAL, WAITS * seconds)


def run_within(made: Sequence[Mutant], tests: Sequence[str], report: Report) -> None:
    """Changes within functions, from a process that keeps what is imported there to itself."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        status = 1
        with os.fdopen(writing, "w") as stream:
            numbers = {id(mutant): k for k, mutant in enumerate(made)}

            def tell(mutant: Mutant, status: str) -> None:
                stream.write(f"{numbers[id(mutant)]} {status}\n")
                stream.flush()

            with contextlib.suppress(SystemExit):
                _run_within(made, tests, tell)
                status = 0
        os._exit(status)
    os.close(writing)
    with os.fdopen(reading) as stream:
        for line in stream:
            number, status = line.split()
            report(made[int(number)], status)
    if os.waitpid(child, 0)[1] != 0:
        raise SystemExit("The tests do not run or do not pass without a change.")


def _run_within(made: Sequence[Mutant], tests: Sequence[str], report: Report) -> None:
    import pytest

    runner = Runner(made, report)
    status = pytest.main([*WORDS, *tests], plugins=[runner])
    if status != 0 or not runner.ran:
        print(f"pytest ends with {status}.", file=sys.stderr)
        raise SystemExit(1)


class Runner:
    """A plugin of pytest that takes the place of its loop over the tests."""

    def __init__(self, made: Sequence[Mutant], report: Report) -> None:
        self.made = made
        self.report = report
        self.ran = False

    def pytest_runtestloop(self, session: Any) -> bool:
        """Note who calls what, then run the tests of each change."""
        if session.testsfailed:
            return True
        calls, took = _noted(session, {str(mutant.path) for mutant in self.made})
        functions = _functions({str(mutant.path) for mutant in self.made})
        for module in {item.module for item in session.items if hasattr(item, "module")}:
            getattr(module, "before_changes", lambda: None)()
        gc.collect()
        gc.freeze()
        for mutant in self.made:
            items = sorted(calls.get((str(mutant.path), mutant.function), ()), key=lambda k: took[k])
            if not items:
                self.report(mutant, UNREACHED)
                continue

            def seen(mutant: Mutant = mutant, items: list[int] = items) -> int:
                _limit(SECONDS + 10.0 * sum(took[k] for k in items))
                _change(mutant, functions[str(mutant.path), mutant.function])
                return _run(session, items)

            self.report(mutant, UNSEEN if _forked(seen) == 0 else SEEN)
        self.ran = True
        return True


def _change(mutant: Mutant, functions: Sequence[FunctionType]) -> None:
    code = codes(compile(mutant.source, str(mutant.path), "exec"))[mutant.function]
    for function in functions:
        function.__code__ = code


def _functions(files: set[str]) -> dict[tuple[str, str], list[FunctionType]]:
    """Functions of some files that are in memory; decorators may have made several of one."""
    found = defaultdict(list)
    for thing in gc.get_objects():
        if isinstance(thing, FunctionType) and thing.__code__.co_filename in files:
            found[thing.__code__.co_filename, thing.__code__.co_qualname].append(thing)
    return found


def _run(session: Any, indices: Sequence[int]) -> int:
    """1 as soon as a test fails, 0 if none does."""
    items = [session.items[k] for k in indices]
    for k, item in enumerate(items):
        following = items[k + 1] if k + 1 < len(items) else None
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
        if session.testsfailed:
            return 1
    return 0


def _noted(session: Any, files: set[str]) -> tuple[dict[tuple[str, str], set[int]], list[float]]:
    """Which tests call which function, and how long each test takes; found in a process of its own."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        status = 1
        with contextlib.suppress(BaseException), _silence():
            text = json.dumps(_note(session, files))
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
    took, called = json.loads(text)
    return {(file, function): set(items) for file, function, items in called}, took


def _note(session: Any, files: set[str]) -> tuple[list[float], list[tuple[str, str, list[int]]]]:
    import pytest

    items = session.items
    called: dict[tuple[str, str], set[int]] = defaultdict(set)
    by_fixture: dict[Any, set[tuple[str, str]]] = defaultdict(set)
    now: list[set[tuple[str, str]]] = []

    def profile(frame: Any, event: str, argument: Any) -> None:
        if event == "call" and frame.f_code.co_filename in files and now:
            now[-1].add((frame.f_code.co_filename, frame.f_code.co_qualname.partition(".<locals>")[0]))

    class Fixtures:
        """What a fixture calls counts for every test that has it."""

        @pytest.hookimpl(wrapper=True)
        def pytest_fixture_setup(self, fixturedef: Any, request: Any) -> Any:
            now.append(by_fixture[fixturedef])
            try:
                return (yield)
            finally:
                now.pop()

    session.config.pluginmanager.register(Fixtures())
    took = []
    sys.setprofile(profile)
    try:
        for k, item in enumerate(items):
            own: set[tuple[str, str]] = set()
            now.append(own)
            began = time.process_time()
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=items[k + 1] if k + 1 < len(items) else None)
            took.append(time.process_time() - began)
            now.pop()
            for key in own:
                called[key].add(k)
    finally:
        sys.setprofile(None)
    for k, item in enumerate(items):
        info = getattr(item, "_fixtureinfo", None)
        for definitions in info.name2fixturedefs.values() if info else ():
            for definition in definitions:
                for key in by_fixture.get(definition, ()):
                    called[key].add(k)
    return took, [(*key, sorted(found)) for key, found in called.items()]


def _forked(work: Callable[[], int]) -> int:
    """The status of some work in a process of its own."""
    child = os.fork()
    if child == 0:
        status = 1
        with contextlib.suppress(BaseException), _silence():
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            status = work()
        os._exit(min(status, 9))
    _, status = os.waitpid(child, 0)
    return status


@contextlib.contextmanager
def _silence() -> Iterator[None]:
    with open(os.devnull, "w") as nothing:
        for number in (1, 2):
            os.dup2(nothing.fileno(), number)
        yield
