"""What theory takes out of a line's classes, and which neighbours it finds unexplained."""

from types import SimpleNamespace

import numpy as np

from hophoop.maps.survey.arrangement import Arrangement, Borders, Meeting, Seen
from hophoop.maps.survey.rules import Rules, explain
from hophoop.maps.survey.slices import Slice
from hophoop.maps.survey.strips import across


def tidied(names, y):
    """What is left of a line, stretch by stretch."""
    table = list(dict.fromkeys(names))
    codes = np.array([table.index(name) for name in names])
    one = Rules(SimpleNamespace(names=table)).remove_spurious(Slice(0.5, np.array(y), codes))
    assert one.y.size == one.codes.size + 1
    assert (one.y[0], one.y[-1]) == (y[0], y[-1])
    return [table[code] for code in one.codes], one.y.tolist()


def test_what_is_no_motion_is_taken_out():
    names, y = tidied(["RKRSH takeoff", "KRSH takeoff", "H takeoff"], [1.0, 2.0, 2.0 + 1e-13, 3.0])
    assert names == ["RKRSH takeoff", "H takeoff"]
    assert 2.0 < y[1] < 2.0 + 1e-13
    assert tidied(["RSK reversal", "RSSK reversal", "RSK reversal"], [1.0, 2.0, 2.1, 3.0]) == (["RSK reversal"], [1.0, 3.0])
    assert tidied(["R revolutions", "R undetermined"], [1.0, 2.0, 3.0])[0] == ["R revolutions"]


def test_simultaneous_touches_of_the_cone_are_one_border():
    first, half, last = "R revolutions", "RKR revolutions", "RKRSR revolutions"
    assert tidied([first, half, last], [1.0, 2.0, 2.0 + 1e-9, 3.0])[0] == [first, last]
    # a class of its own, and one that is none of the halves, stay
    assert tidied([first, half, last], [1.0, 2.0, 2.1, 3.0])[0] == [first, half, last]
    assert tidied([first, "RKS revolutions", last], [1.0, 2.0, 2.0 + 1e-9, 3.0])[0] == [first, "RKS revolutions", last]


def test_islands_of_rounding_are_taken_out_and_narrow_strips_are_not():
    assert tidied(["RS reversal", "RSK reversal", "RS reversal"], [1.0, 2.0, 2.0 + 1e-10, 3.0])[0] == ["RS reversal"]
    row = [" ".join(one) for one in across("RSK")]
    assert tidied(row, [1.0, 2.0, 2.0 + 4e-16, 2.0 + 12e-16, 3.0])[0] == row


def test_rounding_at_the_border_of_a_narrow_class_does_not_take_it_away():
    """Near a meeting: the class below came back, for some doubles, between the narrow one and the one above."""
    below, narrow, above = "RSKRSK reversal", "RSKRSK revolutions", "RSKSK revolutions"
    ends = 1.0 + np.cumsum([0.0, 1e-4, 8e-10, 4e-16, 4e-16, 1e-14, 1e-4])
    assert narrow in tidied([below, narrow, below, above, below, above], ends.tolist())[0]
    fro = [below, above, below, above, below, above]
    assert tidied(fro, ends.tolist())[0] == [below, above]
    assert tidied(fro[:5], [*ends[:5].tolist(), 2.0])[0] == [below]


def neighbours(*pairs):
    """An arrangement with these borders, one a line."""
    classes = list(dict.fromkeys(one for pair in pairs for one in pair))
    below, above = (np.array([classes.index(pair[k]) for pair in pairs]) for k in (0, 1))
    x = 0.1 * np.arange(1.0, len(pairs) + 1.0)
    codes = np.arange(len(classes))
    seen = Seen(codes, *np.ones((3, len(classes))))
    borders = Borders(below, above, x, 2.0 + x)
    return explain(Arrangement([], seen, np.ones(codes.size), [Meeting(5.0, 5.0, ())], borders, True), classes)


def test_neighbours_that_theory_does_not_allow():
    one, other = ("RSK", "reversal"), ("RSKRS", "revolutions")
    assert neighbours((one, other)) == ({}, [(one, other, 0.1, 2.1)])
    # unless something that was seen elsewhere can lie between them
    one, mid, other = ("RSRK", "reversal"), ("RSK", "reversal"), ("RSKR", "reversal")
    assert neighbours((one, other))[1] == [(one, other, 0.1, 2.1)]
    assert neighbours((one, other), (one, mid))[1] == []


def test_strips_that_theory_lists():
    reversal, short, long, over = across("RSK")
    strips, unexplained = neighbours((reversal, over), (reversal, long), (reversal, short))
    assert unexplained == []
    assert strips == {short: [(0.1, 2.1), (0.2, 2.2)], long: [(0.1, 2.1), (0.2, 2.2)]}
    assert neighbours((("RS", "reversal"), ("RS", "revolutions")))[0] == {}
