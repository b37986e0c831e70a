"""Tables of all commands on narrow terminals: whole numbers, and a word on what is left out."""

import pytest
from rich.console import Console

from cli_tools import HOP, done
from hophoop.cli import _tables

# by command, the columns that 80 characters leave out
COMMANDS = {
    HOP: "slip (m/s), x (m).",
    f"{HOP} --errors": "slip (m/s), x (m).",
    "run --v0 3.1 --duration 0.5 --digits 30": "θ̇ (rad/s), v (m/s), x (m), θ (rad).",
    "run --v0 3.1 --duration 0.5 --check": "",
    "prove --v0 3.1 --duration 0.5": "θ̇ (rad/s), v (m/s), x (m).",
    "prove --thresholds immediate_hop_speed": "",
    "theory": "",
    "plan --v0 1 --duration 0.2 --rate 60": "",
    "gait --slope-deg 3 --gamma 0.5 --near 8.68": "hop (m).",
}
MISSING = "Not shown for want of width: "


@pytest.mark.parametrize(("line", "missing"), COMMANDS.items())
def test_no_cell_is_cut_and_no_column_leaves_without_a_word(monkeypatch, line, missing):
    """Where no column is spare, numbers take several lines."""
    for width in (80, 30):
        monkeypatch.setattr(_tables, "console_of", lambda _, width=width: Console(highlight=False, width=width))
        text = done(line).stdout
        assert "…" not in text
        assert all(len(row) <= width for row in text.splitlines() if "─" in row)
        if width == 80:
            assert (MISSING in text) == bool(missing)
            assert f"{MISSING}{missing}" in " ".join(text.split()) or not missing
