"""Borders against thresholds that theory knows, and the pictures of maps."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop import maps
from hophoop.maps.boundaries.classes import Classifier, make_window
from hophoop.maps.boundaries.contours import curves
from hophoop.maps.boundaries.following import follow
from hophoop.plots.maps import motion_map
from hophoop.vocabulary.colors import CODES, MODES, class_color

WINDOW = {"plane.mu": (0.05, 2.0), "start.speed": (0.05, 5.0)}


def test_the_border_of_rolling_is_where_theory_has_it():
    border = maps.boundary(None, WINDOW, one=(1.5, 0.5), other=(0.45, 1.6), step=0.05)
    assert "R" in border.classes
    assert border.x.size > 12
    for mu, speed in list(zip(border.x, border.y, strict=True))[::3]:
        assert mu == pytest.approx(float(hh.theory.needed_friction(hh.Hoop.ideal(0.75), speed).mu), abs=2e-9)


def sides(classify, border):
    """Classes to the right and left of the inner points of a border, close to them."""
    places = border.window.places(np.transpose([border.x, border.y]))
    for before, place, after in zip(places, places[1:], places[2:], strict=False):
        way = after - before
        left = np.array([-way[1], way[0]]) / np.hypot(*way) * 1e-7
        yield tuple(classify.names[int(classify(place + side * left))] for side in (-1, 1))


def test_a_border_parts_its_classes_and_ends_where_a_third_begins():
    border = maps.boundary(None, WINDOW, one=(1.0, 2.7), other=(1.0, 3.1), step=0.04)
    classify = Classifier(hh.Scenario(), border.window, ["sequence"], "first_revolution")
    assert set(list(sides(classify, border))[2:-2]) == {border.classes}
    places = border.window.places(np.transpose([border.x, border.y]))
    junction = places[-1 if border.ends[1] == "junction" else 0]
    phi = np.linspace(0, 2 * math.pi, 97)
    assert "junction" in border.ends
    assert np.unique(classify(junction + 1e-6 * np.stack([np.cos(phi), np.sin(phi)], axis=-1))).size >= 3


class Drawn(Classifier):
    """Classes by a function of the position in a window of unit squares."""

    def __init__(self, name_of):
        window = make_window(hh.Scenario(), {"plane.mu": (0.0, 1.0), "start.speed": (0.0, 1.0)})
        super().__init__(hh.Scenario(), window, ["sequence"], "first_revolution")
        self.name_of = name_of
        self.names = ["out", "in", "third"]

    def at(self, values):
        return np.apply_along_axis(lambda place: self.names.index(self.name_of(*place)), -1, values)

    def curves(self, count):
        lines = np.linspace(0.0, 1.0, count)
        grid = np.stack(np.meshgrid(lines, lines, indexing="ij"), axis=-1)
        return curves(self, grid, self(grid))


def test_closed_borders():
    disc = Drawn(lambda u, v: "in" if math.hypot(u - 0.5, v - 0.4) < 0.3 else "out")
    (contour,) = disc.curves(12)
    for border in (contour, follow(disc, np.array([0.5, 0.4]), np.array([0.95, 0.5]), 0.05, 500)):
        assert border.ends == ("closed", "closed")
        np.testing.assert_allclose(np.hypot(border.x - 0.5, border.y - 0.4), 0.3, rtol=1e-14)
        around = np.unwrap(np.arctan2(border.y - 0.4, border.x - 0.5))
        turned = around[-1] - around[0]
        assert abs(turned) == pytest.approx(2 * math.pi, abs=1e-9)
        assert border.classes == (("out", "in") if turned > 0 else ("in", "out"))  # to the right and to the left


def test_borders_of_three_classes_end_at_their_junction():
    quarters = Drawn(lambda u, v: "out" if u < 0.43 else ("in" if v < 0.52 else "third"))
    found = quarters.curves(11)
    assert {frozenset(border.classes) for border in found} == {
        frozenset(pair) for pair in (("out", "in"), ("out", "third"), ("in", "third"))
    }
    for border in found:
        assert set(border.ends) == {"edge", "junction"}
        junction = border.ends.index("junction")
        place = np.array([border.x[-junction], border.y[-junction]])
        assert np.abs(place - (0.43, 0.52)).max() < 0.1
    # the same inside of the map, where contours close
    ring = Drawn(lambda u, v: "out" if math.hypot(u - 0.5, v - 0.5) > 0.33 else ("in" if v < 0.52 else "third"))
    found = ring.curves(11)
    assert len(found) == 3
    assert {end for border in found for end in border.ends} == {"junction"}


def test_a_class_between_grid_points_has_borders_where_several_edges_cross_it():
    dot = Drawn(lambda u, v: "third" if math.hypot(u - 0.45, v - 0.5) < 0.01 else ("out" if u < 0.45 else "in"))
    assert {frozenset(border.classes) for border in dot.curves(11)} == {frozenset({"out", "in"})}
    strip = Drawn(lambda u, v: "out" if u < 0.44 else ("in" if u > 0.46 else "third"))
    found = {frozenset(border.classes): border.x for border in strip.curves(11)}
    np.testing.assert_allclose(found[frozenset({"out", "third"})], 0.44, rtol=1e-15)
    np.testing.assert_allclose(found[frozenset({"third", "in"})], 0.46, rtol=1e-15)
    assert Drawn(lambda u, v: "out").curves(5) == []


def test_all_borders_of_a_map_part_its_classes():
    axes = {"plane.mu": np.linspace(0.4, 2.0, 7), "start.speed": np.linspace(1.0, 4.5, 7)}
    dataset = maps.sweep(None, axes)
    found = maps.borders(dataset)
    for border in found:
        classify = Classifier(hh.Scenario(), border.window, ["sequence"], "first_revolution")
        assert set(sides(classify, border)) <= {border.classes}
    pairs = {frozenset(border.classes) for border in found}
    assert frozenset({"R", "RKRSR"}) in pairs
    words = np.array(maps.words_of(dataset["sequence"]))[dataset["sequence"].values]
    assert set(words.flat) <= set().union(*pairs)


def test_borders_of_a_map_are_as_fine_as_its_grid():
    with pytest.raises(TypeError, match="'step'"):
        maps.borders(maps.sweep(None, {"plane.mu": [0.5, 1.0], "start.speed": [1.0, 4.0]}), step=0.1)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"one": (1.0, 0.1), "other": (1.0, 0.2)}, "of one class, R"),
        ({"one": (9.0, 0.1), "other": (1.0, 0.2)}, "must lie in the window"),
        ({"step": 0.0}, "step = 0.0"),
        ({"most": 0}, "most = 0"),
        ({"quantity": "time"}, "'time' must be one with classes"),
        ({"ranges": {"plane.mu": (1.0, 0.5), "start.speed": (0.1, 5.0)}}, "two increasing numbers"),
        ({"ranges": {"plane.mu": (1.0, 1.5)}}, "two parameters"),
        ({"logarithmic": ["hoop.mass"]}, "must be one of plane.mu, start.speed"),
        ({"span": "settled"}, "span = 'settled' must be one of"),
    ],
)
def test_bad_borders(options, message):
    arguments = {"ranges": WINDOW, "one": (1.0, 0.5), "other": (1.0, 4.0)} | options
    with pytest.raises(ValueError, match=message):
        maps.boundary(None, **arguments)


# Pictures


@pytest.fixture(scope="module")
def dataset():
    axes = {"plane.mu": np.linspace(0.02, 2.0, 60), "start.speed": np.linspace(0.05, 5.0, 60)}
    return maps.sweep(None, axes, ["sequence", "hop_height", "painleve", "ending"])


@pytest.fixture(autouse=True)
def _closed():
    yield
    import matplotlib.pyplot as plt

    plt.close("all")


def test_a_picture_of_classes(dataset):
    ax = motion_map(dataset, most=5)
    *texts, paradox = [text.get_text() for text in ax.get_legend().get_texts()]
    assert len(texts) == 6
    assert paradox == "Painlevé"
    assert not ax.texts
    assert texts[0].startswith("R ")
    assert "more, together" in texts[-1]
    shown = {float(text.split()[-2]) for text in texts}
    assert max(shown) > 20
    assert ax.get_xlabel() == r"Speed at the start $v_0$ (m/s)"
    assert ax.get_ylabel() == "Friction μ"
    title = ax.get_title(loc="left")
    assert "γ = 0.75" in title
    assert "μ" not in title
    assert "v₀" not in title


def test_the_line_of_painleve_is_the_threshold(dataset):
    ax = motion_map(dataset)
    lines = [c for c in ax.collections if hasattr(c, "levels") and list(c.levels) == [0.0]]
    heights = np.concatenate([path.vertices[:, 1] for path in lines[0].get_paths()])
    np.testing.assert_allclose(heights, math.sqrt(1 - 0.75**2) / 0.75, rtol=1e-12)


def test_a_picture_of_a_number(dataset):
    ax = motion_map(dataset, "hop_height")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["none", "Painlevé"]
    assert motion_map(dataset, "hop_height", painleve=False).get_legend().get_texts()[-1].get_text() == "none"
    assert ax.figure.axes[1].get_ylabel() == "Maximum gap in the first hop (m)"
    axes = {"plane.mu": maps.logarithmic(0.1, 2.0, 6), "start.speed": np.linspace(1.0, 4.0, 5)}
    ax = motion_map(maps.sweep(None, axes))
    assert (ax.get_xscale(), ax.get_yscale()) == ("linear", "log")


def test_colours_of_classes_are_apart_from_each_other_and_from_those_of_modes():
    names = ["R", "H", "RKRSR", "RKRSH", "RKSH", "RSKRSK", "RSKS", "RKRS", "RSK", "RSKSK", "RH", "RMR", "MR", "MKR"]
    paint, modes = (
        np.array([[int(color[i : i + 2], 16) for i in (1, 3, 5)] for color in colors])
        for colors in (map(class_color, names), MODES.values())
    )
    apart = np.abs(paint[:, None] - paint).sum(axis=2) + 1000 * np.eye(len(names))
    assert apart.min() > 12
    assert np.abs(paint[:, None] - modes).sum(axis=2).min() > 60
    for quantity, table in CODES.items():
        assert set(table) <= set({**maps.QUANTITIES, **maps.SETTLED}[quantity].words)
    assert set(CODES["fate"]) == set(maps.SETTLED["fate"].words)


def test_bad_pictures(dataset):
    with pytest.raises(ValueError, match="must be one of sequence"):
        motion_map(dataset, "time")
    axes = {"plane.impact_law": ["newton", "stronge"], "start.speed": [1.0, 2.0]}
    with pytest.raises(ValueError, match="must be numbers"):
        motion_map(maps.sweep(None, axes))
