"""Files of tables, as the tests of tracking write them, and what is read from them."""

import pytest


def saved(folder, text, encoding="utf-8", name="ours.csv"):
    file = folder / name
    file.write_bytes(text.encode(encoding))
    return file


def table(folder, head, *columns, separator=",", form="{:.6f}", decimal="."):
    """A file of a head, which may have several lines, and of columns of numbers or words."""
    cells = [[one if isinstance(one, str) else form.format(one).replace(".", decimal) for one in column] for column in columns]
    return saved(folder, "\n".join([head, *map(separator.join, zip(*cells, strict=True))]))


def assert_read(track, **columns):
    """Columns of a track, by their names in a table, are these, to the digits that were written."""
    found = track.to_dict()["columns"]
    for name, values in columns.items():
        assert found[name] == pytest.approx(values, rel=1e-6, abs=6e-6), name
