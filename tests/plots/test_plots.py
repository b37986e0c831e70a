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
from hophoop.plots.hoop import HoopArtist
from hophoop.plots.overview import save_overview
from hophoop.plots.style import finish
from hophoop.vocabulary import colors
from hophoop.vocabulary.names import mode_word

matplotlib.use("agg")


@pytest.fixture(scope="module")
def hop():
    return hh.simulate(hh.Scenario(duration=2.5))


@pytest.fixture(scope="module")
def rocking():
    return hh.simulate(hh.Scenario.from_query("duration=9&plane.mu=0.3&start.speed=0.1"))


@pytest.fixture
def ax():
    return Figure(figsize=(7, 4), layout="constrained").subplots()


def line(ax, label):
    (found,) = (one for one in ax.get_lines() if one.get_label() == label)
    return found.get_xydata()


def keys(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_a_curve_holds_both_sides_of_an_impact(hop):
    sample = curve(hop)
    impact = hop.find("impact")[0]
    at = np.flatnonzero(sample.t == impact.t)
    assert sample.omega[at].tolist() == [impact.before.omega, impact.omega]
    assert np.all(np.diff(sample.t) >= 0.0)
    assert set(sample.t) >= {event.t for event in hop.events}


def test_phases_are_those_of_the_sequence(hop, rocking):
    for motion, turns in ((hop, False), (rocking, True)):
        found = phases(motion)
        assert "".join(piece.mode for piece in found) == motion.sequence
        assert all(a.end_t == b.t for a, b in itertools.pairwise(found))
        assert found[-1].end_t == motion.duration
        assert turning(motion) == turns


def test_velocities_are_the_motion(hop, ax):
    assert plots.velocities(hop, "time", ax=ax) is ax
    centre, rotation = line(ax, "centre, $v$"), line(ax, r"rotation, $R\dot\theta$")
    inner = ~np.isin(centre[:, 0], [event.t for event in hop.events])
    states = hop.at(centre[inner, 0])
    assert np.allclose(centre[inner, 1], states.vx, rtol=1e-13)
    assert np.allclose(rotation[inner, 1], states.omega, rtol=1e-13)
    over_angle = plots.velocities(hop, "angle", ax=Figure().subplots())
    assert line(over_angle, "centre, $v$")[-1] == pytest.approx([math.degrees(hop.events[-1].angle), hop.events[-1].vx])
    # events are marked where they are, and explained in the legend
    assert keys(over_angle)[2:] == ["take-off", "apex", "landing"]
    assert line(over_angle, "landing")[:, 0] == pytest.approx([math.degrees(hop.find("impact")[0].angle)])
    with pytest.raises(ValueError, match="against = 'place' must be 'time' or 'angle'"):
        plots.velocities(hop, "place", ax=ax)


def test_energies_show_the_losses_that_there_are(hop, rocking, ax):
    plots.energies(hop, "time", ax=ax)
    lost, rubbed = line(ax, "lost in impacts, normal part"), line(ax, "lost to friction")
    assert lost[-1, 1] == pytest.approx(hop.find("impact")[0].impact_normal, rel=1e-13)
    total = line(ax, "kinetic + potential")[:, 1]
    assert np.allclose(rubbed[:, 1] + lost[:, 1], total[0] - total, atol=1e-9)
    assert not any("impacts" in key for key in keys(plots.energies(rocking, "time", ax=Figure().subplots())))


def test_both_contact_models_book_the_landing_alike():
    """The share along the plane stands with friction in the article's balance and in that of the two models."""
    one, two = Figure().subplots(), Figure().subplots()
    compliant.energy_balance(one, two)
    assert line(two, "lost to friction")[-1, 1] == pytest.approx(line(one, "lost to friction")[-1, 1], abs=0.02)


def test_the_gain_under_newtons_law_is_in_the_picture(ax):
    compliant.landing_against_restitution([0.0, 0.9], ax=ax)
    least = min(np.min(np.asarray(one.get_ydata(), dtype=float)) for one in ax.get_lines() if len(one.get_xdata()))
    assert least < -0.05  # Newton's law gives energy in the normal direction
    assert ax.get_ylim()[0] < least


def test_a_power_of_ten_stands_in_the_label(ax):
    """Matplotlib would write it over the axes, where the ribbon of modes hides it."""
    motion = hh.simulate(hh.Scenario.from_query("duration=0.5&hoop.mass=100000000&hoop.load_fraction=0.5&start.speed=1"))
    plots.contact_forces(motion, "time", ax=ax)
    FigureCanvasAgg(ax.figure).draw()
    assert ax.get_ylabel() == r"Force ($10^{6}$ N)"
    assert ax.yaxis.get_offset_text().get_text() == ""
    assert all(abs(float(tick.get_text().replace("−", "-"))) <= 1000.0 for tick in ax.get_yticklabels())


def test_modes_are_shaded_in_their_colours(hop, ax):
    plots.gap(hop, ax=ax)
    tinted = {matplotlib.colors.to_hex(patch.get_facecolor()).upper() for patch in ax.patches}
    assert tinted == {color.upper() for word, color in colors.MODES.items() if word != "skim"}
    assert "flight" in {text.get_text() for text in ax.texts}
    assert not plots.gap(hop, ax=Figure().subplots(), modes=False).patches


def test_many_events_are_counted(ax):
    motion = hh.simulate(hh.Scenario(plane=hh.Plane(restitution=0.5), duration=3.0))
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
    for motions, labels, words in (([hop, rocking], ["one"], "labels"), ([], None, "at least one")):
        with pytest.raises(ValueError, match=words):
            plots.contact_forces(motions, ax=ax, labels=labels)


@pytest.mark.parametrize("count", [1, 3])
def test_legends_side_by_side_do_not_meet(count):
    figure, axes = plt.subplots(1, count, figsize=(13.0, 4.0), layout="constrained", squeeze=False)
    for ax in axes[0]:
        for name in ("compliant, normal", "compliant, friction", "rigid, Stronge", "rigid, Poisson", "rigid, Newton"):
            ax.plot([0.0, 1.0], [0.0, 1.0], label=name)
        finish(ax, "Time (s)", "Energy (J)")
    figure.canvas.draw()
    boxes = [ax.get_legend().get_window_extent() for ax in axes[0]]
    assert all(left.x1 < right.x0 for left, right in itertools.pairwise(boxes))
    assert boxes[0].x0 >= 0.0
    assert boxes[-1].x1 <= figure.bbox.width
    assert (boxes[0].height < 45.0) == (count == 1)  # where there is room, two rows do
    plt.close(figure)


def test_path_is_red_only_in_the_air(hop, ax):
    plots.path(hop, ax=ax)
    red = line(ax, "airborne")
    seen = red[np.isfinite(red[:, 0])]
    off, down = hop.find("takeoff")[0], hop.find("impact")[0]
    for place, event in zip(seen[[0, -1]], (off, down), strict=True):
        height = 1.0 + 0.75 * math.cos(event.angle)
        assert place == pytest.approx([event.x + 0.75 * math.sin(event.angle), height], abs=1e-9)


def test_every_mode_of_the_motion_is_in_the_picture_and_in_its_key(ax):
    motion = hh.simulate(hh.article.scenarios()["low_friction"].replace("duration", 8.3))
    plots.path(motion, ax=ax)
    words = {"roll", "spin", "skid"}
    drawn = np.array([255 * ring.get_colors()[0, :3] for ring in ax.collections])
    assert words <= set(keys(ax))
    for word in words:  # over white
        assert np.abs(drawn - 0.9 * np.array(colors.rgb(colors.MODES[word])) - 0.1 * 255).max(axis=1).min() < 0.01


def test_the_one_drawing_of_the_hoop_is_at_its_pose(ax):
    """With its load in a figure and with its parts in a film; the ring starts on the outward normal of a slope."""
    hoop = hh.Hoop.from_parts(0.3, [hh.Ring(0.4, 0.27, 0.3), hh.Disk(0.5, 0.03, -0.2)])
    for metre in (0.0, 50.0):
        drawn = HoopArtist(ax, hoop, 0.2, ring=2.0, load=5.0, line="gray", edge="white", pieces=True, metre=metre)
        drawn.pose((3.0, 1.0), 0.5)
        rim = drawn.moved.transform(np.array(drawn.ring.get_segments())[:, 1])
        np.testing.assert_allclose(np.hypot(*(rim - (3.0, 1.0)).T), drawn.middle)
        np.testing.assert_allclose(rim[0], [3.0 + drawn.middle * math.sin(0.2), 1.0 + drawn.middle * math.cos(0.2)])
        spots = [part.get_center() for part in drawn.artists if isinstance(part, matplotlib.patches.Circle)]
        spots += [part.get_xydata()[-1] for part in drawn.artists if isinstance(part, matplotlib.lines.Line2D)]
        assert len(spots) == 2  # the part that is a ring and the disk, or the line to the load and the load
        load = drawn.turned.transform(spots[-1])
        np.testing.assert_allclose(load, [3.0 + 0.2 * math.sin(0.7), 1.0 + 0.2 * math.cos(0.7)], atol=1e-12)


def test_the_ground_fills_all_below_a_slope(ax):
    plots.path(hh.simulate(hh.Scenario.from_query("duration=2&hoop.load_fraction=0.5&plane.slope=0.5&start.speed=2")), ax=ax)
    ground, low = ax.patches[0].get_path(), ax.get_ylim()[0]
    for x in np.linspace(*ax.get_xlim(), 7):
        level = -math.tan(0.5) * x
        assert ground.contains_point((x, min(level, low) - 1e-3))
        assert ground.contains_point((x, level - 1e-3))
        assert not ground.contains_point((x, level + 1e-3))


def test_phase_plane_is_exact(ax):
    hoop, plane = hh.Hoop(), hh.Plane()
    plots.phase_plane(hoop, plane, ax=ax, speeds=(0.0, 12.0))
    picture = ax.images[0].get_array()
    rows, columns = picture.shape[:2]
    rng = np.random.default_rng(3)
    for i, j in zip(rng.integers(rows, size=60), rng.integers(columns, size=60), strict=True):
        theta = (j + 0.5) * 2.0 * math.pi / columns
        omega = (i + 0.5) * 12.0 / rows
        word = mode_word(str(hh.theory.mode_of(theta, omega, hoop, plane)), omega)
        # a tint over whatever lies below: pages are light or dark
        assert np.allclose(picture[i, j], matplotlib.colors.to_rgba(colors.MODES[word], 0.30), atol=0.003)


def test_the_border_of_rolling_comes_down_to_rest(ax):
    """It is upright there: drawn on a grid of angles it would end short of θ̇ = 0."""
    plots.phase_plane(hh.Hoop(), hh.Plane(mu=0.3), ax=ax, speeds=(-8.0, 8.0))
    lines = [one.get_xydata() for one in ax.get_lines()]
    feet = [line[k - 1 : k + 2] for line in lines for k in np.flatnonzero(line[:, 1] == 0.0)]
    assert len(feet) == 8  # two islands, both sides, above and below
    for foot in feet:
        assert np.isfinite(foot).all(axis=1).tolist() in ([True, True, False], [False, True, True])
        angle = foot[1, 0]
        state = hh.simulate(hh.Hoop(), hh.Plane(mu=9.0), hh.Start(angle=math.radians(angle)), duration=0.1).at(0.0)
        assert abs(state.friction_force / state.normal_force) == pytest.approx(0.3, rel=2e-3)  # a step of the grid


def test_a_single_speed_of_rolling_is_no_border(ax):
    """The massless hoop on μ = 1 has one where the load is below the centre: rounding decided whether there is any."""
    plots.phase_plane(hh.Hoop.ideal(1.0), ax=ax)
    angles, speeds = np.concatenate([one.get_xydata() for one in ax.get_lines() if one.get_color() == "black"]).T
    drawn = angles[np.isfinite(speeds)]
    assert drawn.size > 1000
    assert not ((drawn > 91.0) & (drawn < 269.0)).any()


def test_motions_in_the_phase_plane_have_numbers_that_do_not_lie_on_each_other():
    """Five motions that run close to each other, as in the article's plane."""
    runs = hh.article.scenarios()
    motions = [hh.simulate(one) for one in runs.values()]
    figure = Figure(figsize=(8.6, 5.6), layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.subplots()
    plots.phase_plane(motions=motions, labels=list(runs), ax=ax, angles=(0.0, 9.4), speeds=(0.0, 12.0))
    figure.canvas.draw()
    boxes = [text.get_window_extent() for text in ax.texts]
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))
    for text, motion in zip(ax.texts, motions, strict=True):
        angle, omega = text.get_position()
        sample = motion.at(motion.times(20_000))
        assert np.min(np.hypot(sample.angle - math.radians(angle), sample.omega - omega)) < 0.02
    legends = [one for one in ax.get_children() if isinstance(one, Legend)]
    assert len(legends) == 2  # of the regions and of the numbers, both within the picture
    assert all(0.0 <= box.y0 < box.y1 <= figure.bbox.height for box in (one.get_window_extent() for one in legends))
    assert keys(ax) == [f"{k + 1}  {name}" for k, name in enumerate(runs)]
    assert {"^", "v"} <= {one.get_marker() for one in ax.get_lines()}
    for options, words in (({"motions": motions, "labels": []}, "labels"), ({"speeds": (2.0, 1.0)}, "speeds")):
        with pytest.raises(ValueError, match=words):
            plots.phase_plane(ax=ax, **options)


def test_overview_and_notebook(hop, tmp_path, monkeypatch):
    before = plt.get_fignums()
    figure = plots.overview(hop)
    assert len(figure.axes) == 5
    figure.canvas.draw()
    for ax in figure.axes[1:]:
        assert ax.get_legend().get_window_extent().y1 < ax.xaxis.label.get_window_extent().y0
    assert figure.number in plt.get_fignums()  # `plt.show()` shows it
    plt.close(figure)
    monkeypatch.setattr(plt, "get_backend", lambda: "inline")
    assert isinstance(plots.overview(hop), Figure)  # a notebook shows it as the value of a cell
    assert plt.get_fignums() == before
    save_overview(hop, tmp_path / "page.png")
    assert (tmp_path / "page.png").read_bytes().startswith(b"\x89PNG")
    html = hop._repr_html_()
    assert html.count("<title>") == len({event.t for event in hop.events})
    assert html.count("<tr>") == 1 + len(hop.events)
    long = hh.simulate(hh.Scenario(start=hh.Start.rolling(2.8), duration=30.0))._repr_html_()
    assert "more</p>" in long
    for picture in (html, long):
        wide, tall = (float(side) for side in re.search(r"viewBox='0 0 ([\d.]+) ([\d.]+)'", picture).groups())
        for x, y, r in re.findall(r"cx='([-\d.]+)' cy='([-\d.]+)' r='([\d.]+)'", picture):
            reach = float(r) + 1.0  # half of the line
            assert reach <= float(x) <= wide - reach
            assert reach <= float(y) <= tall - reach


@pytest.mark.parametrize(
    ("hoop", "plane", "start"),
    [
        (hh.Hoop.ideal(1.0), hh.Plane(mu=2.0), hh.Start.rolling(1.0)),
        (hh.Hoop(), hh.Plane(), hh.Start()),
        (hh.Hoop(), hh.Plane(restitution=0.5), hh.Start(height=0.5, omega=4.0)),
        (hh.Hoop(), hh.Plane(gravity=0.0), hh.Start(height=0.3, vx=1.0, omega=2.0)),
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
    meanings = [
        colors.ROTATION_SPEED, colors.KINETIC, colors.POTENTIAL, colors.FRICTION_LOSS, colors.IMPACT_LOSS, colors.NORMAL_FORCE,
        colors.GRAVITY_CENTER, colors.GRAVITY_CENTER_AIRBORNE, *colors.MODES.values(), *colors.SERIES,
    ]  # fmt: skip
    assert len(set(meanings)) == len(meanings)
