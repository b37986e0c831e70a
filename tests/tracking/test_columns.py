"""The steps from the text of a table to columns, one by one."""

import numpy as np
import pytest

from hophoop.scenario import InputError
from hophoop.tracking.columns import apart, columns, grouped, heads, read_columns, sniff, split, unit_factor, units
from hophoop.tracking.dialects import COMMA_LANGUAGES, ENGLISH, OTHERS


@pytest.mark.parametrize(
    ("text", "sign"),
    [
        ("t,x\n0,1\n1,2\n", ","),
        ("t;x\n0,5;1,5\n1,5;2,5\n", ";"),
        ("t\tx\n0,5\t1,5\n1,5\t2,5\n", "\t"),
        ("t x\n0 1\n1 2\n", ""),
        ("x\n0,5\n1,5\n", ""),
    ],
)
def test_the_sign_between_cells(text, sign):
    assert sniff(text).separator == sign


def test_comments_stay_with_the_lines_below_them():
    layout = sniff("# hub\nt x\n0 1\n% load\n2 3\n")
    assert layout.lines == [("hub", ""), ("hub", "t x"), ("hub", "0 1"), ("load", ""), ("load", "2 3")]


def test_rows_of_numbers_and_those_around_them():
    table = split(sniff("Our hoop\nt;x\n0;1\n1;\n\nmade by hand\n"), "ours.csv")
    assert table.above == [["Our hoop"], ["t", "x"]]
    assert table.body.fillna("").to_numpy().tolist() == [["0", "1"], ["1", ""]]
    assert table.below == "made by hand"
    for text, said in (("", "is empty"), ("a;b\nc;d\n", "has no row of numbers")):
        with pytest.raises(InputError, match=said):
            split(sniff(text), "ours.csv")


@pytest.mark.parametrize(
    ("above", "found"),
    [
        ([["t (s)", "hub x (m)"]], [("", "t", "s"), ("hub", "x", "m")]),
        ([["", "hub", ""], ["time", "x", "y"]], [("", "t", ""), ("hub", "x", ""), ("hub", "y", "")]),
        ([["t", "angle"], ["s", "deg"]], [("", "t", "s"), ("", "angle", "deg")]),
        ([["frame_idx", "hub.x"]], [("", "frame", ""), ("hub", "x", "")]),
        ([["Zeit", "Winkel in rad"]], [("", "t", ""), ("", "angle", "rad")]),
        ([["t", "Gyroscope z (rad/s)", "accelerometer x"]], [("", "t", ""), ("", "omega", "rad/s"), ("accelerometer", "", "")]),
        (
            [["temps", "Winkelgeschw. z", "rotation rate x cal.", "eje x", "rejected x"]],
            [
                ("", "t", ""),
                ("", "omega", ""),
                ("", "omega", ""),
                ("eje", "x", ""),
                ("rejected", "x", ""),
            ],
        ),
    ],
)
def test_names_of_columns(above, found):
    assert [(head.point, head.quantity, head.unit) for head in heads(above)] == found


@pytest.mark.parametrize(
    ("name", "words", "unit"),
    [
        ("x (cm)", "x", "cm"),
        ("x [m]", "x", "m"),
        ("ω / rad/s", "ω", "rad/s"),
        ("x in mm", "x", "mm"),
        ("Gyroscope (z)", "gyroscope z", ""),
    ],
)
def test_units_in_names(name, words, unit):
    assert units(name) == (words, unit)


@pytest.mark.parametrize(
    ("text", "kind", "size"), [("cm", "m", 0.01), ("-mm", "m", -1e-3), ("us", "s", 1e-6), ("0.5", "m", 0.5), ("q", "m", None)]
)
def test_sizes_of_units(text, kind, size):
    assert unit_factor(text, kind) == size


def test_each_word_has_one_meaning_in_one_language():
    languages = [ENGLISH, *COMMA_LANGUAGES.values(), *OTHERS.values()]
    words = [word for language in languages for those in language.values() for word in those.split("|")]
    assert len(words) == len(set(words))


def test_numbers_and_clocks_of_columns():
    table = split(sniff("t;x;y\n10:15:00,5;1,25;-\n10:15:01,0;1,5;2,5\n"), "ours.csv")
    (t, x, y), notes = columns(table, heads(table.above), "ours.csv", None)
    assert t.values.tolist() == [0.0, 0.5]
    assert x.values.tolist() == [1.25, 1.5]
    assert np.isnan(y.values[0])
    assert notes == []


def test_columns_with_times_of_their_own_are_groups():
    found, _ = read_columns("t,x,t,x\n0,1,0,2\n1,2,2,3\n", "ours.csv")
    assert [column.group for column in grouped(found)] == [column.group for column in found]
    found, _ = read_columns("x (m) Run #1,x (m) Run #2\n1,2\n2,3\n", "ours.csv")
    assert [column.group for column in found] == ["Run #1", "Run #2"]


def test_rows_of_several_objects_become_columns():
    text = "name,t,x\n" + "".join(f"{name},{t},{t + shift}\n" for t in range(4) for name, shift in (("hub", 1), ("load", 2)))
    table = split(sniff(text), "spots.csv")
    found, _ = columns(table, heads(table.above), "spots.csv", None)
    wide = apart(found, table.comments)
    assert [(column.head.point, column.values.tolist()) for column in wide] == [
        ("", [0, 1, 2, 3]), ("hub", [1, 2, 3, 4]), ("load", [2, 3, 4, 5])
    ]  # fmt: skip
