"""What Numba compiles of a kernel: its callees, the hash of its code, and what is compiled again."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from hophoop.kernel.native import inline, interpreted_as, noinline, sources
from hophoop.kernel.native.marks import mark_of, source_of

pytest.importorskip("numba")
from hophoop.kernel.build import lowering
from hophoop.kernel.build.kept import folder, keep, kept
from hophoop.kernel.build.link import TARGETS, object_of, own_target


def by_python(value):
    return ("python", value)


@interpreted_as(by_python)
@inline
def by_loops(value, more=2):
    """Documented."""
    return ("loops", value, more)


@noinline
def spread(one, other):
    return abs(one - other)


@noinline
def long_one(value):
    return by_loops(value)


def test_python_runs_the_other_function_under_the_name_of_the_kernel():
    assert (mark_of(by_loops), mark_of(long_one), mark_of(by_python)) == ("alwaysinline", "noinline", "")
    assert by_loops(1) == ("python", 1)
    assert source_of(by_loops)(1) == ("loops", 1, 2)
    assert source_of(long_one) is long_one
    assert (by_loops.__name__, by_loops.__module__, by_loops.__doc__) == ("by_loops", __name__, "Documented.")


@pytest.fixture
def as_kernels(monkeypatch):
    """The functions of this module are kernels."""
    for module in (sources, lowering):
        monkeypatch.setattr(module, "is_kernel", lambda value: getattr(value, "__module__", None) == __name__)


def test_a_copy_calls_replacements(as_kernels):
    assert sources.called(long_one) == [by_loops]
    assert lowering.copied(long_one, lambda kernel: source_of(kernel))(5) == ("loops", 5, 2)
    assert long_one(5) == ("python", 5)  # the module's own names are as before


def made_of(text, **names):
    exec(text, names)
    return names["kernel"]


def test_the_hash_of_a_kernel_changes_with_instructions_constants_and_marks_alone():
    first = sources.own_hash(made_of("def kernel(x):\n    return x + K", K=1.0))
    same = "def kernel(x):\n    'Documented.'\n    # why\n\n    return x + K"
    assert sources.own_hash(made_of(same, K=1.0, more=3)) == first
    others = [
        made_of("def kernel(x):\n    return x - K", K=1.0),
        made_of("def kernel(x):\n    return x + K", K=1.5),
        made_of("def kernel(x):\n    return x + K", K=np.ones(2)),
        made_of("def kernel(x):\n    return x + K", K=np.zeros(2)),
        noinline(made_of("def kernel(x):\n    return x + K", K=1.0)),
    ]
    assert len({first, *map(sources.own_hash, others)}) == 6


CALLEE = "def callee(x, more=1.0):\n    return {}\n"
CALLER = "def caller(x):\n    return callee(x) + 1\n"
BUILT = """
from hophoop.kernel.build.processes import begin
begin()
from numba import types
from hophoop.kernel.build import lowering
from hophoop.kernel.native import sources
lowering.is_kernel = sources.is_kernel = lambda value: getattr(value, "__module__", None) == "pair"
import pair
print(lowering.part_of(pair.caller, (types.float64,)).result)
"""


@pytest.mark.long
def test_a_change_of_a_callee_compiles_its_callers_only_if_it_gives_another_type(tmp_path):
    kept = tmp_path / "kept"

    def compiled(gives):
        """What the caller gives, and what was compiled."""
        (tmp_path / "pair.py").write_text(CALLEE.format(gives) + CALLER)
        before = {(file.name, file.stat().st_mtime_ns) for file in kept.glob("*")}
        surroundings = os.environ | {"PYTHONPATH": str(tmp_path), "HOPHOOP_BUILD_CACHE": str(kept)}
        result = subprocess.check_output([sys.executable, "-B", "-c", BUILT], text=True, env=surroundings).strip()
        after = {(file.name, file.stat().st_mtime_ns) for file in kept.glob("*")}
        return result, sorted(name.split(".")[1] for name, _ in after - before)

    assert compiled("x * more") == ("float64", ["callee", "caller"])
    assert compiled("x - more") == ("float64", ["callee"])
    assert compiled("x > more") == ("int64", ["callee", "caller"])
    assert compiled("x > more") == ("int64", [])


def test_code_that_numba_optimizes_is_refused(monkeypatch):
    monkeypatch.setattr(lowering.numba.config, "OPT", 3)
    monkeypatch.setattr(lowering, "_parts", {})
    with pytest.raises(RuntimeError, match=r"after build\.processes\.begin"):
        lowering.part_of(made_of("def kernel(x):\n    return x + K", K=1.0), (lowering.types.float64,))


@pytest.mark.parametrize("damaged", [b"", b"cnothing\nat all\n."])
def test_a_damaged_file_of_an_earlier_build_is_made_again(tmp_path, monkeypatch, damaged):
    """Code of a kernel, and an object file, which the linker would refuse."""
    monkeypatch.setenv("HOPHOOP_BUILD_CACHE", str(tmp_path))
    monkeypatch.setattr(lowering.numba.config, "OPT", type(lowering.numba.config.OPT)(0))
    monkeypatch.setattr(lowering, "_parts", {})
    target, kinds = own_target(), (lowering.types.float64, lowering.types.float64)

    def linked(part):
        return object_of(part.simple, [part.symbol], target, next(iter(TARGETS[target].levels)))

    first = lowering.part_of(spread, kinds)
    code, files = linked(first), list(tmp_path.iterdir())
    assert len(files) == 2
    for file in files:
        file.write_bytes(damaged)
        assert kept(file.name) is None
    lowering._parts.clear()
    again = lowering.part_of(spread, kinds)
    assert (again.symbol, again.gives(), linked(first)) == (first.symbol, first.gives(), code)
    assert all(kept(file.name) for file in files)


def test_without_a_home_directory_nothing_is_kept(monkeypatch):
    monkeypatch.delenv("HOPHOOP_BUILD_CACHE", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)

    def no_home():
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(Path, "home", no_home)
    keep("a file", b"content")
    assert (folder(), kept("a file")) == (None, None)
