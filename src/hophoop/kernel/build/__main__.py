"""`python -m hophoop.kernel.build`: the library of compiled kernels, for this machine or others.

Each group of entries is compiled by a process of its own, two at a time, and kept: what has not changed since is taken as it
is. A library is in place when it is whole; until then the one before stays.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from hophoop._native.library import HERE, TOLD
from hophoop._native.sources import PACKAGE, stamp
from hophoop.kernel.build.link import TARGETS, linked, own_target
from hophoop.kernel.entries import GROUPS

TOOLS = ("numba", "llvmlite", "numpy", "ziglang")
OLD = 600.0  # seconds after which a library of another build is no longer awaited


def tools() -> dict[str, str]:
    """Versions of the packages that make the library.

    Raises
    ------
    PackageNotFoundError
        If one is not installed.
    """
    return {name: version(name) for name in TOOLS}


def _hash(files: Sequence[str], more: str) -> str:
    digest = hashlib.sha256(more.encode())
    for name in sorted(files):
        digest.update(f"{name}\n".encode())
        file = PACKAGE / name
        digest.update(file.read_bytes() if file.is_file() else b"")
    return digest.hexdigest()[:32]


def _cache_folder() -> Path:
    wanted = os.environ.get("HOPHOOP_BUILD_CACHE")
    if wanted:
        return Path(wanted)
    try:
        return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "hophoop-build"
    except RuntimeError:  # nobody's home
        return Path(tempfile.mkdtemp())


def compile_group(group: str, targets: Sequence[str], folder: Path) -> None:
    """Write the object files of a group, and what is told of it; for a process of its own."""
    from hophoop.kernel.build.entry_code import group_code, reached
    from hophoop.kernel.build.link import object_of

    text, told = group_code(GROUPS[group])
    names = [entry["symbol"] for entry in told.values()]
    for name in targets:
        for level in TARGETS[name].levels:
            (folder / f"{group}-{name}-{level}.o").write_bytes(object_of(text, names, TARGETS[name], level))
    sources = [path.relative_to(PACKAGE).as_posix() for path in reached()]
    (folder / f"{group}.json").write_text(json.dumps({"entries": told, "sources": sources}), encoding="utf-8")


def _kept(group: str, targets: Sequence[str], made_with: str, cache: Path) -> Path | None:
    """The folder in the cache with what a build of these sources has made of a group."""
    try:
        known = json.loads((cache / f"{group}.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    folder = cache / f"{group}-{_hash(known['sources'], made_with)}"
    wanted = [folder / f"{group}-{name}-{level}.o" for name in targets for level in TARGETS[name].levels]
    return folder if all(file.is_file() for file in (*wanted, folder / f"{group}.json")) else None


def _compile(group: str, targets: Sequence[str], made_with: str, cache: Path, scratch: Path) -> Path:
    kept = _kept(group, targets, made_with, cache)
    if kept is not None:
        return kept
    began = time.monotonic()
    fresh = scratch / group
    fresh.mkdir()
    command = [sys.executable, "-m", "hophoop.kernel.build", "--group", group, "--into", str(fresh), *targets]
    environment = dict(os.environ, HOPHOOP_KERNELS="interpreted")
    environment["PYTHONPATH"] = os.pathsep.join([str(PACKAGE.parent), *[place for place in sys.path if place]])
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    if done.returncode:
        raise RuntimeError(f"compiling the group {group!r} failed:\n{done.stderr.strip()[-4000:]}")
    print(f"compiled {group} in {time.monotonic() - began:.0f} s", flush=True)
    try:
        told = json.loads((fresh / f"{group}.json").read_text(encoding="utf-8"))
        place = cache / f"{group}-{_hash(told['sources'], made_with)}"
        cache.mkdir(parents=True, exist_ok=True)
        for old in cache.glob(f"{group}-*"):
            if old != place and time.time() - old.stat().st_mtime > OLD:
                _remove(old)
        _copy(fresh, place)
        (cache / f"{group}.json").write_text(json.dumps({"sources": told["sources"]}), encoding="utf-8")
    except OSError:
        pass  # without a cache the next build takes as long
    return fresh


def _copy(folder: Path, place: Path) -> None:
    import shutil

    part = place.with_name(f"{place.name}.{os.getpid()}")
    shutil.copytree(folder, part)
    try:
        part.replace(place)
    except OSError:  # another build was first
        shutil.rmtree(place, ignore_errors=True)
        part.replace(place)


def _remove(folder: Path) -> None:
    import shutil

    shutil.rmtree(folder, ignore_errors=True)


def build(targets: Sequence[str], out: Path) -> None:
    """Build libraries.

    Parameters
    ----------
    targets : sequence of str
        Of `link.TARGETS`.
    out : Path
        Folder for the library of the only target, or for one folder each.

    Raises
    ------
    PackageNotFoundError
        If Numba or ziglang is not installed.
    RuntimeError
        If compiling or linking fails; what there was before stays.
    OSError
        If the folder cannot be written to.
    """
    versions, sources = tools(), stamp()
    out.mkdir(parents=True, exist_ok=True)
    made_with = json.dumps([versions, stamp_of_build()])
    with tempfile.TemporaryDirectory() as scratch:
        with ThreadPoolExecutor(2) as pool:
            jobs = {group: pool.submit(_compile, group, targets, made_with, _cache_folder(), Path(scratch)) for group in GROUPS}
            folders = {group: job.result() for group, job in jobs.items()}
        for name in targets:
            about = {"machine": TARGETS[name].machine, "sources": sources, "built_with": versions}
            _link(name, folders, out if len(targets) == 1 else out / name, about, Path(scratch))


def stamp_of_build() -> str:
    """Hash of what says how kernels are compiled."""
    return _hash(
        [f"kernel/build/{name}" for name in ("numba_code.py", "entry_code.py", "link.py", "__main__.py")]
        + ["kernel/entries.py"],
        "",
    )


def _link(name: str, folders: dict[str, Path], out: Path, about: dict[str, Any], scratch: Path) -> None:
    out.mkdir(parents=True, exist_ok=True)
    target = TARGETS[name]
    entries: dict[str, Any] = {}
    for group, folder in folders.items():
        entries |= json.loads((folder / f"{group}.json").read_text(encoding="utf-8"))["entries"]
    files = {}
    for level in target.levels:
        fresh = scratch / f"kernels-{name}-{level}{target.suffix}"
        linked([folder / f"{group}-{name}-{level}.o" for group, folder in folders.items()], target, fresh)
        content = fresh.read_bytes()
        files[level] = f"kernels-{level}-{hashlib.sha256(content).hexdigest()[:12]}{target.suffix}"
        _replace(out / files[level], content)
    _replace(out / TOLD, (json.dumps(about | {"files": files, "entries": entries}, indent=1) + "\n").encode())
    for old in out.glob("kernels-*"):
        if old.name not in files.values() and time.time() - old.stat().st_mtime > OLD:
            old.unlink(missing_ok=True)


def _replace(place: Path, content: bytes) -> None:
    part = place.with_name(f".{place.name}.{os.getpid()}")
    try:
        part.write_bytes(content)
        part.replace(place)
    finally:
        part.unlink(missing_ok=True)


def main(arguments: Sequence[str] | None = None) -> int:
    """Read the command line, and build."""
    parser = argparse.ArgumentParser(prog="python -m hophoop.kernel.build", description="Build the compiled kernels.")
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=f"{', '.join(TARGETS)}; this machine by default")
    parser.add_argument("--out", type=Path, default=HERE, help="folder for the library")
    parser.add_argument("--group", choices=list(GROUPS), help=argparse.SUPPRESS)
    parser.add_argument("--into", type=Path, help=argparse.SUPPRESS)
    given = parser.parse_args(arguments)
    unknown = [name for name in given.targets if name not in TARGETS]
    if unknown:
        parser.error(f"target = {unknown[0]!r} must be one of {', '.join(TARGETS)}")
    if given.group:
        compile_group(given.group, given.targets, given.into)
        return 0
    try:
        build(given.targets or [own_target()], given.out)
    except PackageNotFoundError as error:
        print(
            f"Error: building needs {error.name}: pip install 'hophoop[build]'. What there was before stays.", file=sys.stderr
        )
        return 1
    except (RuntimeError, OSError, KeyError) as error:
        print(f"Error: {error} What there was before stays.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
