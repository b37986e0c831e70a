"""A scenario in one line."""

import pytest

import hophoop as hh
from hophoop.scenario import describe


@pytest.mark.parametrize(
    ("link", "said"),
    [
        ("", "v₀ = 3.1 m/s, μ = 1, γ = 0.75"),
        ("plane.mu=inf&start.speed=2&start.angle=0.5", "v₀ = 2 m/s, θ₀ = 28.65°, μ = ∞, γ = 0.75"),
        ("plane.mu_static=0.9&plane.mu_kinetic=0.7", "v₀ = 3.1 m/s, μs = 0.9, μk = 0.7, γ = 0.75"),
        ("hoop.eccentricity=0.4&hoop.inertia_ratio=0.6", "v₀ = 3.1 m/s, μ = 1, ε = 0.4, κ = 0.6"),
        (
            "start.vx=1&start.vy=-0.5&start.omega=2&plane.slope=0.1&plane.restitution=0.5",
            "v = (1, -0.5) m/s, θ̇ = 2 rad/s, μ = 1, γ = 0.75, β = 5.73°, e = 0.5",
        ),
        (
            "start.height=0.5&start.angle=0.5&start.vx=0&start.omega=4&plane.restitution=0.9",
            "gap 0.5 m, θ₀ = 28.65°, v = (0, 0) m/s, θ̇ = 4 rad/s, μ = 1, γ = 0.75, e = 0.9",
        ),
        ("contact.model=compliant", "v₀ = 3.1 m/s, μ = 1, γ = 0.75, compliant contact"),
    ],
)
def test_in_one_line(link, said):
    assert describe(hh.Scenario.from_query(link)) == said


def test_without_what_an_axis_says():
    assert describe(hh.Scenario(), without=("start.speed", "plane.mu")) == "γ = 0.75"
    assert describe(hh.Scenario(), without=("hoop.load_fraction",)) == "v₀ = 3.1 m/s, μ = 1"
