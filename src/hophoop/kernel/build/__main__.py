"""`python -m hophoop.kernel.build`: build the compiled kernels, for this machine or others, and the browser's modules.

Each group of entries is compiled in its own process, two at a time, and cached: unchanged groups are not compiled again. A
library is put in place when it is complete; until then the previous one remains.
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

from hophoop._support.extras import install_command
from hophoop.kernel.build.browser import MODULES, description_of, module_of
from hophoop.kernel.build.link import TARGETS, linked, own_target, zig_version
from hophoop.kernel.entries import GROUPS
from hophoop.kernel.native.library import HERE, MANIFEST
from hophoop.kernel.native.sources import PACKAGE, files, stamp
from hophoop.lab.wasm.stamp import HERE as MODULE_FOLDER
from hophoop.lab.wasm.stamp import LAYOUT, stamped

PACKAGES = ("numba", "llvmlite", "numpy")
BROWSER = "browser"
ALL = (*TARGETS, BROWSER)
TRIED = ((0, 62), (0, 68))  # versions of Numba known to build the library, oldest and newest
OLD = 600.0  # seconds after which files of earlier builds are deleted


def tools() -> dict[str, str]:
    """Return the versions of the packages that the build depends on, and of zig.

    Raises
    ------
    PackageNotFoundError
        If one is not installed.
    """
    return {name: version(name) for name in PACKAGES} | {"ziglang": zig_version()}


def refuse_older(numba: str) -> None:
    """Refuse a Numba that is too old to build the library; print a note about an untested newer one.

    Raises
    ------
    RuntimeError
        If it is older than `TRIED`.
    """
    first, last = (".".join(map(str, each)) for each in TRIED)
    own = tuple(int(part) for part in numba.split(".")[:2])
    if own < TRIED[0]:
        raise RuntimeError(f"Building needs Numba {first} or newer; {numba} is installed.")
    if own > TRIED[1]:
        print(f"Numba {numba} has not been tried: {first} to {last} have built the kernels.", file=sys.stderr)


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
    except RuntimeError:  # no home directory
        return Path(tempfile.mkdtemp())


def compile_group(group: str, targets: Sequence[str], folder: Path) -> None:
    """Compile a group and write its files, in a process of its own."""
    if group in MODULES:
        (folder / f"{group}.wasm").write_bytes(module_of(group))
        _describe(folder / f"{group}.json", {}, stamped())
        return
    from hophoop.kernel.build.entry_code import group_code
    from hophoop.kernel.build.link import object_of

    text, told = group_code(GROUPS[group])
    names = [entry["symbol"] for entry in told.values()]
    for name in targets:
        for level in TARGETS[name].levels:
            (folder / f"{group}-{name}-{level}.o").write_bytes(object_of(text, names, TARGETS[name], level))
    imported = {Path(file) for module in list(sys.modules.values()) if (file := getattr(module, "__file__", None))}
    # it depends on no other sources
    _describe(folder / f"{group}.json", told, [file for file in files() if file in imported or file.suffix == ".json"])


def _describe(file: Path, entries: dict[str, Any], sources: Sequence[Path]) -> None:
    names = [source.relative_to(PACKAGE).as_posix() for source in sources]
    file.write_text(json.dumps({"entries": entries, "sources": names}), encoding="utf-8")


def _file_names(group: str, targets: Sequence[str]) -> list[str]:
    """Return the names of the files that a group produces."""
    if group in MODULES:
        return [f"{group}.wasm", f"{group}.json"]
    return [f"{group}-{name}-{level}.o" for name in targets for level in TARGETS[name].levels] + [f"{group}.json"]


def _cached(group: str, targets: Sequence[str], made_with: str, cache: Path) -> Path | None:
    """Return the cache folder with the group's files from the same sources, or None."""
    try:
        known = json.loads((cache / f"{group}.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    folder = cache / f"{group}-{_hash(known['sources'], made_with)}"
    return folder if all((folder / name).is_file() for name in _file_names(group, targets)) else None


def _compile(group: str, targets: Sequence[str], made_with: str, cache: Path, scratch: Path) -> Path:
    kept = _cached(group, targets, made_with, cache)
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
    except OSError:  # another build was faster
        shutil.rmtree(place, ignore_errors=True)
        part.replace(place)


def _remove(folder: Path) -> None:
    import shutil

    shutil.rmtree(folder, ignore_errors=True)


def build(targets: Sequence[str], out: Path | None = None) -> None:
    """Build libraries, and the browser's modules.

    Parameters
    ----------
    targets : sequence of str
        Of `ALL`.
    out : Path, optional
        Folder for the files of a single target, or of one folder per target. By default they are written into the package.

    Raises
    ------
    PackageNotFoundError
        If Numba or ziglang is not installed.
    RuntimeError
        If Numba is too old, or compiling or linking fails; earlier files remain.
    OSError
        If the folder cannot be written to.
    """
    versions, sources = tools(), stamp()
    refuse_older(versions["numba"])
    made_with = json.dumps([versions, stamp_of_build()])
    native = [name for name in targets if name != BROWSER]
    places = {name: _place(name, targets, out) for name in targets}
    for place in places.values():
        place.mkdir(parents=True, exist_ok=True)
    groups = (*(MODULES if BROWSER in targets else ()), *(GROUPS if native else ()))
    with tempfile.TemporaryDirectory() as scratch:
        with ThreadPoolExecutor(2) as pool:
            jobs = {group: pool.submit(_compile, group, native, made_with, _cache_folder(), Path(scratch)) for group in groups}
            folders = {group: job.result() for group, job in jobs.items()}
        if BROWSER in targets:
            _put_modules(folders, places[BROWSER], versions)
        for name in native:
            about = {"machine": TARGETS[name].machine, "sources": sources, "built_with": versions}
            _link(name, {group: folders[group] for group in GROUPS}, places[name], about, Path(scratch))


def _place(name: str, targets: Sequence[str], out: Path | None) -> Path:
    """Return the folder for the files of a target."""
    if out is not None:
        return out if len(targets) == 1 else out / name
    if name == BROWSER:
        return MODULE_FOLDER
    return HERE if len(set(targets) - {BROWSER}) == 1 else HERE / name


def stamp_of_build() -> str:
    """Return a hash of the files that control how kernels are compiled."""
    return _hash(
        [f"kernel/build/{name}" for name in ("numba_code.py", "entry_code.py", "link.py", "__main__.py")]
        + ["kernel/entries.py"],
        "",
    )


def _put_modules(folders: dict[str, Path], out: Path, versions: dict[str, str]) -> None:
    contents = {group: (folders[group] / f"{group}.wasm").read_bytes() for group in MODULES}
    for group, content in contents.items():
        _replace(out / MODULES[group].file, content)
    _replace(out / LAYOUT, (json.dumps(description_of(contents, versions), indent=1) + "\n").encode())


def _link(name: str, folders: dict[str, Path], out: Path, about: dict[str, Any], scratch: Path) -> None:
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
    _replace(out / MANIFEST, (json.dumps(about | {"files": files, "entries": entries}, indent=1) + "\n").encode())
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
    """Parse the command line and build."""
    parser = argparse.ArgumentParser(prog="python -m hophoop.kernel.build", description="Build the compiled kernels.")
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=f"{', '.join(ALL)}; this machine by default")
    parser.add_argument("--out", type=Path, help="folder for the built files")
    parser.add_argument("--group", choices=[*GROUPS, *MODULES], help=argparse.SUPPRESS)
    parser.add_argument("--into", type=Path, help=argparse.SUPPRESS)
    given = parser.parse_args(arguments)
    unknown = [name for name in given.targets if name not in ALL]
    if unknown:
        parser.error(f"target = {unknown[0]!r} must be one of {', '.join(ALL)}")
    if given.group:
        compile_group(given.group, given.targets, given.into)
        return 0
    try:
        build(list(dict.fromkeys(given.targets)) or [own_target()], given.out)
    except PackageNotFoundError as error:
        print(f"Error: building needs {error.name}: {install_command('build')}. The previous build remains.", file=sys.stderr)
        return 1
    except (RuntimeError, OSError, KeyError) as error:
        print(f"Error: {error} The previous build remains.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
