"""What the heads of a table mean."""

import pytest

from hophoop.tracking.columns import heads, unit_factor, units
from hophoop.tracking.dialects import COMMA_LANGUAGES, ENGLISH, OTHERS


@pytest.mark.parametrize(
    ("above", "found"),
    [
        ([["", "hub", ""], ["time", "x", "y"]], [("", "t", ""), ("hub", "x", ""), ("hub", "y", "")]),
        ([["t", "angle"], ["s", "deg"]], [("", "t", "s"), ("", "angle", "deg")]),
        ([["t", "Gyroscope z (rad/s)", "accelerometer x"]], [("", "t", ""), ("", "omega", "rad/s"), ("accelerometer", "", "")]),
        (
            [["temps", "Winkelgeschw. z", "rotation rate x cal.", "eje x", "rejected x", "X Velocity (m/s)", "sticker"]],
            [
                ("", "t", ""),
                ("", "omega", ""),
                ("", "omega", ""),
                ("eje", "x", ""),
                ("rejected", "x", ""),
                ("velocity", "", "m/s"),
                ("sticker", "", ""),
            ],
        ),
    ],
)
def test_names_of_columns(above, found):
    assert [(column.point, column.quantity, column.unit) for column in heads(above)] == found


def test_units_in_names_and_their_sizes():
    assert units("Gyroscope (z)") == ("gyroscope z", "")
    assert [unit_factor(text, "m") for text in ("cm", "-mm", "0.5", "q", "s")] == [0.01, -1e-3, 0.5, None, None]


def test_each_word_has_one_meaning_in_one_language():
    languages = [ENGLISH, *COMMA_LANGUAGES.values(), *OTHERS.values()]
    words = [word for language in languages for those in language.values() for word in those.split("|")]
    assert len(words) == len(set(words))
