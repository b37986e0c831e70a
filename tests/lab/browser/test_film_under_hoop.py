"""A fit that the lab opens: its motion, and the film that it is of, under the hoop."""

import dataclasses

import numpy as np
import pytest

pytest.importorskip("av")

import hophoop as hh
from film_maker import Film, article_like, make, project
from hophoop.fitting import backdrop
from hophoop.tracking import Hints
from lab_page_tools import serving

FILM = Film(size=(480, 272), frames=60, scale=200.0, origin=(90.0, 240.0), rate=120.0, roll_deg=3.0, marker_size=0.05)
RADIUS = 0.3


# The pixel of the film on which the centre of the drawn hoop lies, by the browser's own transform.
WHERE = """(() => {
  const scene = hophoopLab.stage.flat.views[0], film = document.querySelector('video.backdrop');
  const [right, down] = scene.point(scene.pose.x, scene.pose.height + scene.film.radius);
  const matrix = new DOMMatrix(getComputedStyle(film).transform).inverse();
  const point = matrix.transformPoint(new DOMPoint(right, down));
  const scale = [film.videoWidth / film.offsetWidth, film.videoHeight / film.offsetHeight];
  return [point.x / point.w * scale[0] - 0.5, point.y / point.w * scale[1] - 0.5];
})()"""


@pytest.fixture(scope="module")
def filmed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("film")
    video = make(folder / "hoop.mp4", article_like(), FILM)
    track = hh.track(video, RADIUS, Hints(exposure=FILM.shutter, level=np.radians(-FILM.roll_deg)))
    fit = hh.fit(track, fixed={"slope": 0.0})
    return fit, backdrop(fit, video, folder / "under.mp4"), folder


@pytest.fixture(scope="module")
def address(filmed):
    with serving(backdrop=filmed[1]) as address:
        yield address


def test_corners_lie_where_the_camera_saw_them(filmed):
    fit, under, folder = filmed
    assert under.size == FILM.size
    assert under.start == pytest.approx(fit.track.t[0] - 0.5 * FILM.shutter, abs=1e-3)
    later = dataclasses.replace(fit)  # the hoop is not seen before the fourth picture
    vars(later)["problem"] = dataclasses.replace(fit.problem, runs=(dataclasses.replace(fit.problem.runs[0], first=3),))
    assert backdrop(later, folder / "hoop.mp4", folder / "later.mp4").start == pytest.approx(3 / FILM.rate, abs=1e-3)
    # the corners, seen through the camera that rendered the film, are those of its picture
    seen = project(FILM, *np.array(under.corners).T)
    wide, tall = FILM.size
    expected = np.array([[0, 0], [wide, 0], [wide, tall], [0, tall]]) - 0.5
    assert np.hypot(*(seen - expected).T).max() < 2.5
    higher = dataclasses.replace(fit, values=fit.values | {"origin_y": fit.values["origin_y"] + 0.1})
    lower = backdrop(higher, folder / "hoop.mp4", folder / "lower.mp4")
    assert np.subtract(under.corners, lower.corners)[:, 1] == pytest.approx(0.1, rel=0.01)
    small = make(folder / "small.mp4", article_like(), dataclasses.replace(FILM, size=(320, 192), frames=4))
    with pytest.raises(ValueError, match="is not the film of the track"):
        backdrop(fit, small, folder / "no.mp4")
    assert not (folder / "no.mp4").exists()
    with pytest.raises(ValueError, match="not to a track of a film"):
        backdrop(dataclasses.replace(fit, tracks=(dataclasses.replace(fit.track, view=None),)), small, folder / "no.mp4")


def test_the_film_lies_under_the_hoop(visit, filmed):
    fit, under, _ = filmed
    page = visit(f"?{fit.scenario.to_query()}")
    page.wait_for_selector("video.backdrop", state="attached")
    # the words over it have a ground of their own, to be read on any film
    for place in (".legend", ".readout"):
        ground = page.evaluate(f"getComputedStyle(document.querySelector('{place}')).backgroundColor")
        assert ground != "rgba(0, 0, 0, 0)", place
    for moment in (0.1, 0.35):
        page.evaluate(f"hophoopLab.clock.play(false); hophoopLab.clock.seek({moment})")
        page.wait_for_function(
            f"() => {{ const film = document.querySelector('video.backdrop'); return !film.seeking && film.readyState > 1"
            f" && Math.abs(film.currentTime - {under.start} - hophoopLab.clock.time) < 0.003; }}"
        )
        page.wait_for_timeout(200)
        # the picture of the film under the hoop that is drawn is that of the hoop that was filmed
        state = article_like().at(moment + fit.track.t[0])
        assert page.evaluate(WHERE) == pytest.approx(project(FILM, state.x, state.height + RADIUS), abs=3.0)
