"""Look at each picture of a film: the rim and the marker in it, in its own pixels."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from hophoop.scenario import InputError
from hophoop.tracking.circle import Circle
from hophoop.tracking.hints import Hints
from hophoop.tracking.marker import Marker, Spot, learn_marker, spots
from hophoop.tracking.rim import Rim, find_rim
from hophoop.tracking.scatter import Floats
from hophoop.tracking.search import Search, detect, learn_hoop
from hophoop.tracking.video import Picture, picture_times, pictures, sample_pictures

LONGEST = 120.0  # film without a window that is tracked [s]
FORGET = 0.25  # without the hoop, after which its velocity is unknown [s]
LEAST_REACH = 9.0  # [pixel]
STEADY = 0.004, 0.0003  # changes of the radius and of the oval from picture to picture, over the radius


class Seen(NamedTuple):
    """What the pictures of a film show."""

    t: Floats  # from the file [s]
    rims: Sequence[Rim | None]
    spots: Sequence[list[Spot]]  # of the marker's colour, the largest first
    changes: Floats  # mean change of luma from the picture before [1]
    size: tuple[int, int]  # width and height [pixel]
    first: int  # number of the first picture in the film
    marker: Marker | None


def look(video: str | Path, hints: Hints, progress: Callable[[int, int | None], None] | None) -> Seen:
    """Look for the hoop and its marker in each picture of a film."""
    source, window = Path(video).name, (hints.rate, hints.since, hints.until)
    span = picture_times(video, *window)
    if len(span) and span[-1] - span[0] > LONGEST:
        raise InputError(
            f"{source} lasts {span[-1] - span[0]:.0f} s, and a hoop moves freely for seconds: say from when until when, "
            "such as by --from 12.5 --to 15 (since and until in Hints)."
        )
    stills = sample_pictures(video, *window)
    search, shown = learn_hoop(stills, hints, source)
    marker = learn_marker(shown, hints.marker_color)
    rows: list[tuple[float, Rim | None, list[Spot], float]] = []
    last: list[tuple[float, Rim]] = []
    before = None
    for picture in pictures(video, *window):
        rim = _follow(picture, search, [one for one in last if picture.t - one[0] < FORGET])
        if rim is not None:
            last = [*last[-1:], (picture.t, rim)]
        marked = spots(picture, rim.circle, marker) if rim is not None and marker is not None else []
        small = picture.luma[::2, ::2].astype(np.int16)
        change = np.nan if before is None else float(np.abs(small - before).mean())
        before = small
        rows.append((picture.t, rim, marked, change))
        if progress is not None:
            progress(len(rows), len(span))
    t, rims, found, changes = zip(*rows, strict=True)
    return Seen(np.array(t), rims, found, np.array(changes), stills[0].size, stills[0].row, marker)


def _follow(picture: Picture, search: Search, last: list[tuple[float, Rim]]) -> Rim | None:
    """Find the rim where the last ones, up to two, lead, or anywhere in the picture."""
    if last:
        t, before = last[-1]
        centre, radius = before.circle
        way, reach = 0.0j, 0.3 * radius  # the first velocity is unknown
        if len(last) == 2:
            way = (centre - last[0][1].circle.centre) * (picture.t - t) / (t - last[0][0])
            reach = min(LEAST_REACH + 0.6 * abs(way), 0.45 * radius)  # an impact may stop the hoop
        expected, oval = (radius, STEADY[0] * radius), (*before.oval, STEADY[1] * radius)
        rim = find_rim(picture.luma, Circle(centre + way, radius), search.sign, reach, expected, oval)
        if rim is not None:
            return rim
    return detect(picture.luma, search)
