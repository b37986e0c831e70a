"""Data with the mistakes that a class makes: a fit that is not good asks about the right one, and about none without reason."""

from dataclasses import replace

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import RADIUS, filmed, hopping
from hophoop.fitting.guess import guess
from hophoop.fitting.mistakes import likely_mistakes
from hophoop.fitting.problem import defaults, run_of
from hophoop.tracking.table import COLUMNS

# a hop at once leaves no doubt about times, rolling leaves some
MOTIONS = {
    "right": hopping(),
    "left": hopping(start=hh.Start.rolling(-1.9, angle=-0.1)),
    "hop at once": hopping(
        hh.Hoop.ideal(0.7, radius=RADIUS), hh.Plane(mu=0.6, restitution=0.3), hh.Start.rolling(2.4, angle=0.1), 1.0
    ),
    "rolling": hopping(hh.Hoop.ideal(0.3, radius=RADIUS), hh.Plane(mu=0.9), hh.Start.rolling(1.2, angle=0.1), 1.5),
}
TRACKS = {name: filmed(motion, rate=60.0) for name, motion in MOTIONS.items()}


def asked(track, cost=1e3):
    """What is said of a fit with a cost per number, from a guess of its values."""
    run = run_of(track, "ideal", "rolling", hh.Plane())
    values, free = defaults(run, track)
    return likely_mistakes(run, guess(run, values, free), sorted(free), cost, track)[0]


def stretched(track, centre=1.0, angle=1.0, time=1.0, zero=0.0, radius=1.0):
    """The track in other units, with other directions of axes and another zero of the angle."""
    return replace(
        track,
        t=time * track.t,
        centre=centre * track.centre,
        centre_error=np.abs(centre) * track.centre_error,
        angle=angle * track.angle + zero,
        angle_error=abs(angle) * track.angle_error,
        radius=radius * track.radius,
    )


def turning(track):
    """The track with the angular velocity, too."""
    omega = np.gradient(track.angle, track.t)
    return replace(track, omega=omega, omega_error=np.full(len(omega), 0.05))


def held(track):
    """A hand holds the hoop for 0.3 s."""
    rest = 18
    names = {name for name, _, _ in COLUMNS.values()} - {"t"}
    both = {name: np.concatenate([np.repeat(getattr(track, name)[:1], rest, axis=0), getattr(track, name)]) for name in names}
    return replace(track, **both, t=np.arange(rest + len(track.t)) / 60.0)


def sideways(track):
    return replace(track, centre=track.centre[:, ::-1], centre_error=track.centre_error[:, ::-1])


def marked(track):
    """The marker is taken for the centre."""
    arm = track.radius * np.column_stack([np.sin(track.angle), np.cos(track.angle)])
    return replace(track, centre=track.centre + arm, angle=np.full_like(track.angle, np.nan))


# Motion, mistake, question.
MISTAKES = [
    ("right", {"centre": 100.0}, "are lengths in cm"),
    ("right", {"angle": np.degrees(1.0)}, "is it in degrees"),
    ("right", held, "give --from 0.3"),
    ("right", sideways, "is the film sideways"),
    ("right", {"radius": 100.0}, "with a radius of 0.3 m: is the radius in m"),
    ("right", {"centre": [1.0, -1.0]}, "does y count downwards"),
    ("right", {"centre": [-1.0, -1.0], "zero": np.pi}, "is the film upside down"),
    ("left", {"angle": -1.0}, "the angle counts clockwise"),
    ("left", {"centre": [-1.0, 1.0]}, "the angle counts clockwise"),
    ("right", {"zero": np.pi / 2}, "load at the top? If not, give --fix marker_angle=1.57"),
    ("right", {"centre": 100.0, "radius": 100.0}, "is the radius in m"),
    ("right", {"radius": 1.0 / 0.0254}, "with a radius of 0.3 m: is the radius in m"),
    ("right", marked, "with x and y as those of the marker: name their columns"),
    ("right", lambda track: track.between(0.2), "A motion fits with slip in the first frame"),
    ("hop at once", {"radius": 2.0}, "is the radius in m, and no diameter"),
    ("hop at once", {"time": 0.25}, "are frames per second (--rate) and times right"),
    ("hop at once", {"centre": 1.05}, "with lengths divided by 1.05: is the scale of lengths right? --free scale"),
    ("right", lambda track: turning(stretched(track, time=8.0)), "is the film in slow motion"),
]


@pytest.mark.long
@pytest.mark.parametrize(("name", "mistake", "question"), MISTAKES)
def test_the_mistake_is_asked_about(name, mistake, question):
    track = TRACKS[name]
    (found,) = asked(mistake(track) if callable(mistake) else stretched(track, **mistake))
    assert question in found
    assert found.endswith((".", "?"))


@pytest.mark.long
def test_good_data_raise_no_question():
    for track in (TRACKS["right"], TRACKS["rolling"], filmed(MOTIONS["right"], angle=False)):
        assert asked(track, cost=1.0) == []


@pytest.mark.long
def test_a_doubtful_mistake_is_named_or_none():
    """Of a hoop that only rolls, times and radius are hard to tell apart."""
    assert all("times" in one for one in asked(stretched(TRACKS["rolling"], time=2.0)))


def test_a_fit_that_is_not_good_asks_and_leaves_the_details_out():
    found = hh.fit(stretched(TRACKS["right"], centre=100.0))
    assert not found.good
    said = found.sentences()
    assert said[0].startswith("Wrong: no motion fits.")
    assert "are lengths in cm" in said[1]
    assert len(said) == 2
    assert len(found.details()) == 1  # no correlations, no runs of residuals of a motion that is another one


@pytest.mark.long
def test_a_fit_without_a_usual_mistake_says_so():
    found = hh.fit(TRACKS["right"], fixed={"gamma": 0.1})
    assert (
        "(tried: times, the radius, the scale, units, axes, the point, the start, the zero of the angle, the window): look"
        in found.sentences()[-1]
    )
