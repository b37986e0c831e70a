"""Convert LaTeX in a page to MathML, which browsers draw without scripts or network."""

from __future__ import annotations

import re

from hophoop._support.extras import need

DISPLAYED = re.compile(r"\\\[(.+?)\\\]", re.DOTALL)
INLINE = re.compile(r"\\\((.+?)\\\)", re.DOTALL)


def typeset(text: str) -> str:
    r"""Convert the formulas of a page, LaTeX in ``\(…\)`` and ``\[…\]``, to MathML.

    text: HTML.
    """
    text = DISPLAYED.sub(lambda match: f"<div class='formula' tabindex='0'>{mathml(match[1], displayed=True)}</div>", text)
    return INLINE.sub(lambda match: mathml(match[1], displayed=False), text)


def mathml(latex: str, displayed: bool) -> str:
    """Convert one formula to MathML."""
    converter = need("math_core", "plots").LatexToMathML(fancy_error=False)
    return str(converter.convert_with_local_state(latex.strip(), displaystyle=displayed))
