"""Pictures of the lab as it is now: the build takes them anew, in place of the kept ones, where there is a Chromium."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

SCRIPT = Path(__file__).parents[2] / "examples" / "lab_picture.py"


def retake(app: Sphinx, error: Exception | None) -> None:
    """After Sphinx has copied its images: those that pages show, by their names."""
    if error is None and app.builder.name == "html":
        runpy.run_path(str(SCRIPT))["take"](Path(app.outdir, app.builder.imagedir))


def setup(app: Sphinx) -> dict[str, Any]:
    """When all pages are written."""
    app.connect("build-finished", retake, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
