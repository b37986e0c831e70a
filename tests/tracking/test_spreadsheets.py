"""Tables as a class makes them in a spreadsheet: names, units and encodings that vary, and what a message says of them."""

from pathlib import Path

import numpy as np
import pytest

from hophoop.tracking import Reading, read_track

ROWS = "".join(f"{0.01 * k:.2f};0,1{k};0,3;0,1{k};0,5\n" for k in range(5))


def written(tmp_path, text, encoding="utf-8", name="ours.csv"):
    file = tmp_path / name
    file.write_bytes(text.encode(encoding))
    return file


@pytest.mark.parametrize(
    "names",
    [
        "t;centre x;centre y;load x;load y",
        "Time;Mitte_x;Mitte_y;Gewicht_x;Gewicht_y",
        "t (s);x (m);y (m);mark_x (m);mark_y (m)",
    ],
)
def test_names_of_centre_and_load_are_recognized(tmp_path, names):
    track = read_track(written(tmp_path, names + "\n" + ROWS))
    assert track.centre[:, 0] == pytest.approx([0.10, 0.11, 0.12, 0.13, 0.14])
    assert track.marker[:, 1] == pytest.approx([0.5] * 5)
    assert track.angle == pytest.approx([0.0] * 5)
    assert not track.notes


def test_a_comma_between_quotes_divides_nothing(tmp_path):
    table = 't,x,y,remark\n0.00,0.1,0.3,"dark, blurred"\n"0,01","0,2","0,3",\n0.02,0.3,0.3,\n'
    track = read_track(written(tmp_path, table))
    assert track.t == pytest.approx([0.0, 0.01, 0.02])
    assert track.centre[:, 0] == pytest.approx([0.1, 0.2, 0.3])
    assert track.notes == ("Columns of ours.csv that are not used: remark.",)


def test_columns_that_are_not_used_are_named(tmp_path):
    track = read_track(written(tmp_path, "t;x;y;sticker_x;sticker_y\n" + ROWS))
    assert np.isnan(track.marker).all()
    assert track.notes == ("Columns of ours.csv that are not used: sticker_x, sticker_y.",)


def test_the_columns_that_are_there_are_listed_in_their_order(tmp_path):
    with pytest.raises(ValueError, match=r"its columns are t, right, up, left, down; --column x=HEAD"):
        read_track(written(tmp_path, "t;right;up;left;down\n" + ROWS))


def test_a_title_above_the_names_is_no_point(tmp_path):
    track = read_track(written(tmp_path, "Our hoop with its load;;;;\nt;x;y;load_x;load_y\n" + ROWS))
    assert track.centre[:, 0] == pytest.approx([0.10, 0.11, 0.12, 0.13, 0.14])
    assert track.marker[:, 1] == pytest.approx([0.5] * 5)


@pytest.mark.parametrize("encoding", ["cp1252", "utf-16", "utf-8-sig"])
def test_the_encodings_of_spreadsheets(tmp_path, encoding):
    table = "Größe;;;;\nt (s);x (m);y (m);angle (°);rotation (°)\n" + ROWS
    track = read_track(written(tmp_path, table, encoding))
    assert track.angle == pytest.approx(np.radians([0.10, 0.11, 0.12, 0.13, 0.14]))


def test_a_missing_unit_of_angles_is_explained(tmp_path):
    file = written(tmp_path, "t;x;y;angle;theta\n" + ROWS)
    with pytest.raises(ValueError, match=r"has no unit of angle: write it behind the name, such as angle") as caught:
        read_track(file)
    assert "--angle-unit" in str(caught.value)
    assert "angle_unit=" in str(caught.value)
    assert read_track(file, Reading(angle_unit="deg")).angle[0] == pytest.approx(np.radians(0.10))


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.csv", "", "a.csv is empty"),
        ("a.csv", "0;0,1;0,3\n1;0,2;0,3\n", "has no row of column names, such as t, x, y, angle"),
        ("a.csv", "t;x;y\n0;0,1;0,3\n1;fast;0,3\n2;0;0\n", "has 'fast' in column x, row 2 below the names"),
        ("a.csv", "t,x,y\n0,00,0,1,0,3\n0,01,0,2,0,3\n0,02,0,3,0,3\n", "a row of 6 cells under 3 names: a comma can divide"),
        ("a.xlsx", "PK", "save the sheet as CSV"),
        ("a.ods", "PK", "save the sheet as CSV"),
    ],
)
def test_messages_say_what_to_do(tmp_path, name, text, message):
    with pytest.raises(ValueError) as caught:
        read_track(written(tmp_path, text, name=name))
    assert message in str(caught.value)


def test_the_table_of_the_docs_is_read(tmp_path):
    text = (Path(__file__).parents[2] / "docs" / "film.md").read_text(encoding="utf-8")
    table = text.partition("```text\nt (s);")[2].partition("```")[0]
    track = read_track(written(tmp_path, "t (s);" + table), Reading(radius=0.3))
    assert track.t == pytest.approx([0.0, 0.008, 0.025])  # a row without a mark is left out
    assert track.centre == pytest.approx(np.array([[0.001, 0.3], [0.017, 0.3], [0.05, 0.3]]))
    assert track.angle == pytest.approx(np.radians([0.0, 3.0, 9.0]))
