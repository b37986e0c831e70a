"""The stroboscopic still: where the hoops are, when, and what is refused."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from animate_tools import motion, places
from hophoop.plots import colors, strobe


@pytest.fixture
def ax():
    return Figure().subplots()


def rings(ax):
    return [each for each in ax.collections if isinstance(each, LineCollection)]


def placed(ax, artist, points):
    """Points of an artist in the coordinates of the axes."""
    return (artist.get_transform() - ax.transData).transform(points)


def loads(ax):
    spots = [line for line in ax.lines if line.get_marker() == "o" and len(line.get_xdata()) == 1]
    return np.array([placed(ax, line, line.get_xydata())[0] for line in spots])


@pytest.mark.parametrize(
    ("run", "options", "times"),
    [
        (motion(), {"every": 0.25}, np.arange(9) * 0.25),
        (motion(), {"every": 0.1, "start": 1.0, "end": 1.3}, [1.0, 1.1, 1.2, 1.3]),
        (motion(0.5, 1.0, 1.5, 0.25), {"every": 0.5}, [0, 0.5, 1.0, 1.5]),
    ],
)
def test_flashes_at_equal_times(ax, run, options, times):
    assert strobe(run, ax=ax, **options) is ax
    np.testing.assert_allclose(loads(ax), places(run, times), atol=1e-9)
    # a load on the rim, and the centre of the ring as the mean of its points
    for ring, load in zip(rings(ax), loads(ax), strict=True):
        assert np.hypot(*(np.mean(placed(ax, ring, np.concatenate(ring.get_segments())), axis=0) - load)) == pytest.approx(1.0)


@pytest.mark.parametrize("run", [motion(), motion(2.0, duration=7.3)])
def test_about_twelve_by_default(ax, run):
    assert 8 <= len(loads(strobe(run, ax=ax))) <= 17


def test_flashes_at_equal_turns(ax):
    strobe(motion(), every_deg=60, ax=ax)
    turned = np.radians(np.arange(len(loads(ax))) * 60)
    sample = motion().at(motion().times(20001))
    np.testing.assert_allclose(loads(ax), places(motion(), np.interp(turned, sample.angle, motion().times(20001))), atol=1e-4)
    assert len(turned) == int(np.degrees(sample.angle[-1]) // 60) + 1


def test_the_speed_of_the_points_is_the_colour(ax):
    strobe(motion(2.0), every=2.0, ax=ax)
    paint = rings(ax)[-1].get_colors()
    np.testing.assert_allclose(paint[len(paint) // 2, :3], plt.colormaps[colors.RING_SPEED_MAP](0.0)[:3], atol=0.02)
    assert np.abs(paint[0] - paint[len(paint) // 2]).max() > 0.3
    assert "Speed of the ring's points (m/s)" in [other.get_xlabel() for other in ax.figure.axes]


def test_modes_as_colours_and_forces(ax):
    strobe(motion(), every=0.2, color="mode", forces=True, ax=ax)
    words = [text.get_text() for text in ax.get_legend().get_texts()]
    assert {"load", "centre of gravity", "airborne", "roll", "flight"} <= set(words)
    normal, friction = [each for each in ax.collections if hasattr(each, "N")]
    sample = motion().at(np.arange(11) * 0.2)
    longest = sample.normal_force.max()
    np.testing.assert_allclose(normal.V, 1.2 * sample.normal_force / longest, atol=1e-9)
    np.testing.assert_allclose(friction.U, 1.2 * sample.friction_force / longest, atol=1e-9)


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
