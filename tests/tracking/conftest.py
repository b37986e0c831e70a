"""Films for the tests of tracking, each made once."""

import dataclasses

import pytest

from film_maker import Film, article_like, make

# as a phone takes them
BIG = Film(size=(1280, 720), scale=330.0, origin=(120.0, 600.0), focal=1150.0, frames=60, marker_size=0.04, busy=True)
PHONES = {
    f"phone {change}": dataclasses.replace(BIG, **change)
    for change in (
        {"rate": 240.0},
        {"rate": 120.0, "shutter": 1 / 1000},
        {"rate": 60.0, "shutter": 1 / 1000},
        {"rate": 30.0, "shutter": 1 / 500, "frames": 30},
        {"first": 0.35, "uneven": 0.3},
        {"tilt_deg": (7.0, -7.1), "first": 0.2, "frames": 120, "busy": False},
        {"row_delay": 1e-5, "first": 0.3},
        {"origin": (10.0, 640.0)},
        {"hidden": ((10, 25),), "without": ((40, 50),)},
        {"crf": 26},
    )
}
FILMS = PHONES | {
    # small, for what does not ask for exactness
    "short": Film(
        size=(320, 192), scale=130.0, origin=(60.0, 170.0), frames=18, rate=120.0, uneven=0.3, marker_size=0.045,
        hidden=((6, 8),), without=((12, 14),),
    ),
    # a restless background, uneven times, a marker that is hidden for a while, a hoop that is away for a while
    "hidden": Film(frames=40, uneven=0.3, busy=True, hidden=((14, 20),), without=((30, 34),)),
    # a lens out of axis, whose rows are exposed one after the other
    "tilted": Film(frames=40, first=0.15, tilt_deg=(6.0, -8.0), row_delay=1.5e-5, rate=120.0, shutter=1 / 500),
    # light on dark; the rim is cut by the edge of the picture at first; the picture is not level
    "light": Film(frames=36, light=True, origin=(25.0, 225.0), roll_deg=2.0, marker_size=0.04),
}  # fmt: skip


@pytest.fixture(scope="session")
def motion():
    return article_like()


@pytest.fixture(scope="session")
def films(tmp_path_factory, motion):
    folder = tmp_path_factory.mktemp("films")
    made = {}

    def film(name):
        if name not in made:
            made[name] = make(folder / f"{len(made)}.mp4", motion, FILMS[name])
        return made[name], FILMS[name]

    return film
