"""Formulas become MathML; what the converter does not know is not passed over."""

import re
import sys
from pathlib import Path

import pytest

math_core = pytest.importorskip("math_core", reason="the extra 'docs' is not installed")
pytest.importorskip("sphinx", reason="the extra 'docs' is not installed")
sys.path.insert(0, str(Path(__file__).parents[2] / "docs" / "_ext"))
import typeset  # noqa: E402

DOCS = Path(__file__).parents[2] / "docs"


def test_a_formula_has_its_parts():
    made = typeset.mathml(r"N = m\left(g - \frac{v_0^2}{R}\right)", display=True)
    assert made.startswith("<math")
    assert 'display="block"' in made
    assert made.count("<mfrac>") == 1
    assert made.count("<msubsup>") == 1


def test_lines_without_an_environment_are_aligned():
    assert typeset.mathml(r"a &= b \\ c &= d", display=True).count("<mtr>") == 2


def test_a_command_that_nobody_knows_is_an_error():
    with pytest.raises(math_core.LatexError):
        typeset.mathml(r"\nothinglikethis x", display=False)


@pytest.mark.parametrize(("latex", "found"), [(r"a \\[4pt] b", r"\\[4pt]"), (r"a \\ b", None), (r"x\,[y]", None)])
def test_space_between_lines_is_found(latex, found):
    assert typeset.unknown(latex) == found


def test_every_formula_of_the_pages_can_be_set():
    formulas = [
        (page.name, formula[1])
        for page in sorted(DOCS.rglob("*.md"))
        if "gallery" not in page.parts
        for formula in re.finditer(r"^\$\$\n(.*?)^\$\$$", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    ]
    assert len(formulas) > 30
    for name, latex in formulas:
        assert typeset.unknown(latex) is None, name
        assert "<merror" not in typeset.mathml(latex.strip(), display=True), name
