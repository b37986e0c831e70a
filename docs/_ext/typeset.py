"""Mathematics as MathML when the pages are built, so that they need no network and no program to show it.

A formula that cannot be converted is a warning, which CI takes for an error.
"""

from __future__ import annotations

import re
from html import escape
from typing import Any

import math_core
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util import logging
from sphinx.writers.html5 import HTML5Translator

log = logging.getLogger(__name__)
CONVERTER = math_core.LatexToMathML(fancy_error=False)


def mathml(latex: str, display: bool) -> str:
    """A formula of LaTeX as MathML, with its source as the text that speaks for it where MathML is unknown."""
    if display and r"\\" in latex and r"\begin{" not in latex:
        latex = rf"\begin{{aligned}}{latex}\end{{aligned}}"
    return str(CONVERTER.convert_with_local_state(latex, displaystyle=display))


def unknown(latex: str) -> str | None:
    """What the converter would print instead of obeying it."""
    found = re.search(r"\\\\\s*\[[^\]]*\]", latex)
    return found[0] if found else None


def _converted(node: nodes.Element, display: bool) -> str:
    latex = node.astext().strip()
    if unknown(latex):
        log.warning("formula %r: %s is not known here", latex, unknown(latex), location=node)
    try:
        return mathml(latex, display)
    except math_core.LatexError as error:
        log.warning("formula %r: %s", latex, error, location=node)
        return f"<code>{escape(latex)}</code>"


def inline(self: HTML5Translator, node: nodes.math) -> None:
    """In a sentence."""
    before, after = escape(node.get("before", "")), escape(node.get("after", ""))
    self.body.append(f'<span class="math">{before}{_converted(node, display=False)}{after}</span>')
    raise nodes.SkipNode


def block(self: HTML5Translator, node: nodes.math_block) -> None:
    """By itself; where it is wider than a narrow screen it scrolls, also by the keyboard."""
    self.body.append(
        f'<div class="math" tabindex="0" role="group" aria-label="formula">{_converted(node, display=True)}</div>\n'
    )
    raise nodes.SkipNode


class KeepTogether(SphinxPostTransform):
    """Brackets and commas beside a formula stay on its line."""

    default_priority = 900

    def run(self, **kwargs: Any) -> None:
        """Move them into the formula's own box, which does not break."""
        for node in list(self.document.findall(nodes.math)):
            place = node.parent.index(node)
            self._take(node, place - 1, "before", r"(.*?)([(\[„“‘]*)$", 2)
            self._take(node, place + 1, "after", r"([)\].,;:!?”’]*)(.*)$", 1)

    @staticmethod
    def _take(node: nodes.math, place: int, name: str, pattern: str, group: int) -> None:
        if not 0 <= place < len(node.parent) or not isinstance(beside := node.parent[place], nodes.Text):
            return
        found = re.match(pattern, str(beside), re.DOTALL)
        if found is not None and found[group]:
            node[name] = found[group]
            node.parent[place] = nodes.Text(found[3 - group])


def setup(app: Sphinx) -> dict[str, Any]:
    """Take the place of Sphinx's MathJax."""
    app.add_post_transform(KeepTogether)
    app.add_html_math_renderer("mathml", (inline, None), (block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
