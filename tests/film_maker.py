"""Films of a simulated hoop, rendered by ray and distance, for the tests of tracking; shares no code with the tracker.

Each pixel's ray is cut with the plane of motion, and the hoop that stands there at the time of the pixel's row is asked
how much of the pixel it covers. So tilt, rolling shutter and shutter blur come from their definitions.
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

import av
import numpy as np

import hophoop as hh


@dataclass(frozen=True)
class Film:
    """How a film is taken."""

    size: tuple[int, int] = (480, 272)  # even
    scale: float = 200.0  # pixels a metre where the optical axis meets the plane of motion
    origin: tuple[float, float] = (90.0, 240.0)  # where x = 0 of the ground stands without tilt [pixel]
    rate: float = 240.0
    shutter: float = 1 / 960  # [s]
    first: float = 0.0  # time of the motion in the first frame [s]
    frames: int = 40
    tilt_deg: tuple[float, float] = (0.0, 0.0)  # turned about the picture's x and y axis
    focal: float = 450.0  # [pixel]
    roll_deg: float = 0.0  # of the camera about its axis, counterclockwise
    row_delay: float = 0.0  # rolling shutter [s a row]
    noise: float = 3.0  # of luma, of 255
    busy: bool = False
    light: bool = False  # a light hoop on dark ground
    stroke: float = 0.02  # width of the rim [m]
    marker: float = 0.86  # distance of the marker over the radius
    marker_size: float = 0.03  # its radius [m]
    colour: tuple[float, float, float] = (230, 30, 30)
    hidden: tuple[tuple[int, int], ...] = ()  # frames, from and to, without marker
    without: tuple[tuple[int, int], ...] = ()  # frames without hoop
    uneven: float = 0.0  # variable frame rate: share by which steps vary
    crf: int = 18
    samples: int = 6  # over the shutter
    seed: int = 1


def article_like(radius=0.3, duration=1.3, speed=1.9, restitution=0.3, **start):
    """A hoop that rolls, slips and hops within a second, as one might build it."""
    hoop = hh.Hoop.ideal(0.6, radius=radius)
    plane = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=restitution)
    return hh.simulate(hoop, plane, hh.Start.rolling(speed, angle=start.pop("angle", 0.1)), duration=duration)


def frame_times(film):
    """Time at which each frame's first row starts to be exposed, counted from the first [s], in whole ticks."""
    steps = np.ones(film.frames - 1)
    if film.uneven:
        steps += film.uneven * np.random.default_rng(film.seed).uniform(-1, 1, film.frames - 1)
    return np.round(np.concatenate([[0.0], np.cumsum(steps)]) / film.rate * TICKS) / TICKS


TICKS = 90_000


def rotation(film):
    """Axes of the plane of motion in those of the camera: right, up, towards the scene."""
    a, b = np.radians(film.tilt_deg)
    roll = np.radians(film.roll_deg)
    about_x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    about_y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    about_z = np.array([[np.cos(roll), np.sin(roll), 0], [-np.sin(roll), np.cos(roll), 0], [0, 0, 1]])
    return about_x @ about_y @ about_z


def _centre(film):
    return np.array([0.5 * (film.size[0] - 1), 0.5 * (film.size[1] - 1)])


def _axis_point(film):
    """The point of the plane of motion that the optical axis meets [m]."""
    middle = _centre(film)
    return np.array([(middle[0] - film.origin[0]) / film.scale, (film.origin[1] - middle[1]) / film.scale])


def project(film, x, y):
    """Pixel of a point of the plane of motion, y its height above the ground [m]."""
    axis, turn = _axis_point(film), rotation(film)
    flat = np.stack([np.asarray(x) - axis[0], np.asarray(y) - axis[1], np.zeros_like(np.asarray(x, dtype=float))], axis=-1)
    seen = flat @ turn.T + np.array([0, 0, film.focal / film.scale])
    middle = _centre(film)
    return np.stack(
        [middle[0] + film.focal * seen[..., 0] / seen[..., 2], middle[1] - film.focal * seen[..., 1] / seen[..., 2]], axis=-1
    )


def unproject(film, u, v):
    """Point of the plane of motion that a pixel looks at, and pixels a metre there."""
    middle, turn, axis = _centre(film), rotation(film), _axis_point(film)
    ray = np.stack([(u - middle[0]) / film.focal, (middle[1] - v) / film.focal, np.ones_like(u)], axis=-1)
    normal, away = turn[:, 2], film.focal / film.scale
    reach = away * normal[2] / (ray @ normal)
    flat = (ray * reach[..., None] - np.array([0, 0, away])) @ turn
    return flat[..., 0] + axis[0], flat[..., 1] + axis[1], film.focal / (reach * ray[..., 2])


def background(film):
    """What stands behind the hoop."""
    wide, tall = film.size
    rng = np.random.default_rng(film.seed + 1)
    base = 70.0 if film.light else 165.0
    picture = np.full((tall, wide, 3), base)
    picture += np.linspace(-15, 15, wide)[None, :, None]
    if film.busy:
        for _ in range(60):
            w, h = rng.integers(8, wide // 4), rng.integers(8, tall // 3)
            x, y = rng.integers(0, wide), rng.integers(0, tall)
            tone = base + rng.uniform(-55, 45) + rng.uniform(-25, 25, 3)
            picture[y : y + h, x : x + w] = 0.4 * picture[y : y + h, x : x + w] + 0.6 * tone
        for _ in range(12):  # rings and discs, to mislead
            x, y, r = rng.uniform(0, wide), rng.uniform(0, tall), rng.uniform(6, 30)
            v, u = np.mgrid[0:tall, 0:wide]
            there = np.abs(np.hypot(u - x, v - y) - r) < 2.0
            picture[there] = base + rng.uniform(-60, 50)
    u, v = np.meshgrid(np.arange(wide, dtype=float), np.arange(tall, dtype=float))
    _, height, _ = unproject(film, u, v)
    return np.where((height < 0)[..., None], picture * 0.75, picture).clip(5, 250)


def frames(motion, film):
    """The frames, one after the other, as floating-point RGB."""
    rng = np.random.default_rng(film.seed + 2)
    back = background(film)
    wide, tall = film.size
    u, v = np.meshgrid(np.arange(wide, dtype=float), np.arange(tall, dtype=float))
    x, y, scale = unproject(film, u, v)
    radius = motion.scenario.hoop.radius
    for k, begin in enumerate(frame_times(film)):
        picture = back.copy()
        if not any(a <= k < b for a, b in film.without):
            marked = not any(a <= k < b for a, b in film.hidden)
            _draw(picture, motion, film, film.first + begin, (x, y, scale, radius), marked)
        yield (picture + rng.normal(0, film.noise, (tall, wide, 1))).clip(0, 255)


class Between(NamedTuple):
    """Where the hoop is at many times."""

    x: np.ndarray
    height: np.ndarray
    angle: np.ndarray


def _between(motion, times):
    """The motion at many times close together, on straight lines between a few: to 1e-7 m over a frame."""
    few = np.unique(np.linspace(times.min(), times.max(), 24)) if np.ptp(times[:, 0]) else times[0]
    known = motion.at(np.clip(few, 0.0, motion.duration))
    return Between(*(np.interp(times, few, getattr(known, name)) for name in Between._fields))


def _draw(picture, motion, film, begin, place, marked):
    x, y, scale, radius = place
    rows = np.arange(film.size[1])
    share = (np.arange(film.samples) + 0.5) / film.samples
    times = begin + film.row_delay * rows[:, None] + film.shutter * share
    state = _between(motion, times)
    middle = np.stack([state.x.mean(), state.height.mean() + radius])
    near = np.hypot(x - middle[0], y - middle[1]) < 1.25 * radius + np.ptp(state.x)
    if not near.any():
        return
    top, bottom = np.flatnonzero(near.any(axis=1))[[0, -1]]
    left, right = np.flatnonzero(near.any(axis=0))[[0, -1]]
    box = np.s_[top : bottom + 1, left : right + 1]
    back = picture[box].copy()
    total = np.zeros_like(back)
    tone = 225.0 if film.light else 40.0
    size = scale[box]
    for k in range(film.samples):
        cx, cy = state.x[top : bottom + 1, k, None], state.height[top : bottom + 1, k, None] + radius
        angle = state.angle[top : bottom + 1, k, None]
        away = np.hypot(x[box] - cx, y[box] - cy)
        ring = np.clip(0.5 + (radius - away) * size, 0, 1) * np.clip(0.5 + (away - radius + film.stroke) * size, 0, 1)
        one = back + ring[..., None] * (tone - back)
        if marked:
            mx, my = cx + film.marker * radius * np.sin(angle), cy + film.marker * radius * np.cos(angle)
            dot = np.clip(0.5 + (film.marker_size - np.hypot(x[box] - mx, y[box] - my)) * size, 0, 1)
            one += dot[..., None] * (np.array(film.colour, dtype=float) - one)
        total += one
    picture[box] = total / film.samples


def planes(picture):
    """Luma and chroma of 4:2:0 after BT.601, chroma on the even columns and between the rows, as H.264 has it."""
    r, g, b = picture[..., 0], picture[..., 1], picture[..., 2]
    luma = 16 + (65.481 * r + 128.553 * g + 24.966 * b) / 255
    wide = []
    for weights in ((-37.797, -74.203, 112.0), (112.0, -93.786, -18.214)):
        chroma = 128 + (weights[0] * r + weights[1] * g + weights[2] * b) / 255
        padded = np.pad(chroma, ((0, 0), (1, 1)), mode="edge")
        smooth = 0.25 * padded[:, :-2] + 0.5 * padded[:, 1:-1] + 0.25 * padded[:, 2:]
        wide.append(0.5 * (smooth[0::2, 0::2] + smooth[1::2, 0::2]))
    tall, across = luma.shape
    flat = [luma, *(c.reshape(tall // 4, across) if tall % 4 == 0 else c.reshape(-1, across) for c in wide)]
    return np.concatenate(flat).round().clip(0, 255).astype(np.uint8)


def make(path, motion, film):
    """Write the film; its frames carry their times."""
    with av.open(str(path), "w") as box:
        stream = box.add_stream("libx264", rate=Fraction(film.rate).limit_denominator(1000))
        stream.width, stream.height = film.size
        stream.pix_fmt = "yuv420p"
        stream.time_base = stream.codec_context.time_base = Fraction(1, TICKS)
        stream.options = {"crf": str(film.crf), "preset": "veryfast"}
        for begin, picture in zip(frame_times(film), frames(motion, film), strict=True):
            frame = av.VideoFrame.from_ndarray(planes(picture), format="yuv420p")
            frame.pts, frame.time_base = round(begin * TICKS), Fraction(1, TICKS)
            box.mux(stream.encode(frame))
        box.mux(stream.encode())
    return path
