"""What the kernels' decorators promise: interpreted at first, compiled when worth it, the same bits either way."""

import errno
import json
import math
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numba.core import caching, registry

import compile_ahead
import hophoop as hh
import small_kernels
from hophoop._jit import beside, compiled, dispatchers, forced, policy, signals, store
from hophoop._jit.kernels import Options, describe
from hophoop._jit.policy import Kernel

SOURCE = Path(hh.__file__).parents[1]
COUNT = 20_000_000  # ten seconds interpreted, an instant compiled
SUM = COUNT * (COUNT - 1) / 2


@pytest.fixture
def fresh(tmp_path, monkeypatch):
    """No compiled code anywhere, and kernels that have not been called."""
    for kernel in policy.KERNELS:
        if kernel.py_func.__module__ == "small_kernels":
            for name, value in (("_calls", {}), ("_loaded", {}), ("_target", kernel._choose)):
                monkeypatch.setattr(kernel, name, value)
    monkeypatch.setattr(store, "root_folder", lambda: tmp_path)
    monkeypatch.setattr(beside, "root_folder", lambda: tmp_path)
    monkeypatch.setattr(beside, "_jobs", {})
    monkeypatch.setattr(dispatchers, "_entries", {})
    monkeypatch.delenv("HOPHOOP_KERNELS", raising=False)
    monkeypatch.delenv("NUMBA_DISABLE_JIT", raising=False)
    store._mark.cache_clear()
    yield tmp_path
    store._mark.cache_clear()


def python(code, **environment):
    """Output of a fresh Python."""
    path = os.pathsep.join([str(SOURCE), str(Path(__file__).parent)])
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": path, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


# Interpreted at first


FIRST = """
import json, sys
import hophoop as hh
motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
sample = motion.at([0.5, 1.1])
print(json.dumps([motion.to_dict(), sample.omega.tolist(), "numba" in sys.modules]))
"""


def test_the_first_motion_on_a_cold_cache_needs_no_numba(tmp_path):
    cold = json.loads(python(FIRST, NUMBA_CACHE_DIR=str(tmp_path), HOPHOOP_KERNELS="auto"))
    assert cold[-1] is False
    assert not list(tmp_path.iterdir())  # nor does it compile anything
    warm = json.loads(python(FIRST, HOPHOOP_KERNELS="compiled"))
    assert warm[-1] is True
    assert cold[:-1] == warm[:-1]


def test_numba_disable_jit_is_respected():
    assert json.loads(python(FIRST, NUMBA_DISABLE_JIT="1", HOPHOOP_KERNELS="compiled"))[-1] is False


def test_a_mode_that_there_is_not(fresh, monkeypatch):
    monkeypatch.setenv("HOPHOOP_KERNELS", "fast")
    with pytest.raises(ValueError, match="HOPHOOP_KERNELS = 'fast' must be one of auto, compiled, interpreted"):
        small_kernels.root(4.0)


def test_short_calls_stay_interpreted(fresh):
    assert small_kernels.summed(10, np.empty(1)) == 45.0
    assert not small_kernels.summed._loaded
    assert not list(fresh.iterdir())


# Changing over


@pytest.mark.long
def test_a_long_call_changes_over_while_it_runs(fresh, monkeypatch):
    monkeypatch.setattr(policy, "PATIENCE_TO_COMPILE", 0.0)
    monkeypatch.setattr(policy, "PATIENCE_TO_LOAD", 0.0)
    out = np.empty(1)
    assert small_kernels.summed(100 * COUNT, out) == pytest.approx(10_000 * SUM)  # a quarter of an hour interpreted
    assert out[0] == pytest.approx(10_000 * SUM)
    assert small_kernels.summed._loaded


def test_code_on_disk_is_loaded_when_patience_is_over(fresh, monkeypatch):
    arguments = 1000, np.empty(1)
    dispatchers.compile_for(small_kernels.summed, tuple(describe(value) for value in arguments))
    assert small_kernels.summed(*arguments) == 499500.0
    assert not small_kernels.summed._loaded
    monkeypatch.setattr(policy, "PATIENCE_TO_LOAD", 0.0)
    assert small_kernels.summed(*arguments) == 499500.0
    assert small_kernels.summed._loaded
    assert not beside._jobs
    # and at once when interpreted calls have come between
    with forced("interpreted"):
        assert small_kernels.summed(*arguments) == 499500.0
    assert small_kernels.summed(*arguments) == 499500.0
    assert small_kernels.summed._target in small_kernels.summed._loaded.values()


def test_other_arguments_begin_interpreted_again(fresh):
    assert compiled(small_kernels.quotient, 1.0, 4.0)(1.0, 4.0) == 0.25
    assert len(small_kernels.quotient._loaded) == 1
    assert small_kernels.quotient(np.float32(1.0), np.float32(4.0)) == 0.25
    assert len(small_kernels.quotient._loaded) == 1


def test_where_no_process_can_be_started_it_compiles_by_itself(fresh, monkeypatch):
    monkeypatch.setattr(sys, "executable", str(fresh / "no-python"))
    for name in ("PATIENCE_TO_LOAD", "PATIENCE_TO_COMPILE", "PATIENCE_TO_WAIT"):
        monkeypatch.setattr(policy, name, 0.05)
    assert small_kernels.summed(COUNT, np.empty(1)) == pytest.approx(SUM)
    assert small_kernels.summed._loaded


@pytest.fixture
def asked_for_code(monkeypatch):
    """Sends this process a signal while LLVM, loading a kernel, asks Numba for its code on disk."""
    engine = registry.cpu_target.target_context.codegen()._engine._ee
    ask = engine._object_cache_getbuffer

    def send(*numbers):
        left = list(numbers)

        def interrupted(module):
            while left:
                signal.raise_signal(left.pop(0))
            return ask(module)

        monkeypatch.setattr(engine, "_object_cache_getbuffer", interrupted)

    return send


@pytest.mark.filterwarnings("error::pytest.PytestUnraisableExceptionWarning")
def test_ctrl_c_while_a_kernel_is_loaded_is_not_lost(fresh, asked_for_code):
    """It was raised inside of a callback of LLVM, printed there, and the program went on."""
    before = signal.getsignal(signal.SIGINT)
    asked_for_code(signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        small_kernels.summed.load(tuple(describe(value) for value in (1, np.empty(1))))
    assert signal.getsignal(signal.SIGINT) is before
    assert store.is_ready(small_kernels.summed, tuple(describe(value) for value in (1, np.empty(1))))
    assert small_kernels.summed(1000, np.empty(1)) == 499500.0


def test_of_two_signals_while_a_kernel_is_loaded_none_is_lost():
    came = []
    before = {
        number: signal.signal(number, lambda number, _: came.append(number)) for number in (signal.SIGINT, signal.SIGTERM)
    }
    try:
        with signals.kept():
            signal.raise_signal(signal.SIGTERM)
            signal.raise_signal(signal.SIGINT)
            assert came == []
            signal.raise_signal(signal.SIGINT)  # who asks twice does not wait
            assert came == [signal.SIGINT]
        assert came == [signal.SIGINT, signal.SIGTERM, signal.SIGINT]
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def test_what_is_compiled_ahead_of_all_tests_is_there_to_be_called():
    found = {kernel.py_func.__module__ for kernel, _ in compile_ahead.called(compile_ahead.calls)}
    assert found > compile_ahead.FIRST


def test_what_python_raises_is_what_compiled_arithmetic_gives(fresh):
    assert small_kernels.quotient(1.0, 0.0) == math.inf
    with forced("interpreted"), pytest.raises(ZeroDivisionError):
        small_kernels.quotient(1.0, 0.0)


@pytest.mark.long
def test_two_first_calls_at_once_compile_once(tmp_path):
    code = "import small_kernels, numpy; print(small_kernels.summed(1000, numpy.empty(1)))"
    path = os.pathsep.join([str(SOURCE), str(Path(__file__).parent)])
    environment = {
        **os.environ, "PYTHONPATH": path, "NUMBA_CACHE_DIR": str(tmp_path), "HOPHOOP_KERNELS": "compiled",
    }  # fmt: skip
    environment.pop("NUMBA_DISABLE_JIT", None)
    both = [
        subprocess.Popen([sys.executable, "-c", code], env=environment, stdout=subprocess.PIPE, text=True) for _ in range(2)
    ]
    assert [one.communicate()[0] for one in both] == ["499500.0\n"] * 2
    assert len(list(tmp_path.rglob("*.nbc"))) == 1


@pytest.mark.parametrize("method", multiprocessing.get_all_start_methods())
def test_kernels_in_another_process(method):
    small_kernels.summed(1000, np.empty(1))
    context = multiprocessing.get_context(method)
    queue = context.Queue()
    child = context.Process(target=small_kernels.put_sum, args=(queue,))
    child.start()
    assert queue.get(timeout=60) == 499500.0
    child.join()


def test_kernels_can_be_pickled():
    assert pickle.loads(pickle.dumps(small_kernels.summed)) is small_kernels.summed


# Where compiled code is kept


def test_without_a_home_and_with_nothing_writable(monkeypatch, tmp_path):
    file = tmp_path / "file"
    file.touch()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(file))
    monkeypatch.setenv("XDG_CACHE_HOME", str(file))
    monkeypatch.setattr(store.tempfile, "tempdir", str(tmp_path))
    store.root_folder.cache_clear()
    try:
        folder = store.root_folder()
        assert folder.parent == tmp_path
        assert folder.is_dir()
    finally:
        store.root_folder.cache_clear()


ARGUMENTS = (1000, np.empty(1))
KINDS = tuple(describe(value) for value in ARGUMENTS)


@pytest.mark.parametrize("failing", ["_save_index", "_save_data"])
def test_a_full_disk_for_compiled_code_is_no_error(fresh, monkeypatch, failing):
    """Every command ended with 'No space left on device', though nothing was to be saved."""

    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(caching.IndexDataCacheFile, failing, full)
    dispatchers.compile_for(small_kernels.summed, KINDS)
    assert not store.is_ready(small_kernels.summed, KINDS)
    assert dispatchers.entry(small_kernels.summed)(*ARGUMENTS) == 499500.0


@pytest.mark.parametrize("name", ["*.nbc", "*.nbi"])
def test_compiled_code_that_was_cut_short_is_made_again(fresh, monkeypatch, name):
    """As a power failure leaves files: every later command ended with 'Ran out of input'."""
    for length in (0, 60):
        dispatchers.compile_for(small_kernels.summed, KINDS)
        [file] = store.folder_of(small_kernels.summed).rglob(name)
        file.write_bytes(file.read_bytes()[:length])
        for hits in (0, 1):
            monkeypatch.setattr(dispatchers, "_entries", {})
            dispatchers.compile_for(small_kernels.summed, KINDS)
            made = dispatchers.entry(small_kernels.summed)
            assert sum(made.stats.cache_hits.values()) == hits
            assert made(*ARGUMENTS) == 499500.0


def with_constant(constant):
    def inside(value):
        return value * constant

    called = Kernel(inside, Options())

    def outside(value):
        return called(value)

    return Kernel(outside, Options())


def test_the_stamp_follows_defaults():
    def kernel(default):
        def inside(value, factor=default):
            return value * factor

        return Kernel(inside, Options())

    assert store.stamp(kernel(2.0)) == store.stamp(kernel(2.0))
    assert store.stamp(kernel(2.0)) != store.stamp(kernel(3.0))


def test_the_stamp_follows_what_a_kernel_calls():
    assert store.stamp(with_constant(2.0)) == store.stamp(with_constant(2.0))
    assert store.stamp(with_constant(2.0)) != store.stamp(with_constant(3.0))
    assert store.stamp(with_constant(np.arange(3.0))) != store.stamp(with_constant(np.arange(1.0, 4.0)))
    names = {kernel.py_func.__name__ for kernel in store.reachable(small_kernels.summed)}
    assert names == {"summed", "passed", "tripled"}


def test_a_stamp_is_the_same_in_every_process():
    code = "from hophoop._jit import store; from hophoop.rigid.kernel import run; print(store.stamp(run))"
    assert len({python(code, PYTHONHASHSEED=seed) for seed in "123"}) == 1


# How it is compiled


def test_parts_get_no_machine_code_of_their_own(fresh):
    # in this process: from disk no parts come
    dispatchers.compile_for(small_kernels.summed, tuple(describe(value) for value in (1, np.empty(1))))
    part = dispatchers.inner(small_kernels.passed)
    (made,) = part.overloads.values()
    assert type(made.library).__name__ == "_PartLibrary"
    assert "wrapper" not in made.library.get_llvm_str()


PLAIN = """
import warnings
warnings.simplefilter("error")
from numba import types
import small_kernels
from hophoop._jit.plain import leave_unoptimised, plain
leave_unoptimised()
code, name = plain(small_kernels.with_a_unit, (types.float64,))
print(f"define i32 @{name}(" in code, "by_itself" in code)
"""


def test_code_for_other_machines_is_not_kept_for_this_one(tmp_path):
    """Numba tried to keep the unoptimised code of what is compiled by itself, where every motion would have taken it from."""
    assert python(PLAIN, NUMBA_CACHE_DIR=str(tmp_path)).split() == ["True", "True"]
    assert not [*tmp_path.rglob("*.nb?")]


UNOPTIMISED = """
from numba import types
import small_kernels
from hophoop._jit.plain import leave_unoptimised, plain
leave_unoptimised()
code, name = plain(small_kernels.summed, (types.int64, types.float64[::1]))
for made in code.split("define ")[1:]:
    first, _, body = made.partition(chr(10))
    print("alloca" in body.split(chr(10) + "}")[0], first)
"""


def test_no_part_of_code_for_other_machines_is_optimised_for_this_one(tmp_path):
    """Numba's passes for this machine lay out pointers of 8 bytes, and the module read beside its arrays."""
    lines = python(UNOPTIMISED, NUMBA_CACHE_DIR=str(tmp_path)).splitlines()
    for name in ("summed", "passed"):
        (line,) = [line for line in lines if f"small_kernels{len(name)}{name}" in line]
        assert line.startswith("True"), line  # variables stand in memory still


def test_a_constant_argument_compiles_nothing_anew(fresh):
    dispatchers.compile_for(small_kernels.with_constants, (describe(1.0),))
    signatures = dispatchers.inner(small_kernels.scaled).signatures
    assert [[str(kind) for kind in signature] for signature in signatures] == [["float64", "int64"]]


# The same bits either way


def bits(scenario, samples=33):
    """Everything that a motion is, as bytes."""
    motion = hh.simulate(scenario)
    sample = motion.at(motion.times(samples))
    columns = [np.asarray(getattr(sample, name)).tobytes() for name in sample.__dataclass_fields__]
    return motion.status, motion._events.tobytes(), motion._segments.tobytes(), columns


def same_bits(scenario, samples=33):
    with forced("interpreted"):
        plain = bits(scenario, samples)
    with forced("compiled"):
        return bits(scenario, samples) == plain


@pytest.mark.parametrize("name", hh.article.scenarios())
def test_equal_bits_for_the_article(name):
    assert same_bits(hh.article.scenarios()[name])


def test_equal_bits_for_what_the_lab_offers():
    from hophoop.lab.presets import presets

    rigid = [preset for preset in presets() if preset.scenario.contact.model == "rigid"]
    assert len(rigid) > 10
    assert [preset.key for preset in rigid if not same_bits(preset.scenario)] == []


def random_scenario(rng):
    """Hoops, planes and starts of ordinary size, each kind often enough."""
    if rng.random() < 0.5:
        hoop = hh.Hoop.ideal(rng.uniform(0.0, 1.0), radius=rng.uniform(0.2, 2.0), mass=rng.uniform(0.1, 3.0))
    else:
        eps = rng.uniform(0.0, 0.99)
        hoop = hh.Hoop(eccentricity=eps, inertia_ratio=rng.uniform(0.01, 1.0) * (1.0 - eps * eps))
    plane = hh.Plane(
        mu=float(rng.choice([0.0, 0.05, 0.2, 0.5, 1.0, 3.0, math.inf])),
        slope=rng.uniform(-0.5, 0.5) if rng.random() < 0.3 else 0.0,
        restitution=rng.uniform(0.0, 1.0) if rng.random() < 0.3 else 0.0,
        impact_law=str(rng.choice(["newton", "poisson", "stronge"])),
    )
    angle, vx, omega = rng.uniform(-3.0, 3.0), rng.uniform(-6.0, 6.0), rng.uniform(-8.0, 8.0)
    start = (
        hh.Start.rolling(vx, angle=angle if rng.random() < 0.5 else 0.0),
        hh.Start(angle=angle, vx=vx, omega=omega),
        hh.Start(height=rng.uniform(0.0, 1.0), angle=angle, vx=vx, vy=rng.uniform(-3.0, 3.0), omega=omega),
    )[int(rng.integers(3))]
    return hh.Scenario(hoop=hoop, plane=plane, start=start, duration=rng.uniform(0.5, 6.0), contact=hh.Rigid(max_events=300))


@pytest.mark.parametrize("count", [60, pytest.param(1000, marks=pytest.mark.slow)])
def test_equal_bits_at_random(count):
    rng = np.random.default_rng(count)
    different = []
    for _ in range(count):
        scenario = random_scenario(rng)
        if not same_bits(scenario, samples=9):
            different.append(scenario.to_query())
    assert different == []


def test_equal_bits_for_maps():
    values = {"start.speed": np.linspace(0.1, 5.0, 12), "plane.mu": np.linspace(0.2, 1.4, 12)}
    wanted = ("sequence", "hop_height", "energy_lost", "greatest_utilization", "takeoff_angle")
    with forced("interpreted"):
        plain = hh.maps.points(None, values, wanted)
    with forced("compiled"):
        fast = hh.maps.points(None, values, wanted)
    for name in wanted:
        np.testing.assert_array_equal(plain[name], fast[name])


def test_what_is_never_inlined_is_linked_once_however_it_is_called(fresh):
    """Its callers leave it out: it is compiled with the whole, and not with each of them."""
    woven = dispatchers.entry(small_kernels.woven)
    assert woven(3.0) == small_kernels.woven.interpreted(3.0) == 4.0
    defined = [line for line in woven.inspect_llvm(woven.signatures[0]).splitlines() if line.startswith("define")]
    for name in ("halved", "between"):
        assert sum(f"small_kernels{len(name)}{name}" in line for line in defined) == 1
    part = dispatchers.inner(small_kernels.above)
    code = part.overloads[part.signatures[0]].library.get_llvm_str().splitlines()
    assert any("halved" in line for line in code if line.startswith("declare"))
    assert not any("halved" in line for line in code if line.startswith("define"))


def test_what_two_loops_call_is_there_for_both(fresh):
    """Also where one of them is left out of their caller, which comes to what they call through that one first."""
    assert dispatchers.entry(small_kernels.layered)(3.0) == small_kernels.layered.interpreted(3.0) == 3.75


FOUND = """
import small_kernels
from hophoop._jit import dispatchers
from numba.core import event
with event.install_recorder("numba:compile") as compiled:
    assert small_kernels.quotient(1.0, 4.0) == 0.25
print(small_kernels.__file__, len(compiled.buffer))
"""


@pytest.mark.long
def test_another_copy_of_the_source_finds_compiled_code(tmp_path):
    """Its folder is named by what a kernel is made of: a new environment with the same version compiles nothing."""
    given = Path(small_kernels.__file__).read_text(encoding="utf-8")
    moved = given.replace("from __future__", "# another line\n\nfrom __future__", 1)  # nor do the numbers of its lines matter
    for name, text in (("one", given), ("other", moved)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "small_kernels.py").write_text(text, encoding="utf-8")
        code = f"import sys; sys.path.insert(0, {str(tmp_path / name)!r})" + FOUND
        file, count = python(code, NUMBA_CACHE_DIR=str(tmp_path / "kept"), HOPHOOP_KERNELS="compiled").rsplit(maxsplit=1)
        assert Path(file).parent.name == name
        assert int(count) == 0  # in this process; the first copy's is compiled in one beside
        data = list((tmp_path / "kept").rglob("*.nbc"))
        assert len(data) == 1
    assert len(list((tmp_path / "kept").rglob("*.ready"))) == 1
