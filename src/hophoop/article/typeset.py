"""LaTeX in a page as MathML, which browsers draw by themselves: nothing is asked of the network."""

from __future__ import annotations

import re

from hophoop._support.extras import need

DISPLAYED = re.compile(r"\\\[(.+?)\\\]", re.DOTALL)
INLINE = re.compile(r"\\\((.+?)\\\)", re.DOTALL)


def typeset(text: str) -> str:
    r"""A page whose formulas, as LaTeX in ``\(…\)`` and ``\[…\]``, are MathML.

    Parameters
    ----------
    text : str
        HTML.

    Returns
    -------
    html : str

    Raises
    ------
    ImportError
        If math-core is missing.
    """
    text = DISPLAYED.sub(lambda match: f"<div class='formula' tabindex='0'>{mathml(match[1], displayed=True)}</div>", text)
    return INLINE.sub(lambda match: mathml(match[1], displayed=False), text)


def mathml(latex: str, displayed: bool) -> str:
    """One formula as an element of a page."""
    converter = need("math_core", "plots").LatexToMathML(fancy_error=False)
    return str(converter.convert_with_local_state(latex.strip(), displaystyle=displayed))
