"""Where compiled code is kept: what is in there is run, so nobody else may have put it there."""

from __future__ import annotations

import os
import stat
import sys
import tomllib
from pathlib import Path

import pytest

from hophoop._jit import beside, store

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="owners and modes of POSIX systems")


@pytest.fixture
def shared(tmp_path, monkeypatch):
    """A folder for temporary files, as all users have it, without a home."""
    place = tmp_path / "shared"
    place.mkdir()
    place.chmod(0o1777)
    file = tmp_path / "file"
    file.touch()
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(file))
    monkeypatch.setattr(store.tempfile, "tempdir", str(place))
    store.root_folder.cache_clear()
    yield place
    store.root_folder.cache_clear()


def own(place):
    return place / f"hophoop-{os.getuid()}"


def mode(path):
    return stat.S_IMODE(path.stat().st_mode)


def check_fresh(place, refused):
    folder = store.root_folder()
    assert folder.parent == place
    assert folder != refused
    assert mode(folder) == 0o700
    assert folder == store.root_folder()  # one for the process
    return folder


def test_a_new_folder_is_of_the_user_alone(shared):
    before = os.umask(0)
    try:
        assert store.root_folder() == own(shared)
    finally:
        os.umask(before)
    assert mode(own(shared)) == 0o700


@pytest.mark.parametrize("bits", [0o700, 0o755])
def test_a_folder_of_the_user_is_used_again(shared, bits):
    own(shared).mkdir()
    own(shared).chmod(bits)
    assert store.root_folder() == own(shared)


@pytest.mark.parametrize("bits", [0o777, 0o770, 0o702, 0o1777])
def test_a_folder_that_others_can_write_to_is_not_used(shared, bits):
    own(shared).mkdir()
    own(shared).chmod(bits)
    check_fresh(shared, own(shared))
    assert not list(own(shared).iterdir())


def test_a_link_is_not_used(shared, tmp_path):
    target = tmp_path / "target"
    target.mkdir(mode=0o700)
    own(shared).symlink_to(target)
    check_fresh(shared, own(shared))
    assert not list(target.iterdir())


def test_a_folder_of_another_user_is_not_used(shared, monkeypatch):
    user = os.getuid()
    monkeypatch.setattr(os, "getuid", lambda: user + 1)
    own(shared).mkdir(mode=0o700)
    check_fresh(shared, own(shared))


@pytest.mark.skipif(not hasattr(os, "getuid") or os.getuid() != 0, reason="only root gives folders away")
@pytest.mark.parametrize("given", ["the folder", "the one around it"])
def test_root_uses_no_folder_that_another_user_has_made(shared, given):
    own(shared).mkdir(mode=0o700)
    os.chown(own(shared) if given == "the folder" else shared, 12345, 12345)
    check_fresh(shared, own(shared))


def test_a_folder_that_others_can_take_away_is_not_used(shared):
    own(shared).mkdir(mode=0o700)
    shared.chmod(0o777)  # without the sticky bit
    assert not store.is_private(own(shared))
    shared.chmod(0o770)
    assert not store.is_private(own(shared))


def test_a_cache_of_the_home_in_a_shared_place_is_looked_at_too(shared, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(shared))
    cache = shared / "hophoop"
    cache.mkdir()
    cache.chmod(0o777)
    assert store.root_folder() == own(shared)
    store.root_folder.cache_clear()
    cache.chmod(0o700)
    assert store.root_folder() == cache


def test_a_cache_below_a_folder_of_another_is_not_used(shared, monkeypatch):
    # anybody can make /tmp/.cache where HOME is /tmp
    theirs = shared / ".cache"
    theirs.mkdir()
    theirs.chmod(0o777)
    monkeypatch.setenv("XDG_CACHE_HOME", str(theirs))
    assert store.root_folder() == own(shared)


def test_a_link_of_the_home_into_a_shared_place_is_looked_at(shared, tmp_path, monkeypatch):
    cache = tmp_path / "cache"
    cache.mkdir()
    (cache / "hophoop").symlink_to(shared)
    monkeypatch.setenv("XDG_CACHE_HOME", str(cache))
    assert store.is_shared(cache / "hophoop")
    assert store.root_folder() == own(shared)


def test_a_folder_that_the_user_names_is_trusted(shared, monkeypatch):
    named = shared / "named"
    named.mkdir()
    named.chmod(0o777)
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(named))
    assert store.root_folder() == named


def test_processes_that_are_started_get_the_folder(shared, monkeypatch):
    own(shared).symlink_to("nowhere")
    folder = check_fresh(shared, own(shared))
    given = []
    monkeypatch.setattr(beside, "python_beside", lambda code, **options: given.append(options["env"]["NUMBA_CACHE_DIR"]))
    beside.launch("")
    assert given == [str(folder)]


def test_what_is_trusted_is_in_the_source_archive():
    project = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8"))
    assert "SECURITY.md" in project["tool"]["hatch"]["build"]["targets"]["sdist"]["include"]
