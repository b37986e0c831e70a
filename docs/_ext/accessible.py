"""What pages need so that they can be read with the keyboard alone and be read aloud.

Sphinx gives captions of the navigation the role of a heading without its level, and code and tables that are wider than
the screen scroll by mouse or finger only.
"""

from __future__ import annotations

from typing import Any

from sphinx.application import Sphinx

CAPTION = ('role="heading"', 'role="heading" aria-level="2"')
SCROLLING = (
    ('<div class="highlight"><pre>', '<div class="highlight"><pre tabindex="0">'),
    ('<div class="table-wrapper', '<div tabindex="0" role="group" aria-label="table" class="table-wrapper'),
)


def mend(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """Put in what is missing, just before a page is written."""
    for name in ("furo_navigation_tree", "toc"):
        if name in context:
            context[name] = context[name].replace(*CAPTION)
    for old, new in SCROLLING if "body" in context else ():
        context["body"] = context["body"].replace(old, new)


def setup(app: Sphinx) -> dict[str, Any]:
    """After the theme has made its navigation."""
    app.connect("html-page-context", mend, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
