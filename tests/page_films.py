"""Films of the page compared with motions of Python."""

import math

import numpy as np

from hophoop.vocabulary.names import MODE_WORDS, coming_rotation, mode_words


def number(value):
    return float(value) if isinstance(value, str) else math.nan if value is None else value


def same_columns(arrays, motion, body=""):
    """Every state of a film is that of the motion, on either side of each event."""
    found = {name: np.array([number(value) for value in column]) for name, column in arrays.items()}
    t, duration, plane = found["t"], motion.duration, motion.scenario.plane
    before = np.append(np.diff(t) == 0.0, False)  # the first one of two at a time
    events = {min(event.t, duration) for event in motion.events}
    assert set(t[before]) == {time for time in events if max(t[0], 5e-324) <= time <= t[-1]}, body
    letters = np.empty(len(t), "U1")
    for side, places in (("left", before), ("right", ~before)):
        sample = motion.at(t[places], side=side)
        letters[places] = sample.mode
        for name in found.keys() - {"mode"}:
            expected = sample.utilization(plane) if name == "utilization" else getattr(sample, name)
            np.testing.assert_array_equal(found[name][places], expected, err_msg=f"{body} {name}")
    words = mode_words(letters, coming_rotation(found["omega"]))
    assert [MODE_WORDS[int(code)] for code in found["mode"]] == words.tolist(), body
