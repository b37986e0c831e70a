"""`python -m hophoop.kernel.build`: build the compiled kernels, for this machine or others, and the browser's modules.

Two processes compile the entries, and then optimize them for each kind of processor. What has not changed since an earlier
build is not compiled again. A library is put in place when it is complete; until then the previous one remains.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import Executor
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from hophoop._support.extras import install_command
from hophoop.kernel.build.browser import MODULES, module_of
from hophoop.kernel.build.kept import limit, write
from hophoop.kernel.build.link import TARGETS, linked, object_of, own_target, zig_version
from hophoop.kernel.build.processes import workers
from hophoop.kernel.native.library import HERE, MANIFEST
from hophoop.kernel.native.sources import stamp
from hophoop.lab.wasm.stamp import HERE as MODULE_FOLDER
from hophoop.lab.wasm.stamp import LAYOUT, sources

PACKAGES = ("numba", "llvmlite", "numpy")
BROWSER = "browser"
ALL = (*TARGETS, BROWSER)
TRIED = ((0, 62), (0, 68))  # versions of Numba known to build the library, oldest and newest
OLD = 600.0  # seconds after which libraries of earlier builds are deleted


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
        If Numba is too old, or linking fails; earlier files remain.
    OSError
        If the folder cannot be written to.
    """
    versions = tools()
    refuse_older(versions["numba"])
    limit()
    places = {name: _place(name, targets, out) for name in targets}
    for place in places.values():
        place.mkdir(parents=True, exist_ok=True)
    native = [name for name in targets if name != BROWSER]
    with workers() as pool:
        if native:
            _build_libraries(pool, native, places, versions)
        if BROWSER in targets:
            _build_modules(pool, places[BROWSER], versions)


def _place(name: str, targets: Sequence[str], out: Path | None) -> Path:
    """Return the folder for the files of a target."""
    if out is not None:
        return out if len(targets) == 1 else out / name
    if name == BROWSER:
        return MODULE_FOLDER
    return HERE if len(set(targets) - {BROWSER}) == 1 else HERE / name


def _build_libraries(pool: Executor, targets: Sequence[str], places: dict[str, Path], versions: dict[str, str]) -> None:
    from hophoop.kernel.build.lowering import entry, joined
    from hophoop.kernel.entries import ENTRIES, code_hash

    about = {"sources": stamp(), "code": code_hash(), "built_with": versions}  # before the sources are compiled
    told, codes = zip(*pool.map(entry, ENTRIES), strict=True)
    about["entries"] = dict(zip(ENTRIES, told, strict=True))
    code, names = pool.submit(joined, codes).result(), [each["symbol"] for each in told]
    jobs = {
        (name, level): pool.submit(object_of, code, names, name, level) for name in targets for level in TARGETS[name].levels
    }
    for name in targets:
        objects = {level: jobs[name, level].result() for level in TARGETS[name].levels}
        _put_library(
            name,
            objects,
            places[name],
            about | {"machine": TARGETS[name].machine},
        )


def _put_library(name: str, objects: dict[str, bytes], out: Path, about: dict[str, Any]) -> None:
    target, files = TARGETS[name], {}
    for level, content in objects.items():
        with tempfile.TemporaryDirectory() as scratch:
            made = linked(content, target, Path(scratch) / f"kernels-{name}-{level}{target.suffix}")
        files[level] = f"kernels-{level}-{hashlib.sha256(made).hexdigest()[:12]}{target.suffix}"
        if not (out / files[level]).exists():
            write(out / files[level], made)
    write(out / MANIFEST, (json.dumps(about | {"files": files}, indent=1) + "\n").encode())
    for old in out.glob("kernels-*"):
        if old.name not in files.values() and time.time() - old.stat().st_mtime > OLD:
            old.unlink(missing_ok=True)


def _build_modules(pool: Executor, out: Path, versions: dict[str, str]) -> None:
    told: dict[str, Any] = {"sources": sources()}  # before they are compiled
    for name, content in zip(MODULES, pool.map(module_of, MODULES), strict=True):
        write(out / MODULES[name].file, content)
        told[name] = hashlib.sha256(content).hexdigest()[:16]
    from hophoop.lab.wasm.layout import layout

    write(out / LAYOUT, (json.dumps(told | {"built_with": versions} | layout(), indent=1) + "\n").encode())


def main(arguments: Sequence[str] | None = None) -> int:
    """Parse the command line and build."""
    parser = argparse.ArgumentParser(prog="python -m hophoop.kernel.build", description="Build the compiled kernels.")
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=f"{', '.join(ALL)}; this machine by default")
    parser.add_argument("--out", type=Path, help="folder for the built files")
    given = parser.parse_args(arguments)
    unknown = [name for name in given.targets if name not in ALL]
    if unknown:
        parser.error(f"target = {unknown[0]!r} must be one of {', '.join(ALL)}")
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
