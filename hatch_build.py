"""The build hook: a wheel, or an editable install, gets the library of compiled kernels.

`HOPHOOP_TARGET` names another target of `hophoop.kernel.build.link`; `HOPHOOP_BUILD=0` leaves the library out.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from packaging.tags import sys_tags

sys.path.insert(0, str(Path(__file__).parent / "src"))  # the sources of this folder, whatever is installed

# The platform tag of each target: the oldest C library or system that zig links it for.
PLATFORMS = {
    "linux-x86_64": "manylinux_2_28_x86_64",
    "linux-aarch64": "manylinux_2_28_aarch64",
    "musllinux-x86_64": "musllinux_1_2_x86_64",
    "musllinux-aarch64": "musllinux_1_2_aarch64",
    "macos-arm64": "macosx_11_0_arm64",
    "macos-x86_64": "macosx_11_0_x86_64",
    "windows-amd64": "win_amd64",
}
TOOLS = ("numba", "ziglang", "numpy", "pydantic")
COST = "hophoop is installed without compiled kernels, and a motion takes some milliseconds instead of 20 µs"
LATER = "`pip install 'hophoop[build]'` and `python -m hophoop.kernel.build` build them"


class NoLibrary(Exception):
    """Why this package is built without a library."""


def own_target() -> str:
    """The target that is this machine.

    Raises
    ------
    NoLibrary
        If there is none.
    """
    from hophoop.kernel.build.link import own_target as named

    try:
        target = named()
    except KeyError as error:
        raise NoLibrary(f"{error.args[0].removesuffix('.')}: {COST}.") from None
    # an older system, or a Python of 32 bits
    if PLATFORMS[target] not in {tag.platform for tag in sys_tags()}:
        raise NoLibrary(f"This Python takes no {PLATFORMS[target]}: {COST}.")
    return target


class CustomBuildHook(BuildHookInterface):
    """Builds the library, and packs it."""

    def target(self) -> str:
        """The target to build for.

        Raises
        ------
        NoLibrary
            If the library is to be left out.
        """
        if os.environ.get("HOPHOOP_BUILD") == "0":
            raise NoLibrary(f"HOPHOOP_BUILD=0: {COST}; {LATER}.")
        wanted = os.environ.get("HOPHOOP_TARGET")
        if wanted and wanted not in PLATFORMS:
            self.app.abort(f"HOPHOOP_TARGET = {wanted!r} must be one of {', '.join(PLATFORMS)}.")
        return wanted or own_target()

    def dependencies(self) -> list[str]:
        """What the build of the library needs; nothing where there will be none."""
        try:
            self.target()
        except NoLibrary:
            return []
        if any(tag.platform.startswith("musllinux") for tag in sys_tags()):  # Numba has no wheels for this machine
            return []
        core = self.metadata.core
        return [*core.optional_dependencies["build"], *(one for one in core.dependencies if one.startswith(TOOLS))]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build the library: in place for an editable install, or to be packed into a wheel."""
        try:
            target = self.target()
            missing = [name for name in TOOLS if find_spec(name) is None and not (name == "ziglang" and which("zig"))]
            if missing:
                raise NoLibrary(f"{missing[0]} is not installed: {COST}; {LATER}.")
        except NoLibrary as why:
            self.app.display_warning(str(why))
            return
        if version == "editable":
            self.build(target, Path(self.root, "src", "hophoop", "kernel", "library"))
            return
        # a folder of its own: the library in the sources may be of another machine, and stays
        self.folder = TemporaryDirectory()
        out = Path(self.folder.name)
        self.build(target, out)
        told = json.loads((out / "kernels.json").read_text(encoding="utf-8"))
        for name in ("kernels.json", *told["files"].values()):
            build_data["force_include"][str(out / name)] = f"hophoop/kernel/library/{name}"
        build_data["tag"] = f"py3-none-{PLATFORMS[target]}"
        build_data["pure_python"] = False

    def build(self, target: str, out: Path) -> None:
        """Run the build in a process that finds what pip has installed for this one alone."""
        self.app.display_info(f"Compiling the kernels for {target}: half a minute to a minute.")
        # pip's own start-up file would take out again what this environment has from another installation of hophoop
        path = os.pathsep.join(place for place in sys.path if place and not Path(place, "sitecustomize.py").exists())
        command = [sys.executable, "-m", "hophoop.kernel.build", target, "--out", str(out)]
        if subprocess.run(command, env=os.environ | {"PYTHONPATH": path}, check=False).returncode:
            self.app.abort(
                "The kernels could not be compiled, for the reason above. HOPHOOP_BUILD=0 installs hophoop without "
                "compiled kernels."
            )

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Remove what has been packed."""
        if hasattr(self, "folder"):
            self.folder.cleanup()
