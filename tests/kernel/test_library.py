"""The library of compiled kernels: equal to the interpreted kernels to the bit, and not used where it is not theirs."""

import json
import shutil
import sys
from pathlib import Path

import pytest

from hophoop._support.extras import install_command
from hophoop.kernel.build import link
from hophoop.kernel.build.link import own_target
from hophoop.kernel.native import library as native
from hophoop.kernel.native import sources
from kernel_tools import SHORT, python, started

OTHER = "linux-aarch64" if own_target() != "linux-aarch64" else "linux-x86_64"
MACHINES = {"linux-aarch64": 183, "linux-x86_64": 62}  # as ELF numbers them
RUN = "hophoop.kernel.rigid.run.run"


def told(folder):
    return json.loads((folder / native.MANIFEST).read_text(encoding="utf-8"))


@pytest.fixture
def copied(tmp_path):
    """A copy of the library."""
    return Path(shutil.copytree(native.HERE, tmp_path / "library"))


OLD = {"sources": "0" * 32, "code": "0" * 32}
# content of the manifest → why the library is not used
CONTENTS = {
    **dict.fromkeys([b"", b"5", b'{"machine": [', b"\xff\xfe{}", b"[" * 100_000], native.DAMAGED),
    json.dumps(OLD | {"files": {"v2": "a"}, "entries": {}, "machine": ["beos", "ppc"]}).encode(): "are for beos ppc",
}
# what is changed in the manifest → the same
CHANGES = [
    ({"machine": 5}, native.DAMAGED),
    ({"machine": [1, 2]}, native.DAMAGED),
    ({"files": {}}, native.DAMAGED),
    ({"files": {"v2": 5}}, native.DAMAGED),
    ({"files": {"new": "none.so"}}, native.DAMAGED),
    ({"entries": []}, native.DAMAGED),
    ({"entries": {}}, native.DAMAGED),
    ({"entries": {RUN: {"symbol": "none", "takes": [], "gives": None}}}, native.DAMAGED),
    ({"entries": {RUN: {"symbol": "hophoop_kernel_rigid_run_run", "takes": [5], "gives": "("}}}, native.DAMAGED),
    ({"files": {"v2": "absent.so"}}, "cannot be loaded"),
    ({"files": {"v2": "nul\0.so"}}, "cannot be loaded"),
    (OLD, f"The compiled kernels are older than their sources. To rebuild them: {native.BUILD}."),
]


def test_a_library_that_does_not_fit_is_told_of_and_not_used(copied, monkeypatch):
    monkeypatch.setattr(native, "HERE", copied)
    manifest, right = copied / native.MANIFEST, told(copied)

    def why():
        found = native._found.__wrapped__()
        if isinstance(found, str):
            return found
        with pytest.raises(OSError, match="damaged") as refused:
            found.call(RUN)
        return str(refused.value)

    for content, said in [*CONTENTS.items(), *((json.dumps(right | change).encode(), said) for change, said in CHANGES)]:
        manifest.write_bytes(content)
        assert said in why(), content[:200]
    manifest.unlink()
    manifest.mkdir()
    assert why() == native.DAMAGED


def test_without_a_tool_the_build_says_so_and_leaves_what_there_is(tmp_path):
    (tmp_path / native.MANIFEST).write_text("before")
    code = (
        "import importlib.util as u, sys\n"
        "u.find_spec = lambda name, package=None, real=u.find_spec: None if name == 'ziglang' else real(name, package)\n"
        "from hophoop.kernel.build.__main__ import main\n"
        f"sys.exit(main(['--out', {str(tmp_path)!r}]))"
    )
    done = python(code, PATH="")
    assert done.returncode == 1
    assert done.stderr == f"Error: building needs ziglang: {install_command('build')}. The previous build remains.\n"
    assert (tmp_path / native.MANIFEST).read_text() == "before"


@pytest.mark.skipif(sys.platform == "win32", reason="the program is a shell script")
def test_a_zig_on_the_path_serves_as_well(tmp_path, monkeypatch):
    """As conda has it, which has no package ziglang."""
    program = tmp_path / "zig"
    program.write_text('#!/bin/sh\nif [ "$1" = version ]; then echo 0.99.9; else echo "$@" > "$0.said"; fi\n')
    program.chmod(0o755)
    monkeypatch.setattr(link, "find_spec", lambda name: None)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    assert link.zig_version() == "0.99.9"
    link.zig(["-O2"], tmp_path / "library.so")
    assert (tmp_path / "zig.said").read_text() == f"cc -O2 -o {tmp_path / 'library.so'}\n"
    program.write_text("#!/bin/sh\necho no memory >&2; exit 1\n")
    with pytest.raises(RuntimeError, match="zig version failed: no memory"):
        link.zig_version()


def test_an_unknown_target_is_refused(tmp_path):
    done = started("-m", "hophoop.kernel.build", "amiga", "--out", str(tmp_path))
    assert done.returncode == 2
    assert "target = 'amiga' must be one of linux-x86_64" in done.stderr


# a small library, of entries that take arrays and tuples
SMALL = """
import sys
from hophoop.kernel import entries
names = ("hophoop.kernel.records.refusals.mark_refused", "hophoop.theory.kernels.phase_plane.lift_off")
entries.ENTRIES = {name: entries.ENTRIES[name] for name in names}
from hophoop.kernel.build.__main__ import main
sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.long
def test_libraries_are_built_and_what_has_not_changed_is_not_compiled_again(tmp_path):
    """For this machine and another kind: Numba's own code for counts of references had been made for this one."""
    pytest.importorskip("ziglang")
    cache = tmp_path / "cache"

    def build(name, *targets):
        done = started("-c", SMALL, *targets, "--out", str(tmp_path / name), HOPHOOP_BUILD_CACHE=str(cache))
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
        return tmp_path / name

    both = build("both", own_target(), OTHER)
    for file in told(both / OTHER)["files"].values():
        head = (both / OTHER / file).read_bytes()[:20]
        assert head[:4] == b"\x7fELF"
        assert int.from_bytes(head[18:20], "little") == MACHINES[OTHER]
    before = {file: file.stat().st_mtime_ns for file in cache.iterdir()}
    assert told(build("again", own_target())) == told(both / own_target())
    assert {file: file.stat().st_mtime_ns for file in cache.iterdir()} == before


EVERYTHING = """
import hashlib, sys
import numpy as np
import hophoop as hh
from hophoop import theory
from hophoop.kernel.native.library import Library
from hophoop.kernel.numerics import elementwise
from hophoop.maps import sweep

names, call = set(), Library.call
Library.call = lambda self, name: names.add(name) or call(self, name)
hoop, plane = hh.Hoop.ideal(0.75), hh.Plane(mu=1.0)
digest = hashlib.sha256()
def take(*values):
    for value in values:
        digest.update((np.asarray(value, dtype=float) + 0.0).tobytes())
take(theory.first_slip_speed(hoop, plane), theory.first_hop_speed(hoop, plane), theory.needed_friction(hoop, 1.0, plane)[0])
angles = [0.5, 1.0, 3.0]
take(*elementwise.sine_and_cosine(np.array(angles)), theory.slip_angle(hoop, [4.0], plane))
take(theory.rolling_time(angles, hoop, 2.0, plane), theory.rolling_speed(angles, hoop, 2.0, plane))
take(*theory.rolling_forces(angles, hoop, 2.0, plane), *theory.rolling_energies(angles, hoop, 2.0, plane))
take(theory.rocking_period([2.5, 3.0], hoop, plane), theory.massless_loss([0.5, 1.0, 2.0]).angle)
take(*theory.rolling_range(angles, hoop, plane), theory.lift_off_speed(angles, hoop, plane))
digest.update(theory.mode_of(angles, [1.0, 2.0, 8.0], hoop, plane).tobytes())
take(theory.painleve_threshold(angles, hoop), *theory.painleve_minimum(hoop))
digest.update(theory.painleve_region([5.9, 1.0], [2.0, 9.0], hoop).tobytes())
take(*((state.angle, state.omega) for state in theory.jam_states(hoop)))
motion = hh.simulate(hh.Scenario(duration=2.0))
take(*(getattr(motion.errors, name) for name in ("t", "angle")))
take(motion.at(motion.times(50)).utilization(motion.scenario.plane))
of = ["hop.height", "at(1.0).angle", "greatest_utilization"]
take(motion.sensitivity([*of, "end.kinetic"], ["plane.mu", "hoop.load_fraction"]).derivatives)
gentle = hh.simulate(hh.Scenario(plane=hh.Plane(mu=5.0), start=hh.Start.rolling(1.0), duration=1.0))
take(gentle.sensitivity("greatest_utilization", "plane.mu").derivatives)
held = hh.simulate(hh.Scenario(plane=hh.Plane(mu=1.0, rolling_resistance=0.1), start=hh.Start(angle=0.01), duration=1.0))
take(held.sensitivity("greatest_utilization", "plane.mu").derivatives)
axes = {"start.speed": np.linspace(0.5, 6.0, 2), "plane.mu": np.linspace(0.1, 2.0, 2)}
found = sweep(hh.Scenario(), axes, ["time", "distance"])
take(found["time"], found["distance"])
soft = hh.simulate(hh.Scenario(duration=0.1, contact=hh.Compliant()))
take(soft.at(soft.times(50)).omega, soft.at(soft.times(50)).normal_force)
onward = hh.simulate(hh.Scenario(start=hh.Start.of(motion.at(1.2)), duration=0.8))
take([event.omega for event in onward.events])
slope = hh.Scenario(plane=hh.Plane(slope=0.05), hoop=hh.Hoop.ideal(0.5))
for section in ("bottom", "landing"):
    rows = hh.passages(slope, 5, section=section)
    take(rows.numbers, rows.packed, hh.gaits.derivative(slope.replace("start", rows.start(1)), section=section).matrix)
take(hh.gaits.fates([hh.Scenario(), hh.Scenario(start=hh.Start(angle=3.0))], 4).passages)
assert "numba" not in sys.modules
print(digest.hexdigest(), *sorted(names))
"""


@pytest.mark.long
def test_all_that_python_calls_has_the_bits_of_the_interpreter():
    """Each entry is called, and each is compiled."""
    from hophoop.kernel.entries import ENTRIES

    done = python(EVERYTHING, HOPHOOP_KERNELS="compiled")
    assert done.returncode == 0, done.stderr
    mine, *names = done.stdout.split()
    assert names == sorted(ENTRIES)
    other = python(EVERYTHING, HOPHOOP_KERNELS="interpreted")
    assert other.returncode == 0, other.stderr
    assert other.stdout.split() == [mine]


MEMORY = """
import resource
import hophoop as hh
for k in range(6):
    for _ in range(200):
        motion = hh.simulate(hh.Scenario(duration=2.0))
        motion.at(motion.times(20))
    if k == 2:
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="Linux says how much memory a process had at most, in kB")
def test_motions_leave_no_memory_behind():
    """Arrays that a kernel creates and never frees would take 14 kB a motion."""
    done = python(MEMORY, HOPHOOP_KERNELS="compiled")
    assert int(done.stdout) < 2000, done.stderr


def test_it_names_no_folder_of_the_machine_that_built_it():
    """Numba writes the places of its own sources into errors."""
    found = native.library()
    assert found is not None
    numba = pytest.importorskip("numba")
    for file in found.told["files"].values():
        content = (native.HERE / file).read_bytes()
        for place in (Path(numba.__file__).parents[1], sources.PACKAGE.parent):
            assert str(place).encode() not in content


def test_a_library_that_is_cut_short_is_told_of_once_and_the_sources_serve(copied):
    """The system may load half a file, and end the process where it reads the other half."""
    for name in told(copied)["files"].values():
        file = copied / name
        file.write_bytes(file.read_bytes()[:-100])
    done = python(SHORT, HOPHOOP_LIBRARY=str(copied), HOPHOOP_KERNELS="auto")
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (0, "R\n", 1), done.stderr
    assert "is damaged" in done.stderr


def test_a_numba_that_is_too_old_is_refused_and_a_new_one_is_told_of(capsys):
    from hophoop.kernel.build.__main__ import refuse_older

    with pytest.raises(RuntimeError, match=r"^Building needs Numba 0\.62 or newer; 0\.60\.0 is installed\.$"):
        refuse_older("0.60.0")
    refuse_older("0.62.1")
    assert capsys.readouterr().err == ""
    refuse_older("1.0.0rc1")
    assert capsys.readouterr().err == "Numba 1.0.0rc1 has not been tried: 0.62 to 0.68 have built the kernels.\n"


HARMLESS = {
    "kernel/rigid/run.py": "# a comment\n\n\ndef unused(x):\n    return 2.0 * x\n",
    "kernel/build/lowering.py": "# a comment\n",
    "simulation/trajectory.py": "\n\ndef unused(x):\n    return 2.0 * x\n",
}
CONSTANT = {"kernel/rigid/panel_choice.py": "SLOW = 2e-3\n"}


@pytest.mark.parametrize(("ends", "said"), [(HARMLESS, ""), (HARMLESS | CONSTANT, "The compiled kernels are older than ")])
def test_only_an_edit_that_changes_a_kernel_takes_the_library_out_of_use(ends, said, tmp_path):
    """A copy of the sources in which some files have another end, with the library of the present ones."""
    ignored = shutil.ignore_patterns("library", "static", "__pycache__", "*.wasm")
    shutil.copytree(sources.PACKAGE, tmp_path / "hophoop", ignore=ignored)
    for name, end in ends.items():
        with (tmp_path / "hophoop" / name).open("a", encoding="utf-8") as file:
            file.write(end)
    done = python(SHORT, PYTHONPATH=str(tmp_path), HOPHOOP_LIBRARY=str(native.HERE), HOPHOOP_KERNELS="auto")
    assert (done.returncode, done.stdout) == (0, "R\n")
    assert done.stderr.startswith(said)
    assert bool(done.stderr) == bool(said)


@pytest.mark.skipif(
    sys.platform == "win32", reason="Windows keeps a file that is in use; the build gives a new one another name"
)
def test_a_library_that_is_replaced_serves_who_has_loaded_it(copied):
    code = """
import hophoop as hh
from hophoop.kernel.build.kept import write
from hophoop.kernel.native.library import HERE
first = hh.simulate(hh.Scenario(duration=2.0))
for file in list(HERE.iterdir()):
    write(file, b"new")
assert {file.read_bytes() for file in HERE.iterdir()} == {b"new"}
again = hh.simulate(hh.Scenario(duration=2.0, contact=hh.Compliant())), hh.simulate(hh.Scenario(duration=2.0))
print(again[1].fingerprint == first.fingerprint)
"""
    done = python(code, HOPHOOP_LIBRARY=str(copied), HOPHOOP_KERNELS="compiled")
    assert (done.returncode, done.stdout, done.stderr) == (0, "True\n", "")


LEVEL = """
import hophoop as hh
from hophoop.kernel.native.library import library
print(hh.simulate(hh.Scenario(duration=1.0)).fingerprint, library().level)
"""


def test_the_library_of_each_level_gives_the_same_motion():
    found = native.library(quiet=True)
    assert found is not None
    levels = [level for level in sorted(found.told["files"]) if level <= found.level]
    usual = python(LEVEL, HOPHOOP_KERNELS="compiled").stdout.split()
    assert usual == [usual[0], levels[-1]]
    for level in levels:
        done = python(LEVEL, HOPHOOP_KERNELS="compiled", HOPHOOP_LEVEL=level)
        assert (done.returncode, done.stdout.split()) == (0, [usual[0], level]), done.stderr
    done = python(LEVEL, HOPHOOP_KERNELS="compiled", HOPHOOP_LEVEL="v9")
    assert done.returncode == 1
    assert "HOPHOOP_LEVEL = 'v9' must be one of v" in done.stderr.splitlines()[-1]
