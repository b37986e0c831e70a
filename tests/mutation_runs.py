"""Tests run with one change of the source after the other, each in a process of its own that is forked when all is imported.

A first run without a change notes which test comes to which statement (`mutation_reach`). A module of tests may have a function
`before_changes`, which computes once what it compares with, and calls nothing that is changed. A change within a function is
then made by giving the function other code, and only the tests that come to the changed statement are run, those first that saw
other changes of the function, then the quickest, until one fails. A change outside of functions, or in one that only runs as
modules are imported, is made as the module is imported, with all tests, those of the module first.
"""

from __future__ import annotations

import contextlib
import functools
import gc
import importlib
import importlib.abc
import importlib.util
import json
import mmap
import os
import resource
import signal
import sys
from collections import Counter, defaultdict
from collections.abc import Callable, Collection, Sequence
from pathlib import Path
from types import FunctionType
from typing import Any, NamedTuple

from mutants import Key, Mutant, codes, functions
from mutation_reach import Reach, noted, silence

# s of the processor, which others may share, that a test may take with a change, beside ten times what it took without: what
# never ends has been seen. What waits without computing is given more of the clock's.
SECONDS = 4.0
WAITS = 30.0  # times more
LONGEST = 5.0  # s; a test that takes longer without a change is left out
BRIEF = 1.0  # s that the tests of a change take that nothing can see, as is said
MEMORY = 8 * 2**30  # bytes; what eats more has been seen
WORDS = ("-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:randomly", "-s", "-W", "ignore", "--timeout=0")

SEEN, UNSEEN, UNREACHED = "seen", "unseen", "unreached"
IMPORTED = "imported"  # to be tried where the module is imported
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


class Tests(NamedTuple):
    """What is run for a change."""

    paths: Sequence[str]
    patience: float  # s that the tests of one change take together, without the change; one test may take longer
    reach: Path  # where it is kept which test comes to which statement
    explained: Collection[Key]  # changes that nothing can see, as is said: tried briefly
    compiled: bool  # whether kernels are: they are loaded before the processes part


def run_all(made: Sequence[Mutant], names: dict[Path, str], tests: Tests, report: Report) -> None:
    """Try changes of modules that have these names.

    Here nothing of hophoop is imported: all of it is left to processes forked from this one.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        status = 1
        with os.fdopen(writing, "w") as stream:
            numbers = {id(mutant): k for k, mutant in enumerate(made)}

            def tell(mutant: Mutant, status: str) -> None:
                stream.write(json.dumps([numbers[id(mutant)], status]) + "\n")
                stream.flush()

            with contextlib.suppress(SystemExit):
                runner = Runner([one for one in made if one.function], names, tests, tell)
                _run_within(runner)
                stream.write(json.dumps(runner.orders) + "\n")
                status = 0
        os._exit(status)
    os.close(writing)
    orders: dict[str, list[list[str]]] = {}
    anew = [mutant for mutant in made if not mutant.function]
    with os.fdopen(reading) as stream:
        for line in stream:
            told = json.loads(line)
            if isinstance(told, dict):
                orders = told
            elif told[1] == IMPORTED:
                anew.append(made[told[0]])
            else:
                report(made[told[0]], told[1])
    if os.waitpid(child, 0)[1] != 0:
        raise SystemExit("The tests do not run or do not pass without a change.")
    for mutant in anew:
        order = orders[str(mutant.path)][mutant.key in tests.explained]
        passed = _run_anew(mutant, names[mutant.path], tests.paths, order) == 0
        report(mutant, SEEN if not passed else UNREACHED if mutant.function else UNSEEN)


def _run_anew(mutant: Mutant, name: str, tests: Sequence[str], order: Sequence[str]) -> int:
    """The status of all tests where the changed module is imported."""
    places = {node: k for k, node in enumerate(order)}

    class Order:
        """Only the tests of that order, in that order."""

        def pytest_collection_modifyitems(self, items: list[Any]) -> None:
            """Sort them."""
            items[:] = sorted((one for one in items if one.nodeid in places), key=lambda one: places[one.nodeid])
            _shorten(items)

    def seen() -> int:
        import pytest

        _limit(WAITS * SECONDS)
        sys.meta_path.insert(0, Found(name, mutant))
        return int(pytest.main([*WORDS, *tests], plugins=[Order()]))

    return _forked(seen)


def _limit(seconds: float) -> None:
    signal.setitimer(signal.ITIMER_PROF, seconds)
    signal.setitimer(signal.ITIMER_REAL, WAITS * seconds)


def _shorten(items: Sequence[Any]) -> None:
    """Hypothesis stops at the first counterexample: nobody reads a shorter one here."""
    from hypothesis import Phase, settings

    for item in items:
        function = getattr(item, "obj", None)
        function = getattr(function, "__func__", function)
        before = getattr(function, "_hypothesis_internal_use_settings", None)
        if before is not None:
            phases = tuple(phase for phase in before.phases if phase in (Phase.explicit, Phase.generate))
            function._hypothesis_internal_use_settings = settings(before, phases=phases, report_multiple_bugs=False)  # type: ignore[union-attr]


def _run_within(runner: Runner) -> None:
    import pytest

    for name in runner.names.values():
        importlib.import_module(name)
    if runner.tests.compiled:
        _load_kernels()
    status = pytest.main([*WORDS, *runner.tests.paths], plugins=[runner])
    if status != 0 or not runner.ran:
        print(f"pytest ends with {status}.", file=sys.stderr)
        raise SystemExit(1)


def _load_kernels() -> None:
    import hophoop

    for contact in (hophoop.Rigid(), hophoop.Compliant()):
        hophoop.simulate(hophoop.Scenario(duration=0.01, contact=contact)).at(0.01)


class Runner:
    """A plugin of pytest that takes the place of its loop over the tests."""

    def __init__(self, made: Sequence[Mutant], names: dict[Path, str], tests: Tests, report: Report) -> None:
        self.made = made
        self.names = names
        self.tests = tests
        self.report = report
        self.ran = False
        self.orders: dict[str, list[list[str]]] = {}  # tests of each module, the most telling first; those of a brief try
        self.wins: Counter[tuple[Path, str, int]] = Counter()  # changes of a function that a test saw

    def pytest_runtestloop(self, session: Any) -> bool:
        """Note who comes where, then run the tests of each change."""
        if session.testsfailed:
            return True
        _shorten(session.items)
        reach = noted(session, {str(path) for path in self.names}, LONGEST, self.tests.reach)
        print(f"... {len(reach.known())} of {len(reach.took)} tests are quick enough", file=sys.stderr, flush=True)
        found = _functions({str(path) for path in self.names})
        for module in {item.module for item in session.items if hasattr(item, "module")}:
            getattr(module, "before_changes", lambda: None)()
        gc.collect()
        gc.freeze()
        for mutant in self.made:
            self.report(mutant, self._status(mutant, session, reach, found))
        self.orders = {str(path): self._order(path, session, reach) for path in self.names}
        self.ran = True
        return True

    def _status(self, mutant: Mutant, session: Any, reach: Reach, found: dict[tuple[str, str], list[FunctionType]]) -> str:
        key = (mutant.path, mutant.function)
        items = sorted(reach.tests(mutant.path, mutant.line), key=lambda k: reach.took[k] / (1.0 + 5.0 * self.wins[*key, k]))
        if not items:
            body = {line for line, name in places(mutant.path).items() if name == mutant.function}
            return UNREACHED if any((str(mutant.path), line) in reach.lines for line in body) else IMPORTED
        changed = found[str(mutant.path), mutant.function]
        if not changed:
            raise SystemExit(f"{mutant.function} of {mutant.path.name} is not in memory.")
        items = within(items, reach.took, BRIEF if mutant.key in self.tests.explained else self.tests.patience)
        which = mmap.mmap(-1, 8)  # the test that fails, told by the child

        def seen() -> int:
            _change(mutant, changed)
            return _run(session, items, reach.took, which)

        if _forked(seen) == 0:
            return UNSEEN
        self.wins[*key, int.from_bytes(which[:8], "big")] += 1
        return SEEN

    def _order(self, path: Path, session: Any, reach: Reach) -> list[list[str]]:
        touching = reach.touching(path)
        own = {k for k, item in enumerate(session.items) if item.path.stem == f"test_{path.stem}"}
        known = sorted(reach.known(), key=lambda k: (k not in own, k not in touching, reach.took[k]))
        both = (within(known, reach.took, patience) for patience in (self.tests.patience, BRIEF))
        return [[session.items[k].nodeid for k in chosen] for chosen in both]


def within(items: Sequence[int], took: Sequence[float], patience: float) -> list[int]:
    """The first of some tests that together take no longer than that, at least one."""
    chosen, total = [], 0.0
    for k in items:
        total += took[k]
        if chosen and total > patience:
            break
        chosen.append(k)
    return chosen


def _change(mutant: Mutant, changed: Sequence[FunctionType]) -> None:
    code = codes(compile(mutant.source, str(mutant.path), "exec"))[mutant.function]
    for function in changed:
        function.__code__ = code


@functools.cache
def places(path: Path) -> dict[int, str]:
    """For each line within a function of a module, its name."""
    return functions(path.read_text(encoding="utf-8"))


def _functions(files: set[str]) -> dict[tuple[str, str], list[FunctionType]]:
    """Functions of some files that are in memory; there may be several of one."""
    found = defaultdict(list)
    gc.unfreeze()  # what was imported as tests were collected (conftest.py) is not listed otherwise
    for thing in gc.get_objects():
        if isinstance(thing, FunctionType) and thing.__code__.co_filename in files:
            found[thing.__code__.co_filename, thing.__code__.co_qualname].append(thing)
    return found


def _run(session: Any, indices: Sequence[int], took: Sequence[float], which: mmap.mmap) -> int:
    """1 as soon as a test fails, 0 if none does."""
    for at, k in enumerate(indices):
        item = session.items[k]
        which[:8] = k.to_bytes(8, "big")
        _limit(SECONDS + 10.0 * took[k])
        following = session.items[indices[at + 1]] if at + 1 < len(indices) else None
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
        if session.testsfailed:
            return 1
    return 0


def _forked(work: Callable[[], int]) -> int:
    """The status of some work in a process of its own."""
    child = os.fork()
    if child == 0:
        status = 1
        with contextlib.suppress(BaseException), silence():
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            status = work()
        os._exit(min(status, 9))
    _, status = os.waitpid(child, 0)
    return status
