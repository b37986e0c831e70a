"""Tables of all commands on narrow terminals: whole numbers, and a word on what is left out."""

from __future__ import annotations

import pytest
from rich.console import Console

from cli_tools import HOP, done
from hophoop.cli import _tables

COMMANDS = {
    "run": HOP,
    "errors": f"{HOP} --errors",
    "digits": "run --v0 3.1 --duration 0.5 --digits 30",
    "check": "run --v0 3.1 --duration 0.5 --check",
    "prove": "prove --v0 3.1 --duration 0.5",
    "thresholds": "prove --thresholds painleve_friction",
    "theory": "theory",
    "plan": "plan --v0 3.1 --duration 0.4 --rate 60",
    "gait": "gait --slope-deg 3 --gamma 0.5 --near 8.68",
}
MISSING = "Not shown for want of width: "


@pytest.fixture
def printed(monkeypatch):
    """What a command prints on a terminal of a width."""

    def of(name: str, width: int) -> str:
        monkeypatch.setattr(_tables, "console_of", lambda _: Console(highlight=False, width=width))
        return done(COMMANDS[name]).stdout

    return of


@pytest.mark.parametrize("name", COMMANDS)
def test_no_cell_is_cut_and_no_column_leaves_without_a_word(printed, name):
    wide = printed(name, 1000)
    assert MISSING not in wide
    for width in (80, 30):
        text = printed(name, width)
        assert text.count("…") == wide.count("…")
        assert all(len(line) <= width for line in text.splitlines() if "─" in line)


@pytest.mark.parametrize(
    ("name", "width", "missing"),
    [
        ("run", 80, "slip (m/s), x (m)."),
        ("errors", 80, "slip (m/s), x (m)."),
        ("digits", 80, "θ̇ (rad/s), v (m/s), x (m), θ (rad)."),
        ("gait", 80, "hop (m), revolutions, next boundary."),
        ("prove", 80, "θ̇ (rad/s), v (m/s), x (m)."),
    ],
)
def test_what_is_left_out_is_said(printed, name, width, missing):
    text = " ".join(printed(name, width).split())
    assert f"{MISSING}{missing}" in text


def test_numbers_longer_than_the_terminal_take_several_lines(printed):
    text = printed("digits", 30)
    whole = printed("digits", 1000)
    first = next(word for word in whole.split() if word.startswith("0.2663"))
    assert first not in text
    assert "…" not in text
    assert "0.26" in text
