"""Where things lie in the checkout."""

from pathlib import Path

ROOT = Path(__file__).parents[1]
DATA = ROOT / "tests" / "data"


def text_of(place):
    """The text of a file, by its place from the root."""
    return (ROOT / place).read_text(encoding="utf-8")
