"""Formulas become MathML; what the converter does not know is not passed over."""

import pytest

math_core = pytest.importorskip("math_core")
pytest.importorskip("sphinx")
import typeset  # noqa: E402


def test_lines_without_an_environment_are_aligned():
    made = typeset.mathml(r"a &= \frac{b}{2} \\ c &= d", display=True)
    assert 'display="block"' in made
    assert (made.count("<mfrac>"), made.count("<mtr>")) == (1, 2)


def test_a_command_that_nobody_knows_is_an_error():
    with pytest.raises(math_core.LatexError):
        typeset.mathml(r"\nothinglikethis x", display=False)


@pytest.mark.parametrize(("latex", "found"), [(r"a \\[4pt] b", r"\\[4pt]"), (r"a \\ b", None), (r"x\,[y]", None)])
def test_space_between_lines_is_found(latex, found):
    assert typeset.unknown(latex) == found
