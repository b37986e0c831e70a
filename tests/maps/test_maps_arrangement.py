"""Slices and arrangements on planes known in closed form, and the borders of the first revolution against theory."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop import maps, theory
from hophoop.maps.boundaries.classes import Classifier, make_window
from hophoop.maps.survey.arrangement import Options, arrange
from hophoop.maps.survey.coincidences import coincidence
from hophoop.maps.survey.rules import Rules
from hophoop.maps.survey.slices import resolve
from hophoop.maps.survey.strips import across
from hophoop.maps.survey.survey import survey

G = 9.81


def resolved(gamma, mu, low, high, count=9):
    """Classes and borders of first revolutions along the speed, without those that theory knows to be rounding."""
    base = hh.Scenario().replace("hoop.load_fraction", gamma)
    window = make_window(base, {"plane.mu": (1e-3, 2.0), "start.speed": (1e-3, 9.0)})
    classify = Classifier(base, window, ("sequence", "ending"), "first_revolution")
    one = Rules(classify).remove_spurious(resolve(classify.at, [mu], [np.linspace(low, high, count)])[0])
    return [tuple(classify.names[code].split(" ")) for code in one.codes], one.y[1:-1]


def test_a_slice_finds_what_lies_between_two_classes():
    strip = 1e-13

    def codes_at(x, y):
        return np.where(y < math.e, 0, np.where(y < math.e + strip, 7, 1)) + 0 * x.astype(int)

    one = resolve(codes_at, [1.0], [np.array([1.0, 4.0])])[0]
    assert one.codes.tolist() == [0, 7, 1]
    assert one.y[1] == math.e
    assert one.y[2] - one.y[1] == pytest.approx(strip, rel=0.01)
    # where theory lets nothing lie between the outer two, the border is not cut so finely
    rough = resolve(codes_at, [1.0], [np.array([1.0, 4.0])], settled=lambda a, b: a >= 0, part=1e-6)[0]
    assert rough.codes.tolist() == [0, 1]
    assert rough.y[1] == pytest.approx(math.e, rel=1e-6)


def test_borders_of_a_slice_do_not_coincide():
    def codes_at(x, y):
        # three classes at three neighbouring numbers
        first = 1.5
        second = np.nextafter(first, 2.0)
        return np.where(y < first, 0, np.where(y == first, 1, np.where(y == second, 2, 3)))

    one = resolve(codes_at, [1.0], [np.array([1.0, 2.0])])[0]
    assert one.codes.tolist() in ([0, 1, 2, 3], [0, 2, 3], [0, 1, 3])
    assert (np.diff(one.y) > 0).all()


def plane(x, y):
    """A disc (1) and a wedge (2 and 3 above and below a line) in a rectangle of 0."""
    disc = (x - 1.0) ** 2 + (y - 1.0) ** 2 < 0.25
    slope = (y - 2.5) / np.maximum(x - 1.5, 1e-300)
    wedge = (x > 1.5) & (abs(slope) < 0.1)
    return np.where(disc, 1, np.where(wedge, np.where(y > 2.5, 2, 3), 0))


def test_areas_and_meetings_of_a_known_plane():
    lines = np.linspace(0.1, 2.9, 57)
    seeds = np.linspace(0.1, 3.9, 23)
    found = arrange(plane, lines, seeds, Options(1e-12))
    assert found.complete
    assert found.areas.sum() == pytest.approx(2.8 * 3.8, rel=1e-13)
    assert found.areas[1] == pytest.approx(math.pi / 4, rel=1e-2)
    # between straight borders trapezoids are exact, to the tip
    assert found.areas[2] == pytest.approx(0.5 * 0.1 * 1.4**2, rel=1e-6)
    assert found.areas[3] == pytest.approx(0.5 * 0.1 * 1.4**2, rel=1e-6)
    places = [(0.5, 1.0), (1.5, 1.0), (1.5, 2.5)]
    met = [min(math.hypot(one.x - x, one.y - y) for one in found.meetings) for x, y in places]
    assert max(met[0], met[1]) < 2e-6  # a tip that is round: y is the root of what x is good for
    assert met[2] < 1e-11
    tip = min(found.meetings, key=lambda one: math.hypot(one.x - 1.5, one.y - 2.5))
    assert tip.codes == (0, 2, 3)


def test_an_arrangement_says_where_it_gave_up():
    found = arrange(plane, np.linspace(0.1, 2.9, 57), np.linspace(0.1, 3.9, 23), Options(1e-12, most=1))
    assert not found.complete
    assert found.areas.sum() == pytest.approx(2.8 * 3.8, rel=1e-13)


def test_areas_converge_as_the_square_of_the_lines():
    off = []
    for count in (41, 81):
        found = arrange(plane, np.linspace(0.1, 2.9, count), np.linspace(0.1, 3.9, 23), Options(1e-9))
        off.append(abs(found.areas[1] - math.pi / 4))
    assert off[1] < 0.5 * off[0]


@pytest.mark.parametrize("mu", [0.3921, 0.5, 1.0, 1.7])
def test_the_border_of_rolling_is_the_first_slip(mu):
    speed = float(theory.first_slip_speed(hh.Hoop.ideal(0.75), hh.Plane(mu=mu)))
    classes, borders = resolved(0.75, mu, 0.9 * speed, 1.1 * speed)
    assert classes[0] == ("R", "revolutions")
    assert classes[-1][0].startswith("RK")
    assert borders[0] == pytest.approx(speed, rel=1e-9)


@pytest.mark.parametrize(("gamma", "mu"), [(0.75, 1.0), (0.48, 0.02), (0.95, 0.3)])
def test_the_uppermost_border_is_the_immediate_hop(gamma, mu):
    speed = math.sqrt(G / gamma)
    classes, borders = resolved(gamma, mu, 0.999 * speed, 1.001 * speed)
    assert [sequence for sequence, _ in classes][-1] == "H"
    assert not any(sequence[0] in "KS" for sequence, _ in classes)
    # without more digits, doubles cannot tell within some 1e-12 whether the hoop rolls for a moment
    assert borders[-1] == pytest.approx(speed, rel=2e-12)
    beside = maps.points(
        hh.Scenario().replace("hoop.load_fraction", gamma),
        {"plane.mu": mu, "start.speed": speed * (1.0 + 1e-15 * np.array([-3.0, -1.0, 1.0, 3.0]))},
    )["sequence"]
    assert [name == "H" for name in beside] == [False, False, True, True]


NAMED = [
    (0.75, 0.2413582763671875, 0.8775946663529695, "RSRKRSKR", {"reversal"}),
    (0.48, 0.05182703145, 1.46386130, "RSKRSKR", {"reversal", "revolutions"}),
    (0.48, 0.0302286812, 1.5379669529, "RSRSKR", {"reversal", "revolutions"}),
    (0.48, 0.0272932951443266, 1.5391366385487686, "RSKR", {"reversal", "revolutions"}),
]


@pytest.mark.parametrize(("gamma", "mu", "speed", "sequence", "endings"), NAMED)
def test_named_classes_are_at_their_places(gamma, mu, speed, sequence, endings):
    # a line through the place; in 40 digits too, the strip of RSKRSKR begins 1.1e-5 above it
    classes, borders = resolved(gamma, mu, speed * (1.0 - 3e-5), speed * (1.0 + 3e-5))
    assert endings <= {ending for name, ending in classes if name == sequence}
    if len(endings) == 2:
        assert classes == list(across(sequence[:-1]))
        assert (np.diff(borders) > 0).all()


def test_named_place_of_the_article_hoop():
    place = {"plane.mu": 0.2413582763671875, "start.speed": 0.8775946663529695}
    found = maps.points(None, place, ["sequence", "ending"])
    assert (str(found["sequence"]), str(found["ending"])) == ("RSRKRSKR", "reversal")


def test_coincidences():
    def name(one, other):
        found = coincidence(tuple(one.split()), tuple(other.split()))
        assert found == coincidence(tuple(other.split()), tuple(one.split()))
        return found

    assert name("R revolutions", "RKRSR revolutions") == "mirror"
    assert name("RSK reversal", "RSRK reversal") == "cone"
    assert name("RKR revolutions", "RKSR revolutions") == "cone"
    assert name("RSKR revolutions", "RSKRKR revolutions") == "graze"
    assert name("RKRS revolutions", "RKRSR revolutions") == "end"
    assert name("RKRSH takeoff", "RKRSR revolutions") == "lift"
    assert name("RKSH takeoff", "RKRSH takeoff") == "cone"
    assert name("RKSH takeoff", "H takeoff") == "start"
    assert name("RKRSR reversal", "RKRSR revolutions") == "top"
    assert name("RSK reversal", "RSK revolutions") == ""
    assert name("RSK reversal", "RSKRS revolutions") == ""


@pytest.fixture(scope="module")
def whole():
    return survey(0.48, 16, 1e-5, 1e-3, 1e-3)


@pytest.mark.long
def test_neighbours_differ_by_one_coincidence(whole):
    assert whole.complete
    assert whole.unexplained == []
    for skid in ("RSK", "RSRSK", "RSKRSK"):
        assert set(across(skid)[1:-1]) <= set(whole.strips)


@pytest.mark.long
def test_a_class_between_two_lines_is_not_lost():
    """Of RSKRSRK, at the bottom of this window, no line sees a whole stretch."""
    found = survey(0.8, 8, 1e-3, 1e-3, 1e-3).found
    assert ("RSKRSRK", "reversal") in {(one.sequence, one.ending) for one in found}
    assert sum(one.area for one in found) == pytest.approx(1.0, rel=1e-12)


@pytest.fixture(scope="module", params=[0.3, pytest.param(0.48, marks=pytest.mark.long)])
def coarse(request):
    """A survey, and the scenario of its hoop; with γ = 0.3 and from μ = 0.05 on there are fewer classes."""
    gamma = request.param
    found = request.getfixturevalue("whole") if gamma == 0.48 else survey(gamma, 16, 1e-3, 0.05, 0.05)
    return found, hh.Scenario().replace("hoop.load_fraction", gamma)


def test_areas_of_a_survey_are_those_of_refined_squares(coarse):
    surveyed, base = coarse
    ranges = {"plane.mu": surveyed.mu_range, "start.speed": surveyed.speed_range}
    squares = maps.refine(base, ranges, levels=4, cells=64, quantity=("sequence", "ending")).shares()
    assert sum(one.area for one in surveyed.found) == pytest.approx(1.0, rel=1e-12)
    for one in surveyed.found:
        share, doubt = squares.get(f"{one.sequence} {one.ending}", (0.0, 0.0))
        assert abs(one.area - share) <= doubt + 2e-4


def test_examples_of_a_survey_lie_in_the_middle_of_their_class(coarse):
    surveyed, base = coarse
    sides = [high - low for low, high in (surveyed.mu_range, surveyed.speed_range)]
    for one in surveyed.found:
        if one.width < 1e-7:
            continue
        mu = one.mu + 0.45 * one.width * sides[0] * np.array([0.0, -1.0, 1.0, 0.0, 0.0])
        speed = one.speed + 0.45 * one.width * sides[1] * np.array([0.0, 0.0, 0.0, -1.0, 1.0])
        found = maps.points(base, {"plane.mu": mu, "start.speed": speed}, ["sequence", "ending"])
        assert set(zip(found["sequence"], found["ending"], strict=True)) == {(one.sequence, one.ending)}


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"lines": 3}, "lines = 3 must be from 4 to 4096"),
        ({"part": 0.5}, r"part = 0\.5 must be from 1e-15 to 0\.1"),
        ({"least_friction": 0.0}, r"least_friction = 0\.0 must be greater than 0 and below 0\.1"),
        ({"least_speed": 0.5}, r"least_speed = 0\.5 must be greater than 0 and below 0\.1"),
    ],
)
def test_wrong_options(options, message):
    with pytest.raises(ValueError, match=message):
        survey(0.75, **options)
