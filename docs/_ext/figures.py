"""Figures that the scripts of examples/figures draw while pages are built; the others are kept in docs/figures."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
from sphinx.application import Sphinx

SCRIPTS = Path(__file__).parents[2] / "examples" / "figures"


def draw(app: Sphinx) -> None:
    """Draw all figures of a script that is newer than those it drew before."""
    folder = Path(app.srcdir, "figures", "drawn")
    folder.mkdir(parents=True, exist_ok=True)
    for script in sorted(SCRIPTS.glob("*.py")):
        done = folder / f".{script.stem}"
        if not done.exists() or done.stat().st_mtime < script.stat().st_mtime:
            with plt.rc_context({"svg.hashsalt": "hophoop", "backend": "agg"}):
                runpy.run_path(str(script))["draw"](folder)
            done.touch()


def setup(app: Sphinx) -> dict[str, Any]:
    """Before pages are read."""
    app.connect("builder-inited", draw)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
