"""The stroboscopic still: where the hoops are, when, and what is refused."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.collections import LineCollection

from animate_tools import motion, places
from hophoop.plots import colors, strobe


@pytest.fixture(autouse=True)
def close():
    yield
    plt.close("all")


def rings(ax):
    """Centre of each ring, from its points."""
    return np.array(
        [
            np.mean([path[1] for path in each.get_segments()], axis=0)
            for each in ax.collections
            if isinstance(each, LineCollection)
        ]
    )


def loads(ax):
    return np.array([line.get_xydata()[0] for line in ax.lines if line.get_marker() == "o" and len(line.get_xdata()) == 1])


def test_flashes_at_equal_times():
    ax = strobe(motion(), every=0.25)
    times = np.arange(9) * 0.25
    sample = motion().at(times)
    np.testing.assert_allclose(rings(ax), np.stack([sample.x, 1.0 + sample.height], axis=-1), atol=1e-9)
    np.testing.assert_allclose(loads(ax), places(motion(), times), atol=1e-12)
    assert ax.get_aspect() == 1.0


def test_about_twelve_by_default():
    assert 8 <= len(loads(strobe(motion()))) <= 17
    assert 8 <= len(loads(strobe(motion(2.0, duration=7.3)))) <= 17


def test_flashes_at_equal_turns():
    ax = strobe(motion(), every_deg=60)
    turned = np.radians(np.arange(len(loads(ax))) * 60)
    sample = motion().at(motion().times(20001))
    x, height = (np.interp(turned, sample.angle, values) for values in (sample.x, sample.height))
    wanted = np.stack([x + np.sin(turned), 1.0 + height + np.cos(turned)], axis=-1)
    np.testing.assert_allclose(loads(ax), wanted, atol=1e-5)
    assert len(turned) == int(np.degrees(sample.angle[-1]) // 60) + 1


def test_a_slope_is_drawn_as_a_slope():
    run = motion(0.5, 1.0, 1.5, 0.25)
    ax = strobe(run, every=0.5)
    np.testing.assert_allclose(loads(ax), places(run, [0, 0.5, 1.0, 1.5]), atol=1e-12)
    assert ax.get_xlabel() == "Level distance (m)"


def test_part_of_a_motion():
    ax = strobe(motion(), every=0.1, start=1.0, end=1.3)
    np.testing.assert_allclose(loads(ax), places(motion(), [1.0, 1.1, 1.2, 1.3]), atol=1e-9)


def test_the_speed_of_the_points_is_the_colour():
    ax = strobe(motion(2.0), every=2.0)
    assert len(rings(ax)) == 2
    last = [each for each in ax.collections if isinstance(each, LineCollection)][-1].get_colors()
    top, bottom = last[0], last[len(last) // 2]
    shades = plt.colormaps[colors.RING_SPEED_MAP]
    np.testing.assert_allclose(bottom[:3], shades(0.0)[:3], atol=0.02)
    assert np.abs(top[:3] - bottom[:3]).max() > 0.3
    labels = [other.get_xlabel() for other in ax.figure.axes]
    assert "Speed of the ring's points (m/s)" in labels


def test_modes_as_colours_and_forces():
    ax = strobe(motion(), every=0.2, color="mode", forces=True)
    words = [text.get_text() for text in ax.get_legend().get_texts()]
    assert {"load", "centre of gravity", "airborne", "roll", "flight"} <= set(words)
    quivers = [each for each in ax.collections if hasattr(each, "N")]
    assert len(quivers) == 2
    normal = motion().at(np.arange(11) * 0.2).normal_force
    np.testing.assert_allclose(quivers[0].V / quivers[0].V.max(), normal / normal.max(), atol=1e-9)


def test_the_flight_is_red():
    ax = strobe(motion())
    ink = colors.GRAVITY_CENTER_AIRBORNE
    (line,) = [each for each in ax.lines if each.get_color() == ink and len(each.get_xdata()) > 2]
    shown = line.get_xdata()[np.isfinite(line.get_xdata())]
    takeoff, landing = motion().find("takeoff")[0], motion().find("impact")[0]
    wanted = [event.x + 0.75 * np.sin(event.angle) for event in (takeoff, landing)]
    np.testing.assert_allclose([shown.min(), shown.max()], wanted, atol=1e-9)


def test_given_axes_are_used():
    _, ax = plt.subplots()
    assert strobe(motion(), ax=ax) is ax


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"every": 0.0}, "every = 0.0 must be positive"),
        ({"every": 0.1, "every_deg": 10}, "cannot be given together"),
        ({"every": 1e-6}, "makes 2000000 flashes"),
        ({"every_deg": 0.01}, "flashes; at most 400"),
        ({"start": 1.5, "end": 1.0}, "start = 1.5, end = 1.0"),
        ({"end": 3.0}, "end = 3.0"),
        ({"color": "red"}, "color = 'red' must be 'speed' or 'mode'"),
    ],
)
def test_what_is_refused(options, words):
    with pytest.raises(ValueError, match=words):
        strobe(motion(), **options)
