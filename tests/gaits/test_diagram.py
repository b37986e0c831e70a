"""Attractors over a parameter, against gaits that are found otherwise."""

import io
import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.vocabulary.names import Fate

BASE = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=hh.Plane(gravity=1.0))


def over(degrees, **options):
    return hh.gaits.diagram(BASE, "plane.slope", np.radians(degrees), **options)


def test_attractors_are_stable_gaits_and_coexisting_ones_are_told_apart():
    found = over([1.0, 1.1, 1.18, 1.22])
    lasting = [[one for one in several if one.fate == Fate.GAIT] for several in found.attractors]
    kinds = [sorted((one.period, one.hops) for one in several) for several in lasting]
    assert kinds == [[(1, 0), (1, 1)], [(1, 0), (2, 2)], [(2, 2)], [(4, 4)]]
    assert repr(found).endswith("several at 4 values>")
    for value, several in zip(found.values[:3], lasting, strict=False):
        for one in several:
            gaits = hh.gaits.find(BASE.replace("plane.slope", value), one.period, near=3.45)
            gait = next(gait for gait in gaits if gait.stable and gait.hops == one.hops)
            assert gait.speed == pytest.approx(one.speed, rel=1e-7)
            assert sorted(gait.passages.omega) == pytest.approx(sorted(one.omega), rel=1e-7)


def test_a_gait_without_a_hop_is_known_at_landings():
    """It has no landings, but its speed and sequence; the gait with a hop beside it has one landing."""
    several = over([1.0], starts=[3.41, 3.455], section="landing").attractors[0]
    both = {one.hops: one for one in several if one.fate == Fate.GAIT}
    bottom = {one.hops: one for one in over([1.0], starts=[3.41, 3.455]).attractors[0]}
    assert {hops: len(one.omega) for hops, one in both.items()} == {0: 0, 1: 1}
    assert both[0].sequence == "RSRKR"
    assert [both[hops].speed for hops in (0, 1)] == pytest.approx([bottom[hops].speed for hops in (0, 1)], rel=1e-7)


def test_chaos_and_standstill():
    """At 4° chaos with an exponent of 0.575, at 10° every start rocks in the end, at 17.5° it goes on again."""
    found = over([4.0, 10.0, 17.5])
    chaos = next(one for one in found.attractors[0] if one.fate == Fate.CHAOTIC)
    assert [one.fate for one in found.attractors[0]].count(Fate.CHAOTIC) == 1
    assert chaos.lyapunov == pytest.approx(0.575, abs=0.08)
    assert {one.fate for one in found.attractors[1]} == {Fate.ROCKS}
    assert any(one.fate in (Fate.CHAOTIC, Fate.GAIT) for one in found.attractors[2])


def test_the_last_attractor_is_followed():
    """With a single start that settles on the gait without a hop the other one is found, once it was met before."""
    slow = over([1.0], starts=[3.41]).attractors[0]
    assert [one.hops for one in slow] == [0]
    both = hh.gaits.diagram(BASE, "plane.slope", np.radians([1.0, 1.02]), starts=[3.41, 3.455])
    assert sorted(one.hops for one in both.attractors[0]) == [0, 1]


def test_files(tmp_path):
    pytest.importorskip("xarray")
    found = over([1.0, 4.0])
    data = found.to_xarray()
    assert data["omega"].attrs["units"] == "rad/s"
    assert data["fate"].shape == data["speed"].shape
    assert float(data["speed"][0, 0]) == found.attractors[0][0].speed
    rows = found.to_csv().splitlines()
    assert rows[0] == "plane.slope,fate,sequence,period,hops,starts,speed,lyapunov"
    assert len(rows) == 1 + sum(len(several) for several in found.attractors)
    assert "2 values of plane.slope" in repr(found)


def test_the_picture():
    pytest.importorskip("matplotlib")
    found = over([1.0, 1.18, 4.0, 10.0])
    ax = hh.plots.diagram(found)
    drawn = np.concatenate([np.asarray(dots.get_offsets()) for dots in ax.collections])
    expected = sum(len(one.omega) for several in found.attractors for one in several)
    assert len(drawn) == expected
    assert ax.get_xlabel() == "Slope β (°)"
    names = {text.get_text() for text in ax.get_legend().get_texts()}
    assert names >= {"gait without a hop", "gait with hops", "chaos", "rocks"}
    assert "m/s" in hh.plots.diagram(found, speed=True).get_ylabel()
    drawing = io.StringIO()
    ax.figure.savefig(drawing, format="svg")
    assert "<image" in drawing.getvalue()


def test_what_is_done_is_kept_when_it_is_stopped():
    def stop(done):
        if done > 0.3:
            raise KeyboardInterrupt

    found = hh.gaits.diagram(BASE, "plane.slope", np.radians([1.0, 2.0, 4.0]), progress=stop)
    assert not found.complete
    assert len(found.values) == len(found.attractors) == 2


@pytest.mark.parametrize(
    ("degrees", "options", "message"),
    [
        ([], {}, "values must be 1 to 100000 finite numbers"),
        ([math.nan], {}, "finite numbers"),
        ([1.0], {"starts": 0}, "starts = 0 must be 1 to 1000"),
        ([1.0], {"passages": 10}, "passages = 10 must be an integer from 650"),
        ([1.0], {"section": "top"}, "section = 'top'"),
    ],
)
def test_refusals(degrees, options, message):
    with pytest.raises(ValueError, match=message):
        over(degrees, **options)
