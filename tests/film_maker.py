"""Films of a simulated hoop, rendered by ray and distance, for the tests of tracking; shares no code with the tracker.

Each pixel's ray is cut with the plane of motion, and the hoop that stands there at the time of the pixel's row is asked
how much of the pixel it covers. So tilt, rolling shutter and shutter blur come from their definitions.
"""

from dataclasses import dataclass
from fractions import Fraction

import av
import numpy as np
from scipy.spatial.transform import Rotation

import hophoop as hh


@dataclass(frozen=True)
class Film:
    """How a film is taken."""

    size: tuple = (480, 272)  # width and height, even
    scale: float = 200.0  # pixels a metre where the optical axis meets the plane of motion
    origin: tuple = (90.0, 240.0)  # where x = 0 of the ground stands without tilt [pixel]
    rate: float = 240.0
    shutter: float = 1 / 960  # [s]
    first: float = 0.0  # time of the motion in the first frame [s]
    frames: int = 40
    tilt_deg: tuple = (0.0, 0.0)  # turned about the picture's x and y axis
    focal: float = 450.0  # [pixel]
    roll_deg: float = 0.0  # of the camera about its axis, counterclockwise
    row_delay: float = 0.0  # rolling shutter [s a row]
    noise: float = 3.0  # of luma, of 255
    busy: bool = False
    light: bool = False  # a light hoop on dark ground
    marker: float = 0.86  # distance of the marker over the radius
    marker_size: float = 0.03  # its radius [m]
    hidden: tuple = ()  # frames, from and to, without marker
    without: tuple = ()  # frames without hoop
    uneven: float = 0.0  # variable frame rate: share by which steps vary
    crf: int = 18


SMALL = Film(size=(320, 192), scale=130.0, origin=(60.0, 170.0), marker_size=0.05)


def article_like(duration=1.3):
    """A hoop that rolls, slips and hops within a second, as one might build it."""
    plane = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)
    return hh.simulate(hh.Hoop.ideal(0.6, radius=0.3), plane, hh.Start.rolling(1.9, angle=0.1), duration=duration)


def frame_times(film):
    """Time at which each frame's first row starts to be exposed, counted from the first [s], in whole ticks."""
    steps = np.ones(film.frames - 1)
    if film.uneven:
        steps += film.uneven * np.random.default_rng(1).uniform(-1, 1, film.frames - 1)
    return np.round(np.concatenate([[0.0], np.cumsum(steps)]) / film.rate * TICKS) / TICKS


TICKS = 90_000
SAMPLES = 6  # over the shutter
STROKE = 0.02  # width of the rim [m]
RED = np.array([230, 30, 30])  # of the marker


def camera(film):
    """Matrix from a point of the plane of motion, x, y, 1 [m], to its pixel and 1, times its distance from the lens."""
    middle = 0.5 * (np.array(film.size) - 1)
    axis = (middle - film.origin) / film.scale * [1, -1]  # the point of the plane of motion that the optical axis meets
    turn = Rotation.from_euler("XYZ", [*film.tilt_deg, -film.roll_deg], degrees=True).as_matrix()[:, :2]
    place = np.column_stack([turn, [0, 0, film.focal / film.scale] - turn @ axis])
    return np.array([[film.focal, 0, middle[0]], [0, -film.focal, middle[1]], [0, 0, 1]]) @ place


def project(film, x, y):
    """Pixel of a point of the plane of motion, y its height above the ground [m]."""
    seen = np.stack(np.broadcast_arrays(x, y, 1.0), axis=-1) @ camera(film).T
    return seen[..., :2] / seen[..., 2:]


def unproject(film):
    """For each pixel the point of the plane of motion that it looks at, x and y [m], and pixels a metre there."""
    v, u = np.mgrid[: film.size[1], : film.size[0]].astype(float)
    x, y, near = np.tensordot(np.linalg.inv(camera(film)), [u, v, np.ones_like(u)], 1)
    return x / near, y / near, film.focal * near


def background(film):
    """What stands behind the hoop."""
    wide, tall = film.size
    rng = np.random.default_rng(2)
    base = 70.0 if film.light else 165.0
    picture = np.full((tall, wide, 3), base)
    picture += np.linspace(-15, 15, wide)[None, :, None]
    if film.busy:
        for _ in range(60):
            w, h = rng.integers(8, wide // 4), rng.integers(8, tall // 3)
            x, y = rng.integers(0, wide), rng.integers(0, tall)
            tone = base + rng.uniform(-55, 45) + rng.uniform(-25, 25, 3)
            picture[y : y + h, x : x + w] = 0.4 * picture[y : y + h, x : x + w] + 0.6 * tone
        v, u = np.mgrid[0:tall, 0:wide]
        for _ in range(12):  # rings and discs, to mislead
            x, y, r = rng.uniform(0, wide), rng.uniform(0, tall), rng.uniform(6, 30)
            picture[np.abs(np.hypot(u - x, v - y) - r) < 2.0] = base + rng.uniform(-60, 50)
    picture[unproject(film)[1] < 0] *= 0.75
    return picture.clip(5, 250)


def frames(motion, film):
    """The frames, one after the other, as floating-point RGB."""
    rng, back, places = np.random.default_rng(3), background(film), unproject(film)
    for k, begin in enumerate(frame_times(film)):
        away, bare = (any(a <= k < b for a, b in spans) for spans in (film.without, film.hidden))
        picture = back.copy()
        if not away:
            _draw(picture, motion, film, film.first + begin, places, not bare)
        yield (picture + rng.normal(0, film.noise, (*back.shape[:2], 1))).clip(0, 255)


def _covered(depth):
    """Share of a pixel on the inner side of an edge; depth: behind the edge [pixel]."""
    return np.clip(0.5 + depth, 0, 1)[..., None]


def _draw(picture, motion, film, begin, places, marked):
    """Draw the hoop: the mean over the shutter, each row at its own time."""
    radius = motion.scenario.hoop.radius
    share = (np.arange(SAMPLES) + 0.5) / SAMPLES
    times = begin + film.row_delay * np.arange(film.size[1])[:, None] + film.shutter * share
    # on straight lines between a few times: to 1e-7 m over a frame
    few = np.linspace(times.min(), times.max(), 24)
    known = motion.at(np.clip(few, 0.0, motion.duration))
    states = np.array([np.interp(times, few, values) for values in (known.x, known.height + radius, known.angle)])
    x, y, _ = places
    near = np.hypot(x - states[0].mean(), y - states[1].mean()) < 1.25 * radius + np.ptp(states[0])
    rows, columns = np.flatnonzero(near.any(axis=1)), np.flatnonzero(near.any(axis=0))
    if not rows.size:
        return
    box = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    (x, y, size), back, seen = (each[box] for each in places), picture[box], []
    for sample in np.moveaxis(states[:, box[0]], -1, 0):
        center_x, center_y, angle = sample[..., None]
        away = np.hypot(x - center_x, y - center_y)
        ring = _covered((radius - away) * size) * _covered((away - radius + STROKE) * size)
        one = back + ring * ((225.0 if film.light else 40.0) - back)
        if marked:
            out = film.marker * radius
            off = np.hypot(x - center_x - out * np.sin(angle), y - center_y - out * np.cos(angle))
            one += _covered((film.marker_size - off) * size) * (RED - one)
        seen.append(one)
    picture[box] = np.mean(seen, axis=0)


# Luma, blue and red of BT.601, of R, G, B from 0 to 255.
BT601 = np.array([[65.481, 128.553, 24.966], [-37.797, -74.203, 112.0], [112.0, -93.786, -18.214]]) / 255


def planes(picture):
    """Luma and chroma of 4:2:0, chroma on the even columns and between the rows, as H.264 has it."""
    luma, *colours = np.moveaxis(picture @ BT601.T + [16, 128, 128], -1, 0)
    flat = [luma]
    for chroma in colours:
        wide = np.pad(chroma, ((0, 0), (1, 1)), mode="edge")
        smooth = 0.25 * wide[:, :-2:2] + 0.5 * wide[:, 1:-1:2] + 0.25 * wide[:, 2::2]
        flat.append((0.5 * (smooth[0::2] + smooth[1::2])).reshape(-1, luma.shape[1]))
    return np.concatenate(flat).round().clip(0, 255).astype(np.uint8)


def encode(path, size, pictures, ticks, rate=60, crf=18, aspect=None):
    """Write a film of planes at given times in ticks, with the pixel's aspect ratio."""
    with av.open(str(path), "w") as box:
        stream = box.add_stream("libx264", rate=Fraction(rate).limit_denominator(1000))
        stream.width, stream.height = size
        stream.pix_fmt, stream.options = "yuv420p", {"crf": str(crf), "preset": "veryfast"}
        stream.time_base = stream.codec_context.time_base = Fraction(1, TICKS)
        if aspect is not None:
            stream.codec_context.sample_aspect_ratio = aspect
        for picture, tick in zip(pictures, ticks, strict=True):
            frame = av.VideoFrame.from_ndarray(picture, format="yuv420p")
            frame.pts, frame.time_base = round(tick), Fraction(1, TICKS)
            box.mux(stream.encode(frame))
        box.mux(stream.encode())
    return path


def make(path, motion, film):
    """Write the film; its frames carry their times."""
    ticks = frame_times(film) * TICKS
    return encode(path, film.size, map(planes, frames(motion, film)), ticks, film.rate, film.crf)
