"""Figures: they draw what the motion is, on the axes given, and leave the rest alone."""

import itertools
import math
import re

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.legend import Legend

import hophoop as hh
from hophoop import plots
from hophoop.article import compliant_figures as compliant
from hophoop.plots.curves import curve, phases, turning
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import mode_word

matplotlib.use("agg")


@pytest.fixture(scope="module")
def hop():
    return hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=1.0), hh.Start.rolling(3.1), duration=2.5)


@pytest.fixture(scope="module")
def rocking():
    return hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(mu=0.3), hh.Start.rolling(0.1), duration=9.0)


@pytest.fixture
def ax():
    return Figure(figsize=(7, 4), layout="constrained").subplots()


def line(ax, label):
    found = [one for one in ax.get_lines() if one.get_label() == label]
    assert len(found) == 1, [one.get_label() for one in ax.get_lines()]
    return found[0].get_xydata()


def render(ax):
    canvas = FigureCanvasAgg(ax.figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())


def test_a_curve_holds_both_sides_of_an_impact(hop):
    sample = curve(hop)
    impact = hop.find("impact")[0]
    at = np.flatnonzero(sample.t == impact.t)
    assert len(at) == 2
    assert sample.omega[at].tolist() == [impact.before.omega, impact.omega]
    assert np.all(np.diff(sample.t) >= 0.0)
    assert set(np.unique(sample.t)) >= {event.t for event in hop.events}


def test_phases_are_those_of_the_sequence(hop, rocking):
    for motion in (hop, rocking):
        found = phases(motion)
        assert "".join(piece.mode for piece in found) == motion.sequence
        assert all(a.end_t == b.t for a, b in itertools.pairwise(found))
        assert found[-1].end_t == motion.duration


def test_turning(hop, rocking):
    assert not turning(hop)
    assert turning(rocking)


@pytest.mark.parametrize("against", ["time", "angle"])
def test_velocities_are_the_motion(hop, ax, against):
    assert plots.velocities(hop, against, ax=ax) is ax
    centre, rotation = line(ax, "centre, $v$"), line(ax, r"rotation, $R\dot\theta$")
    across = centre[:, 0] if against == "time" else None
    if across is not None:
        assert np.allclose(centre[:, 1], hop.at(across, side="left").vx, atol=6.0)
        inner = ~np.isin(across, [event.t for event in hop.events])
        assert np.allclose(centre[inner, 1], hop.at(across[inner]).vx, rtol=1e-13)
        assert np.allclose(rotation[inner, 1], hop.at(across[inner]).omega, rtol=1e-13)
    else:
        assert centre[-1, 0] == pytest.approx(math.degrees(hop.events[-1].angle))


def test_energies_show_the_losses_that_there_are(hop, rocking, ax):
    plots.energies(hop, "time", ax=ax)
    lost, rubbed = line(ax, "lost in impacts, normal part"), line(ax, "lost to friction")
    impact = hop.find("impact")[0]
    assert lost[-1, 1] == pytest.approx(impact.impact_normal, rel=1e-13)
    total = line(ax, "kinetic + potential")[:, 1]
    assert np.allclose(rubbed[:, 1] + lost[:, 1], total[0] - total, atol=1e-9)
    other = Figure().subplots()
    plots.energies(rocking, "time", ax=other)
    assert not any("impacts" in one.get_label() for one in other.get_lines())


def test_both_contact_models_book_the_landing_alike():
    """The share along the plane stands with friction in the article's balance and in that of the two models."""
    one, two = Figure().subplots(), Figure().subplots()
    compliant.energy_balance(one, two)
    scenario = compliant.landing_scenario()
    plain = Figure().subplots()
    plots.energies(hh.simulate(scenario), "angle", ax=plain)
    for label in ("lost to friction", "lost in impacts, normal part"):
        assert line(one, label)[-1, 1] == pytest.approx(line(plain, label)[-1, 1], rel=1e-12)
    assert line(two, "lost to friction")[-1, 1] == pytest.approx(line(one, "lost to friction")[-1, 1], abs=0.02)


def test_the_gain_under_newtons_law_is_in_the_picture(ax):
    compliant.landing_against_restitution([0.0, 0.5, 0.9], ax=ax)
    least = min(np.min(np.asarray(one.get_ydata(), dtype=float)) for one in ax.get_lines() if len(one.get_xdata()))
    assert least < -0.05  # Newton's law gives energy in the normal direction
    assert ax.get_ylim()[0] < least


def test_a_power_of_ten_stands_in_the_label(ax):
    """Matplotlib would write it over the axes, where the ribbon of modes hides it."""
    motion = hh.simulate(hh.Hoop.ideal(0.5, mass=1e8), hh.Plane(), hh.Start.rolling(1.0), duration=0.5)
    plots.contact_forces(motion, "time", ax=ax)
    ax.figure.canvas.draw()
    assert ax.get_ylabel() == r"Force ($10^{6}$ N)"
    assert ax.yaxis.get_offset_text().get_text() == ""
    assert all(abs(float(tick.get_text().replace("−", "-"))) <= 1000.0 for tick in ax.get_yticklabels())
    plain = Figure().subplots()
    plots.contact_forces(hh.simulate(hh.Scenario(duration=0.5)), "time", ax=plain)
    assert plain.get_ylabel() == "Force (N)"


def test_friction_used_stays_within_one_and_reaches_it_in_slip(hop, ax):
    plots.friction_utilization(hop, "time", ax=ax)
    used = max(ax.get_lines(), key=lambda one: len(one.get_xdata())).get_ydata()
    used = used[np.isfinite(used)]
    assert np.max(np.abs(used)) <= 1.0 + 1e-12
    assert np.any(used > 1.0 - 1e-12)
    assert np.any(used < -1.0 + 1e-12)


def test_modes_are_shaded_in_their_colours(hop, ax):
    plots.gap(hop, ax=ax)
    tinted = {matplotlib.colors.to_hex(patch.get_facecolor()).upper() for patch in ax.patches}
    assert tinted == {color.upper() for word, color in colors.MODES.items() if word != "skim"}
    assert "flight" in {text.get_text() for text in ax.texts}
    bare = Figure().subplots()
    plots.gap(hop, ax=bare, modes=False)
    assert not bare.patches


def test_events_are_marked_where_they_are_and_explained_in_the_legend(hop, ax):
    plots.velocities(hop, "angle", ax=ax)
    said = [text.get_text() for text in ax.get_legend().get_texts()]
    assert said[2:] == ["take-off", "apex", "landing"]
    (landing,) = hop.find("impact")
    assert line(ax, "landing")[:, 0] == pytest.approx([math.degrees(landing.angle)])


def test_many_events_are_counted(ax):
    motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(restitution=0.5), hh.Start.rolling(3.1), duration=3.0)
    plots.gap(motion, ax=ax)
    count = len(motion.find("impact"))
    assert count > 12
    assert len(line(ax, f"{count} × landing")) == count


def test_several_motions_in_one_colour_of_what_they_show(hop, rocking, ax):
    """A quantity keeps its colour; motions differ by their dashes."""
    plots.contact_forces([hop, rocking], ax=ax, labels=["one", "two"])
    drawn = {one.get_label(): one for one in ax.get_lines()}
    one, two = (drawn[f"friction, {name}"] for name in ("one", "two"))
    assert one.get_color() == two.get_color() == colors.FRICTION_FORCE
    assert one.get_linestyle() != two.get_linestyle()
    assert "normal force, one" in drawn
    with pytest.raises(ValueError, match="labels"):
        plots.contact_forces([hop, rocking], ax=ax, labels=["one"])
    with pytest.raises(ValueError, match="at least one"):
        plots.contact_forces([], ax=ax)


def test_against_is_checked(hop, ax):
    with pytest.raises(ValueError, match="against = 'place' must be 'time' or 'angle'"):
        plots.velocities(hop, "place", ax=ax)


def test_path_is_red_only_in_the_air(hop, ax):
    plots.path(hop, ax=ax)
    red = line(ax, "airborne")
    seen = red[np.isfinite(red[:, 0])]
    off, down = hop.find("takeoff")[0], hop.find("impact")[0]
    places = [event.x + 0.75 * math.sin(event.angle) for event in (off, down)]
    assert seen[0, 0] == pytest.approx(places[0], abs=1e-9)
    assert seen[-1, 0] == pytest.approx(places[1], abs=0.05)
    # a projectile: the second difference of height over place is that of a parabola
    bend = np.polyfit(seen[:, 0], seen[:, 1], 2)
    assert np.max(np.abs(np.polyval(bend, seen[:, 0]) - seen[:, 1])) < 1e-9


def test_every_mode_of_the_motion_is_in_the_picture_and_in_its_key(ax):
    motion = hh.simulate(hh.article.scenarios()["low_friction"].replace("duration", 8.3))
    plots.path(motion, ax=ax)
    words = {piece.word for piece in phases(motion)}
    assert words == {"roll", "spin", "skid"}
    key = {text.get_text() for text in ax.get_legend().get_texts()}
    drawn = {matplotlib.colors.to_hex(patch.get_edgecolor()).upper() for patch in ax.patches}
    assert words <= key
    assert {colors.MODES[word].upper() for word in words} <= drawn


def test_the_ground_fills_all_below_a_slope(ax):
    motion = hh.simulate(hh.Hoop.ideal(0.5), hh.Plane(slope=0.5), hh.Start.rolling(2.0), duration=2.0)
    plots.path(motion, ax=ax)
    ground = ax.patches[0] if ax.patches and hasattr(ax.patches[0], "get_xy") else None
    assert ground is not None
    low, high = ax.get_xlim(), ax.get_ylim()
    for x in np.linspace(*low, 7):
        below = np.array([x, min(-math.tan(0.5) * x, high[1]) - 1e-3])
        if below[1] > high[0]:
            assert ground.get_path().contains_point(below)
        assert ground.get_path().contains_point((x, high[0])) == (high[0] < -math.tan(0.5) * x)


def test_phase_plane_is_exact(ax):
    hoop, plane = hh.Hoop.ideal(0.75), hh.Plane(mu=1.0)
    plots.phase_plane(hoop, plane, ax=ax, speeds=(0.0, 12.0))
    picture = ax.images[0].get_array()
    rows, columns = picture.shape[:2]
    rng = np.random.default_rng(3)
    for i, j in zip(rng.integers(rows, size=60), rng.integers(columns, size=60), strict=True):
        theta = (j + 0.5) * 2.0 * math.pi / columns
        omega = (i + 0.5) * 12.0 / rows
        mode = hh.theory.mode_of(theta, omega, hoop, plane)
        # a tint over whatever lies below: pages are light or dark
        expected = (*matplotlib.colors.to_rgb(colors.MODES[mode_word(str(mode), omega)]), 0.30)
        assert np.allclose(picture[i, j], expected, atol=0.003)


def test_phase_plane_draws_motions(hop, rocking, ax):
    plots.phase_plane(motions=[hop, rocking], labels=["hop", "rocks"], ax=ax, angles=(0.0, 9.0))
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["1  hop", "2  rocks"]
    for text, motion in zip(ax.texts, (hop, rocking), strict=True):
        angle, omega = text.get_position()
        apart = np.hypot(motion.at(motion.times(4000)).angle - math.radians(angle), motion.at(motion.times(4000)).omega - omega)
        assert np.min(apart) < 0.02
    markers = {one.get_marker() for one in ax.get_lines()}
    assert {"^", "v"} <= markers
    with pytest.raises(ValueError, match="labels"):
        plots.phase_plane(motions=[hop], labels=[], ax=ax)
    with pytest.raises(ValueError, match="speeds"):
        plots.phase_plane(ax=ax, speeds=(2.0, 1.0))


def test_the_border_of_rolling_comes_down_to_rest(ax):
    """It is upright there: drawn on a grid of angles it would end short of θ̇ = 0."""
    plots.phase_plane(hh.Hoop.ideal(0.75), hh.Plane(mu=0.3), ax=ax, speeds=(-8.0, 8.0))
    feet = [one.get_xydata() for one in ax.get_lines() if len(one.get_xydata()) == 2]
    assert len(feet) == 8  # two islands, both sides, above and below
    for foot in feet:
        (angle, rest), (_, above) = sorted(foot.tolist(), key=lambda end: abs(end[1]))
        assert rest == 0.0 < abs(above)
        sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
        turned = 0.75 * 9.81 * sine / (2.0 * (1.0 + 0.75 * cosine))  # θ̈ from rest, by conservation of energy
        friction, normal = turned * (1.0 + 0.75 * cosine), 9.81 - 0.75 * turned * sine
        assert abs(friction) / normal == pytest.approx(0.3, rel=2e-3)  # a step of the grid


def test_numbers_of_motions_do_not_lie_on_each_other():
    """Five motions that run close to each other, as in the article's plane."""
    runs = hh.article.scenarios()
    motions = [hh.simulate(one) for one in runs.values()]
    figure = Figure(figsize=(8.6, 5.6), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.subplots()
    plots.phase_plane(motions[0].scenario.hoop, motions[0].scenario.plane, motions, list(runs), ax=ax,
                      angles=(0.0, 9.4), speeds=(0.0, 12.0))  # fmt: skip
    figure.canvas.draw()
    boxes = [text.get_window_extent() for text in ax.texts]
    assert len(boxes) == len(runs)
    assert not [1 for one, other in itertools.combinations(boxes, 2) if one.overlaps(other)]
    legends = [one for one in ax.get_children() if isinstance(one, Legend)]
    assert len(legends) == 2  # of the regions and of the numbers, both within the picture
    for legend in legends:
        box = legend.get_window_extent()
        assert box.y0 >= 0.0
        assert box.y1 <= figure.bbox.height


def test_geometry_renders(ax):
    plots.geometry(ax=ax)
    assert {"$G$", "$C$", r"$\theta$"} <= {text.get_text() for text in ax.texts}
    assert render(ax).std() > 0.0
    with pytest.raises(ValueError, match="angle"):
        plots.geometry(angle=math.nan)


def test_overview_and_notebook(hop, tmp_path):
    figure = plots.overview(hop)
    assert len(figure.axes) == 5
    assert figure.number in plt.get_fignums()  # `plt.show()` shows it
    plt.close(figure)
    from hophoop.plots.overview import save_overview

    save_overview(hop, tmp_path / "page.png")
    assert (tmp_path / "page.png").read_bytes().startswith(b"\x89PNG")
    html = hop._repr_html_()
    assert "<svg " in html
    assert html.count("<title>") == len({event.t for event in hop.events})
    assert "takeoff" in html
    assert html.count("<tr>") == 1 + len(hop.events)
    for one in (hop, hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(2.8), duration=30.0)):
        picture = one._repr_html_()
        wide, tall = (float(side) for side in re.search(r"viewBox='0 0 ([\d.]+) ([\d.]+)'", picture).groups())
        for x, y, r in re.findall(r"cx='([-\d.]+)' cy='([-\d.]+)' r='([\d.]+)'", picture):
            reach = float(r) + 1.0  # half of the line
            assert reach <= float(x) <= wide - reach
            assert reach <= float(y) <= tall - reach
    long = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(2.8), duration=20.0)
    assert "more</p>" in long._repr_html_()


@pytest.mark.parametrize(
    ("hoop", "plane", "start"),
    [
        (hh.Hoop.ideal(1.0), hh.Plane(mu=2.0), hh.Start.rolling(1.0)),
        (hh.Hoop.ideal(0.75), hh.Plane(), hh.Start()),
        (hh.Hoop.ideal(0.75), hh.Plane(restitution=0.5), hh.Start(height=0.5, omega=4.0)),
        (hh.Hoop.ideal(0.75), hh.Plane(gravity=0.0), hh.Start(height=0.3, vx=1.0, omega=2.0)),
    ],
    ids=["massless", "at rest", "bounces", "no gravity"],
)
def test_every_motion_can_be_drawn(hoop, plane, start):
    motion = hh.simulate(hoop, plane, start, duration=2.0)
    figure = plots.overview(motion)
    figure.canvas.draw()
    plt.close(figure)
    assert motion._repr_html_()


def test_colours_have_one_meaning_each():
    assert len(set(colors.MODES.values())) == len(colors.MODES)
    quantities = [
        colors.ROTATION_SPEED, colors.KINETIC, colors.POTENTIAL, colors.FRICTION_LOSS, colors.IMPACT_LOSS, colors.NORMAL_FORCE,
        colors.GRAVITY_CENTER, colors.GRAVITY_CENTER_AIRBORNE,
    ]  # fmt: skip
    assert len(set(quantities)) == len(quantities)
    assert not set(quantities) & set(colors.MODES.values())
    assert not set(colors.SERIES) & {*quantities, *colors.MODES.values()}
    assert colors.FRICTION_FORCE == colors.FRICTION_LOSS  # friction, as a force and as what it takes
    assert colors.mode_color("flight") == colors.MODES["flight"]
    with pytest.raises(ValueError, match="word = 'X' must be one of"):
        colors.mode_color("X")
