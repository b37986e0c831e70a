"""What the tests of films share: motions, decoding, finding the load in a picture."""

from functools import cache

import av
import numpy as np
from scipy import ndimage

import hophoop as hh


@cache
def motion(speed=3.1, mu=1.0, duration=2.0, slope=0.0, load_fraction=0.75):
    """A rolling start of an ideal hoop; the reference case hops."""
    plane = hh.Plane(mu=mu, slope=slope)
    return hh.simulate(hh.Hoop.ideal(load_fraction), plane, hh.Start.rolling(speed), duration=duration)


def decoded(path):
    """Pictures of a film, n × height × width × 3, and its codec, pictures a second and duration [s]."""
    with av.open(str(path)) as box:
        stream = box.streams.video[0]
        header = {"codec": stream.codec_context.name, "fps": stream.average_rate, "seconds": box.duration / 1e6}
        return np.array([frame.to_ndarray(format="rgb24") for frame in box.decode(stream)]), header


def darkest_spot(picture, radius, below=0):
    """Centre of the blackest disc of a radius in pixels: column, row; rows above `below` do not count."""
    dark = picture[..., :3].max(axis=-1) < 60
    dark[:below] = False
    # thin lines, such as text and the plane's, go; the disc stays
    spots, _ = ndimage.label(ndimage.binary_opening(dark, iterations=max(1, round(radius) // 3)))
    largest = 1 + np.argmax(np.bincount(spots.ravel())[1:])
    return np.array(ndimage.center_of_mass(spots == largest))[::-1]


def places(motion, times):
    """Load in the world, X level and Y up, from the symbols of the model alone."""
    sample, radius = motion.at(np.asarray(times)), motion.scenario.hoop.radius
    along = sample.x + radius * np.sin(sample.angle)
    above = radius + sample.height + radius * np.cos(sample.angle)
    world = (along + 1j * above) * np.exp(-1j * motion.scenario.plane.slope)
    return np.stack([world.real, world.imag], axis=-1)


def near(drawn, color, tolerance=40):
    """Whether each pixel has nearly a colour, given as #RRGGBB."""
    return np.abs(drawn[..., :3].astype(int) - list(bytes.fromhex(color[1:]))).max(axis=-1) <= tolerance


def window(drawn, spot, rows=(0, 1), half=0):
    """Pixels of a picture about a point, column and row: rows from it, and columns on each side."""
    column, row = np.round(spot).astype(int)
    return drawn[row + rows[0] : row + rows[1], column - half : column + half + 1, :3].astype(int)


def keys_of(shown):
    """Texts of the keys to lines and marks."""
    return [text.get_text() for legend in shown.sheet.figure.legends for text in legend.get_texts()]
