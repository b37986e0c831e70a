"""The built modules, and whether they are those of the sources beside them."""

from __future__ import annotations

import hashlib
import json
from functools import cache
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
MODULE, DERIVATIVES, LAYOUT = "hophoop.wasm", "hophoop-derivatives.wasm", "layout.json"
# What decides the modules' bytes: rooms, and files of other rooms.
ROOMS = ("numerics", "physics", "panels", "records", "rigid", "compliant", "theory/kernels", "derivatives", "module")
FILES = (
    *(f"_jit/{name}.py" for name in ("__init__", "dispatchers", "kernels", "plain", "quicker")),  # how they are compiled
    "kernel/build/link.py", "maps/friction_use.py", "maps/kernel.py",
)  # fmt: skip


@cache
def built() -> dict[str, Any]:
    """What is told of the modules that are built: their sources, their hashes, how they are called.

    Returns
    -------
    told : dict
        The content of `LAYOUT`.
    """
    told: dict[str, Any] = json.loads((HERE / LAYOUT).read_text(encoding="utf-8"))
    return told


def stamped() -> list[Path]:
    """The sources that decide the modules' bytes.

    Returns
    -------
    files : list of Path
        Sorted.
    """
    package = HERE.parent
    files = {package / name for name in FILES}
    for room in ROOMS:
        files.update((package / room).glob("*.py"), (package / room).glob("*.c"))
    return sorted(files - {Path(__file__)})


def sources() -> str:
    """Hash of the sources that the modules are made of.

    Returns
    -------
    stamp : str
        Equal stamps, equal sources.
    """
    digest = hashlib.sha256()
    for file in stamped():
        name = file.relative_to(HERE.parent).as_posix()
        digest.update(f"{name}\n".encode())
        digest.update(file.read_bytes().replace(b"\r\n", b"\n"))
    return digest.hexdigest()[:32]
