"""The page on which a person points at the hoop in a still."""

import json
import threading
import urllib.error
import urllib.request

import numpy as np
import pytest

from film_maker import Film, article_like, frames, make
from hophoop.lab.server.pick import clicked, pick
from hophoop.tracking import Hints
from hophoop.tracking.video import sample_pictures

FILM = Film(size=(320, 192), scale=130.0, origin=(60.0, 170.0), frames=8, marker_size=0.06)


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    return make(tmp_path_factory.mktemp("film") / "hoop.mp4", article_like(duration=0.2), FILM)


def rim(count=5):
    """Points on the rim in the first frame."""
    around = np.linspace(0.3, 5.5, count)
    radius = 0.3 * FILM.scale
    return (np.array([60.0, 170.0 - radius]) + radius * np.stack([np.cos(around), np.sin(around)], axis=-1)).tolist()


def test_clicks_on_the_page_become_hints(film):
    answers = {}

    def person(address):
        def act():
            with urllib.request.urlopen(address, timeout=10) as page:
                answers["page"] = page.read().decode()
            with urllib.request.urlopen(f"{address}still?k=1", timeout=10) as still:
                answers["still"] = still.read()
            for body in ({"still": 0, "rim": rim(2)}, {"still": 0, "rim": rim(), "ground": [[0, 170], [319, 170]]}):
                try:
                    urllib.request.urlopen(address, json.dumps(body).encode(), timeout=10).close()
                except urllib.error.HTTPError as error:
                    answers["refused"] = error.code, json.loads(error.read())["error"]

        threading.Thread(target=act, daemon=True).start()

    hints = pick(film, Hints(ring="dark"), person)
    assert hints.centre == pytest.approx((60.0, 170.0 - 39.0), abs=1e-6)
    assert hints.rim == pytest.approx(39.0)
    assert hints.ground == (0, 170, 319, 170)
    assert hints.ring == "dark"
    assert answers["refused"] == (422, "2 points on the rim are not enough: click at least 3.")
    assert '"hoop.mp4"' in answers["page"]
    assert "__" not in answers["page"].split("<script>")[1].split("let what")[0]
    assert answers["still"].startswith(b"\xff\xd8")


def test_the_marker_has_the_colour_that_was_clicked(film):
    stills = [one for one, _ in sample_pictures(film, None)]
    middle = np.array([60.0, 131.0]) + 39.0 * 0.86 * np.array([np.sin(0.1), -np.cos(0.1)])
    hints = clicked({"still": 0, "rim": rim(), "marker": middle.tolist()}, stills, Hints())
    red, green, blue = (int(hints.marker_color[k : k + 2], 16) for k in (1, 3, 5))
    drawn = next(frames(article_like(duration=0.2), FILM))[round(middle[1]), round(middle[0])]
    assert [red, green, blue] == pytest.approx(drawn, abs=45)
    assert red > 2 * max(green, blue)


@pytest.mark.parametrize(
    ("said", "message"),
    [
        ([], "cannot be read"),
        ({"still": 99, "rim": rim()}, "cannot be read"),
        ({"still": 0, "rim": [[1, 1], [2, 2], [3, 3]]}, "do not lie on a circle"),
        ({"still": 0, "rim": rim(), "marker": [9999, 9999]}, "outside the picture"),
    ],
)
def test_clicks_that_make_no_sense(film, said, message):
    with pytest.raises(ValueError, match=message):
        clicked(said, [one for one, _ in sample_pictures(film, None)], Hints())
