"""The build hook: which wheel is made for which machine, and what is packed into it."""

import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from packaging.tags import Tag

from kernel_tools import python

pytest.importorskip("hatchling")
FILE = Path(__file__).parents[2] / "hatch_build.py"


@pytest.fixture
def module(monkeypatch):
    """The hook's module, on a machine with all tools and no wishes."""
    monkeypatch.setattr(sys, "path", list(sys.path))
    for name in ("HOPHOOP_TARGET", "HOPHOOP_BUILD"):
        monkeypatch.delenv(name, raising=False)
    spec = importlib.util.spec_from_file_location("hatch_build", FILE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    monkeypatch.setattr(module, "find_spec", lambda name: name)
    return module


@pytest.fixture
def hook(module):
    """The hook, as hatchling makes it."""
    from hatchling.bridge.app import Application
    from hatchling.metadata.core import ProjectMetadata

    root = str(FILE.parent)
    app = Application().get_safe_application()
    return module.CustomBuildHook(root, {}, None, ProjectMetadata(root, None), "", "wheel", app)


@pytest.fixture
def built(module, monkeypatch):
    """Commands of a build that writes two libraries, beside one of another build."""
    commands = []

    def run(command, **options):
        commands.append(command)
        out = Path(command[command.index("--out") + 1])
        for name in ("kernels-v2-new.so", "kernels-v3-new.so", "kernels-v2-old.so"):
            (out / name).write_text(name)
        files = {"v2": "kernels-v2-new.so", "v3": "kernels-v3-new.so"}
        (out / "kernels.json").write_text(json.dumps({"files": files}))
        return subprocess.CompletedProcess(command, 0)

    monkeypatch.setattr(module.subprocess, "run", run)
    return commands


def made_by(hook, version="standard"):
    data = {"force_include": {}}
    hook.initialize(version, data)
    return data


def test_the_targets_are_read_without_numpy():
    """Pip asks the hook before it installs what the build needs."""
    code = "import sys; sys.modules['numpy'] = None; from hophoop.kernel.build.link import own_target; own_target()"
    assert python(code).returncode == 0


def test_every_target_has_the_tag_of_its_system(module):
    """Of the oldest C library or system that zig links for."""
    from hophoop.kernel.build.link import TARGETS

    assert set(module.PLATFORMS) == set(TARGETS)
    systems = {"linux": "manylinux", "musllinux": "musllinux", "macos": "macosx", "windows": "win"}
    for name, target in TARGETS.items():
        system, _, machine = name.partition("-")
        oldest = target.zig.split(".", 1)[1].replace(".", "_") if system in ("linux", "macos") else ""
        assert module.PLATFORMS[name].startswith(f"{systems[system]}_{oldest}")
        assert module.PLATFORMS[name].endswith(f"_{machine}")


def test_a_wheel_for_another_machine_has_its_tag_and_the_files_of_this_build(hook, built, monkeypatch):
    monkeypatch.setenv("HOPHOOP_TARGET", "windows-amd64")
    data = made_by(hook)
    assert (data["tag"], data["pure_python"]) == ("py3-none-win_amd64", False)
    assert "windows-amd64" in built[0]
    names = {"kernels.json", "kernels-v2-new.so", "kernels-v3-new.so"}
    assert set(data["force_include"].values()) == {f"hophoop/kernel/library/{name}" for name in names}
    assert all(Path(file).is_file() for file in data["force_include"])
    hook.finalize("standard", data, "")
    assert not any(Path(file).exists() for file in data["force_include"])


def test_an_unknown_target_ends_the_build_with_a_sentence(hook, built, monkeypatch, capsys):
    monkeypatch.setenv("HOPHOOP_TARGET", "amiga")
    with pytest.raises(SystemExit):
        made_by(hook)
    assert "HOPHOOP_TARGET = 'amiga' must be one of linux-x86_64" in capsys.readouterr().err
    assert not built


def test_an_editable_install_has_the_library_in_the_sources(module, built, tmp_path, monkeypatch):
    monkeypatch.setenv("HOPHOOP_TARGET", "linux-x86_64")
    library = tmp_path / "src" / "hophoop" / "kernel" / "library"
    library.mkdir(parents=True)
    hook = module.CustomBuildHook(str(tmp_path), {}, None, None, "", "wheel")
    assert made_by(hook, "editable") == {"force_include": {}}
    assert (library / "kernels.json").is_file()


@pytest.mark.parametrize(
    ("why", "said"),
    [
        ("not wanted", ["HOPHOOP_BUILD=0", "python -m hophoop.kernel.build"]),
        ("no tools", ["ziglang is not installed", "python -m hophoop.kernel.build"]),
        ("an older system, or 32 bits", ["This Python takes no "]),
    ],
)
def test_without_a_library_the_wheel_is_for_any_machine_and_says_its_cost(module, hook, built, monkeypatch, capsys, why, said):
    if why == "not wanted":
        monkeypatch.setenv("HOPHOOP_BUILD", "0")
    elif why == "no tools":
        monkeypatch.setenv("HOPHOOP_TARGET", "linux-x86_64")
        monkeypatch.setattr(module, "find_spec", lambda name: None if name == "ziglang" else name)
        monkeypatch.setattr(module, "which", lambda name: None)
    else:
        monkeypatch.setattr(module, "sys_tags", lambda: iter(()))
    assert made_by(hook) == {"force_include": {}}
    assert not built
    told = capsys.readouterr().err
    assert [words for words in [*said, "milliseconds instead of 20 µs"] if words not in told] == []
    assert why == "no tools" or hook.dependencies() == []


def test_the_build_asks_for_its_tools_where_numba_has_wheels(module, hook, monkeypatch):
    monkeypatch.setenv("HOPHOOP_TARGET", "linux-x86_64")
    for platform, tools in (("manylinux_2_28_x86_64", ["numba", "numpy", "pydantic", "ziglang"]), ("musllinux_1_2_x86_64", [])):
        monkeypatch.setattr(module, "sys_tags", lambda platform=platform: iter([Tag("py3", "none", platform)]))
        assert sorted(re.match(r"\w+", name)[0] for name in hook.dependencies()) == tools


def test_a_build_that_fails_ends_the_installation_and_names_the_way_round(module, hook, monkeypatch, capsys):
    monkeypatch.setenv("HOPHOOP_TARGET", "linux-x86_64")
    monkeypatch.setattr(module.subprocess, "run", lambda command, **options: subprocess.CompletedProcess(command, 1))
    with pytest.raises(SystemExit) as stopped:
        made_by(hook)
    assert stopped.value.code == 1
    assert "HOPHOOP_BUILD=0 installs hophoop without" in capsys.readouterr().err


def test_a_zig_on_the_path_builds_as_well(module, hook, built, monkeypatch):
    monkeypatch.setenv("HOPHOOP_TARGET", "linux-x86_64")
    monkeypatch.setattr(module, "find_spec", lambda name: None if name == "ziglang" else name)
    monkeypatch.setattr(module, "which", lambda name: f"/usr/bin/{name}")
    made_by(hook)
    assert built
