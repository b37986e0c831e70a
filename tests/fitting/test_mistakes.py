"""Data with the mistakes that a class makes: a fit that is not good asks about the right one, and about none without reason."""

from dataclasses import replace

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import ROOT, filmed, hopping
from hophoop.fitting.channels import Sigma
from hophoop.fitting.mistakes import likely_mistakes, without_shutter
from hophoop.fitting.problem import run_of
from hophoop.tracking import read_track
from hophoop.tracking.table import COLUMNS

LIGHT = hh.Hoop.ideal(0.3, radius=0.3)
LEFT = hh.Start.rolling(-1.9, angle=-0.1)
TRACKS = [filmed(hopping()), filmed(hopping(start=LEFT)), filmed(hopping(LIGHT), rate=60.0)]


def asked(track):
    return likely_mistakes(run_of(track, "ideal", "rolling", hh.Plane(), Sigma()), track, Sigma())


def stretched(track, centre=1.0, angle=1.0, time=1.0, zero=0.0, radius=1.0):
    """The track in other units, with other directions of axes and another zero of the angle."""
    size = np.abs(np.broadcast_to(centre, 2))
    return replace(
        track,
        t=time * track.t,
        centre=centre * track.centre,
        centre_error=size * track.centre_error,
        angle=angle * track.angle + zero,
        angle_error=abs(angle) * track.angle_error,
        radius=radius * track.radius,
    )


@pytest.mark.parametrize("track", TRACKS, ids=["right", "left", "light"])
def test_good_data_raise_no_question(track):
    assert asked(track) == []


@pytest.mark.parametrize("track", TRACKS[:2], ids=["right", "left"])
@pytest.mark.parametrize(
    ("mistake", "question"),
    [
        ({"centre": 100.0}, "are lengths in cm"),
        ({"centre": 1000.0}, "are lengths in cm"),
        ({"angle": np.degrees(1.0)}, "is it in degrees"),
        ({"radius": 100.0}, "is it in degrees (--angle-unit deg), or the radius in cm"),
        ({"centre": np.array([1.0, -1.0])}, "does y count downwards"),
        ({"centre": np.array([-1.0, -1.0]), "zero": np.pi}, "is the film upside down"),
        ({"angle": -1.0}, "the angle counts clockwise"),
        ({"centre": np.array([-1.0, 1.0])}, "the angle counts clockwise"),
        ({"zero": np.pi}, "is your angle zero with the load at the top"),
        ({"zero": np.pi / 2}, "is your angle zero with the load at the top"),
        ({"time": 8.0}, "is the film in slow motion"),
        ({"time": 1000.0}, "is the film in slow motion"),
        ({"centre": 100.0, "radius": 100.0}, "is the radius in m"),
    ],
)
def test_the_mistake_is_asked_about(track, mistake, question):
    (found,) = asked(stretched(track, **mistake))
    assert question in found
    assert found.endswith((".", "?"))


FASTEST_ASIDE = filmed(
    hopping(hh.Hoop.ideal(0.7, radius=0.3), hh.Plane(mu=0.6, restitution=0.3), hh.Start.rolling(2.4, angle=0.1), 1.0)
)
ROLLING = filmed(hopping(hh.Hoop.ideal(0.3, radius=0.3), hh.Plane(mu=0.9), hh.Start.rolling(1.2, angle=0.1), 1.5), rate=120.0)


@pytest.mark.parametrize("track", [FASTEST_ASIDE, ROLLING], ids=["fastest aside", "rolling"])
@pytest.mark.parametrize(
    ("mistake", "question"),
    [
        ({"time": 0.25}, "times"),
        ({"time": 1.2}, "times"),
        ({"time": 2.0}, "times"),
        ({"time": 8.0}, "slow motion"),
        ({"centre": 1.05}, "the scale of lengths"),
        ({"radius": 2.0}, "the radius"),
        ({"radius": 0.5}, "the radius"),
        ({"zero": np.pi}, "load at the top"),
        ({"angle": -1.0}, "counts clockwise"),
        ({"centre": 100.0}, "in cm"),
        ({}, None),
    ],
    ids=str,
)
def test_the_right_mistake_is_named_or_none(track, mistake, question):
    found = asked(stretched(track, **mistake))
    assert len(found) <= 1
    assert not found or (question and question in found[0])
    if track is FASTEST_ASIDE:  # a hop at once leaves no doubt
        assert found or mistake not in ({"time": 2.0}, {"centre": 1.05}, {"radius": 2.0})


def test_an_angular_velocity_is_corrected_as_the_times_are():
    track = stretched(TRACKS[0], time=8.0)
    omega = np.gradient(track.angle, track.t)
    (found,) = asked(replace(track, omega=omega, omega_error=np.full(len(omega), 0.05)))
    assert "is the film in slow motion" in found


def test_a_hoop_that_was_held_first():
    track, rest = TRACKS[0], 72
    before = np.zeros(rest, int)
    held = replace(
        stretched(track),
        **{
            name: np.concatenate([getattr(track, name)[before], getattr(track, name)])
            for name in {name for name, _, _ in COLUMNS.values()} - {"t"}
        },
        t=np.arange(rest + len(track.t)) / 240.0,
        state=("found",) * rest + track.state,
    )
    (found,) = asked(held)
    assert "--from 0.3" in found


def test_a_film_on_its_side():
    track = TRACKS[0]
    (found,) = asked(replace(track, centre=track.centre[:, ::-1], centre_error=track.centre_error[:, ::-1]))
    assert "is the film sideways" in found


def test_without_an_angle_nothing_is_asked():
    assert asked(filmed(hopping(), angle=False)) == []


def test_a_fit_that_is_not_good_asks_and_leaves_the_details_out():
    found = hh.fit(stretched(TRACKS[0], centre=100.0))
    assert not found.good
    said = found.sentences()
    assert said[0].startswith("Wrong: no motion fits.")
    assert "are lengths in cm" in said[1]
    assert len(said) == 2
    assert found.notes == tuple(said[1:])
    assert len(found.details()) == 1  # no correlations, no runs of residuals of a motion that is another one


def test_a_film_tracked_without_its_shutter():
    """The sample film without --exposure and --row-delay gives γ to 0.001, and says why it is not perfect."""
    film = read_track(ROOT / "examples" / "film" / "track.json")
    late = 8e-6 * (film.marker_pixel[:, 1] - film.pixel[:, 1])
    omega = np.gradient(film.angle, film.t)
    bare = replace(
        film,
        t=film.t - 8e-6 * film.pixel[:, 1],
        angle=film.angle + omega * late,
        view=replace(film.view, exposure=0.0, row_delay=0.0),
    )
    found = hh.fit(bare)
    assert not found.good
    assert found.usable
    said = found.sentences()
    assert said[0].startswith("Not perfect, but usable")
    assert "enough to test the theory: gamma" in said[1]
    assert any("The likely cause is the shutter" in one and "--exposure" in one and "--row-delay" in one for one in said)
    assert abs(found.values["gamma"] - 0.6) < 0.001
    assert without_shutter((film,)) == []


def test_a_fit_without_a_usual_mistake_says_so():
    found = hh.fit(TRACKS[0], fixed={"gamma": 0.1})
    assert "No usual mistake" in found.sentences()[-1]


def test_a_negative_variance_of_a_singular_problem_is_no_warning(recwarn):
    found = hh.fit(TRACKS[0], fixed={"gamma": 0.6})
    singular = replace(found, covariance=-found.covariance)
    assert np.isnan(singular.error("speed"))
    assert np.isnan(singular.error("mu_static"))
    assert singular.rows()
    assert not recwarn.list


def test_a_hoop_of_another_radius_than_the_film_is_refused():
    with pytest.raises(ValueError, match=r"has the radius 0\.311 m and the data 0\.3 m"):
        hh.fit(TRACKS[0], hoop=hh.Hoop.ideal(0.6, radius=0.311))
