"""Branches of gaits, their special points and doubled gaits."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.gaits.maps import SectionMap, value_of
from slopes import on_slope

GOOD = {"rel": 1e-9}


def first(degrees, near, period=1, **options):
    return hh.gaits.find(on_slope(degrees, **options), period, near=near)[0]


def landing(degrees, gamma, **options):
    return hh.gaits.find(on_slope(degrees, gamma, **options), section="landing")[0]


@pytest.fixture(scope="module")
def gait():
    return first(1.0, 3.408)


@pytest.fixture(scope="module")
def branch(gait):
    return gait.follow("plane.slope", (math.radians(0.1), math.radians(2.0)))


@pytest.fixture(scope="module")
def gear():
    """The first gear: below 0.5362° its landing does not stop the slip."""
    return landing(3.0, 0.15).follow("plane.slope", (math.radians(0.5), math.radians(10.0)))


def of_kind(found, kind):
    return [special for special in found.special if special.kind == kind]


def doubled(special, share=1e-5):
    """The gait of twice the period next to a special point, at a larger slope."""
    gait = special.gait
    case = gait.scenario.replace("plane.slope", special.parameter * (1.0 + share))
    return hh.gaits.find(case, 2 * gait.period, near=special.omega, section=gait.section)[0]


def parameter_rates(found, path):
    """Rates of the coordinates at the last passage by those at the start, and by a parameter."""
    image_of = SectionMap(found.scenario, len(found), found.section, found.sequences[0][0], path)
    point = image_of.point(found.scenario.start, value_of(found.scenario, path))
    rates = image_of.rates(image_of(point), point, exact=True, sided=False)
    return rates[:, :-1], rates[:, -1]


CHANGES = {"plane.slope": 0.0523, "hoop.load_fraction": 0.5, "plane.mu": 0.9, "plane.rolling_resistance": 0.01}


@pytest.mark.parametrize("path", CHANGES)
@pytest.mark.parametrize(("section", "count"), [("bottom", 2), ("landing", 1)])
def test_rates_of_the_map_by_parameters(section, count, path):
    """Against central differences of all coordinates, extrapolated, and the derivatives by the start."""
    base, value, step = on_slope(3.0, 0.5, 2.7), CHANGES[path], 1e-5
    if section == "landing":
        base, value = landing(3.0, 0.5).scenario, min(value, 0.001) if path == "plane.rolling_resistance" else value
    known = hh.gaits.derivative(base.replace(path, value), count, section=section)

    def image(value):
        found = hh.passages(base.replace(path, value), count, section=section)
        return np.array([float(getattr(found, name)[-1]) for name in known.rows])

    narrow, wide = ((image(value + k * step) - image(value - k * step)) / (2 * k * step) for k in (1, 2))
    matrix, rate = parameter_rates(hh.passages(base.replace(path, value), count, section=section), path)
    assert rate == pytest.approx((4 * narrow - wide) / 3, rel=1e-5, abs=1e-7)
    assert matrix == pytest.approx(known.matrix, rel=1e-13)


def test_every_point_of_a_branch_is_a_gait(branch):
    assert len(branch.parameter) > 100
    assert (branch.stable == (np.abs(branch.multiplier) < 1.0)).all()
    for k in range(0, len(branch.parameter), 25):
        gait = branch.gait(k)
        assert gait.residual < 1e-12
        assert gait.sequence == branch.sequences[k]
        assert gait.multipliers[0].real == pytest.approx(branch.multiplier[k], rel=1e-6)


def test_folds(branch):
    up, down = of_kind(branch, "fold")
    assert math.degrees(up.parameter) == pytest.approx(1.167217696421, rel=1e-12)
    assert up.omega == pytest.approx(3.425520325759, rel=1e-11)
    assert math.degrees(down.parameter) == pytest.approx(0.91388709760, **GOOD)


def test_border_collisions_are_named(branch):
    found = of_kind(branch, "border collision")
    assert [special.event for special in found] == [
        "hop vanishes: RSRKR | RSHSRKR",
        "phase vanishes: RSHSRKR | RSHRKR",
        "phase vanishes: RSHRKR | RSHKR",
        "impact: slip just stops: RSHKR | RSHKR",
    ]
    hop, corner = found[0], found[-1]
    assert hop.multipliers[0] == pytest.approx(hop.multipliers[1], rel=1e-5)  # a hop opens with τ³: no corner
    assert math.degrees(corner.parameter) == pytest.approx(1.0275511980, abs=1e-10)  # by the line to its margin of 0
    assert corner.multipliers == (pytest.approx(-0.31478, abs=1e-5), pytest.approx(-1.35050, abs=1e-5))


@pytest.mark.long
def test_a_wide_range_does_not_make_the_branch_jump_at_a_fold():
    """Long steps near a fold met the part of the branch beyond it, and the branch was followed twice."""
    found = first(1.0, 3.4552).follow("plane.slope", (0.0, 0.17))
    folds = sorted(math.degrees(fold.parameter) for fold in of_kind(found, "fold"))
    assert folds == pytest.approx([0.9138870976, 1.1672176964], **GOOD)
    for special in of_kind(found, "border collision"):
        assert sum(abs(special.omega - other.omega) < 1e-6 for other in found.special) == 1


def test_a_value_at_the_edge_of_what_is_allowed_is_a_limit(gait):
    found = gait.follow("plane.restitution", (0.0, 0.01))
    assert (found.special[0].kind, found.special[0].parameter) == ("limit of the range", pytest.approx(0.0, abs=1e-9))


def test_a_branch_ends_where_the_plane_would_not_be_allowed():
    """Static friction is never less than kinetic friction, though each of both may have the value."""
    end = first(3.0, 2.8, gamma=0.5, mu_static=1.0, mu_kinetic=0.9).follow("plane.mu_static", (0.5, 1.2)).special[0]
    assert (end.kind, end.event, end.parameter) == ("end", "", pytest.approx(0.9, abs=1e-12))


def test_a_border_just_before_the_limit_of_the_range_is_met():
    """9e-6° beyond the border the range ends: one step leads over both."""
    found = first(1.0, 3.4552).follow("plane.slope", (math.radians(0.99), math.radians(1.02756)))
    assert [special.kind for special in found.special] == ["limit of the range", "border collision", "limit of the range"]
    assert math.degrees(found.special[1].parameter) == pytest.approx(1.0275511980, abs=1e-10)


@pytest.mark.long
def test_doubled_gaits_are_followed(branch):
    twice = doubled(of_kind(branch, "border collision")[-1])
    assert twice.period == 2
    assert twice.stable
    second = twice.follow("plane.slope", (math.radians(1.0), math.radians(1.3)))
    (joins,) = of_kind(second, "joins a shorter period")
    assert math.degrees(joins.parameter) == pytest.approx(1.027551, abs=2e-6)
    (doubling,) = of_kind(second, "period doubling")
    assert math.degrees(doubling.parameter) == pytest.approx(1.195297240190, rel=1e-11)
    assert doubled(doubling).period == 4


def test_the_top_of_the_hill():
    gait = next(one for one in hh.gaits.find(on_slope(15.2), 2, near=3.14) if one.stable)
    found = gait.follow("plane.slope", (math.radians(15.0), math.radians(15.3)))
    assert found.special[0].kind == "top of the hill"
    assert math.degrees(found.special[0].parameter) == pytest.approx(15.085738, abs=1e-6)


@pytest.mark.long
def test_landings_and_the_bottom_give_the_same_doubling():
    """At landings the map has two or three coordinates, at the bottom one: a doubling is at the same slope in both."""
    limits = (math.radians(1.0), math.radians(6.0))
    at_bottom, at_landing = first(3.0, 2.8, gamma=0.5), landing(3.0, 0.5)
    assert len(at_landing.multipliers) == 3
    one, other = (of_kind(gait.follow("plane.slope", limits), "period doubling")[0] for gait in (at_bottom, at_landing))
    assert other.parameter == pytest.approx(one.parameter, rel=1e-10)
    twice = doubled(other)
    assert (twice.sequence, twice.stable) == ("KRSH·KRSH", True)
    assert twice.speed == pytest.approx(doubled(one).speed, rel=1e-4)


@pytest.mark.long
def test_a_branch_goes_on_where_the_mode_after_the_landing_changes(gear):
    borders = of_kind(gear, "border collision")
    assert [border.event for border in borders] == [
        "impact: slip just stops: KRSH | RSH", "phase vanishes: RSH | SH", "phase vanishes: SH | H"
    ]  # fmt: skip
    for border in borders:
        assert border.multipliers[0] == pytest.approx(border.multipliers[1], rel=1e-6)
    assert {len(point.place) for point in gear.points} == {3, 4, 5}
    for k in (0, len(gear.points) // 2, -1):
        assert gear.gait(k).residual < 1e-12
    fold = of_kind(gear, "fold")[0]
    assert fold.gait.multipliers[0] == pytest.approx(1.0, abs=1e-6)


@pytest.mark.long
def test_gaits_that_never_roll_are_followed():
    """On 5° with μ = 0.2 the gears slip all the way: three coordinates at the landing."""
    gait = landing(5.0, 0.15, mu=0.2)
    assert gait.sequence == "KSH"
    found = gait.follow("plane.mu", (0.1, 0.3))
    (border,) = of_kind(found, "border collision")
    assert border.event == "phase vanishes: KSH | KRSH"
    assert (found.gait(-1).sequence, found.gait(-1).residual < 1e-12) == ("KRSH", True)


def test_files_and_pictures(branch, gear):
    pytest.importorskip("xarray")
    pytest.importorskip("matplotlib")
    data = branch.to_xarray()
    assert data["parameter"].attrs["units"] == "rad"
    assert branch.to_dict()["special"][0]["kind"] == "limit of the range"
    ax = hh.plots.branch(branch)
    names = {text.get_text() for text in ax.get_legend().get_texts()}
    assert {"fold", "border collision", "gait without a hop", "gait with hops", "gait with hops, unstable"} <= names
    assert ax.get_xlabel() == "Slope β (°)"
    ax = hh.plots.branch(gear)
    assert ax.get_ylabel().endswith("after the landing (rad/s)")
    assert "period doubling" in {text.get_text() for text in ax.get_legend().get_texts()}
    assert "border collision, fold" in repr(branch)
    assert repr(of_kind(branch, "fold")[0]).startswith("<fold at plane.slope = 0.02037179")


@pytest.mark.parametrize(
    ("path", "bounds", "message"),
    [
        ("plane.slope", (0.1, 0.2), r"must be finite and on both sides of plane\.slope = 0\.0174\d+ rad"),
        ("plane.slope", (-0.1, 0.2), "bounds = .* must be slopes of one sign"),
        ("plane.slope", (0.0, math.nan), "must be finite"),
        ("plane.slope", ("a", 1.0), "bounds = .* must be two numbers"),
        ("plane.slope", (0.1,), "must be two numbers"),
        ("start.speed", (0.0, 1.0), "path = 'start.speed' must be a parameter of hoop or plane"),
        ("plane.tilt", (0.0, 1.0), "plane.tilt"),
        ("plane.gravity", (0.5, 2.0), "other than hoop.radius, hoop.mass and plane.gravity"),
    ],
)
def test_refusals(gait, path, bounds, message):
    with pytest.raises(ValueError, match=message):
        gait.follow(path, bounds)


def test_a_gait_without_a_derivative_is_not_followed():
    """With a hop and the least restitution there are endless bounces."""
    with pytest.raises(
        ValueError, match=r"path = 'plane\.restitution' must be a parameter whose derivative exists at this gait"
    ):
        first(3.0, 2.8, gamma=0.5).follow("plane.restitution", (0.0, 0.6))


def test_a_branch_ends_where_the_hoop_leaves_the_plane_at_the_bottom():
    end = first(3.0, 2.8, gamma=0.5).follow("plane.slope", (0.05, 0.36)).special[-1]
    assert (end.kind, end.event, end.parameter) == ("end", "hop vanishes", pytest.approx(0.34150477526, abs=1e-10))


@pytest.mark.long
def test_a_gear_whose_slip_starts_at_once_is_that_of_single_motions(gear):
    """Beyond 8.709°, where the first phase after the landing vanishes."""
    for sequence in ("SH", "H"):
        point = next(one for one in gear.points[::-1] if one.image.sequence == sequence and one.parameter > 0.1)
        gait = point.gait
        motion = hh.simulate(gait.scenario.replace("duration", 10.0 * gait.time), until="landings:1")
        end = motion.events[-1]
        assert end.t == pytest.approx(gait.time, rel=1e-12)
        assert (end.angle - 2.0 * math.pi, end.omega) == pytest.approx((gait.state.angle, gait.state.omega), rel=1e-11)


def test_a_branch_turns_back_at_a_corner_of_the_map():
    """With rolling resistance the gait with a hop ends against one whose landing stops the slip: no fold, but a corner."""
    found = first(3.0, 2.8, gamma=0.5).follow("plane.rolling_resistance", (0.0, 0.1))
    corner = of_kind(found, "border collision")[0]
    assert corner.event == "impact: slip just stops: RSHKR | RSHKR"
    assert corner.multipliers[0] < 1.0 < corner.multipliers[1]
    assert corner.parameter == found.parameter[: np.argmax(found.parameter > corner.parameter + 1e-9)].max()
    assert found.special[-1].kind == "top of the hill"
    assert found.sequences[-1] == "R"


def test_a_branch_goes_on_where_the_hoop_slips_at_the_bottom():
    found = first(3.0, 2.8, gamma=0.5).follow("plane.slope", (0.05, 0.33))
    (border,) = of_kind(found, "border collision")
    assert border.event == "slip at the section: RSHKR | KRSHK"
    gait = found.gait(-1)
    assert (gait.passages.mode, gait.residual < 1e-12) == (("K",), True)
    assert len(gait.multipliers) == 2


@pytest.mark.long
def test_a_window_in_the_chaos():
    """Of stable gaits, from a border collision to a doubling."""
    settled = hh.passages(on_slope(1.36, omega=3.4), 6000)
    assert (settled.fate, settled.period) == ("gait", 3)
    case = on_slope(1.36).replace("start", settled.start(-1))
    window = hh.gaits.Gait(hh.passages(case, 3)).follow("plane.slope", (math.radians(1.31), math.radians(1.41)))
    met = {(one.kind, round(math.degrees(one.parameter), 8)) for one in window.special}
    assert met >= {("border collision", 1.35206842), ("period doubling", 1.36205393)}
    assert window.stable.any()


def test_a_border_of_landings_is_where_the_impact_needs_all_friction(gear):
    """To 1e-10°: there the share of friction that the impact of the gait above it needs is 1, extrapolated from two gaits."""
    border = of_kind(gear, "border collision")[0]
    slopes, shares = [], []
    for offset in (1e-6, 2e-6):
        case = border.gait.scenario.replace("plane.slope", border.parameter + math.radians(offset))
        gait = hh.gaits.find(case, section="landing", near=border.omega)[0]
        impact = gait.motion().find("impact")[-1]
        slopes.append(math.degrees(case.plane.slope))
        shares.append(abs(impact.impulse_tangential) / impact.impulse_normal - 1.0)
    met = slopes[0] - shares[0] * (slopes[1] - slopes[0]) / (shares[1] - shares[0])
    assert math.degrees(border.parameter) == pytest.approx(met, abs=1e-10)


@pytest.mark.long
def test_a_branch_goes_on_where_it_turns_back_at_a_corner():
    """At 15.6354° the multiplier jumps over 1: the branch turns, and the gait doubles on its other side."""
    gait = next(one for one in hh.gaits.find(on_slope(15.2), 2, near=3.14) if one.stable)
    found = gait.follow("plane.slope", (math.radians(15.1), math.radians(16.0)))
    corner = of_kind(found, "border collision")[-1]
    assert corner.event == "impact: slip just stops: RSHKR·RSHRKR | RSHKR·RSHRKR"
    assert math.degrees(corner.parameter) == pytest.approx(15.635389354, abs=1e-9)
    assert corner.multipliers == (pytest.approx(12.55266, abs=1e-4), pytest.approx(0.032143, abs=1e-5))
    (doubling,) = of_kind(found, "period doubling")
    twice = doubled(doubling)
    assert (twice.period, twice.stable) == (4, True)


@pytest.mark.long
def test_corners_of_bounces_are_passed():
    """Under Stronge's law the branch reaches both limits, through a jump of the multiplier at the impact of a bounce."""
    case = on_slope(3.0, 0.5, restitution=0.3, impact_law="stronge")
    gait = hh.gaits.find(case, near=2.77)[0]
    found = gait.follow("plane.restitution", (0.192, 0.32))
    assert [found.special[0].kind, found.special[-1].kind] == ["limit of the range"] * 2
    assert np.all(np.diff(found.parameter) > -1e-12)
    jump = max(of_kind(found, "border collision"), key=lambda one: abs(one.multipliers[1] - one.multipliers[0]))
    assert jump.event == "impact: slip just stops: RSHHHHHHHHHHHHHHHR | RSHHHHHHHHHHHHHHHR"
    assert jump.parameter == pytest.approx(0.19332988986, abs=1e-10)
    assert jump.multipliers == (pytest.approx(-0.78398, abs=1e-5), pytest.approx(-0.82800, abs=1e-5))


@pytest.mark.long
def test_a_border_between_two_pieces_of_a_landing():
    """Where the slip after the landing ends no coordinate can change alone; the friction of the impact gives 0.23352067134."""
    gait = hh.gaits.find(on_slope(5.0, 0.15, mu=0.2), section="landing", near=12.08)[0]
    found = gait.follow("plane.mu", (0.19, 0.24))
    border = of_kind(found, "border collision")[-1]
    assert border.event == "impact: slip just stops: KRSH | RSH"
    assert border.parameter == pytest.approx(0.233520671345, abs=1e-11)
    assert border.multipliers[0] == pytest.approx(border.multipliers[1], abs=1e-5)


@pytest.mark.long
def test_the_mirrored_hoop_has_the_mirrored_branch():
    """Where the slip after the landing changes its sign, the branch downhill to the right ended; its mirror image went on."""
    met = []
    for sign in (1, -1):
        bounds = sorted((sign * math.radians(4.9), sign * math.radians(9.0)))
        found = landing(sign * 5.0, 0.15, mu=0.2).follow("plane.slope", (bounds[0], bounds[1]))
        met.append([(one.kind, sign * one.parameter) for one in found.special[::sign]])
    assert [kind for kind, _ in met[0]] == [kind for kind, _ in met[1]]
    assert [place for _, place in met[0]] == pytest.approx([place for _, place in met[1]], rel=1e-9)
    assert ("border collision", pytest.approx(math.radians(8.405044), abs=1e-8)) in met[0]
