"""Figures on dark pages: every drawing of Matplotlib gets a second set of colours, which a dark page asks for.

A browser shows an SVG file in the colours of the page that it stands in (`color-scheme` in site.css). Pictures made of
pixels stay as they are.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

from hophoop.article.inks import for_both

MADE_BY = "Matplotlib"  # in the file's metadata
DARK = "prefers-color-scheme"


def add_dark_colors(app: Sphinx, exception: Exception | None) -> None:
    """Rewrite the drawings that the build has copied beside its pages."""
    if exception is None and app.builder.format == "html":
        for path in Path(app.outdir, app.builder.imagedir).glob("*.svg"):
            drawing = path.read_text(encoding="utf-8")
            if MADE_BY in drawing and DARK not in drawing:
                path.write_text(for_both(drawing), encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    """After Sphinx has copied its images, which it does as the build ends."""
    app.connect("build-finished", add_dark_colors, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
