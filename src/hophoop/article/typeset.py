"""LaTeX in a page as MathML, which browsers draw by themselves: nothing is asked of the network."""

from __future__ import annotations

import re

from hophoop._support.extras import need

DISPLAYED = re.compile(r"\\\[(.+?)\\\]", re.DOTALL)
INLINE = re.compile(r"\\\((.+?)\\\)", re.DOTALL)

FUNCTION = re.compile("<mi>(cos|sin)</mi>")
BEFORE = re.compile("(</mi>|</msup>|</msub>)<mi>(cos|sin)</mi>")


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
        If latex2mathml is missing.
    """
    text = DISPLAYED.sub(lambda match: f"<div class='formula' tabindex='0'>{mathml(match[1], displayed=True)}</div>", text)
    return INLINE.sub(lambda match: mathml(match[1], displayed=False), text)


def mathml(latex: str, displayed: bool) -> str:
    """One formula as an element of a page."""
    convert = need("latex2mathml.converter", "plots").convert
    made: str = convert(latex.strip(), display="block" if displayed else "inline")
    made = made.replace("<mover>", "<mover accent='true'>")  # close to its letter
    # names of functions stand off from what is beside them
    made = FUNCTION.sub(r"<mi>\1</mi><mspace width='0.17em'/>", made)
    return BEFORE.sub(r"\1<mspace width='0.17em'/><mi>\2</mi>", made)
