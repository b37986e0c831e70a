"""Words that are never right in docstrings, comments, messages and help texts (how we write).

Some of the list need a reader: 'begin' as a verb is right, and so is 'room' for space; only their clear cases are found here.
"""

from __future__ import annotations

import ast
import io
import re
import sys
import tokenize
from collections.abc import Iterator
from pathlib import Path

import pytest

SOURCE = Path(__file__).parents[1] / "src" / "hophoop"

_COUNTED = "line|row|column|record|number|letter|file|segment|thread|entry|sample|value|cell|process|word|name|call"
NEVER = {
    "beside": r"(?<!#)\bbeside\b",
    "mended": r"\bmend(?:s|ed|ing)?\b",
    "booked": r"\bbooked\b",
    "but for": r"\bbut for\b",
    "some 30": r"\bsome \d",
    "hilltop": r"\bhilltops?\b",
    "of before": r"\bof before\b",
    "taken up again": r"\b(?:taken?|took) up again\b",
    "one line a …": rf"\bone (?:{_COUNTED}) an? \w",
    "begin (noun)": r"(?:\b(?:the|an?|its|their|each|every|this)|['’]s) begins?\b"
    r"(?! (?:with|to|at|in|here|there|again|anew)\b)",
    "house": r"\bhouses?\b",
    "room": r"(?<!\bno )(?<!\benough )(?<!\bmore )(?<!\bis )(?<!\bwithout )(?<!`)\brooms?\b(?! (?:for|to)\b)",
}


def texts_of(source: str) -> Iterator[tuple[int, str]]:
    """Docstrings, messages (strings with a space) and comments of a program, with their lines."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value.strip():
            yield node.lineno, node.value
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string


def found_in(text: str) -> list[str]:
    """The names of the words in a text, whatever its line breaks."""
    joined = re.sub(r"\s+", " ", text)
    return [name for name, pattern in NEVER.items() if re.search(pattern, joined, re.IGNORECASE)]


def hits(path: Path) -> list[str]:
    """Where a file has such words."""
    where = path.relative_to(SOURCE)
    return [f"{where}:{line}: {word}" for line, text in texts_of(path.read_text(encoding="utf-8")) for word in found_in(text)]


ROOT = SOURCE.parents[1]
# the lab is being rewritten
PAGES = [
    page
    for page in [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").rglob("*.md"))]
    if not {"tables", "gallery", "generated"} & set(page.parts) and page.name != "lab.md"
]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_no_page_has_words_that_are_never_right(page):
    text = re.sub(r"^#+ .*$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE)  # headings are anchors of the code
    assert found_in(text) == []


def test_no_words_that_are_never_right():
    assert [hit for path in sorted(SOURCE.rglob("*.py")) for hit in hits(path)] == []


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Samples beside an event.", ["beside"]),
        ("besides, it is fixed", []),
        ("a defect that was mended", ["mended"]),
        ("some 30 events, one row\n    an event", ["some 30", "one line a …"]),
        ("one of a kind", []),
        ("files of before rolling resistance", ["of before"]),
        ("at the panel's begin", ["begin (noun)"]),
        ("The motions begin at rest", []),
        ("the rules of the house", ["house"]),
        ("a module of this room", ["room"]),
        ("there is no room for more events", []),
    ],
)
def test_the_words_are_found(text, found):
    assert found_in(text) == found


def test_docstrings_messages_and_comments_are_read():
    program = '''"""Beside."""\n\nraise ValueError(f"{x} is beside it")  # beside\nname = "beside"\n'''
    assert sorted(line for line, text in texts_of(program.replace("Beside", "One beside")) if found_in(text)) == [1, 3, 3]


if __name__ == "__main__":  # python tests/test_words.py: the words in all packages
    for path in sorted(SOURCE.rglob("*.py")):
        for hit in hits(path):
            sys.stdout.write(f"{hit}\n")
