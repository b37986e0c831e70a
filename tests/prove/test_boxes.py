"""Boxes of parameters to first order: derivatives by another way, motions sampled inside, and borders that are not crossed."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import hophoop as hh
from hophoop.precise.problem import Problem
from hophoop.prove import prove, prove_box, prove_map
from hophoop.prove._flint import precision
from hophoop.prove.enclosures.mean_value_form import Varied, parameter, polynomial, series
from hophoop.prove.motion import REVOLUTION, Run

flint = pytest.importorskip("flint")


# --- arithmetic: derivatives of series in the parameter are another way --------------------------


SHAPES = [
    ("sum", lambda a, b: 2 + a - b * 3 - (1 - a)),
    ("product", lambda a, b: a * b * a),
    ("quotient", lambda a, b: (a + 1) / (b + 2)),
    ("reciprocal", lambda a, b: 1 / (a * b + 3)),
    ("roots", lambda a, b: (a + b).sqrt() * (2 + a * b).rsqrt()),
    ("exponential", lambda a, b: (a * b).exp()),
    ("sine", lambda a, b: (a + 2 * b).sin() * (a - b).cos()),
    ("size", lambda a, b: abs(b - 5) + abs(a + 1)),
]


@pytest.mark.parametrize(("name", "function"), SHAPES)
def test_arithmetic(name, function):
    """At places of the box: the value lies in what is said of all, and the derivative in what is said of it."""
    with precision(80):
        low, high = (0.5, 0.8), (0.625, 0.84375)
        box = [parameter(low[k], high[k], k, 2) for k in range(2)]
        found = function(*box)
        centre = [flint.arb((low[k] + high[k]) / 2) for k in range(2)]
        assert found.at.overlaps(function(*centre))
        for shares in itertools.product((0.0, 0.4, 1.0), repeat=2):
            place = [flint.arb(low[k] + share * (high[k] - low[k])) for k, share in enumerate(shares)]
            assert found.over.overlaps(function(*place))
            for k in range(2):
                flint.ctx.cap = 2
                sides = [flint.arb_series([one, int(k == at)]) for at, one in enumerate(place)]
                if name == "size":
                    slope = flint.arb([1, -1][k])
                else:
                    slope = function(*sides).coeffs()[1]
                half = box[k].by[k]
                assert found.by[k].overlaps(slope * half)
                assert not found.by[k].overlaps(-slope * half)


def test_power_series_and_polynomials():
    with precision(80):
        flint.ctx.cap = 6
        a = parameter(0.5, 0.625, 0, 1)
        terms = (series([a, 1]) * a).exp().integral().coeffs()[:6]
        for value in (0.5, 0.55, 0.625):
            p = flint.arb(value)
            true = (flint.arb_series([p, 1]) * p).exp().integral().coeffs()[:6]
            assert all(one.over.overlaps(other) for one, other in zip(terms[1:], true[1:], strict=True))
        found = polynomial(terms)(flint.arb(0.25))
        assert found.over.overlaps(polynomial(true)(flint.arb(0.25)))
        assert found.over.rad() < 0.2


def test_a_box_is_narrower_by_an_order():
    """x − x² at its top: balls alone are as wide as the box, to first order it is flat."""
    with precision(80):
        x = parameter(0.49, 0.51, 0, 1)
        assert (x.over - x.over * x.over).rad() > 0.015
        assert (x - x * x).over.rad() < 0.0005


# --- events ----------------------------------------------------------------------------------------


def run_of(ranges, scenario=None):
    free = {path: parameter(low, high, k, len(ranges)) for k, (path, (low, high)) in enumerate(ranges.items())}
    return Run(Problem.of(scenario or hh.Scenario()), free, until=REVOLUTION, timed=False).run()


def test_derivatives_of_the_takeoff():
    """dθ/dv0 and dθ/dμ of the article's hop, in units of R and g, as differences of motions in many digits gave them."""
    width = 1e-6
    with precision(48):
        found = run_of({"plane.mu": (1 - width, 1 + width), "start.speed": (3.1 - width, 3.1 + width)}).facts[-1].state.th
        by_mu, by_speed = (float(one.mid()) / width for one in found.by)
        assert by_mu == pytest.approx(0.22178816, abs=1e-3)
        assert by_speed * 9.81**0.5 == pytest.approx(-3.1987967, abs=3e-3)
        assert float(found.by[1].rad()) < 1e-3 * width


@pytest.mark.parametrize(
    ("paths", "low", "high"),
    [
        pytest.param(("plane.mu", "start.speed"), (0.999, 3.097), (1.001, 3.103), marks=pytest.mark.slow),
        pytest.param(("plane.slope", "start.speed"), (-0.0005, 3.099), (0.0005, 3.101), marks=pytest.mark.slow),
        (("hoop.load_fraction",), (0.7498,), (0.7502,)),
    ],
)
def test_motions_of_the_kernel_lie_inside(paths, low, high):
    scenario = hh.Scenario(duration=2.0)
    with precision(48):
        run = run_of(dict(zip(paths, zip(low, high, strict=True), strict=True)), scenario)
        assert run.proved, run.why
        facts = run.facts[:-1]
        for shares in itertools.product((0.0, 0.5, 1.0), repeat=len(paths)):
            values = {path: a + share * (b - a) for path, a, b, share in zip(paths, low, high, shares, strict=True)}
            for fact, event in zip(facts, hh.simulate(scenario.with_values(values)).events, strict=False):
                for ball, value in ((fact.state.th, event.angle), (fact.state.om, event.omega / 9.81**0.5)):
                    every = ball.over if isinstance(ball, Varied) else ball
                    assert abs(float(every.mid()) - value) <= float(every.rad()) + 1e-9


def test_wide_boxes_with_slip():
    """Balls alone prove the hop up to a width of 2·10⁻⁴ of μ and v0."""
    box = prove_box(hh.Scenario(), {"plane.mu": (0.995, 1.005), "start.speed": (3.0845, 3.1155)})
    assert (box.sequence, box.ending) == ("RKRSH", "takeoff")
    back = prove_box(hh.Scenario(), {"plane.mu": (0.997, 1.003), "start.speed": (2.6, 2.61)})
    assert back.proved
    middle = hh.Scenario(plane=hh.Plane(mu=1.0), start=hh.Start.rolling(2.605))
    assert back.sequence == prove(middle, 3, until="revolution").sequence


def test_a_box_across_a_border_stays_undecided():
    """The hop begins at 2.90816 m/s."""
    assert not prove_box(hh.Scenario(), {"start.speed": (2.9075, 2.909)}).proved
    assert prove_box(hh.Scenario(), {"start.speed": (2.909, 2.9092)}).sequence == "RKRSH"


@pytest.mark.slow
def test_random_boxes_agree_with_motions_inside():
    """Motions at random places of proved boxes are proved one by one, which goes another way and is verified by the checker."""
    random, proved = np.random.default_rng(7), 0
    for _ in range(60):
        mu, speed, width = random.uniform(0.2, 1.5), random.uniform(0.5, 3.6), 10 ** random.uniform(-4, -2.3)
        ranges = {"plane.mu": (mu * (1 - width), mu * (1 + width)), "start.speed": (speed * (1 - width), speed * (1 + width))}
        scenario = hh.Scenario(plane=hh.Plane(slope=float(random.choice([0.0, 0.05]))))
        box = prove_box(scenario, ranges)
        if not box.proved:
            continue
        proved += 1
        for _ in range(3):
            values = {path: float(random.uniform(low, high)) for path, (low, high) in ranges.items()}
            one = prove(scenario.with_values(values), 3, until="revolution")
            assert (one.sequence, one.ending) == (box.sequence, box.ending), (ranges, values)
    assert proved > 30


@pytest.mark.slow
def test_a_window_about_the_hop():
    found = prove_map(hh.Scenario(), {"plane.mu": (0.95, 1.05), "start.speed": (3.0, 3.2)}, depth=10)
    assert found.share("RKRSH") > 0.9
