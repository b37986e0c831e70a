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
FILES = ("maps/friction_use.py", "maps/kernel.py")


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


def sources() -> str:
    """Hash of the sources that the modules are made of.

    Returns
    -------
    stamp : str
        Equal stamps, equal sources.
    """
    package = HERE.parent
    files = [package / name for name in FILES]
    for room in ROOMS:
        files += [*(package / room).glob("*.py"), *(package / room).glob("*.c")]
    files.remove(Path(__file__))
    digest = hashlib.sha256()
    for file in sorted(files):
        name = file.relative_to(package).as_posix()
        digest.update(f"{name}\n".encode())
        digest.update(file.read_bytes().replace(b"\r\n", b"\n"))
    return digest.hexdigest()[:32]
