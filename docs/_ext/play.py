"""The lab itself beside the pages: it computes in the visitor's browser, so that "play" needs no server."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

from hophoop.lab.site import export as site


def after_the_pages(app: Sphinx, error: Exception | None) -> None:
    """Write it where the front page's links expect it."""
    if error is None and app.builder.name == "html":
        site.export(Path(app.outdir) / "play", docs="../")


def setup(app: Sphinx) -> dict[str, Any]:
    """When all pages are written."""
    app.connect("build-finished", after_the_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
